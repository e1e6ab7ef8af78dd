#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds holds of the control laws that are active and not held in calm, in the
record of a flight (SAF-9, EXT-8).

    python3 evidence/safety/holds.py RECORD [--faults FILE]

A line for each hold that is not held; exit status 1 when there is any. With
--json one object: not_held, judged, excepted, reasons.

Calm is a time in which the modes, the state of the link and the commands that
the aircraft heard last stay, and no surface has a fault that ends. The target
of a hold is what the mode is for, or what was measured when it was engaged.
From SETTLE_S of calm on, plus the time to fly back to a lost altitude, the
mean error of each WINDOW_S must be within the tolerance.

Excepted, with the reason: a hold whose actuator failed for good; the airspeed
that the engine cannot give (the throttle is at its end); nose and altitude
below GUARDED_KT, where the laws lower the nose to keep flying.

It knows the record and docs/control-laws.md, nothing of the software, and
needs nothing but Python: it travels to the workers of a campaign.
"""

import argparse
import json
import sys
from pathlib import Path
from typing import NamedTuple

FRAMES_PER_S = 50
SETTLE_S = 45
WINDOW_S = 5
FLY_BACK_FT_S = 5.0
# A dive is over after so much of altitude hold.
PULL_UP_S = 10

# Mean error over the window.
TOLERANCE = {"bank": 3.0, "pitch": 2.0, "altitude": 8.0, "airspeed": 3.0}
UNIT = {"bank": "deg", "pitch": "deg", "altitude": "ft", "airspeed": "kt"}

# The measurement of each hold: column, unit of a word, and the word of zero.
MEASURED = {"bank": ("roll_attitude", 45 / 512, 2048),
            "pitch": ("pitch_attitude", 45 / 1024, 2048),
            "altitude": ("altitude", 0.5, 0),
            "airspeed": ("airspeed", 1 / 32, 0)}

# The modes as the record numbers them.
BANK_BY_STICK, WINGS_LEVEL, ORBIT = 2, 3, 4
PITCH_BY_STICK, HOLD_ALTITUDE, GLIDE = 2, 3, 4
HOLD_AIRSPEED = 1

STICK_BANK_DEG = 45.0 / 2048
STICK_PITCH_DEG = 20.0 / 2048
LEVEL_PITCH_DEG = 2.4
LOWEST_PITCH_DEG, HIGHEST_PITCH_DEG = -12.0, 15.0
ORBIT_DEG_PER_KT, ORBIT_FASTEST_KT = 0.157, 95.0
HELD_KT = (60.0, 95.0)
LEVER_KT = 0.4 / 32
GLIDE_KT = 63.0
GUARDED_KT = 59.5
FULL, IDLE = 4090, 5
ON_THE_GROUND_FT = 30.0

# The holds that need a surface.
NEEDED = {"aileron": ("bank",), "rudder": ("bank",),
          "elevator": ("pitch", "altitude", "airspeed"),
          "flap": ("bank", "pitch", "altitude", "airspeed"),
          "throttle": ("airspeed", "altitude")}
SOUND_PERCENT = 50

COMMANDS = ("roll", "pitch", "yaw", "throttle", "brake",
            *(f"switch{number}" for number in range(1, 9)))
STALE = 1


class Faults(NamedTuple):
    """When surfaces or the aircraft's node were disturbed, in ms, and the
    holds that cannot be held any more: from when on, and why."""

    times: list
    node_times: list
    lost: dict


def faults_of(text):
    times, node_times, last = [], [], {}
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if not words:
            continue
        at = float(words[0])
        if words[1] == "mcs":
            node_times.append(at)
        elif words[1] == "surface":
            is_sound = (words[3] == "slow"
                        and float(words[4]) >= SOUND_PERCENT)
            before = last.get(words[2])
            if before is None or at >= before[0]:
                last[words[2]] = (at, is_sound)
            times.append(at)
    lost = {}
    for name, (at, is_sound) in sorted(last.items()):
        if not is_sound:
            kind = next((kind for kind in NEEDED if kind in name), None)
            for hold in NEEDED.get(kind, ()):
                first, _ = lost.get(hold, (at, ""))
                lost[hold] = (min(first, at), f"{name} failed for good")
    return Faults(sorted(times), sorted(node_times), lost)


class Row(NamedTuple):
    time: float
    heard: tuple
    modes: tuple
    measured: dict
    throttle: int
    true_altitude: float


def rows_of(path):
    """The rows of a record that has the laws and an aircraft; else none."""
    with open(path, encoding="utf-8") as file:
        titles = file.readline().rstrip("\n").split(",")
        if not {"laws.lateral", "truth.altitude_ft"} <= set(titles):
            return
        uplink = [titles.index(f"mcs.uplink.{name}")
                  for name in (*COMMANDS, "error")]
        heard = (0,) * len(COMMANDS)
        modes = [titles.index(f"laws.{name}")
                 for name in ("lateral", "vertical", "power", "link")]
        sensors = {hold: titles.index(f"mcs.downlink.{column}")
                   for hold, (column, _, _) in MEASURED.items()}
        time, throttle, height = map(titles.index, (
            "time_ms", "pwm.throttle", "truth.altitude_ft"))
        for line in file:
            cells = line.split(",")
            if len(cells) < len(titles):
                return
            *commands, error = (int(cells[at]) for at in uplink)
            if not error & STALE:
                heard = tuple(commands)
            yield Row(
                float(cells[time]), heard,
                tuple(int(cells[at]) for at in modes),
                {hold: (int(cells[at]) - MEASURED[hold][2])
                 * MEASURED[hold][1] for hold, at in sensors.items()},
                int(cells[throttle]), float(cells[height]))


def within(value, least, most):
    return max(least, min(most, value))


class Engaged:
    """The words when the hold of altitude and airspeed began."""

    def __init__(self):
        self.altitude = self.airspeed = self.lever = None
        self.modes = (0, 0, 0, 0)

    def see(self, row, lever):
        _, vertical, power, _ = row.modes
        if vertical == HOLD_ALTITUDE != self.modes[1]:
            self.altitude = row.measured["altitude"]
        if power == HOLD_AIRSPEED != self.modes[2]:
            self.airspeed, self.lever = row.measured["airspeed"], lever
        self.modes = row.modes

    def forget(self):
        self.altitude = self.airspeed = None


def targets(row, sticks, engaged):
    """The violation of each active hold that has one."""
    lateral, vertical, power, _ = row.modes
    speed = row.measured["airspeed"]
    if lateral == BANK_BY_STICK:
        yield "bank", (sticks["roll"] - 2048) * STICK_BANK_DEG
    elif lateral == WINGS_LEVEL:
        yield "bank", 0.0
    elif lateral == ORBIT:
        yield "bank", ORBIT_DEG_PER_KT * within(
            speed, HELD_KT[0], ORBIT_FASTEST_KT)
    if vertical == PITCH_BY_STICK:
        yield "pitch", within(
            LEVEL_PITCH_DEG + (sticks["pitch"] - 2048) * STICK_PITCH_DEG,
            LOWEST_PITCH_DEG, HIGHEST_PITCH_DEG)
    elif vertical == HOLD_ALTITUDE and engaged.altitude is not None:
        yield "altitude", engaged.altitude
    elif vertical == GLIDE:
        yield "airspeed", GLIDE_KT
    if power == HOLD_AIRSPEED and engaged.airspeed is not None:
        yield "airspeed", within(
            engaged.airspeed + (sticks["throttle"] - engaged.lever)
            * LEVER_KT, *HELD_KT)


def exception(hold, error, row, faults):
    """Why a hold need not be held; empty if it must."""
    lost_from, reason = faults.lost.get(hold, (None, ""))
    if reason and row.time >= lost_from:
        return reason
    if row.modes[1] == GLIDE and hold == "airspeed":
        return ""
    if hold == "airspeed" and (
            error < 0 and row.throttle >= FULL
            or error > 0 and row.throttle <= IDLE):
        return "the engine cannot give this airspeed"
    if (row.measured["airspeed"] < GUARDED_KT
            and hold in ("pitch", "altitude") and error < 0):
        return "the nose is lowered to keep flying"
    return ""


class Findings(NamedTuple):
    """Holds not held, as text; windows judged and excepted by hold; the
    reasons; whether it came to the ground."""

    not_held: list
    judged: dict
    excepted: dict
    reasons: list
    landed: bool

    def as_json(self):
        return {"not_held": len(self.not_held), "which": self.not_held,
                "judged": self.judged, "excepted": self.excepted,
                "reasons": self.reasons, "landed": self.landed}


class Window:
    """The errors of a hold in the last seconds."""

    def __init__(self):
        self.sum, self.count, self.reason = 0.0, 0, ""

    def add(self, error, reason):
        self.sum += error
        self.count += 1
        self.reason = self.reason or reason


def check(record, faults=None):
    """The violations of a flight, from the paths of its record and its
    faults."""
    text = Path(faults).read_text("utf-8-sig") if faults else ""
    return judge(rows_of(record), faults_of(text))


def judge(rows, faults):
    found = {}
    judged, excepted, reasons = {}, {}, []
    engaged, windows, far = Engaged(), {}, {}
    before, since, landed = None, 0.0, False
    disturbed, reset = iter(faults.times), iter(faults.node_times)
    next_fault, next_reset = next(disturbed, None), next(reset, None)
    for row in rows:
        if row.true_altitude < ON_THE_GROUND_FT:
            landed = True
            if (row.modes[1] == HOLD_ALTITUDE == (before or row).modes[1]
                    and row.time - since >= PULL_UP_S * 1000
                    and "altitude" not in faults.lost):
                found[since, "altitude"] = (
                    f"{row.time:g} ms: it comes to the ground though the"
                    f" altitude is held since {since:g} ms")
            break
        sticks = dict(zip(COMMANDS, row.heard, strict=True))
        engaged.see(row, sticks["throttle"])
        moved = (before is None or row.modes != before.modes
                 or row.heard != before.heard)
        while next_fault is not None and row.time >= next_fault:
            next_fault, moved = next(disturbed, None), True
        while next_reset is not None and row.time >= next_reset:
            next_reset, moved = next(reset, None), True
            engaged.forget()
        if moved:
            since, windows, far = row.time, {}, {}
        before = row
        calm_s = (row.time - since) / 1000
        for hold, target in targets(row, sticks, engaged):
            error = row.measured[hold] - target
            # A dive goes on for a while after its altitude is to be held.
            if hold == "altitude" and calm_s <= PULL_UP_S:
                far[hold] = max(far.get(hold, 0.0),
                                abs(error) / FLY_BACK_FT_S)
            if calm_s < SETTLE_S + far.get(hold, 0.0):
                continue
            window = windows.setdefault(hold, Window())
            window.add(error, exception(hold, error, row, faults))
            if window.count == WINDOW_S * FRAMES_PER_S:
                del windows[hold]
                if window.reason:
                    excepted[hold] = excepted.get(hold, 0) + 1
                    if window.reason not in reasons:
                        reasons.append(window.reason)
                    continue
                judged[hold] = judged.get(hold, 0) + 1
                mean = window.sum / window.count
                if abs(mean) > TOLERANCE[hold]:
                    found.setdefault((since, hold), (
                        f"{row.time:g} ms: {hold} is not held: {mean:+.1f}"
                        f" {UNIT[hold]} off {target:.1f} after"
                        f" {calm_s:.0f} s of calm"))
    return Findings(list(found.values()), judged, excepted, reasons, landed)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("record", help="of a simulated flight")
    parser.add_argument("--faults", help="that the flight was given")
    parser.add_argument("--json", action="store_true",
                        help="one object instead of lines")
    given = parser.parse_args()
    try:
        findings = check(given.record, given.faults)
    except (OSError, ValueError) as error:
        print(f"holds.py: {error}", file=sys.stderr)
        return 2
    if given.json:
        print(json.dumps(findings.as_json()))
        return 0
    for line in findings.not_held:
        print(line)
    print(f"{sum(findings.judged.values())} windows judged,"
          f" {len(findings.not_held)} holds not held")
    return 1 if findings.not_held else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flights that lose the pilot's console at a random second (SAF-10).

    evidence/console_losses.py [--flights N] [--way NAME] [--seed N] [--jobs N]

Each way to lose the console (`WAYS`) is flown N times, in turn in the standard
flight and in the circuit, with the control laws on. The console is back after
60 s. A flight is good if

* it never banks more than 45 degrees while the console is lost,
* it never comes below 200 ft; where the console was lost lower than 250 ft,
  it does not come more than 50 ft lower than it was,
* nothing fresh but the safe words reaches the aircraft, and those never above
  50 ft, and the link is back at the end,
* an aircraft slower than 42 kt on the runway stops: engine idle, brake on,
  3.5 s after the last console packet and 0.5 s after it was faster.

A line for each flight that is not well, and a last one for each way.
"""

import argparse
import os
import random
import sys
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import link_cuts

# How much longer the station sends the last words of a page that says
# nothing any more (ground/urv/sticks.py); the others it knows at once.
WAYS = {"closed-page": 0, "hidden-page": 0, "unplugged-gamepad": 0,
        "killed-station": 0, "hung-browser": 200}

FLIGHTS = {"standard": 180, "circuit": 235}
LOST_MS, BACK_MS, GROUND_MS, SLOW_MS = 600, 1_500, 3_500, 500
AWAY_S = 60
STEEPEST, LOWEST, LOWER = 45.0, 200.0, 50.0
ON_GROUND_KT, ON_GROUND_FT, ROLLING_FT = 42.0, 50.0, 5.0
IDLE, BRAKED = "0", "4095"
SAFE = {"throttle": "0", "brake": "4095"} | {
    f"switch{n}": "0" for n in range(1, 9)} | {
    name: "2048" for name in ("roll", "pitch", "yaw")}


class Loss(NamedTuple):
    """A flight to be made: the pilot's, and when the console is lost."""

    way: str
    pilot: str
    at_ms: int


def losses(way, number, seed=1):
    """The flights of a way, the same ones for the same seed."""
    chance = random.Random(f"{way} {seed}")
    return [Loss(way, pilot, chance.randrange(1_000, FLIGHTS[pilot] * 1_000))
            for pilot, _ in zip(
                (pilot for _ in range(number) for pilot in FLIGHTS),
                range(number), strict=False)]


def fly(loss):
    """The faults of a flight, as text; none in a good flight."""
    silent_ms = loss.at_ms + WAYS[loss.way]
    back_ms = loss.at_ms + AWAY_S * 1000
    rows = link_cuts.rows_from(
        loss.at_ms, f"{silent_ms} gsc console {back_ms - silent_ms}",
        back_ms // 1000 + 5, loss.pilot)
    return "; ".join(problems(rows, silent_ms, back_ms))


def is_fresh(row):
    return not int(row["mcs.uplink.error"]) & 1


def is_safe(row):
    return all(row[f"mcs.uplink.{name}"] == word
               for name, word in SAFE.items())


def rolling(rows, from_ms):
    """The rows of an aircraft that is slow, and whose engine or brake is not
    as it must be."""
    slow_from = 0
    for row in rows:
        now = float(row["time_ms"])
        if float(row["truth.airspeed_kt"]) >= ON_GROUND_KT:
            slow_from = now + SLOW_MS
        if now >= max(from_ms, slow_from) and (
                row["pwm.throttle"], row["pwm.brake"]) != (IDLE, BRAKED):
            yield row


def problems(rows, silent_ms, back_ms):
    """The violations in the rows from the loss on."""
    lost = [row for row in rows if float(row["time_ms"]) < back_ms]
    height = [float(row["truth.altitude_ft"]) for row in lost]
    on_ground = (float(lost[0]["truth.airspeed_kt"]) < ON_GROUND_KT
                 and height[0] < ROLLING_FT)
    bank = max(abs(float(row["truth.bank_deg"])) for row in lost)
    if bank > STEEPEST:
        yield f"{bank:.1f} degrees of bank"
    floor = LOWEST if height[0] >= LOWEST + LOWER else height[0] - LOWER
    if min(height) < floor:
        yield f"down to {min(height):.0f} ft from {height[0]:.0f}"
    for row in lost:
        if float(row["time_ms"]) < silent_ms + LOST_MS or not is_fresh(row):
            continue
        if not is_safe(row):
            yield f"fresh commands at {row['time_ms']} ms"
            break
        if float(row["truth.altitude_ft"]) > ON_GROUND_FT:
            yield f"the safe words in flight at {row['time_ms']} ms"
            break
    if on_ground and (hot := list(rolling(lost, silent_ms + GROUND_MS))):
        yield f"no brake or power on the ground at {hot[0]['time_ms']} ms"
    back = [row for row in rows if float(row["time_ms"]) >= back_ms + BACK_MS]
    if not back or any(row["laws.link"] != link_cuts.LINKED for row in back):
        yield "the pilot does not have it back"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--flights", type=int, default=500, metavar="N",
                        help="flights of each way (500)")
    parser.add_argument("--way", choices=WAYS, action="append",
                        help="only this way; may be given again")
    parser.add_argument("--seed", type=int, default=1, metavar="N",
                        help="other random seconds (1)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        metavar="N", help="flights at once (one a processor)")
    chosen = parser.parse_args()

    bad = 0
    for way in chosen.way or WAYS:
        flights = losses(way, chosen.flights, chosen.seed)
        with ThreadPoolExecutor(chosen.jobs) as pool:
            said = list(pool.map(fly, flights))
        for loss, what in zip(flights, said, strict=True):
            if what:
                print(f"{way}: {loss.pilot} at {loss.at_ms} ms: {what}")
        wrong = sum(map(bool, said))
        print(f"{way}: {len(flights)} flights, {wrong} not well", flush=True)
        bad += wrong
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())

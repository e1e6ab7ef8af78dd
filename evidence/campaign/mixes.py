# SPDX-License-Identifier: Apache-2.0
"""Random mixes of all kinds of faults, each a short flight of its own.

A mix's number is all that is needed to make it again. Half of them fly as the
report has it; the others in the fast schedule, in step, with a clock that
drifts, sealed, or with orders besides the sticks, or in several of these.
Sticks and sensors keep their words for at least 40 ms, so that a word shows
its time at the console. The safety monitor knows the events that must never
happen.
"""

import random
from typing import NamedTuple

import data
from flight_numbers import FRAMES_PER_S, NUMBERS

SHORTEST_S, LONGEST_S = 2, 4
HELD_MS = 40
NODES = ("gsc", "mcs")
WAYS = ("up", "down")


MOST_DRIFT_PPM = 200
KNOWN_KINDS = (0, 0x100, 0x200, 0x300, 0x400)
# The same for each flight: the same number leaves the same bytes.
KEY = f"key 1 {'5a' * 16}\n"


class Mix(NamedTuple):
    """Schedule and drift are among the options; the safety monitor is told,
    too. The files are by the option that names them."""

    options: tuple
    files: dict
    schedule: str
    drift: str


def at_ms(time):
    return f"{max(time, 0):.3f}"


def spread(chance, least, most):
    """From least to most, each power of ten as likely as the next."""
    return least * (most / least) ** chance.random()


def script(chance, names, length_ms, switches):
    """Rows of random words; switches are often well off or well on."""
    lines = [f"time_ms,{','.join(names)}"]
    words = [0x800] * (len(names) - switches) + [0] * switches
    time = chance.uniform(0, 300) * chance.randrange(2)
    while time < length_ms:
        for place in range(len(names)):
            if chance.random() < 0.7:
                words[place] = chance.randrange(0x1000)
                if place >= len(names) - switches and chance.random() < 0.8:
                    words[place] = chance.choice((0, 0x7FF, 0x800, 0xFFF))
        lines.append(f"{at_ms(time)},{','.join(map(str, words))}")
        time += HELD_MS + chance.choice((0, 0.5, 20, chance.uniform(0, 200)))
    return "\n".join(lines) + "\n"


def fault(chance, time, node):
    """The lines of one fault, or of a few that belong together."""
    way = chance.choice(WAYS)
    kind = chance.choice((
        "cut", "ber", "character", "character", "adc", "adc", "telemetry",
        "start", "start", "starts", "both", "bus_error", "rom", "ram"))
    if kind == "cut":
        return [f"{at_ms(time)} cut {at_ms(spread(chance, 0.1, 500))}"]
    if kind == "ber":
        return [f"{at_ms(time)} {way} ber {spread(chance, 1e-5, 2e-2):.7f}"
                f" {at_ms(spread(chance, 1, 2_000))}"]
    if kind == "character":
        count = chance.randrange(1, 60)
        harm = chance.choice((
            "drop {n}", "dup {n}", f"insert {{n}} {chance.randrange(256):x}",
            f"flip {{n}} {chance.randrange(1, 512):x}",
            f"flip {{n}} {chance.choice((3, 6, 0x11, 0xF0)):x}"))
        return [f"{at_ms(time)} {way} {harm.format(n=count + more)}"
                for more in range(chance.randrange(1, 4))]
    if kind in ("adc", "telemetry"):
        return [f"{at_ms(time)} {node} stall {kind}"
                f" {at_ms(spread(chance, 0.1, 300))}"]
    if kind == "start":
        how = chance.choice(("warm", "processor", "telemetry"))
        return [f"{at_ms(time)} {node} reset {how}"]
    if kind == "starts":
        lines = []
        for _ in range(chance.randrange(2, 12)):
            how = chance.choice(("reset warm", "reset processor",
                                 "bus_error"))
            lines.append(f"{at_ms(time)} {node} {how}")
            time += chance.uniform(0, 13)
        return lines
    if kind == "both":
        return [f"{at_ms(time)} {each} reset"
                f" {chance.choice(('warm', 'processor', 'telemetry'))}"
                for each in NODES]
    if kind == "bus_error":
        return [f"{at_ms(time)} {node} bus_error"]
    if kind == "rom":
        return [f"{at_ms(time)} {node} rom {chance.randrange(0x10000):x}"
                f" {chance.randrange(1, 256):x}"]
    return [f"{at_ms(time)} {node} ram {chance.randrange(0x2000):x}"
            f" {chance.randrange(1, 0x10000):x}"]


def lost_consoles(chance, length_ms):
    """Lines of consoles that are lost once or twice, some from the start on
    or to the end (SAF-10)."""
    lines = []
    for _ in range(chance.randrange(1, 3)):
        time = chance.uniform(0, length_ms) * chance.choice((0, 1, 1, 1))
        lines.append(f"{at_ms(time)} gsc console"
                     f" {at_ms(spread(chance, 10, 2 * length_ms))}")
    return lines


def halts(chance, length_ms):
    """In every fifth mix a node's processor stops, the aircraft's more often,
    and in half of these a reset ends it."""
    if chance.random() >= 0.2:
        return []
    node = chance.choice(("mcs", "mcs", "gsc"))
    time = chance.uniform(0, length_ms)
    how = chance.choice(("warm", "processor"))
    lines = [f"{at_ms(time)} {node} halt"]
    if chance.random() < 0.5:
        time += spread(chance, 1, 1_500)
        lines.append(f"{at_ms(time)} {node} reset {how}")
    return lines


def orders(chance, length_ms):
    """Configurations, good and bad, and blocks of other kinds, most of which
    nobody knows."""
    kinds = (*KNOWN_KINDS, *(chance.randrange(0x1000) for _ in KNOWN_KINDS))
    lines = []
    at = chance.uniform(0, length_ms)
    while at < length_ms:
        time = at_ms(at)
        at += 100 + chance.uniform(0, length_ms / 3)
        if chance.random() < 0.5:
            orbit_ms = chance.randrange(0, 20_000, 100)
            lines.append(f"{time} configure {chance.randrange(0, 4)}"
                         f" {orbit_ms} {orbit_ms + 20_000}")
        else:
            words = [chance.randrange(0x1000)
                     for _ in range(chance.randrange(13))]
            lines.append(" ".join(map(str, (
                time, "block", f"{chance.choice(kinds):x}", *words))))
    return "\n".join(lines) + "\n"


def ways_to_fly(chance, length_ms):
    """Options besides the report's, their files, schedule and drift."""
    options, files = [], {}
    schedule, drift = "report", "0"
    if chance.random() < 0.5:
        return options, files, schedule, drift
    if chance.random() < 0.5:
        schedule = "fast"
        options += ["--schedule", schedule]
    if chance.random() < 0.5:
        options += ["--lock"]
    if chance.random() < 0.5:
        drift = str(chance.randint(-MOST_DRIFT_PPM, MOST_DRIFT_PPM))
        options += [f"--drift={drift}"]
    if chance.random() < 0.3:
        options += ["--format", "2"]
        files["key"] = KEY
    if chance.random() < 0.3:
        files["orders"] = orders(chance, length_ms)
    return options, files, schedule, drift


def of_number(number, message_format=1):
    """The mix of that number: the options of its flight, and its files. In
    format 2 all fly sealed, else some."""
    chance = random.Random(f"mix {number}")
    frames = chance.randrange(
        SHORTEST_S * FRAMES_PER_S, LONGEST_S * FRAMES_PER_S + 1)
    length_ms = frames * NUMBERS.frame_us // 1000
    lines = []
    centre = chance.choice((0, chance.uniform(0, length_ms)))
    for _ in range(chance.randrange(1, 9)):
        # Some together, often as the nodes are switched on.
        time = (centre + chance.expovariate(1 / 40)
                if chance.random() < 0.5 else chance.uniform(0, length_ms))
        lines += fault(chance, time, chance.choice(NODES))
    lines += halts(random.Random(f"mix {number} stands"), length_ms)
    options = ("--seconds", f"{frames / FRAMES_PER_S:.2f}",
               "--phase", str(chance.randrange(NUMBERS.frame_ticks)), "--seed", str(number),
               "--processors", chance.choice(("1", "2", "3", "4")))
    files = {"sticks": script(chance, data.STICKS, length_ms, 8),
             "sensors": script(chance, data.SENSORS, length_ms, 0),
             "faults": "".join(f"{line}\n" for line in lines)}
    more, more_files, schedule, drift = ways_to_fly(
        random.Random(f"mix {number} flies"), length_ms)
    lost = random.Random(f"mix {number} loses its console")
    if lost.random() < 0.2:
        files["faults"] += "".join(
            f"{line}\n" for line in lost_consoles(lost, length_ms))
        if lost.random() < 0.5:
            # The aircraft is on the ground.
            files["sensors"] = "time_ms,airspeed,altitude\n0,0,0\n"
    if message_format == 2 and "key" not in more_files:
        more += ["--format", "2"]
        more_files["key"] = KEY
    return Mix((*options, *more), files | more_files, schedule, drift)

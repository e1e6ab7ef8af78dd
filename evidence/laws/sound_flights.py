#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flights with sound servos, in which no surface may be reported (EXT-6).

    evidence/laws/sound_flights.py [--flights N] [--seed N] [--jobs N]

Each flight is drawn from its seed: the sticks (steps, doublets, sweeps, random
telegraph, noise, to full travel), the modes of the control laws, how quick the
servos are and how wide their dead band is, phase, schedule and processors; in
some, cuts of the link and restarts. Nine of ten fly on the bench, one with
JSBSim. Exit status 1 when a surface or the engine was reported.
"""

import argparse
import csv
import itertools
import json
import math
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from whole_numbers import whole  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

SECONDS, FRAME_MS = 20, 20
FRAMES = SECONDS * 1000 // FRAME_MS
FRAME_S = FRAME_MS / 1000
MIDDLE, LARGEST = 2048, 4095

# One flight in this number is with JSBSim.
JSBSIM_EVERY = 10

# Per cent of the plant's lag: of JSBSim's 100 ms and the bench's 64 ms. Both
# end at 150 ms, the slowest servo that the monitor calls sound.
LAG = {"jsbsim": (50, 150), "bench": (50, 234)}
RATE = (50, 150)
DEAD_BAND = (0, 1)

AXES = ("roll", "pitch", "yaw", "throttle", "brake")
SWITCHES = tuple(f"switch{number}" for number in range(1, 9))
# The modes that a flight may begin with; disconnect and flaps come later.
MODE_SWITCHES = SWITCHES[:5]

FAULTS = (
    "cut {length}", "mcs reset warm", "mcs reset processor",
    "gsc reset processor", "mcs bus_error", "mcs stall adc {short}",
    "mcs stall telemetry {short}", "gsc stall adc {short}",
    "up ber 0.003 {short}", "down ber 0.003 {short}")


class Drawn(NamedTuple):
    """A flight's input files and options."""

    sticks: str
    conditions: str
    faults: str
    options: list


class Flown(NamedTuple):
    """The report and its first time; nothing in a sound flight."""

    seed: int
    reported: list
    time_ms: object


def plant_of(seed):
    return "jsbsim" if seed % JSBSIM_EVERY == 0 else "bench"


# --- sticks ------------------------------------------------------------------

def rest(chance, size):
    return [0.0] * chance.randrange(10, 150)


def step(chance, size):
    before, after = chance.randrange(50), chance.randrange(5, 100)
    return [0.0] * before + [chance.choice((-size, size))] * after


def doublet(chance, size):
    half = chance.randrange(1, 25)
    return [size] * half + [-size] * half + [0.0] * 10


def sweep(chance, size):
    slow, quick = chance.uniform(0.05, 2), chance.uniform(2, 25)
    length, phase, found = chance.randrange(50, 250), 0.0, []
    for frame in range(length):
        hertz = slow * (quick / slow) ** (frame / length)
        phase += 2 * math.pi * hertz * FRAME_S
        found.append(size * math.sin(phase))
    return found


def sine(chance, size):
    hertz = math.exp(chance.uniform(math.log(0.1), math.log(25)))
    begins = chance.uniform(0, 2 * math.pi)
    return [size * math.sin(begins + 2 * math.pi * hertz * FRAME_S * frame)
            for frame in range(chance.randrange(10, 150))]


def telegraph(chance, size):
    often, value, found = chance.choice((0.03, 0.1, 0.3, 0.5)), size, []
    for _ in range(chance.randrange(10, 150)):
        if chance.random() < often:
            value = -value
        found.append(value)
    return found


def noise(chance, size):
    return [chance.gauss(0, size / 3)
            for _ in range(chance.randrange(10, 150))]


SHAPES = (rest, step, doublet, sweep, sine, telegraph, noise)


def axis(chance):
    """A stick's word in each frame."""
    found = []
    while len(found) < FRAMES:
        size = chance.choice(
            (MIDDLE, chance.randrange(1, MIDDLE), chance.randrange(1, 400)))
        middle = chance.choice((0, 0, chance.randrange(-MIDDLE, MIDDLE)))
        found += [middle + value
                  for value in chance.choice(SHAPES)(chance, size)]
    return [max(0, min(LARGEST, round(MIDDLE + value)))
            for value in found[:FRAMES]]


def switch(chance, name):
    often = chance.choice((0.0, 0.0, 0.002, 0.01))
    value = chance.choice((0, LARGEST)) if name in MODE_SWITCHES else 0
    found = []
    for _ in range(FRAMES):
        if chance.random() < often:
            value = LARGEST - value
        found.append(value)
    return found


def sticks(chance, is_gentle):
    columns = {name: axis(chance) for name in AXES}
    if is_gentle:
        # It stays in the air longer.
        for name in ("roll", "pitch", "yaw"):
            columns[name] = [MIDDLE + (word - MIDDLE) // 4
                             for word in columns[name]]
        columns["throttle"] = [1024 + word * 3 // 4
                               for word in columns["throttle"]]
    columns.update((name, switch(chance, name)) for name in SWITCHES)
    later_ms = chance.randrange(FRAME_MS)
    lines = ["time_ms," + ",".join(columns)]
    for frame, words in enumerate(zip(*columns.values(), strict=True)):
        time_ms = frame and frame * FRAME_MS + later_ms
        lines.append(f"{time_ms}," + ",".join(map(str, words)))
    return "\n".join(lines) + "\n"


# --- flights -----------------------------------------------------------------

def faults(chance):
    lines = sorted(
        (chance.randrange(100, SECONDS * 1000),
         chance.choice(FAULTS).format(length=chance.randrange(20, 3000),
                                      short=chance.randrange(1, 200)))
        for _ in range(chance.randrange(1, 5)))
    return "".join(f"{time_ms} {fault}\n" for time_ms, fault in lines)


def draw(seed):
    """The flight of that seed, whichever others are flown."""
    chance = random.Random(f"sound servos {seed}")
    plant = plant_of(seed)
    flown = sticks(chance, plant == "jsbsim" and chance.random() < 0.5)
    dead_band = chance.choice((*DEAD_BAND, chance.uniform(*DEAD_BAND)))
    conditions = (f"servos {chance.uniform(*LAG[plant]):.3f}"
                  f" {chance.uniform(*RATE):.3f} {dead_band:.3f}\n")
    if plant == "jsbsim" and chance.random() < 0.5:
        conditions += (f"wind {chance.randrange(360)} {chance.randrange(15)}\n"
                       f"turbulence {chance.randrange(16)}\n")
    options = ["--plant", plant, "--laws", "on", "--seconds", str(SECONDS),
               "--seed", str(seed), "--phase", str(chance.randrange(10)),
               "--schedule", chance.choice(("report", "fast"))]
    for option in (["--lock"], ["--drift", str(chance.randint(-200, 200))],
                   ["--processors", "2"]):
        if chance.random() < 0.2:
            options += option
    return Drawn(flown, conditions,
                 faults(chance) if chance.random() < 0.3 else "# none\n",
                 options)


def first_report(record):
    """When something was first reported. After a crash nothing moves any more,
    the servos do not either, and nothing is judged."""
    before = None
    with open(record, encoding="ascii", newline="") as lines:
        for row in csv.DictReader(lines):
            truth = [value for name, value in row.items()
                     if name.startswith("truth.")]
            if truth and truth == before:
                return None
            before = truth
            if int(row["laws.failed"]):
                return float(row["time_ms"])
    return None


def fly(drawn, folder):
    """Fly it in this folder, where its files stay; what was reported, and
    when."""
    for name, text in (("sticks.csv", drawn.sticks),
                       ("conditions.txt", drawn.conditions),
                       ("faults.txt", drawn.faults)):
        (folder / name).write_text(text, encoding="ascii")
    command = [
        PROGRAM, "fly", "--quiet", *drawn.options, "--sticks", "sticks.csv",
        "--conditions", "conditions.txt", "--faults", "faults.txt",
        "--summary", "summary.json"]
    subprocess.run(command, cwd=folder, check=True, stdin=subprocess.DEVNULL)
    reported = json.loads((folder / "summary.json").read_text("utf-8")).get(
        "failed_surfaces", [])
    if not reported:
        return [], None
    subprocess.run([*command, "--record", "record.csv"], cwd=folder,
                   check=True, stdin=subprocess.DEVNULL)
    time_ms = first_report(folder / "record.csv")
    return (reported, time_ms) if time_ms is not None else ([], None)


def flown(seed):
    with tempfile.TemporaryDirectory() as folder:
        return Flown(seed, *fly(draw(seed), Path(folder)))


# --- the campaign ------------------------------------------------------------

def campaign(seeds, jobs, say=lambda line: None):
    """Those of these flights in which something was reported."""
    found = []
    with ProcessPoolExecutor(jobs) as pool:
        for count, each in enumerate(pool.map(flown, seeds, chunksize=4), 1):
            if each.reported:
                found.append(each)
            if count % 100 == 0:
                say(f"{count} of {len(seeds)}")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--flights", type=whole(1), default=100)
    parser.add_argument("--seed", type=int, default=1,
                        help="of the first; the others follow")
    parser.add_argument("--jobs", type=whole(1), default=os.cpu_count())
    chosen = parser.parse_args()
    seeds = range(chosen.seed, chosen.seed + chosen.flights)
    found = campaign(
        seeds, chosen.jobs,
        lambda line: print(f"sound flights: {line}", file=sys.stderr))
    for each in itertools.islice(found, 20):
        print(f"seed {each.seed}: {', '.join(each.reported)} reported at"
              f" {each.time_ms:.0f} ms")
    count = sum(plant_of(seed) == "jsbsim" for seed in seeds)
    print(f"sound flights: {len(seeds)}, {count} of them with JSBSim;"
          f" {len(found)} with a false report")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Sealed flights with someone in the middle of the line (SEC-4).

    evidence/attack.py [--flights N] [--seed N] [--jobs N]

The attacker has no key. In either direction he delays, withholds, drops,
repeats and reorders blocks, and puts in those of sessions before; now and then
a node starts cold, which ends a session. In every frame the pilot's roll stick
and the measured altitude have words that they have in no other, so that the
record shows how old each word is. In every tenth flight the line only loses
half of the frames. A flight is well when

* no word that reaches the servos, or the ground's memory, was sealed more than
  0.3 s before,
* a line that delivers half of the frames has a session within 1 s,
* both nodes hear each other again within 2 s of the end of an attack.

A line for each flight that is not well, and a last one with the oldest word
taken. The exit status is 1 when a flight was not well.
"""

import argparse
import csv
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from whole_numbers import whole

ROOT = Path(__file__).resolve().parent.parent
SIMULATION = ROOT / "bin" / "urv_sim"
FRAME_MS = 20
FRAMES = 500
ATTACK_ENDS = 400
MOST_AGE_S = 0.3
SESSION_S, AGAIN_S = 1.0, 2.0
WAYS = ("up", "down")

# A word that rises with every frame, at its source and where it arrives: the
# pilot's to a servo, the aircraft's to the ground.
SOURCES = {"up": ("roll", "pwm.left_aileron"),
           "down": ("altitude", "gsc.downlink.altitude")}
FIRST_WORD = 1000


def words(way):
    """The word of each frame, by its time."""
    name = SOURCES[way][0]
    yield f"time_ms,{name}\n"
    for frame in range(FRAMES):
        yield f"{frame * FRAME_MS},{FIRST_WORD + frame}\n"


def half_lost(chance):
    """A line that delivers half of the frames. An aircraft that does not
    hear the ground's command sends nothing."""
    return [f"{frame * FRAME_MS} cut {FRAME_MS}"
            for frame in range(FRAMES) if chance.random() < 0.5]


def delayed(way, frame, chance):
    return [f"{frame * FRAME_MS} {way} replay {chance.randint(1, 100)}"
            f" {chance.randint(1, 100) * FRAME_MS}"]


def growing(way, frame, chance):
    """One block in two or three comes, and each is the oldest that has not."""
    share = chance.choice((2, 3))
    return [f"{(frame + step) * FRAME_MS} {way} replay"
            f" {step * (share - 1) // share} {FRAME_MS}"
            for step in range(share, 100)]


def reordered(way, frame, chance):
    return [f"{(frame + step) * FRAME_MS} {way} replay"
            f" {chance.randint(1, 12)} {FRAME_MS}"
            for step in range(chance.randint(5, 60)) if chance.random() < 0.7]


def repeated(way, frame, chance):
    """One block for a while."""
    first = chance.randint(1, 5)
    return [f"{(frame + step) * FRAME_MS} {way} replay {first + step}"
            f" {FRAME_MS}" for step in range(chance.randint(5, 60))]


def withheld(way, frame, chance):
    """Nothing for a while, then what was withheld, in order."""
    length = chance.randint(5, 60)
    return [f"{frame * FRAME_MS} {way} ber 0.5 {length * FRAME_MS}",
            f"{(frame + length) * FRAME_MS} {way} replay {length}"
            f" {length * FRAME_MS}"]


def dropped(way, frame, chance):
    return [f"{(frame + step) * FRAME_MS} {way} ber 0.5 {FRAME_MS}"
            for step in range(chance.randint(5, 60)) if chance.random() < 0.5]


def of_before(way, frame, chance):
    """A node starts cold, and the hellos and blocks of before come."""
    back = chance.randint(50, 300)
    return [f"{frame * FRAME_MS + chance.randrange(FRAME_MS)}"
            f" {chance.choice(('mcs', 'gsc'))} reset cold"] + [
        f"{(frame + step) * FRAME_MS} {way} replay {back} {FRAME_MS}"
        for step in range(chance.randint(5, 60)) if chance.random() < 0.5]


ATTACKS = (delayed, growing, reordered, repeated, withheld, dropped, of_before)


def script_of(number, seed):
    """The faults of a flight, and whether it is one that loses a half."""
    chance = random.Random(f"{seed} {number}")
    if number % 10 == 0:
        return half_lost(chance), True
    lines = []
    for _ in range(chance.randint(1, 6)):
        lines += chance.choice(ATTACKS)(
            chance.choice(WAYS), chance.randrange(20, ATTACK_ENDS), chance)
    return [line for line in lines if line_ends(line) <= ATTACK_ENDS], False


def line_ends(line):
    """The frame in which a fault is over."""
    parts = line.split()
    length = 0 if "reset" in line else float(parts[-1])
    return (float(parts[0]) + length) / FRAME_MS


def taken(rows, way):
    """The frames in which a word arrived that was not there before, and how
    many frames before it was its source's."""
    place = rows[0].index(SOURCES[way][1])
    last = None
    for frame, row in enumerate(rows[1:], 1):
        word = int(row[place])
        if word != last and FIRST_WORD <= word < FIRST_WORD + FRAMES:
            yield frame, frame - (word - FIRST_WORD)
        last = word


def fly(number, seed, folder, extra=()):
    """The faults of a flight, and the age of its oldest word."""
    faults, loses_half = script_of(number, seed)
    own = Path(tempfile.mkdtemp(dir=folder))
    (own / "faults.txt").write_text("\n".join(faults) + "\n", "utf-8")
    subprocess.run(
        [SIMULATION, "fly", "--quiet", "--seconds", str(FRAMES * FRAME_MS / 1000),
         "--sticks", folder / "up.csv", "--sensors", folder / "down.csv",
         "--faults", own / "faults.txt", "--record", own / "record.csv",
         "--seed", str(number), "--drift", str(number % 401 - 200),
         *(extra or ("--format", "2", "--key", folder / "key"))],
        check=True, timeout=300)
    with (own / "record.csv").open(encoding="utf-8") as file:
        rows = list(csv.reader(file))
    for path in own.iterdir():
        path.unlink()
    own.rmdir()
    oldest = 0
    wrongs = []
    for way in WAYS:
        ages = list(taken(rows, way))
        oldest = max([oldest, *(age for _, age in ages)])
        late = [(frame, age) for frame, age in ages
                if age * FRAME_MS > MOST_AGE_S * 1000]
        if late:
            wrongs.append(
                f"{way}: {len(late)} words too late, the first in frame"
                f" {late[0][0]} of {late[0][1] * FRAME_MS} ms")
        first = ages[0][0] if ages else FRAMES
        if loses_half and first * FRAME_MS > SESSION_S * 1000:
            wrongs.append(f"{way}: nothing until frame {first}")
        if not loses_half:
            again = next((frame for frame, _ in ages if frame >= ATTACK_ENDS),
                         FRAMES)
            if (again - ATTACK_ENDS) * FRAME_MS > AGAIN_S * 1000:
                wrongs.append(f"{way}: nothing after the attack")
    return [f"flight {number}, {each}" for each in wrongs], oldest


def prepare(folder):
    """The files that all flights have."""
    for way in WAYS:
        (folder / f"{way}.csv").write_text("".join(words(way)), "utf-8")
    key = folder / "key"
    key.write_text(f"key 1 {bytes(range(16)).hex()}\n", "ascii")
    key.chmod(0o600)


def main(arguments):
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("--flights", type=whole(1), default=2000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=whole(1), default=os.cpu_count())
    given = parser.parse_args(arguments)
    wrong = oldest = 0
    with tempfile.TemporaryDirectory() as name, ThreadPoolExecutor(
            given.jobs) as pool:
        folder = Path(name)
        prepare(folder)
        for found, age in pool.map(
                lambda number: fly(number, given.seed, folder),
                range(given.flights)):
            wrong += bool(found)
            oldest = max(oldest, age)
            for line in found:
                print(line, flush=True)
    print(f"{given.flights} flights, {wrong} not well, the oldest word taken"
          f" was of {oldest * FRAME_MS} ms before")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flights with a surface that has failed, with the laws and direct (EXT-6).

    evidence/laws/surfaces.py [--renew] [--jobs N] [--sound N]
                             [--sample N | --only-sound]

Each of the ten aerodynamic surfaces is stuck at nine places of its travel, or
floats, in three conditions, 10 s after the beginning of a flight of 60 s: in hold
of altitude and airspeed, and direct, where the simulated pilot flies level.
A flight is flown if its bank stays within 15 degrees and its altitude within
100 ft. Then flights with sound servos (sound_flights.py): no surface may be
named. --sample takes a number of cases of the grid, drawn by lot; --only-sound
none. --renew writes docs/evidence/surfaces.md; with --only-sound the page's
last lines.
"""

import argparse
import csv
import os
import random
import subprocess
import sys
import tempfile
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import NamedTuple

sys.path[:0] = [
    str(Path(__file__).resolve().parent),
    str(Path(__file__).resolve().parents[1]),
    str(Path(__file__).resolve().parents[2] / "scripts" / "laws")]

import allocation  # noqa: E402
import sound_flights  # noqa: E402
from whole_numbers import whole  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs" / "evidence" / "surfaces.md"
PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

FAULT_MS, SECONDS, FRAME_MS = 10_000, 60, 20
MOST_BANK, MOST_OFF = 15.0, 100.0
NEUTRAL = 2048

CONDITIONS = {
    "calm": "wind 0 0\n",
    "turbulence": "wind 40 10\nturbulence 15\n",
    "heavy": "ballast 30 1.0\n",
}
# The laws' switch 3: altitude and airspeed held.
STICKS = f"time_ms,throttle,switch3\n0,2048,4095\n{SECONDS}000,2048,4095\n"

# The linkages' travel, in words from neutral.
LOWEST = {"aileron": -2000, "elevator": -2000, "rudder": -2000, "flap": 0}
HIGHEST = {"aileron": 2000, "elevator": 2000, "rudder": 2000, "flap": 2047}
PLACES = 9
FLOATS = "float"

# A surface further from its word than this can be identified; it should be
# named within this time.
OFF_WORDS, NAMED_MS = 100, 500


class Case(NamedTuple):
    """`where` is words from neutral, or FLOATS."""

    surface: str
    where: object
    condition: str
    laws: bool

    def fault(self):
        what = (FLOATS if self.where == FLOATS
                else f"stuck {NEUTRAL + self.where}")
        return f"{FAULT_MS} surface {self.surface} {what}\n"


class Outcome(NamedTuple):
    """Most bank and altitude error after the fault; when the surface could be
    told and when it was named, in ms after the fault; who was named."""

    bank: float
    off: float
    told_from: object
    named: object
    failed: int

    @property
    def is_flown(self):
        return self.bank <= MOST_BANK and self.off <= MOST_OFF


def places(surface):
    family = allocation.family(surface)
    low, high = LOWEST[family], HIGHEST[family]
    return [low + round((high - low) * place / (PLACES - 1))
            for place in range(PLACES)]


def cases(sample=None):
    """Cases of the whole grid, or a number of them drawn by lot; each with the
    laws and direct."""
    grid = [(surface, where, condition)
            for surface in allocation.SURFACES
            for where in [*places(surface), FLOATS]
            for condition in CONDITIONS]
    if sample is not None:
        grid = random.Random(1).sample(grid, sample)
    return [Case(*each, laws) for each in grid for laws in (True, False)]


def must_be_flown(case):
    """A tenth of the other's authority is left when it makes up for this one;
    ailerons have the flaps, flaps the ailerons."""
    family = allocation.family(case.surface)
    return (case.where == FLOATS or family in ("aileron", "flap")
            or abs(case.where) <= 0.9 * HIGHEST[family])


def fly(folder, case, fault, *options):
    folder = Path(folder)
    (folder / "sticks.csv").write_text(STICKS, encoding="ascii")
    (folder / "faults.txt").write_text("# None.\n" + fault, encoding="ascii")
    (folder / "conditions.txt").write_text(
        CONDITIONS[case.condition], encoding="ascii")
    how = (["--laws", "on", "--sticks", "sticks.csv"] if case.laws
           else ["--laws", "off", "--pilot", "level"])
    subprocess.run(
        [PROGRAM, "fly", "--plant", "jsbsim", *how, "--faults", "faults.txt",
         "--conditions", "conditions.txt", "--quiet", *options],
        cwd=folder, check=True, stdin=subprocess.DEVNULL)


def record(folder, case, fault):
    """The rows of the flight from the fault on."""
    fly(folder, case, fault, "--seconds", str(SECONDS), "--seed", "1",
        "--record", "record.csv")
    with (Path(folder) / "record.csv").open(encoding="ascii", newline="") as lines:
        rows = list(csv.DictReader(lines))
    return rows[FAULT_MS // FRAME_MS:]


def flown(case):
    with tempfile.TemporaryDirectory() as folder:
        rows = record(folder, case, case.fault())
    told_from = named = None
    failed = 0
    if case.laws:
        bit = 1 << allocation.SURFACES.index(case.surface)
        for place, row in enumerate(rows):
            failed |= int(row["laws.failed"])
            off = abs(int(row[f"pwm.{case.surface}"])
                      - int(row[f"mcs.downlink.{case.surface}"]))
            if told_from is None and off > OFF_WORDS:
                told_from = place * FRAME_MS
            if named is None and failed & bit:
                named = place * FRAME_MS
    return Outcome(
        max(abs(float(row["truth.bank_deg"])) for row in rows),
        max(abs(float(row["truth.altitude_ft"]) - 1000) for row in rows),
        told_from, named, failed)


# --- the page ----------------------------------------------------------------

def title(where, surface):
    if where == FLOATS:
        return FLOATS
    degrees = where * allocation.PER_WORD[allocation.family(surface)]
    return f"{degrees:.1f}"


def share(outcomes):
    if not outcomes:
        return "none flown"
    count = sum(outcome.is_flown for outcome in outcomes)
    return f"{count} of {len(outcomes)} ({100 * count / len(outcomes):.0f} %)"


def table(found):
    lines = ["| surface | with the laws | worst bank, altitude"
             " | not flown, degrees and condition | direct |",
             "|---|---|---|---|---|"]
    for surface in allocation.SURFACES:
        laws = {case: outcome for case, outcome in found.items()
                if case.surface == surface and case.laws}
        direct = [outcome for case, outcome in found.items()
                  if case.surface == surface and not case.laws]
        good = [outcome for outcome in laws.values() if outcome.is_flown]
        worst = (f"{max(each.bank for each in good):.0f} degrees,"
                 f" {max(each.off for each in good):.0f} ft" if good else "")
        lost = ", ".join(
            f"{title(case.where, surface)} {case.condition}"
            for case, outcome in laws.items() if not outcome.is_flown)
        lines.append(f"| {surface} | {share(list(laws.values()))} | {worst} |"
                     f" {lost or 'none'} | {share(direct)} |")
    return "\n".join(lines)


def named_in_time(found):
    """The cases that could be identified: the number named in time, the number
    of all, and the longest time."""
    took = []
    for case, outcome in found.items():
        if case.laws and outcome.told_from is not None:
            # The doubt may have grown before it was that far off.
            took.append(None if outcome.named is None
                        else max(0, outcome.named - outcome.told_from))
    in_time = [each for each in took if each is not None
               and each <= NAMED_MS]
    return len(in_time), len(took), max(
        (each for each in took if each is not None), default=0)


def wrongly_named(found):
    return [case for case, outcome in found.items()
            if outcome.failed
            & ~(1 << allocation.SURFACES.index(case.surface))]


def page(found, alarms, flights):
    laws = {case: each for case, each in found.items() if case.laws}
    due = {case: each for case, each in laws.items() if must_be_flown(case)}
    stuck = [each for case, each in laws.items() if case.where != FLOATS]
    missed = [case for case, each in due.items() if not each.is_flown]
    in_time, tellable, longest = named_in_time(found)
    wrong = wrongly_named(found)
    return f"""# Failed surfaces

`make -C evidence surfaces RENEW=--renew` writes this page. Its last section is
written by `evidence/laws/surfaces.py --only-sound --sound 10000 --renew`.

Each surface is stuck at {PLACES} places, from stop to stop, or floats, from
{FAULT_MS // 1000} s of a flight of {SECONDS} s on. A case is flown if from then on
the bank stays within {MOST_BANK:.0f} degrees and the altitude within
{MOST_OFF:.0f} ft. Conditions: calm; light turbulence in 10 kt of wind; 30 lb more,
an inch aft. With the laws, altitude and airspeed are held. Direct, the simulated
pilot flies level, without any allocation. The grid has {len(cases()) // 2} cases;
{len(laws)} were flown{
    "" if len(found) == len(cases()) else ", drawn by lot"}, each both ways.

| | flown with the laws | direct |
|---|---|---|
| stuck | {share(stuck)} | {share([
    each for case, each in found.items()
    if not case.laws and case.where != FLOATS])} |
| floating | {share([
    each for case, each in laws.items() if case.where == FLOATS])} | {share([
    each for case, each in found.items()
    if not case.laws and case.where == FLOATS])} |
| a tenth of the partner's authority left | {share(
    list(due.values()))} | {share([
        found[case._replace(laws=False)] for case in due])} |

{"Every case with a tenth of authority left is flown."
 if not missed else "Not flown, though a tenth of authority is left: "
 + ", ".join(f"{case.surface} at {title(case.where, case.surface)}"
             f" ({case.condition})" for case in missed) + "."}

{table(found)}

## Identification

A surface can be identified once it is {OFF_WORDS} words off its command
({OFF_WORDS / 100:.0f} degree of an aileron); a surface stuck at its command
cannot. {tellable} of these flights could be identified:
{in_time} were within {NAMED_MS / 1000} s
({100 * in_time / max(1, tellable):.1f} %), the slowest after
{longest / 1000:.2f} s. A wrong surface was named in {len(wrong)}.

{sound_section(flights, alarms)}"""


SOUND = "## Sound servos\n"


def sound_section(flights, alarms):
    with_jsbsim = sum(sound_flights.plant_of(seed) == "jsbsim"
                      for seed in range(1, flights + 1))
    return f"""{SOUND}
Servos with half to one and a half times the modelled lag of 0.1 s (the
bench's: 32 to 150 ms) and rate limit, and dead bands of up to 1 % of the travel;
sticks that step, sweep, jump by chance and move to the stops, in every mode;
link cuts and restarts in three of ten flights. In {flights:,} flights of
{sound_flights.SECONDS} s ({flights - with_jsbsim:,} on the bench,
{with_jsbsim:,} with JSBSim) a sound surface or engine was reported in {alarms}.
"""


def sounded(jobs, number):
    """In how many flights with sound servos a surface was named."""
    return len(sound_flights.campaign(
        range(1, number + 1), jobs,
        lambda line: print(f"surfaces: sound flights {line}",
                           file=sys.stderr)))


def renewed(before, text):
    """The new page, with the last section of the old one: that is of more
    flights."""
    if SOUND not in before:
        return text
    return text.partition(SOUND)[0] + SOUND + before.partition(SOUND)[2]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--renew", action="store_true",
                        help="write docs/evidence/surfaces.md")
    parser.add_argument("--jobs", type=whole(1), default=os.cpu_count())
    parser.add_argument("--sound", type=whole(1), default=100,
                        help="flights without a fault")
    parser.add_argument("--sample", type=whole(1, len(cases()) // 2),
                        help="a number of cases of the grid")
    parser.add_argument("--only-sound", action="store_true",
                        help="no case of the grid")
    chosen = parser.parse_args()
    if chosen.only_sound:
        alarms = sounded(chosen.jobs, chosen.sound)
        print(sound_section(chosen.sound, alarms), end="")
        if chosen.renew:
            before = PAGE.read_text(encoding="utf-8").partition(
                SOUND)[0].rstrip("\n") + "\n\n"
            PAGE.write_text(before + sound_section(chosen.sound, alarms),
                            encoding="utf-8")
        sys.exit("surfaces: a sound surface was named" if alarms else 0)
    every = cases(chosen.sample)
    with ProcessPoolExecutor(chosen.jobs) as pool:
        found = {}
        for case, outcome in zip(every, pool.map(flown, every, chunksize=4)):
            found[case] = outcome
            if len(found) % 60 == 0:
                print(f"surfaces: {len(found)} of {len(every)}",
                      file=sys.stderr)
    alarms = sounded(chosen.jobs, chosen.sound)
    text = page(found, alarms, chosen.sound)
    print(text)
    if chosen.renew:
        PAGE.write_text(renewed(PAGE.read_text("utf-8"), text), "utf-8")
    if alarms or wrongly_named(found):
        sys.exit("surfaces: a sound surface was named")


if __name__ == "__main__":
    main()

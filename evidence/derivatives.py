#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Derivatives from flights beside the truth (GND-64).

    derivatives.py [--airframe NAME] [--flights N] [--first SEED]
                   [--condition NAME ...] [--results FILE [--no-fly]]
                   [--renew]
    derivatives.py --sticks FILE [--seed SEED]

Flies the programme below in JSBSim, in three conditions: exact sensors; the
biases and noise of docs/monte-carlo.md; the same in light turbulence; or in those of
--condition only. Identifies each flight alone, and compares the main derivatives with
the truth, which sim/jsbsim/derivatives.py computes from JSBSim's own model. --airframe
takes an aircraft that comes with JSBSim in place of URV's own.

--results keeps each flight's figures as a line of JSON: flights that the file has are
not flown again, and with --no-fly no others are. --renew writes the table into
docs/flight-test.md. --sticks writes the programme of a seed only.

A programme has four manoeuvres of each axis, flown with the sticks: elevator
3-2-1-1, rudder and aileron doublets, with amplitudes and times drawn from the
seed. The last of each axis is for validation.
"""

import os

# The arrays are small: more threads only wait for each other.
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse  # noqa: E402
import json  # noqa: E402
import random  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
from pathlib import Path  # noqa: E402

import numpy  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "ground"), str(ROOT / "sim" / "jsbsim")]

from airframes import AIRFRAMES  # noqa: E402
from urv import dispersions, flights  # noqa: E402
from urv.identification import aircraft, analysis  # noqa: E402

PAGE = ROOT / "docs" / "flight-test.md"
BEGIN = "<!-- derivatives.py --renew --airframe {} writes this -->"
END = "<!-- to here -->"

OWN = "lambda"

NEUTRAL = 2048
WORDS_PER_PERCENT = 20.48
MANOEUVRES = 4
FIRST_S, REST_S = 6.0, 8.0

MAIN = {
    "CZ_alpha": "lift by alpha", "Cm_alpha": "pitch by alpha",
    "Cm_q": "pitch damping", "Cm_elevator": "pitch by elevator",
    "Cl_p": "roll damping", "Cl_beta": "dihedral",
    "Cl_aileron": "roll by aileron", "Cn_beta": "weathercock",
    "Cn_r": "yaw damping", "Cn_rudder": "yaw by rudder"}

TURBULENCE_KT = 5.0
"""Wind at 20 ft: light is up to 15 kt, of which this is the lower third."""

CONDITIONS = ("exact", "noise and biases", "light turbulence too")


def programme(seed):
    """The rows of a stick script, and the flight's length in s."""
    chance = random.Random(f"flight test {seed}")
    rows = [(0.0, None, 0.0)]
    now = FIRST_S

    def pulses(stick, percent, seconds, lengths):
        nonlocal now
        for number, length in enumerate(lengths):
            rows.append((now, stick, percent * (-1) ** number))
            now += length * seconds
        rows.append((now, None, 0.0))

    for number in range(MANOEUVRES):
        side = (-1) ** number
        pulses("pitch", side * chance.uniform(8, 12),
               chance.uniform(0.35, 0.45), (3, 2, 1, 1))
        now += REST_S
        pulses("yaw", side * chance.uniform(15, 22),
               chance.uniform(0.7, 0.9), (1, 1))
        now += 2.0
        pulses("roll", -side * chance.uniform(18, 25),
               chance.uniform(0.5, 0.7), (1, 1))
        now += REST_S
    return rows, now


def stick_script(seed):
    """The text of the file, and the flight's length in s."""
    rows, seconds = programme(seed)
    lines = ["time_ms,roll,pitch,yaw,throttle"]
    for time, stick, percent in rows:
        words = dict.fromkeys(("roll", "pitch", "yaw"), NEUTRAL)
        if stick:
            words[stick] += round(percent * WORDS_PER_PERCENT)
        lines.append(f"{round(time * 1000)},{words['roll']},{words['pitch']},"
                     f"{words['yaw']},{NEUTRAL}")
    return "\n".join(lines) + "\n", seconds


def conditions(kind, seed, airframe):
    """Errors of sensors as drawn for Monte Carlo flights, no ballast."""
    lines = ["# conditions"]
    if airframe != OWN:
        lines.append(f"airframe {airframe}")
    if kind != "exact":
        drawn = dispersions.draw(seed, "level", 60)
        lines += [line for line in drawn.conditions.splitlines()
                  if line.split()[0] in ("bias", "noise")]
    if kind == "light turbulence too":
        lines.append(f"turbulence {TURBULENCE_KT}")
    return "\n".join(lines) + "\n"


def fly(kind, seed, folder, airframe):
    """The record of a flight."""
    text, seconds = stick_script(seed)
    (folder / "sticks.csv").write_text(text, "utf-8")
    (folder / "conditions.txt").write_text(
        conditions(kind, seed, airframe), "utf-8")
    subprocess.run(
        [ROOT / "bin" / "urv_sim", "fly", "--plant", "jsbsim", "--sticks",
         folder / "sticks.csv", "--conditions", folder / "conditions.txt",
         "--laws", "on" if airframe == OWN else "off",
         "--seconds", f"{seconds:.2f}", "--seed", str(seed), "--quiet",
         "--record", folder / "record.csv"], check=True)
    return flights.read(folder / "record.csv", lambda _record: None)


def true_aircraft(airframe, folder):
    """The aircraft with its true derivatives."""
    if airframe == OWN:
        return aircraft.read()
    path = folder / "aircraft.json"
    subprocess.run(
        [sys.executable, "-B", ROOT / "sim" / "jsbsim" / "derivatives.py",
         "--airframe", airframe, "-o", path], check=True)
    return aircraft.read(path)


class Kept:
    """Figures of flights, each a line of a file."""

    def __init__(self, path, airframe):
        self.path = path
        self.airframe = airframe
        self.found = {}
        if path and path.exists():
            for line in path.read_text("utf-8").splitlines():
                each = json.loads(line)
                if each["airframe"] == airframe:
                    self.found[each["condition"], each["seed"]] = (
                        each["derivatives"])

    def keep(self, kind, seed, found):
        self.found[kind, seed] = found
        if self.path:
            with self.path.open("a", encoding="utf-8") as file:
                file.write(json.dumps(
                    {"airframe": self.airframe, "condition": kind,
                     "seed": seed, "derivatives": found}) + "\n")


def judged(result, truth):
    """For each main derivative: error of the estimate, half of the interval,
    both as shares of the truth, and whether the truth is within."""
    found = {}
    for axis in result.axes.values():
        for name, each in axis.derivatives.items():
            if name in MAIN:
                true = truth[name]
                found[name] = (
                    each.value / true - 1.0,
                    (each.high - each.low) / 2.0 / abs(true),
                    bool(each.low <= true <= each.high))
    return found


def table(results):
    """Markdown: a part for each condition."""
    lines = []
    for kind, found in results.items():
        lines += [
            f"| {kind}, {len(found)} flights | inside | median error |"
            " half width |", "|---|---|---|---|"]
        for name, label in [*MAIN.items(), ("all", "all")]:
            many = [flight[each] for flight in found
                    for each in (MAIN if name == "all" else (name,))]
            errors, widths, inside = zip(*many, strict=True)
            lines.append(
                f"| {label}{'' if name == 'all' else f' `{name}`'} |"
                f" {sum(inside)} of {len(inside)} |"
                f" {100 * numpy.median(numpy.abs(errors)):.1f} % |"
                f" {100 * numpy.median(widths):.1f} % |")
        lines.append("")
    return "\n".join(lines)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--flights", type=int, default=6)
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--airframe", default=OWN,
                           choices=(OWN, *AIRFRAMES))
    arguments.add_argument("--condition", action="append",
                           choices=CONDITIONS)
    arguments.add_argument("--results", type=Path)
    arguments.add_argument("--no-fly", action="store_true")
    arguments.add_argument("--renew", action="store_true")
    arguments.add_argument("--sticks", type=Path)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--verbose", action="store_true")
    given = arguments.parse_args()
    if given.sticks:
        text, seconds = stick_script(given.seed)
        given.sticks.write_text(text, "utf-8")
        print(f"{given.sticks}: {seconds:.1f} s")
        return
    kept = Kept(given.results, given.airframe)
    results = {}
    with tempfile.TemporaryDirectory() as work:
        own = true_aircraft(given.airframe, Path(work))
        for seed in range(given.first, given.first + given.flights):
            for kind in given.condition or CONDITIONS:
                if (kind, seed) not in kept.found:
                    if given.no_fly:
                        continue
                    flight = fly(kind, seed, Path(work), given.airframe)
                    kept.keep(kind, seed, judged(
                        analysis.identify([flight], own), own.prior))
                found = kept.found[kind, seed]
                results.setdefault(kind, []).append(found)
                if given.verbose:
                    print(kind, seed, *(
                        f"{name} {100 * error:+.1f}+-{100 * half:.1f}"
                        f"{'' if inside else '!'}"
                        for name, (error, half, inside) in found.items()),
                        flush=True)
    text = table(results)
    print(text)
    if given.renew:
        begin = BEGIN.format(given.airframe)
        before, _, rest = PAGE.read_text("utf-8").partition(begin)
        _, _, after = rest.partition(END)
        PAGE.write_text(f"{before}{begin}\n{text}\n{END}{after}", "utf-8")


if __name__ == "__main__":
    main()

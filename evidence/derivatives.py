#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Derivatives from flights beside the truth (GND-64).

    derivatives.py [--flights N] [--first SEED] [--renew]
    derivatives.py --sticks FILE [--seed SEED]

Flies the programme below in JSBSim, in three conditions: exact sensors; the
biases and noise of docs/monte-carlo.md; the same in light turbulence. Identifies
each flight alone, and compares the main derivatives with the truth, which
sim/jsbsim/derivatives.py computes from JSBSim's own model. --renew writes the
table into docs/flight-test.md. --sticks writes the programme of a seed only.

A programme has four manoeuvres of each axis, flown with the sticks: elevator
3-2-1-1, rudder and aileron doublets, with amplitudes and times drawn from the
seed. The last of each axis is for validation.
"""

import os

# The arrays are small: more threads only wait for each other.
os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse  # noqa: E402
import random  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
from pathlib import Path  # noqa: E402

import numpy  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "ground"))

from urv import dispersions, flights  # noqa: E402
from urv.identification import aircraft, analysis  # noqa: E402

PAGE = ROOT / "docs" / "flight-test.md"
BEGIN, END = ("<!-- derivatives.py --renew writes this -->",
              "<!-- to here -->")

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


def conditions(kind, seed):
    """Errors of sensors as drawn for Monte Carlo flights, no ballast."""
    if kind == "exact":
        return "# none\n"
    drawn = dispersions.draw(seed, "level", 60)
    lines = [line for line in drawn.conditions.splitlines()
             if line.split()[0] in ("bias", "noise")]
    if kind == "light turbulence too":
        lines.append(f"turbulence {TURBULENCE_KT}")
    return "\n".join(lines) + "\n"


def fly(kind, seed, folder):
    """The record of a flight."""
    text, seconds = stick_script(seed)
    (folder / "sticks.csv").write_text(text, "utf-8")
    (folder / "conditions.txt").write_text(conditions(kind, seed), "utf-8")
    subprocess.run(
        [ROOT / "bin" / "urv_sim", "fly", "--plant", "jsbsim", "--sticks",
         folder / "sticks.csv", "--conditions", folder / "conditions.txt",
         "--seconds", f"{seconds:.2f}", "--seed", str(seed), "--quiet",
         "--record", folder / "record.csv"], check=True)
    return flights.read(folder / "record.csv", lambda _record: None)


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
                    each.low <= true <= each.high)
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
    own = aircraft.read()
    results = {}
    with tempfile.TemporaryDirectory() as work:
        for kind in CONDITIONS:
            results[kind] = []
            for seed in range(given.first, given.first + given.flights):
                flight = fly(kind, seed, Path(work))
                found = judged(analysis.identify([flight], own), own.prior)
                results[kind].append(found)
                if given.verbose:
                    print(kind, seed, *(
                        f"{name} {100 * error:+.1f}+-{100 * half:.1f}"
                        f"{'' if inside else '!'}"
                        for name, (error, half, inside) in found.items()),
                        flush=True)
    text = table(results)
    print(text)
    if given.renew:
        page = PAGE.read_text("utf-8")
        before, _, rest = page.partition(BEGIN)
        _, _, after = rest.partition(END)
        PAGE.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}", "utf-8")


if __name__ == "__main__":
    main()

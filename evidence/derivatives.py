#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Derivatives from flights beside the truth (GND-64).

    derivatives.py [--airframe NAME] [--flights N] [--first SEED]
                   [--condition NAME ...] [--results FILE [--no-fly]]
                   [--renew]
    derivatives.py --inputs [--flights N] [--first SEED] [--results FILE]
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

--inputs compares intervals by a multisine card of all axes with those by doublets of
the sticks: in the same times, with the same largest movement of each surface, biases and
noise, in URV's own aircraft.
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
sys.path[:0] = [str(ROOT / folder)
                for folder in ("ground", "sim/jsbsim", "evidence")]

from airframes import AIRFRAMES  # noqa: E402
from urv import cards, dispersions, flights  # noqa: E402
from urv.identification import (  # noqa: E402
    aircraft,
    analysis,
    manoeuvres,
)
from whole_numbers import whole  # noqa: E402

PAGE = ROOT / "docs" / "flight-test.md"
BEGIN = "<!-- derivatives.py --renew --airframe {} writes this -->"
BEGIN_INPUTS = "<!-- derivatives.py --inputs --renew writes this -->"
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

INPUTS = ("multisine", "doublets")
STARTS_S, LENGTH_S = (8.0, 36.0, 64.0), 20.0
"""Starts and length of the manoeuvres. The last one is for validation."""
CARD = cards.Card(
    slot=1, kind="multisine", surfaces=cards.SURFACES, amplitude=200,
    time=round(LENGTH_S * 100), first=5, last=4 * 16 + 8)
"""2.5 degrees of elevators and rudders, 2 of ailerons; 0.2 to 1.35 Hz."""
DOUBLETS = (("pitch", 0.4, 8.0), ("yaw", 0.8, 2.0), ("roll", 0.6, 8.0))
"""The sticks in turn, the time to each side, and the rest."""
DOUBLET_PERCENT = 200 / WORDS_PER_PERCENT


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
    return script(*programme(seed))


def script(rows, seconds):
    """The text of such rows, and the length as given."""
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


def multisine():
    """The stick script of the cards, and the flight's length in s."""
    rest = f"{NEUTRAL},{NEUTRAL},{NEUTRAL},{NEUTRAL}"
    lines = ["time_ms,roll,pitch,yaw,throttle,switch5", f"0,{rest},0"]
    for start in STARTS_S:
        lines += [f"{round(start * 1000)},{rest},4095",
                  f"{round((start + LENGTH_S + 1.0) * 1000)},{rest},0"]
    return "\n".join(lines) + "\n", STARTS_S[-1] + LENGTH_S + REST_S


def doublets(seed):
    """The same of the doublets. A pilot's times vary by a tenth."""
    chance = random.Random(f"doublets {seed}")
    rows = [(0.0, None, 0.0)]
    for start in STARTS_S:
        now, side = start, 1
        while now < start + LENGTH_S:
            for stick, half, rest in DOUBLETS:
                if now + 2.0 * half > start + LENGTH_S:
                    now = start + LENGTH_S
                    break
                for percent in (side, -side):
                    rows.append((now, stick, percent * DOUBLET_PERCENT))
                    now += half * chance.uniform(0.9, 1.1)
                rows.append((now, None, 0.0))
                now += rest
            side = -side
    return script(rows, STARTS_S[-1] + LENGTH_S + REST_S)


def windows(_flight):
    """Both inputs are judged over the same times."""
    return [manoeuvres.Manoeuvre(
        start - manoeuvres.LEAD_S, start + LENGTH_S + manoeuvres.TAIL_S,
        tuple(manoeuvres.AXES), "given") for start in STARTS_S]


def fly(kind, seed, folder, airframe):
    """The record of a flight."""
    more = ()
    if kind == "multisine":
        text, seconds = multisine()
        (folder / "orders.txt").write_text(
            CARD.order(2_000) + "\n" + cards.Card(
                slot=1, kind="choose").order(2_500) + "\n", "ascii")
        more = "--orders", folder / "orders.txt"
    else:
        text, seconds = (
            doublets(seed) if kind in INPUTS else stick_script(seed))
    (folder / "sticks.csv").write_text(text, "utf-8")
    (folder / "conditions.txt").write_text(
        conditions(kind, seed, airframe), "utf-8")
    subprocess.run(
        [ROOT / "bin" / "urv_sim", "fly", "--plant", "jsbsim", "--sticks",
         folder / "sticks.csv", "--conditions", folder / "conditions.txt",
         "--laws", "on" if airframe == OWN else "off",
         "--seconds", f"{seconds:.2f}", "--seed", str(seed), "--quiet",
         "--record", folder / "record.csv", *more], check=True)
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
    both as shares of the truth, whether the truth is within, and half of the
    interval by noise alone."""
    found = {}
    for axis in result.axes.values():
        for name, each in axis.derivatives.items():
            if name in MAIN:
                true = truth[name]
                found[name] = (
                    each.value / true - 1.0,
                    (each.high - each.low) / 2.0 / abs(true),
                    bool(each.low <= true <= each.high),
                    each.noise_half_width / abs(true))
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
            errors, widths, inside, *_ = zip(*many, strict=True)
            lines.append(
                f"| {label}{'' if name == 'all' else f' `{name}`'} |"
                f" {sum(inside)} of {len(inside)} |"
                f" {100 * numpy.median(numpy.abs(errors)):.1f} % |"
                f" {100 * numpy.median(widths):.1f} % |")
        lines.append("")
    return "\n".join(lines)


def inputs_table(results):
    """Markdown: half of the intervals, and of their parts by noise alone, as
    medians of the flights."""
    lines = [
        "| derivative | multisine | doublets | ratio | noise alone: multisine |"
        " doublets | ratio |", "|---|--:|--:|--:|--:|--:|--:|"]
    ratios = {}
    for name, label in MAIN.items():
        line = f"| {label} `{name}` |"
        for place, digits in ((1, 1), (3, 2)):
            one, other = (100.0 * numpy.median(
                [each[name][place] for each in results[kind]])
                for kind in INPUTS)
            ratios.setdefault(name, []).append(one / other)
            line += (f" {one:.{digits}f} % | {other:.{digits}f} % |"
                     f" {one / other:.2f} |")
        lines.append(line)
    for axis, rows in (("longitudinal", list(MAIN)[:4]),
                       ("lateral", list(MAIN)[4:])):
        whole, noise = numpy.median([ratios[each] for each in rows], axis=0)
        lines.append(f"| median, {axis} | | | {whole:.2f} | | |"
                     f" {noise:.2f} |")
    one, other = ([each[name][2] for each in results[kind] for name in MAIN]
                  for kind in INPUTS)
    lines.append(f"| the truth is inside | {sum(one)} of {len(one)} |"
                 f" {sum(other)} of {len(other)} | | | | |")
    return "\n".join(lines)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--flights", type=whole(1), default=6)
    arguments.add_argument("--first", type=int, default=1)
    arguments.add_argument("--airframe", default=OWN,
                           choices=(OWN, *AIRFRAMES))
    arguments.add_argument("--condition", action="append",
                           choices=CONDITIONS)
    arguments.add_argument("--results", type=Path)
    arguments.add_argument("--no-fly", action="store_true")
    arguments.add_argument("--renew", action="store_true")
    arguments.add_argument("--inputs", action="store_true")
    arguments.add_argument("--sticks", type=Path)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--verbose", action="store_true")
    given = arguments.parse_args()
    if given.sticks:
        text, seconds = stick_script(given.seed)
        # A flight without --seconds ends with its last row, which must not be
        # that of the last movement.
        text += f"{round(seconds * 1000)},{','.join([str(NEUTRAL)] * 4)}\n"
        given.sticks.write_text(text, "utf-8")
        print(f"{given.sticks}: {seconds:.1f} s")
        return
    if given.inputs and (given.airframe != OWN or given.condition):
        arguments.error("--inputs has its own conditions and aircraft")
    kept = Kept(given.results, given.airframe)
    results = {}
    with tempfile.TemporaryDirectory() as work:
        own = true_aircraft(given.airframe, Path(work))
        for seed in range(given.first, given.first + given.flights):
            for kind in INPUTS if given.inputs else (
                    given.condition or CONDITIONS):
                if (kind, seed) not in kept.found:
                    if given.no_fly:
                        continue
                    flight = fly(kind, seed, Path(work), given.airframe)
                    kept.keep(kind, seed, judged(analysis.identify(
                        [flight], own, (windows,) if given.inputs
                        else manoeuvres.FINDERS), own.prior))
                found = kept.found[kind, seed]
                results.setdefault(kind, []).append(found)
                if given.verbose:
                    print(kind, seed, *(
                        f"{name} {100 * error:+.1f}+-{100 * half:.1f}"
                        f"{'' if inside else '!'}"
                        for name, (error, half, inside, *_)
                        in found.items()),
                        flush=True)
    text = (inputs_table if given.inputs else table)(results)
    print(text)
    if given.renew:
        begin = BEGIN_INPUTS if given.inputs else BEGIN.format(given.airframe)
        before, _, rest = PAGE.read_text("utf-8").partition(begin)
        _, _, after = rest.partition(END)
        PAGE.write_text(f"{before}{begin}\n{text}\n{END}{after}", "utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Intervals of derivatives from multisine cards, and from hand-flown doublets of
the same length (GND-64).

    .venv/bin/python -B evidence/inputs.py [--flights N] [--first SEED]
            [--results FILE] [--renew]

Each seed is flown in JSBSim, with the biases and noise of docs/monte-carlo.md: with
a multisine of all axes, LENGTH_S long; with doublets of the sticks in the same
time, with the rests of docs/flight-test.md; and with doublets that follow each other
closely, as only a script flies them. The surfaces' largest inputs are the same. All
are identified over the same times. --renew writes the
table into docs/flight-test.md; --results keeps the figures of each flight.
"""

import os

os.environ["OPENBLAS_NUM_THREADS"] = "1"

import argparse  # noqa: E402
import json  # noqa: E402
import random  # noqa: E402
import subprocess  # noqa: E402
import sys  # noqa: E402
import tempfile  # noqa: E402
from pathlib import Path  # noqa: E402

import derivatives  # noqa: E402
import numpy  # noqa: E402
from derivatives import MAIN, NEUTRAL, PAGE, ROOT  # noqa: E402
from urv import cards, flights  # noqa: E402
from urv.identification import aircraft, analysis, manoeuvres  # noqa: E402

BEGIN = "<!-- inputs.py --renew writes this -->"
END = derivatives.END

WINDOWS = 3
"""The last one is for validation."""
FIRST_S, LENGTH_S, REST_S = 8.0, 20.0, 8.0
CARD = cards.Card(
    slot=1, kind="multisine", surfaces=cards.SURFACES, amplitude=200,
    time=round(LENGTH_S * 100), first=10, last=2 * 16 + 6)
"""2.5 degrees of elevators and rudders, 2 of ailerons; 0.2 to 1.9 Hz."""

WORDS_OF_STICKS = {"pitch": 200, "yaw": 200, "roll": 200}
DOUBLETS = (("pitch", 0.4), ("yaw", 0.8), ("roll", 0.6))
"""The sticks in turn, and the time to each side."""
RESTS_S = {"doublets": (8.0, 2.0, 8.0), "close doublets": (2.5, 2.5, 2.5)}
"""After each of them."""

INPUTS = ("multisine", *RESTS_S)


def starts():
    return [FIRST_S + number * (LENGTH_S + REST_S)
            for number in range(WINDOWS)]


def multisine_rows():
    for start in starts():
        yield start, {"switch5": 4_095}
        yield start + LENGTH_S + 1.0, {}


def doublet_rows(kind, seed):
    """A pilot's: the times vary by a tenth."""
    chance = random.Random(f"doublets {seed}")
    for start in starts():
        now, side, place = start, 1, 0
        while True:
            stick, half = DOUBLETS[place % len(DOUBLETS)]
            if now + 2 * half > start + LENGTH_S:
                break
            for sign in (side, -side):
                yield now, {stick: NEUTRAL + sign * WORDS_OF_STICKS[stick]}
                now += half + chance.uniform(-0.1, 0.1) * half
            yield now, {}
            now += RESTS_S[kind][place % len(DOUBLETS)]
            place += 1
            side = -side if place % len(DOUBLETS) == 0 else side


def stick_script(kind, seed):
    neutral = {"roll": NEUTRAL, "pitch": NEUTRAL, "yaw": NEUTRAL,
               "throttle": NEUTRAL, "switch5": 0}
    rows = multisine_rows() if kind == "multisine" else doublet_rows(
        kind, seed)
    lines = [f"time_ms,{','.join(neutral)}"]
    for time, moved in ((0.0, {}), *rows):
        words = (neutral | moved).values()
        lines.append(f"{round(time * 1000)},{','.join(map(str, words))}")
    return "\n".join(lines) + "\n"


def windows(_flight):
    """Both inputs are judged over the same times."""
    return [manoeuvres.Manoeuvre(
        start - manoeuvres.LEAD_S,
        start + LENGTH_S + manoeuvres.TAIL_S,
        tuple(manoeuvres.AXES), "given") for start in starts()]


def fly(kind, seed, folder):
    (folder / "sticks.csv").write_text(stick_script(kind, seed), "utf-8")
    (folder / "conditions.txt").write_text(derivatives.conditions(
        "noise and biases", seed, derivatives.OWN), "utf-8")
    command = [ROOT / "bin" / "urv_sim", "fly", "--plant", "jsbsim",
               "--laws", "on", "--sticks", folder / "sticks.csv",
               "--conditions", folder / "conditions.txt",
               "--seconds", f"{starts()[-1] + LENGTH_S + REST_S:g}",
               "--seed", str(seed), "--quiet",
               "--record", folder / "record.csv"]
    if kind == "multisine":
        (folder / "orders.txt").write_text(
            CARD.order(2_000) + "\n" + cards.Card(
                slot=1, kind="choose").order(2_500) + "\n", "ascii")
        command += ["--orders", folder / "orders.txt"]
        # The same card again: the next loaded one is itself.
    subprocess.run(command, check=True)
    return flights.read(folder / "record.csv", lambda _record: None)


def table(results):
    """Markdown: medians over the flights."""
    lines = ["| derivative | " + " | ".join(INPUTS) + " | ratio to doublets |"
             " to close doublets |", "|---|--:|--:|--:|--:|--:|"]
    ratios = []
    inside = []
    for name, label in MAIN.items():
        both = [[flight[name] for flight in results[kind]] for kind in INPUTS]
        widths = [numpy.median([each[1] for each in many]) for many in both]
        inside.append([sum(bool(each[2]) for each in many) for many in both])
        ratios.append([widths[0] / each for each in widths[1:]])
        lines.append(
            f"| {label} `{name}` | "
            + " | ".join(f"{100 * width:.1f} %" for width in widths) + " | "
            + " | ".join(f"{ratio:.2f}" for ratio in ratios[-1]) + " |")
    lines.append("| median | | | | " + " | ".join(
        f"{ratio:.2f}" for ratio in numpy.median(ratios, axis=0)) + " |")
    of = len(MAIN) * len(results[INPUTS[0]])
    lines.append("| the truth is inside | " + " | ".join(
        f"{count} of {of}" for count in numpy.sum(inside, axis=0))
        + " | | |")
    return "\n".join(lines)


def main():
    arguments = argparse.ArgumentParser(
        description=__doc__.split("\n\n")[0])
    arguments.add_argument("--flights", type=int, default=4)
    arguments.add_argument("--first", type=int, default=401)
    arguments.add_argument("--results", type=Path)
    arguments.add_argument("--renew", action="store_true")
    given = arguments.parse_args()
    kept = {}
    if given.results and given.results.exists():
        for line in given.results.read_text("utf-8").splitlines():
            each = json.loads(line)
            kept[each["kind"], each["seed"]] = each["derivatives"]
    own = aircraft.read()
    results = {kind: [] for kind in INPUTS}
    for seed in range(given.first, given.first + given.flights):
        for kind in INPUTS:
            if (kind, seed) not in kept:
                with tempfile.TemporaryDirectory() as folder:
                    flight = fly(kind, seed, Path(folder))
                kept[kind, seed] = derivatives.judged(analysis.identify(
                    [flight], own, finders=(windows,)), own.prior)
                if given.results:
                    with given.results.open("a", encoding="utf-8") as file:
                        file.write(json.dumps(
                            {"kind": kind, "seed": seed,
                             "derivatives": kept[kind, seed]}) + "\n")
            results[kind].append(kept[kind, seed])
    text = table(results)
    print(text)
    if given.renew:
        before, _, rest = PAGE.read_text("utf-8").partition(BEGIN)
        _, _, after = rest.partition(END)
        PAGE.write_text(f"{before}{BEGIN}\n{text}\n\n{END}{after}", "utf-8")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the control laws cost: instructions of the aircraft's tasks in a major
frame, in each mode (EVI-16).

    evidence/laws/costs.py            prints them, and fails when one is 3 % more
                                     than docs/evidence/laws-cost.md says
    evidence/laws/costs.py --renew    writes them into that page

Valgrind counts them, in bin/urv_sim with the bench, so they are the same on
any machine and beside any load, with the same compiler. Each flight's record is
looked at: its mode is the one that it stands for.
"""

import csv
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "evidence"))

import instructions  # noqa: E402
from flight_numbers import FRAMES_PER_S  # noqa: E402

PAGE = ROOT / "docs" / "evidence" / "laws-cost.md"

# From the first second to the other the mode does not change. A flap can be
# judged 7 s after a start (D-32).
SHORT_S, LONG_S = 9, 11
MOST_MORE = 0.03

ON = ("--laws", "on")
CUT = "500 cut 60000"
SURFACES = (
    "left_aileron", "right_aileron", "left_elevator", "right_elevator",
    "left_rudder", "right_rudder", "left_flap_1", "right_flap_1",
    "left_flap_2", "right_flap_2")


class Flight(NamedTuple):
    """What is flown, and what its record must have at its end: codes of
    lateral, vertical and power mode and of the link, bits of failed
    surfaces."""

    name: str
    codes: tuple | None
    failed: int = 0
    options: tuple = ON
    sticks: str = ""
    faults: str = ""


def stuck(names):
    """A surface far from where it is wanted, each."""
    return "\n".join(f"500 surface {name} stuck 2300" for name in names)


FLIGHTS = (
    Flight("laws off", None, options=("--laws", "off")),
    Flight("direct", (0, 0, 0, 1)),
    Flight("rate damping", (1, 1, 0, 1), sticks="switch1"),
    Flight("attitude hold", (2, 2, 0, 1), sticks="switch2"),
    Flight("altitude and airspeed hold", (2, 3, 1, 1), sticks="switch3"),
    Flight("wings level, with these", (3, 3, 1, 1), sticks="switch3,switch4"),
    Flight("link lost: holding", (3, 3, 1, 2), faults=CUT,
           options=(*ON, "--orbit-after", "30")),
    Flight("link lost: orbiting", (4, 3, 1, 3), faults=CUT,
           options=(*ON, "--orbit-after", "1")),
    Flight("link lost: terminated", (3, 4, 2, 4), faults=CUT,
           options=(*ON, "--orbit-after", "1", "--terminate-after", "2")),
    Flight("attitude hold, a surface failed", (2, 2, 0, 1), 1,
           sticks="switch2", faults=stuck(SURFACES[:1])),
    Flight("attitude hold, five failed", (2, 2, 0, 1), 0x155,
           sticks="switch2", faults=stuck(SURFACES[::2])),
    Flight("attitude hold, all ten failed", (2, 2, 0, 1), 0x3FF,
           sticks="switch2", faults=stuck(SURFACES)),
)

# What is counted, all that it calls with it: the name of the code.
PARTS = {
    "LAW task": "mcs__law__run_transaction",
    "laws": "urv__laws__next",
    "surface monitor": "urv__surface_monitor__next",
    "allocation": "urv__allocation__servos",
    "PWM task": "mcs__pwm__run_transaction",
    "all tasks": "mcs__run_step",
}
TOTAL = "simulation"
LINE = re.compile(r"^ *([\d,]+) \([^)]*\)  .+?:(\w+) \[")


def counted(flight, seconds):
    """By part, of a whole flight."""
    with tempfile.TemporaryDirectory(prefix="urv-costs-") as folder:
        folder = Path(folder)
        options = [*flight.options]
        if flight.sticks:
            columns = flight.sticks.split(",")
            (folder / "sticks").write_text(
                f"time_ms,{flight.sticks}\n0{',0' * len(columns)}\n"
                f"300{',4095' * len(columns)}\n", encoding="ascii")
            options += ["--sticks", folder / "sticks"]
        if flight.faults:
            (folder / "faults").write_text(flight.faults + "\n",
                                           encoding="ascii")
            options += ["--faults", folder / "faults"]
        subprocess.run(
            ["valgrind", "-q", "--tool=callgrind",
             f"--callgrind-out-file={folder / 'counts'}",
             instructions.SIMULATION, "fly", "--quiet", "--record",
             folder / "record.csv", "--seconds", str(seconds), *options],
            check=True, capture_output=True)
        check_flown(flight, folder / "record.csv")
        text = subprocess.run(
            ["callgrind_annotate", "--auto=no", "--inclusive=yes",
             "--threshold=100", folder / "counts"],
            # From where the sources are it leaves out what is inlined.
            cwd=folder, check=True, capture_output=True, text=True).stdout
    found = {}
    for line in text.splitlines():
        told = LINE.match(line)
        if told and told[2] not in found:
            found[told[2]] = number(told[1])
        if "PROGRAM TOTALS" in line:
            found[TOTAL] = number(line.split()[0])
    return {part: found.get(name, 0)
            for part, name in (PARTS | {TOTAL: TOTAL}).items()}


def number(text):
    return int(text.replace(",", ""))


def check_flown(flight, record):
    """The mode of the last row, and of that of the short flight."""
    if flight.codes is None:
        return
    with record.open(newline="", encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    names = ("lateral", "vertical", "power", "link", "failed")
    for row in (rows[SHORT_S * FRAMES_PER_S - 1], rows[-1]):
        found = tuple(int(row[f"laws.{name}"]) for name in names)
        if found != (*flight.codes, flight.failed):
            raise ValueError(
                f"{flight.name}: {', '.join(names)} are {found}, not"
                f" {(*flight.codes, flight.failed)}")


def per_frame(flight):
    """By part, without those of the start."""
    short, long = (counted(flight, seconds) for seconds in (SHORT_S, LONG_S))
    frames = (LONG_S - SHORT_S) * FRAMES_PER_S
    return {part: round((long[part] - short[part]) / frames)
            for part in long}


def table(found):
    """The page's, with what of the tasks a flight without laws takes."""
    parts = list(next(iter(found.values())))
    usual = found[FLIGHTS[0].name]["all tasks"]
    lines = ["| mode | " + " | ".join(parts) + " | all tasks, of those without"
             " laws |", "|---" * (len(parts) + 2) + "|"]
    for name, costs in found.items():
        lines.append(
            f"| {name} | " + " | ".join(f"{costs[part]:,}" for part in parts)
            + f" | {costs['all tasks'] / usual:.2f} |")
    return "\n".join(lines) + "\n"


def told():
    """The page's compiler and its table, by mode and part."""
    page = PAGE.read_text("utf-8")
    rows = [[cell.strip() for cell in line.strip("|").split("|")]
            for line in page.splitlines() if line.startswith("| ")]
    parts = rows[0][1:-1]
    return (re.search(r"made by `([^`]+)`", page)[1],
            {row[0]: dict(zip(parts, map(number, row[1:-1]), strict=True))
             for row in rows[1:]})


def main(arguments):
    with ThreadPoolExecutor(2) as pool:
        found = dict(zip((flight.name for flight in FLIGHTS),
                         pool.map(per_frame, FLIGHTS), strict=True))
    print(table(found), end="")
    compiler = instructions.compiler()
    if arguments == ["--renew"]:
        page = PAGE.read_text("utf-8")
        page = re.sub(r"made by `[^`]+`", f"made by `{compiler}`", page)
        PAGE.write_text(page[:page.index("| mode |")] + table(found), "utf-8")
    agreed, costs = told()
    if agreed != compiler:
        print(f"costs: the page is of {agreed}, this is {compiler}")
        return 0
    more = [f"{name}, {part}: {count:,}, not {costs[name][part]:,}"
            for name, parts in found.items() for part, count in parts.items()
            if count > costs[name][part] * (1 + MOST_MORE)]
    for line in more:
        print(f"costs: {line}")
    return 1 if more else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

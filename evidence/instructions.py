#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""EVI-14: instructions of a major frame in the simulation, beside those
agreed.

    evidence/instructions.py           fails when a flight takes 3 % more
    evidence/instructions.py --renew   they are agreed from now on

Valgrind counts them, so it is the same number on any machine, beside any
load, with the same compiler: tests/data/instructions.json has both.
"""

import json
import subprocess
import sys
import tempfile
from pathlib import Path

from flight_numbers import FRAMES_PER_S

ROOT = Path(__file__).resolve().parent.parent
AGREED = ROOT / "tests" / "data" / "instructions.json"
SIMULATION = ROOT / "bin" / "urv_sim"

SHORT_S, LONG_S = 2, 6
MOST_MORE = 0.03

# The flights: options of bin/urv_sim.
FLIGHTS = {
    "bench": (),
    "two processors": ("--processors", "2"),
}


def compiler():
    """Which GNAT has made the program, as far as the counts depend on it."""
    text = subprocess.run(
        ["gnatls", "--version"], capture_output=True, text=True, check=True)
    return text.stdout.splitlines()[0]


def counted(options, seconds):
    """The instructions of a whole flight."""
    with tempfile.TemporaryDirectory(prefix="urv-instructions-") as folder:
        counts = Path(folder) / "counts"
        subprocess.run(
            ["valgrind", "-q", "--tool=callgrind",
             f"--callgrind-out-file={counts}", SIMULATION, "fly", "--quiet",
             "--seconds", str(seconds), *options],
            check=True, capture_output=True)
        for line in counts.read_text("utf-8").splitlines():
            if line.startswith("summary:"):
                return int(line.split()[1])
    raise ValueError("callgrind gave no summary")


def per_frame(options):
    """Without those of the start."""
    more = counted(options, LONG_S) - counted(options, SHORT_S)
    return round(more / ((LONG_S - SHORT_S) * FRAMES_PER_S))


def main(arguments):
    found = {name: per_frame(options) for name, options in FLIGHTS.items()}
    if arguments == ["--renew"]:
        AGREED.write_text(json.dumps(
            {"compiler": compiler(), "per_frame": found}, indent=1) + "\n",
            encoding="utf-8")
    agreed = json.loads(AGREED.read_text("utf-8"))
    if agreed["compiler"] != compiler():
        print(f"instructions: agreed for {agreed['compiler']}, this is"
              f" {compiler()}: {found}")
        return 0
    status = 0
    for name, count in found.items():
        ratio = count / agreed["per_frame"][name]
        print(f"instructions: {name}: {count:,} a frame, {ratio:.3f} of what"
              " is agreed")
        if ratio > 1 + MOST_MORE:
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

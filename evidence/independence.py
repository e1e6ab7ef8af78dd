#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compares the tests' results between builds (EVI-6).

    evidence/independence.py [--renew]

Unit tests and the tests that fly, built with and without contracts executed,
without optimisation and with, validity checked wherever it may be. Some flights
must leave the same bytes in every build.

--renew writes the result into docs/evidence/independence.md. All warnings are errors,
so what builds has none. Exit status 1 when a test fails or bytes differ.
"""

import argparse
import hashlib
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import coverage

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "evidence" / "independence.md"

# The switches come after those of urv.gpr, so that these count.
BUILDS = {
    f"{level}{' -gnata' if contracts else ''} -gnatVa":
        [level, "-gnatVa", *(["-gnata"] if contracts else [])]
    for contracts in (False, True) for level in ("-O0", "-O2")
}
PLAIN = "as in urv.gpr"

# Contracts executed make a flight slower than real time: the tests with many
# flights are not flown then.
SHORT_FLIGHTS = ("data_path", "events", "wire")

# Flights that are compared byte by byte.
FAULTS = """\
300 up flip 3 1
500 cut 95.5
1000 down drop 17
1500 mcs reset processor
2500 gsc reset warm
3000 gsc stall adc 200
4000 up dup 1
"""
STICKS = "time_ms,roll,pitch,throttle,switch8\n" + "".join(
    f"{50 * row},{37 * row},{61 * row % 4096},{83 * row % 4096},"
    f"{4095 * (row // 10 % 2)}\n" for row in range(100))
FLIGHTS = (
    ("--seconds", "6"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--phase", "7"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--faults", "faults.txt"),
    ("--seconds", "6", "--sticks", "sticks.csv", "--processors", "2"),
)

TOTALS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$", re.M)
PYTEST = re.compile(r"^(?:(\d+) failed, )?(\d+) passed.* in ", re.M)


def run(*command, **more):
    result = subprocess.run(command, cwd=ROOT, check=False, text=True, **more)
    return result.returncode, result.stdout


def build(project, name, switches):
    """The folder of the programs. With contracts they are built as the tests
    are."""
    place = "independence-" + re.sub(r"\W+", "-", name).strip("-").lower()
    pragmas = ([f"-gnatec={ROOT / 'tests' / 'urv_tests.adc'}"]
               if "-gnata" in switches else [])
    status, _ = run("gprbuild", "-q", "-p", "-j0", "-P", project,
                    "-XURV_Mode=host", f"--subdirs={place}",
                    "-cargs:Ada", *switches, *pragmas)
    if status != 0:
        sys.exit(f"independence: {project} does not build with"
                 f" {' '.join(switches)}")
    return ROOT / "bin" / place


def unit_tests(folder):
    """Passed and failed; one that ends early has failed."""
    status, said = run(folder / "urv_tests_host", stdout=subprocess.PIPE)
    totals = TOTALS.search(said)
    if not totals:
        print(said, f"ended early, status {status}", sep="\n")
        return 0, 1
    if totals[2] != "0":
        print(said)
    return int(totals[1]), int(totals[2])


def flying_tests(folder, names):
    status, said = run(
        sys.executable, "-B", "-m", "pytest", "-q", "--tb=short", "-p",
        "no:cacheprovider", *coverage.SHORT,
        *(f"tests/simulation/test_{name}.py" for name in names),
        stdout=subprocess.PIPE,
        env={**os.environ, "URV_SIM": str(folder / "urv_sim")})
    totals = PYTEST.search(said)
    if status not in (0, 1) or not totals:
        print(said, f"ended early, status {status}", sep="\n")
        return 0, 1
    if status != 0:
        print(said)
    return int(totals[2]), int(totals[1] or 0)


def bytes_of_flights(program):
    """One number of all that the flights leave."""
    found = hashlib.sha256()
    with tempfile.TemporaryDirectory(prefix="urv-independence-") as name:
        folder = Path(name)
        (folder / "faults.txt").write_text(FAULTS, encoding="utf-8")
        (folder / "sticks.csv").write_text(STICKS, encoding="utf-8")
        for options in FLIGHTS:
            outputs = ("record", "wire", "events")
            subprocess.run(
                [program, "fly", *options, "--quiet",
                 *(word for output in outputs
                   for word in (f"--{output}", output))],
                cwd=folder, check=True)
            for output in outputs:
                found.update((folder / output).read_bytes())
    return found.hexdigest()


def try_switches():
    """The table, and whether all is well."""
    rows = []
    plain = build("sim/urv_sim.gpr", PLAIN, [])
    expected = bytes_of_flights(plain / "urv_sim")
    well = True
    for name, switches in BUILDS.items():
        folder = build("tests/urv_tests.gpr", name, switches)
        build("sim/urv_sim.gpr", name, switches)
        flying = flying_tests(
            folder,
            SHORT_FLIGHTS if "-gnata" in switches else coverage.FLIGHTS)
        units = unit_tests(folder)
        same = bytes_of_flights(folder / "urv_sim") == expected
        well = well and units[1] == flying[1] == 0 and same
        rows.append([f"`{name}`", *map(passed, (units, flying)),
                     "the same" if same else "others"])
        print(*rows[-1], sep=", ", flush=True)
    return table(("switches", "unit tests", "tests that fly",
                  f"bytes of {len(FLIGHTS)} flights"), rows), well


def passed(counts):
    good, bad = counts
    return f"{good} passed" + (f", {bad} failed" if bad else "")


# --- the page --------------------------------------------------------------

def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(line)} |\n" for line in lines)


def renewed(page, text):
    """The page with another table."""
    begin, end = "<!-- switches -->\n", "<!-- end -->\n"
    before, found, rest = page.partition(begin)
    _, ended, after = rest.partition(end)
    if not found or not ended:
        sys.exit(f"independence: {DOCUMENT.name} has no place for the table")
    return before + begin + text + end + after


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--renew", action="store_true")
    chosen = options.parse_args()
    text, well = try_switches()
    print(text, end="")
    if chosen.renew:
        page = DOCUMENT.read_text(encoding="utf-8")
        DOCUMENT.write_text(renewed(page, text), encoding="utf-8")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Runs every test and ends with one line: N passed, N failed, N skipped.

    scripts/run_tests.py [PART ...]    those parts whose names begin so

The parts: that every source of src and proofs builds without a warning; unit
tests in Ada, with and without their contracts executed; the tests in Python of
the simulation and of the real-time partitions; the links of the requirements,
the static data of each node, the proof record.
A part that cannot be built or run counts as one failed test, and the other
parts run all the same.
Exit status: 0 when none failed and at least one passed.
"""

import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "obj" / "tests"
GPRBUILD = ["gprbuild", "-q", "-p", "-j0"]
TOTALS = re.compile(r"^(\d+) passed, (\d+) failed, (\d+) skipped$")

BROKEN = (0, 1, 0)


def run(*command):
    """Run a command with its output on ours, return its exit status."""
    sys.stdout.flush()
    return subprocess.run(command, cwd=ROOT, check=False).returncode


def every_source():
    """Theorems too, which no program needs. Warnings are errors."""
    built = run(*GPRBUILD, "-P", "urv.gpr", "-XURV_Mode=flight")
    return (1, 0, 0) if built == 0 else BROKEN


def unit_tests(mode):
    project = ["-P", "tests/urv_tests.gpr", f"-XURV_Mode={mode}"]
    if run(*GPRBUILD, *project) != 0:
        return BROKEN
    totals = None
    command = [f"bin/urv_tests_{mode}"]
    with subprocess.Popen(
        command, cwd=ROOT, stdout=subprocess.PIPE, text=True
    ) as program:
        for line in program.stdout:
            print(line, end="", flush=True)
            totals = TOTALS.match(line)
    # Its last line is its totals, or it did not get to its end.
    if not totals:
        print(f"{command[0]} ended early, status {program.returncode}")
        return BROKEN
    return tuple(map(int, totals.groups()))


def python_tests(project, mode, name):
    project = ["-P", project, f"-XURV_Mode={mode}"]
    if run(*GPRBUILD, *project) != 0:
        return BROKEN
    report = RESULTS / f"{name}.xml"
    report.unlink(missing_ok=True)
    pytest = [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider"]
    pytest += ["-q", "-rs", "--tb=short", f"--junitxml={report}"]
    status = run(*pytest, f"tests/{name}")
    # 0: all passed; 1: some failed. Otherwise pytest itself went wrong, or
    # found no test.
    if status not in (0, 1) or not report.exists():
        return BROKEN
    passed = failed = skipped = 0
    for suite in xml.etree.ElementTree.parse(report).iter("testsuite"):
        names = ("tests", "failures", "errors", "skipped")
        tests, failures, errors, left_out = (int(suite.get(n)) for n in names)
        failed += failures + errors
        skipped += left_out
        passed += tests - failures - errors - left_out
    return passed, failed, skipped


def simulation_tests():
    return python_tests("sim/urv_sim.gpr", "host", "simulation")


def real_time_tests():
    return python_tests("real_time/urv_real_time.gpr", "flight", "real_time")


def one_test(*command):
    return (1, 0, 0) if run(sys.executable, *command) == 0 else BROKEN


def links():
    """Also when the file of tests is gone that would find it gone."""
    return one_test("scripts/trace/run.py", "check")


def node_size():
    return one_test("scripts/node_size.py")


def record_is_current():
    return one_test("scripts/proof_record.py", "sources")


def proof_anew():
    if not shutil.which("gnatprove"):
        print("skipped: gnatprove is not on the PATH")
        return 0, 0, 1
    return one_test("scripts/proof_record.py", "check")


PARTS = {
    "every source builds without a warning": every_source,
    "unit tests, contracts executed": lambda: unit_tests("test"),
    "unit tests, contracts not executed": lambda: unit_tests("host"),
    "simulation": simulation_tests,
    "real time": real_time_tests,
    "links of the requirements": links,
    "static data": node_size,
    "proof record is of these sources": record_is_current,
    "proof anew shows the recorded checks": proof_anew,
}


def totals_line(counts):
    return "{} passed, {} failed, {} skipped".format(*counts)


def chosen(beginnings):
    """The parts whose names begin so; all if nothing is asked for."""
    for each in beginnings:
        if not any(name.startswith(each) for name in PARTS):
            sys.exit(f"no part begins with {each}: {', '.join(PARTS)}")
    return [name for name in PARTS
            if not beginnings or name.startswith(tuple(beginnings))]


def main():
    RESULTS.mkdir(parents=True, exist_ok=True)
    counts = {}
    for name in chosen(sys.argv[1:]):
        print(f"== {name}")
        counts[name] = PARTS[name]()
        print()
    print("== all")
    for name, of_part in counts.items():
        print(f"{name}: {totals_line(of_part)}")
    total = [sum(column) for column in zip(*counts.values())]
    last_line = totals_line(total)
    (RESULTS / "totals").write_text(f"{last_line}\n", encoding="utf-8")
    print(last_line)
    return 0 if total[1] == 0 and total[0] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the lines, subprograms and decisions that the tests reach (EVI-4).

    evidence/coverage.py run [--renew]     builds, runs the tests, then checks
    evidence/coverage.py check [--renew]   checks what was counted last

Unit tests, simulated flights and flights of the real-time partitions run in
builds without optimisation or inlining. They have no run-time checks, so that
each branch the compiler makes is one of the source: decisions are counted
here. The unit tests run once more with contracts executed: what only
contracts use is entered here.

A generic's text is merged over its instances: a line is reached when it is in
any of them, and so is a branch.

Each line that is not reached and each decision that goes one way only is
listed in docs/evidence/coverage.md with its reason; a text that ends in "..."
is that of all lines that begin so. One that is not there fails, and so does
one that is there without need, but for those that the machine's load decides:
their reason begins with "Sometimes". With --renew the table of the result is
written into docs/evidence/coverage.md.
"""

import concurrent.futures
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EXPLAINED = ROOT / "docs" / "evidence" / "coverage.md"
PLACE = ROOT / "coverage"

LEAST_LINES = 98.0

# GNAT 12's; Debian calls it so.
GCOV = shutil.which("gcov-12") or "gcov"

# Atomic, for a partition has several tasks. No reuse of the stack: it would
# make a branch after a call, for an exception.
SWITCHES = ["-O0", "-fno-inline", "-fprofile-arcs", "-ftest-coverage",
            "-fprofile-update=atomic", "-fstack-reuse=none"]

# Programs: their project, mode and switches. Each has its own objects, for
# each project has configuration pragmas of its own.
PROGRAMS = {
    "unit": ("tests/urv_tests.gpr", "host", ["-gnatp"]),
    "flights": ("sim/urv_sim.gpr", "host", ["-gnatp"]),
    "partitions": (
        "real_time/urv_real_time.gpr", "flight",
        # Under the profile itself a call that blocks where it must not
        # raises an exception (D-29).
        ["-gnatp", f"-gnatec={ROOT / 'src/kernel/ravenscar.adc'}"]),
    "contracts": ("tests/urv_tests.gpr", "test", ["-gnatVn"]),
}
COUNT_DECISIONS = ("unit", "flights", "partitions")

# The simulation's tests that fly with bin/urv_sim; the rest of them look at
# other programs, or at the same flights for longer.
# Not the flight of a thousand starts: it lasts long, and does nothing new.
SHORT = ("-k", "not thousand")
FLIGHTS = ("data_path", "events", "faults", "laws", "line_faults", "seal",
           "starts", "surface_faults", "type_codes", "wire")


def run(*command, **more):
    result = subprocess.run(command, cwd=ROOT, check=False, **more)
    if result.returncode != 0:
        sys.exit(f"coverage: failed: {' '.join(map(str, command))}")


# --- counting --------------------------------------------------------------

def folders(program):
    """The folders of objects with text of src: its own, and instances of its
    generics in the tests and the simulation."""
    _, mode, _ = PROGRAMS[program]
    return [ROOT / "obj" / where / f"coverage-{program}"
            for where in (mode, f"{mode}/unit", f"sim-{mode}", "real_time")]


def build_and_run(program):
    project, mode, switches = PROGRAMS[program]
    for folder in folders(program):
        shutil.rmtree(folder, ignore_errors=True)
    run("gprbuild", "-q", "-p", "-j1", "-P", project, f"-XURV_Mode={mode}",
        f"--subdirs=coverage-{program}",
        "-cargs:Ada", *SWITCHES, *switches, "-largs", "-fprofile-arcs")
    built = ROOT / "bin" / f"coverage-{program}"
    if program == "flights":
        run_pytest(built, [*SHORT, *(f"tests/simulation/test_{name}.py"
                                     for name in FLIGHTS)])
    elif program == "partitions":
        run_pytest(built, ["tests/real_time"])
    else:
        # Contracts executed without optimisation take long: on a busy machine
        # a node on its clock would never get to some of its tasks.
        run_unit_tests(built / f"urv_tests_{mode}",
                       "briefly" if program == "contracts" else "fully")


def run_unit_tests(program, choice):
    """For each processor a share of them: what a process counts is added to
    what is there. Told are the tests that fail, and why."""
    shares = len(os.sched_getaffinity(0))

    def run_share(number):
        return subprocess.run(
            [program, str(number), str(shares), choice], cwd=ROOT,
            check=False, text=True, capture_output=True)

    with concurrent.futures.ThreadPoolExecutor(shares) as pool:
        results = list(pool.map(run_share, range(1, shares + 1)))
    if any(result.returncode != 0 for result in results):
        told = [f"coverage: failed: {program}"]
        for result in results:
            told += re.findall(r"^FAIL .*(?:\n  .*)*", result.stdout, re.M)
            told.append(result.stderr.rstrip())
        sys.exit("\n".join(filter(None, told)))


def run_pytest(built, files):
    """With these programs, copied to where they find the aircraft: it is
    beside the folder that they are in."""
    shutil.copytree(built, PLACE, dirs_exist_ok=True)
    programs = {"URV_SIM": str(PLACE / "urv_sim"), "URV_PARTITIONS": str(PLACE)}
    run(sys.executable, "-B", "-m", "pytest", "-q", "-p", "no:cacheprovider",
        *files, env={**os.environ, **programs})


FUNCTION_RECORD = 0x0100_0000


def with_protected(notes):
    """The notes of GCC 12 with no function marked as artificial that has a
    source: GNAT marks the bodies of protected subprograms and of tasks so,
    and gcov would leave them out."""
    changed = bytearray(notes)

    def number(place):
        return int.from_bytes(notes[place:place + 4], "little")

    def after_text(place):
        return place + 4 + number(place)

    if notes[:8] != b"oncg*22B":
        sys.exit("coverage: these are not the notes of GCC 12")
    place = after_text(16) + 4
    while place + 8 <= len(notes) and number(place):
        if number(place) == FUNCTION_RECORD:
            artificial = after_text(place + 20)
            if number(artificial + 4):
                changed[artificial:artificial + 4] = bytes(4)
        place += 8 + number(place + 4)
    return bytes(changed)


def counted(program):
    """The counts of gcov for each source below src in each object."""
    for folder in folders(program):
        for notes in sorted(folder.glob("*.gcno")):
            yield from counted_in(notes)


def counted_in(notes):
    with tempfile.TemporaryDirectory(prefix="urv-coverage-") as name:
        copy = Path(name, notes.name)
        copy.write_bytes(with_protected(notes.read_bytes()))
        data = notes.with_suffix(".gcda")
        if data.exists():
            shutil.copyfile(data, copy.with_suffix(".gcda"))
        result = subprocess.run(
            [GCOV, "--json-format", "--stdout", "--branch-probabilities",
             copy.name],
            cwd=name, capture_output=True, text=True, check=False)
    if "mismatch" in result.stderr:
        sys.exit(f"coverage: {result.stderr}")
    for line in result.stdout.splitlines():
        for file in json.loads(line)["files"]:
            path = Path(file["file"])
            if path.is_relative_to(ROOT / "src"):
                yield path.relative_to(ROOT).as_posix(), file


# Code that the compiler adds: elaboration, finalization, the initialisation of
# types, their predicates and images.
MADE_BY_COMPILER = re.compile(
    r"___elab[bs]$|___finalize|IP(__\d+)?$|(DIC|predicate|invariant)$"
    r"|put_image|(_|^)(read|write|input|output)__\d+$|S[ROIW]$|P\d+b$|Tmp$",
    re.I)


class Source:
    """One file of src, merged over its instances and both builds."""

    def __init__(self):
        self.lines = defaultdict(int)
        self.subprograms = {}
        self.branches = defaultdict(dict)

    def add(self, file, decisions):
        starts = {}
        for function in file["functions"]:
            starts[function["name"]] = function["start_line"]
            if MADE_BY_COMPILER.search(function["name"]):
                continue
            start = function["start_line"]
            name, count = self.subprograms.get(start, (function["name"], 0))
            self.subprograms[start] = (
                min(name, function["name"], key=len),
                count + function["execution_count"])
        for line in file["lines"]:
            number = line["line_number"]
            self.lines[number] += line["count"]
            ways = [branch["count"] for branch in line["branches"]
                    if not branch["throw"]]
            if decisions and len(ways) > 1:
                # Instances with as many branches here have the same ones.
                key = (starts.get(line.get("function_name")), len(ways))
                before = self.branches[number].get(key, [0] * len(ways))
                self.branches[number][key] = [
                    one + other for one, other in zip(before, ways)]


def merged():
    sources = defaultdict(Source)
    for program in PROGRAMS:
        for name, file in counted(program):
            sources[name].add(file, decisions=program in COUNT_DECISIONS)
    return sources


# --- judging ---------------------------------------------------------------

DECIDES = re.compile(
    r"\b(if|elsif|case|when|while|for|and then|or else|exit)\b")


@cache
def text_of(name):
    lines = (ROOT / name).read_text(encoding="utf-8").splitlines()
    return [re.sub(r"--.*", "", line).strip() for line in lines]


def decides(name, number):
    """True if a line has a decision of the source, or an operand of one. A
    call that the compiler branches after is none."""
    text = text_of(name)
    following = text[number] if number < len(text) else ""
    return bool(DECIDES.search(text[number - 1])
                or re.match(r"(and then|or else)\b", following))


def one_sided(name, source):
    """Lines with a decision that was entered and never goes one of its
    ways."""
    for number, of_line in source.branches.items():
        if not decides(name, number):
            continue
        entered = [ways for ways in of_line.values() if any(ways)]
        if entered and not any(all(ways) for ways in entered):
            yield number


def findings(sources):
    """Places not reached: file, kind, line number."""
    found = []
    for name, source in sorted(sources.items()):
        found += [(name, "entry", start)
                  for start, (_, count) in source.subprograms.items()
                  if count == 0]
        found += [(name, "line", number)
                  for number, count in source.lines.items() if count == 0]
        found += [(name, "decision", number)
                  for number in one_sided(name, source)]
    return sorted(found)


ROW = re.compile(r"^\| `([^`]+)` \| (entry|line|decision) \| `([^`]+)` \|"
                 r" (Sometimes)?.+ \|$", re.M)


def explained():
    """The rows of docs/evidence/coverage.md: file, kind, text, and what is not None
    for what is missed sometimes."""
    page = EXPLAINED.read_text(encoding="utf-8")
    return [row.groups() for row in ROW.finditer(page)]


def row_for(rows, name, kind, text):
    """The row that explains a finding, if there is one."""
    for row in rows:
        if row[:2] == (name, kind) and (
                row[2] == text
                or (row[2].endswith("...") and text.startswith(row[2][:-3]))):
            return row
    return None


MISSED = {"entry": "never entered", "line": "never reached",
          "decision": "goes one way only"}


def bodies():
    """Files that have code: bodies with a subprogram in them."""
    return {path.relative_to(ROOT).as_posix()
            for path in (ROOT / "src").rglob("*.adb")
            if re.search(r"^ *(procedure|function|entry|task) ",
                         path.read_text(encoding="utf-8"), re.M)}


def judge(sources):
    """Print what is wrong; return whether anything is."""
    wrong = []
    rows = explained()
    used = set()
    missed = findings(sources)
    for name, kind, number in missed:
        text = text_of(name)[number - 1]
        row = row_for(rows, name, kind, text)
        if row:
            used.add(row)
        else:
            wrong.append(f"{name}:{number}: {MISSED[kind]}: {text}")
    wrong += [f"docs/evidence/coverage.md: covered, or not there: {name}: {text}"
              for name, kind, text, sometimes in rows
              if not sometimes and (name, kind, text, None) not in used]
    wrong += [f"{name}: in no program"
              for name in sorted(bodies() - set(sources))]
    lines = [count for source in sources.values()
             for count in source.lines.values()]
    reached = sum(count > 0 for count in lines)
    percent = 100 * reached / len(lines)
    if percent < LEAST_LINES:
        wrong.append(f"lines: {percent:.2f} %, wanted {LEAST_LINES} %")
    for line in wrong:
        print(line)
    return bool(wrong)


def result(sources):
    """The table: what there is, what the tests reach."""
    missed = Counter(kind for _, kind, _ in findings(sources))
    of_all = {
        "entry": sum(len(source.subprograms) for source in sources.values()),
        "line": sum(len(source.lines) for source in sources.values()),
        "decision": sum(decides(name, number)
                        for name, source in sources.items()
                        for number in source.branches),
    }
    table = "| of src | there are | reached | |\n|---|---|---|---|\n"
    for kind, what in WHAT.items():
        there, reached = of_all[kind], of_all[kind] - missed[kind]
        table += (f"| {what} | {there} | {reached} |"
                  f" {math.floor(1000 * reached / max(there, 1)) / 10} % |\n")
    return table


WHAT = {"entry": "subprograms entered", "line": "lines reached",
        "decision": "lines with a decision, each operand both ways"}


def renew(table):
    page = EXPLAINED.read_text(encoding="utf-8")
    begin, end = "<!-- make -C evidence coverage -->\n", "<!-- end -->\n"
    before, _, rest = page.partition(begin)
    _, _, after = rest.partition(end)
    EXPLAINED.write_text(before + begin + table + end + after,
                         encoding="utf-8")


def main(arguments):
    match arguments:
        case ["run" | "check" as what, *more] if more in ([], ["--renew"]):
            pass
        case _:
            print(__doc__, file=sys.stderr)
            return 2
    if what == "run":
        for program in PROGRAMS:
            build_and_run(program)
    sources = merged()
    if not sources:
        print("coverage: nothing was counted: evidence/coverage.py run counts",
              file=sys.stderr)
        return 1
    wrong = judge(sources)
    table = result(sources)
    print(table, end="")
    if more:
        renew(table)
    return wrong


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

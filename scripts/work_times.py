#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures how long one waits for builds, tests and the proof.

    scripts/work_times.py [--renew] [WORK ...]

WORK is build, test, again, nothing; all of them unless named. Each is done in
a fresh clone of the last commit, on this machine, which should be idle:

    build     every program that flies or tests, from nothing, by project
    test      what `make test` runs, without a proof, by part
    again     `make prove` of a tree that is proved, then with one body changed
    nothing   the proof without the sessions that say which prover found what,
              by unit, and the claims that must not be proved

--renew writes the table in docs/evidence/performance.md; of a work that is not
named its row stays.
"""

import argparse
import json
import os
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import proof_canaries
import proof_record

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs" / "evidence" / "performance.md"
HEAD = "| work | takes | largest parts |\n|---|---|---|\n"

PROJECTS = (
    ("flight software and theorems", "urv.gpr", "flight"),
    ("simulation", "sim/urv_sim.gpr", "host"),
    ("partitions", "real_time/urv_real_time.gpr", "flight"),
    ("unit tests", "tests/urv_tests.gpr", "host"),
    ("unit tests, contracts executed", "tests/urv_tests.gpr", "test"),
)

# A body in the middle of what is proved.
CHANGED = Path("src", "kernel", "waiting", "urvos-semaphores.adb")

PART = re.compile(
    r"^(.+): \d+ passed, (\d+) failed, \d+ skipped, in (.+?)(?:, .*)?$", re.M)


def run(folder, *command, **more):
    """How long it took, and what it said."""
    began = time.monotonic()
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, check=False,
                          **more)
    if done.returncode != 0:
        last = "\n".join(done.stdout.splitlines()[-40:])
        sys.exit(f"{last}\nwork_times: {' '.join(command)} failed")
    return time.monotonic() - began, done.stdout


def words(seconds):
    minutes, seconds = divmod(round(seconds), 60)
    return f"{minutes} min {seconds} s" if minutes else f"{seconds} s"


def largest(parts, number=3):
    """The longest first: name and seconds."""
    first = sorted(parts, key=lambda part: -part[1])[:number]
    return ", ".join(f"{name} {words(seconds)}" for name, seconds in first)


def build(clone):
    parts = [(name, run(clone, "gprbuild", "-q", "-p", "-j0", "-P", project,
                        f"-XURV_Mode={mode}")[0])
             for name, project, mode in PROJECTS]
    total = sum(seconds for _, seconds in parts)
    return [("a clean build", words(total), largest(parts))]


def seconds_of(text):
    """Of `2 min 3 s` or `3 s`."""
    *minutes, seconds = map(int, re.findall(r"\d+", text))
    return 60 * sum(minutes) + seconds


def test(clone):
    """Without GNATprove, wherever it is: the proof is another work."""
    path = os.pathsep.join(
        place for place in os.environ["PATH"].split(os.pathsep)
        if not Path(place, "gnatprove").exists())
    taken, said = run(clone, "make", "test",
                      env={**os.environ, "PATH": path})
    parts = [(name, seconds_of(text)) for name, _, text in PART.findall(said)]
    return [("`make test`, without GNATprove", words(taken), largest(parts))]


def prove(clone):
    return run(clone, sys.executable, "scripts/proof_record.py", "prove")[0]


def again(clone):
    """The record's sessions are there: provers are asked what they proved."""
    whole = prove(clone)
    unchanged = prove(clone)
    changed = clone / CHANGED
    changed.write_text(changed.read_text("utf-8") + "\n", encoding="utf-8")
    after = prove(clone)
    return [("`make prove` with the sessions of the tree", words(whole),
             by_unit(clone)),
            ("`make prove` again", words(unchanged), "what it hangs on is"
             " compared, nothing is analysed"),
            ("`make prove` after a change in one body", words(after),
             "as the first: results are kept for a tree as a whole")]


def by_unit(clone):
    """What analysis and provers took, by unit; two run at once."""
    units = []
    for path in (clone / proof_record.RESULTS).glob("*.spark"):
        found = json.loads(path.read_text(encoding="utf-8"))
        units.append((f"`{path.stem}`", sum(found["timings"].values())))
    return largest(units)


def nothing(clone):
    for path in proof_record.sessions(clone):
        path.unlink()
    taken, _ = run(clone, *proof_record.COMMAND,
                   env=proof_canaries.ENVIRONMENT)
    units = by_unit(clone)
    return [("the proof from nothing", words(taken), units)]


WORKS = {"build": build, "test": test, "again": again, "nothing": nothing}


def renew(rows):
    """Rows of works that were not done stay."""
    text = PAGE.read_text(encoding="utf-8")
    before, _, rest = text.partition(HEAD)
    table, _, after = rest.partition("\n\n")
    known = {line.split(" | ")[0]: line for line in table.splitlines()}
    known.update((line.split(" | ")[0], line) for line in rows)
    PAGE.write_text(before + HEAD + "\n".join(known.values()) + "\n\n" + after,
                    encoding="utf-8")


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--renew", action="store_true")
    options.add_argument("works", nargs="*", metavar="WORK",
                         choices=[*WORKS, []])
    chosen = options.parse_args()

    rows = []
    for name in chosen.works or WORKS:
        with tempfile.TemporaryDirectory(prefix="urv-times-") as folder:
            clone = Path(folder, "urv")
            run(ROOT, "git", "clone", "-q", str(ROOT), str(clone))
            (clone / ".venv").symlink_to(ROOT / ".venv")
            for row in WORKS[name](clone):
                rows.append(f"| {' | '.join(row)} |")
                print(rows[-1], flush=True)
    if chosen.renew:
        renew(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())

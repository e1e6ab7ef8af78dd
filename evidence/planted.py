#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plant the defects that the safety monitor must find (EVI-10).

    evidence/planted.py [NAME ...]    those patches whose names begin so

Each evidence/planted/*.patch is one defect: a few lines that describe it, then a
line for each test that must notice it

    # notices: tests/simulation/test_faults.py::test_lnk9_a_cut_link_recovers
    # notices: MBX-2 an unconsumed message is overwritten and counted once

and then the change, as git writes it. In a copy of the tree these tests first
pass. Then one patch after another is applied, what it changes is built, and
each test that it names must fail.
Exit status: 0 when all are noticed; 1 otherwise, a line for each reason.
"""

import ast
import os
import re
import subprocess
import sys
import time
from pathlib import Path
from typing import NamedTuple

sys.path.append(str(Path(__file__).resolve().parents[1] / "scripts"))

from tree_copy import (  # noqa: E402
    CHANGED, git_apply, renew_copy)

ROOT = Path(__file__).resolve().parent.parent
PATCHES = Path("evidence", "planted")
COPY = Path("obj", "planted")
NOTICES = re.compile(r"^# notices: +(.*\S)\s*$", re.M)

# What is built for the tests of a folder; a unit test has no folder.
UNIT = "tests/unit"
PROJECTS = {
    "tests/simulation": [("sim/urv_sim.gpr", "host")],
    "tests/real_time": [("real_time/urv_real_time.gpr", "flight"),
                        ("sim/urv_sim.gpr", "host")],
    UNIT: [("tests/urv_tests.gpr", "test")],
}
BUILT = (".ads", ".adb", ".gpr", ".adc", ".c")

# A test that hangs has noticed: none of those named takes so long.
TIME_LIMIT_S = 900


class Planted(NamedTuple):
    """A mistake: its patch, the tests that must fail, the files changed."""

    name: str
    path: Path
    notices: tuple
    changed: tuple


def patches(root):
    found = []
    for path in sorted((root / PATCHES).glob("*.patch")):
        text = path.read_text(encoding="utf-8")
        found.append(Planted(path.stem, path, tuple(NOTICES.findall(text)),
                             tuple(CHANGED.findall(text))))
    return found


def is_unit_test(name):
    return "::" not in name


def folder_of(name):
    return UNIT if is_unit_test(name) else Path(name).parent.as_posix()


def test_exists(root, name):
    if is_unit_test(name):
        # Its name may go on in the next line.
        return any(
            f'"{name}"' in re.sub(r'"\s*&\s*"', "", path.read_text("utf-8"))
            for path in (root / UNIT).glob("*.adb"))
    file, _, function = name.partition("::")
    path = root / file
    if not path.exists():
        return False
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return function.split("[")[0] in {
        each.name for each in tree.body if isinstance(each, ast.FunctionDef)}


def faults_of(root, planted):
    """What makes the patch one that cannot be tried, a line each."""
    said = git_apply(root, planted.path, "--check")
    if said:
        yield f"{planted.name}: no longer applies: {said.splitlines()[0]}"
    if not planted.notices:
        yield f"{planted.name}: names no test that notices it"
    for name in planted.notices:
        if not test_exists(root, name):
            yield f"{planted.name}: there is no test {name}"


def build(copy, folders):
    """What the builder says when something does not build."""
    for project, mode in dict.fromkeys(
            each for folder in sorted(folders) for each in PROJECTS[folder]):
        done = subprocess.run(
            ["gprbuild", "-q", "-p", "-j0", "-P", project,
             f"-XURV_Mode={mode}"],
            cwd=copy, capture_output=True, text=True, check=False)
        if done.returncode:
            return f"{project} does not build: {done.stderr.strip()[-400:]}"
    return ""


# What came of a test.
PASSED, FAILED = "passed", "failed"


def run_unit_tests(copy):
    """What came of each unit test, by name."""
    try:
        done = subprocess.run(
            ["bin/urv_tests_test"], cwd=copy, capture_output=True, text=True,
            timeout=TIME_LIMIT_S, check=False)
    except subprocess.TimeoutExpired as late:
        return results_of((late.stdout or b"").decode())
    return results_of(done.stdout)


def results_of(said):
    return {line[5:].strip(): PASSED if line.startswith("ok ") else FAILED
            for line in said.splitlines() if line.startswith(("ok ", "FAIL"))}


def run_pytest(copy, name):
    """What came of a test of pytest, any of its cases."""
    settings = {name: value for name, value in os.environ.items()
                if name not in ("URV_SIM", "URV_PARTITIONS")}
    try:
        done = subprocess.run(
            [sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider",
             "-q", "-x", "--tb=no", name],
            cwd=copy, env=settings, capture_output=True, text=True,
            timeout=TIME_LIMIT_S, check=False)
    except subprocess.TimeoutExpired:
        return FAILED
    # A skipped test says nothing, nor does one that cannot be read.
    if done.returncode == 0:
        return PASSED if re.search(r"\d+ passed", done.stdout) else "skipped"
    last = (done.stdout.strip().splitlines() or ["it said nothing"])[-1]
    return FAILED if done.returncode == 1 else f"did not run: {last}"


def run_tests(copy, names):
    units = run_unit_tests(copy) if any(map(is_unit_test, names)) else {}
    return {name: units.get(name, "did not run") if is_unit_test(name)
            else run_pytest(copy, name) for name in names}


def try_patch(copy, planted):
    """Why the mistake is not noticed by all that should; empty if it is."""
    # Its change is undone as it was made, whatever happens meanwhile.
    said = git_apply(copy, planted.path)
    if said:
        return f"no longer applies: {said}"
    try:
        if any(name.endswith(BUILT) for name in planted.changed):
            said = build(copy, set(map(folder_of, planted.notices)))
            if said:
                return said
        came = run_tests(copy, planted.notices)
    finally:
        undone = git_apply(copy, planted.path, "--reverse")
        if undone:
            sys.exit(f"planted: {planted.name} is not undone: {undone}")
    return "; ".join(f"{name} {what}" for name, what in came.items()
                     if what != FAILED)


def chosen(found, beginnings):
    for each in beginnings:
        if not any(planted.name.startswith(each) for planted in found):
            sys.exit(f"planted: no patch begins with {each}: "
                     + ", ".join(planted.name for planted in found))
    return [planted for planted in found if not beginnings
            or planted.name.startswith(tuple(beginnings))]


def judge(root, copy, found):
    """Tries them; how many were not noticed or could not be tried."""
    failures = [line for planted in found
                for line in faults_of(root, planted)]
    for line in failures:
        print(f"planted: {line}")
    if failures:
        return len(failures)

    renew_copy(root, copy)
    names = dict.fromkeys(name for planted in found
                          for name in planted.notices)
    print(f"planted: {len(names)} tests, first without any mistake",
          flush=True)
    said = build(copy, set(map(folder_of, names)))
    if said:
        print(f"planted: {said}")
        return 1
    wrong = {name: what for name, what in run_tests(copy, names).items()
             if what != PASSED}
    for name, what in wrong.items():
        print(f"planted: without any mistake: {name} {what}")
    if wrong:
        return len(wrong)

    missed = 0
    for planted in found:
        began = time.monotonic()
        why = try_patch(copy, planted)
        missed += bool(why)
        print(f"{'MISSED ' if why else 'noticed'} {planted.name}, "
              f"{time.monotonic() - began:.0f} s"
              + (f": {why}" if why else ""), flush=True)
    return missed


def main():
    found = chosen(patches(ROOT), sys.argv[1:])
    failures = judge(ROOT, ROOT / COPY, found)
    print(f"planted: {len(found)} mistakes, {failures} failures")
    return 1 if failures or not found else 0


if __name__ == "__main__":
    sys.exit(main())

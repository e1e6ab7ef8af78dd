#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plant the defects that the safety monitor must find (EVI-10).

    evidence/planted.py [NAME ...]    those patches whose names begin so

Each evidence/planted/*.patch is one defect: a few lines that describe it, a
line for each test that must notice it, then the change:

    # notices: tests/simulation/test_faults.py::test_lnk9_a_cut_link_recovers
    # notices: MBX-2 an unconsumed message is overwritten and counted once

Each defect is planted in a copy of the tree, which is built. Each test that it
names must fail there. `make test` shows that they pass without it.
Exit status: 0 when all are noticed; 1 otherwise, with a line for each reason.
"""

import ast
import re
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

sys.path.append(str(Path(__file__).resolve().parents[1] / "scripts"))

from tree_copy import git_apply, renew_copy  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
NOTICES = re.compile(r"^# notices: +(.*\S)\s*$", re.M)
PROJECTS = (("sim/urv_sim.gpr", "host"), ("tests/urv_tests.gpr", "test"),
            ("real_time/urv_real_time.gpr", "flight"))

# A test that hangs has noticed the defect.
TIME_LIMIT_S = 900


class Planted(NamedTuple):
    """A defect: its patch and the tests that must fail."""

    name: str
    path: Path
    notices: tuple


def patches(root):
    return [Planted(path.stem, path,
                    tuple(NOTICES.findall(path.read_text(encoding="utf-8"))))
            for path in sorted((root / "evidence/planted").glob("*.patch"))]


def is_unit_test(name):
    return "::" not in name


def test_exists(root, name):
    if is_unit_test(name):
        # A long name continues on the next line.
        return any(
            f'"{name}"' in re.sub(r'"\s*&\s*"', "", path.read_text("utf-8"))
            for path in (root / "tests/unit").glob("*.adb"))
    file, _, function = name.partition("::")
    if not (root / file).exists():
        return False
    tree = ast.parse((root / file).read_text(encoding="utf-8"))
    return function.split("[")[0] in {
        each.name for each in tree.body if isinstance(each, ast.FunctionDef)}


def faults_of(root, planted):
    """The reasons for which a patch cannot be planted."""
    said = git_apply(root, planted.path, "--check")
    if said:
        yield f"{planted.name}: no longer applies: {said.splitlines()[0]}"
    if not planted.notices:
        yield f"{planted.name}: names no test that notices it"
    for name in planted.notices:
        if not test_exists(root, name):
            yield f"{planted.name}: there is no test {name}"


def fails(copy, name):
    """True if a test fails in the copy."""
    command = ["bin/urv_tests_test"] if is_unit_test(name) else [
        sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", "-q",
        "-x", "--tb=no", name]
    try:
        done = subprocess.run(
            command, cwd=copy, capture_output=True, text=True,
            timeout=TIME_LIMIT_S, check=False)
    except subprocess.TimeoutExpired:
        return True
    # The status of pytest is 1 only when a test has failed.
    return (f"FAIL {name}" in done.stdout if is_unit_test(name)
            else done.returncode == 1)


def missed(copy, planted):
    """The reasons for which a defect is not noticed."""
    said = git_apply(copy, planted.path)
    if said:
        return [said]
    try:
        for project, mode in PROJECTS:
            done = subprocess.run(
                ["gprbuild", "-q", "-p", "-j0", "-P", project,
                 f"-XURV_Mode={mode}"],
                cwd=copy, capture_output=True, text=True, check=False)
            if done.returncode:
                return [f"{project} does not build: {done.stderr[-400:]}"]
        return [f"{name} does not fail" for name in planted.notices
                if not fails(copy, name)]
    finally:
        git_apply(copy, planted.path, "--reverse")


def main():
    found = [planted for planted in patches(ROOT)
             if planted.name.startswith(tuple(sys.argv[1:]) or "")]
    if not found:
        print(f"planted: no defect begins with {' or '.join(sys.argv[1:])}")
        return 1
    failures = [fault for planted in found
                for fault in faults_of(ROOT, planted)]
    if not failures:
        copy = ROOT / "obj" / "planted"
        renew_copy(ROOT, copy)
        for planted in found:
            why = missed(copy, planted)
            print(f"{'MISSED ' if why else 'noticed'} {planted.name}",
                  flush=True)
            failures += [f"{planted.name}: {reason}" for reason in why]
    for line in failures:
        print(f"planted: {line}")
    print(f"planted: {len(found)} defects, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

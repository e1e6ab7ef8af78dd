# SPDX-License-Identifier: Apache-2.0
"""EVI-13: each source says its licence where tools look for it."""

from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
LICENCE = "SPDX-License-Identifier: Apache-2.0"
FOLDERS = ("evidence", "examples", "ground", "host", "proofs",
           "real_time", "scripts", "sim", "src", "targets", "tests")

# By the ending of the name, or the name.
LINES = {
    **dict.fromkeys((".ads", ".adb", ".gpr", ".adc"), f"--  {LICENCE}"),
    **dict.fromkeys((".py", ".sh", "Makefile", "run"), f"# {LICENCE}"),
    ".c": f"/* {LICENCE} */",
}


def line_for(path):
    return LINES.get(path.suffix or path.name)


def sources(root):
    """Every source, but what was built."""
    paths = [*root.glob("*"), *(root / ".ci").glob("*"),
             *(path for folder in FOLDERS
               for path in (root / folder).rglob("*"))]
    return [path for path in paths if path.is_file() and line_for(path)]


def says_it(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    first = 1 if lines and lines[0].startswith("#!") else 0
    return lines[first:first + 1] == [line_for(path)]


def test_each_source_says_its_licence():
    found = sources(ROOT)
    assert {line_for(path) for path in found} == set(LINES.values())
    assert [path.relative_to(ROOT).as_posix() for path in found
            if not says_it(path)] == []


@pytest.mark.parametrize("name, text, says", [
    ("a.ads", f"--  {LICENCE}\n\npackage A is", True),
    ("a.ads", f"--  A package.\n--  {LICENCE}\n", False),
    ("a.py", f"#!/usr/bin/env python3\n# {LICENCE}\n", True),
    ("a.py", f"--  {LICENCE}\n", False), ("a.sh", "#!/bin/sh\n", False),
    ("a.c", "", False)])
def test_a_source_without_it_is_found(tmp_path, name, text, says):
    path = tmp_path / name
    path.write_text(text, encoding="utf-8")
    assert says_it(path) is says

# SPDX-License-Identifier: Apache-2.0
"""EVI-15: a source is no longer than one reads."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

from ada_source import sources  # noqa: E402

MOST = {".ads": 350, ".adb": 450}

# Longer ones of src, with how long each may be, and why.
LONGER = {
    "urv-test_runs.ads": (460, "the contract of Next has a card's whole life"),
    "urv-law_steps.ads": (440, "the decision's four parts, each with its"
                               " contract"),
}


def too_long(root, longer):
    """Sources above their limit, and exceptions without need."""
    for path in sources(root, "src"):
        lines = len(path.read_text(encoding="utf-8").splitlines())
        limit = longer.get(path.name, (MOST[path.suffix],))[0]
        if lines > limit:
            yield f"{path.name}: {lines} lines, {limit} at most"
        elif path.name in longer and lines <= MOST[path.suffix]:
            yield f"{path.name}: {lines} lines need no exception"


def test_no_specification_has_over_350_lines_and_no_body_over_450():
    assert list(too_long(ROOT, LONGER)) == []
    names = {path.name for path in sources(ROOT, "src")}
    assert set(LONGER) <= names


@pytest.mark.parametrize("name, lines, longer, found", [
    ("a.ads", 350, {}, []), ("a.adb", 450, {}, []),
    ("a.ads", 351, {}, ["a.ads: 351 lines, 350 at most"]),
    ("a.adb", 451, {}, ["a.adb: 451 lines, 450 at most"]),
    ("a.ads", 360, {"a.ads": (360, "so")}, []),
    ("a.ads", 361, {"a.ads": (360, "so")},
     ["a.ads: 361 lines, 360 at most"]),
    ("a.ads", 350, {"a.ads": (360, "so")},
     ["a.ads: 350 lines need no exception"])])
def test_a_longer_source_is_found(tmp_path, name, lines, longer, found):
    folder = tmp_path / "src" / "kernel"
    folder.mkdir(parents=True)
    (folder / name).write_text("--  A line.\n" * lines, encoding="utf-8")
    assert list(too_long(tmp_path, longer)) == found

# SPDX-License-Identifier: Apache-2.0
"""EVI-1: requirements, code, theorems and tests are linked to each other, and
a link that is missing or leads nowhere is found."""

import re
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT

TRACE = ROOT / "scripts" / "trace"
sys.path.insert(0, str(TRACE))

import gaps  # noqa: E402
import requirements_file  # noqa: E402

REQUIREMENTS = requirements_file.FILE

UNTESTED = """[REQUIREMENT]
UID: SIM-99
TITLE: Nothing
STATEMENT: Nothing.
CODE: Sim.Engine

"""

# What is changed in which file, and what must be found then.
PLANTED = {
    "a requirement without a test": (
        REQUIREMENTS, "[REQUIREMENT]\nUID: SIM-1\n",
        UNTESTED + "[REQUIREMENT]\nUID: SIM-1\n",
        "SIM-99: no test names it"),
    "a requirement without code": (
        REQUIREMENTS, "CODE: URV.TELIN_Task\n", "",
        "TIN-1: names no CODE"),
    "an identifier twice": (
        REQUIREMENTS, "UID: SIM-2\n", "UID: SIM-1\n", "SIM-1: stands twice"),
    "what is open without a reason": (
        REQUIREMENTS, "[REQUIREMENT]\nUID: SIM-1\n",
        UNTESTED.replace("TITLE:", "STATUS: Open\nTITLE:")
        + "[REQUIREMENT]\nUID: SIM-1\n",
        "SIM-99: Open without a WHY"),
    "a line that is no field": (
        REQUIREMENTS, "UID: SIM-2\n", "UID: SIM-2\nNonsense\n",
        f"{REQUIREMENTS}: cannot be read: Nonsense"),
    "a link to no unit": (
        REQUIREMENTS, "CODE: URV.TELIN_Task\n", "CODE: URV.TELLIN_Task\n",
        "TIN-1: CODE names URV.TELLIN_Task, which does not exist"),
    "a link to no declaration": (
        REQUIREMENTS, "URV.Routing.To_Downlink", "URV.Routing.To_Nowhere",
        "CODE names URV.Routing.To_Nowhere, which does not exist"),
    "a link to no theorem": (
        REQUIREMENTS, "Theorems.Silence.Live_On", "Theorems.Silence.Live",
        "LNK-9: THEOREMS names Theorems.Silence.Live, which does not exist"),
    "a link to no file": (
        REQUIREMENTS, "CODE: scripts/trace/gaps.py", "CODE: scripts/gaps.py",
        "EVI-1: CODE names scripts/gaps.py, which does not exist"),
    "a theorem for nothing": (
        REQUIREMENTS, "Theorems.Silence.Live_On", "",
        "no requirement's THEOREMS names Theorems.Silence.Live_On"),
    "code for nothing": (
        REQUIREMENTS, "CODE: URV.AD_Scans, URV.ADINT_Handler,",
        "CODE: URV.AD_Scans,",
        "src/tasks/urv-adint_handler.ads: no requirement's CODE names it"),
    "code that names its requirement no more": (
        "src/tasks/urv-telin_task.ads", "TIN-1", "TIN",
        "TIN-1: CODE names URV.TELIN_Task, but no comment of URV.TELIN_Task"
        " names TIN-1"),
    "code that names no requirement": (
        "src/tasks/urv-telin_task.ads", "TIN-1", "TIN-77",
        "src/tasks/urv-telin_task.ads: names TIN-77, which is no requirement"),
    "a test in Ada of nothing": (
        "tests/unit/headers_tests.adb", '"D-6 ', '"',
        "names no requirement"),
    "a test in Ada of no requirement": (
        "tests/unit/headers_tests.adb", '"D-6 ', '"D-666 ',
        "names D-666, which is none"),
    "a test whose name is not in the text": (
        "tests/unit/headers_tests.adb", '(Suite, "', '(Suite, Prefix & "',
        "names no requirement"),
    "tests in Ada that are not run": (
        "tests/unit/all_tests.adb", "Headers_Tests.Add_To (Result);", "",
        "tests/unit/headers_tests.adb: all_tests.adb does not run it"),
    "a test in Python of nothing": (
        "tests/simulation/test_wire.py", "(LNK-1, LNK-2, LNK-3)", "",
        '"test_lnk_nothing_is_sent_twice_scrapped_or_reset" names no'),
    "a test in Python of no requirement": (
        "tests/simulation/test_wire.py", "def test_d5_", "def test_d555_",
        "names D-555, which is none"),
}


@pytest.fixture(scope="module")
def copied(tmp_path_factory):
    """A copy of what is looked at."""
    folder = tmp_path_factory.mktemp("trace")
    for name in ("src", "proofs", "host", "sim", "real_time", "ground",
                 "tests", "docs", "scripts", "evidence"):
        if (ROOT / name).exists():
            shutil.copytree(
                ROOT / name, folder / name,
                ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def test_nothing_is_missing():
    assert gaps.all_gaps(ROOT) == []


@pytest.mark.parametrize("what", PLANTED)
def test_a_planted_gap_is_found(copied, what):
    name, text, instead, expected = PLANTED[what]
    file = copied / name
    original = file.read_text(encoding="utf-8")
    assert text in original
    try:
        file.write_text(original.replace(text, instead), encoding="utf-8")
        found = gaps.all_gaps(copied)
    finally:
        file.write_text(original, encoding="utf-8")
    assert any(expected in gap for gap in found), found


def test_each_file_of_tests_is_missed():
    repository = gaps.Repository(ROOT)
    every = repository.tests
    assert len(every) > 30
    for name in every:
        repository.tests = {other: tests for other, tests in every.items()
                            if other != name}
        assert any(f"TESTS names {name}, which does not exist" in gap
                   for gap in gaps.requirement_gaps(repository)), name


def test_what_tests_a_requirement_and_what_it_names_are_the_same():
    """Each difference is told once, as what it is."""
    repository = gaps.Repository(ROOT)
    item = next(item for item in repository.requirements if item.uid == "LNK-9")
    other = next(name for name in repository.tests if name not in item.tests)
    item.tests.append(other)
    assert list(gaps.requirement_gaps(repository)) == [
        f"LNK-9: TESTS names {other}, which has no test of it"]
    item.tests.remove(other)
    own = item.tests.pop()
    assert list(gaps.requirement_gaps(repository)) == [
        f"LNK-9: TESTS does not name {own}, which tests it"]


def test_each_file_that_is_no_test_is_needed_by_one():
    """Without it something does not build, or does not run."""
    unit = list((ROOT / "tests" / "unit").glob("*.ad[sb]"))
    texts = [path.read_text(encoding="utf-8").lower() for path in unit]
    for path in unit:
        if path.stem != "urv_tests" and not path.stem.endswith("_tests"):
            assert any(re.search(rf"^with {path.stem}\b", text, re.M)
                       for text in texts), path
    python = [path for folder in ("simulation", "real_time", "ground")
              for path in (ROOT / "tests" / folder).glob("*.py")]
    texts = [path.read_text(encoding="utf-8") for path in python]
    for path in python:
        if not path.stem.startswith("test_"):
            assert any(f"from {path.stem} import" in text
                       or f"import {path.stem}\n" in text
                       for text in texts), path
    for path in (ROOT / "tests" / "data").iterdir():
        assert any(path.name in text for text in texts), path


def test_strictdoc_shows_the_links_both_ways(tmp_path):
    html = tmp_path / "html"
    result = subprocess.run(
        [sys.executable, TRACE / "run.py", "export", html,
         "TIN-1", "ADI-1", "LNK-9", "LNK-2"],
        capture_output=True, text=True, check=False)
    assert f"{html}/index.html shows" in result.stdout, result.stdout
    requirements = next(html.glob("*/requirements.html")).read_text("utf-8")
    for link in ("src/tasks/urv-telin_task.ads", "tests/unit/ad_tests.adb",
                 "proofs/theorems-silence.ads", "tests/simulation/test_wire.py"):
        page = html / "_source_files" / f"{link}.html"
        assert link in requirements
        assert "requirements.html" in page.read_text("utf-8")

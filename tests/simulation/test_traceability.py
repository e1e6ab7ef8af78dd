# SPDX-License-Identifier: Apache-2.0
"""EVI-1: requirements, code, theorems and tests are linked to each other, and
a link that is missing or leads nowhere is found."""

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

# A change of a file, and the gap that it makes.
PLANTED = {
    "a requirement without a test": (
        REQUIREMENTS, "[REQUIREMENT]\nUID: SIM-1\n",
        UNTESTED + "[REQUIREMENT]\nUID: SIM-1\n",
        "SIM-99: no test names it"),
    "a link to no declaration": (
        REQUIREMENTS, "URV.Routing.To_Downlink", "URV.Routing.To_Nowhere",
        "CODE names URV.Routing.To_Nowhere, which does not exist"),
    "a link to no theorem": (
        REQUIREMENTS, "Theorems.Silence.Comes_To_Rest", "Theorems.Silence.Rest",
        "LNK-9: THEOREMS names Theorems.Silence.Rest, which does not exist"),
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
    "code that names no requirement": (
        "src/tasks/urv-telin_task.ads", "TIN-1", "TIN-77",
        "src/tasks/urv-telin_task.ads: names TIN-77, which is no requirement"),
    "a test in Ada of nothing": (
        "tests/unit/link_suite-headers_tests.adb", '"D-6 ', '"',
        "names no requirement"),
    "tests in Ada that are not run": (
        "tests/unit/all_tests.adb", "Headers_Tests.Add_To (Result);", "",
        "tests/unit/link_suite-headers_tests.adb: all_tests.adb does not run it"),
    "a test in Python of no requirement": (
        "tests/simulation/test_wire.py", "def test_d5_", "def test_d555_",
        "names D-555, which is none"),
}


@pytest.fixture(scope="module")
def planted_gaps(tmp_path_factory):
    """The gaps of a copy of what is looked at, with all changes at once."""
    folder = tmp_path_factory.mktemp("trace")
    for name in ("src", "proofs", "host", "sim", "real_time", "ground",
                 "targets", "tests", "docs", "scripts", "evidence"):
        if (ROOT / name).exists():
            shutil.copytree(
                ROOT / name, folder / name,
                ignore=shutil.ignore_patterns("__pycache__"))
    for name, text, instead, _ in PLANTED.values():
        file = folder / name
        original = file.read_text(encoding="utf-8")
        assert text in original
        file.write_text(original.replace(text, instead), encoding="utf-8")
    return gaps.all_gaps(folder)


def test_nothing_is_missing():
    assert gaps.all_gaps(ROOT) == []


@pytest.mark.parametrize("what", PLANTED)
def test_a_planted_gap_is_found(planted_gaps, what):
    expected = PLANTED[what][-1]
    assert any(expected in gap for gap in planted_gaps), planted_gaps


def links_in(text):
    """The links of each requirement, as the file has them."""
    return {item.uid: {"CODE": item.code, "THEOREMS": item.theorems,
                       "TESTS": item.tests}
            for item in requirements_file.parsed(text)}


def test_evi1_new_links_change_no_others():
    """A renewal broke telemetry-shared_boards.adb into two lines, and wrapped
    each list of the file again."""
    text = (ROOT / requirements_file.FILE).read_text("utf-8")
    links = links_in(text)
    assert requirements_file.with_links(text, links.get) == text

    longest = max(links, key=lambda uid: max(map(
        len, links[uid]["CODE"]), default=0))
    links[longest]["CODE"].append("targets/mc68000/a-name-with-hyphens.adb")
    renewed = requirements_file.with_links(text, links.get)
    assert links_in(renewed) == links
    assert max(map(len, renewed.splitlines())) <= max(
        map(len, text.splitlines()))


@pytest.mark.parametrize("before", range(0, 60, 4))
def test_evi1_a_name_stays_on_one_line(before):
    links = ["a" * 20, "b" * before or "c", "mc68000/a-b-c/d-e-f_g-h.adb",
             *("d" * 20 for _ in range(3))]
    field = requirements_file.field_of(("CODE", links))
    found = requirements_file.FIELD_ON_LINE.fullmatch(field)
    assert requirements_file.names(found["block"]) == links


def test_strictdoc_shows_the_links_both_ways(tmp_path):
    html = tmp_path / "html"
    result = subprocess.run(
        [sys.executable, TRACE / "run.py", "export", html,
         "TIN-1", "ADI-1", "LNK-9", "LNK-2"],
        capture_output=True, text=True, check=False)
    assert f"{html}/index.html shows" in result.stdout, result.stdout
    requirements = next(html.glob("*/requirements.html")).read_text("utf-8")
    for link in ("src/tasks/urv-telin_task.ads", "tests/unit/task_suite-ad_tests.adb",
                 "proofs/theorems-silence.ads", "tests/simulation/test_wire.py"):
        page = html / "_source_files" / f"{link}.html"
        assert link in requirements
        assert "requirements.html" in page.read_text("utf-8")

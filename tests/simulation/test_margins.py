# SPDX-License-Identifier: Apache-2.0
"""EXT-7: docs/evidence/margins.md is of the gains and of the aircraft as they
are, and no loop has less than is wanted."""

import re
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts" / "laws"))

import law_gains  # noqa: E402

PAGE = (ROOT / "docs/evidence/margins.md").read_text(encoding="utf-8")
LEAST = PAGE.partition("\n## Margins\n")[2].partition("\nAt 200 lb")[0]


def test_the_page_is_of_these_gains_and_this_aircraft():
    assert law_gains.mark() in PAGE, "renew it: make margins RENEW=--renew"


def test_every_loop_has_6_db_and_45_degrees():
    rows = [[cell.strip() for cell in line.split("|")[1:-1]]
            for line in LEAST.splitlines() if line.startswith("| ")][1:]
    assert [row[0] for row in rows] == [
        "roll, damping", "yaw damper, roll in damping", "roll, attitude",
        "yaw damper, roll in attitude", "pitch, damping", "pitch, attitude",
        "pitch, hold", "altitude", "airspeed",
        "roll, attitude, table 1", "yaw damper, roll in attitude, table 1",
        "pitch, attitude, table 1", "pitch, hold, table 1",
        "altitude, table 1", "airspeed, table 1"]
    for loop, gain, _, phase, _ in rows:
        assert float(gain) >= 6, loop
        assert phase == "none" or float(phase) >= 45, loop


def test_fixed_point_answers_as_designed():
    steps = PAGE.partition("\n## Fixed point")[2]
    differences = re.findall(r"\| ([0-9.]+) \|$", steps, re.M)
    assert len(differences) == 2
    assert all(float(each) < 0.2 for each in differences)


def test_numbers_are_read_as_ada_has_them(tmp_path):
    (tmp_path / "gains.ads").write_text(
        "   Frames : constant := 50;\n   Much   : constant := 1_000;\n"
        "   Hold   : constant := Frames / 2;\n"
        "   Speed  : constant := 60 * 32;\n   Low : constant := -12_000;\n")
    assert vars(law_gains.gains(tmp_path / "gains.ads")) == {
        "Frames": 50, "Much": 1000, "Hold": 25, "Speed": 1920,
        "Low": -12000}


def column(text, head, speed):
    """By name, what a table of the page says at a speed."""
    lines = text[text.index(head):].split("\n\n")[0].splitlines()
    place = [cell.strip() for cell in lines[0].split("|")].index(speed)
    return {cells[1].strip(): cells[place].strip()
            for cells in (line.split("|") for line in lines[2:])}


def test_the_page_has_what_one_condition_gives_anew(monkeypatch, capsys):
    """The models, the loops, their margins and poles, at 70 kt."""
    pytest.importorskip("control", reason="make margins installs it")
    import margins
    monkeypatch.setattr(margins, "SPEEDS", (70,))
    monkeypatch.setattr(margins, "BALLASTS", (0,))
    of = law_gains.gains()
    result = margins.measured(of)
    assert max(result.misfits) < 0.03
    assert margins.complaints(result) == []
    again = margins.page(result, [])
    for head in ("| loop | 60 kt", "| | 60 kt"):
        there = column(PAGE, head, "70 kt")
        assert there
        assert column(again, head.replace("60", "70"), "70 kt") == there
    assert "all loops have them" in again

# SPDX-License-Identifier: Apache-2.0
"""EVI-4: what evidence/coverage.py says of what gcov counted."""

import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import coverage  # noqa: E402

NAME = "src/kernel/some.adb"
TEXT = """\
procedure Some is
begin
   if A
     and then B
   then
      C;
   end if;
end Some;
"""
REACHED = {1: 1, 3: 4, 4: 3, 6: 2}
BOTH_WAYS = {3: [3, 1], 4: [2, 1]}


def counted(lines=REACHED, ways=BOTH_WAYS, throws=(), name="some"):
    """As gcov has it, of one instance."""
    return {
        "functions": [{"name": name, "start_line": 1,
                       "execution_count": lines.get(1, 0)}],
        "lines": [
            {"line_number": number, "count": count, "function_name": name,
             "branches": [{"count": way, "throw": place in throws}
                          for place, way in enumerate(ways.get(number, ()))]}
            for number, count in lines.items()],
    }


@pytest.fixture
def judged(tmp_path, monkeypatch, capsys):
    """The judgement of some instances, with these rows in
    docs/evidence/coverage.md."""
    (tmp_path / NAME).parent.mkdir(parents=True)
    (tmp_path / NAME).write_text(TEXT, encoding="utf-8")
    monkeypatch.setattr(coverage, "ROOT", tmp_path)
    monkeypatch.setattr(coverage, "EXPLAINED", tmp_path / "coverage.md")

    def judge(*instances, rows="", least=0):
        monkeypatch.setattr(coverage, "LEAST_LINES", least)
        coverage.text_of.cache_clear()
        coverage.EXPLAINED.write_text(rows, encoding="utf-8")
        source = coverage.Source()
        for instance in instances:
            source.add(instance, decisions=True)
        wrong = coverage.judge({NAME: source})
        said = capsys.readouterr().out
        assert wrong == bool(said)
        return said + coverage.result({NAME: source})

    return judge


def test_a_line_not_reached_is_reported(judged):
    assert f"{NAME}:6: never reached: C;" in judged(
        counted({**REACHED, 6: 0}))


def test_a_subprogram_not_entered_is_reported(judged):
    assert f"{NAME}:1: never entered: procedure Some is" in judged(
        counted(dict.fromkeys(REACHED, 0), {}))


@pytest.mark.parametrize("number, text", [(3, "if A"), (4, "and then B")])
def test_a_decision_that_goes_one_way_is_reported(judged, number, text):
    assert f"{NAME}:{number}: goes one way only: {text}" in judged(
        counted(ways={**BOTH_WAYS, number: [5, 0]}))


def test_instances_are_one_text(judged):
    first = counted({**REACHED, 6: 0}, {3: [0, 2], 4: [0, 0]}, name="a")
    second = counted(REACHED, {3: [3, 0], 4: [2, 1]}, name="b")
    assert "goes one way only: if A" in judged(second)
    assert "both ways | 2 | 2 |" in judged(first, second)


def test_what_is_explained_is_well(judged):
    rows = (f"| `{NAME}` | line | `C;` | no B yet |\n"
            f"| `{NAME}` | decision | `and then B` | no B yet |\n")
    said = judged(
        counted({**REACHED, 6: 0}, {**BOTH_WAYS, 4: [0, 4]}), rows=rows)
    assert said.startswith("| of src")
    assert "both ways | 2 | 1 | 50.0 %" in said


@pytest.mark.parametrize("text", ["C;", "D;"])
def test_what_is_explained_without_need_is_reported(judged, text):
    row = f"| `{NAME}` | line | `{text}` | it is so |\n"
    assert f"covered, or not there: {NAME}: {text}" in judged(
        counted(), rows=row)


# --- what is counted, and what comes of it -----------------------------------

@pytest.mark.parametrize("reached, status", [(1, False), (0, True)])
def test_what_is_wrong_is_the_exit_status(
        tmp_path, monkeypatch, judged, reached, status):
    judged(counted())
    source = coverage.Source()
    source.add(counted({**REACHED, 6: reached}), decisions=True)
    monkeypatch.setattr(coverage, "merged", lambda: {NAME: source})
    assert bool(coverage.main(["check"])) == status
    assert coverage.main(["chekc"]) == 2
    assert coverage.main(["run", "--again"]) == 2


def test_evi4_a_check_of_nothing_counted_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(coverage, "merged", dict)
    assert coverage.main(["check", "--renew"]) == 1
    assert capsys.readouterr().err.startswith("coverage: nothing was counted")

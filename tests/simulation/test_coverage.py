# SPDX-License-Identifier: Apache-2.0
"""EVI-4: what evidence/coverage.py says of what gcov counted."""

import json
import subprocess
import sys
from pathlib import Path

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
    """What is said of some instances, with these rows in docs/evidence/coverage.md."""
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


def test_all_covered_is_well(judged):
    assert "lines reached | 4 | 4 | 100.0 %" in judged(counted())


def test_a_line_not_reached_is_told(judged):
    assert f"{NAME}:6: never reached: C;" in judged(
        counted({**REACHED, 6: 0}))


def test_a_subprogram_not_entered_is_told(judged):
    assert f"{NAME}:1: never entered: procedure Some is" in judged(
        counted(dict.fromkeys(REACHED, 0), {}))


def test_too_few_lines_are_told(judged):
    row = f"| `{NAME}` | line | `C;` | it is so |\n"
    assert "lines: 75.00 %, wanted 98.0 %" in judged(
        counted({**REACHED, 6: 0}), rows=row, least=98.0)


@pytest.mark.parametrize("number, text", [(3, "if A"), (4, "and then B")])
def test_a_decision_that_goes_one_way_is_told(judged, number, text):
    assert f"{NAME}:{number}: goes one way only: {text}" in judged(
        counted(ways={**BOTH_WAYS, number: [5, 0]}))


def test_an_exception_after_a_call_is_no_decision(judged):
    assert "both ways | 2 | 2 |" in judged(
        counted(ways={**BOTH_WAYS, 4: [2, 1, 0], 6: [2, 0]}, throws=(2,)))


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


def test_what_is_missed_sometimes_may_be_covered(judged):
    row = f"| `{NAME}` | line | `C;` | Sometimes: on a busy machine. |\n"
    for times in (0, 2):
        assert judged(counted({**REACHED, 6: times}),
                      rows=row).startswith("| of src")


@pytest.mark.parametrize("text, is_well", [
    ("and then...", True), ("and...", True), ("if...", False)])
def test_lines_that_begin_alike_have_one_row(judged, text, is_well):
    row = f"| `{NAME}` | decision | `{text}` | no B yet |\n"
    said = judged(counted(ways={**BOTH_WAYS, 4: [0, 4]}), rows=row)
    assert said.startswith("| of src") == is_well


@pytest.mark.parametrize("text", ["C;", "D;"])
def test_what_is_explained_without_need_is_told(judged, text):
    row = f"| `{NAME}` | line | `{text}` | it is so |\n"
    assert f"covered, or not there: {NAME}: {text}" in judged(
        counted(), rows=row)


def test_a_body_in_no_program_is_told(judged, tmp_path):
    (tmp_path / "src/kernel/other.adb").write_text(TEXT, encoding="utf-8")
    assert "src/kernel/other.adb: in no program" in judged(counted())


# --- what is counted, and what comes of it -----------------------------------

def test_the_least_is_that_of_the_requirement():
    text = (ROOT / "docs" / "requirements.sdoc").read_text("utf-8")
    assert "enter every subprogram of src and reach 98 % of its lines" in text
    assert coverage.LEAST_LINES == 98.0
    # Decisions are not counted where contracts are executed: theirs are no
    # decisions of the program.
    assert {*coverage.PROGRAMS} - {*coverage.COUNT_DECISIONS} == {"contracts"}
    for _, _, switches in coverage.PROGRAMS.values():
        assert switches[0] in ("-gnatp", "-gnata")
    assert coverage.PROGRAMS["partitions"][2][1].endswith("ravenscar.adc")


def test_percents_are_not_rounded_up(judged):
    lines = {number: 1 for number in range(1, 1_001)}
    row = f"| `{NAME}` | line | `C;` | it is so |\n"
    said = judged(counted({**lines, 6: 0}, {}), rows=row, least=99.9)
    assert "lines reached | 1000 | 999 | 99.9 % |" in said
    said = judged(counted({**{n: 1 for n in range(1, 4)}, 6: 0}, {}), rows=row)
    assert "lines reached | 4 | 3 | 75.0 % |" in said


@pytest.mark.parametrize("reached, status", [(1, False), (0, True)])
def test_what_is_wrong_is_the_exit_status(
        tmp_path, monkeypatch, judged, reached, status):
    judged(counted())
    source = coverage.Source()
    source.add(counted({**REACHED, 6: reached}), decisions=True)
    monkeypatch.setattr(coverage, "merged", lambda: {NAME: source})
    monkeypatch.setattr(coverage, "write_html", lambda _: None)
    assert bool(coverage.main(["check"])) == status
    assert coverage.main(["chekc"]) == 2
    assert coverage.main(["run", "--again"]) == 2


@pytest.mark.parametrize("status", [1, 2, 134, -9])
def test_a_part_that_fails_ends_it(monkeypatch, status):
    monkeypatch.setattr(
        coverage.subprocess, "run", lambda *_, **__:
        subprocess.CompletedProcess([], status, "", ""))
    with pytest.raises(SystemExit, match="coverage: failed: gprbuild"):
        coverage.run("gprbuild")


def notes(*functions):
    """Notes of GCC 12: each function with its name, whether it is marked as
    artificial, and the name of its source."""
    def number(value):
        return value.to_bytes(4, "little")

    def text(value):
        return number(len(value)) + value

    data = b"oncg*22B" + number(1) + number(2) + text(b"folder\0\0") + number(1)
    for name, artificial, source in functions:
        body = (number(3) + number(4) + number(5) + text(name)
                + number(artificial) + text(source) + number(6) * 4)
        data += number(coverage.FUNCTION_RECORD) + number(len(body)) + body
        data += number(0x0141_0000) + number(4) + number(7)
    return data + number(0)


def test_only_what_has_a_source_is_no_longer_artificial():
    given = notes((b"own_", 1, b"some.adb"), (b"made", 1, b""),
                  (b"usual___", 0, b"some.adb"))
    wanted = notes((b"own_", 0, b"some.adb"), (b"made", 1, b""),
                   (b"usual___", 0, b"some.adb"))
    assert coverage.with_protected(given) == wanted
    with pytest.raises(SystemExit, match="not the notes of GCC 12"):
        coverage.with_protected(given.replace(b"*22B", b"*31B"))


@pytest.fixture
def gcov(tmp_path, monkeypatch):
    """A program that stands for gcov: what it says, and on which output."""

    def say(out, error=""):
        program = tmp_path / "gcov"
        (tmp_path / "out").write_text(out)
        (tmp_path / "error").write_text(error)
        program.write_text(f"#!/bin/sh\ncat {tmp_path}/out\n"
                           f"cat {tmp_path}/error >&2\n")
        program.chmod(0o755)
        (tmp_path / "some.gcno").write_bytes(notes())
        monkeypatch.setattr(coverage, "GCOV", str(program))
        monkeypatch.setattr(coverage, "ROOT", tmp_path)
        return list(coverage.counted_in(tmp_path / "some.gcno"))

    return say


def test_only_sources_of_src_are_counted(gcov, tmp_path):
    files = [{"file": str(tmp_path / name)}
             for name in ("src/a.adb", "tests/b.adb", "sim/c.adb")]
    said = json.dumps({"files": files + [{"file": "system.ads"}]})
    assert gcov(said) == [("src/a.adb", files[0])]


def test_counts_of_another_build_end_it(gcov):
    with pytest.raises(SystemExit, match="stamp mismatch with notes file"):
        gcov("", "some.gcda:stamp mismatch with notes file\n")


def test_evi4_programs_stand_where_they_find_the_aircraft(tmp_path,
                                                          monkeypatch):
    """plant.py and its Python are beside the folder of a program; in a
    folder of bin it would find neither, and the flights with JSBSim fail."""
    built = tmp_path / "bin" / "coverage-flights"
    built.mkdir(parents=True)
    (built / "urv_sim").touch()
    monkeypatch.setattr(coverage, "HTML", tmp_path / "coverage")
    began = {}
    monkeypatch.setattr(coverage, "run",
                        lambda *command, env: began.update(env))
    coverage.run_pytest(built, ["a test"])
    program = Path(began["URV_SIM"])
    assert program.exists()
    assert program.parent.parent == tmp_path
    assert Path(began["URV_PARTITIONS"]) == program.parent


def test_the_page_gets_the_table_and_keeps_the_rest(tmp_path, monkeypatch):
    page = tmp_path / "coverage.md"
    text = coverage.EXPLAINED.read_text("utf-8")
    page.write_text(text, "utf-8")
    monkeypatch.setattr(coverage, "EXPLAINED", page)
    coverage.renew("new\n")
    before, there, after = page.read_text("utf-8").partition(
        "<!-- make -C evidence coverage -->\nnew\n<!-- end -->\n")
    assert there
    assert text.startswith(before) and text.endswith(after) and after


def test_a_unit_test_that_fails_is_told(tmp_path):
    program = tmp_path / "tests"
    program.write_text("#!/bin/sh\necho 'ok   one'\necho 'FAIL two'\n"
                       "echo '     why'\necho 'ok   three'\nexit 1\n")
    program.chmod(0o755)
    with pytest.raises(SystemExit) as told:
        coverage.run_unit_tests(program, "fully")
    assert "FAIL two\n     why" in str(told.value)
    assert "one" not in str(told.value) and "three" not in str(told.value)

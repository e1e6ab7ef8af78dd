# SPDX-License-Identifier: Apache-2.0
"""EVI-6: what evidence/independence.py makes of what it sees."""

import subprocess
import sys
from pathlib import Path

import pytest
from conftest import PROGRAM, ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import independence  # noqa: E402

PAGE = "a\n<!-- switches -->\nold\n<!-- end -->\nb\n<!-- chroot -->\n<!-- end -->"


def said(text):
    """A program that says this and ends with status 1."""
    return lambda *command, **more: (1, text)


@pytest.mark.parametrize("text, expected", [
    ("ok one\n3 passed, 0 failed, 0 skipped\n", (3, 0)),
    ("FAIL one\n2 passed, 1 failed, 0 skipped\n", (2, 1)),
    ("raised PROGRAM_ERROR\n", (0, 1)),
])
def test_unit_tests_are_counted(monkeypatch, text, expected):
    monkeypatch.setattr(independence, "run", said(text))
    assert independence.unit_tests(Path("bin")) == expected


@pytest.mark.parametrize("text, expected", [
    ("..\n2 passed in 0.10s\n", (2, 0)),
    ("F.\n1 failed, 2 passed, 1 skipped in 0.10s\n", (2, 1)),
    ("nothing was collected\n", (0, 1)),
])
def test_flying_tests_are_counted(monkeypatch, text, expected):
    monkeypatch.setattr(independence, "run", said(text))
    assert independence.flying_tests(Path("bin"), ["wire"]) == expected


def test_bytes_of_flights_are_those_of_the_flights(monkeypatch):
    first = independence.bytes_of_flights(PROGRAM)
    assert first == independence.bytes_of_flights(PROGRAM)
    monkeypatch.setattr(independence, "FLIGHTS",
                        (*independence.FLIGHTS[:-1], ("--seconds", "6")))
    assert first != independence.bytes_of_flights(PROGRAM)


def test_a_flight_that_fails_is_no_result(tmp_path):
    with pytest.raises(subprocess.CalledProcessError):
        independence.bytes_of_flights("false")


def test_the_page_gets_the_table_and_keeps_the_rest():
    page = independence.renewed(PAGE, "switches", "new\n")
    assert page == PAGE.replace("old\n", "new\n")
    page = independence.DOCUMENT.read_text(encoding="utf-8")
    for part in ("switches", "chroot"):
        assert "other\n" in independence.renewed(page, part, "other\n")


def test_a_page_without_a_place_is_refused():
    with pytest.raises(SystemExit):
        independence.renewed("a\nb\n", "switches", "new\n")


def test_switches_are_all_combinations():
    assert list(independence.BUILDS) == [
        "-O0 -gnatVa", "-O2 -gnatVa", "-O0 -gnata -gnatVa",
        "-O2 -gnata -gnatVa"]


MISSING = "    apt-get update && apt-get install -y gnat-12 gprbuild\n"


@pytest.mark.parametrize("said, command", [
    (f"setup: have root run this:\n{MISSING}make: Error 1\n",
     MISSING.strip()),
    (MISSING * 2, None),
    ("setup: no network\n", None),
])
def test_a_user_is_told_one_command(said, command):
    assert independence.command_for_root(said) == command


def test_a_newcomer_tried_alone_leaves_the_others_rows():
    def row(debian, who, result):
        return [f"Debian {debian}", who, "14.2.0", "5 min", result, "9 min"]
    page = independence.newcomers_table(
        "", [row(12, "root", "old"), row(13, "user", "old")])
    page = independence.newcomers_table(
        f"a\n{page}b\n", [row(13, "user", "new"), row(12, "user", "new")])
    lines = page.splitlines()
    assert len(lines) == 5
    for line, beginning, result in zip(
            lines[2:], ["12 | root", "12 | user", "13 | user"],
            ["old", "new", "new"]):
        assert line.startswith(f"| Debian {beginning} |")
        assert f"| {result} |" in line


def test_sticks_move_every_50_ms_for_5_seconds():
    rows = [line.split(",") for line in independence.STICKS.splitlines()]
    assert [int(row[0]) for row in rows[1:]] == [*range(0, 5_000, 50)]
    for name, *words in zip(*rows):
        assert len(set(words)) > 1, name
        assert name == "time_ms" or {*map(int, words)} <= {*range(4_096)}


def test_what_git_has_is_checked_out_as_it_stands(tmp_path, monkeypatch):
    root = tmp_path / "root"
    (root / "folder").mkdir(parents=True)
    (root / "folder" / "script").write_text("changed\n")
    (root / "folder" / "script").chmod(0o755)
    (root / "not git's").write_text("")
    monkeypatch.setattr(independence, "ROOT", root)
    monkeypatch.setattr(independence, "run", lambda *_, **__: (
        0, "folder/script\0gone\0"))
    independence.check_out(tmp_path / "home")
    assert [path.relative_to(tmp_path / "home").as_posix()
            for path in (tmp_path / "home").rglob("*") if path.is_file()] == [
                "folder/script"]
    there = tmp_path / "home" / "folder" / "script"
    assert there.read_text() == "changed\n"
    assert there.stat().st_mode & 0o777 == 0o755


@pytest.mark.parametrize("who, home", [
    ("root", "root"), ("user", f"home/{independence.USER}")])
def test_a_newcomer_has_the_sources_at_home(tmp_path, monkeypatch, who, home):
    """In a folder with a space in its name, as some have."""
    assert " " in independence.CLONE
    home = f"{home}/{independence.CLONE}"
    done = []
    for name in ("left", "fresh"):
        monkeypatch.setattr(independence, name, lambda *_: None)
    monkeypatch.setattr(independence, "check_out", done.append)
    monkeypatch.setattr(independence, "in_system", lambda *_, **__: (0, ""))
    monkeypatch.setattr(independence, "what_happens",
                        lambda system, place, debian, user: (
                            place.relative_to(system), user))
    debian = next(iter(independence.SUITES))
    assert independence.try_newcomer(tmp_path, f"{debian}/{who}") == (
        Path(home), who)
    assert done[0].as_posix().endswith(home)

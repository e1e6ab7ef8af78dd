# SPDX-License-Identifier: Apache-2.0
"""SEC-17, SEC-18: what set-up fetches, and the page that lists it."""

import hashlib
import re

import pytest
from conftest import ROOT
from test_set_up import on_debian, set_up

__all__ = ["set_up"]

LISTS = sorted(path for folder in (ROOT / "sim", ROOT / "ground",
                                   ROOT / "tests", ROOT / "scripts",
                                   ROOT / "evidence", ROOT / "targets")
               for path in folder.rglob("*requirements.txt"))
SUMS = ROOT / "ground" / "yamcs" / "SHA256SUMS"
SUM = re.compile(r"([0-9a-f]{64})  (\S+\.jar)")
PAGE = (ROOT / "docs" / "dependencies.md").read_text("utf-8")
HASH = r"    --hash=sha256:[0-9a-f]{64}"
PINNED = re.compile(rf"([A-Za-z0-9._-]+)==(\S+)((?: \\\n{HASH})*)\n")


def pinned(text):
    """Each package with its version and its hashes; nothing else is in it."""
    text = "".join(line for line in text.splitlines(True)
                   if not line.startswith("#"))
    assert PINNED.sub("", text) == ""
    return [(name, version, hashes.split())
            for name, version, hashes in PINNED.findall(text)]


@pytest.mark.parametrize("path", LISTS, ids=[
    path.relative_to(ROOT).as_posix() for path in LISTS])
def test_sec17_each_python_package_has_its_hashes(path):
    found = pinned(path.read_text("utf-8"))
    assert found
    assert [name for name, _, hashes in found if not hashes] == []


def test_sec17_set_up_installs_wheels_with_known_hashes_alone(
        set_up, tmp_path):
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text('#!/bin/sh\n[ "$1" = -c ] || echo "$@" >>called\n',
                      encoding="utf-8")
    python.chmod(0o755)
    result = set_up("fly", alire=True, gprbuild="", gcc="")
    assert result.returncode == 0
    calls = (tmp_path / "called").read_text("utf-8").splitlines()
    assert len(calls) == 2
    for call in calls:
        assert {"--require-hashes", "--only-binary", ":all:", "--no-deps"} \
            <= set(call.split())


@on_debian
def test_sec17_d84_the_archive_of_the_emulator_has_its_hash(set_up, tmp_path):
    folder = tmp_path / "targets/mc68000/musashi"
    folder.mkdir(parents=True)
    for name in ("requirements.txt", "archive.txt"):
        text = (ROOT / "targets/mc68000/musashi" / name).read_text("utf-8")
        (folder / name).write_text(text, encoding="utf-8")
    assert [text.count("--hash=")] == [len(pinned(text))]
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text('#!/bin/sh\n[ "$1" = -c ] || echo "$@" >>called\n',
                      encoding="utf-8")
    python.chmod(0o755)
    result = set_up("mc68000", dpkg_query="echo install ok installed",
                    id="echo 1000")
    if "Debian 12 has it" in result.stderr:
        pytest.skip("this Debian has no compiler for the 68000")
    assert result.returncode == 0
    calls = (tmp_path / "called").read_text("utf-8").splitlines()
    assert len(calls) == 2
    assert {"download", "--require-hashes", "--no-deps",
            "targets/mc68000/musashi/archive.txt"} <= set(calls[1].split())


JAR = b"a jar"
# A Maven that leaves one file in the folder that it was told.
MAVEN = ('for word in "$@"; do case $word in -DoutputDirectory=*)'
         ' mkdir -p "${word#*=}"; printf "%s" "a jar" '
         '>"${word#*=}/NAME.jar" ;; esac; done; echo "$@" >called')


@pytest.mark.parametrize("name, data, works", [
    ("a", JAR, True), ("a", b"another jar", False), ("b", JAR, False)])
def test_sec17_yamcs_is_what_it_was(set_up, tmp_path, name, data, works):
    """Another content, or another file, ends set-up."""
    yamcs = tmp_path / "ground" / "yamcs"
    yamcs.mkdir(parents=True)
    (yamcs / "pom.xml").write_text("<project/>", encoding="utf-8")
    (yamcs / "SHA256SUMS").write_text(
        f"{hashlib.sha256(data).hexdigest()}  a.jar\n", encoding="utf-8")
    python = tmp_path / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text("#!/bin/sh\n", encoding="utf-8")
    python.chmod(0o755)
    result = set_up("ground", alire=True, gprbuild="", gcc="", java="",
                    mvn=MAVEN.replace("NAME", name))
    called = (tmp_path / "called").read_text("utf-8").split()
    assert "--strict-checksums" in called
    assert (result.returncode == 0) == works
    assert (tmp_path / "obj" / "yamcs").exists() == works
    if not works:
        assert "setup: Maven failed" in result.stderr
        assert "SHA256SUMS" in result.stderr


@on_debian
@pytest.mark.parametrize("owner, hands_over", [
    ("pilot", True), ("root", False), ("UNKNOWN", False)])
def test_sec17_root_installs_debian_packages_alone(
        set_up, tmp_path, owner, hands_over):
    """The owner of the tree does the rest."""
    result = set_up(
        "prove", dpkg_query="echo install ok installed", id="echo 0",
        gnatprove="", stat=f"echo {owner}", runuser='echo "$@" >handed')
    assert result.returncode == 0
    handed = tmp_path / "handed"
    assert handed.exists() == hands_over
    if hands_over:
        assert handed.read_text("utf-8") == \
            f"-u {owner} -- scripts/setup.sh prove\n"


def cells(line):
    return [cell.strip() for cell in line.strip("|\n").split("|")]


def rows(title):
    """The rows of the tables below a title of the page."""
    part = PAGE.partition(f"\n## {title}\n")[2].partition("\n## ")[0]
    return [cells(line) for line in part.splitlines()
            if line.startswith("| ")]


def test_sec18_the_page_lists_each_python_package_with_its_licence():
    wanted = {(name, version) for path in LISTS
              for name, version, _ in pinned(path.read_text("utf-8"))}
    listed = {tuple(row[:2]): row for row in rows("Python packages")
              if len(row) == 4 and row[0] != "package"}
    assert set(listed) == wanted
    assert [row for row in listed.values() if not row[2] or not row[3]] == []
    assert {path.relative_to(ROOT).as_posix() for path in LISTS} == {
        row[1].strip("`") for row in rows("Python packages")
        if len(row) == 2 and row[0] != "use"}


def test_sec18_the_page_lists_each_file_of_yamcs_with_its_licence():
    lines = SUMS.read_text("utf-8").splitlines()
    assert all(SUM.fullmatch(line) for line in lines)
    listed = {row[0].strip("`"): row for row in rows("Yamcs")
              if row[0] != "file"}
    assert set(listed) == {SUM.fullmatch(line)[2] for line in lines}
    assert all(row[1] and row[2] for row in listed.values())


def test_sec18_the_page_lists_each_debian_package():
    text = (ROOT / "scripts" / "setup.sh").read_text("utf-8")
    named = " ".join(re.findall(
        r'(?:packages|build|aunit|gcov|more|bare\w*)="?([^"$;]*(?:\$\w+ ?[^"]*)*)',
        text))
    wanted = {re.sub(r"-1[0-9]$", "", word) for word in named.split()
              if re.fullmatch(r"[a-z][a-z0-9+.-]+", word)}
    assert {"gprbuild", "afl++", "chromium"} <= wanted
    listed = {word for row in rows("Debian packages")
              for word in re.split(r", | ", row[0])}
    assert {word for word in wanted
            if re.sub(r"(22)?-dev$", "", word) not in listed} == set()


def test_sec18_the_page_of_security_names_tests_that_there_are():
    """A statement of a table names its test."""
    page = (ROOT / "docs" / "security.md").read_text("utf-8")
    part = page.partition("\n## Files\n")[2].partition("\n## ")[0]
    rows = [cells(line) for line in part.splitlines()
            if line.startswith("| ") and "statement" not in line]
    assert len(rows) >= 7
    there = {path.stem for path in (ROOT / "tests").rglob("test_*.py")}
    for statement, tests in rows:
        assert re.search(r"SEC-\d+", statement), statement
        named = re.findall(r"`(\w+)`", tests)
        assert named and set(named) <= there, statement

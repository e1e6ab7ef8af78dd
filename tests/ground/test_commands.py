# SPDX-License-Identifier: Apache-2.0
"""GND-10: the messages of bin/urv, and its exit status."""

import io
import os
import re
import subprocess
import sys
import time

import pytest
from conftest import ROOT, TIME_LIMIT_S

from urv import main, progress


def test_gnd10_help_names_every_command_and_each_has_help(urv, capsys):
    result = urv("--help")
    assert (result.returncode, result.stderr) == (0, "")
    commands = re.findall(
        r"^  ([a-z-]+) +(.+)$", result.stdout.partition("Commands:")[2], re.M)
    assert len(commands) == 13
    for command, line in commands:
        assert main.main([command, "--help"]) == 0, command
        help_of_it = capsys.readouterr().out
        assert help_of_it.startswith(f"Usage: urv {command}"), command
        assert f"\n\n  {line}\n" in help_of_it, command


@pytest.mark.parametrize("group", ["card", "recorder"])
def test_gnd10_the_list_of_a_group_has_whole_sentences(urv, group):
    """Long ones ended with "..."."""
    result = urv(group, "--help", env={**os.environ, "COLUMNS": "80"})
    lines = result.stdout.partition("Commands:\n")[2].splitlines()
    assert len(lines) >= 2
    assert [line for line in lines if not re.fullmatch(
        r"  [a-z]+ +[A-Z].*[a-z]\.", line)] == []


LOADED = """
import sys
from urv import main
main.main(["--help"])
print(*sorted(name for name in sys.modules if name.startswith("urv.")))
"""


def test_gnd10_help_imports_no_command():
    """A command's packages take most of the time of a start."""
    result = subprocess.run(
        [sys.executable, "-B", "-c", LOADED], text=True, capture_output=True,
        check=False, timeout=TIME_LIMIT_S,
        env={**os.environ, "PYTHONPATH": str(ROOT / "ground")})
    assert result.stdout.splitlines()[-1] == "urv.faults urv.main"


def test_gnd10_without_a_command_the_choices_are_listed(urv):
    result = urv()
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith("urv: no command; there are ")


def test_gnd10_version_is_the_product_s(urv):
    assert urv("--version").stdout == "urv 0.1.0\n"
    assert 'version = "0.1.0"' in (ROOT / "alire.toml").read_text("utf-8")


@pytest.mark.parametrize("arguments", [["flie"], ["--flie"], ["-q"],
                                       ["\x1b[31mred"]])
def test_gnd10_what_is_mistyped_gives_one_line(urv, arguments):
    result = urv(*arguments)
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    assert result.stderr.startswith("urv: No such ")
    assert "\x1b" not in result.stderr


def test_gnd10_an_output_that_cannot_be_written_gives_one_line(urv):
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = urv("--help", stdout=full, capture_output=False, stderr=-1)
    assert result.returncode == 1
    assert result.stderr == ("urv: standard output: No space left on device"
                             "\n")


class Terminal(io.StringIO):
    """A standard error that someone looks at."""

    def isatty(self):
        return True


class Record:
    size, position = 1000, 250


@pytest.mark.parametrize("seconds, is_shown", [(1.9, False), (2.1, True)])
def test_gnd10_a_bar_is_shown_after_two_seconds(
        monkeypatch, seconds, is_shown):
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setenv("TERM", "xterm")
    now = time.monotonic()
    monkeypatch.setattr(progress.time, "monotonic", lambda: now)
    with progress.bar("converting") as told:
        now += seconds
        told(Record)
    assert ("converting" in terminal.getvalue()) == is_shown
    assert ("25%" in terminal.getvalue()) == is_shown


def test_gnd10_where_nobody_looks_there_is_no_bar(monkeypatch):
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    monkeypatch.setattr(progress, "BEFORE_IT_IS_SHOWN_S", 0)
    with progress.bar("converting") as told:
        told(Record)
    assert sys.stderr.getvalue() == ""


WITHOUT = """
import sys

class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r} or name.startswith({name!r} + "."):
            raise {error}

sys.meta_path.insert(0, Hidden())
sys.argv[0] = "urv"
import runpy
runpy.run_module("urv", run_name="__main__")
"""


def run_without(folder, name, *arguments, error=None):
    """bin/urv where that package is not installed."""
    error = error or "ModuleNotFoundError('No module named', name=name)"
    return subprocess.run(
        [sys.executable, "-B", "-c", WITHOUT.format(name=name, error=error),
         *map(str, arguments)], cwd=folder, text=True, capture_output=True,
        check=False, timeout=TIME_LIMIT_S,
        env={**os.environ, "PYTHONPATH": str(ROOT / "ground"),
             # pictures looks for a browser before its package.
             "URV_CHROMIUM": sys.executable})


def listed(target):
    """The packages that set-up installs for a target, as modules."""
    script = (ROOT / "scripts" / "setup.sh").read_text("utf-8")
    case = re.search(rf"^   (?:\w+ \| )*{target}(?: \| \w+)*\)(.*?);;", script,
                     re.M | re.S)[1]
    found = {name for path in re.findall(r"\S+requirements\.txt", case)
             for name in re.findall(r"^([\w-]+)==",
                                    (ROOT / path.split("=")[-1].strip('"'))
                                    .read_text("utf-8"), re.M)}
    modules = {"mcap": "mcap", "protobuf": "google.protobuf",
               "yamcs-client": "yamcs", "yamcs-pymdb": "yamcs"}
    return {modules.get(name, name) for name in found}


@pytest.mark.parametrize("name, command", [
    ("typer", ["--help"]), ("numpy", ["report", "a.csv", "-o", "a.html"]),
    ("pyarrow", ["convert", "a.csv", "a.parquet"]),
    ("mcap", ["convert", "a.csv", "a.mcap"]),
    ("google.protobuf", ["convert", "a.csv", "a.mcap"]),
    ("yamcs", ["xtce", "-o", "a.xml"]),
    ("aiohttp", ["station"]), ("pymavlink", ["mavlink"]),
    ("distributed", ["monte-carlo", "--flights", "1"]),
    ("scipy", ["identify", "a.csv"]), ("playwright", ["pictures"]),
])
def test_gnd10_a_missing_package_gives_one_line_with_the_command(
        tmp_path, name, command):
    (tmp_path / "a.csv").write_text("frame,time_ms\n0,20\n", "utf-8")
    result = run_without(tmp_path, name, *command)
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr.startswith(f"urv: the package {name}")
    # None of them needs Java, which ground installs, and only the tests have a
    # browser's package.
    target = {"typer": "fly", "playwright": "test"}.get(name, "page")
    assert result.stderr.endswith(
        f" is missing: scripts/setup.sh {target} installs it\n")
    assert len(result.stderr.splitlines()) == 1
    assert name == "typer" or name in listed(target)


def test_gnd10_a_package_with_a_part_missing_gives_one_line(tmp_path):
    """An ImportError that is no ModuleNotFoundError was a traceback."""
    result = run_without(
        tmp_path, "yamcs", "xtce", "-o", "a.xml",
        error="ImportError(\"cannot import name 'pymdb' from 'yamcs'\")")
    assert (result.returncode, result.stderr) == (
        1, "urv: a package is missing (cannot import name 'pymdb' from"
        " 'yamcs'): scripts/setup.sh page installs it\n")


SCRIPTS = [path for folder in ("scripts", "evidence", "ground")
           for path in sorted((ROOT / folder).rglob("*"))
           if path.is_file() and path.suffix in (".py", ".sh")]


def test_gnd10_what_has_a_first_line_for_it_can_be_run():
    """A script with #! has its run bit, and none has the one only."""
    for path in SCRIPTS:
        has_line = path.read_bytes().startswith(b"#!")
        assert os.access(path, os.X_OK) == has_line, path


@pytest.mark.parametrize("arguments, named", [
    ("report a.csv -o a.csv", "RECORD and --output"),
    ("report b.csv --summary a.csv -o a.csv", "--summary and --output"),
    ("report a.csv -o same.csv", "RECORD and --output"),
    ("convert a.csv ./a.csv", "IN and OUT"),
    ("identify b.csv a.csv --json a.csv", "RECORD 2 and --json"),
    ("identify b.csv --json a.csv -o a.csv", "--output and --json"),
    ("identify b.csv --json new --model ./new", "--json and --model"),
    ("card check a.csv --plot a.csv", "FILE and --plot"),
    ("card programme a.csv --sticks a.csv --orders b.csv",
     "FILE and --sticks"),
    ("card programme a.csv --sticks new --orders new",
     "--sticks and --orders"),
    ("recorder read a.recording a.recording", "BLOCKS and FILE"),
])
def test_gnd10_no_output_replaces_an_input_or_another_output(
        urv, tmp_path, arguments, named):
    """bin/urv report flight.csv -o flight.csv replaced the record."""
    for name in ("a.csv", "b.csv", "a.recording"):
        (tmp_path / name).write_text("frame,time_ms\n0,20\n", "utf-8")
    os.link(tmp_path / "a.csv", tmp_path / "same.csv")
    result = urv(*arguments.split())
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith(f"urv: {named} name the same file: ")
    assert len(result.stderr.splitlines()) == 1
    assert {path.read_text("utf-8") for path in tmp_path.iterdir()} == {
        "frame,time_ms\n0,20\n"}


def test_gnd10_two_outputs_may_go_to_one_device(urv, tmp_path):
    (tmp_path / "cards.toml").write_text(
        '[[card]]\nkind = "step"\nmoves = ["pitch"]\namplitude_deg = 2\n'
        "pulse_s = 0.4\n", "utf-8")
    assert urv("card", "programme", "cards.toml", "--sticks", "/dev/null",
               "--orders", "/dev/null").returncode == 0

# SPDX-License-Identifier: Apache-2.0
"""SEC-10: bin/urv and all that it starts run the project's code and that of
its packages, never code of the current folder."""

import os
import shutil
import signal
import socket
import subprocess
import sys
from importlib.metadata import packages_distributions

import pytest
from conftest import ROOT, TIME_LIMIT_S, URV
from ports import free_ports

import urv.main
from urv import programs

MARK = "code of the current folder has run"
TRAP = """import os
with open({marks!r}, "a") as file:
    file.write({mark!r} + ": " + __name__ + "\\n")
"""
OWN = {path.stem for folder in ("ground/urv", "sim/jsbsim", "evidence/safety")
       for path in (ROOT / folder).glob("*.py")}
PROGRAMS = ("java", "openssl", "chromium", "python", "urv_sim")


@pytest.fixture
def hostile(tmp_path):
    """A folder with a module of each name that anything could import, and
    programs. Each leaves a line in the file marks."""
    folder = tmp_path / "hostile"
    folder.mkdir()
    marks = tmp_path / "marks"
    names = {"urv", "ground", "sitecustomize", "usercustomize", *OWN,
             *sys.stdlib_module_names, *packages_distributions()}
    for name in names:
        if name.isidentifier():
            (folder / f"{name}.py").write_text(
                TRAP.format(marks=str(marks), mark=MARK))
    for name in PROGRAMS:
        program = folder / name
        program.write_text(f"#!/bin/sh\necho {MARK}: {name} >>{marks}\n")
        program.chmod(0o755)
    return folder


def marks(hostile):
    """The modules and programs of the folder that have run."""
    left = hostile.parent / "marks"
    return left.read_text().splitlines() if left.exists() else []


# The current folder is in each path, as in some set-ups. An empty entry means
# it, too.
PATHS = {"PYTHONPATH": ":", "PYTHONHOME": "",
         "PATH": f":.:{os.environ['PATH']}"}


@pytest.fixture
def start(hostile):
    """Starts bin/urv in the folder."""
    def start_it(*arguments, **more):
        environment = {name: value for name, value in os.environ.items()
                       if not name.startswith("PYTHON")}
        return subprocess.Popen(
            [URV, *map(str, arguments)], cwd=hostile, text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            env=environment | PATHS | more)
    return start_it


@pytest.fixture
def run(start):
    """The same, up to its end."""
    def run_it(*arguments, **more):
        process = start(*arguments, **more)
        said, errors = process.communicate(timeout=TIME_LIMIT_S)
        return process.returncode, said, errors
    return run_it


QUICK = {
    "--help": (("--help",), 0), "--version": (("--version",), 0),
    "convert": (("convert", "{record}", "record.parquet"), 0),
    "report": (("report", "{record}", "-o", "report.html"), 0),
    "identify": (("identify", "{record}", "-o", "report.html"), 0),
    "xtce": (("xtce", "-o", "urv.xml"), 0),
    "card": (("card", "check", "{card}"), 0),
    "recorder": (("recorder", "read", "{blocks}", "a.recording"), 0),
    "keygen": (("keygen", "link.key"), 0),
    "station": (("station", "--port", "0", "--frames", "udp:127.0.0.1:0",
                 "--console", "none", "--seconds", "0.1"), 0),
    "pictures": (("pictures", "--folder", "pictures"), 1),
    "monte-carlo": (("monte-carlo", "--flights", "2", "--pilot", "level",
                     "--seconds", "10", "--workers", "1"), 0),
    "monte-carlo --again": (("monte-carlo", "--again", "1", "--pilot",
                             "level", "--seconds", "10"), 0)}
"""Commands that end by themselves, with their status. pictures finds no
browser that works."""

CARD = """
[[card]]
kind = "doublet"
moves = ["pitch"]
amplitude_deg = 2
pulse_s = 0.4
"""


@pytest.mark.parametrize("name", QUICK)
def test_sec10_no_command_runs_code_of_the_current_folder(
        name, run, hostile, brief, tmp_path):
    arguments, wanted = QUICK[name]
    card, blocks = tmp_path / "card.toml", tmp_path / "blocks"
    card.write_text(CARD, "utf-8")
    blocks.touch()
    status, _, errors = run(
        *(word.format(record=brief / "record.csv", card=card, blocks=blocks)
          for word in arguments),
        URV_CHROMIUM="/bin/false")
    assert marks(hostile) == []
    assert status == wanted, errors


def test_sec10_mavlink_runs_no_code_of_the_current_folder(start, hostile):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        process = start("mavlink", "--listen", "udp:127.0.0.1:0", "--to",
                        f"udp:127.0.0.1:{receiver.getsockname()[1]}")
        line = process.stdout.readline()
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=TIME_LIMIT_S)
    assert marks(hostile) == []
    assert line.startswith("mavlink: from "), errors


def test_sec10_yamcs_gate_runs_no_code_of_the_current_folder(start, hostile):
    process = start("yamcs-gate", "--port", 0, "--yamcs",
                    "http://127.0.0.1:1/yamcs")
    line = process.stdout.readline()
    process.send_signal(signal.SIGTERM)
    _, errors = process.communicate(timeout=TIME_LIMIT_S)
    assert marks(hostile) == []
    assert line.startswith("yamcs-gate: pages at "), errors
    assert process.returncode == 0


def test_sec10_a_flight_runs_no_code_of_the_current_folder(run, hostile):
    ports = free_ports(7)[0]
    status, said, errors = run(
        "ground", "--no-yamcs", "--seconds", 3, "--folder", "flight",
        "--ports", ports, "--page-port", ports + 5,
        "--mavlink", f"udp:127.0.0.1:{ports + 6}")
    assert marks(hostile) == []
    # 3 where a slow machine has ended it before the link was there.
    assert status in (0, 3), said + errors


def test_sec10_workers_of_the_campaign_run_no_code_of_the_current_folder(
        hostile, tmp_path):
    """The program of a copy, which has results of its own."""
    copy = tmp_path / "copy"
    for name in ("evidence/campaign", "evidence/safety", "ground/urv"):
        shutil.copytree(ROOT / name, copy / name)
    (copy / "bin").mkdir()
    for name in ("evidence/flight_numbers.py", "evidence/whole_numbers.py",
                 "bin/urv_sim"):
        shutil.copy(ROOT / name, copy / name)
    ended = subprocess.run(
        [sys.executable, copy / "evidence/campaign/run.py", "tiny", "--only",
         "many", "--jobs", "1"], cwd=hostile, capture_output=True, text=True,
        check=False, stdin=subprocess.DEVNULL, timeout=TIME_LIMIT_S)
    assert marks(hostile) == []
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert (copy / "campaign" / "results.csv").exists()


def test_sec10_every_command_is_tried():
    tried = {name.split()[0] for name in QUICK} | {
        "mavlink", "ground", "yamcs-gate"}
    assert set(urv.main.COMMANDS) == tried - {"--help", "--version"}


def test_sec10_programs_come_from_absolute_folders_of_the_path(
        hostile, monkeypatch):
    monkeypatch.chdir(hostile)
    monkeypatch.setenv("PATH", ":.:bin:")
    assert programs.found("java") is None
    monkeypatch.setenv("PATH", f":.:{hostile}")
    assert programs.found("java") == str(hostile / "java")


def test_sec10_a_worker_looks_for_modules_elsewhere(hostile, monkeypatch):
    """The check of a worker's modules, in a worker's folder."""
    from urv import cargo

    monkeypatch.chdir(hostile)
    monkeypatch.delenv("PYTHONPATH", raising=False)
    cargo.Cargo(b"", None, modules=("json", "jsbsim")).must_do()
    assert marks(hostile) == []

# SPDX-License-Identifier: Apache-2.0
"""Runs bin/urv for the tests, and the simulation whose flights it reads.

    def test_something(urv, flight):
        result = urv("convert", flight / "record.csv", "record.mcap")
        assert result.returncode == 0

Both run in a folder of the test's own. `standard` is the flight of `make fly`,
`brief` its first 20 s; each is flown once for all tests of a run.
"""

import contextlib
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
URV = ROOT / "bin" / "urv"
SIMULATION = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

sys.path[:0] = [str(ROOT / "ground"), str(ROOT / "tests")]

# Their assertions are shown like a test's own.
pytest.register_assert_rewrite("fake_node", "flight_rig", "station_rig")

# Far longer than anything of the tests takes; a hung program is a failure.
TIME_LIMIT_S = 900


def run(folder, program, *arguments, **more):
    return subprocess.run(
        [program, *map(str, arguments)], cwd=folder, check=False,
        stdin=subprocess.DEVNULL, timeout=TIME_LIMIT_S,
        **{"capture_output": True, "text": True, **more})


# A new process is counted as large as the one that starts it was, so a small
# one starts the command and says what the command needed.
MEASURE = """
import resource, subprocess, sys
status = subprocess.call(sys.argv[1:], stdout=subprocess.DEVNULL)
print(status, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)
"""


def run_measured(folder, *arguments):
    """The exit status, standard error and largest memory in MB of a command
    of bin/urv."""
    result = run(folder, sys.executable, "-c", MEASURE, URV, *arguments)
    status, most_kb = map(int, result.stdout.split())
    return status, result.stderr, most_kb / 1024


@pytest.fixture
def urv(tmp_path):
    """Runs bin/urv in the test's folder."""
    def run_it(*arguments, **more):
        return run(tmp_path, URV, *arguments, **more)
    return run_it


def fly(folder, *arguments):
    """Fly, and leave record.csv, summary.json and events.jsonl."""
    result = run(folder, SIMULATION, "fly", "--quiet", "--record",
                 "record.csv", "--summary", "summary.json", "--events",
                 "events.jsonl", *arguments)
    assert (result.returncode, result.stderr) == (0, "")
    return folder


@pytest.fixture(scope="session")
def standard(tmp_path_factory):
    """The folder of the flight of `make fly`."""
    return fly(tmp_path_factory.mktemp("standard"), "--plant", "jsbsim",
               "--pilot", "standard")


@pytest.fixture(scope="session")
def brief(tmp_path_factory):
    """The same, 20 s of it."""
    return fly(tmp_path_factory.mktemp("brief"), "--plant", "jsbsim",
               "--pilot", "standard", "--seconds", "20")


CHROMIUM = (os.environ.get("URV_CHROMIUM") or shutil.which("chromium")
            or shutil.which("chromium-browser"))


def descendants():
    """The processes that this one has started, and theirs."""
    parents = {}
    for stat in Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):
            after_name = stat.read_text().rpartition(")")[2]
            parents[int(stat.parent.name)] = int(after_name.split()[1])
    found, new = set(), {os.getpid()}
    while new:
        new = {child for child, parent in parents.items() if parent in new}
        found |= new
    return found


def precede_others(*processes):
    """A page on a starved machine shows no data, for all is older than half a
    second (GND-25), and its input is dropped (GND-51). Where that is permitted,
    a browser and what is started after it therefore precede other programs,
    and so do their sessions, which Linux gives a priority of their own."""
    for process in processes:
        with contextlib.suppress(OSError):
            os.setpriority(os.PRIO_PROCESS, process, -10)
            Path(f"/proc/{process}/autogroup").write_text("-10")


@pytest.fixture(scope="session")
def browser():
    """A headless Chromium of the system, one for all tests: playwright can be
    started once only."""
    if CHROMIUM is None:
        pytest.skip("there is no Chromium: chromium is a Debian package")
    playwright = pytest.importorskip("playwright.sync_api")
    with playwright.sync_playwright() as tool:
        precede_others(os.getpid())
        browser = tool.chromium.launch(
            executable_path=CHROMIUM, args=["--no-sandbox"])
        precede_others(*descendants())
        yield browser
        browser.close()

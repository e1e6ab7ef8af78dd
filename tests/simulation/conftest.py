"""Runs bin/urv_sim for the tests and reads what it leaves behind.

    def test_something(fly):
        flight = fly("--seconds", "2", "--phase", "7")
        assert flight.summary["frames"] == 100
        assert flight.record["pwm.throttle"][-1] == 0x800
        up = [row for row in flight.wire if row.direction == "up"]

Each flight has a folder of its own; files a test hands in are written there
with `write`. The program under test is bin/urv_sim, or the one the
environment variable URV_SIM names.
"""

import csv
import json
import os
import subprocess
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

# Far longer than any flight of the tests takes; a hung program is a failure.
TIME_LIMIT_S = 300


class WireByte(NamedTuple):
    """One byte as it leaves the sender."""

    time_us: int
    direction: str
    byte: int


class Flight:
    """A finished run of `urv_sim fly` and its output files."""

    def __init__(self, folder, result):
        self.folder = folder
        self.status = result.returncode
        self.stdout = result.stdout
        self.stderr = result.stderr

    def path(self, name):
        return self.folder / name

    @property
    def summary(self):
        return json.loads(self.path("summary.json").read_text("utf-8"))

    @property
    def rows(self):
        """The flight record, a dictionary of numbers for each frame."""
        with self.path("record.csv").open(newline="", encoding="utf-8") as f:
            return [
                {name: int(value) for name, value in row.items()}
                for row in csv.DictReader(f)
            ]

    @property
    def record(self):
        """The flight record, a list of numbers for each column."""
        rows = self.rows
        return {name: [row[name] for row in rows] for name in rows[0]}

    @property
    def wire(self):
        """Every byte on the serial link, in order."""
        with self.path("wire.csv").open(newline="", encoding="utf-8") as f:
            return [
                WireByte(
                    int(row["time_us"]), row["direction"], int(row["byte"], 16)
                )
                for row in csv.DictReader(f)
            ]


def run_program(folder, *arguments):
    return subprocess.run(
        [PROGRAM, *map(str, arguments)],
        cwd=folder,
        capture_output=True,
        stdin=subprocess.DEVNULL,
        text=True,
        timeout=TIME_LIMIT_S,
        check=False,
    )


@pytest.fixture(scope="session", autouse=True)
def _program_is_built():
    if not PROGRAM.exists():
        pytest.exit(f"{PROGRAM} is not built: make test builds it", 2)


@pytest.fixture
def urv_sim(tmp_path):
    """Run the program with any arguments, in the test's folder."""

    def run(*arguments):
        return run_program(tmp_path, *arguments)

    return run


@pytest.fixture
def write(tmp_path):
    """Write an input file into the test's folder."""

    def write_file(name, text):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return name

    return write_file


@pytest.fixture
def fly(tmp_path):
    """Fly with these options, and every output; expect exit status 0.

    A second flight of the same test leaves its files in a folder named by
    `name`.
    """

    def run(*options, name="."):
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        # Input files lie in the test's folder, outputs in the flight's.
        outputs = []
        for option, file in (
            ("--record", "record.csv"),
            ("--summary", "summary.json"),
            ("--wire", "wire.csv"),
        ):
            outputs += [option, folder / file]
        result = run_program(tmp_path, "fly", *options, *outputs)
        assert result.returncode == 0, result.stderr
        return Flight(folder, result)

    return run

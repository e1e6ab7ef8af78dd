# SPDX-License-Identifier: Apache-2.0
"""Runs bin/urv_sim for the tests and reads its files.

    def test_something(fly):
        flight = fly("--seconds", "2", "--phase", "7")
        assert flight.summary["frames"] == 100
        assert flight.record["pwm.throttle"][-1] == 0x800
        up = [row for row in flight.wire if row.direction == "up"]

Each flight has a folder of its own; files a test hands in are written there
with `write`. `fly_in` flies in any folder, for flights that several tests
look at. The program under test is bin/urv_sim, or the one the environment
variable URV_SIM names.

Below that is the tests' knowledge of the words, from the requirements (BUF-1,
BUF-2, PWM-2) and not from the program: their order, the servos' transform of a
command, and scripts in which a row's words identify the row.
"""

import csv
import json
import os
import random
import subprocess
import sys
import tempfile
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "evidence" / "safety"), str(ROOT / "evidence")]

import monitor  # noqa: E402
from flight_numbers import (  # noqa: E402
    FRAME_MS,
    FRAMES_PER_S,  # noqa: F401
    NUMBERS,
)

PROGRAM = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

# Far longer than any flight of the tests takes; a hung program is a failure.
TIME_LIMIT_S = 900


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

    @cached_property
    def summary(self):
        return json.loads(self.path("summary.json").read_text("utf-8"))

    @cached_property
    def rows(self):
        """The flight record, a dictionary of numbers for each frame: whole
        ones, and decimals of what the aircraft really does."""
        with self.path("record.csv").open(newline="", encoding="utf-8") as f:
            lines = csv.reader(f)
            names = next(lines)
            kinds = [float if name.startswith("truth.") else int
                     for name in names]
            return [
                {name: kind(value) for name, kind, value
                 in zip(names, kinds, line, strict=True)}
                for line in lines
            ]

    @cached_property
    def record(self):
        """The flight record, a list of numbers for each column."""
        rows = self.rows
        return {name: [row[name] for row in rows] for name in rows[0]}

    @cached_property
    def wire(self):
        """Every byte on the serial link, in order."""
        with self.path("wire.csv").open(newline="", encoding="utf-8") as f:
            lines = csv.reader(f)
            assert next(lines) == ["time_us", "direction", "byte"]
            return [WireByte(int(time_us), direction, int(byte, 16))
                    for time_us, direction, byte in lines]

    @cached_property
    def events(self):
        """The error logs, a dictionary for each node and kind."""
        text = self.path("events.jsonl").read_text("utf-8")
        return {
            (event["node"], event["kind"]): event
            for event in map(json.loads, text.splitlines())
        }


def run_program(folder, *arguments):
    """Run the program; a flight goes through the safety monitor (SAF-9), with
    a record of its own when none is asked for."""
    arguments = list(map(str, arguments))
    options = options_of(arguments)
    record = options.get("--record")
    with tempfile.TemporaryDirectory() as aside:
        if arguments[:1] == ["fly"] and "--record" not in options:
            record = Path(aside) / "record.csv"
            arguments[1:1] = ["--record", str(record)]
        result = subprocess.run(
            [PROGRAM, *arguments],
            cwd=folder,
            capture_output=True,
            stdin=subprocess.DEVNULL,
            text=True,
            timeout=TIME_LIMIT_S,
            check=False,
        )
        if record and result.returncode == 0:
            must_be_safe(folder, record, options)
    return result


def options_of(arguments):
    """The options of a flight, by name: --option VALUE or --option=VALUE."""
    found = {}
    for place, argument in enumerate(arguments):
        if argument.startswith("--"):
            name, is_joined, value = argument.partition("=")
            found[name] = value if is_joined else (
                arguments[place + 1:place + 2] or [None])[0]
    return found


def must_be_safe(folder, record, options):
    """The safety monitor has nothing to say of the flight. Its wrong blocks
    are the link's, and the business of its tests."""
    path = folder / record
    if not path.is_file():
        return
    findings = monitor.check(path, **{
        name: folder / options[f"--{name}"]
        for name in ("sticks", "sensors", "faults", "conditions")
        if options.get(f"--{name}")},
        schedule=options.get("--schedule", "report"),
        drift=options.get("--drift"), lock="--lock" in options)
    assert findings.violations == [], "\n".join(findings.violations)


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


def fly_in(folder, *options, outputs_in=None):
    """Fly with these options, and every output; expect exit status 0.

    The options' files lie in the folder, the outputs there or elsewhere.
    """
    into = outputs_in or folder
    outputs = []
    for option, file in (
        ("--record", "record.csv"),
        ("--summary", "summary.json"),
        ("--wire", "wire.csv"),
        ("--events", "events.jsonl"),
    ):
        outputs += [option, into / file]
    result = run_program(folder, "fly", *options, *outputs)
    assert result.returncode == 0, result.stderr
    return Flight(into, result)


@pytest.fixture
def fly(tmp_path):
    """Fly with these options, and every output; expect exit status 0.

    A second flight of the same test leaves its files in a folder named by
    `name`.
    """

    def run(*options, name="."):
        folder = tmp_path / name
        folder.mkdir(exist_ok=True)
        return fly_in(tmp_path, *options, outputs_in=folder)

    return run


# --- what the tests know of the words --------------------------------------

SWITCHES = tuple(f"switch{n}" for n in range(1, 9))
COMMANDS = ("roll", "pitch", "yaw", "throttle", "brake", *SWITCHES)
SENSORS = tuple(
    """
    right_flap_1 left_flap_1 right_flap_2 left_flap_2
    right_aileron left_aileron right_elevator left_elevator
    right_rudder left_rudder alpha beta altitude_offset
    lateral_acceleration longitudinal_acceleration vertical_acceleration
    rpm battery_volts alternator_volts roll_attitude pitch_attitude
    roll_rate pitch_rate yaw_rate airspeed altitude uplink_signal_strength
    """.split()
)
FLAPS = ("left_flap_1", "right_flap_1", "left_flap_2", "right_flap_2")
SERVOS = (
    "left_aileron", "right_aileron", "left_elevator", "right_elevator",
    "left_rudder", "right_rudder", "steering", "throttle", "brake", *FLAPS,
    "discretes",
)
NEUTRAL = (0x800,) * 5 + (0,) * 8

TICK_US, FRAME_US = NUMBERS.tick_us, NUMBERS.frame_us
CHARACTER_US = NUMBERS.character_us

# Characters of a message: two a word, header and checksum. Those of an
# exchange: the ground's command and answer too, or the aircraft's answer.
UPLINK_CHARACTERS = 2 * (len(COMMANDS) + 1) + 2
DOWNLINK_CHARACTERS = 2 * (len(SENSORS) + 1) + 2
EXCHANGE = {"up": UPLINK_CHARACTERS + 2, "down": DOWNLINK_CHARACTERS + 1}

# The middle and the ends of a converter's range, and beside the middle.
EDGES = (0, 0x7FF, 0x800, 0x801, 0xFFF)


def transformed(commands):
    """The PWM board's words for 13 command words (PWM-2, D-2, D-8)."""
    roll, pitch, yaw, throttle, brake, *switches = commands
    flaps = 0xFFF if switches[7] >= 0x800 else 0x800
    discretes = sum(
        1 << bit for bit, word in enumerate(switches) if word >= 0x800
    )
    return (
        roll, roll, pitch, pitch, yaw, yaw, yaw, throttle, brake,
        flaps, flaps, flaps, flaps, discretes,
    )


def different_rows(count, width, seed):
    """Rows of words, no two alike."""
    words = random.Random(seed)
    return list(dict.fromkeys(
        tuple(words.randrange(0x1000) for _ in range(width))
        for _ in range(count)
    ))


def script(names, rows, first_ms):
    """A CSV script of one row for each frame."""
    lines = ["time_ms," + ",".join(names)]
    lines += [
        f"{first_ms + FRAME_MS * place}," + ",".join(map(str, row))
        for place, row in enumerate(rows)
    ]
    return "\n".join(lines) + "\n"


def columns(flight, group, names):
    """A group of the record's columns, one tuple of words a frame."""
    return list(zip(
        *(flight.record[f"{group}.{name}"] for name in names), strict=True
    ))


class Message(NamedTuple):
    """A message as its sender sent it."""

    time_us: int
    direction: str
    kind: str
    data: tuple


# Headers (docs/link.md), and the whole length of their messages.
HEADERS = {
    0x1E: ("uplink", UPLINK_CHARACTERS),
    0x87: ("downlink", DOWNLINK_CHARACTERS),
    0x4B: ("command", 1),
    0xD2: ("good", 1),
    0x2D: ("good, wants", 1),
    0xCC: ("bad", 1),
    0x33: ("bad, wants", 1),
}


def messages(wire):
    """The messages on the wire, in the order in which they began. A sender
    finishes what it began, whatever the line does to it."""
    found = []
    for direction in ("up", "down"):
        line = [item for item in wire if item.direction == direction]
        place = 0
        while place < len(line):
            kind, length = HEADERS[line[place].byte]
            found.append(Message(
                line[place].time_us, direction, kind,
                tuple(i.byte for i in line[place:place + length]),
            ))
            place += length
    return sorted(found)

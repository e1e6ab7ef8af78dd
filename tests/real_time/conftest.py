# SPDX-License-Identifier: Apache-2.0
"""Runs bin/urv_mcs and bin/urv_gsc for the tests, and reads what they leave.

    def test_something(partitions, write):
        flight = partitions.fly(seconds=2, sticks=write("s.csv", text))
        assert flight.gsc.summary["frames"] == 100

Judged is what the nodes did, not when: the machine may be slow. A flight may
not show its result on a machine that ran a partition late; such a test calls
`need`, and flies again. Forbidden events are asserted, for every flight. At
the end of each test the records of its flights go through the safety monitor
(SAF-9). The programs are those in bin, or in the folder that URV_PARTITIONS
names; the simulation they are compared with is bin/urv_sim, or what URV_SIM
names.
"""

import csv
import functools
import json
import os
import random
import select
import signal
import subprocess
import sys
import threading
import time
import tty
from functools import cached_property
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = Path(os.environ.get("URV_PARTITIONS", ROOT / "bin")).resolve()
PROGRAMS = {name: FOLDER / f"urv_{name}" for name in ("mcs", "gsc")}
SIMULATION = Path(os.environ.get("URV_SIM", ROOT / "bin" / "urv_sim")).resolve()

sys.path[:0] = [str(ROOT / "evidence" / "safety"), str(ROOT / "tests")]

import monitor  # noqa: E402
from ports import free_ports  # noqa: E402
from timelines import FRAME_US  # noqa: E402

from peer import be_prompt  # noqa: E402

# Far longer than any run of the tests; a hung program is a failure.
TIME_LIMIT_S = 900

SWITCHES = tuple(f"switch{n}" for n in range(1, 9))
COMMANDS = ("roll", "pitch", "yaw", "throttle", "brake", *SWITCHES)

# Until a scan says otherwise: neutral, throttle idle, brake on, switches off.
SAFE_COMMANDS = (0x800,) * 3 + (0, 0xFFF) + (0,) * 8

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
SERVOS = (
    "left_aileron", "right_aileron", "left_elevator", "right_elevator",
    "left_rudder", "right_rudder", "steering", "throttle", "brake",
    "left_flap_1", "right_flap_1", "left_flap_2", "right_flap_2",
    "discretes",
)


def udp(own, other):
    return f"udp:127.0.0.1:{own}:127.0.0.1:{other}"


class RanLate(Exception):
    """A flight did not show what it was to, on a machine that was late."""


# When a clock ticks so late, in us, characters on the line were as late: boards
# that wait for each other for 1.9 ms may have given up.
LATE_TICK_US = 1_000


def ran_late(outputs):
    """True if the partition itself says that the machine ran it late."""
    summary = outputs.summary
    return bool(summary["overruns"] or summary["stood_still"]
                or summary["link"]["board_restarts"]
                or summary["release_jitter_us"]["max"] > LATE_TICK_US)


def need(shown, *flown):
    """The required result of a flight, given the outputs of its partitions."""
    if not shown and any(map(ran_late, flown)):
        raise RanLate
    assert shown


# The most flights of a test whose flights show nothing, and the latest start
# of one.
MOST_FLIGHTS = 25
LAST_FLIGHT_S = 120


def flies_again(test):
    """A test that flies again when the machine was late. It is skipped when
    no flight shows anything: then nothing can be said."""

    @functools.wraps(test)
    def fly(*arguments, **fixtures):
        until = time.monotonic() + LAST_FLIGHT_S
        for _ in range(MOST_FLIGHTS):
            try:
                return test(*arguments, **fixtures)
            except RanLate:
                if time.monotonic() > until:
                    break
        return pytest.skip("the machine was late in every flight")

    return fly


# A partition's messages about the machine and the line's time, not about the
# other node.
STOOD_STILL = ": stood still before "
NO_PRIORITIES = ": no real-time priorities: "
OF_THE_MACHINE = (
    STOOD_STILL, ": round trip ", ": answers come ", NO_PRIORITIES)


def of_the_link(said):
    """The lines of standard error about the link and the other node."""
    return [line for line in said.splitlines()
            if not any(each in line for each in OF_THE_MACHINE)]


# The exit status of a run without a fault, and of one whose peer was never
# heard (RTP-7).
HEARD, UNHEARD = 0, 3


class Outputs:
    """The files that a program left in its folder."""

    def __init__(self, folder):
        self.folder = folder

    @cached_property
    def summary(self):
        return json.loads((self.folder / "summary.json").read_text("utf-8"))

    @cached_property
    def events(self):
        lines = (self.folder / "events.jsonl").read_text("utf-8")
        return {
            event["kind"]: event
            for event in map(json.loads, lines.splitlines())
        }

    @cached_property
    def rows(self):
        with (self.folder / "record.csv").open(encoding="utf-8") as file:
            return [
                {name: (float if name.startswith("truth.") else int)(value)
                 for name, value in row.items()}
                for row in csv.DictReader(file)
            ]

    def words(self, group, names):
        """A group of the record's columns, a tuple of words a row."""
        return [
            tuple(row[f"{group}.{name}"] for name in names)
            for row in self.rows
        ]


class Run:
    """A partition that runs."""

    def __init__(self, node, folder, link, *options, quiet=True):
        folder.mkdir(exist_ok=True)
        self.node = node
        self.schedule = "fast" if "fast" in options else "report"
        self.outputs = Outputs(folder)

        # When it was told to do something, in us of the monotonic clock.
        self.told = []
        self.program = subprocess.Popen(
            [
                PROGRAMS[node], "--link", link,
                *(["--quiet"] if quiet else []),
                "--record", folder / "record.csv",
                "--summary", folder / "summary.json",
                "--events", folder / "events.jsonl",
                *map(str, options),
            ],
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def await_begin(self):
        """Wait until it has its link and its outputs."""
        deadline = time.monotonic() + TIME_LIMIT_S
        while not (self.outputs.folder / "record.csv").exists():
            assert self.program.poll() is None
            assert time.monotonic() < deadline
            time.sleep(0.01)

    def say_line(self):
        """The next line that it says of the link on standard error."""
        lines = []

        def read():
            while not of_the_link("".join(lines[-1:])):
                lines.append(self.program.stderr.readline())
                if not lines[-1]:
                    break

        reader = threading.Thread(target=read, daemon=True)
        reader.start()
        reader.join(TIME_LIMIT_S)
        assert lines and not reader.is_alive(), "it says nothing"
        return lines[-1].rstrip("\n")

    def send(self, which):
        self.told.append((which, time.monotonic_ns() // 1000))
        self.program.send_signal(which)

    def end(self):
        """Wait for the end of the program, which is to be a good one."""
        out, err = self.program.communicate(timeout=TIME_LIMIT_S)
        assert (self.program.returncode, err) == (self.good_status(), "")
        return self.outputs

    def good_status(self):
        """The exit status of a run without a fault."""
        state = self.outputs.summary["link"]["state"]
        return UNHEARD if state == "never heard" else HEARD

    def stop(self):
        self.send(signal.SIGTERM)
        return self.end()


def wait_for_line(run, what):
    """It says so, some time."""
    while what not in (line := run.say_line()):
        assert line, "it has ended"
    return line


@pytest.fixture(scope="session", autouse=True)
def _programs_are_built():
    for program in (*PROGRAMS.values(), SIMULATION):
        if not program.exists():
            pytest.exit(f"{program} is not built: make test builds it", 2)


RESTARTS = ("processor_restart", "warm_reset")

# The link's counts of errors.
TROUBLES = ("_bad", "_scrapped", "_resets")


def starts_of(run):
    """The warm starts of a node: those that it was told to make, and those
    that its log has."""
    on_us = run.outputs.summary["switched_on_us"]
    ordered = [
        at for which, at in run.told
        if which in (signal.SIGUSR1, signal.SIGUSR2, signal.SIGCONT)
    ]
    logged = [
        on_us + 1000 * run.outputs.events[kind][when]
        for kind in RESTARTS if kind in run.outputs.events
        for when in ("first_ms", "last_ms")
    ]
    return [(run.node, at) for at in ordered + logged]


def disturbed_of(run):
    """The times in which a node's board met with trouble on the link."""
    rows = run.outputs.rows
    counts = [name for name in (rows[0] if rows else ())
              if name.startswith("link.") and name.endswith(TROUBLES)]
    return [
        (before["clock_us"] - FRAME_US, row["clock_us"] + FRAME_US)
        for before, row in zip(rows, rows[1:])
        if any(row[name] != before[name] for name in counts)
    ]


def known_of(runs):
    """The safety monitor's inputs about a flight's nodes."""
    return {
        "starts": [start for run in runs for start in starts_of(run)],
        "disturbed": [span for run in runs for span in disturbed_of(run)],
        "schedule": runs[0].schedule,
    }


def assert_safe(runs):
    """The safety monitor's findings about the flight. A program that a test
    has killed left no whole record."""
    ended = [run for run in runs
             if run.program.returncode in (HEARD, UNHEARD)]
    by_node = {
        node: [run for run in ended if run.node == node] for node in PROGRAMS
    }
    flights = (
        [ended] if all(len(each) == 1 for each in by_node.values())
        else [[run] for run in ended]
    )
    for flight in flights:
        findings = monitor.check_partitions(
            **{run.node: run.outputs.folder / "record.csv" for run in flight},
            **known_of(flight),
        )
        # The records of a late machine are incomplete: a block sent in a frame
        # without a row looks like one that nobody sent.
        if not any(ran_late(run.outputs) for run in flight):
            assert findings.violations == []


@pytest.fixture
def start(tmp_path):
    """Start a partition; whatever still runs at the end is killed."""
    runs = []

    def begin(node, link, *options, quiet=True):
        run = Run(node, tmp_path / f"{node}{len(runs)}", link, *options,
                  quiet=quiet)
        runs.append(run)
        return run

    yield begin
    for run in runs:
        if run.program.poll() is None:
            run.program.kill()
            run.program.wait()
    assert_safe(runs)


@pytest.fixture
def start_both(start):
    """Start both nodes on one link."""

    def begin(links=None, mcs=(), gsc=()):
        if links is None:
            up, down = free_ports(2)
            links = udp(up, down), udp(down, up)
        return (
            start("mcs", links[0], "--phase", 3, *mcs),
            start("gsc", links[1], "--phase", 0, *gsc),
        )

    return begin


@pytest.fixture
def write(tmp_path):
    def write_file(name, text):
        (tmp_path / name).write_text(text, encoding="utf-8")
        return tmp_path / name

    return write_file


@pytest.fixture
def simulate(tmp_path):
    """The simulation's results for the same scripts."""

    def run(*options):
        folder = tmp_path / "simulation"
        folder.mkdir(exist_ok=True)
        result = subprocess.run(
            [
                SIMULATION, "fly", "--quiet",
                "--record", folder / "record.csv", *map(str, options),
            ],
            capture_output=True, text=True, timeout=TIME_LIMIT_S,
            check=False,
        )
        assert result.returncode == 0, result.stderr
        return Outputs(folder)

    return run


class TerminalPair:
    """Two serial devices, what is written to one comes out of the other."""

    def __init__(self):
        pairs = [os.openpty() for _ in range(2)]
        self._masters = [master for master, _ in pairs]
        self._slaves = [slave for _, slave in pairs]
        self.devices = [os.ttyname(slave) for slave in self._slaves]
        for slave in self._slaves:
            tty.setraw(slave)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._carry, daemon=True)
        self._thread.start()

    def _carry(self):
        be_prompt()
        one, other = self._masters
        to = {one: other, other: one}
        while not self._ended.is_set():
            ready, _, _ = select.select(self._masters, [], [], 0.1)
            for master in ready:
                try:
                    os.write(to[master], os.read(master, 4096))
                except OSError:
                    pass

    def close(self):
        self._ended.set()
        self._thread.join()
        for file in (*self._masters, *self._slaves):
            os.close(file)


@pytest.fixture
def terminals():
    pair = TerminalPair()
    yield pair
    pair.close()


# Each row of a script is held for this time, the first from here on: away from
# the moments at which a node looks. On a machine that is too slow for the
# first, the next is tried.
HOLDS_MS = (120, 400, 1_000)
FIRST_MS = 250


def different_rows(count, width, seed):
    """Rows of converter words, no two alike."""
    words = random.Random(seed)
    return list(dict.fromkeys(
        tuple(words.randrange(0x1000) for _ in range(width))
        for _ in range(count)
    ))


def script(names, rows, hold_ms=HOLDS_MS[0]):
    lines = ["time_ms," + ",".join(names)]
    lines += [
        f"{FIRST_MS + hold_ms * place}," + ",".join(map(str, row))
        for place, row in enumerate(rows)
    ]
    return "\n".join(lines) + "\n"


def script_seconds(rows, hold_ms=HOLDS_MS[0]):
    """How long such a script and a little more take."""
    return (FIRST_MS + hold_ms * (len(rows) + 2)) / 1000


def assert_in_order(found, expected):
    """Nothing was found but what is expected, in its order."""
    places = [expected.index(words) for words in found]
    assert places == sorted(places)


def in_turn(words):
    """The order of the values, without their durations."""
    return [
        word for place, word in enumerate(words)
        if place == 0 or words[place - 1] != word
    ]

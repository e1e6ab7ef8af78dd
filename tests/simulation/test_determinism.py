# SPDX-License-Identifier: Apache-2.0
"""SIM-1: the same command gives the same bytes, whatever the clock on the
wall."""

import pytest
from conftest import COMMANDS, SENSORS, different_rows, script

FAULTS = """\
100 up flip 3 1
110 cut 35.5
300 down drop 17
333.333 up drop 1
400 down flip 2 1ff
"""

COMMAND_LINES = {
    "neutral": (),
    "scripts": ("--sticks", "sticks.csv", "--sensors", "sensors.csv"),
    "faults": ("--sticks", "sticks.csv", "--sensors", "sensors.csv",
               "--faults", "faults.txt"),
    "phase and seed": ("--phase", "8", "--seed", "99",
                       "--faults", "faults.txt"),
    "processors": ("--sticks", "sticks.csv", "--processors", "2"),
    "in step": ("--sticks", "sticks.csv", "--lock", "--drift", "-77"),
    "fast": ("--sticks", "sticks.csv", "--schedule", "fast"),
}


@pytest.fixture
def inputs(write):
    write("sticks.csv", script(COMMANDS, different_rows(50, 13, seed=5), 3))
    write("sensors.csv", script(SENSORS, different_rows(50, 27, seed=6), 9))
    write("faults.txt", FAULTS)


def outputs(flight):
    """The bytes of each output; in the summary, all but the speed."""
    summary = flight.path("summary.json").read_text().splitlines(True)
    lines = [line for line in summary if '"speed"' not in line]
    assert len(lines) == len(summary) - 1
    return {
        "record": flight.path("record.csv").read_bytes(),
        "wire": flight.path("wire.csv").read_bytes(),
        "events": flight.path("events.jsonl").read_bytes(),
        "summary": "".join(lines),
    }


@pytest.mark.parametrize("options", COMMAND_LINES.values(),
                         ids=COMMAND_LINES.keys())
def test_same_command_same_bytes(fly, inputs, options):
    options = (*options, "--seconds", "1.5")
    first = outputs(fly(*options, name="first"))
    second = outputs(fly(*options, name="second"))
    for name in first:
        assert first[name] == second[name], name


def test_outputs_do_not_depend_on_each_other(fly, urv_sim, inputs, tmp_path):
    options = (*COMMAND_LINES["faults"], "--seconds", "1")
    together = outputs(fly(*options))
    for name, option in (("record", "--record"), ("wire", "--wire"),
                         ("events", "--events")):
        assert urv_sim("fly", *options, "--quiet", option,
                       "alone").returncode == 0
        assert (tmp_path / "alone").read_bytes() == together[name], name


def test_realtime_flies_the_same_flight(fly, inputs):
    options = (*COMMAND_LINES["faults"], "--seconds", "1")
    fast = fly(*options, name="fast")
    slow = fly(*options, "--pace", "realtime", name="slow")
    assert outputs(fast) == outputs(slow)
    # Real time is kept: not ahead of the clock.
    assert slow.summary["speed"] <= 1.1

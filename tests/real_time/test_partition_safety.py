# SPDX-License-Identifier: Apache-2.0
"""SAF-9: flights of both partitions pass the safety monitor. Their rows are
joined by the machine's clock, and how late they were is measured from it."""

import signal
import sys
import time

import pytest

from conftest import (
    COMMANDS, ROOT, RanLate, different_rows, flies_again, known_of, need,
    ran_late, script, script_seconds,
)
from peer import UPLINK, data_message

sys.path.insert(0, str(ROOT / "evidence" / "safety"))

import monitor  # noqa: E402

STICKS = different_rows(20, len(COMMANDS), 5)


def findings(mcs, gsc):
    """The records of two runs that are over. Nothing disturbs their link but a
    machine that runs them late."""
    runs = [mcs, gsc]
    known = known_of(runs)
    if not any(ran_late(run.outputs) for run in runs):
        known["disturbed"] = []
    return monitor.check_partitions(
        gsc=gsc.outputs.folder / "record.csv",
        mcs=mcs.outputs.folder / "record.csv", **known)


def serial(terminals):
    return [f"serial:{device}" for device in terminals.devices]


@pytest.mark.parametrize("line", ["udp", "serial"])
@flies_again
def test_saf9_a_flight_of_both_nodes_has_no_violation(
    start_both, write, terminals, line
):
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    seconds = script_seconds(STICKS)
    runs = start_both(
        None if line == "udp" else serial(terminals),
        mcs=("--seconds", seconds),
        gsc=("--seconds", seconds, "--sticks", sticks))
    mcs, gsc = (run.end() for run in runs)
    found = findings(*runs)
    assert found.violations == []
    # A block that is late on a late line looks like one.
    need(found.wrong_blocks == [], mcs, gsc)
    assert found.rows == len(mcs.rows) + len(gsc.rows) > 0


@flies_again
def test_saf4_saf9_the_monitor_lets_no_command_of_before_power_up_pass(
    start, write, terminals
):
    """A ground that was there before has left a message on the line."""
    old, young = different_rows(2, len(COMMANDS), 6)
    links = serial(terminals)
    with open(terminals.devices[1], "wb", buffering=0) as line:
        line.write(data_message(UPLINK, (*old, 0)))
    # The aircraft first: another command directly after it makes that one bad.
    aircraft = start("mcs", links[0], "--phase", 3, "--seconds", 1.5)
    aircraft.await_begin()
    time.sleep(0.2)
    runs = aircraft, start(
        "gsc", links[1], "--seconds", 1.5, "--sticks", write(
            "young.csv", script(COMMANDS, [young])))
    mcs, gsc = (run.end() for run in runs)
    assert old not in mcs.words("mcs.uplink", COMMANDS)

    # The time for which a late machine kept a message on the line is unknown.
    need(findings(*runs).violations == [], mcs, gsc)


@flies_again
def test_saf9_warm_starts_in_flight_have_no_violation(
    start_both, write
):
    """A start makes no task overrun; a machine that is late does."""
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    seconds = script_seconds(STICKS)
    mcs, gsc = start_both(
        mcs=("--seconds", seconds),
        gsc=("--seconds", seconds, "--sticks", sticks))
    mcs.await_begin()
    gsc.await_begin()
    for run, which in ((mcs, signal.SIGUSR1), (gsc, signal.SIGUSR2),
                       (mcs, signal.SIGUSR2), (gsc, signal.SIGUSR1)):
        time.sleep(0.4)
        if run.program.poll() is None:
            run.send(which)
    for run in (mcs, gsc):
        run.end()
    found = findings(mcs, gsc).violations
    if found and any(run.outputs.summary["overruns"] for run in (mcs, gsc)):
        raise RanLate
    assert found == []

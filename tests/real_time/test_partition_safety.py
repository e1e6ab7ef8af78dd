"""SAF-9: flights of both partitions pass the safety monitor. Their rows are
joined by the machine's clock, and how late they were is measured from it."""

import signal
import sys
import time

import pytest

from conftest import COMMANDS, ROOT, different_rows, script, script_seconds

sys.path.insert(0, str(ROOT / "scripts" / "safety"))

import monitor  # noqa: E402

STICKS = different_rows(20, len(COMMANDS), 5)


def findings(mcs, gsc, **known):
    return monitor.check_partitions(
        gsc=gsc.folder / "record.csv", mcs=mcs.folder / "record.csv", **known)


def serial(terminals):
    return [f"serial:{device}" for device in terminals.devices]


@pytest.mark.parametrize("line", ["udp", "serial"])
def test_saf9_a_flight_of_both_nodes_has_no_violation(
    start_both, write, terminals, line
):
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    seconds = script_seconds(STICKS)
    mcs, gsc = (run.end() for run in start_both(
        None if line == "udp" else serial(terminals),
        mcs=("--seconds", seconds),
        gsc=("--seconds", seconds, "--sticks", sticks)))
    found = findings(mcs, gsc)
    assert found.violations == []
    assert found.wrong_blocks == []
    assert found.rows == len(mcs.rows) + len(gsc.rows) > 0


def test_saf4_saf9_the_monitor_lets_no_command_of_before_power_up_pass(
    start, start_both, write, terminals
):
    """A ground that was there before has filled the line."""
    old, young = different_rows(2, len(COMMANDS), 6)
    links = serial(terminals)
    before = start("gsc", links[1], "--seconds", 0.5, "--sticks", write(
        "old.csv", script(COMMANDS, [old]).replace("\n250,", "\n0,")))
    assert before.end().summary["frames"] == 25
    mcs, gsc = (run.end() for run in start_both(
        links, mcs=("--seconds", 1.5),
        gsc=("--seconds", 1.5, "--sticks", write(
            "young.csv", script(COMMANDS, [young])))))
    assert findings(mcs, gsc).violations == []


def test_saf9_warm_starts_in_flight_have_no_violation(
    start_both, write
):
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    seconds = script_seconds(STICKS)
    mcs, gsc = start_both(
        mcs=("--seconds", seconds),
        gsc=("--seconds", seconds, "--sticks", sticks))
    starts = []
    mcs.await_begin()
    gsc.await_begin()
    for node, run, which in (("mcs", mcs, signal.SIGUSR1),
                             ("gsc", gsc, signal.SIGUSR2),
                             ("mcs", mcs, signal.SIGUSR2),
                             ("gsc", gsc, signal.SIGUSR1)):
        time.sleep(0.4)
        if run.program.poll() is None:
            starts.append((node, time.monotonic_ns() // 1000))
            run.send(which)
    mcs, gsc = mcs.end(), gsc.end()
    assert findings(mcs, gsc, starts=starts).violations == []

# SPDX-License-Identifier: Apache-2.0
"""RTP-1, D-9: both partitions fly together, and do what the simulation does."""

import statistics

import pytest

from conftest import (
    COMMANDS, FRAME_US, HOLDS_MS, SAFE_COMMANDS, SENSORS, SERVOS,
    assert_in_order, different_rows, flies_again, free_ports, in_turn, need, script,
    script_seconds, udp,
)
from peer import NUMBERS

STICKS = different_rows(24, len(COMMANDS), 1)
MEASURED = different_rows(24, len(SENSORS), 2)


def fly_scripts(start_both, write, hold_ms, links=None, processors=1):
    sticks = write("sticks.csv", script(COMMANDS, STICKS, hold_ms))
    sensors = write("sensors.csv", script(SENSORS, MEASURED, hold_ms))
    seconds = script_seconds(STICKS, hold_ms)
    runs = start_both(
        links,
        mcs=("--seconds", seconds, "--sensors", sensors,
             "--processors", processors),
        gsc=("--seconds", seconds, "--sticks", sticks,
             "--processors", processors),
    )
    mcs, gsc = (run.end() for run in runs)
    return mcs, gsc, ("--seconds", seconds, "--sticks", sticks,
                      "--sensors", sensors)


def have_same_contents(mcs, gsc, simulated):
    """Never anything else than in the simulation, or in another order. True if
    everything is there: a machine that pauses for longer than a row is held
    leaves some out."""
    complete = True
    for node, group, names in (
        (gsc, "console", COMMANDS),
        (gsc, "gsc.uplink", COMMANDS),
        (mcs, "mcs.uplink", COMMANDS),
        (mcs, "pwm", SERVOS),
        (mcs, "mcs.downlink", SENSORS),
        (gsc, "gsc.downlink", SENSORS),
    ):
        flown = in_turn(node.words(group, names))
        expected = in_turn(simulated.words(group, names))
        assert len(expected) >= 24

        # A first scan that is late leaves what is safe.
        if names is COMMANDS and flown[:1] == [SAFE_COMMANDS]:
            del flown[0]
        elif names is COMMANDS and flown[1:2] == [SAFE_COMMANDS]:
            assert flown.pop(0) == (0,) * len(COMMANDS)
            del flown[0]
        assert_in_order(flown, expected)

        # The first and last frames depend on the nodes' start times.
        complete = complete and set(expected[3:-1]) <= set(flown)
    return complete


def assert_same_contents(start_both, write, simulate, links=None,
                         processors=1):
    for hold_ms in HOLDS_MS:
        mcs, gsc, options = fly_scripts(start_both, write, hold_ms, links,
                                        processors)
        if have_same_contents(mcs, gsc, simulate(*options)):
            return
    # Contents were left out, however long they were there.
    need(False, mcs, gsc)


@flies_again
@pytest.mark.parametrize("processors", [1, 2, 3, 4])
def test_lnk1_d9_a_flight_over_udp_has_the_contents_of_the_simulations(
    start_both, write, simulate, processors
):
    """On one processor a node to four (EXT-4)."""
    assert_same_contents(start_both, write, simulate, processors=processors)


@flies_again
def test_lnk1_a_flight_over_a_serial_line_has_them_too(
    start_both, write, simulate, terminals
):
    links = [f"serial:{device}" for device in terminals.devices]
    assert_same_contents(start_both, write, simulate, links)


@flies_again
def test_rtp1_a_node_without_a_script_moves_its_surfaces(start_both, write):
    """The bench: surfaces follow the servos."""
    sticks = write("sticks.csv", "time_ms,roll\n300,4000\n")
    mcs, gsc = (
        run.end() for run in start_both(
            mcs=("--seconds", 2),
            gsc=("--seconds", 2, "--sticks", sticks),
        )
    )
    ailerons = [words for words, in gsc.words("gsc.downlink",
                                              ("left_aileron",))]
    need(0x800 in ailerons and ailerons[-1] > 3900, mcs, gsc)
    after = ailerons[ailerons.index(0x800):]
    assert sorted(after) == after


@flies_again
def test_frm1_each_frame_has_its_row(start_both):
    mcs, gsc = (
        run.end() for run in start_both(
            mcs=("--seconds", 1.5), gsc=("--seconds", 1.5)
        )
    )
    for node, name in ((mcs, "mcs"), (gsc, "gsc")):
        frames = [row["frame"] for row in node.rows]
        assert frames == sorted(set(frames))
        assert all(
            row["time_ms"] == FRAME_US // 1000 * (row["frame"] + 1)
            for row in node.rows
        )
        assert node.summary["rows_left_out"] == 0
        assert f"link.{name}_resets" in node.rows[0]
        assert node.summary["frames"] == frames[-1] + 1 >= 75
        need(node.summary["frames"] == 75 and node.summary["seconds"] == 1.5,
             node)


@flies_again
def test_rtp2_the_times_of_the_summary_are_those_of_the_record(start):
    """The record has when the servos were commanded: in each frame as long
    after the tick in which they are, as the summary calls the response. A few
    late frames do not change the median."""
    own, other = free_ports(2)
    mcs = start("mcs", udp(own, other), "--seconds", 5).end()
    commanded = [(row["servos_us"], row["frame"]) for row in mcs.rows]
    tick_us = NUMBERS.servo_tick * NUMBERS.tick_us
    on_us = mcs.summary["switched_on_us"]
    at = [
        time - FRAME_US * frame - on_us - tick_us
        for (time, frame), (before, _) in zip(commanded[1:], commanded)
        if time != before
    ]
    response = mcs.summary["response_us"]["pwm_task"]
    found, written = statistics.median(at), response["median"]
    need(found / 1.5 - 10 <= written <= found * 1.5 + 10, mcs)

    cost = mcs.summary["cost_us"]["pwm_task"]
    need(response["measured"] == cost["measured"] >= len(at), mcs)
    for which in ("min", "median"):
        assert 0 < cost[which] <= response[which]

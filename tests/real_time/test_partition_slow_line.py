# SPDX-License-Identifier: Apache-2.0
"""RTP-4, LNK-11: partitions over a network, which is slower than a wire.

The network is slow_line.py. It is never quicker than it says, but where the
partitions or the network ran late, an answer may be taken for that to the next
poll.
"""

import re

import pytest

from conftest import (
    HEARD, TIME_LIMIT_S, UNHEARD, RanLate, flies_again, free_ports, need,
)
from slow_line import SlowLine

SECONDS = 3
FRAMES = SECONDS * 50

# When the network of the test was so late, the line was slower than it says.
LATE_NETWORK_S = 0.0005

# The measurement is accurate to a character.
CHARACTER_US = 96


def fly(start, delay_ms, *options):
    """Both nodes over a network: their outputs and what they said."""
    with SlowLine(free_ports(4), delay_ms / 1000) as line:
        runs = [
            start(node, link, "--phase", phase, "--seconds", SECONDS,
                  *options, quiet=False)
            for node, link, phase in (("mcs", line.aircraft, 5),
                                      ("gsc", line.ground, 0))
        ]
        said = [run.program.communicate(timeout=TIME_LIMIT_S) for run in runs]
    for run in runs:
        heard = run.outputs.summary["link"]["state"] != "never heard"
        assert run.program.returncode == (HEARD if heard else UNHEARD), said
    mcs, gsc = (run.outputs for run in runs)
    return line, mcs, gsc, said


def need_of_line(shown, line, *flown):
    """The required result of a flight on a machine that is in time."""
    if not shown and line.latest_s > LATE_NETWORK_S:
        raise RanLate
    need(shown, *flown)


def lines_with(text, what):
    return [line for line in text.splitlines() if what in line]


@flies_again
def test_rtp4_a_slow_line_flies_with_its_delay(start):
    line, mcs, gsc, said = fly(start, 1.2, "--line-delay", 1.3)
    for node in (mcs, gsc):
        link = node.summary["link"]
        assert link["line_delay_us"] == 1300
        need_of_line(
            link["round_trip_us"]["measured"] == 0
            or link["round_trip_us"]["min"] >= 2400 - CHARACTER_US,
            line, mcs, gsc)
    need_of_line(
        gsc.summary["link"]["downlink_received"] > 0.9 * FRAMES
        and mcs.summary["link"]["uplink_received"] > 0.9 * FRAMES
        and gsc.summary["link"]["late_answers"] == 0, line, mcs, gsc)
    assert lines_with(said[1][1], "round trip ")


@flies_again
def test_rtp4_a_line_beyond_the_timers_is_reported_with_its_remedy(start):
    line, mcs, gsc, said = fly(start, 1.0)
    too_late = lines_with(said[1][1], "answers come too late at ")
    need_of_line(
        gsc.summary["link"]["downlink_received"] < FRAMES / 2
        and gsc.summary["link"]["late_answers"] > FRAMES / 4
        and len(too_late) == 1
        and "give both nodes --line-delay 1." in too_late[0],
        line, mcs, gsc)


@flies_again
def test_rtp4_a_line_beyond_every_delay_is_reported_by_both(start):
    line, mcs, gsc, said = fly(start, 3.0)
    too_late = lines_with(said[1][1], "answers come too late at ")
    unheard = lines_with(said[0][1], "the ground asks for no downlink at ")
    need_of_line(
        gsc.summary["link"]["downlink_received"] < FRAMES / 2
        and mcs.summary["link"]["uplink_received"] > FRAMES / 2
        and len(too_late) == 1 and len(unheard) == 1, line, mcs, gsc)
    found = re.search(r"round trip (\d+(?:\.\d)?) ms, the board waits for up"
                      r" to 1\.5 ms; no --line-delay \(0 to 1\.392\)",
                      too_late[0])
    assert found and float(found[1]) >= 5.9


@flies_again
def test_rtp4_the_round_trip_of_a_wire_is_measured_by_both(start):
    line, mcs, gsc, said = fly(start, 0.4)
    for node, (out, _) in zip((mcs, gsc), said):
        times = node.summary["link"]["round_trip_us"]
        need_of_line(times["measured"] > FRAMES / 2, line, mcs, gsc)
        need_of_line(times["min"] >= 800 - CHARACTER_US, line, mcs, gsc)
        need_of_line(times["median"] < 1400, line, mcs, gsc)
        shown = re.search(r", round trip (\d+(?:\.\d)?) ms$", out, re.M)
        assert shown and float(shown[1]) >= 0.7
        assert node.summary["link"]["late_answers"] >= 0


@pytest.mark.parametrize("node", ["mcs", "gsc"])
@pytest.mark.parametrize("value", ["1.393", "-1", "1.0001", "x", "1e-3"])
def test_rtp4_a_delay_without_room_is_refused_with_the_range(
        start, node, value):
    run = start(node, "udp:127.0.0.1:1:127.0.0.1:1", "--line-delay", value)
    out, err = run.program.communicate(timeout=TIME_LIMIT_S)
    assert (run.program.returncode, out) == (2, "")
    assert err.startswith(f'urv_{node}: --line-delay: "{value}" is not a'
                          " number of milliseconds from 0 to 1.392")
    assert err.count("\n") == 1

# SPDX-License-Identifier: Apache-2.0
"""RTP-2: a partition ends and restarts on a signal.
"""

import os
import signal
import subprocess
import time

import pytest

from conftest import (
    COMMANDS, FRAME_US, PROGRAMS, SENSORS, SERVOS, TIME_LIMIT_S, different_rows,
    flies_again, free_ports, in_turn, need, script, udp,
)
from peer import AircraftPeer, GroundPeer

FAR_LONGER_S = 1000


def await_rows(run, number):
    """Wait until the program has made a number of rows: it writes late, so the
    length of the run counts."""
    run.await_begin()
    time.sleep(number * FRAME_US / 1e6 + 0.3)
    assert run.program.poll() is None


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
@flies_again
def test_a_signal_ends_a_run_with_whole_outputs(start, which):
    """Record, summary and events are of the same run, up to its end."""
    up, down = free_ports(2)
    runs = [
        start("mcs", udp(up, down), "--seconds", FAR_LONGER_S, quiet=False),
        start("gsc", udp(down, up), quiet=False),
    ]
    for run in runs:
        assert "listening" in run.say_line()
    for run in runs:
        assert "peer heard" in run.say_line()
    time.sleep(0.5)
    ended_at = []
    for run in runs:
        ended_at.append(time.monotonic() * 1e6)
        run.send(which)
    for run, told_at in zip(runs, ended_at):
        run.program.communicate(timeout=TIME_LIMIT_S)
        gone_at = time.monotonic() * 1e6
        assert run.program.returncode == 0
        node, outputs = run.node, run.outputs
        summary, last = outputs.summary, outputs.rows[-1]
        assert summary["frames"] == last["frame"] + 1
        assert summary["seconds"] == pytest.approx(
            summary["frames"] * FRAME_US / 1e6)

        # Up to the signal, but for the frame that was not over yet; a row
        # may be late, and then so is the signal's. A row that a pausing
        # machine had not begun is no row.
        on_at = summary["switched_on_us"]
        need(last["clock_us"] >= told_at - 2 * FRAME_US - latest(outputs),
             outputs)
        assert last["clock_us"] - on_at >= summary["frames"] * FRAME_US / 2

        # The link and the log of the whole run.
        sent = "downlink_sent" if node == "mcs" else "uplink_sent"
        more = summary["link"][sent] - last[f"link.{sent}"]
        assert more >= 0
        need(more <= 2, outputs)
        assert summary["events"] == {
            kind: event["count"] for kind, event in outputs.events.items()
        }
        for event in outputs.events.values():
            assert event["first_ms"] <= event["last_ms"]
            # The node goes on while the last rows are written.
            assert event["last_ms"] <= (gone_at - on_at) / 1000
        assert "warm_reset" not in outputs.events


def latest(outputs):
    """How late the latest row was, in microseconds."""
    first = outputs.rows[0]
    return max(
        row["clock_us"] - first["clock_us"]
        - FRAME_US * (row["frame"] - first["frame"])
        for row in outputs.rows
    )


def fall_silent(start, node):
    """A node whose peer has spoken with it, and speaks no more."""
    own, other = free_ports(2)
    run = start(node, udp(own, other))
    width = len(COMMANDS if node == "mcs" else SENSORS) + 1
    peer = GroundPeer if node == "mcs" else AircraftPeer
    with peer(other, own, [(0x700,) * (width - 1) + (0,)]) as it:
        it.await_received(20)
        it.await_answered(3)
    return run


@pytest.mark.parametrize("node", ["mcs", "gsc"])
@pytest.mark.parametrize("which, kind", [
    (signal.SIGUSR1, "processor_restart"), (signal.SIGUSR2, "warm_reset"),
], ids=["restart", "reset"])
@flies_again
def test_ini4_a_reset_restarts_the_telemetry_board_a_restart_does_not(
    start, node, which, kind
):
    """A board that has received nothing since its start gives its controller
    no reason to complain of silence (LNK-10): in the frames after SIGUSR2
    the log has no more of that, in those after SIGUSR1 it has."""
    run = fall_silent(start, node)
    time.sleep(0.3)
    run.send(which)
    time.sleep(0.5)
    outputs = run.stop()
    if kind == "processor_restart":
        assert "warm_reset" not in outputs.events
    else:
        need("processor_restart" not in outputs.events, outputs)
    assert kind in outputs.events
    need(outputs.events[kind]["count"] == 1, outputs)
    started_ms = outputs.events[kind]["last_ms"]

    # A board that the machine ran late starts again by itself, and then is
    # silent.
    need("telin_no_block" in outputs.events, outputs)
    silent_ms = outputs.events["telin_no_block"]
    need(silent_ms["first_ms"] < started_ms
         and silent_ms["last_ms"] >= started_ms - 60, outputs)
    if which == signal.SIGUSR2:
        need(silent_ms["last_ms"] <= started_ms, outputs)
    else:
        need(silent_ms["last_ms"] > started_ms + 100, outputs)


@flies_again
@pytest.mark.parametrize("processors", [1, 2, 4])
def test_krn6_a_processor_exception_restarts_the_aircraft_in_flight(
    start_both, write, processors
):
    """All processors of the node (EXT-4)."""
    rows = different_rows(40, len(COMMANDS), 7)
    sticks = write("sticks.csv", script(COMMANDS, rows))
    mcs, gsc = start_both(mcs=("--processors", processors),
                          gsc=("--sticks", sticks))
    await_rows(mcs, 60)
    mcs.send(signal.SIGUSR1)
    await_rows(mcs, 60)
    mcs, gsc = mcs.stop(), gsc.stop()

    restart = mcs.events["processor_restart"]

    # The servos were never anywhere but where some command put them, each
    # in its turn.
    safe, neutral = (*(0x800,) * 7, 0, 0xFFF), (0x800,) * 9
    expected = [safe, neutral]
    expected += [
        (r[0], r[0], r[1], r[1], r[2], r[2], r[2], r[3], r[4]) for r in rows
    ]
    commanded = in_turn([
        words[:9] for words in mcs.words("pwm", SERVOS)
    ])
    places = [expected.index(words) for words in commanded]
    assert places == sorted(places)

    # No node starts unasked, except on a machine that pauses. Commands follow
    # again: the last frames have the late rows.
    need(restart["count"] == 1, mcs)
    need("processor_restart" not in gsc.events, gsc)
    need(places[-1] > (restart["last_ms"] - 250) / 120 + 3, mcs, gsc)


@flies_again
@pytest.mark.parametrize("processors", [1, 2, 4])
def test_krn6_the_ground_restarts_and_flies_on(start_both, write, processors):
    rows = different_rows(40, len(COMMANDS), 8)
    sticks = write("sticks.csv", script(COMMANDS, rows))
    mcs, gsc = start_both(
        gsc=("--sticks", sticks, "--processors", processors))
    for _ in range(3):
        await_rows(gsc, 20)
        gsc.send(signal.SIGUSR1)
    await_rows(gsc, 50)
    mcs, gsc = mcs.stop(), gsc.stop()
    restart = gsc.events["processor_restart"]
    need(restart["count"] == 3, gsc)
    late = rows[int((restart["last_ms"] - 250) / 120) + 3]
    need(late in mcs.words("mcs.uplink", COMMANDS), mcs, gsc)


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("waits_for", ["output", "plant"])
def test_rtp2_a_signal_ends_a_start_that_waits(tmp_path, which, waits_for):
    """It waits for a reader of its output, or for JSBSim's process."""
    own, other = free_ports(2)
    command = [PROGRAMS["mcs"], "--link", udp(own, other)]
    surroundings = dict(os.environ)
    if waits_for == "output":
        os.mkfifo(tmp_path / "pipe")
        command += ["--record", tmp_path / "pipe"]
    else:
        python = tmp_path / "python"
        python.write_text(
            f"#!/bin/sh\ntouch {tmp_path}/begun\nexec cat <&$2\n")
        python.chmod(0o755)
        command += ["--plant", "jsbsim"]
        surroundings["URV_PYTHON"] = str(python)
    with subprocess.Popen(command, env=surroundings,
                          stderr=subprocess.PIPE) as program:
        threads = f"/proc/{program.pid}/task"
        deadline = time.monotonic() + TIME_LIMIT_S
        while (len(os.listdir(threads)) == 1
               or waits_for == "plant" and not (tmp_path / "begun").exists()):
            assert program.poll() is None
            assert time.monotonic() < deadline
            time.sleep(0.01)
        time.sleep(0.2)
        program.send_signal(which)
        assert program.wait(TIME_LIMIT_S) == -which

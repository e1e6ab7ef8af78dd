"""RTP-2: a partition ends when it is told to, and restarts when it is told to.
"""

import signal
import time

import pytest

from conftest import COMMANDS, SERVOS, different_rows, in_turn, script

FAR_LONGER_S = 1000


def await_rows(run, number):
    """Wait until the program has made so many rows: it writes late, so the
    length of the run is what counts."""
    run.await_begin()
    time.sleep(number * 0.02 + 0.3)
    assert run.program.poll() is None


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_a_signal_ends_a_run_with_whole_outputs(start_both, which):
    runs = start_both(mcs=("--seconds", FAR_LONGER_S))
    await_rows(runs[0], 40)
    for run in runs:
        run.send(which)
    for run in runs:
        outputs = run.end()
        assert outputs.summary["frames"] == outputs.rows[-1]["frame"] + 1
        assert outputs.summary["frames"] >= 30
        assert "events" in outputs.summary
        assert isinstance(outputs.events, dict)


def test_krn6_a_processor_exception_restarts_the_aircraft_in_flight(
    start_both, write
):
    rows = different_rows(40, len(COMMANDS), 7)
    sticks = write("sticks.csv", script(COMMANDS, rows))
    mcs, gsc = start_both(gsc=("--sticks", sticks))
    await_rows(mcs, 60)
    mcs.send(signal.SIGUSR1)
    await_rows(mcs, 60)
    mcs, gsc = mcs.stop(), gsc.stop()

    restart = mcs.events["processor_restart"]
    assert restart["count"] == 1
    assert "processor_restart" not in gsc.events

    # The servos were never anywhere but where some command put them, each
    # in its turn.
    expected = [(0x800,) * 9]
    expected += [
        (r[0], r[0], r[1], r[1], r[2], r[2], r[2], r[3], r[4]) for r in rows
    ]
    commanded = in_turn([
        words[:9] for words in mcs.words("pwm", SERVOS)
    ])
    places = [expected.index(words) for words in commanded]
    assert places == sorted(places)

    # Commands follow again: the last frames have the late rows.
    assert places[-1] > (restart["last_ms"] - 250) / 120 + 3


def test_krn6_the_ground_restarts_and_flies_on(start_both, write):
    rows = different_rows(40, len(COMMANDS), 8)
    sticks = write("sticks.csv", script(COMMANDS, rows))
    mcs, gsc = start_both(gsc=("--sticks", sticks))
    for _ in range(3):
        await_rows(gsc, 20)
        gsc.send(signal.SIGUSR1)
    await_rows(gsc, 50)
    mcs, gsc = mcs.stop(), gsc.stop()
    assert gsc.events["processor_restart"]["count"] == 3
    late = rows[int((gsc.events["processor_restart"]["last_ms"] - 250) / 120)
                + 3]
    assert late in mcs.words("mcs.uplink", COMMANDS)

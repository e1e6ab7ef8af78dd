# SPDX-License-Identifier: Apache-2.0
"""From the console to the servos and from the sensors to the ground, without
faults, at every phase (D-12; Tables 1 to 10 of the report, PWM-2, BUF-1,
BUF-2).

Each frame has words of its own, so a row of the record identifies its frame.
How many frames that takes follows from the tasks' offsets.
"""

import pytest
from conftest import (
    CHARACTER_US,
    COMMANDS,
    EDGES,
    FRAMES_PER_S,
    FRAME_MS,
    NEUTRAL,
    SENSORS,
    SERVOS,
    UPLINK_CHARACTERS,
    columns,
    different_rows,
    fly_in,
    script,
    transformed,
)

# The console changes in the middle of the ground's frame, the sensors in
# the middle of the aircraft's, so no scan sees half a change.
MIDDLE_MS = 10

# When, in ms from the beginning of a frame, the link carries what.
UPLINK_GIVEN = 4
UPLINK_COMPLETE = UPLINK_GIVEN + UPLINK_CHARACTERS * CHARACTER_US / 1000
DOWNLINK_BEGINS = UPLINK_COMPLETE + 2 * CHARACTER_US / 1000


def one_at_a_time():
    """Every command word takes every edge value, alone."""
    return [
        NEUTRAL[:place] + (word,) + NEUTRAL[place + 1:]
        for place in range(13) for word in EDGES if word != NEUTRAL[place]
    ]


STICKS = one_at_a_time() + different_rows(40, 13, seed=3)
WORDS = different_rows(len(STICKS), 27, seed=4)
FRAMES = len(STICKS)


def first_frame(begins, not_before):
    """The first time at which a frame begins that is not before another."""
    while begins < not_before:
        begins += FRAME_MS
    return begins


def expected_delays(phase):
    """In frames: from the row of the record that first has a console word,
    or during which the sensors change, to the row that has it elsewhere.

    Row k is taken as the frame that began at 20 k ends; what happens at that
    very moment comes after it.
    """
    lag = 2 * phase
    # The change is within frame 0; the scan of frame 1 sees it; it is taken
    # at frame 2.
    taken = 2 * FRAME_MS
    aircraft = first_frame(lag, taken + UPLINK_COMPLETE)

    # The same, by the aircraft's frames.
    sensed = taken + lag
    downlink = first_frame(DOWNLINK_BEGINS, sensed + 4) // FRAME_MS * FRAME_MS
    return {
        "gsc.uplink": (taken + 8) // FRAME_MS,
        "mcs.uplink": (aircraft + 8) // FRAME_MS,
        "pwm": (aircraft + 4) // FRAME_MS,
        "mcs.downlink": (sensed + 8) // FRAME_MS,
        "gsc.downlink": (int(downlink) + FRAME_MS + 8) // FRAME_MS,
    }


@pytest.fixture(scope="module", params=range(10), ids="phase {}".format)
def flight(request, tmp_path_factory):
    folder = tmp_path_factory.mktemp("path")
    (folder / "sticks.csv").write_text(script(COMMANDS, STICKS, MIDDLE_MS))
    (folder / "sensors.csv").write_text(
        script(SENSORS, WORDS, MIDDLE_MS + 2 * request.param)
    )
    flown = fly_in(
        folder, "--phase", request.param, "--seconds", (FRAMES + 10) / FRAMES_PER_S,
        "--sticks", "sticks.csv", "--sensors", "sensors.csv",
    )
    flown.phase = request.param
    return flown


@pytest.mark.parametrize("group, names, sent", [
    ("console", COMMANDS, STICKS),
    ("gsc.uplink", COMMANDS, STICKS),
    ("mcs.uplink", COMMANDS, STICKS),
    ("pwm", SERVOS, [transformed(row) for row in STICKS]),
    ("mcs.downlink", SENSORS, WORDS),
    ("gsc.downlink", SENSORS, WORDS),
], ids=lambda value: value if isinstance(value, str) else "")
def test_every_word_arrives_unchanged_and_in_time(flight, group, names, sent):
    delay = expected_delays(flight.phase).get(group, 0)
    arrived = columns(flight, group, names)
    for frame, words in enumerate(sent):
        got = arrived[frame + delay]
        wrong = [
            f"{name} {was:#x}, not {wanted:#x}"
            for name, was, wanted in zip(names, got, words)
            if was != wanted
        ]
        assert not wrong, f"{group}, row {frame} after {delay}: {wrong}"
    # And the last stays.
    assert set(arrived[FRAMES - 1 + delay:]) == {sent[-1]}


@pytest.mark.parametrize("group", ["gsc.uplink", "mcs.uplink",
                                   "mcs.downlink", "gsc.downlink"])
def test_gdo1_mdo1_error_word_is_0_once_running(flight, group):
    errors = columns(flight, group, ("error",))
    assert set(errors[5:]) == {(0,)}


def test_cor1_both_nodes_have_the_same_commands_and_sensors(flight):
    delays = expected_delays(flight.phase)
    for names, here, there in (
        ((*COMMANDS, "error"), "gsc.uplink", "mcs.uplink"),
        ((*SENSORS, "error"), "mcs.downlink", "gsc.downlink"),
    ):
        apart = delays[there] - delays[here]
        first, second = (columns(flight, g, names) for g in (here, there))
        assert first[5:len(first) - apart] == second[5 + apart:]


def test_only_the_start_misses_messages(flight):
    # Before the first block comes over the link nobody has news.
    events = flight.summary["events"]
    assert events.keys() <= {"gsc.no_input", "mcs.no_input"}
    assert events.get("gsc.no_input", 0) <= 3
    assert events.get("mcs.no_input", 0) <= 2

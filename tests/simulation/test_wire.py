# SPDX-License-Identifier: Apache-2.0
"""The serial link when nothing goes wrong, at every phase (LNK-1, LNK-2,
LNK-3)."""

from collections import Counter

import pytest
from conftest import (
    CHARACTER_US,
    COMMANDS,
    EXCHANGE,
    FRAMES_PER_S,
    FRAME_MS,
    SENSORS,
    TICK_US,
    different_rows,
    fly_in,
    messages,
    script,
)

FRAMES = 60

# From here on both nodes have sent and received.
RUNNING_US = 100_000

# The ground's TELOUT runs two ticks after its frame begins, and all of an
# exchange comes after it.
EXCHANGE_BEGINS_US = 2 * TICK_US


def frame_of(time_us):
    return (time_us - EXCHANGE_BEGINS_US) // (FRAME_MS * 1000)


@pytest.fixture(scope="module", params=range(10), ids="phase {}".format)
def flight(request, tmp_path_factory):
    """A flight with words that change in every frame."""
    folder = tmp_path_factory.mktemp("wire")
    (folder / "sticks.csv").write_text(
        script(COMMANDS, different_rows(FRAMES, 13, seed=1), 10)
    )
    (folder / "sensors.csv").write_text(
        script(SENSORS, different_rows(FRAMES, 27, seed=2), 10)
    )
    return fly_in(
        folder, "--phase", request.param, "--seconds", FRAMES / FRAMES_PER_S,
        "--sticks", "sticks.csv", "--sensors", "sensors.csv",
    )


def running(flight):
    """The messages of every whole frame once running."""
    return [
        message for message in messages(flight.wire)
        if frame_of(RUNNING_US) < frame_of(message.time_us) < FRAMES - 1
    ]


def test_d5_32_bytes_go_up_and_59_down_in_every_frame(flight):
    counts = Counter(
        (frame_of(item.time_us), item.direction) for item in flight.wire
    )
    for frame in range(frame_of(RUNNING_US), FRAMES - 1):
        got = counts[frame, "up"], counts[frame, "down"]
        assert got == tuple(EXCHANGE.values()), f"frame {frame}: up, down {got}"


def test_lnk2_messages_take_their_turns_without_a_retry(flight):
    exchange = [
        ("up", "uplink"), ("down", "good, wants"), ("up", "command"),
        ("down", "downlink"), ("up", "good"),
    ]
    seen = {}
    for message in running(flight):
        seen.setdefault(frame_of(message.time_us), []).append(
            (message.direction, message.kind)
        )
    assert len(seen) > 50
    for frame, order in seen.items():
        assert order == exchange, f"frame {frame}"


def test_lnk1_d4_one_character_at_a_time(flight):
    times = [item.time_us for item in flight.wire]
    gaps = {later - earlier for earlier, later in zip(times, times[1:])}
    assert min(gaps) == CHARACTER_US


def test_d7_every_data_message_ends_with_its_crc(flight):
    # By long division: the remainder of a whole message is zero.
    checked = 0
    for message in running(flight):
        if len(message.data) > 1:
            rest = 0
            for byte in message.data:
                rest ^= byte
                for _ in range(8):
                    rest = (rest >> 1) ^ (0x9C if rest & 1 else 0)
            assert rest == 0, message
            checked += 1
    assert checked > 100


def test_lnk_nothing_is_sent_twice_scrapped_or_reset(flight):
    link = flight.summary["link"]
    sent = Counter(message.kind for message in messages(flight.wire))
    assert link == {
        "uplink_sent": sent["uplink"],
        "uplink_received": sent["uplink"],
        "uplink_bad": 0,
        "uplink_scrapped": 0,
        "downlink_sent": sent["downlink"],
        "downlink_received": sent["downlink"],
        "downlink_bad": 0,
        "downlink_scrapped": 0,
        "gsc_resets": 0,
        "mcs_resets": 0,
    }
    # TELOUT first runs in the second frame.
    assert sent["uplink"] == FRAMES - 1
    assert FRAMES - 3 <= sent["downlink"] <= FRAMES - 1
    assert flight.summary["overruns"] == 0
    last = flight.rows[-1]
    assert {name: last["link." + name] for name in link} == link

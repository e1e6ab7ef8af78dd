# SPDX-License-Identifier: Apache-2.0
"""How long a change at the console takes to the PWM board, to the
microsecond, at every phase and in both schedules (FRM-2, FRM-5, D-12).
docs/design.md derives the same. And frames in step (FRM-6): from any phase,
under drift and lost blocks; evidence/in_step.py tries every phase and drift."""

import sys

import pytest
from conftest import (
    CHARACTER_US,
    COMMANDS,
    FRAME_US,
    NEUTRAL,
    NUMBERS,
    ROOT,
    TICK_US,
    UPLINK_CHARACTERS,
    fly_in,
    transformed,
)

sys.path.insert(0, str(ROOT / "evidence"))

import in_step  # noqa: E402

# All times in microseconds.
FRAME, TICK = FRAME_US, TICK_US
CONVERSION = NUMBERS.conversion_us

# Changes far enough apart that each has arrived before the next comes.
APART = 6 * FRAME

UPLINK = UPLINK_CHARACTERS * CHARACTER_US

# When the ground's TELOUT runs after a scan began: the AD task takes it a
# frame later, or as soon as its 32 channels are converted. When the aircraft's
# TELIN and PWM run.
TELOUT = {"report": FRAME + 2 * TICK, "fast": 32 * CONVERSION}
TELIN = {"report": 0, "fast": 4 * TICK}
PWM = {"report": 2 * TICK, "fast": 4 * TICK}

SCHEDULES = sorted(TELOUT)


def from_scan_to_servos(phase, schedule):
    """From the beginning of the scan that samples a change."""
    arrived = TELOUT[schedule] + UPLINK
    aircraft = TICK * phase - FRAME
    while aircraft + TELIN[schedule] < arrived:
        aircraft += FRAME
    return aircraft + PWM[schedule]


def latency(time, channel, phase, schedule):
    """A channel is held 16 us after the one before it; a change at that
    very moment is in time."""
    sampled = channel * CONVERSION
    scans = -(-(time - sampled) // FRAME)
    return scans * FRAME + from_scan_to_servos(phase, schedule) - time


# The place of a change in its frame, and its channel. The first is the latest
# that the scan still sees, and so the fastest of all; the second has just been
# missed by the first channel, and is the slowest.
FASTEST = (12 * CONVERSION, 12)
SLOWEST = (1, 0)
MOMENTS = [FASTEST, SLOWEST]
MOMENTS += [
    moment
    for channel in range(13)
    for moment in (
        (channel * CONVERSION, channel),
        (channel * CONVERSION + 1, channel),
        (7_654 + 321 * channel, channel),
        (19_999, channel),
        *((1_357 * part + 29 * channel, channel) for part in range(3, 8)),
    )
]
# One that comes twice would hide a percentile that is off by one; so would
# fewer than 100, or an even number.
MOMENTS = list(dict.fromkeys(MOMENTS))
assert len(MOMENTS) > 100 and len(MOMENTS) % 2 == 1


@pytest.fixture(scope="module")
def sticks():
    """The script and, for each change, its time and channel."""
    lines = ["time_ms," + ",".join(COMMANDS), "0," + ",".join(
        map(str, NEUTRAL))]
    changes = []
    words = list(NEUTRAL)
    time = 10 * FRAME
    for within, channel in MOMENTS:
        words[channel] = 0x123 if words[channel] >= 0x800 else 0x923
        at = time + within
        lines.append(f"{at // 1000}.{at % 1000:03},"
                     + ",".join(map(str, words)))
        changes.append((at, channel, tuple(words)))
        time += APART
    return "\n".join(lines) + "\n", changes, time


@pytest.mark.parametrize("schedule", SCHEDULES)
@pytest.mark.parametrize("phase", range(10))
def test_console_to_servo_latency_is_exact(tmp_path, sticks, phase, schedule):
    text, changes, end = sticks
    (tmp_path / "sticks.csv").write_text(text)
    flight = fly_in(tmp_path, "--sticks", "sticks.csv", "--phase", phase,
                    "--schedule", schedule, "--seconds", end / 1e6)
    assert flight.record["pwm.discretes"][-1] == transformed(
        changes[-1][2])[-1]
    expected = sorted(latency(time, channel, phase, schedule)
                      for time, channel, _ in changes)
    count = len(expected)
    measured = {
        name: round(value * 1000) if name in ("min", "median", "p99", "max")
        else value
        for name, value in flight.summary["latency_ms"].items()
    }
    assert measured == {
        "min": expected[0],
        "median": expected[(count + 1) // 2 - 1],
        "p99": expected[-(-count * 99 // 100) - 1],
        "max": expected[-1],
        "measured": count,
        "overtaken": 0,
        "expired": 0,
    }
    # The extremes are those of the derivation.
    scan = {"report": FRAME + 2 * TICK + TICK * phase
            + (FRAME if phase < 4 else 0),
            "fast": 4 * TICK + TICK * phase
            - (FRAME if phase > 7 else 0)}[schedule]
    assert (expected[0], expected[-1]) == (
        scan - 12 * CONVERSION, scan + FRAME - 1)


# The most changes that may wait (sim-latency.ads), and the longest wait, in
# microseconds.
ROOM, LONGEST = 2_048, 2_000_000


@pytest.mark.parametrize("number, apart", [(3_000, 400), (900, 1_000)])
def test_changes_that_never_arrive_are_counted_as_what_they_are(
        tmp_path, number, apart):
    """While the link is cut the roll stick moves on and on. The last change
    arrives after it, and was made less than two seconds before."""
    changes = [1_100_000 + apart * count for count in range(number)]
    until = changes[-1] + 1_500_000
    (tmp_path / "sticks.csv").write_text("time_ms,roll\n" + "".join(
        f"{time / 1000:.3f},{count % 4_000 + 1}\n"
        for count, time in enumerate(changes)))
    (tmp_path / "faults.txt").write_text(
        f"1000 cut {(until - 1_000_000) / 1000:.3f}\n")
    latency = fly_in(
        tmp_path, "--sticks", "sticks.csv", "--faults", "faults.txt",
        "--seconds", round(until / 1e6 + 1, 3)).summary["latency_ms"]
    assert latency["measured"] == 1
    arrived = changes[-1] + round(latency["min"] * 1000)
    assert until < arrived < until + 100_000
    expired = sum(arrived - time > LONGEST for time in changes[-ROOM:])
    assert 0 < expired < number - 100
    assert (latency["expired"], latency["overtaken"]) == (
        expired, number - expired - 1)


def test_a_change_that_a_later_one_overtakes_is_counted(tmp_path):
    # Three in each frame between two scans: the last of them arrives.
    (tmp_path / "sticks.csv").write_text("time_ms,roll\n" + "".join(
        f"{221 + 20 * frame + 5 * part},{100 * frame + part + 1}\n"
        for frame in range(40) for part in range(3)))
    latency = fly_in(tmp_path, "--sticks", "sticks.csv", "--seconds", "2"
                     ).summary["latency_ms"]
    assert (latency["measured"], latency["overtaken"], latency["expired"]) \
        == (40, 80, 0)


# --- frames in step ----------------------------------------------------------

@pytest.mark.parametrize("phase, drift, schedule, processors", [
    (0, -200, "fast", 1), (6, 137, "fast", 2), (9, 200, "fast", 1),
    (2, -91, "report", 2), (3, 200, "report", 1),
])
def test_frm6_in_step_sticks_and_sensors_keep_their_bounds(
        phase, drift, schedule, processors):
    found = in_step.fly(phase, drift, schedule, processors, changed=200)
    assert list(in_step.wrongs(found, schedule)) == []
    # As soon as five corrections of four uplinks each.
    assert found.since_ms < 25 * in_step.FRAME_MS


@pytest.mark.parametrize("phase, drift", [(3, -200), (8, 200)])
def test_frm6_no_downlink_is_left_out_in_10000_frames(phase, drift):
    assert in_step.fly_long(phase, drift, "fast", 10_000) == 0


def test_frm6_without_lock_a_drift_leaves_downlinks_out(tmp_path):
    flight = fly_in(tmp_path, "--drift", "200", "--seconds", "120")
    assert in_step.left_out(flight.summary) > 3
    assert "lock" not in flight.summary


def test_frm6_without_uplinks_a_frame_is_ten_ticks(tmp_path):
    """Cut off as soon as it is in step, the aircraft corrects nothing and
    drifts away; 20 s after the link is back it is in step again."""
    (tmp_path / "faults.txt").write_text("2000 cut 36000\n")
    flights = [
        fly_in(tmp_path, "--lock", "--drift", "150", "--phase", "0",
               "--faults", "faults.txt", "--seconds", seconds).summary["lock"]
        for seconds in ("1.9", "37.9", "58")]
    assert flights[1] == flights[0]
    assert flights[2]["frames_of_9_ticks"] > flights[0]["frames_of_9_ticks"]
    assert 38 < flights[2]["in_step_since_s"] <= 58


def test_frm6_it_stays_in_step_while_blocks_are_lost(tmp_path):
    """Half a second without an uplink, over and over."""
    (tmp_path / "faults.txt").write_text("".join(
        f"{time} cut 460\n" for time in range(2_000, 58_000, 500)))
    lock = fly_in(tmp_path, "--lock", "--drift", "-200", "--schedule", "fast",
                  "--faults", "faults.txt", "--seconds", "60").summary["lock"]
    assert lock["in_step_since_s"] < 2
    assert lock["frames_of_11_ticks"] > 2


def test_frm6_a_reset_is_in_step_again(tmp_path):
    (tmp_path / "faults.txt").write_text("3000 mcs reset warm\n")
    lock = fly_in(tmp_path, "--lock", "--phase", "7", "--schedule", "fast",
                  "--faults", "faults.txt", "--seconds", "8").summary["lock"]
    assert 3 < lock["in_step_since_s"] < 4

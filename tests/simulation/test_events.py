# SPDX-License-Identifier: Apache-2.0
"""The error logs of both nodes (EXT-1): --events has one line for each node
and kind of error that happened, with count, first and last time.

The aircraft lags 3 ticks. A block that the ground sends in its frame n is
taken by the aircraft's TELIN at its frame n + 1, which begins at
20 (n + 1) + 6 ms; one that the aircraft sends meanwhile by the ground's
TELIN at its frame n + 1.
"""

import json

import pytest
from conftest import FRAME_MS, HEADERS, messages

FIELDS = ["node", "kind", "count", "first_frame", "last_frame",
          "first_ms", "last_ms", "last_detail"]

LAG_MS = 6


def logged(count, first_frame, last_frame, node, minor_frame, detail=0):
    """The fields of an event besides node and kind."""
    later = (LAG_MS if node == "mcs" else 0) + 2 * minor_frame
    return {
        "count": count,
        "first_frame": first_frame, "last_frame": last_frame,
        "first_ms": FRAME_MS * first_frame + later,
        "last_ms": FRAME_MS * last_frame + later,
        "last_detail": detail,
    }


def without_name(event):
    return {name: event[name] for name in FIELDS[2:]}


def test_ext1_one_object_a_line_with_these_fields(fly, write):
    write("faults.txt", "200 cut 100\n500 up flip 9 1\n")
    flight = fly("--seconds", "1", "--faults", "faults.txt")
    lines = flight.path("events.jsonl").read_text().splitlines()
    assert len(lines) > 5
    seen = set()
    for line in lines:
        event = json.loads(line)
        assert list(event) == FIELDS
        assert event["count"] > 0
        assert event["first_frame"] <= event["last_frame"] < 50
        assert event["first_ms"] <= event["last_ms"] < 1000
        seen.add((event["node"], event["kind"]))
    assert len(seen) == len(lines)
    assert [json.loads(line)["node"] for line in lines] == sorted(
        node for node, _ in seen)


def test_ext1_summary_counts_the_same_events(fly, write):
    write("faults.txt", "200 cut 100\n500 up flip 9 1\n700 down drop 20\n")
    flight = fly("--seconds", "1", "--faults", "faults.txt")
    assert flight.summary["events"] == {
        f"{node}.{kind}": event["count"]
        for (node, kind), event in flight.events.items()
    }


def test_saf7_the_ground_has_both_logs(fly, write):
    # Errors of both nodes, and then 8 s in which the aircraft's come down.
    write("faults.txt", "1000 cut 200\n1500 mcs stall adc 50\n"
                        "2000 gsc stall adc 50\n2500 mcs reset processor\n")
    flight = fly("--seconds", "12", "--faults", "faults.txt")
    logs = flight.summary["ground_logs"]
    for node in ("gsc", "mcs"):
        known = {f"{node}.{kind}": count for kind, count in logs[node].items()}
        assert known == {kind: count
                         for kind, count in flight.summary["events"].items()
                         if kind.startswith(node)}, node
    assert logs["mcs"]["processor_restart"] == 1


def test_ext1_a_good_flight_logs_the_start_only(fly):
    flight = fly("--seconds", "2")
    assert set(flight.events) == {("gsc", "no_input"), ("mcs", "no_input")}
    for event in flight.events.values():
        assert event["first_frame"] == 1
        assert event["last_frame"] <= 2


@pytest.mark.parametrize("options", [
    ("--drift", "200"),
    ("--drift", "-200", "--phase", "9"),
    ("--drift", "200", "--lock"),
    ("--drift", "-200", "--lock", "--phase", "9"),
])
def test_ext1_times_are_the_ground_s_with_a_drift(fly, write, options):
    """The start takes 10 ms and begins with a tick. In 400 s the aircraft's
    clock has lost or won 80 ms; in step it keeps to the ground's, after ticks
    that its frames had more or less than ten."""
    write("faults.txt", "400000 mcs reset warm\n")
    flight = fly("--seconds", "401", *options, "--faults", "faults.txt")
    event = flight.events["mcs", "warm_reset"]
    assert 399_998 <= event["first_ms"] <= 400_012
    if "--lock" in options:
        corrected = (flight.summary["lock"]["frames_of_9_ticks"]
                     + flight.summary["lock"]["frames_of_11_ticks"])
        assert corrected > 30


def test_ext1_a_cut_link_is_logged_on_both_sides(fly, write):
    # Nothing of the ground's frames 100 to 124 gets through.
    write("faults.txt", "2000 cut 500\n")
    events = fly("--seconds", "4", "--faults", "faults.txt").events
    for node in ("gsc", "mcs"):
        assert without_name(events[node, "telin_no_block"]) == logged(
            25, 101, 125, node, minor_frame=0)

    # The ground sends each block twice, and gives it up. It has waited in
    # vain twice a frame, and finds that out before its log task runs.
    resets = events["gsc", "link_reset"]
    assert (resets["first_frame"], resets["first_ms"]) == (100, 2010)
    assert resets["last_frame"] in (124, 125)
    assert events["gsc", "link_block_scrapped"]["count"] == 25

    # The aircraft is not asked, and its transmit buffers fill.
    assert ("mcs", "link_reset") not in events
    assert ("mcs", "link_block_scrapped") not in events
    overwrote = events["mcs", "telout_overwrote_block"]
    assert 22 <= overwrote["count"] <= 25
    assert 100 <= overwrote["first_frame"] <= 103
    assert events["mcs", "link_block_cleared"]["count"] == 1


@pytest.mark.parametrize("way, node", [("up", "mcs"), ("down", "gsc")])
def test_ext1_a_bad_block_is_logged_with_its_frame(fly, write, way, node):
    # The tenth byte from 1 s on is within the block, either way.
    write("faults.txt", f"1000 {way} flip 10 1\n")
    flight = fly("--seconds", "2", "--faults", "faults.txt")
    data = next(m for m in messages(flight.wire)
                if m.time_us > 1_000_000 and m.direction == way
                and HEADERS[m.data[0]][1] > 1)
    ended_ms = data.time_us / 1000 + 0.096 * len(data.data)
    later = LAG_MS if node == "mcs" else 0
    # The log task runs in minor frame 5.
    frame = int((ended_ms - later - 10) // FRAME_MS) + 1
    assert without_name(flight.events[node, "link_block_bad"]) == logged(
        1, frame, frame, node, minor_frame=5, detail=1)
    if way == "up":
        # It came again in time: the tasks have missed nothing.
        assert (node, "telin_no_block") not in flight.events
    else:
        # By the second time the aircraft had a newer block, and sent that:
        # the ground has it a frame early, and nothing in the next.
        assert flight.events["mcs", "link_block_cleared"]["count"] == 1
        missed = flight.events[node, "telin_no_block"]
        assert (missed["count"], missed["first_frame"]) == (1, frame + 1)


def test_ext1_a_flood_hides_nothing(fly, write):
    # One bad block, then a link that is away for a minute, then one more.
    write("faults.txt", "1000 up flip 10 1\n2000 cut 60000\n"
                        "63000 up flip 10 1\n")
    events = fly("--seconds", "64", "--faults", "faults.txt").events
    assert events["mcs", "telin_no_block"]["count"] == 3000
    bad = events["mcs", "link_block_bad"]
    assert bad["count"] == 2
    assert (bad["first_frame"], bad["last_frame"]) == (50, 3150)
    start = events["mcs", "no_input"]
    assert (start["count"], start["first_frame"]) == (1, 1)


def test_ext1_two_blocks_in_a_frame_are_logged(fly, write):
    # The ground's board stalls for five frames, the aircraft's block comes
    # late, and the next one in time: the first is never taken.
    write("faults.txt", "1000 gsc stall telemetry 100\n")
    events = fly("--seconds", "2", "--faults", "faults.txt").events
    assert events["gsc", "link_block_not_taken"]["count"] == 1
    assert events["gsc", "link_block_cleared"]["count"] == 1


@pytest.mark.parametrize("phase", [0, 9])
def test_ext1_the_time_is_that_of_the_ground_s_clock(fly, write, phase):
    write("faults.txt", "1000 cut 200\n")
    events = fly("--seconds", "2", "--phase", phase,
                 "--faults", "faults.txt").events
    for (node, _), event in events.items():
        lag = 2 * phase if node == "mcs" else 0
        for place in ("first", "last"):
            within = (event[f"{place}_ms"] - lag
                      - FRAME_MS * event[f"{place}_frame"])
            assert 0 <= within < FRAME_MS


def test_ext1_the_log_does_not_disturb_the_flight(urv_sim, tmp_path, write):
    write("faults.txt", "200 cut 100\n")
    for name, more in (("with", ["--events", "e"]), ("without", [])):
        assert urv_sim("fly", "--seconds", "1", "--faults", "faults.txt",
                       "--quiet", "--record", name, *more).returncode == 0
    assert (tmp_path / "with").read_bytes() == (
        tmp_path / "without").read_bytes()

# SPDX-License-Identifier: Apache-2.0
"""FTI-12: the frame of a downlink, from the aircraft to the record."""

import sys

import numpy
import pytest
from conftest import (
    COMMANDS,
    FRAME_MS,
    ROOT,
    SENSORS,
    different_rows,
    fly_in,
    script,
)
from test_test_cards import COMPLETE, DOUBLET, SWEEP, fly_cards, switched

sys.path.insert(0, str(ROOT / "ground"))

from urv import flights, packets  # noqa: E402

UNKNOWN = 65_535
SERVOS = ("left_aileron", "right_aileron", "left_elevator", "right_elevator",
          "left_rudder", "right_rudder", "throttle")
KEY = "key 1 000102030405060708090a0b0c0d0e0f\n"
FRAMES = 500
FAULTS = "\n".join((
    "1000 cut 400", "2000 cut 20", "2500 cut 60", "3000 down ber 0.002 3000",
    "7000 cut 1300", "8800 up ber 0.003 800")) + "\n"


def sealed(folder):
    """The options of format 2."""
    path = folder / "link.key"
    path.write_text(KEY, encoding="ascii")
    path.chmod(0o600)
    return "--format", "2", "--key", "link.key"


def read(flight):
    return flights.read(flight.path("record.csv"), lambda record: None)


@pytest.fixture(scope="module", params=["report", "fast", "sealed"])
def disturbed(request, tmp_path_factory):
    """A flight whose sensors and sticks change in the middle of each frame,
    over a bad line; and its rows of sensors."""
    folder = tmp_path_factory.mktemp("frame")
    rows = different_rows(FRAMES, len(SENSORS), seed=11)
    (folder / "sensors.csv").write_text(
        script(SENSORS, rows, FRAME_MS // 2), encoding="ascii")
    (folder / "sticks.csv").write_text(
        script(COMMANDS, different_rows(FRAMES, len(COMMANDS), seed=12),
               FRAME_MS // 2), encoding="ascii")
    (folder / "faults.txt").write_text(FAULTS, encoding="ascii")
    options = {"report": (), "fast": ("--schedule", "fast"),
               "sealed": sealed(folder)}[request.param]
    flight = fly_in(
        folder, "--phase", "0", "--seconds", FRAMES * FRAME_MS / 1000,
        "--sensors", "sensors.csv", "--sticks", "sticks.csv",
        "--faults", "faults.txt", *options)
    return request.param, flight, rows


def test_fti12_the_number_is_that_of_the_frame_of_the_scan(disturbed):
    name, flight, rows = disturbed
    frame_of = {words: place for place, words in enumerate(rows)}
    found, first = [], None
    for row in flight.rows:
        if row["gsc.downlink.error"] & 1 or not row["gsc.downlink.alpha"]:
            continue
        words = tuple(row[f"gsc.downlink.{item}"] for item in SENSORS)
        if words not in frame_of:
            continue
        # Sensors of row n are scanned from frame n + 1 on.
        scanned = frame_of[words] + 1
        if name == "sealed":
            # A number counts from the beginning of the session.
            first = row["gsc.frame.number"] - scanned if first is None else (
                first)
            scanned += first
        assert row["gsc.frame.number"] == scanned % packets.FRAME_NUMBERS
        found.append(scanned)
    assert len(found) > 200
    # Gaps of many lengths are exact.
    assert len(set(numpy.diff(found))) > 3
    frames = read(flight).aircraft_frames
    frames = frames[~numpy.isnan(frames)]
    assert list(frames[-len(found):]) == found
    lost = set(range(found[0], found[-1])) - set(found)
    assert read(flight).lost_frames >= len(lost) > 50


def test_fti12_servo_words_are_those_at_the_servos(disturbed):
    name, flight, _ = disturbed
    rows = flight.rows
    for place, row in enumerate(rows[5:], 5):
        if name == "sealed":
            assert all(row[f"gsc.frame.{servo}"] == UNKNOWN
                       for servo in SERVOS)
        elif not row["gsc.downlink.error"] & 1:
            # The sticks move in each frame.
            assert tuple(row[f"gsc.frame.{servo}"] for servo in SERVOS) in [
                tuple(before[f"pwm.{servo}"] for servo in SERVOS)
                for before in rows[place - 5:place + 1]]


@pytest.mark.parametrize("name", ["report", "fast", "sealed"])
def test_fti12_the_running_card_and_its_phase_come_down(tmp_path, name):
    folder = tmp_path / "f"
    folder.mkdir()
    options = {"report": (), "fast": ("--schedule", "fast"),
               "sealed": sealed(folder)}[name]
    flight = fly_cards(
        folder, (DOUBLET, SWEEP), switched(4_000, 7_000, 8_000, 14_000),
        "--seconds", "15", *options)
    record = flight.record
    for slot, card in ((1, DOUBLET), (8, SWEEP)):
        rows = [row for row, word in enumerate(record["gsc.frame.card"])
                if word == slot]
        assert len(rows) == card.length
        assert [record["gsc.frame.phase"][row] for row in rows] == [
            place % 16 for place in range(card.length)]
        numbers = [record["gsc.frame.number"][row] for row in rows]
        assert numbers == list(range(numbers[0], numbers[0] + len(rows)))
    ended = [row for row in flight.rows if row["gsc.frame.card"] == 0]
    assert ended[-1]["gsc.frame.phase"] == COMPLETE
    assert ended[200]["gsc.frame.phase"] in (0, COMPLETE)
    if name != "sealed":
        # The surface's command has the input in the frame of its number.
        moved = {row["gsc.frame.left_rudder"] for row in flight.rows}
        assert len(moved) > 50


@pytest.mark.parametrize(("schedule", "before_ms", "after_ms"), [
    ("report", -1, 1), ("fast", 3, 4)])
def test_fti12_samples_have_the_times_that_the_page_gives(
        tmp_path, schedule, before_ms, after_ms):
    begin = 50 * FRAME_MS
    for at, seen in ((begin + before_ms, 50), (begin + after_ms, 51)):
        (tmp_path / "sensors.csv").write_text(
            "time_ms,right_flap_1,uplink_signal_strength\n"
            f"0,100,100\n{at},200,200\n", encoding="ascii")
        flight = fly_in(
            tmp_path, "--phase", "0", "--seconds", "2", "--schedule",
            schedule, "--sensors", "sensors.csv")
        for item in ("right_flap_1", "uplink_signal_strength"):
            assert seen == next(
                row["gsc.frame.number"] for row in flight.rows
                if row[f"gsc.downlink.{item}"] == 200)
    early, late = (
        flights.sample_offset(f"gsc.downlink.{item}", schedule)
        for item in ("right_flap_1", "uplink_signal_strength"))
    assert before_ms < 1e3 * early < 1e3 * late < after_ms
    assert late - early == pytest.approx(26 * 16e-6)


def record_of(tmp_path, rows):
    """A record of ground's frames, each with the number that has come, or
    None."""
    lines = ["frame,time_ms,gsc.downlink.alpha,gsc.downlink.error,"
             "gsc.frame.number"]
    for frame, number in rows:
        lines.append(f"{frame},{(frame + 1) * FRAME_MS},2048,"
                     f"{int(number is None)},{number or 0}")
    path = tmp_path / "record.csv"
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return flights.read(path, lambda record: None)


def test_fti12_gaps_of_any_length_are_exact(tmp_path):
    at, rows, wanted = 4_000, [(4_000, 4_000)], [4_000]
    for lost in (*range(256), 4_094, 4_095, 4_096, 10_000, 50_000):
        at += lost + 1
        # The ground's clock may be frames early or late.
        rows.append((at + (lost > 0) * (lost % 3), at % 4_096))
        wanted.append(at)
        at += 3
        rows.append((at, at % 4_096))
        wanted.append(at)
    flight = record_of(tmp_path, rows)
    assert list(flight.aircraft_frames) == wanted
    assert flight.lost_frames == wanted[-1] - wanted[0] + 1 - len(wanted)


def test_fti12_a_start_of_the_aircraft_begins_a_new_count(tmp_path):
    flight = record_of(tmp_path, [
        (100, 3_000), (101, 3_001), (102, None), (130, 5), (131, 6)])
    frames = flight.aircraft_frames
    assert list(frames[[0, 1, 3, 4]]) == [3_000, 3_001, 3_030, 3_031]
    assert numpy.isnan(frames[2])


def test_fti12_without_numbers_there_are_no_frames(tmp_path):
    flight = record_of(tmp_path, [(1, UNKNOWN), (2, UNKNOWN)])
    assert flight.aircraft_frames is None
    assert flight.lost_frames is None
    assert flight.sample_times("gsc.downlink.alpha") is None
    with_numbers = record_of(tmp_path, [(1, 7), (2, 8)])
    times = with_numbers.sample_times("gsc.downlink.alpha")
    assert times == pytest.approx([0.14016, 0.16016])
    assert with_numbers.sample_times("console.roll") is None
    assert with_numbers.sample_times("gsc.frame.throttle") == pytest.approx(
        [0.144, 0.164])

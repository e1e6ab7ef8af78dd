# SPDX-License-Identifier: Apache-2.0
"""FTI-9, FTI-10: the flight recorder aboard, and its rows on the ground."""

import json
import sys

import pytest
from conftest import FRAMES_PER_S, ROOT, fly_in

sys.path.insert(0, str(ROOT / "ground"))

from urv import flights, recorder_blocks, recordings  # noqa: E402
from urv.tables import TABLES  # noqa: E402

LANDS_MS = 4_000
ASKS_MS = 6_000
LENGTH = 2 * FRAMES_PER_S
"""Rows of the ring in these flights."""
FAST, HIGH = 80 * 32, 2_000
SLOW, LOW = 10 * 32, 40


def sensors(*changes):
    """Sensors of an aircraft that flies, and is on the ground, in turn."""
    return "time_ms,airspeed,altitude,alpha\n" + "".join(
        f"{time},{SLOW if place % 2 else FAST},{LOW if place % 2 else HIGH},"
        f"{1_000 + place}\n" for place, time in enumerate((0, *changes)))


def order(time_ms, first, rows):
    words = " ".join(map(str, recorder_blocks.request(first, rows)))
    return f"{time_ms} block 700 {words}\n"


def fetch(folder, *options, orders="", faults="", changes=(LANDS_MS,),
          length=2):
    folder.mkdir(exist_ok=True)
    for name, text in (("orders", orders), ("faults", faults),
                       ("sensors", sensors(*changes) if changes else "")):
        if text:
            (folder / name).write_text(text, encoding="ascii")
            options = [*options, f"--{name}", name]
    flight = fly_in(folder, "--recorder", length, "--recording",
                    "aboard.recording", "--fetched", "fetched", *options)
    flight.aboard = recordings.Recording(folder / "aboard.recording").rows
    flight.fetched = recorder_blocks.Rows()
    flight.blocks = 0
    for line in (folder / "fetched").read_text("ascii").splitlines():
        words = [int(line[at:at + 4], 16) for at in range(0, len(line), 4)]
        flight.fetched.take(words[0], words[1:])
        flight.blocks += 1
    return flight


def test_fti10_a_fetched_recorder_is_complete_and_right(tmp_path):
    flight = fetch(tmp_path / "a", "--seconds", "20",
                   orders=order(ASKS_MS, 0, 200))
    report = flight.fetched.report
    assert (report.answer, report.held, report.length) == (0, LENGTH, LENGTH)
    assert flight.fetched.in_order() == flight.aboard[-LENGTH:]
    # A second after the landing the recorder has stopped.
    last = recordings.columns_of(flight.aboard[-1])
    assert abs(last["time_ms"] - (LANDS_MS + 1_000)) <= 100


@pytest.mark.parametrize("format_", [1, 2])
@pytest.mark.parametrize("schedule", ["report", "fast"])
def test_fti10_with_errors_of_1e3_it_is_complete_and_right(
        tmp_path, format_, schedule):
    options = ["--schedule", schedule]
    folder = tmp_path / "a"
    folder.mkdir()
    if format_ == 2:
        (folder / "key").write_text("key 1 " + "5a" * 16 + "\n", "ascii")
        (folder / "key").chmod(0o600)
        options += ["--format", "2", "--key", "key"]
    flight = fetch(
        folder, "--seconds", "140", *options,
        faults="5500 up ber 0.001 140000\n5500 down ber 0.001 140000\n",
        orders="".join(order(ASKS_MS + 12_000 * turn + 300 * again, 0, 200)
                       for turn in range(11) for again in range(3)))
    assert flight.summary["link"]["downlink_bad"] > 1_000
    assert flight.fetched.wrong == {}
    assert flight.fetched.in_order() == flight.aboard[-LENGTH:]


def test_fti9_rows_survive_warm_starts_and_no_cold_start(tmp_path):
    faults = "".join(f"{time} mcs reset {kind}\n" for time, kind in
                     ((3_000, "warm"), (3_500, "processor"), (5_500, "warm")))
    kept = fetch(tmp_path / "warm", "--seconds", "20", faults=faults,
                 orders=order(ASKS_MS, 0, 200))
    assert kept.fetched.in_order() == kept.aboard[-LENGTH:]
    assert {recordings.columns_of(row)["recorder.warm_starts"]
            for row in kept.aboard[-LENGTH:]} == {0, 1, 2}

    cleared = fetch(tmp_path / "cold", "--seconds", "20",
                    faults="5513 mcs reset cold\n",
                    orders=order(7_000, 0, 200))
    rows = cleared.fetched.in_order()
    assert rows == cleared.aboard[:len(rows)] and rows
    ticks = [recordings.columns_of(row)["recorder.tick"] for row in rows]
    assert min(ticks) * 2 > 5_500


def test_fti10_in_flight_a_request_is_answered_once_and_stops_nothing(
        tmp_path):
    flight = fetch(tmp_path / "a", "--seconds", "8",
                   orders=order(2_000, 10, 50), changes=(100_000,))
    assert flight.blocks == 1
    assert flight.fetched.report.answer == 1
    assert len(flight.aboard) > 7.8 * FRAMES_PER_S


def test_fti10_flight_ends_a_fetch_and_the_recorder_goes_on(tmp_path):
    flight = fetch(tmp_path / "a", "--seconds", "12",
                   orders=order(ASKS_MS, 0, 200),
                   changes=(LANDS_MS, 8_000))
    rows = len(flight.fetched.in_order())
    assert 15 <= rows <= 21
    assert recordings.columns_of(flight.aboard[-1])["time_ms"] > 11_800


def test_fti10_a_wrong_request_is_not_answered(tmp_path):
    words = list(recorder_blocks.request(0, 20))
    words[2] ^= 1
    flight = fetch(
        tmp_path / "a", "--seconds", "8", orders=
        f"{ASKS_MS} block 700 {' '.join(map(str, words))}\n")
    assert flight.blocks == 0


def test_fti10_each_fifth_downlink_has_sensors(tmp_path):
    flight = fetch(tmp_path / "a", "--seconds", "12",
                   orders=order(ASKS_MS, 0, 200))
    first = ASKS_MS // 20 + 10
    fresh = [word & 1 == 0 for word in
             flight.record["gsc.downlink.error"][first:first + 200]]
    assert sum(fresh) == 40
    assert all(any(fresh[at:at + 5]) for at in range(0, 200, 5))


def test_fti9_a_row_has_the_words_of_its_frame(tmp_path):
    (tmp_path / "sticks").write_text(
        "time_ms,roll,switch8\n1000,3000,4095\n", "ascii")
    flight = fetch(tmp_path, "--seconds", "3", "--sticks", "sticks")
    words = [name for name in recordings.columns_of((0,) * 72)
             if name.startswith(("mcs.", "pwm."))]
    assert len(words) == 28 + 14 + 14
    # The aircraft's frame begins after the ground's: its row is one ahead of
    # the end of a ground's frame.
    for place in (5, 40, 48, 49, 50, 51, 52, 53, 100):
        row = recordings.columns_of(flight.aboard[place])
        found = [at for at in range(place - 2, place + 4) if all(
            flight.record[name][at] == row[name] for name in words)]
        assert found, place


def test_fti9_a_row_has_the_laws_report_and_the_last_error(tmp_path):
    """With a failed surface and a lost link, so that no word is 0."""
    (tmp_path / "sticks").write_text(
        "time_ms,switch2\n500,4095\n", "ascii")
    flight = fetch(
        tmp_path, "--plant", "jsbsim", "--seconds", "9", "--sticks", "sticks",
        faults="2000 surface left_elevator stuck 1500\n7000 cut 2000\n",
        changes=None)
    names = [f"laws.{name}" for name in (
        "lateral", "vertical", "power", "link", "invalid_low",
        "invalid_high", "silent", "failed")]
    rows = [recordings.columns_of(row) for row in flight.aboard]
    own = [tuple(row[name] for name in names) for row in rows]
    seen = set(zip(*(flight.record[name] for name in names), strict=True))
    assert {modes[-1] for modes in own} > {0}
    assert max(modes[-2] for modes in own) > 50
    assert seen - set(own) == set()

    kinds = [TABLES["error_kinds"][row["recorder.last_error"] - 1]
             for row in rows if row["recorder.errors"] > 0]
    logged = [json.loads(line) for line in
              flight.path("events.jsonl").read_text("utf-8").splitlines()]
    assert set(kinds) <= {event["kind"] for event in logged
                          if event["node"] == "mcs"}
    assert "surface_failed" in kinds


def test_fti10_a_request_stops_the_recorder(tmp_path):
    """Earlier than the second after a landing, here of a flight of a frame."""
    flight = fetch(tmp_path / "a", "--seconds", "4",
                   orders=order(400, 0, 5), changes=(20,))
    assert flight.fetched.in_order() == flight.aboard[:5]
    last = recordings.columns_of(flight.aboard[-1])
    assert last["time_ms"] < 700


def test_fti9_a_flight_has_the_same_bytes_with_any_recorder(tmp_path):
    faults = ("1000 up ber 0.001 4000\n1000 down ber 0.001 4000\n"
              "2500 mcs reset warm\n3500 cut 1000\n")
    options = ("--seconds", "6", "--laws", "on")
    flights_ = [fetch(tmp_path / f"{length}", *options, faults=faults,
                      length=length) for length in (0.02, 600)]
    assert len(flights_[0].aboard) == len(flights_[1].aboard)
    for name in ("record.csv", "wire.csv", "events.jsonl"):
        one, other = (flight.path(name).read_bytes() for flight in flights_)
        assert one == other, name


def test_fti9_recorders_with_wrong_rows_are_reported(tmp_path):
    flight = fetch(tmp_path / "a", "--seconds", "3")
    path = tmp_path / "b.recording"
    lines = (tmp_path / "a" / "aboard.recording").read_text(
        "ascii").splitlines(keepends=True)
    # A damaged row, and a half one at the end.
    place = 4 * 40
    lines[10] = lines[10][:place] + "ffff" + lines[10][place + 4:]
    path.write_text("".join(lines)[:-100], "ascii")
    read = recordings.Recording(path)
    assert read.wrong == [11]
    assert read.rows == flight.aboard[:9] + flight.aboard[10:-1]
    whole = flights.read(tmp_path / "a" / "aboard.recording",
                         lambda record: None)
    assert list(whole.columns["mcs.downlink.alpha"][-5:]) == [1_000] * 5

# SPDX-License-Identifier: Apache-2.0
"""EVI-9: whatever was late in a flight in real time is found, and whether the
machine had paused then."""

import os
import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "evidence"))

import machine_pauses  # noqa: E402
import timing  # noqa: E402
from flight_numbers import NUMBERS  # noqa: E402
from machine_pauses import Pauses  # noqa: E402

COUNTS = ("overruns", *(
    f"link.{way}_{count}" for way in ("uplink", "downlink")
    for count in ("sent", "received", "bad", "scrapped")),
    "link.mcs_resets", "link.gsc_resets")


def flight(frames=10):
    """A record of each node in which nothing is late."""
    return {
        node: [
            {"frame": number, "clock_us": NUMBERS.frame_us * number,
             **dict.fromkeys(COUNTS, 0)}
            for number in range(frames)
        ]
        for node in ("mcs", "gsc")
    }


def found_in(records, ways=()):
    return {
        kind: places
        for kind, places in timing.deviations(ways, records).items() if places
    }


def test_nothing_is_found_where_nothing_is_late():
    assert found_in(flight(), [(0, 60_000), (100_000, 150_000)]) == {}


def test_a_row_that_is_missing_is_found():
    records = flight()
    del records["gsc"][4:6]
    assert found_in(records) == {
        "frames without a row": [(2, 60_000, 120_000)]
    }


def test_a_change_out_of_bounds_is_found_either_way():
    least, most = (1_000 * each for each in timing.LATENCY_MS)
    edge = 1_000 * timing.LENIENCY_MS
    begin = 1_000_000
    ways = [(begin, begin + way) for way in (
        least - edge, most + edge, least - edge - 1, most + edge + 1
    )]
    assert found_in(flight(), ways) == {
        "changes not within the bounds":
            [(1, begin - timing.RECOVERY_US, there) for _, there in ways[2:]]
    }


def test_a_pause_explains_what_it_touches_and_nothing_else():
    pauses = Pauses([(5_000, 30_000), (9_000, 9_600), (80_000, 80_500)])
    assert pauses.longest == 25_000
    assert pauses.within(29_000, 40_000)
    assert pauses.within(0, 5_000)
    assert pauses.within(80_200, 80_300)
    assert not pauses.within(30_001, 79_999)
    assert not pauses.within(80_501, 10**9)
    assert not Pauses([]).within(0, 10**9)
    places = [(2, 0, 4_000), (3, 20_000, 21_000)]
    assert timing.count_explained(places, pauses) == 3
    assert timing.count_explained(places, pauses, later_us=5_000) == 5


def test_a_change_that_never_comes_is_out_of_bounds():
    changes = [(timing.CHANGE_US * number, number) for number in (1, 2, 3)]
    rows = [
        {"servos_us": 5_000 + changes[number - 1][0] + 60_000,
         "pwm.left_aileron": number}
        for number in (1, 3)
    ]
    ways = timing.ways_of(
        changes, {"gsc": {"switched_on_us": 5_000}}, {"mcs": rows})
    assert [timing.latency_ms(way) for way in ways] == [
        60, timing.CHANGE_US / 1_000, 60
    ]
    assert [timing.is_in_bounds(way) for way in ways] == [True, False, True]


# --- which counts, whose bounds, and what comes of it ------------------------

@pytest.mark.parametrize("node, column, kind", [
    *[(node, "overruns", "overruns") for node in ("mcs", "gsc")],
    *[(node, f"link.{name}", "link errors") for node, names in {
        "mcs": ("uplink_bad", "downlink_scrapped", "mcs_resets"),
        "gsc": ("downlink_bad", "uplink_scrapped", "gsc_resets"),
    }.items() for name in names]])
def test_every_count_of_either_node_is_looked_at(node, column, kind):
    records = flight()
    records[node][7][column] = 2
    for row in records[node][8:]:
        row[column] = 3
    assert found_in(records) == {
        kind: [(2, 100_000, 140_000), (1, 120_000, 160_000)]}


def test_the_bounds_are_those_of_the_design():
    design = (ROOT / "docs" / "design.md").read_text("utf-8")
    scan_to_servo = int(re.search(
        r"2p \+ (\d+) ms for p = 0 \.\. 3$", design, re.M)[1])
    waits = re.search(r"waits for its scan from 0 to (\d+) ms more, and for\n"
                      r"its channel ([\d.]+) ms", design)
    least = 2 * timing.PHASE + scan_to_servo
    assert timing.PHASE == 3
    assert timing.LATENCY_MS[0] == least
    assert timing.LATENCY_MS[1] == pytest.approx(
        least + int(waits[1]) + float(waits[2]), abs=0.02)
    assert timing.LENIENCY_MS == 1
    assert timing.FRAME_US == NUMBERS.frame_us


def summary(node):
    tasks = {"mcs": ("ad_task", "pwm_task"), "gsc": ("ad_task",)}[node]
    four = {"min": 1, "median": 2, "p99": 3, "max": 4}
    return {"frames": 10, "overruns": 0, "switched_on_us": 0,
            "cost_us": {task: four for task in tasks},
            "response_us": {task: four for task in tasks},
            "release_jitter_us": four}


@pytest.fixture
def concluded(monkeypatch, capsys):
    """The exit status and what is said of a flight with these pauses."""

    def conclude(records, pauses, ways=()):
        summaries = {node: summary(node) for node in records}
        monkeypatch.setattr(timing, "fly", lambda *_: (
            [], summaries, records, None, pauses))
        monkeypatch.setattr(timing, "ways_of", lambda *_: list(ways))
        monkeypatch.setattr(sys, "argv", ["timing.py", "--seconds", "5"])
        return timing.main(), capsys.readouterr().out

    return conclude


def with_overrun(at=7):
    records = flight()
    for row in records["mcs"][at:]:
        row["overruns"] = 1
    return records


@pytest.mark.parametrize("pauses, status", [
    ([], 1), ([(110_000, 120_000)], 0), ([(90_000, 100_000)], 0),
    # Too early, too late, or a second beside it.
    ([(90_000, 99_999)], 1), ([(140_001, 150_000)], 1),
    ([(1_110_000, 1_120_000)], 1), (None, 0)])
def test_what_no_pause_explains_fails(concluded, pauses, status):
    result, said = concluded(with_overrun(), pauses)
    assert result == status
    assert ("1 of these without a pause" in said) == (status == 1)
    assert ("pauses of the machine were not recorded" in said) == (pauses is None)


# --- who watches for pauses ----------------------------------------------------

def test_a_late_wake_is_a_pause_and_a_punctual_one_is_none(monkeypatch):
    # The excess of each sleep, in microseconds.
    late = iter([0, 100, 499, 500, 20_000, 0, 0, 0, 0, 0, 0])
    now = [0]

    def sleep(seconds):
        now[0] += round(seconds * 1e6) + next(late, 0)

    monkeypatch.setattr(machine_pauses, "now_us", lambda: now[0])
    monkeypatch.setattr(machine_pauses.time, "sleep", sleep)
    for name in ("sched_setaffinity", "sched_setscheduler"):
        monkeypatch.setattr(machine_pauses.os, name, lambda *_: None)
    found = []
    machine_pauses.watch(0, os.SCHED_OTHER, 0.02, found)
    assert found == [(4_000, 4_500), (5_500, 25_500)]

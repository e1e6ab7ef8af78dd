"""EVI-9: whatever was late in a flight in real time is found, and whether the
machine had paused then."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import timing  # noqa: E402
from machine_pauses import Pauses  # noqa: E402

COUNTS = ("overruns", *timing.LINK_ERRORS["mcs"], *timing.LINK_ERRORS["gsc"])


def flight(frames=10):
    """A record of each node in which nothing is late."""
    return {
        node: [
            {"frame": number, "clock_us": 20_000 * number,
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


def test_overruns_are_found_from_a_frame_before():
    records = flight()
    for row in records["mcs"][7:]:
        row["overruns"] = 3
    assert found_in(records) == {"overruns": [(3, 100_000, 140_000)]}


def test_link_errors_are_found_from_a_frame_before():
    records = flight()
    for row in records["gsc"][7:]:
        row["link.gsc_resets"] = 1
        row["link.downlink_bad"] = 1
    assert found_in(records) == {"link errors": [(2, 100_000, 140_000)]}


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

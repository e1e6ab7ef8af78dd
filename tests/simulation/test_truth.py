# SPDX-License-Identifier: Apache-2.0
"""SIM-3: the record of a flight of the aircraft shows what it really does, in
the last columns: at the time of the row, in the units that their names say."""

import math
import re

import pytest
from conftest import FRAME_MS, FRAMES_PER_S, NUMBERS, TICK_US, fly_in
from test_flight import has_jsbsim

NAMES = [f"truth.{name}" for name in (
    "altitude_ft", "airspeed_kt", "bank_deg", "pitch_deg", "heading_deg",
    "alpha_deg", "beta_deg", "north_ft", "east_ft")]

FRAME_S = FRAME_MS / 1000
TICK_MS = TICK_US / 1000

# The aircraft waits a frame, and until the tick in which the servos get their
# commands.
WAITS_MS = FRAME_MS + NUMBERS.servo_tick * TICK_MS
FT_S_PER_KT = 1.68781

# At 1800 ft above the sea the air is thinner than calibrated airspeed takes
# it for: the standard atmosphere's density there is 0.948 of that below.
TRUE_OF_CALIBRATED = 1 / math.sqrt(0.948)


@pytest.fixture(scope="module", autouse=True)
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """Left by 90 degrees, and half the way back."""
    return fly_in(tmp_path_factory.mktemp("flight"), "--plant", "jsbsim",
                  "--pilot", "standard", "--seconds", "60")


def test_later_columns_come_after_those_of_the_truth(flight):
    """Those of the control laws, then those of the frame's number."""
    names = list(flight.record)
    first = names.index(NAMES[0])
    laws = [name for name in names if name.startswith("laws.")]
    frame = [name for name in names if ".frame." in name]
    assert names[first:] == NAMES + laws + frame
    row = flight.path("record.csv").read_text().splitlines()[1000]
    decimals = [2, 2, 3, 3, 3, 3, 3, 2, 2]
    for value, count in zip(row.split(",")[first:first + len(NAMES)],
                            decimals, strict=True):
        assert re.fullmatch(rf"-?\d+\.\d{{{count}}}", value), value


def test_the_bench_has_no_such_columns(fly):
    assert not any(name.startswith("truth.")
                   for name in fly("--seconds", "0.1").record)


# Word of the downlink, what it is worth (docs/items.md), column.
SENSED = [
    ("altitude", 0, 0.5, "altitude_ft"),
    ("airspeed", 0, 0.03125, "airspeed_kt"),
    ("roll_attitude", 2048, 180 / 2048, "bank_deg"),
    ("pitch_attitude", 2048, 90 / 2048, "pitch_deg"),
    ("alpha", 2048, 0.0125, "alpha_deg"),
    ("beta", 2048, 0.0125, "beta_deg"),
]


@pytest.mark.parametrize("item, zero, unit, column", SENSED,
                         ids=[row[0] for row in SENSED])
def test_what_sensors_measure_is_the_truth(flight, item, zero, unit, column):
    """Rounded to a word; 10 to 30 ms before the row that has it at phase 3."""
    words = flight.record["mcs.downlink." + item]
    truth = flight.record["truth." + column]
    for row in range(10, len(words)):
        then = truth[row - 2:row + 1]
        measured = unit * (words[row] - zero)
        rounding = 0.51 * unit + 0.005
        assert min(then) - rounding <= measured <= max(then) + rounding, row
    # Not of a standstill.
    assert len({*truth}) > 50


def travelled(record, first, last):
    """North and east from one row to another, by heading and speed. The path
    is below the nose by alpha, which a bank turns to the outside."""
    north = east = 0.0
    for row in range(first, last):
        bank = math.radians(record["truth.bank_deg"][row])
        heading = math.radians(
            record["truth.heading_deg"][row]
            + record["truth.beta_deg"][row] * math.cos(bank)
            - record["truth.alpha_deg"][row] * math.sin(bank))
        way = (record["truth.airspeed_kt"][row] * TRUE_OF_CALIBRATED
               * FT_S_PER_KT * FRAME_S)
        north += way * math.cos(heading)
        east += way * math.sin(heading)
    return north, east


# Straight east; the turn to the north; north.
@pytest.mark.parametrize("first, last", [(10, 750), (750, 1300),
                                         (1300, 2200), (10, 2999)])
def test_north_and_east_are_what_heading_and_speed_make(flight, first, last):
    record = flight.record
    north, east = travelled(record, first, last)
    assert math.hypot(north, east) > 1000
    error = 0.005 * FRAME_S * (last - first) * 70 * FT_S_PER_KT
    assert record["truth.north_ft"][last] - record["truth.north_ft"][first] \
        == pytest.approx(north, abs=error)
    assert record["truth.east_ft"][last] - record["truth.east_ft"][first] \
        == pytest.approx(east, abs=error)


def test_it_begins_as_documented(flight):
    first = flight.rows[0]
    assert first["truth.altitude_ft"] == pytest.approx(1000, abs=0.1)
    assert first["truth.airspeed_kt"] == pytest.approx(70, abs=0.05)
    assert first["truth.heading_deg"] == pytest.approx(90, abs=0.05)
    assert (first["truth.north_ft"], first["truth.east_ft"]) == (0, 0)


def test_left_is_negative_and_down_the_heading(flight):
    """In the middle of the left turn, 25 degrees of bank."""
    turn = flight.rows[20 * FRAMES_PER_S]
    assert -30 < turn["truth.bank_deg"] < -15
    assert 20 < turn["truth.heading_deg"] < 80
    assert flight.rows[50 * FRAMES_PER_S]["truth.bank_deg"] > 15


@pytest.mark.parametrize("phase", range(10))
def test_the_truth_is_that_of_the_row_s_time(tmp_path, phase):
    """At any time at which the servos have their commands within the ground's
    frame: at a steady speed east the place shows the time."""
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "2",
                    "--phase", phase)
    # The aircraft waits until the servos have had their first commands.
    begins_ms = WAITS_MS + TICK_MS * phase
    speed = 70 * TRUE_OF_CALIBRATED * FT_S_PER_KT
    for row in flight.rows[10:]:
        flown_ms = row["truth.east_ft"] / speed * 1000
        assert flown_ms == pytest.approx(row["time_ms"] - begins_ms, abs=3), \
            row["frame"]


def test_the_time_of_a_crash_is_that_of_the_last_change(tmp_path):
    """The link is cut as the pilot rolls into a turn, and stays so. No law
    takes over."""
    (tmp_path / "faults.txt").write_text("17000 cut 60000\n")
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--pilot", "standard",
                    "--seconds", "60", "--laws", "off", "--faults",
                    "faults.txt")
    quality = flight.summary["flight_quality"]
    assert (quality["crashed"], quality["ended_level"]) == (True, False)
    truths = [tuple(row[name] for name in NAMES) for row in flight.rows]
    still = len(truths) - 1
    while truths[still - 1] == truths[-1]:
        still -= 1
    # An aircraft moves in every frame until it is at rest.
    assert 20 * FRAMES_PER_S < still < 40 * FRAMES_PER_S
    assert all(a != b for a, b in zip(
        truths[FRAMES_PER_S:still], truths[FRAMES_PER_S + 1:still + 1],
        strict=True))
    # The frame after the one that is the same for ever is the crash's.
    assert quality["crashed_at_s"] == \
        flight.record["time_ms"][still + 1] / 1000
    # A wing tip is 7 ft from the middle, and it fell fast.
    assert -10 < flight.rows[-1]["truth.altitude_ft"] < 15


def test_left_alone_it_stays_where_the_page_says(tmp_path):
    """docs/aircraft.md: with neutral sticks for 180 s, within 11 ft and 3
    degrees of heading."""
    record = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "180").record
    off = max(abs(altitude - 1000)
              for altitude in record["truth.altitude_ft"])
    turned = max(abs(heading - 90) for heading in record["truth.heading_deg"])
    assert 11 / 1.5 < off <= 11
    assert 3 / 1.5 < turned <= 3


@pytest.mark.parametrize("phase", range(10))
def test_saf1_before_the_first_commands_it_flies_on_the_safe_words(
        tmp_path, phase):
    """docs/aircraft.md: idle, for a frame at phases 0 to 3 and no longer; the
    aircraft does not notice."""
    flight = fly_in(tmp_path, "--plant", "jsbsim", "--seconds", "1",
                    "--phase", phase)
    # A row shows what the board holds as the ground's frame ends.
    flies_from_ms = WAITS_MS + TICK_MS * phase
    commands_from_ms = flies_from_ms + (FRAME_MS if phase < 4 else 0)
    for row in flight.rows:
        time_ms = row["time_ms"]
        safe = (row["pwm.throttle"], row["pwm.brake"]) == (0, 0xFFF)
        assert safe == (time_ms <= commands_from_ms), time_ms
        assert (row["truth.east_ft"] > 0) == (time_ms > flies_from_ms), \
            time_ms
    slowest = min(row["truth.airspeed_kt"] for row in flight.rows)
    assert slowest == pytest.approx(69.9, abs=0.1)

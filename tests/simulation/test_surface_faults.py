# SPDX-License-Identifier: Apache-2.0
"""SIM-5: what befalls a servo of the aircraft, on the bench and in flight. The
words for the servos stay as they are; the measured positions show it."""

import pytest
from conftest import FRAME_MS
from test_flight import has_jsbsim

REST = 0x800

# The roll stick goes to one side and back; its ailerons follow.
ASIDE = 3000
STICKS = f"time_ms,roll\n0,2048\n1000,{ASIDE}\n3000,2048\n5000,2048\n"
BENCH = ("--sticks", "sticks.csv", "--seconds", 5)


def at(flight, name, ms, of="mcs.downlink"):
    return flight.record[f"{of}.{name}"][ms // FRAME_MS]


@pytest.fixture
def flown(fly, write):
    """A flight on the bench with these faults."""

    def run(*faults, name="."):
        write("sticks.csv", STICKS)
        write("faults.txt", "".join(f"{line}\n" for line in ["# None.", *faults]))
        return fly(*BENCH, "--faults", "faults.txt", name=name)

    return run


def test_a_stuck_surface_stays_where_it_is(flown):
    """From the very tick on: two that stick a tick apart differ by a lag's
    part, and what is commanded then moves neither."""
    flight = flown("1150 surface left_aileron stuck",
                   "1152 surface right_aileron stuck")
    left, right = (flight.record[f"mcs.downlink.{side}_aileron"]
                   for side in ("left", "right"))
    settled = 1300 // FRAME_MS
    assert len({*left[settled:]}) == len({*right[settled:]}) == 1
    assert REST < left[-1] < right[-1] < ASIDE
    # A thirty-second of the way that is left.
    assert right[-1] - left[-1] == pytest.approx(
        (ASIDE - left[-1]) / 32, abs=1)
    assert at(flight, "left_aileron", 2900, of="pwm") == ASIDE


def test_a_surface_runs_to_a_place_and_stays(flown):
    flight = flown("500 surface left_aileron stuck 0x5dc")
    assert at(flight, "left_aileron", 480) == REST
    assert 1500 < at(flight, "left_aileron", 540) < REST
    assert {at(flight, "left_aileron", ms)
            for ms in range(1500, 5000, 100)} == {1500}
    assert at(flight, "right_aileron", 2900) == ASIDE


def test_a_floating_surface_comes_to_rest_without_wind(flown):
    flight = flown("2000 surface right_aileron float")
    assert at(flight, "right_aileron", 1980) > ASIDE - 2
    assert at(flight, "right_aileron", 2900) == REST
    assert at(flight, "left_aileron", 2900) == ASIDE


def test_a_slow_surface_moves_at_a_part_of_its_speed(flown):
    """At a quarter it is after 400 ms where the other was after 100."""
    flight = flown("0 surface left_aileron slow 25")
    slow, quick = (flight.record[f"mcs.downlink.{side}_aileron"]
                   for side in ("left", "right"))
    # CORE has zeros until the first scan.
    leaves = next(place for place, word in enumerate(quick) if word > REST)
    for frames in (5, 8):
        way = quick[leaves + frames] - REST
        assert slow[leaves + 4 * frames + 3] - REST == pytest.approx(
            way, rel=0.05), frames
        assert slow[leaves + frames] - REST < 0.6 * way
    assert slow[2900 // FRAME_MS] > ASIDE - 30


def test_a_later_fault_takes_the_place_of_the_one_before(flown):
    """In whatever order they are written, the later line's at one time."""
    flight = flown("3500 surface left_aileron slow 99",
                   "1500 surface left_aileron stuck 100",
                   "0 surface right_aileron stuck 200",
                   "0 surface right_aileron stuck 300")
    assert at(flight, "left_aileron", 3400) < 110
    assert at(flight, "left_aileron", 4900) == REST
    assert at(flight, "right_aileron", 4900) == 300


def test_only_measured_positions_and_what_follows_differ(flown):
    """The nodes and the link have nothing to do with it."""
    broken = flown("100 surface steering stuck 0",
                   "100 surface throttle float", "100 surface brake slow 1",
                   "100 surface left_rudder stuck 7", name="broken")
    sound = flown(name="sound")
    differ = {name for name in sound.record
              if sound.record[name] != broken.record[name]}
    assert differ == {"mcs.downlink.left_rudder", "gsc.downlink.left_rudder"}


# --- in flight --------------------------------------------------------------

in_flight = pytest.mark.skipif(
    not has_jsbsim(), reason="make fly installs JSBSim")
LEVEL = ("--plant", "jsbsim", "--pilot", "level", "--seconds", 8)


@in_flight
def test_the_aircraft_has_the_faults_in_flight(fly, write):
    """Stuck to the right, slow and loose: positions are true, and the aircraft
    rolls according to its ailerons."""
    write("faults.txt",
          "1000 surface left_aileron stuck 2348\n"
          "1000 surface right_elevator stuck\n"
          "1000 surface left_flap_1 stuck 4095\n"
          "1000 surface left_flap_2 slow 50\n"
          "1000 surface right_rudder float\n"
          "1000 surface throttle stuck 0\n"
          "7000 surface left_flap_1 stuck\n")
    record = fly(*LEVEL, "--faults", "faults.txt").record
    sensed = {name.removeprefix("mcs.downlink."): words
              for name, words in record.items() if "mcs.downlink" in name}
    fault, later = 1040 // FRAME_MS, 2000 // FRAME_MS
    assert {*sensed["left_aileron"][later:]} == {2348}
    assert len({*sensed["right_elevator"][fault + 2:]}) == 1
    assert len({*sensed["left_elevator"][fault + 2:]}) > 5
    # 5 deg/s for a flap: 15 deg take three seconds, as many more no time.
    half = sensed["left_flap_1"][2500 // FRAME_MS]
    assert half == pytest.approx(REST + 2047 / 2, abs=200)
    assert sensed["left_flap_1"][4500 // FRAME_MS] > 4000
    assert {*sensed["left_flap_2"][fault:]} == {REST}
    # The rudder trails: to the left of the fin with wind from the right.
    beta = [record["truth.beta_deg"][place] for place in range(later, 400)]
    trails = [(word - REST) * 0.0125
              for word in sensed["right_rudder"][later:400]]
    worst = max(range(len(beta)), key=lambda place: abs(beta[place]))
    assert abs(beta[worst]) > 0.5
    assert trails[worst] == pytest.approx(-0.3 * beta[worst], abs=0.1)
    # Rolled right at first, and without an engine slow in the end.
    assert record["truth.bank_deg"][1800 // FRAME_MS] > 2
    assert record["truth.airspeed_kt"][-1] < 67


@in_flight
def test_a_slow_servo_is_as_slow_in_flight(fly, write):
    """At a tenth of 100 deg/s it takes a second for ten degrees."""
    write("sticks.csv", "time_ms,roll,throttle\n0,2048,2048\n"
          "1000,3048,2048\n3000,3048,2048\n")
    write("faults.txt", "500 surface right_aileron slow 10\n")
    record = fly("--plant", "jsbsim", "--sticks", "sticks.csv",
                 "--faults", "faults.txt").record
    begins = record["pwm.left_aileron"].index(3048)
    sound = record["mcs.downlink.left_aileron"]
    slow = record["mcs.downlink.right_aileron"]
    assert sound[begins + 25] - REST > 950
    speed = (slow[begins + 40] - slow[begins + 20]) * 0.01 / 0.4
    assert speed == pytest.approx(7.5, abs=2.5)
    assert slow[begins + 25] - REST < 500

# SPDX-License-Identifier: Apache-2.0
"""EXT-6: a sound surface is never reported as failed, however quick or slow its
servo is, and whatever the sticks do. A sample of the flights of
evidence/laws/sound_flights.py; the servos of a flight's conditions (SIM-4)."""

import json
import statistics
import sys

import pytest
from conftest import FRAME_MS, ROOT
from test_flight import has_jsbsim

sys.path.insert(0, str(ROOT / "evidence" / "laws"))

import sound_flights  # noqa: E402

NEEDS_JSBSIM = pytest.mark.skipif(
    not has_jsbsim(), reason="make fly installs JSBSim")
PLANTS = ["bench", pytest.param("jsbsim", marks=NEEDS_JSBSIM)]


@pytest.mark.parametrize("phase", [0, 9])
@pytest.mark.parametrize("schedule", ["report", "fast"])
def test_ext6_a_roll_step_on_the_bench_is_no_failure(
        fly, write, phase, schedule):
    """With the law that damps the rates, and a step of 71 %."""
    write("sticks.csv", "time_ms,roll,switch1\n0,2048,4095\n"
          "3000,3500,4095\n12000,3500,4095\n")
    flight = fly("--laws", "on", "--sticks", "sticks.csv", "--phase", phase,
                 "--schedule", schedule)
    assert set(flight.record["laws.failed"]) == {0}
    assert "failed_surfaces" not in flight.summary


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("lag, rate", [(50, 150), (150, 50)])
def test_ext6_d32_quick_and_slow_servos_are_sound(fly, write, plant, lag, rate):
    """From stop to stop, on all axes, with the widest dead band."""
    write("conditions.txt", f"servos {lag} {rate} 1\n")
    write("sticks.csv", "time_ms,roll,pitch,yaw,throttle,switch8\n" + "".join(
        f"{time},{word},{word},{word},{word},{word}\n"
        for place, time in enumerate(range(0, 6001, 340))
        for word in [4095 if place % 2 else 0]))
    flight = fly("--plant", plant, "--laws", "on", "--sticks", "sticks.csv",
                 "--conditions", "conditions.txt")
    assert set(flight.record["laws.failed"]) == {0}


@pytest.mark.parametrize("seeds", [
    [seed for seed in range(1, 61) if sound_flights.plant_of(seed) == "bench"],
    pytest.param([10, 20, 30, 40, 50, 610], marks=NEEDS_JSBSIM)])
def test_ext6_no_flight_with_sound_servos_reports_a_failure(seeds):
    for seed in seeds:
        assert sound_flights.flown(seed).reported == [], seed


@pytest.mark.parametrize("plant", PLANTS)
@pytest.mark.parametrize("lag, quickest, slowest", [
    (100, 0.03, 0.13), (50, 0.01, 0.09), (200, 0.08, 0.25)])
def test_sim4_servos_have_the_lag_of_the_conditions(
        fly, write, plant, lag, quickest, slowest):
    """The time from a small step to 63 % of it, with two frames' delay."""
    write("conditions.txt", f"servos {lag} 100 0\n")
    write("sticks.csv", "time_ms,roll\n0,2048\n1000,2448\n2500,2448\n")
    flight = fly("--plant", plant, "--laws", "off", "--sticks", "sticks.csv",
                 "--conditions", "conditions.txt")
    begins = flight.record["pwm.left_aileron"].index(2448)
    reached = next(place for place, word in enumerate(
        flight.record["mcs.downlink.left_aileron"]) if word >= 2048 + 253)
    assert quickest < (reached - begins - 2) * FRAME_MS / 1000 < slowest


@NEEDS_JSBSIM
def test_sim4_servos_have_the_rate_limit_of_the_conditions(fly, write):
    """A flap: 5 deg/s and half of it, 136.5 words a degree."""
    write("sticks.csv", "time_ms,switch8\n0,0\n200,4095\n2500,4095\n")
    for rate in (100, 50):
        write("conditions.txt", f"servos 100 {rate} 0\n")
        flight = fly("--plant", "jsbsim", "--laws", "off", "--sticks",
                     "sticks.csv", "--conditions", "conditions.txt",
                     name=str(rate))
        words = flight.record["mcs.downlink.left_flap_1"]
        ways = [later - word for word, later in zip(words[50:], words[51:])]
        assert statistics.mean(ways) == pytest.approx(13.65 * rate / 100,
                                                      rel=0.03)


@pytest.mark.parametrize("plant", PLANTS)
def test_sim4_servos_rest_within_the_dead_band_of_the_conditions(
        fly, write, plant):
    """2 % of an aileron's travel: 80 words."""
    write("conditions.txt", "servos 100 100 2\n")
    write("sticks.csv", "time_ms,roll\n0,2048\n1000,2118\n2000,2448\n"
          "4000,2448\n")
    flight = fly("--plant", plant, "--laws", "off", "--sticks", "sticks.csv",
                 "--conditions", "conditions.txt")
    words = flight.record["mcs.downlink.left_aileron"]
    assert max(abs(word - 2048) for word in words[5:98]) <= 1
    assert 2448 - 82 <= words[-1] <= 2448 - 20


def test_sim4_the_usual_servos_change_nothing(fly, write):
    write("conditions.txt", "servos 100 100 0\n")
    write("sticks.csv", "time_ms,roll,pitch\n0,2048,100\n500,9,4000\n"
          "1500,2048,2048\n")
    flights = [fly("--sticks", "sticks.csv", *options, name=name)
               for name, options in (
                   ("plain", ()),
                   ("usual", ("--conditions", "conditions.txt")))]
    assert (flights[0].path("record.csv").read_bytes()
            == flights[1].path("record.csv").read_bytes())


@pytest.mark.parametrize("line, said", [
    ("servos 9 100 0", "LAG_PERCENT: \"9\" is not a number from 10 to 1000"),
    ("servos 100 1001 0", "RATE_PERCENT: \"1001\" is not a number"),
    ("servos 100 100 11", "DEAD_BAND_PERCENT: \"11\" is not a number"),
    ("servos 100 100",
     "the form of this condition is servos LAG_PERCENT RATE_PERCENT"),
    ("servos 100 100 0\nservos 100 100 0", "conditions.txt:2: servos is given twice"),
    ("wind 270 10", "the bench has no wind, only servos"),
    ("bias alpha 1", "the bench has no bias, only servos"),
])
def test_sim4_other_servos_are_refused(urv_sim, write, line, said):
    write("conditions.txt", line + "\n")
    result = urv_sim("fly", "--seconds", "0.1", "--conditions",
                     "conditions.txt")
    assert result.returncode != 0
    assert said in result.stderr
    assert len(result.stderr.strip().splitlines()) == 1


# --- the campaign's own -------------------------------------------------------

def test_a_report_after_a_crash_is_none(tmp_path):
    path = tmp_path / "record.csv"
    titles = "time_ms,truth.altitude_ft,laws.failed\n"
    path.write_text(titles + "20,9.5,0\n40,8.2,0\n60,8.2,0\n80,8.2,3\n")
    assert sound_flights.first_report(path) is None
    path.write_text(titles + "20,9.5,0\n40,8.2,3\n60,8.2,3\n")
    assert sound_flights.first_report(path) == 40


def test_flights_are_the_same_again_and_of_every_kind():
    drawn = [sound_flights.draw(seed) for seed in range(1, 60)]
    assert drawn == [sound_flights.draw(seed) for seed in range(1, 60)]
    text = json.dumps(drawn)
    for word in ("jsbsim", "bench", "fast", "report", "--lock", "--drift",
                 "--processors", "cut", "reset warm", "turbulence"):
        assert word in text, word

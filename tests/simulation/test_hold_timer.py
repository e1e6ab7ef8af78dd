# SPDX-License-Identifier: Apache-2.0
"""SAF-11, SAF-12: an aircraft without a controller does not fly on with frozen
outputs, and a restart in flight is not refused."""

import pytest
from conftest import SERVOS, fly_in
from safe_words import SAFE_ROW, unattended
from test_flight import has_jsbsim

STICKS = """time_ms,roll,throttle,brake,switch8
0,2048,2048,0,0
3000,3000,3000,0,4095
5000,2048,3000,0,0
8000,1500,1000,4095,0
"""
COMMANDED = (3000,) * 2 + (2048,) * 5 + (3000, 0) + (4095,) * 4 + (128,)


def pwm(flight):
    return list(zip(*(flight.record[f"pwm.{name}"] for name in SERVOS),
                    strict=True))


def flown(folder, faults, *options, sticks=STICKS, seconds="8"):
    (folder / "faults.txt").write_text(faults)
    (folder / "sticks.csv").write_text(sticks)
    return fly_in(folder, "--faults", "faults.txt", "--sticks", "sticks.csv",
                  "--seconds", seconds, *options)


def row_of(ms):
    return ms // 20 - 1


@pytest.mark.parametrize("plant", ["bench", "jsbsim"])
@pytest.mark.parametrize("laws", ["on", "off"])
@pytest.mark.parametrize("harm", ["ram 100 ffff", "rom 100 ff"])
def test_saf12_a_restart_in_flight_is_not_refused(
        tmp_path, plant, laws, harm):
    """A memory that has failed keeps no flying aircraft from its controller:
    the commands of 5 s reach the servos."""
    if plant == "jsbsim" and not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")
    flight = flown(tmp_path, f"3500 mcs {harm}\n4000 mcs reset processor\n",
                   "--plant", plant, "--laws", laws)
    rows = pwm(flight)
    assert rows[row_of(3900)] == COMMANDED
    assert set(rows[row_of(4000):row_of(4980)]) == {COMMANDED}
    assert rows[row_of(5200)][:2] == (2048, 2048)
    assert ("mcs", "self_test_failed") not in flight.events


STOPS = {"halt": "4000 mcs halt\n",
         "failed test": "3500 mcs ram 100 ffff\n4000 mcs reset warm\n",
         "halt in a start": "3995 mcs reset processor\n4000 mcs halt\n",
         "failed at every start":
             "3500 mcs rom 0 1\n4000 mcs reset warm\n4300 mcs reset warm\n"}


@pytest.mark.parametrize("stop", STOPS)
@pytest.mark.parametrize("laws", ["on", "off"])
def test_saf11_without_a_controller_the_outputs_are_safe_in_half_a_second(
        tmp_path, stop, laws):
    rows = pwm(flown(tmp_path, STOPS[stop], "--laws", laws))
    assert set(rows[row_of(3900):row_of(4460)]) == {COMMANDED}
    assert set(rows[row_of(4540):]) == {unattended(COMMANDED)}
    assert unattended(COMMANDED)[8] == 0


def test_saf11_a_brake_that_was_on_stays_on(tmp_path):
    """On the ground the pilot holds it; from power up it is on."""
    sticks = "time_ms,brake,throttle\n0,4095,0\n3000,4095,1500\n"
    rows = pwm(flown(tmp_path, "4000 mcs halt\n", sticks=sticks))
    assert set(rows[row_of(4540):]) == {SAFE_ROW}
    (tmp_path / "power_up").mkdir()
    rows = pwm(flown(tmp_path / "power_up",
                     "0 mcs ram 100 ffff\n", "--phase", "3"))
    assert set(rows) == {SAFE_ROW}


@pytest.mark.parametrize("how", ["warm", "processor"])
def test_saf11_a_reset_brings_a_halted_controller_back(tmp_path, how):
    flight = flown(tmp_path, f"4000 mcs halt\n4900 mcs reset {how}\n")
    rows = pwm(flight)
    assert rows[row_of(4900)] == unattended(COMMANDED)
    assert rows[row_of(5200)][7:9] == (3000, 0)
    assert flight.record["mcs.uplink.error"][-1] == 0


def test_saf11_a_halt_shorter_than_the_timer_moves_nothing(tmp_path):
    rows = pwm(flown(tmp_path, "4000 mcs halt\n4440 mcs reset processor\n"))
    assert set(rows[row_of(3900):row_of(4980)]) == {COMMANDED}


def test_saf11_a_lost_link_without_laws_holds_the_last_command(tmp_path):
    """The report's behaviour: the timer looks at the controller, and not at
    whether the words change."""
    rows = pwm(flown(tmp_path, "4000 cut 60000\n", seconds="20"))
    assert set(rows[row_of(4000):]) == {COMMANDED}


def test_saf11_a_halted_ground_is_a_lost_link(tmp_path):
    flight = flown(tmp_path, "4000 gsc halt\n", "--laws", "on")
    assert flight.record["laws.link"][-1] == 2
    assert set(flight.record["gsc.uplink.throttle"][row_of(4100):]) == {3000}


@pytest.mark.skipif(
    not has_jsbsim(), reason="JSBSim is not installed: make fly installs it")
@pytest.mark.parametrize("roll", [2048, 3000])
def test_saf11_an_aircraft_without_a_controller_glides_to_the_ground(
        tmp_path, roll):
    """From level flight, and from a roll at full power: idle, in a descending
    turn that does not steepen, no faster than in a normal descent."""
    sticks = ("time_ms,roll,throttle,brake\n0,2048,2048,0\n"
              f"11500,{roll},{roll},0\n")
    flight = flown(tmp_path, "12000 mcs halt\n", "--plant", "jsbsim",
                   "--laws", "on", sticks=sticks, seconds="65")
    rows = pwm(flight)
    assert set(rows[row_of(12540):]) == {unattended(rows[row_of(11000)])}
    halted = row_of(12000)
    assert max(map(abs, flight.record["truth.bank_deg"][halted:])) < 45
    assert max(flight.record["truth.airspeed_kt"][halted:]) < 95
    assert flight.record["truth.altitude_ft"][-1] < 10

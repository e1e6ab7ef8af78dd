# SPDX-License-Identifier: Apache-2.0
"""EXT-8: every active hold comes back to its target, whatever went before."""

import subprocess

import holds
import monitor
import pytest
from conftest import ROOT, fly_in
from test_flight import has_jsbsim

ON = 4095
FULL, IDLE, MIDDLE = 4095, 0, 2048
SECONDS = 150

# Holds are back at their targets this time after the last change.
BACK_S = 45


@pytest.fixture(autouse=True, scope="module")
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


def flown(folder, columns, rows, faults="# none", seconds=SECONDS):
    (folder / "sticks.csv").write_text("\n".join(
        [",".join(("time_ms", *columns))]
        + [",".join(map(str, row)) for row in rows]) + "\n")
    (folder / "faults.txt").write_text(faults + "\n")
    return fly_in(folder, "--plant", "jsbsim", "--laws", "on",
                  "--sticks", "sticks.csv", "--faults", "faults.txt",
                  "--seconds", str(seconds))


def furthest(flight, column, target, first, last):
    return max(abs(each - target) for each in
               flight.record[column][first * 50:last * 50])


def not_held(flight):
    return holds.check(flight.path("record.csv"),
                       flight.path("faults.txt")).not_held


def test_ext8_a_nose_held_up_comes_down_with_the_stick(tmp_path):
    """Full aft stick at idle, then full forward: 10 s later the nose is where
    the stick wants it, 12 degrees down."""
    flight = flown(tmp_path, ("pitch", "throttle", "switch2"),
                   ((0, MIDDLE, MIDDLE, ON), (5000, FULL, IDLE, ON),
                    (25000, IDLE, FULL, ON)), seconds=45)
    assert furthest(flight, "truth.pitch_deg", -12.0, 38, 45) < 2


def test_ext8_an_altitude_is_held_again_after_full_rudder(tmp_path):
    flight = flown(tmp_path, ("yaw", "throttle", "switch3", "switch4"),
                   ((0, MIDDLE, MIDDLE, ON, ON), (5000, 3500, MIDDLE, ON, ON),
                    (35000, MIDDLE, MIDDLE, ON, ON)))
    assert furthest(flight, "truth.altitude_ft", 1000.0,
                    35 + BACK_S, SECONDS) < 4
    assert not_held(flight) == []


ENGINE_AWAY = "10000 surface throttle stuck 0\n25000 surface throttle slow 99"


def test_ext8_an_altitude_is_held_again_after_the_engine_was_away(tmp_path):
    flight = flown(tmp_path, ("throttle", "switch2", "switch3"),
                   ((0, MIDDLE, ON, ON),), ENGINE_AWAY)
    assert furthest(flight, "truth.altitude_ft", 1000.0,
                    25 + BACK_S, SECONDS) < 4
    assert not_held(flight) == []


def test_ext8_an_altitude_is_held_again_with_the_link_lost(tmp_path):
    """The same in the orbit; the link is lost 1 s before the engine fails."""
    flight = flown(tmp_path, ("throttle",), ((0, MIDDLE),),
                   f"9000 cut 110000\n{ENGINE_AWAY}", seconds=115)
    assert furthest(flight, "truth.altitude_ft", 1000.0, 25 + BACK_S,
                    115) < 6
    assert not_held(flight) == []


def test_ext8_an_altitude_has_no_offset_at_another_airspeed(tmp_path):
    flight = flown(tmp_path, ("throttle", "switch2", "switch3"),
                   ((0, MIDDLE, ON, ON), (5000, IDLE, ON, ON),
                    (60000, FULL, ON, ON)))
    assert furthest(flight, "truth.altitude_ft", 1000.0, 60 + BACK_S,
                    SECONDS) < 4
    assert not_held(flight) == []


def test_ext8_an_airspeed_follows_the_lever(tmp_path):
    """20 per cent of the lever is 10 kt; nothing of it is missing."""
    flight = flown(tmp_path, ("throttle", "switch3"),
                   ((0, MIDDLE, ON), (5000, MIDDLE + 820, ON),
                    (65000, MIDDLE - 410, ON)), seconds=115)
    assert furthest(flight, "truth.airspeed_kt", 80.2, 50, 65) < 1.5
    assert furthest(flight, "truth.airspeed_kt", 65.0, 110, 115) < 1.5


def test_ext8_a_bank_is_reached_without_an_overshoot(tmp_path):
    """From 45 degrees to 45 of the other side and back."""
    flight = flown(tmp_path, ("roll", "throttle", "switch3"),
                   ((0, MIDDLE, MIDDLE, ON), (5000, FULL, MIDDLE, ON),
                    (25000, IDLE, MIDDLE, ON), (45000, MIDDLE, MIDDLE, ON)),
                   seconds=65)
    bank = flight.record["truth.bank_deg"]
    assert max(bank[5 * 50:25 * 50]) < 48 and min(bank[25 * 50:]) > -48
    assert max(bank[45 * 50:]) < 4
    altitude = flight.record["truth.altitude_ft"][5 * 50:]
    assert max(altitude) - min(altitude) < 20


def test_ext8_random_histories_leave_every_hold_held(tmp_path):
    """A few of the 2,000 of docs/control-laws.md."""
    done = subprocess.run(
        [ROOT / "bin/urv", "monte-carlo", "--pilot", "histories", "--flights",
         "2", "--workers", "2", "-o", tmp_path],
        capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "2 of 2 flights within all limits" in done.stdout


def test_saf9_ext8_the_monitor_sees_a_hold_that_is_not_held(tmp_path):
    """The flight without the engine passes; with 30 ft more at the end of its
    record it does not."""
    flight = flown(tmp_path, ("throttle", "switch2", "switch3"),
                   ((0, MIDDLE, ON, ON),), ENGINE_AWAY, seconds=90)

    def said():
        return monitor.check(
            flight.path("record.csv"), flight.path("sticks.csv"),
            faults=flight.path("faults.txt")).violations

    assert said() == []
    titles, *lines = flight.path("record.csv").read_text().splitlines()
    place = titles.split(",").index("mcs.downlink.altitude")
    cells = [line.split(",") for line in lines]
    for row in cells[60 * 50:]:
        row[place] = str(int(row[place]) + 60)
    flight.path("record.csv").write_text(
        "\n".join([titles, *map(",".join, cells)]) + "\n")
    assert [line for line in said() if "altitude is not held: +" in line]


# The motion of an aircraft, as rows of the record: altitude hold engaged at
# 1000 ft, with words of the sensors.
def rows(altitude_ft, seconds, airspeed_kt=70.0, throttle=2048):
    heard = (2048, 2048, 2048, 2048, 2048, 0, 0, ON, 0, 0, 0, 0, 0)
    for frame in range(seconds * 50):
        altitude = altitude_ft(frame / 50)
        yield holds.Row(
            frame * 20.0, heard, (2, 3 if frame else 0, 1 if frame else 0, 1),
            {"bank": 0.0, "pitch": 2.4, "altitude": altitude,
             "airspeed": airspeed_kt if frame > 1 else 70.0},
            throttle, altitude)


def test_saf9_a_hold_that_is_not_held_in_calm_is_seen():
    found = holds.judge(rows(lambda at: 1000 + 3.5 * at, 120),
                        holds.faults_of(""))
    assert len(found.not_held) == 1
    assert "altitude is not held: " in found.not_held[0]
    assert "off 1000" in found.not_held[0]


def test_saf9_an_offset_that_stays_is_seen():
    found = holds.judge(rows(lambda at: 1000 + min(at, 22), 120),
                        holds.faults_of(""))
    assert len(found.not_held) == 1


def test_saf9_a_hold_that_is_held_is_no_finding():
    found = holds.judge(rows(lambda at: 1000 + min(at, 4), 120),
                        holds.faults_of(""))
    assert found.not_held == []
    assert min(found.judged.values()) > 10
    assert {*found.judged} == {"bank", "altitude", "airspeed"}


@pytest.mark.parametrize("airspeed, throttle, faults, reason", [
    (60.0, 4095, "", "the engine cannot give this airspeed"),
    (70.0, 2048, "1000 surface throttle stuck 0",
     "throttle failed for good")])
def test_saf9_what_cannot_be_held_is_excepted_with_its_reason(
        airspeed, throttle, faults, reason):
    found = holds.judge(
        rows(lambda at: 1000, 120, airspeed, throttle),
        holds.faults_of(faults))
    assert found.not_held == []
    assert reason in found.reasons


def test_saf9_a_fault_that_ends_excuses_nothing():
    found = holds.judge(
        rows(lambda at: 1000 + 3.5 * at, 120),
        holds.faults_of(ENGINE_AWAY))
    assert len(found.not_held) == 1


def test_saf9_the_ground_is_no_place_to_hold_an_altitude():
    found = holds.judge(rows(lambda at: 1000 - 20 * at, 60),
                        holds.faults_of(""))
    assert found.landed
    assert "comes to the ground" in found.not_held[0]

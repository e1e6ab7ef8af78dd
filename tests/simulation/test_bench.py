# SPDX-License-Identifier: Apache-2.0
"""The bench plant: surfaces follow their servos with a lag (SIM-1)."""

import pytest
from conftest import FLAPS, SENSORS, columns

SURFACES = {
    "right_flap_1": "switch8", "left_flap_1": "switch8",
    "right_flap_2": "switch8", "left_flap_2": "switch8",
    "right_aileron": "roll", "left_aileron": "roll",
    "right_elevator": "pitch", "left_elevator": "pitch",
    "right_rudder": "yaw", "left_rudder": "yaw",
}

# 200 ms of peace, two seconds of deflection, two of the other way.
STEP_FRAME = 10
BACK_FRAME = 110


def stepped(stick, first, second):
    return (f"time_ms,{stick}\n0,{0 if stick == 'switch8' else 2048}\n"
            f"200,{first}\n2200,{second}\n4200,{second}\n")


@pytest.mark.parametrize("stick, first, second", [
    ("roll", 4095, 0), ("roll", 2049, 2048), ("pitch", 0, 4095),
    ("pitch", 1000, 1001), ("yaw", 3210, 123), ("switch8", 4095, 0),
    ("switch8", 0x800, 0x7FF),
])
def test_surfaces_follow_with_a_lag_and_arrive(fly, write, stick, first,
                                               second):
    write("sticks.csv", stepped(stick, first, second))
    flight = fly("--sticks", "sticks.csv")
    if stick == "switch8":
        first, second = 0xFFF, 0x800
    for surface, moved_by in SURFACES.items():
        servo = flight.record["pwm." + surface]
        sensed = flight.record["mcs.downlink." + surface][2:]
        if moved_by != stick:
            assert set(sensed) == {0x800}, surface
            continue
        assert {servo[BACK_FRAME - 5], servo[-1]} == {first, second}

        # It goes there steadily, not at once, and arrives exactly.
        there, back = sensed[:BACK_FRAME], sensed[BACK_FRAME:]
        assert (there[0], there[-1], back[-1]) == (0x800, first, second), \
            surface
        for leg, start, goal in ((there, 0x800, first),
                                 (back, first, second)):
            assert leg == sorted(leg, reverse=goal < start), surface
            if abs(goal - start) > 100:
                assert len(set(leg)) > 5, (surface, leg)


def test_flaps_follow_switch_8(fly, write):
    write("sticks.csv", stepped("switch8", 4095, 0))
    record = fly("--sticks", "sticks.csv").record
    for flap in FLAPS:
        servo = record["pwm." + flap]
        up, half = (servo.count(word) for word in (0x800, 0xFFF))
        assert half == BACK_FRAME - STEP_FRAME, flap
        assert up + half == len(servo), flap
    # Before the first command it is 0800h as every channel (INI-3).
    assert set(record["pwm.discretes"][3:]) == {0, 0x80}


def test_other_sensors_are_held(fly, write):
    write("sticks.csv", stepped("roll", 4095, 0))
    flight = fly("--sticks", "sticks.csv", "--seconds", "1")
    others = [name for name in SENSORS if name not in SURFACES]
    assert len(set(columns(flight, "gsc.downlink", others)[5:])) == 1


def test_a_scripted_surface_does_not_follow(fly, write):
    write("sticks.csv", stepped("roll", 4095, 0))
    write("sensors.csv", "time_ms,left_aileron\n0,77\n")
    record = fly("--sticks", "sticks.csv", "--sensors", "sensors.csv",
                 "--seconds", "1").record
    assert set(record["gsc.downlink.left_aileron"][5:]) == {77}
    assert record["gsc.downlink.right_aileron"][-1] > 4000


def test_the_lag_is_64_ms(fly, write):
    """A frame of ten ticks leaves (31/32)**10 of the way to go."""
    write("sticks.csv", stepped("roll", 4095, 0))
    sensed = fly("--sticks", "sticks.csv").record[
        "mcs.downlink.right_aileron"][2:]
    to_go = [word for word in sensed[BACK_FRAME:] if 200 < word < 4000]
    shares = [later / now for now, later in zip(to_go, to_go[1:])]
    assert len(shares) > 5
    assert all(abs(share - (31 / 32) ** 10) < 0.01 for share in shares), shares

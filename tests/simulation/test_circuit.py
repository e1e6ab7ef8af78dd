# SPDX-License-Identifier: Apache-2.0
"""SIM-7: a whole flight, judged by the true state in the record, and the
summary by the record."""

import pytest
from conftest import FRAMES_PER_S, fly_in
from test_flight import has_jsbsim

CIRCUITS = ("circuit", "damped-circuit")
CIRCUIT = ("--plant", "jsbsim", "--pilot", "circuit")

WINDS = {
    "calm": "# nothing\n",
    "left": "wind 0 10\nturbulence 15\n",
    "right": "wind 180 10\nturbulence 15\n",
}


@pytest.fixture(scope="module", autouse=True)
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


@pytest.fixture(scope="module", params=[
    (pilot, wind) for pilot in CIRCUITS for wind in WINDS], ids="-".join)
def flight(request, tmp_path_factory):
    """Both have the laws; nobody switches one on in the first."""
    pilot, wind = request.param
    folder = tmp_path_factory.mktemp(f"{pilot}-{wind}")
    (folder / "conditions.txt").write_text(WINDS[wind])
    flight = fly_in(folder, "--plant", "jsbsim", "--pilot", pilot,
                    "--conditions", "conditions.txt")
    damped = int(pilot == "damped-circuit")
    assert set(flight.record["laws.lateral"][100:]) == {damped}
    return flight


def truth(flight, name):
    return flight.record[f"truth.{name}"]


def touchdown(flight):
    """The frame in which the aircraft is where it is said to have touched
    down."""
    altitude, east = truth(flight, "altitude_ft"), truth(flight, "east_ft")
    along = flight.summary["circuit"]["touchdown_along_ft"]
    before = next(frame for frame in range(
        altitude.index(max(altitude)), len(east)) if altitude[frame] < 100)
    return next(frame for frame in range(before, len(east))
                if east[frame] >= along)


def test_it_lands_softly_on_the_centre_line_and_stops(flight):
    said = flight.summary["circuit"]
    assert said["crashed"] is False
    assert said["touchdown_sink_ft_s"] < 3.0
    assert abs(said["touchdown_offset_ft"]) < 25.0
    assert said["stopped_on_runway"] is True


def test_the_record_says_the_same(flight):
    """From standstill over the circuit's height to standstill."""
    said = flight.summary["circuit"]
    altitude, airspeed = truth(flight, "altitude_ft"), truth(
        flight, "airspeed_kt")
    north, east = truth(flight, "north_ft"), truth(flight, "east_ft")
    assert max(map(abs, north[:100] + east[:100])) < 1.0
    assert altitude[0] == pytest.approx(1.6, abs=0.2)
    assert 350 < max(altitude) < 450
    assert max(north) > 1500

    # The wheels' lowest points are 1.8 ft below the centre of gravity, and
    # those aft of it lower when the nose is up.
    frame = touchdown(flight)
    assert 1.6 < altitude[frame] < 2.6
    assert min(altitude[frame - 500:frame - 2]) > 1.7
    assert abs(said["touchdown_offset_ft"] - north[frame]) < 5.0
    assert abs(said["touchdown_airspeed_kt"] - airspeed[frame]) < 5.0
    # Between 20 and 2 ft above the wheels' own height it sinks slower and
    # slower.
    above = [feet - 1.6 for feet in altitude[:frame]]
    high = max(n for n, feet in enumerate(above) if feet > 20)
    low = max(n for n, feet in enumerate(above) if feet > 5)
    assert (20 - 5) / ((low - high) / FRAMES_PER_S) < 8.0

    last = slice(-100, None)
    assert max(east[last]) - min(east[last]) < 1.0
    assert north[-1] == pytest.approx(said["stop_offset_ft"], abs=0.5)
    assert east[-1] == pytest.approx(said["stop_along_ft"], abs=0.5)
    assert -100 < east[-1] < 2900
    assert abs(north[-1]) < 40


def test_brakes_steering_and_flaps_are_used(flight):
    frame = touchdown(flight)
    record = flight.record
    brake, flap = record["pwm.brake"], record["pwm.left_flap_1"]
    # Brake on before take-off, released in the air, on again afterwards.
    assert brake[100] == 0xFFF
    assert set(brake[frame - 500:frame - 100]) == {0x800}
    assert max(brake[frame:]) > 0xA00
    # Half flaps for the landing and not for take-off.
    assert set(flap[:1000]) == {0x800}
    assert set(flap[frame - 500:frame - 100]) == {0xFFF}
    # The wheel steers in the first seconds of the roll.
    assert len(set(record["pwm.steering"][160:400])) > 20


def test_what_the_pilot_sees_is_of_the_seed(tmp_path):
    """Exact sensors: nothing but his eyes differs."""
    flown = []
    for place, seed in enumerate((1, 1, 2)):
        folder = tmp_path / str(place)
        folder.mkdir()
        flown.append(fly_in(folder, *CIRCUIT, "--seconds", 12, "--seed",
                            seed).record["console.yaw"])
    assert flown[0] == flown[1] != flown[2]


def test_a_circuit_does_not_begin_in_the_air(urv_sim, write):
    write("conditions.txt", "start air\n")
    result = urv_sim("fly", *CIRCUIT, "--conditions", "conditions.txt")
    assert result.returncode == 2
    assert result.stderr == (
        "urv_sim: --pilot circuit and the condition \"start air\" do not go"
        " together\n")

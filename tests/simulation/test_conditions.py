# SPDX-License-Identifier: Apache-2.0
"""SIM-4: the conditions of a flight come from a file. Their effects are judged
by the true state and by the words, each against the line of the file."""

import math
import os
import statistics
import subprocess
import sys

import pytest
from conftest import PROGRAM, ROOT, SENSORS, TIME_LIMIT_S
from test_flight import has_jsbsim

JSBSIM = ("--plant", "jsbsim")
FPS_PER_KT = 1.68781


@pytest.fixture(autouse=True)
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


@pytest.fixture
def fly_so(fly, write):
    """Fly some seconds in these conditions, sticks neutral."""

    def run(text, *options, seconds=4, name="."):
        return fly(*JSBSIM, "--seconds", seconds, *options,
                   "--conditions", write("conditions.txt", text), name=name)

    return run


def truth(flight, name):
    return flight.record[f"truth.{name}"]


def differences(left, right, name):
    return [a - b for a, b in zip(
        left.record[name], right.record[name], strict=True)]


def test_a_file_that_says_nothing_changes_nothing(fly, fly_so):
    calm = fly(*JSBSIM, "--seconds", 4, name="calm")
    same = fly_so("# nothing\n\nstart air\n", name="same")
    for name in ("record.csv", "wire.csv", "events.jsonl"):
        assert same.path(name).read_bytes() == calm.path(name).read_bytes()


def test_wind_moves_the_aircraft_over_the_ground(fly, fly_so):
    """It heads east: a tailwind carries it on, wind from the left carries it
    south."""
    calm = fly(*JSBSIM, "--seconds", 4, name="calm")
    for heading, north, east in ((270, 0, 20), (0, -20, 0)):
        windy = fly_so(f"wind {heading} 20\n", name=str(heading))
        for axis, speed in (("north_ft", north), ("east_ft", east)):
            moved = differences(windy, calm, f"truth.{axis}")[-1]
            assert moved == pytest.approx(
                speed * FPS_PER_KT * 3.96, abs=0.15 * 20 * FPS_PER_KT * 4)
        assert truth(windy, "airspeed_kt")[-1] == pytest.approx(70, abs=2)


def test_turbulence_is_that_of_the_seed(fly_so):
    rough = [fly_so("turbulence 30\n", "--seed", seed, name=f"{place}")
             for place, seed in enumerate((1, 1, 2))]
    assert rough[0].rows == rough[1].rows
    assert truth(rough[0], "alpha_deg") != truth(rough[2], "alpha_deg")
    assert statistics.pstdev(truth(rough[0], "alpha_deg")) > 0.3


def test_sim4_turbulence_of_0_kt_is_calm_air(fly_so):
    """Its altitude was 44 ft off after 10 s."""
    calm, none = (fly_so(text, name=name) for text, name in (
        ("# nothing\n", "a"), ("turbulence 0\n", "b")))
    for name in ("altitude_ft", "bank_deg", "airspeed_kt"):
        assert truth(calm, name) == truth(none, name)


def test_ballast_is_carried(fly, fly_so):
    """More lift is needed, so more alpha: 10 per cent of 0.49 by 4.8."""
    calm = fly(*JSBSIM, "--seconds", 1, name="calm")
    heavy = fly_so("ballast 20 0\n", seconds=1, name="heavy")
    more = differences(heavy, calm, "truth.alpha_deg")[0]
    assert more == pytest.approx(math.degrees(0.1 * 0.49 / 4.8), abs=0.15)


def test_a_centre_of_gravity_further_aft_wants_less_up_elevator(fly, fly_so):
    """Neutral elevators then pitch the nose up."""
    calm = fly(*JSBSIM, "--seconds", 3, name="calm")
    aft = fly_so("ballast 20 10\n", seconds=3, name="aft")
    fore = fly_so("ballast 20 -10\n", seconds=3, name="fore")
    assert truth(fore, "pitch_deg")[-1] < truth(calm, "pitch_deg")[-1] \
        < truth(aft, "pitch_deg")[-1]


def test_bias_and_noise_are_those_of_the_sensor(fly, fly_so):
    """Neutral sticks: what is measured does not change the flight."""
    calm = fly(*JSBSIM, "--seconds", 6, name="calm")
    wrong = fly_so("bias altitude 25\nnoise roll_rate 2\nbias roll_rate -5\n",
                   seconds=6, name="wrong")
    assert truth(wrong, "bank_deg") == truth(calm, "bank_deg")
    for name in SENSORS:
        off = differences(wrong, calm, f"mcs.downlink.{name}")[10:]
        if name == "altitude":
            assert set(off) <= {49, 50, 51}
        elif name == "roll_rate":
            # 0.05 deg/s a word; the mean of 290 is good to 6 words.
            assert statistics.fmean(off) == pytest.approx(-100, abs=10)
            assert statistics.pstdev(off) == pytest.approx(40, rel=0.2)
        else:
            assert set(off) == {0}, name


def test_noise_is_that_of_the_seed(fly_so):
    noisy = [fly_so("noise alpha 1\n", "--seed", seed, name=f"{place}")
             .record["mcs.downlink.alpha"]
             for place, seed in enumerate((1, 1, 2))]
    assert noisy[0] == noisy[1] != noisy[2]


def test_a_start_on_the_runway_stands_until_the_brake_is_off(fly_so, write):
    sticks = write("sticks.csv", "time_ms,throttle,brake\n"
                                 "0,0,0xfff\n2000,0xfff,0x800\n")
    flight = fly_so("start runway\nwind 270 10\n", "--sticks", sticks,
                    seconds=5)
    east, height = truth(flight, "east_ft"), truth(flight, "altitude_ft")
    assert max(map(abs, east[:100])) < 0.1
    assert east[-1] > 15
    assert all(1.4 < feet < 1.8 for feet in height)
    assert truth(flight, "heading_deg")[0] == pytest.approx(90, abs=0.1)


@pytest.mark.parametrize(("text", "complaint"), [
    ("wnd 3 4", "1: unknown condition \"wnd\"; there are start,"
     " airframe, wind, turbulence, ballast, servos, bias, noise"),
    ("wind 3", "1: the form of this condition is wind FROM_DEG KT"),
    ("# wind\nwind 361 4", "2: FROM_DEG: \"361\" is not a number from 0 to"
     " 360 with at most 6 decimals"),
    ("turbulence -1", "1: KT: \"-1\" is not a number from 0 to 60 with at"
     " most 6 decimals"),
    ("bias error 1", "1: unknown sensor \"error\"; there are right_flap_1,"),
    ("bias alpha 1\nbias alpha 1", "2: bias of alpha is given twice"),
    ("wind 1 1\n\nwind 1 1", "3: wind is given twice"),
    ("start ground", "1: start: \"ground\" is neither \"air\" nor \"runway\""),
])
def test_what_is_wrong_is_said_with_its_line(urv_sim, write, text, complaint):
    write("conditions.txt", text + "\n")
    result = urv_sim("fly", *JSBSIM, "--conditions", "conditions.txt")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith(f"conditions.txt:{complaint}")


def test_conditions_need_the_aircraft(urv_sim, write):
    write("conditions.txt", "wind 270 10\n")
    result = urv_sim("fly", "--conditions", "conditions.txt")
    assert result.returncode == 2
    assert "add --plant jsbsim" in result.stderr


PARKED = "time_ms,throttle,brake\n0,0,0xfff\n"


@pytest.mark.parametrize("knots", [15, 30, 45, 60])
def test_a_parked_aircraft_stands_in_wind_from_anywhere(fly_so, write, knots):
    """It diverged: pitch grew with alpha up to 180 degrees, roll with beta up
    to 90, and nothing held the aircraft down."""
    sticks = write("sticks.csv", PARKED)
    for heading in range(0, 360, 45):
        flight = fly_so(f"start runway\nwind {heading} {knots}\n",
                        "--sticks", sticks, seconds=6, name=str(heading))
        where = f"wind {heading} {knots}"
        for axis in ("north_ft", "east_ft"):
            assert max(map(abs, truth(flight, axis))) < 0.1, where
        assert all(abs(degrees - 90) < 2
                   for degrees in truth(flight, "heading_deg")), where
        assert all(abs(degrees) < 12
                   for degrees in truth(flight, "bank_deg")), where
        assert all(0.9 < feet < 1.9
                   for feet in truth(flight, "altitude_ft")), where


def test_an_aircraft_let_go_in_a_storm_has_numbers_to_the_end(fly_so):
    """Sticks neutral: the brake is off, and the wind takes it along."""
    for heading in (0, 90, 180, 270):
        for knots in (30, 60):
            flight = fly_so(f"start runway\nwind {heading} {knots}\n",
                            seconds=20, name=f"{heading}-{knots}")
            for name, values in flight.record.items():
                assert all(map(math.isfinite, values)), (heading, name)


PLANT_WITH = """#!{python}
import sys
sys.path.insert(0, {folder!r})
sys.argv[0:1] = []
import plant

class Broken(plant.Aircraft):
    frames = 0

    def begin(self, commands):
        sensors, truth, shown = map(list, super().begin(commands))
        self.frames += 1
        if self.frames >= 50:
            {which}[{place}] = float({value!r})
        return sensors, truth, shown

plant.Aircraft = Broken
plant.main()
"""


def plant_with(path, **what):
    """An interpreter for URV_PYTHON whose aircraft has such a number from its
    50th frame on."""
    path.write_text(PLANT_WITH.format(
        python=sys.executable, folder=str(ROOT / "sim" / "jsbsim"), **what),
        encoding="utf-8")
    path.chmod(0o755)
    return path


@pytest.mark.parametrize(("which", "place", "name"), [
    ("sensors", 10, "alpha"), ("sensors", 26, "uplink_signal_strength"),
    ("truth", 0, "altitude"), ("shown", 8, "east_ft"),
])
@pytest.mark.parametrize("value", ["nan", "inf", "-inf"])
def test_sim3_a_number_that_is_not_finite_ends_the_flight(
        tmp_path, which, place, name, value):
    python = plant_with(
        tmp_path / "python", which=which, place=place, value=value)
    result = subprocess.run(
        [PROGRAM, "fly", *JSBSIM, "--seconds", "4", "--quiet",
         "--record", "record.csv"], cwd=tmp_path, text=True,
        capture_output=True, check=False, timeout=TIME_LIMIT_S,
        env={**os.environ, "URV_PYTHON": str(python)})
    assert result.returncode == 1
    assert result.stderr.startswith(
        f"urv_sim: --plant jsbsim: the aircraft's {name} is not a finite"
        " number at 10")
    assert len(result.stderr.splitlines()) == 1
    rows = (tmp_path / "record.csv").read_text("utf-8").splitlines()
    assert 49 <= len(rows) <= 53
    assert "nan" not in rows[-1] and "inf" not in rows[-1]


@pytest.mark.parametrize("broken", ["float('nan')", "0.5"])
def test_sim3_an_aircraft_that_does_not_settle_is_refused(tmp_path, broken):
    python = tmp_path / "python"
    python.write_text(f"""#!{sys.executable}
import sys
sys.path.insert(0, {str(ROOT / "sim" / "jsbsim")!r})
sys.argv[0:1] = []
import plant

class Node:
    def get_double_value(self):
        return {broken}

class Broken(plant.Aircraft):
    def must_be_sound(self):
        self.altitude = Node()
        self.sensors[0][25] = self.altitude.get_double_value
        super().must_be_sound()

plant.Aircraft = Broken
plant.main()
""", encoding="utf-8")
    python.chmod(0o755)
    result = subprocess.run(
        [PROGRAM, "fly", *JSBSIM, "--seconds", "1", "--quiet"],
        cwd=tmp_path, text=True, capture_output=True, check=False,
        timeout=TIME_LIMIT_S, env={**os.environ, "URV_PYTHON": str(python)})
    why = {"0.5": "it touches the ground"}.get(
        broken, "JSBSim's numbers are not finite")
    assert (result.returncode, result.stderr) == (
        2, "urv_sim: --plant jsbsim: the aircraft does not settle in these"
        f" conditions: {why}\n")

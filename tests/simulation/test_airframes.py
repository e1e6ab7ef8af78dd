# SPDX-License-Identifier: Apache-2.0
"""SIM-10, D-91: aircraft that come with JSBSim fly in place of URV's own, with the
controls in the pilot's sense around JSBSim's trim."""

import json
import subprocess
import sys

import pytest
from conftest import ROOT
from test_flight import has_jsbsim

JSBSIM = ("--plant", "jsbsim")
SPEEDS_KT = {"c172p": 90, "c182": 100, "J3Cub": 60}
SEES = 2048


@pytest.fixture(autouse=True)
def _jsbsim_is_there():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")


@pytest.fixture
def fly_one(fly, write):
    """Flies an airframe with these rows of sticks."""

    def run(airframe, rows="", seconds=8, more=""):
        sticks = write("sticks.csv",
                       f"time_ms,roll,pitch,yaw,throttle\n"
                       f"0,{SEES},{SEES},{SEES},{SEES}\n{rows}")
        return fly(*JSBSIM, "--laws", "off", "--seconds", seconds,
                   "--sticks", sticks,
                   "--conditions", write(
                       "conditions.txt", f"airframe {airframe}\n{more}"))

    return run


@pytest.mark.parametrize("airframe", SPEEDS_KT)
def test_sim10_it_flies_level_with_sticks_at_rest(fly_one, airframe):
    truth = fly_one(airframe, seconds=30).rows[-1]
    assert truth["truth.altitude_ft"] == pytest.approx(1000, abs=5)
    assert truth["truth.airspeed_kt"] == pytest.approx(
        SPEEDS_KT[airframe], abs=0.5)
    assert truth["truth.bank_deg"] == pytest.approx(0, abs=1)
    for side in ("left", "right"):
        for surface in ("aileron", "elevator", "rudder"):
            assert truth[f"gsc.downlink.{side}_{surface}"] == SEES


@pytest.mark.parametrize("airframe", SPEEDS_KT)
def test_sim10_controls_are_in_the_pilots_sense(fly_one, airframe):
    """A tenth of each stick for a second: the surface follows, with the sign
    of the stick, and the aircraft too."""
    moved = SEES + 205
    rows = "".join(
        f"{start},{','.join(str(moved if stick == each else SEES) for each in ('roll', 'pitch', 'yaw', 'throttle'))}\n"
        f"{start + 1000},{SEES},{SEES},{SEES},{SEES}\n"
        for start, stick in ((1000, "roll"), (4000, "pitch"), (7000, "yaw")))
    flight = fly_one(airframe, rows, seconds=9)

    def change(name, start):
        column = flight.record[name]
        return column[start // 20 + 40] - column[start // 20]

    for start, surface, answer, least in (
            (1000, "aileron", "truth.bank_deg", 1.5),
            (4000, "elevator", "truth.pitch_deg", 1.0),
            (7000, "rudder", "mcs.downlink.yaw_rate", 50)):
        for side in ("left", "right"):
            # Command and position have the same scale.
            assert change(f"mcs.downlink.{side}_{surface}",
                          start) == pytest.approx(205, abs=12)
        assert change(answer, start) > least


def test_sim10_full_throttle_climbs_and_idle_descends(fly_one):
    heights = [
        fly_one("c172p", f"500,{SEES},{SEES},{SEES},{throttle}\n",
                seconds=12).rows[-1]["truth.altitude_ft"]
        for throttle in (0, 4095)]
    assert heights[0] < 960 and heights[1] > 1020


def test_sim10_the_aircraft_of_urv_is_lambda(fly, write):
    flights = [fly(*JSBSIM, "--seconds", 3, "--conditions",
                   write("conditions.txt", text), name=name)
               for name, text in (("own", "# none\n"),
                                  ("named", "airframe lambda\n"))]
    for name in ("record.csv", "wire.csv", "events.jsonl"):
        one, other = (each.path(name).read_bytes() for each in flights)
        assert one == other


def test_sim10_turbulence_and_noise_are_those_of_the_seed(fly_one):
    more = "turbulence 5\nnoise alpha 0.1\nservos 200 100 0\n"
    one, other = (fly_one("c172p", more=more, seconds=3) for _ in range(2))
    assert one.rows == other.rows
    assert len(set(one.record["truth.alpha_deg"])) > 50


@pytest.mark.parametrize("text, complaint", [
    ("airframe c172", "1: unknown airframe \"c172\"; there are lambda, c172p,"
     " c182, J3Cub"),
    ("airframe", "1: the form of this condition is airframe"
     " lambda|c172p|c182|J3Cub"),
    ("airframe c172p\nairframe c172p", "2: airframe is given twice"),
    ("airframe c172p\nwind 90 5", "2: wind and another airframe than lambda"
     " do not go together"),
    ("ballast 1 1\nairframe c172p", "2: ballast and another airframe"),
    ("start air\nairframe c172p", "2: start and another airframe"),
])
def test_sim10_a_bad_condition_has_one_line(urv_sim, write, text, complaint):
    write("conditions.txt", text + "\n")
    result = urv_sim("fly", *JSBSIM, "--conditions", "conditions.txt")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr.startswith(f"conditions.txt:{complaint}")
    assert len(result.stderr.splitlines()) == 1


@pytest.mark.parametrize("options", [
    ("--pilot", "level", "--laws", "off"), ("--laws", "on"), (),
    ("--faults", "faults.txt", "--laws", "off")])
def test_sim10_pilot_laws_and_faults_are_for_the_own_aircraft(
        urv_sim, write, options):
    write("conditions.txt", "airframe c182\n")
    write("faults.txt", "1000 surface left_aileron stuck\n")
    result = urv_sim("fly", *JSBSIM, "--conditions", "conditions.txt",
                     *options)
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    assert (options or ("--laws on",))[0] in result.stderr
    assert "another airframe than lambda do not go together" in result.stderr


def test_d91_the_names_are_those_of_the_plant():
    """Both lists have the same aircraft."""
    sys.path.insert(0, str(ROOT / "sim" / "jsbsim"))
    import airframes
    assert airframes.AIRFRAMES == SPEEDS_KT


def test_gnd64_true_derivatives_are_those_of_the_models_file(tmp_path):
    """JSBSim's own coefficients; the centre of gravity and the slipstream
    change some a little."""
    path = tmp_path / "c172p.json"
    subprocess.run(
        [sys.executable, "-B", ROOT / "sim" / "jsbsim" / "derivatives.py",
         "--airframe", "c172p", "-o", path], check=True)
    found = json.loads(path.read_text("utf-8"))
    assert found["aircraft"] == "c172p"
    assert found["mass_slug"] == pytest.approx(58.4, abs=0.1)
    # Pilot before and below, fuel behind and above the centre of gravity.
    assert found["ixz_slug_ft2"] == pytest.approx(16.7, abs=0.1)
    true = found["derivatives"]
    for name, value in (("Cl_p", -0.484), ("Cl_aileron", 0.229),
                        ("CY_rudder", -0.187), ("CZ_alpha", -5.3),
                        ("Cn_p", -0.0278), ("Cn_r", -0.0937),
                        ("Cm_q", -12.4 - 7.27)):
        assert true[name] == pytest.approx(value, rel=0.02), name
    # The slipstream's dynamic pressure at the trim is 1.237 of the air's.
    assert true["Cm_elevator"] == pytest.approx(1.237 * 1.122, rel=0.03)
    assert true["Cn_rudder"] == pytest.approx(1.237 * 0.043, rel=0.03)

# SPDX-License-Identifier: Apache-2.0
"""EXT-7, GND-65: docs/evidence/margins.md is of the gains and of the aircraft as they
are, and no loop has less than is wanted."""

import json
import re
import sys
from types import SimpleNamespace

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence" / "laws"))

import law_gains  # noqa: E402

PAGE = (ROOT / "docs/evidence/margins.md").read_text(encoding="utf-8")
LEAST = PAGE.partition("\n## Margins\n")[2].partition("\nAt 200 lb")[0]


def test_the_page_is_of_these_gains_and_this_aircraft():
    assert law_gains.mark() in PAGE, "renew it: make -C evidence margins RENEW=--renew"


def test_every_loop_has_6_db_and_45_degrees():
    rows = [[cell.strip() for cell in line.split("|")[1:-1]]
            for line in LEAST.splitlines() if line.startswith("| ")][1:]
    assert [row[0] for row in rows] == [
        "roll, damping", "yaw damper, roll in damping", "roll, attitude",
        "yaw damper, roll in attitude", "pitch, damping", "pitch, attitude",
        "pitch, hold", "altitude", "airspeed",
        "roll, attitude, table 1", "yaw damper, roll in attitude, table 1",
        "pitch, attitude, table 1", "pitch, hold, table 1",
        "altitude, table 1", "airspeed, table 1"]
    for loop, gain, _, phase, _ in rows:
        assert float(gain) >= 6, loop
        assert phase == "none" or float(phase) >= 45, loop


def test_fixed_point_answers_as_designed():
    steps = PAGE.partition("\n## Fixed point")[2]
    differences = re.findall(r"\| ([0-9.]+) \|$", steps, re.M)
    assert len(differences) == 2
    assert all(float(each) < 0.2 for each in differences)


def column(text, head, speed):
    """By name, what a table of the page says at a speed."""
    lines = text[text.index(head):].split("\n\n")[0].splitlines()
    place = [cell.strip() for cell in lines[0].split("|")].index(speed)
    return {cells[1].strip(): cells[place].strip()
            for cells in (line.split("|") for line in lines[2:])}


def test_the_page_gets_the_new_results_of_one_condition(monkeypatch, capsys):
    """The models, the loops, their margins and poles, at 70 kt."""
    pytest.importorskip("control", reason="make -C evidence margins installs it")
    import margins
    monkeypatch.setattr(margins, "SPEEDS", (70,))
    monkeypatch.setattr(margins, "BALLASTS", (0,))
    of = law_gains.gains()
    result = margins.measured(of)
    assert max(result.misfits) < 0.03
    assert margins.complaints(result) == []
    again = margins.page(result, [])
    for head in ("| loop | 60 kt", "| | 60 kt"):
        there = column(PAGE, head, "70 kt")
        assert there
        assert column(again, head.replace("60", "70"), "70 kt") == there
    assert "all loops have them" in again


# --- the models, the laws and the tables, by hand ------------------------------

@pytest.fixture
def laws():
    """The modules that make -C evidence margins has the packages of."""
    pytest.importorskip("control", reason="make -C evidence margins installs it")
    import identify
    import loops
    import margins
    return SimpleNamespace(identify=identify, loops=loops, margins=margins)


def answered(law, inputs):
    """A law's outputs for these inputs, frame by frame."""
    state, said = [0.0] * len(law.A), []
    for given in inputs:
        said.append(law.C @ state + law.D @ given)
        state = law.A @ state + law.B @ given
    return said


def test_what_is_delayed_is_the_input_of_two_frames_ago(laws):
    maker = laws.loops.Maker(("one", "other"))
    maker.now["out"] = {maker.delayed("one"): 1.0, maker.delayed("other"): 10.0}
    inputs = [(1.0, 2.0), (3.0, 4.0), (5.0, 6.0), (7.0, 8.0), (0.0, 0.0)]
    said = [float(out[0]) for out in answered(maker.law(("out",)), inputs)]
    assert laws.loops.DELAY == 2
    assert said == [0.0, 0.0, 21.0, 43.0, 65.0]


def test_at_a_steady_altitude_that_is_wanted_the_pitch_comes_to_rest(laws):
    """The smoothed value reaches the measured one; the integrator keeps its
    value."""
    law = laws.loops.longitudinal(law_gains.gains(), "hold")
    # The altitude is seen so much later.
    late = laws.loops.DELAY
    inputs = [[100.0 if name == "altitude"
               or name == "wanted_altitude" and frame >= late else 0.0
               for name in law.inputs] for frame in range(2_000)]
    wanted = [out[law.outputs.index("wanted")]
              for out in answered(law, inputs)]
    assert max(map(abs, wanted)) > 1
    assert wanted[-1] == pytest.approx(wanted[-100], abs=1e-6)


def made_up(laws, gain):
    """A model of two inputs and three outputs that fades away, and what it
    answers to a pulse of each input, times a gain."""
    control = pytest.importorskip("control")
    import numpy
    inputs, outputs = ("roll", "yaw"), laws.identify.LATERAL
    model = control.ss(
        [[0.9, 0.1], [0.0, 0.8]], [[1.0, 0.0], [0.5, 1.0]],
        [[1.0, 0.0], [0.0, 20.0], [0.3, 0.4]], [[0.0, 0.0]] * 3,
        laws.identify.FRAME_S)
    answers = {}
    for place, name in enumerate(inputs):
        pulse = numpy.zeros((2, 1000))
        pulse[place, 0] = 1.0
        _, out = control.forced_response(
            model, numpy.arange(1000) * laws.identify.FRAME_S, pulse)
        answers[name] = dict(zip(outputs, gain * out, strict=True))
    return model, answers, inputs, outputs


MODEL = {
    "aircraft": "lambda", "airspeed_kt": 70.0, "weight_lb": 199.8,
    "not_determined": ["CZ_q"],
    "longitudinal": {
        "states": ["alpha_deg", "pitch_rate_deg_s", "pitch_attitude_deg"],
        "inputs": ["elevator_deg"],
        "outputs": ["alpha_deg", "pitch_rate_deg_s", "pitch_attitude_deg",
                    "climb_ft_s"],
        "A": [[-2.6, 1.0, 0.0], [-28.7, -4.5, 0.0], [0.0, 1.0, 0.0]],
        "B": [[0.13], [38.2], [0.0]],
        "C": [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0],
              [-2.1, 0.0, 2.1]],
        "D": [[0.0]] * 4},
    "lateral": None}


def test_gnd65_an_identified_model_is_sampled_as_the_sensors_are(
        laws, tmp_path):
    """A word held for a frame, a servo's lag, the scan 16 ms later: by many
    short steps."""
    numpy = pytest.importorskip("numpy")
    import identified
    path = tmp_path / "model.json"
    path.write_text(json.dumps(MODEL), "utf-8")
    found = identified.read(path)
    assert found.condition == laws.identify.Condition(70.0, 0)
    assert found.not_determined == ["CZ_q"]
    assert found.models.lateral is None
    model = found.models.longitudinal
    A, B = (numpy.array(MODEL["longitudinal"][name]) for name in "AB")
    aircraft, servo, state = numpy.zeros(3), 0.0, numpy.zeros(len(model.A))
    step = 1e-5
    for frame in range(10):
        word = 1.0 if frame == 0 else 0.0
        inputs = numpy.array([word, 0.0])
        said = model.C @ state + model.D @ inputs
        for count in range(2000):
            if count == 1600:
                measured = aircraft.copy()
            aircraft = aircraft + step * (A @ aircraft + B[:, 0] * servo)
            servo += step * (word - servo) / 0.1
        assert said[:2] == pytest.approx(
            [measured[2], measured[1]], abs=2e-3)
        assert said[2] == 0.0
        state = model.A @ state + model.B @ inputs


def test_gnd65_the_table_has_both_margins_of_each_loop(laws, tmp_path):
    margins = laws.margins
    pytest.importorskip("numpy")
    import identified
    path = tmp_path / "model.json"
    path.write_text(json.dumps(MODEL), "utf-8")
    given = identified.read(path)
    found = [(name, laws.loops.Margins(15.0, 60.0, 1.0),
              laws.loops.margins(response, margins.OMEGA))
             for name, response in margins.longitudinal_loops(
                 given.models.longitudinal, law_gains.gains())]
    lines = margins.table_beside(given, found).splitlines()
    assert "at 70.0 kt, 200 lb" in lines[0]
    assert [line.split("|")[1].strip() for line in lines[2:]] == [
        "pitch, damping", "pitch, attitude", "pitch, hold", "altitude",
        "airspeed"]
    assert all(line.split("|")[2].strip() == "15.0" for line in lines[2:])
    # Twice the gain, 6 dB less.
    assert float(lines[3].split("|")[3]) > 6.0


@pytest.mark.parametrize("text, error", [
    ("{", "no model of bin/urv identify"), ("[]", "no model"),
    ("{}", "no model"),
    (json.dumps(MODEL | {"longitudinal": {}}), "no model"),
    (json.dumps(MODEL | {"aircraft": "c172p"}), "not of c172p")])
def test_gnd65_what_is_no_model_has_one_line(laws, tmp_path, text, error):
    assert laws
    import identified
    path = tmp_path / "model.json"
    path.write_text(text, "utf-8")
    with pytest.raises(SystemExit, match=error) as ended:
        identified.read(path)
    assert len(str(ended.value).splitlines()) == 1


@pytest.mark.parametrize("gain, misfit", [(1.0, 0.0), (0.8, 0.25), (2.0, 0.5)])
def test_a_misfit_is_a_part_of_the_largest_answer(laws, gain, misfit):
    assert laws.identify.misfit(*made_up(laws, gain)) == pytest.approx(
        misfit, abs=1e-9)


def test_a_model_is_realised_from_its_answers(laws):
    _, answers, inputs, outputs = made_up(laws, 1.0)
    model, _ = laws.identify.realised(answers, inputs, outputs, 2)
    assert laws.identify.misfit(model, answers, inputs, outputs) < 1e-6


def test_each_loop_has_its_own_least_margins_on_the_page(laws):
    margins = laws.margins

    def row(loop, speed, gain, phase):
        return margins.Row(loop, laws.identify.Condition(speed, 0),
                           laws.loops.Margins(gain, phase, 1.0))
    rows = [row("a", 60, 9.0, 45.0), row("b", 60, 8.0, 50.0),
            row("b", 70, 7.0, 60.0), row("a", 70, 11.0, 65.0)]
    table = margins.table_of_loops(margins.Result(rows, [], []))
    assert table.splitlines()[2:] == [
        "| a | 9.0 | 60 kt, 200 lb | 45.0 | 60 kt, 200 lb |",
        "| b | 7.0 | 70 kt, 200 lb | 50.0 | 60 kt, 200 lb |"]

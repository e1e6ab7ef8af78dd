# SPDX-License-Identifier: Apache-2.0
"""GND-61 to GND-65, D-90: bin/urv identify. Derivatives of systems that are known,
their intervals over many seeds, and a flight of the simulated aircraft."""

import contextlib
import dataclasses
import json
import os
import pty
import re
import subprocess
import sys
from types import SimpleNamespace

# The arrays are small: more threads only wait for each other.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy
import pytest
from conftest import ROOT, fly
from scipy import ndimage, signal

from urv import faults
from urv.identification import (
    aircraft,
    airframes,
    analysis,
    bounds,
    cautions,
    compatibility,
    consistency,
    equation_error,
    manoeuvres,
    measurements,
    output_error,
)
from urv.identification.output_error import ALL, RECORD, Parameter

STEP_S = 0.02
TRUTH = {"stiffness": -9.0, "damping": -1.2, "control": 6.0}


class Oscillator:
    """A mass on a spring, moved by a force: angle and rate are measured."""

    states = outputs = ("angle", "rate")
    sizes = (0.01, 0.01)
    noisy = ()
    parameters = tuple(Parameter(name, ALL, 0.8 * value, 0.05)
                       for name, value in TRUTH.items())

    def prior(self, _parameter, _record):
        return None

    def first_states(self, _segment):
        return numpy.zeros(2)

    def inputs(self, segment, times, _values):
        return numpy.interp(times, segment.times,
                            segment["force"])[None]

    def measured(self, segment):
        return numpy.array([segment["angle"], segment["rate"]])

    def rates(self, states, inputs, values):
        angle, rate = states
        return numpy.array([rate, values[0] * angle + values[1] * rate
                            + values[2] * inputs[0]])

    def outputs_of(self, states, _inputs, _values):
        return states


def oscillation(seed, colour):
    """Three manoeuvres, computed by scipy, with noise of that colour: the
    correlation of one frame with the next."""
    chance = numpy.random.default_rng(seed)
    stiffness, damping, control = TRUTH.values()
    system = signal.StateSpace(
        [[0, 1], [stiffness, damping]], [[0], [control]], numpy.eye(2),
        numpy.zeros((2, 1)))
    found = []
    for number in range(3):
        times = STEP_S * numpy.arange(300)
        force = numpy.interp(
            times, [0, 1, 1.2, 2, 2.2, 3, 3.2, 6],
            [0, 0, 0.1, 0.1, -0.1, -0.1, 0, 0]) * (-1) ** number
        _, outputs, _ = signal.lsim(system, force, times)
        white = chance.normal(0, 0.01, (len(times) + 500, 2))
        noise = signal.lfilter([numpy.sqrt(1 - colour ** 2)], [1, -colour],
                               white, axis=0)[500:]
        angle, rate = (outputs + noise).T
        found.append(measurements.Segment(
            times + 10.0 * number,
            {"force": force, "angle": angle, "rate": rate},
            numpy.ones(len(times), bool), numpy.ones(len(times))))
    return found


def estimated(segments):
    return output_error.estimate(
        output_error.Problem(Oscillator(), segments))


def covered(fits, deviations):
    """The share of true values within 95 % intervals."""
    inside = [abs(fit.values[name] - value)
              <= analysis.FACTOR * getattr(fit, deviations)[name]
              for fit in fits for name, value in TRUTH.items()]
    return sum(inside) / len(inside)


def test_gnd62_without_noise_the_derivatives_are_the_true_ones():
    segments = oscillation(1, 0.0)
    model = Oscillator()
    exact = [each.with_signals(**dict(zip(
        ("angle", "rate"), signal.lsim(
            ([[0, 1], list(TRUTH.values())[:2]], [[0], [TRUTH["control"]]],
             numpy.eye(2), numpy.zeros((2, 1))),
            each["force"], each.times - each.times[0])[1].T, strict=True)))
        for each in segments]
    fit = output_error.estimate(output_error.Problem(model, exact))
    assert fit.has_converged
    for name, value in TRUTH.items():
        assert fit.values[name] == pytest.approx(value, rel=1e-3), name


def test_gnd62_slopes_take_memory_in_proportion_to_the_manoeuvres():
    """Those of a manoeuvre have its own parameters and the shared ones only,
    and the normal equations are those of all rows."""
    problem = output_error.Problem(
        Oscillator(), [*oscillation(1, 0.0), *oscillation(2, 0.0)])
    noise = numpy.array([0.01, 0.02])
    residuals, slopes = problem.reduced(problem.start, noise)
    base, changed = problem.integrate(problem.start, True)
    differences = problem.differences(base)
    squares, normal, right = 0.0, numpy.zeros((15, 15)), numpy.zeros(15)
    for number, table in enumerate(problem.sensitivities(changed, base)):
        assert table.shape == (2, 300, 5)
        own = problem.columns(number)
        flat = -(table / noise[:, None, None]).reshape(-1, 5)
        rest = (differences[number] / noise[:, None]).ravel()
        normal[numpy.ix_(own, own)] += flat.T @ flat
        right[own] += flat.T @ rest
        squares += rest @ rest
    assert slopes.shape == (6 * 6, 15)
    numpy.testing.assert_allclose(slopes.T @ slopes, normal, rtol=1e-9,
                                  atol=1e-9 * normal.max())
    numpy.testing.assert_allclose(slopes.T @ residuals, right, rtol=1e-9,
                                  atol=1e-9 * abs(right).max())
    assert residuals @ residuals == pytest.approx(squares)


def test_gnd62_intervals_of_white_noise_hold_the_truth():
    fits = [estimated(oscillation(seed, 0.0)) for seed in range(10)]
    assert 0.88 <= covered(fits, "deviations") <= 1.0
    assert covered(fits, "white_deviations") >= 0.88


def test_gnd62_intervals_of_coloured_noise_hold_the_truth():
    """Those for white noise do not."""
    fits = [estimated(oscillation(seed, 0.95)) for seed in range(10)]
    assert covered(fits, "deviations") >= 0.8
    assert covered(fits, "white_deviations") < 0.7


def test_gnd62_what_is_only_considered_widens_the_bounds_of_others():
    """A parameter that is known with a deviation, and not estimated."""
    def model(is_considered, deviation):
        class Known(Oscillator):
            parameters = (*Oscillator.parameters[:2], Parameter(
                "control", ALL, TRUTH["control"], 0.05,
                prior=(TRUTH["control"], deviation),
                is_considered=is_considered))

            def first_states(self, _segment):
                return numpy.zeros(2)
        return Known()

    segments = oscillation(2, 0.0)
    exact, unsure = (output_error.estimate(output_error.Problem(
        model(True, deviation), segments)) for deviation in (1e-6, 0.6))
    for fit in (exact, unsure):
        assert fit.values["control"] == pytest.approx(TRUTH["control"])
    for name in ("stiffness", "damping"):
        assert unsure.values[name] == pytest.approx(exact.values[name])
        assert unsure.deviations[name] > exact.deviations[name]
    # The force's effect is about that of the spring: 10 % of it.
    assert unsure.deviations["stiffness"] > 5 * exact.deviations["stiffness"]


def test_gnd62_a_parameter_that_changes_nothing_does_not_hurt_the_others():
    """The propellers' spin in a flight without any yaw rate: its variance was
    infinite, and the covariances with it no numbers."""
    chance = numpy.random.default_rng(1)
    slopes = [chance.normal(0, 1, (1, 200, 3)) for _ in range(2)]
    residuals = [chance.normal(0, 1, (1, 200)) for _ in range(2)]
    padded = [numpy.concatenate([each, 0.0 * each[:, :, :1]], axis=2)
              for each in slopes]
    with numpy.errstate(all="raise"):
        for alone, beside in zip(bounds.covariances(slopes, residuals),
                                 bounds.covariances(padded, residuals),
                                 strict=True):
            assert numpy.isfinite(beside).all()
            assert numpy.sqrt(beside[3, 3]) > 1e5
            # The other one uses up one residual, too.
            assert beside[:3, :3] == pytest.approx(alone, rel=0.01)
            assert abs(beside[3, :3]).max() < 1e-6


class Integrator:
    """An angle from a measured rate with a constant error, as attitudes come
    from the rates of gyros."""

    states = outputs = ("angle",)
    noisy = ("rate",)
    sizes = (0.01,)
    parameters = (Parameter("bias", RECORD, 0.0, 0.01, prior=(0.0, 1.0)),)

    def prior(self, parameter, _record):
        return parameter.prior

    def first_states(self, segment):
        return segment["angle"][:1]

    def inputs(self, segment, times, _values):
        return segment.splines("rate")(times)

    def measured(self, segment):
        return segment["angle"][None]

    def rates(self, _states, inputs, values):
        return inputs - values[:1]

    def outputs_of(self, states, _inputs, _values):
        return states


def test_gnd62_intervals_contain_the_noise_of_measured_inputs():
    """It is integrated: the residuals are a random walk, and show too little of
    it."""
    inside = 0
    for seed in range(40):
        chance = numpy.random.default_rng(seed)
        times = STEP_S * numpy.arange(400)
        rate = numpy.sin(3.0 * times)
        parts = [measurements.Segment(
            times, {"rate": rate + 0.03 + chance.normal(0, 0.1, 400),
                    "angle": (1.0 - numpy.cos(3.0 * times)) / 3.0
                    + chance.normal(0, 1e-3, 400)},
            numpy.ones(400, bool), numpy.ones(400)) for _ in range(3)]
        fit = output_error.estimate(output_error.Problem(Integrator(), parts))
        inside += (abs(fit.of_records["bias", 0] - 0.03)
                   <= analysis.FACTOR * fit.deviations["bias/0"])
    # Without the noise of inputs 22 are.
    assert inside >= 34


def test_gnd61_the_noise_of_a_signal_is_found_without_its_movement():
    chance = numpy.random.default_rng(1)
    times = STEP_S * numpy.arange(2_000)
    moves = numpy.sin(6.0 * times) + (times > 20.0)
    for size in (1e-3, 1e-1):
        found = measurements.noise_of(
            moves + chance.normal(0, size, len(times)))
        assert found == pytest.approx(size, rel=0.15)


def fit_of(found, deviations, correlation):
    """A fit of Kinematics as far as scale factors and delays go: those of alpha
    and of the accelerations have this correlation."""
    model = compatibility.Kinematics(measurements.GRAVITY)
    names = [each.name for each in model.parameters
             if each.name.startswith(("scale", "delay"))]
    table = numpy.eye(len(names))
    pair = [names.index(name) for name in ("scale alpha",
                                           "delay accelerations")]
    table[pair, pair[::-1]] = correlation
    sizes = {f"{name}/0": deviations[name.split(" ")[0]] for name in names}
    values = {(name, 0): float(name.startswith("scale")) for name in names}
    return model, SimpleNamespace(
        names=[f"{name}/0" for name in names],
        of_records=values | {(name, 0): value
                             for name, value in found.items()},
        correlations=table, white_correlations=table,
        deviations=sizes, white_deviations=sizes)


def test_gnd61_errors_that_compensate_each_other_are_not_applied():
    """Both are 4 deviations from none, along the line on which the data hardly
    know them; with either one alone, the other is none."""
    model, fit = fit_of({"scale alpha": 0.92, "delay accelerations": -0.028},
                        {"scale": 0.02, "delay": 0.007}, 0.999)
    chosen, others = compatibility.needed(model, fit, 0, False)
    assert chosen == []
    value, deviation = others["scale alpha"]
    assert abs(value - 1.0) < 3.0 * deviation < 0.01


def test_gnd61_an_error_that_the_data_need_is_applied_alone():
    model, fit = fit_of({"scale alpha": 0.92, "delay accelerations": 0.0},
                        {"scale": 0.02, "delay": 0.007}, 0.5)
    assert compatibility.needed(model, fit, 0, False)[0] == ["scale alpha"]
    assert compatibility.needed(model, fit, 0, True)[0] == []
    model, fit = fit_of({"scale alpha": 0.92, "delay accelerations": 0.03},
                        {"scale": 0.02, "delay": 0.007}, 0.0)
    assert sorted(compatibility.needed(model, fit, 0, False)[0]) == [
        "delay accelerations", "scale alpha"]


def test_gnd61_a_delay_that_no_sensor_has_is_bounded():
    """A switched sign of beta in a noisy record made a delay of seconds: that of the
    accelerations alone was drawn along its correlation with beta's factor."""
    model, fit = fit_of({"scale alpha": -1.0, "delay accelerations": -0.01},
                        {"scale": 0.02, "delay": 0.03}, 0.99)
    for is_rough in (False, True):
        _, others = compatibility.needed(model, fit, 0, is_rough)
        for name, (value, _) in others.items():
            assert name.startswith("scale") or abs(value) <= 0.3
    model, fit = fit_of({"delay rates": -3.0},
                        {"scale": 0.02, "delay": 0.03}, 0.0)
    chosen, others = compatibility.needed(model, fit, 0, False)
    assert (chosen, others["delay rates"][0]) == ([], -0.3)


def test_gnd61_a_delay_beyond_its_bound_moves_no_signal():
    model = compatibility.Kinematics(measurements.GRAVITY)
    times = STEP_S * numpy.arange(200)
    part = measurements.Segment(
        times, dict.fromkeys(model.noisy, numpy.sin(times)),
        numpy.ones(200, bool), numpy.ones(200))
    values = numpy.zeros(len(model.parameters))
    values[model.place["delay rates"]] = -3.132
    assert model.inputs(part, times[50:], values)[0] == pytest.approx(
        numpy.sin(times[50:] - 0.3), abs=1e-4)


def test_gnd63_a_delay_at_its_bound_is_reported():
    said, = judged([], sensors(found=[compatibility.Found(
        "delay accelerations", "ms", -300.0, 10.0, False, False, True)]))
    assert said == ('"a.csv": the data want a delay of accelerations of'
                    " more than 300 ms, as no sensor has; is a sign, a unit or"
                    " a column of the record wrong?")


def test_gnd61_known_delays_are_removed():
    times = STEP_S * numpy.arange(200)
    late = {"accelerations": 0.004, "attitude": 0.002}
    part = measurements.Segment(
        times, {name: numpy.sin(2.0 * (times - late.get(group, 0.0)))
                for group, names in measurements.GROUPS.items()
                for name in names},
        numpy.ones(200, bool), numpy.ones(200))
    found = measurements.without_delays(part, late)
    for name in ("az", "theta", "p", "alpha"):
        assert found[name][5:-5] == pytest.approx(
            numpy.sin(2.0 * times)[5:-5], abs=1e-5), name


def test_gnd62_moments_come_after_their_causes():
    """The airflow acts 4 ms late, rates and surfaces 2 ms."""
    own = dataclasses.replace(aircraft.read(), delays={
        "moments": 0.002, "moments_by_airflow": 0.004})
    model = airframes.Lateral(own, {name: {0: 0.1}
                                    for name in ("airspeed", "alpha")})
    values = numpy.array([
        [model.prior(each, 0)[0] if model.prior(each, 0) else
         own.prior.get(each.name, 0.0)] for each in model.parameters])
    inputs = numpy.array([[0.1], [0.05], [0.05], [0.0], [-32.0],
                          [118.0], [16.0], [0.05], [0.02], [0.0], [0.0]])
    states = numpy.array([[0.02], [0.3], [0.1], [0.2]])
    now = model.motion(states, inputs, values)
    found = model.rates(states, inputs, values)
    before = model.motion(
        states - numpy.array([[0.004], [0.002], [0.002], [0.002]]) * now,
        inputs, values)
    assert found[[1, 2]] == pytest.approx(before[[1, 2]])
    assert found[[1, 2]] != pytest.approx(now[[1, 2]])
    assert found[[0, 3]] == pytest.approx(now[[0, 3]])
    # Equation error has the same causes, by time.
    times = STEP_S * numpy.arange(100)
    part = measurements.Segment(
        times, dict.fromkeys(("beta", "p", "r", "aileron", "rudder"), times),
        numpy.ones(100, bool), numpy.ones(100))
    late = model.as_moments_see(part)
    for name, delay in (("beta", 0.004), ("p", 0.002), ("rudder", 0.002)):
        assert times - late[name] == pytest.approx(delay), name


def of_prior(model, own):
    """The values of a model's parameters: those of the aircraft file."""
    return numpy.array([
        [model.prior(each, 0)[0] if model.prior(each, 0) else
         own.prior.get(each.name, 0.0)] for each in model.parameters])


def test_gnd62_drag_that_a_sideslip_turns_is_no_side_force_of_a_roll():
    """The side force of drag, lift and side force along the axes of the wind. In
    rolls the lift and with it the drag changes: CY_p was 0.01 in place of 0."""
    own = aircraft.read()
    model = airframes.Lateral(own, {name: {0: 0.1}
                                    for name in ("airspeed", "alpha")})
    times = STEP_S * numpy.arange(200)
    alpha = 0.04 + 0.03 * numpy.sin(2.0 * times)
    beta = 0.12 * numpy.sin(3.0 * times)
    pressure = 0.5 * measurements.SEA_LEVEL_DENSITY * 118.0 ** 2
    area = pressure * own.wing_area / own.mass
    lift = 0.3 + 4.8 * alpha
    drag = 0.05 + 0.05 * lift ** 2
    thrust = 0.06
    cos, sin = numpy.cos, numpy.sin
    side = -0.45 * beta
    part = measurements.Segment(
        times, dict.fromkeys(("p", "q", "r", "phi", "theta", "aileron",
                              "rudder"), 0.0 * times) | {
            "alpha": alpha, "beta": beta, "airspeed": 118.0 + 0.0 * times,
            "ax": area * (thrust - drag * cos(alpha) * cos(beta)
                          - side * cos(alpha) * sin(beta)
                          + lift * sin(alpha)),
            "ay": area * (side * cos(beta) - drag * sin(beta)),
            "az": area * (-drag * sin(alpha) * cos(beta)
                          - side * sin(alpha) * sin(beta)
                          - lift * cos(alpha))},
        numpy.ones(200, bool), numpy.ones(200))
    values = of_prior(model, own)
    values[model.place["CY_beta"]] = -0.45 - drag.mean()
    states = numpy.array([beta, *numpy.zeros((3, 200))])
    inputs = model.inputs(part, times, values[:, 0])
    found = model.forces(states, inputs, numpy.tile(values, 200))[0]
    assert abs(found - part["ay"]).max() < 1e-4 * area
    # Drag along the body is the other case that the interval contains.
    values[model.place[airframes.DRAG]] = 0.0
    other = model.forces(states, inputs, numpy.tile(values, 200))[0]
    assert abs(other - part["ay"]).max() > 5e-4 * area
    left, table, _ = model.equations(part, lambda each: each,
                                     lambda each: 0.0 * each)
    assert left["CY"] == pytest.approx(
        values[model.place["CY_beta"], 0] * table["CY"][0], abs=1e-4)


def test_gnd62_the_noise_of_the_airspeed_is_smoothed():
    times = STEP_S * numpy.arange(400)
    speed = 118.0 - 5.0 * numpy.sin(times)
    chance = numpy.random.default_rng(1)
    part = measurements.Segment(
        times, {"airspeed": speed + chance.normal(0, 0.4, 400)},
        numpy.ones(400, bool), numpy.ones(400))
    left = measurements.smooth_airspeed(part)["airspeed"] - speed
    assert left[25:-25].std() < 0.15


def test_gnd62_the_propellers_spin_is_not_taken_for_aerodynamics():
    """A yawing aircraft whose propeller has an angular momentum. Its moment in pitch
    is half of that of the elevator."""
    spin = 0.5
    own = aircraft.read()
    times = STEP_S * numpy.arange(500)
    level = numpy.zeros(500)
    alpha = level + numpy.radians(2.4)
    part = measurements.Segment(
        times, {**dict.fromkeys(("p", "q", "phi", "beta", "ay"), level),
                "r": 0.15 * numpy.sin(3.7 * times),
                "elevator": 0.02 * numpy.sign(numpy.sin(6.0 * times)),
                "alpha": alpha, "theta": alpha,
                "ax": own.gravity * numpy.sin(alpha),
                "az": -own.gravity * numpy.cos(alpha),
                "airspeed": level + 118.0},
        numpy.ones(500, bool), level + 1.0)
    known = {name: {0: 0.1} for name in ("airspeed", "alpha")}
    model = airframes.Longitudinal(own, known)
    problem = output_error.Problem(model, [part])
    truth = own.prior | {
        f"{airframes.SPIN}/0": spin,
        "Cm_0/0/0": -own.prior["Cm_alpha"] * alpha[0],
        "CZ_0/0/0": own.mass * part["az"][0] / own.wing_area
        / model.pressure_and_speed(part)[0][0]
        - own.prior["CZ_alpha"] * alpha[0]}
    flown = numpy.array([truth.get(name, value) for name, value in zip(
        problem.names, problem.start, strict=True)])
    out, _ = problem.integrate(flown, False)
    chance = numpy.random.default_rng(1)
    flown = part.with_signals(**{
        name: values + chance.normal(0, size, 500)
        for name, values, size in zip(
            model.outputs, out[:, :, 0], (5e-4, 1e-3, 1e-3, 0.03),
            strict=True)})
    start = equation_error.regress(model, [flown])
    problem = output_error.Problem(model, [flown], {
        f"{name}_speed": 0.0 for name in model.coefficients})
    analysis.begin(problem, model, start, [flown])
    fit = output_error.estimate(problem)
    assert fit.of_records[airframes.SPIN, 0] == pytest.approx(spin, rel=0.02)
    for name in ("Cm_alpha", "Cm_q", "Cm_elevator"):
        assert fit.values[name] == pytest.approx(
            own.prior[name], rel=0.03), name
        assert start.values[name] == pytest.approx(
            own.prior[name], rel=0.15), name


def pitching(model, own, record):
    """A record of elevator doublets, computed with the prior derivatives."""
    times = STEP_S * numpy.arange(300)
    level = numpy.zeros(300)
    alpha = level + numpy.radians(2.4)
    part = measurements.Segment(
        times, {**dict.fromkeys(("p", "q", "r", "phi", "beta", "ay"), level),
                "elevator": 0.02 * numpy.sign(numpy.sin(6.0 * times)),
                "alpha": alpha, "theta": alpha,
                "ax": own.gravity * numpy.sin(alpha),
                "az": -own.gravity * numpy.cos(alpha),
                "airspeed": level + 118.0},
        numpy.ones(300, bool), level + 1.0, record)
    problem = output_error.Problem(model, [part])
    truth = own.prior | {
        f"Cm_0/{record}/0": -own.prior["Cm_alpha"] * alpha[0],
        f"CZ_0/{record}/0": own.mass * part["az"][0] / own.wing_area
        / model.pressure_and_speed(part)[0][0]
        - own.prior["CZ_alpha"] * alpha[0]}
    out, _ = problem.integrate(numpy.array([
        truth.get(name, value) for name, value in zip(
            problem.names, problem.start, strict=True)]), False)
    chance = numpy.random.default_rng(record)
    return part.with_signals(**{
        name: values + chance.normal(0, size, 300)
        for name, values, size in zip(
            model.outputs, out[:, :, 0], (5e-4, 1e-3, 1e-3, 0.03),
            strict=True)})


def test_gnd63_a_record_of_another_aircraft_is_named():
    """The longitudinal axis of two aircraft together had a fit of 0.21 and no
    caution."""
    own = dataclasses.replace(aircraft.read(), delays={})
    other = dataclasses.replace(own, prior=own.prior | {
        name: factor * own.prior[name] for name, factor in (
            ("CZ_alpha", 0.84), ("Cm_alpha", 0.6), ("Cm_elevator", 0.4))})
    known = {name: dict.fromkeys(range(4), 0.01)
             for name in ("airspeed", "alpha")}
    model = airframes.Longitudinal(own, known)
    parts = [pitching(model, own, record) for record in (0, 1, 3)]
    odd = pitching(model, other, 2)
    assert consistency.different(model, parts[:1]) == {}
    assert consistency.different(model, parts) == {}
    found = consistency.different(model, [*parts, odd])
    assert list(found) == [2]
    assert set(found[2]) == {"Cm_alpha", "Cm_elevator"}
    assert found[2]["Cm_elevator"] == pytest.approx(0.6, abs=0.1)
    # Neither of two records is the odd one.
    assert list(consistency.different(model, [parts[0], odd])) == [0, 2]
    said, = cautions.of(analysis.Result(
        ["a.csv", "b.csv"], [sensors(), sensors()],
        {"longitudinal": analysis.Axis(
            "longitudinal", (), [],
            different={1: {"Cm_alpha": 0.4, "Cm_elevator": 0.6}})}), own)
    assert said == (
        '"b.csv": Cm_alpha, Cm_elevator differ from those of the other records'
        " by up to 60%; is it a record of the same aircraft and load?")


@pytest.mark.parametrize("airspeed_ft_s, delays_ms", [(6.0, 0.01),
                                                      (0.01, 20.0)])
def test_gnd62_more_records_make_common_errors_no_smaller(
        airspeed_ft_s, delays_ms):
    """One probe and one aircraft fly all of them: of 50 records the interval
    of a derivative was a seventh, and did not contain the truth."""
    own = dataclasses.replace(
        aircraft.read(), delays={}, delays_deviation=delays_ms / 1e3)
    many = 4
    model = airframes.Longitudinal(own, {
        "airspeed": dict.fromkeys(range(many), airspeed_ft_s),
        "alpha": dict.fromkeys(range(many), 0.001)})
    parts = [pitching(model, own, record) for record in range(many)]
    fixed = {f"{name}_speed": 0.0 for name in model.coefficients}

    def fit_of(segments):
        problem = output_error.Problem(model, segments, fixed)
        analysis.begin(problem, model, equation_error.regress(
            model, segments), segments)
        return output_error.estimate(problem)

    one, all_of_them = fit_of(parts[:1]), fit_of(parts)
    name = "Cm_elevator"
    assert all_of_them.noise_deviations[name] < (
        0.7 * one.noise_deviations[name])
    assert one.deviations[name] > 3.0 * one.noise_deviations[name]
    assert all_of_them.deviations[name] > 0.85 * one.deviations[name]


def test_gnd62_a_gap_in_the_data_counts_for_nothing():
    whole = oscillation(3, 0.0)
    hurt = []
    for each in whole:
        fresh = each.is_fresh.copy()
        fresh[150:153] = False
        angle = each["angle"].copy()
        angle[150:153] = 50.0
        hurt.append(measurements.Segment(
            each.times, each.signals | {"angle": angle}, fresh,
            each.density_ratio))
    one, other = estimated(whole), estimated(hurt)
    for name in TRUTH:
        assert abs(one.values[name] - other.values[name]) < (
            one.deviations[name])


@pytest.fixture(scope="module")
def flown(tmp_path_factory):
    """The folder of a flight of evidence/derivatives.py's programme."""
    folder = tmp_path_factory.mktemp("identify")
    subprocess.run(
        [sys.executable, "-B", ROOT / "evidence" / "derivatives.py",
         "--sticks", folder / "sticks.csv"], check=True,
        capture_output=True)
    (folder / "conditions.txt").write_text(
        "bias pitch_rate 0.2\nbias airspeed 1\nbias alpha 0.3\n"
        "bias pitch_attitude 1\n"
        "noise alpha 0.1\nnoise beta 0.1\nnoise roll_rate 0.1\n"
        "noise pitch_rate 0.1\nnoise yaw_rate 0.1\n", "utf-8")
    return fly(folder, "--plant", "jsbsim", "--sticks", "sticks.csv",
               "--conditions", "conditions.txt")


def test_gnd64_the_flight_of_the_page_has_the_rest_of_its_last_manoeuvre(
        flown):
    """The record ended with the last movement: the manoeuvre for validation
    lacked the 4 s after it."""
    from urv import flights
    last = manoeuvres.found(flights.read(
        flown / "record.csv", lambda _record: None))[-1]
    script = (flown / "sticks.csv").read_text("ascii").splitlines()
    moved_s = int(script[-2].partition(",")[0]) / 1000
    assert last.end >= moved_s + manoeuvres.TAIL_S - 0.1


def lateral_start(flight):
    """The lateral derivatives by equation error, and the segments."""
    own = aircraft.read()
    parts = [measurements.smooth_airspeed(measurements.without_delays(
        measurements.segment(flight, each.begin, each.end), own.delays))
        for each in manoeuvres.found(flight) if "lateral" in each.axes]
    return equation_error.regress(airframes.Lateral(
        own, {name: {0: 0.1} for name in ("airspeed", "alpha")}), parts)


def test_gnd62_a_roll_makes_no_side_force_in_a_flight(flown, tmp_path):
    """JSBSim's aircraft has none: exact sensors showed 0.01."""
    from urv import flights
    fly(tmp_path, "--plant", "jsbsim", "--sticks", flown / "sticks.csv")
    start = lateral_start(flights.read(tmp_path / "record.csv",
                                       lambda _record: None))
    assert abs(start.values["CY_p"]) < 0.005
    assert abs(start.values["CY_aileron"]) < 0.0015
    assert start.values["CY_beta"] == pytest.approx(-0.5103, rel=0.01)


@pytest.fixture(scope="module")
def identified(flown):
    """The same, with the report and the numbers."""
    result = subprocess.run(
        [ROOT / "bin" / "urv", "identify", "record.csv", "-o", "report.html",
         "--json", "result.json", "--model", "model.json"], cwd=flown,
        check=False, text=True, capture_output=True)
    assert (result.returncode, result.stderr) == (0, "")
    (flown / "said.txt").write_text(result.stdout, "utf-8")
    return flown


def test_gnd10_identify_shows_its_progress_on_a_terminal(flown, tmp_path):
    """50 records took 8 minutes without a word."""
    times = tmp_path / "times.csv"
    times.write_text("begin_s,end_s,axes\n6,9,longitudinal\n", "utf-8")
    code = ("import sys; from urv import main, progress;"
            "progress.BEFORE_IT_IS_SHOWN_S = 0.0;"
            "sys.exit(main.main(['identify', 'record.csv', '--manoeuvres',"
            f" {str(times)!r}]))")
    ours, theirs = pty.openpty()
    done = subprocess.Popen(
        [sys.executable, "-c", code], cwd=flown, stderr=theirs,
        stdout=subprocess.DEVNULL,
        env=os.environ | {"PYTHONPATH": str(ROOT / "ground"),
                          "TERM": "xterm", "COLUMNS": "80"})
    os.close(theirs)
    shown = b""
    with contextlib.suppress(OSError):
        while block := os.read(ours, 4_096):
            shown += block
    os.close(ours)
    assert done.wait(60) == 0
    assert b"estimating" in shown, shown


def test_gnd10_the_progress_of_identify_rises_to_its_end(flown):
    from urv import flights
    flight = flights.read(flown / "record.csv", lambda _record: None)
    seen = []
    analysis.identify(
        [flight], aircraft.read(), (lambda found: [
            each for each in manoeuvres.found(found)
            if each.axes == ("longitudinal",)][:1],),
        told=lambda work: seen.append((work.position, work.size)))
    places = [place for place, _ in seen]
    assert len(places) > 6
    assert places == sorted(places)
    assert seen[-1][0] == pytest.approx(seen[-1][1])


MAIN = ("CZ_alpha", "Cm_alpha", "Cm_q", "Cm_elevator", "Cl_p", "Cl_beta",
        "Cl_aileron", "Cn_beta", "Cn_r", "Cn_rudder")


def test_gnd64_main_derivatives_of_a_flight_are_near_the_truth(identified):
    result = json.loads((identified / "result.json").read_text("utf-8"))
    found = {}
    for axis in result["axes"].values():
        assert axis["converged"]
        found |= axis["derivatives"]
    for name in MAIN:
        each = found[name]
        assert each["determined"], name
        assert each["low"] < each["value"] < each["high"]
        assert each["value"] == pytest.approx(each["prior"], rel=0.05), name


def test_gnd61_manoeuvres_are_found_by_the_sticks(identified):
    result = json.loads((identified / "result.json").read_text("utf-8"))
    for axis in result["axes"].values():
        uses = [each["use"] for each in axis["manoeuvres"]]
        assert uses == ["estimation"] * 3 + ["validation"]
        assert {each["found_by"] for each in axis["manoeuvres"]} == {"sticks"}
        # Validation: the computed outputs are those of the flight.
        assert max(axis["manoeuvres"][-1]["inequality"].values()) < 0.3


def test_gnd61_the_errors_of_the_sensors_are_found(identified):
    sensors, = json.loads(
        (identified / "result.json").read_text("utf-8"))["sensors"]
    rate = sensors["bias q"]
    assert rate["determined"] and rate["unit"] == "deg/s"
    assert rate["value"] == pytest.approx(0.2, abs=0.05)
    assert sensors["bias airspeed"]["value"] == pytest.approx(1.0, abs=1.5)


def test_d90_errors_of_attitude_widen_those_of_alpha(identified):
    """Half a degree of pitch attitude is half a degree of alpha."""
    sensors, = json.loads(
        (identified / "result.json").read_text("utf-8"))["sensors"]
    alpha = sensors["bias alpha"]
    assert 0.4 < alpha["deviation"] < 0.8
    # Alpha is 0.3 degrees too large, the attitude 1 degree.
    assert alpha["value"] == pytest.approx(0.3 - 1.0, abs=0.1)


def test_gnd63_the_report_is_one_page_that_needs_no_network(identified):
    page = (identified / "report.html").read_text("utf-8")
    assert "default-src 'none'" in page
    assert "http-equiv=\"Content-Security-Policy\"" in page
    for name in MAIN:
        assert f">{name}</th>" in page
    assert "Errors of the sensors" in page
    assert "residual of alpha" in page
    said = (identified / "said.txt").read_text("utf-8")
    for name in MAIN:
        assert f"  {name} " in said


class Switched:
    """A flight with the sign of a sensor switched."""

    def __init__(self, flight, sensor):
        self.flight, self.switched = flight, sensor

    def __getattr__(self, name):
        return getattr(self.flight, name)

    def sensor(self, name):
        values = self.flight.sensor(name)
        return -values if name == self.switched else values


@pytest.mark.parametrize("sensor, axis, cautioned", [
    ("roll_rate", "lateral", "the roll attitude contradicts the rates"),
    ("pitch_attitude", "longitudinal",
     "the pitch attitude contradicts the rates"),
    ("beta", "lateral", "beta has a factor of -"),
    ("left_elevator", "longitudinal", None)])
def test_gnd63_a_switched_sign_is_reported(flown, sensor, axis, cautioned):
    """It made confident numbers: Cl_aileron of -0.15, in place of 0.15."""
    from urv import flights
    flight = flights.read(flown / "record.csv", lambda _record: None)

    def some(flight):
        return [each for each in manoeuvres.found(flight)
                if each.axes == (axis,)][:3]
    own = aircraft.read()
    result = analysis.identify([Switched(flight, sensor)], own, (some,))
    said = cautions.of(result, own)
    if cautioned is None:
        # Only one of the elevators: the mean of both hardly moves.
        assert not any("contradicts" in each for each in said)
        return
    assert any(cautioned in each for each in said), said
    assert not any(each.is_determined for each
                   in result.axes[axis].derivatives.values())


def test_gnd63_a_sound_flight_has_no_caution(identified):
    result = json.loads((identified / "result.json").read_text("utf-8"))
    assert result["cautions"] == []
    assert "caution: " not in (identified / "said.txt").read_text("utf-8")


def derived(name, value, half, prior):
    return analysis.Derivative(name, value, value - half, value + half, 0.0,
                               value, prior, True)


def judged(derivatives, known=None, inequality=None):
    """The cautions of a result with these parts."""
    flown = analysis.Flown(manoeuvres.Manoeuvre(0.0, 1.0, ("lateral",)), 0)
    flown.inequality = inequality or {}
    return cautions.of(analysis.Result(["a.csv"], [known], {
        "lateral": analysis.Axis(
            "lateral", ("beta", "phi"), [flown],
            {each.name: each for each in derivatives})}), aircraft.read())


def sensors(**changed):
    return SimpleNamespace(**({"contradictions": [], "is_rough": False,
                               "found": []} | changed))


def test_gnd63_a_record_without_manoeuvres_is_named():
    assert judged([]) == ['"a.csv": no usable manoeuvre']
    assert judged([], sensors()) == []


def test_gnd63_rough_air_and_poor_fits_are_reported():
    rough, poor = judged([], sensors(is_rough=True),
                         {"beta": 0.1, "phi": 0.35})
    assert rough.startswith('"a.csv": the air is rough: ')
    assert poor == ("lateral: the model does not follow phi in 1 of 1"
                    " manoeuvres: fit up to 0.35; below 0.3 is good")


def test_gnd63_a_sign_that_no_aircraft_has_is_reported():
    assert judged([derived("Cl_aileron", -0.15, 0.01, None),
                   derived("Cl_p", -0.45, 0.01, None),
                   derived("Cn_rudder", -0.01, 0.02, None)], sensors()) == [
        "Cl_aileron is negative: is the sign of a surface or of a sensor"
        " wrong?"]


def test_gnd63_priors_of_another_aircraft_are_reported():
    own = [derived("CY_beta", -0.5, 0.01, -0.51),
           derived("Cl_beta", -0.13, 0.01, -0.2),
           derived("Cl_p", -0.45, 0.01, -0.46),
           derived("Cn_r", -0.12, 0.001, -0.14)]
    assert judged(own, sensors()) == []
    other = [*own[:1], derived("Cl_p", -0.2, 0.01, -0.45),
             *(derived(name, 0.05, 0.01, 0.1)
               for name in ("Cn_beta", "Cl_r"))]
    said, = judged(other, sensors())
    assert said.startswith(
        "3 of 4 prior values differ by more than 20% and are outside")


def test_gnd65_the_linear_model_is_that_of_the_derivatives(identified):
    """The elements of the matrices, by the usual formulas, in rad and ft."""
    model = json.loads((identified / "model.json").read_text("utf-8"))
    found = {}
    for axis in json.loads((identified / "result.json").read_text("utf-8"))[
            "axes"].values():
        found |= {name: each["value"]
                  for name, each in axis["derivatives"].items()}
    own = aircraft.read()
    assert model["aircraft"] == "lambda"
    assert model["airspeed_kt"] == pytest.approx(70, abs=2)
    assert model["weight_lb"] == pytest.approx(199.8, abs=0.1)
    pressure = 0.5 * 0.0023769 * (
        model["airspeed_kt"] * measurements.FPS_PER_KT) ** 2
    # 1800 ft above the sea.
    speed = model["airspeed_kt"] * measurements.FPS_PER_KT * 1.0270
    force = pressure * own.wing_area / own.mass / speed
    pitch = pressure * own.wing_area * own.chord / own.iyy
    roll, yaw = (pressure * own.wing_area * own.span / inertia
                 for inertia in (own.ixx, own.izz))
    per_c, per_b = own.chord / (2 * speed), own.span / (2 * speed)
    axis = model["longitudinal"]
    assert axis["states"] == ["alpha_deg", "pitch_rate_deg_s",
                              "pitch_attitude_deg"]
    assert axis["inputs"] == ["elevator_deg"]
    A, B = numpy.array(axis["A"]), numpy.array(axis["B"])
    assert A[0, 0] == pytest.approx(force * found["CZ_alpha"], rel=0.02)
    assert A[1, :2] == pytest.approx(
        [pitch * found["Cm_alpha"], pitch * per_c * found["Cm_q"]], rel=0.01)
    assert B[1, 0] == pytest.approx(pitch * found["Cm_elevator"], rel=0.01)
    climb = dict(zip(axis["outputs"], axis["C"], strict=True))["climb_ft_s"]
    assert climb == pytest.approx(
        numpy.radians(speed) * numpy.array([-1, 0, 1]), rel=0.01)
    axis = model["lateral"]
    assert axis["states"] == ["beta_deg", "roll_rate_deg_s",
                              "yaw_rate_deg_s", "roll_attitude_deg"]
    A, B = numpy.array(axis["A"]), numpy.array(axis["B"])
    assert A[1, :3] == pytest.approx(
        [roll * found["Cl_beta"], roll * per_b * found["Cl_p"],
         roll * per_b * found["Cl_r"]], rel=0.01)
    assert A[2, :3] == pytest.approx(
        [yaw * found["Cn_beta"], yaw * per_b * found["Cn_p"],
         yaw * per_b * found["Cn_r"]], rel=0.01)
    assert A[0, 3] == pytest.approx(own.gravity / speed, rel=0.01)
    assert B[1:3] == pytest.approx(numpy.array([
        [roll * found["Cl_aileron"], roll * found["Cl_rudder"]],
        [yaw * found["Cn_aileron"], yaw * found["Cn_rudder"]]]), rel=0.01)
    # Without a determined effect of the rates on the forces.
    assert "CZ_q" in model["not_determined"]


class Carded:
    """A flight with a card from 10 to 12 s, which moves the elevators, and
    without the downlink's words in some rows."""

    def __init__(self, hidden):
        self.rows = 1_000
        self.seconds = STEP_S * numpy.arange(self.rows)
        self.hidden = hidden

    def has_all(self, *_names):
        return True

    def values(self, name):
        values = numpy.zeros(self.rows)
        if name.endswith("switch5"):
            values[500:600] = 1.0
        if "downlink" in name:
            if name.endswith("elevator"):
                values[505:550] = 2.0
            values[self.hidden] = numpy.nan
        return values


@pytest.mark.parametrize("hidden", [
    slice(0), slice(480, 481), slice(475, 500), slice(500, 520)], ids=[
        "none", "one", "all before", "many of the card"])
def test_gnd61_old_words_hide_no_card(hidden):
    found = manoeuvres.found(Carded(hidden))
    assert [(each.begin, round(each.end, 2), each.axes, each.mark,
             each.reason) for each in found] == [
        (9.5, 14.98, ("longitudinal",), "card", "")]


@pytest.mark.parametrize("hidden", [slice(470, 501), slice(490, 560)],
                         ids=["before", "card"])
def test_gnd61_a_card_that_a_gap_hides_is_reported(hidden):
    found = manoeuvres.found(Carded(hidden))
    assert [(each.begin, each.reason) for each in found] == [
        (10.0, manoeuvres.NOT_JUDGED)]


class Sticks:
    """A flight in which the pilot trims the pitch stick, then moves it."""

    def __init__(self, seconds, pitch):
        self.rows, self.seconds, self.pitch = len(seconds), seconds, pitch

    def has_all(self, *names):
        return not any(name.endswith("switch5") for name in names)

    def values(self, name):
        return self.pitch * name.endswith("pitch")


def trimmed(seconds, moved_at):
    """At 200 s the stick goes to 5 %, its rest from then on. A doublet."""
    pitch = numpy.where(seconds < 200.0, 0.0, 5.0)
    after = seconds - moved_at
    return pitch + 10.0 * ((after >= 0) & (after < 0.5)) - 10.0 * (
        (after >= 0.5) & (after < 1.0))


@pytest.mark.parametrize("missing", ["none", "trim", "every second", "few"])
def test_gnd61_missing_rows_do_not_stretch_the_time_of_a_rest(missing):
    """The rest is a median over 20 s, whatever rows a record lacks."""
    seconds = STEP_S * numpy.arange(1, 15_000)
    if missing == "trim":
        seconds = seconds[(seconds < 190.0) | (seconds > 212.0)]
    elif missing == "every second":
        seconds = seconds[::2]
    elif missing == "few":
        seconds = seconds[numpy.arange(len(seconds)) % 7 != 3]
    found = manoeuvres.found(Sticks(seconds, trimmed(seconds, 216.0)))
    assert [(round(each.begin, 1), round(each.end, 1))
            for each in found if each.begin > 211.0] == [(215.5, 221.0)]


def test_gnd61_rests_of_a_record_without_gaps_are_medians_of_20_s():
    chance = numpy.random.default_rng(1)
    for rows in (1, 2, 999, 12_345):
        values = chance.normal(0, 5, rows).round(1)
        found = manoeuvres.rests(STEP_S * numpy.arange(rows), values)
        assert (found == ndimage.median_filter(
            values, min(1000, rows) | 1, mode="nearest")).all()


class Lacking:
    """A flight without some of the rows of another."""

    def __init__(self, flight, kept):
        self.flight, self.kept = flight, kept
        self.rows, self.seconds = len(kept), flight.seconds[kept]
        self.has_all = flight.has_all

    def values(self, name):
        return self.flight.values(name)[self.kept]


def test_gnd61_missing_rows_hide_no_card_without_a_word():
    """The rows in which the surfaces move are not in the record."""
    found = manoeuvres.found(Lacking(
        Carded(slice(0)), numpy.r_[0:503, 552:1_000]))
    assert [(each.begin, each.reason) for each in found] == [
        (10.0, manoeuvres.NOT_JUDGED)]


def test_gnd61_surfaces_before_a_gap_are_not_the_rest_of_a_card():
    """The surfaces of 0.5 s before switch 5 count; older ones may have had
    another trim."""
    flight = Carded(slice(0))
    values = flight.values
    flight.values = lambda name: values(name) + 1.0 * (
        name.endswith("rudder") & (flight.seconds < 9.0))
    found = manoeuvres.found(Lacking(
        flight, numpy.r_[0:450, 497:1_000]))
    assert [each.axes for each in found] == [("longitudinal",)]


def test_gnd61_switch_5_without_a_card_is_no_manoeuvre():
    flight = Carded(slice(510, 514))
    values = flight.values
    flight.values = lambda name: values(name) * ("elevator" not in name)
    assert manoeuvres.found(flight) == []


def test_gnd62_a_surface_that_never_moves_is_reported(flown, tmp_path):
    """No rudder manoeuvre, so the data say nothing of its derivatives."""
    from urv import flights
    flight = flights.read(flown / "record.csv", lambda _record: None)
    rolls = [each for each in manoeuvres.found(flight)
             if each.axes == ("lateral",)]
    # Ailerons move 3.5 s after the manoeuvre's begin.
    times = tmp_path / "times.csv"
    times.write_text("begin_s,end_s,axes\n" + "".join(
        f"{each.begin + 3.2:.2f},{each.end:.2f},lateral\n"
        for each in rolls), "utf-8")
    result = analysis.identify(
        [flight], aircraft.read(), (manoeuvres.from_file(times),))
    axis = result.axes["lateral"]
    each = axis.derivatives["Cn_rudder"]
    assert not each.is_determined
    assert each.reason == "nothing moved it"
    assert axis.derivatives["Cl_aileron"].is_determined
    assert result.axes["longitudinal"].reason == analysis.NO_MANOEUVRES


def test_gnd64_the_file_of_the_aircraft_is_that_of_the_model(tmp_path):
    """Small differences on JSBSim's own model."""
    made = tmp_path / "made.json"
    subprocess.run(
        [sys.executable, "-B", ROOT / "sim/jsbsim/derivatives.py", "-o",
         made], check=True)
    made, kept = (json.loads(path.read_text("utf-8"))
                  for path in (made, aircraft.DEFAULT))
    derivatives = made.pop("derivatives"), kept.pop("derivatives")
    assert derivatives[0] == pytest.approx(derivatives[1], abs=1e-4)
    trim = made.pop("trim"), kept.pop("trim")
    assert trim[0] == pytest.approx(trim[1], abs=0.1)
    assert made == kept
    # Some are in the model's own file.
    assert derivatives[1]["Cl_p"] == pytest.approx(-0.45, abs=1e-3)
    assert derivatives[1]["Cn_rudder"] == pytest.approx(0.07, abs=1e-3)
    assert derivatives[1]["Cm_q"] == pytest.approx(-14 - 4, abs=0.01)


@pytest.mark.parametrize("text, error", [
    ("[]", "no aircraft file"), ("{", "not JSON"),
    ("{}", "there is no mass_slug")])
def test_gnd61_a_bad_aircraft_file_gives_one_line(tmp_path, text, error):
    path = tmp_path / "a.json"
    path.write_text(text, "utf-8")
    with pytest.raises(faults.Refused, match=error):
        aircraft.read(path)


@pytest.mark.parametrize("value", ["0", "-1", "true", "\"1\"", "null"])
def test_gnd61_a_mass_that_is_no_positive_number_is_refused(tmp_path, value):
    given = aircraft.DEFAULT.read_text("utf-8")
    mass = json.loads(given)["mass_slug"]
    path = tmp_path / "a.json"
    path.write_text(given.replace(f"\"mass_slug\": {mass}",
                                  f"\"mass_slug\": {value}"), "utf-8")
    with pytest.raises(faults.Refused, match="mass_slug is no positive"):
        aircraft.read(path)


@pytest.mark.parametrize("field, value, error", [
    ("mass_slug", 1e-300, "mass_slug is from 1e-06 to 1e+09"),
    ("ixz_slug_ft2", -1e200, "ixz_slug_ft2 is from -1e+09 to 1e+09"),
    ("delays_ms", {"rates": -1}, "delays_ms are numbers from 0 to 500 of"),
    ("delays_ms", {"forces": 2}, "of attitude, rates, accelerations"),
    ("delays_ms", [4], "delays_ms are numbers"),
    ("delays_deviation_ms", 0, "delays_deviation_ms is from 0.01 to 500"),
    ("delays_deviation_ms", "2", "delays_deviation_ms is from 0.01 to 500"),
    ("aircraft", "\ud800", "aircraft is a name of at most 60"),
    ("aircraft", ["lambda"], "aircraft is a name of at most 60")])
def test_gnd61_what_no_aircraft_has_is_refused(
        tmp_path, field, value, error):
    given = json.loads(aircraft.DEFAULT.read_text("utf-8")) | {field: value}
    path = tmp_path / "a.json"
    path.write_text(json.dumps(given), "utf-8")
    with pytest.raises(faults.Refused, match=re.escape(error)):
        aircraft.read(path)


@pytest.mark.parametrize("text, error", [
    ("begin,end\n", "times.csv:1: the columns are begin_s,end_s,axes"),
    ("begin_s,end_s,axes\n1,x,both\n", "times.csv:2: times are numbers"),
    ("begin_s,end_s,axes\n2,1,both\n", "times.csv:2: begin_s is before"),
    ("begin_s,end_s,axes\n1,nan,both\n", "times.csv:2: begin_s is before"),
    ("begin_s,end_s,axes\n1,2,roll\n", "times.csv:2: axes are"),
    ("begin_s,end_s,axes\n1,2,both\n3,200,both\n",
     "times.csv:3: a manoeuvre lasts at most 120 s"),
    # The message was that of a flight whose sticks never move.
    ("begin_s,end_s,axes\n", "times.csv: it has no manoeuvre"),
    # Data that counted twice made intervals narrower by the root of two.
    ("begin_s,end_s,axes\n1,9,lateral\n20,30,both\n8,15,both\n",
     "times.csv:4: overlaps the lateral manoeuvre of line 2"),
])
def test_gnd61_bad_times_of_manoeuvres_are_refused(tmp_path, text, error):
    times = tmp_path / "times.csv"
    times.write_text(text, "utf-8")
    with pytest.raises(faults.Refused, match=re.escape(error)):
        manoeuvres.from_file(times)


def test_gnd61_times_that_a_spreadsheet_wrote_are_read(tmp_path):
    """They begin with a byte order mark and have CR LF: the message was that
    the columns are begin_s,end_s,axes, which they were."""
    times = tmp_path / "times.csv"
    times.write_bytes("\ufeffbegin_s,end_s,axes\r\n1,2.5,both\r\n"
                      "2.5,4,lateral\r\n".encode())
    flight = SimpleNamespace(seconds=numpy.array([0.02, 4.0]))
    first, second = manoeuvres.from_file(times)(flight)
    assert (first.begin, first.end, first.axes, first.reason) == (
        1.0, 2.5, ("longitudinal", "lateral"), "")
    assert (second.end, second.reason) == (4.0, "")


def test_gnd61_times_outside_of_the_record_are_reported(tmp_path):
    """A manoeuvre that ends after the record was cut there without a word, and
    one behind it was "shorter than 1 s"."""
    times = tmp_path / "times.csv"
    times.write_text("begin_s,end_s,axes\n5,15,lateral\n50,60,lateral\n",
                     "utf-8")
    flight = SimpleNamespace(seconds=numpy.array([0.02, 12.0]))
    for each in manoeuvres.from_file(times)(flight):
        assert each.reason == (
            "it is not in the record, which has 0.02 to 12.00 s")


def test_gnd62_no_data_count_twice_and_outputs_are_checked_first(
        urv, tmp_path):
    fly(tmp_path, "--seconds", "1")
    result = urv("identify", "record.csv", "./record.csv")
    assert (result.returncode, result.stderr) == (
        2, 'urv: RECORD 1 and RECORD 2 name the same file: "record.csv":'
        " its data would count twice\n")
    # After minutes of work the result could not be written.
    result = urv("identify", "record.csv", "--json", "none/result.json")
    assert (result.returncode, result.stderr) == (
        1, 'urv: "none/result.json" cannot be written: No such file or'
        " directory\n")


def test_gnd61_a_flight_without_manoeuvres_gives_one_line(
        urv, tmp_path):
    fly(tmp_path, "--seconds", "5")
    result = urv("identify", "record.csv", "-o", "report.html")
    assert (result.returncode, result.stdout) == (2, "")
    assert "no manoeuvre: no stick moves" in result.stderr
    assert len(result.stderr.splitlines()) == 1
    assert not (tmp_path / "report.html").exists()


def test_gnd61_a_record_that_was_cut_short_is_reported(urv, tmp_path):
    fly(tmp_path, "--seconds", "5")
    record = tmp_path / "record.csv"
    record.write_bytes(record.read_bytes()[:-20])
    result = urv("identify", "record.csv")
    assert result.stderr.splitlines()[0].startswith(
        'urv: "record.csv" was cut short: '), result.stderr


def test_gnd61_manoeuvres_with_gaps_are_not_used(urv, tmp_path, flown):
    (tmp_path / "cut.txt").write_text("7000 cut 500\n", "utf-8")
    folder = fly(tmp_path, "--plant", "jsbsim", "--sticks",
                 flown / "sticks.csv", "--faults", tmp_path / "cut.txt",
                 "--seconds", "14")
    result = urv("identify", folder / "record.csv")
    assert result.returncode == 2
    assert "a gap of more than 0.1 s" in result.stderr


def test_gnd62_a_flight_by_the_pilot_does_not_determine_lateral_motion(
        tmp_path):
    """The simulated pilot moves rudder and ailerons with the motion."""
    from urv import flights
    fly(tmp_path, "--plant", "jsbsim", "--pilot", "standard", "--seconds", "70")
    flight = flights.read(tmp_path / "record.csv", lambda _record: None)
    result = analysis.identify([flight], aircraft.read())
    for name, each in result.axes["lateral"].derivatives.items():
        assert not each.is_determined, each
        assert ("nothing moved it" if name.endswith("_speed") else
                "moves with the other variables") in each.reason

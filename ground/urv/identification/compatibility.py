# SPDX-License-Identifier: Apache-2.0
"""Are a flight's data compatible? Errors of its sensors (GND-61).

Rates and accelerations, integrated by the equations of motion alone, give
airspeed, alpha, beta, attitude and altitude. Output error finds the constant
errors, scale factors and delays with which all of them agree. No aerodynamics
are assumed. Still air is, but a steady wind changes nothing.

Two sums cannot be separated: an error of attitude from one of the
accelerations, and a factor of the airspeed from its constant error when the
flight has one speed. Constant errors of the attitude are therefore not estimated,
but widen the deviations of all others.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy

from urv.identification import measurements, output_error
from urv.identification.measurements import GRAVITY, Segment
from urv.identification.output_error import RECORD, Parameter

DEG = numpy.radians(1.0)
KT = measurements.FPS_PER_KT

SIGNIFICANT = 3.0
"""Standard deviations from which on a scale factor or a delay is applied."""

LEAST_SCALE_ERROR = 0.02
ROUGH = 0.15
"""Theil's coefficient of alpha or beta from which on the air is too
rough: gusts then look like scale factors and delays."""

LEAST_DELAY_S = 0.003
"""A smaller delay is not applied: steps of a simulation of 4 ms make 2 ms."""

BIASES = {"ax": ("ft/s2", 0.05 * GRAVITY), "ay": ("ft/s2", 0.05 * GRAVITY),
          "az": ("ft/s2", 0.05 * GRAVITY), "p": ("rad/s", 2.0 * DEG),
          "q": ("rad/s", 2.0 * DEG), "r": ("rad/s", 2.0 * DEG),
          "airspeed": ("ft/s", 2.0 * KT), "alpha": ("rad", 3.0 * DEG),
          "beta": ("rad", 3.0 * DEG)}
"""Constant errors, with the deviation that is taken for possible before."""

SCALES = {"alpha": 0.3, "beta": 0.3}
DELAYS = {"rates": (measurements.RATES, 0.1),
          "accelerations": (measurements.ACCELERATIONS, 0.1),
          "airflow": (measurements.AIRFLOW, 0.1)}
"""Delays against the attitudes."""

MOST_DELAY_S = 0.3
"""No sensor is later, beside others. A wrong sign looks like a delay of seconds."""

ATTITUDE = {"phi": 0.5 * DEG, "theta": 0.5 * DEG}
"""Standard deviations of the attitudes' constant errors, which are taken for
0: a usual mounting and a usual vertical gyro (D-90)."""

CONTRADICTED = {
    "phi": (DEG, "the roll attitude contradicts the rates"),
    "theta": (DEG, "the pitch attitude contradicts the rates"),
    "altitude": (3.0, "the altitude contradicts the accelerations"),
    "airspeed": (KT, "the airspeed contradicts the accelerations")}
"""Outputs with the deviation from which on they move. Gusts move the airspeed,
but none of the others."""
CONTRADICTORY = 0.5
"""The share of an output's movement from which on its residual is an error of
the record: that of a sound record is below 0.05."""

SHOWN = {"ft/s2": ("g", 1.0 / GRAVITY), "rad/s": ("deg/s", 1.0 / DEG),
         "rad": ("deg", 1.0 / DEG), "ft/s": ("kt", 1.0 / KT)}


@dataclass(frozen=True)
class Found:
    """An error of a sensor, in the unit of people."""

    name: str
    unit: str
    value: float
    deviation: float
    is_determined: bool
    """The data say more of it than was taken for possible before."""
    is_applied: bool
    """The data are corrected for it."""
    is_at_bound: bool = False
    """The data want more than a sensor has."""


def bounded(delay):
    return numpy.clip(delay, -MOST_DELAY_S, MOST_DELAY_S)


class Kinematics:
    """The equations of motion of a rigid body."""

    states = ("u", "v", "w", "phi", "theta", "height")
    outputs = ("airspeed", "alpha", "beta", "phi", "theta", "altitude")
    noisy = ("p", "q", "r", "ax", "ay", "az")
    sizes = (1.0, 1.0, 1.0, DEG, DEG, 1.0)

    def __init__(self, gravity):
        self.gravity = gravity

        def known(deviation, mean=0.0):
            return mean, deviation

        self.parameters = (
            *(Parameter(f"bias {name}", RECORD, 0.0, 0.02 * deviation,
                        prior=known(deviation))
              for name, (_, deviation) in BIASES.items()),
            *(Parameter(f"scale {name}", RECORD, 1.0, 0.01,
                        prior=known(deviation, 1.0))
              for name, deviation in SCALES.items()),
            *(Parameter(f"delay {name}", RECORD, 0.0, 0.005,
                        is_input=name != "airflow", prior=known(deviation))
              for name, (_, deviation) in DELAYS.items()),
            *(Parameter(f"attitude {name}", RECORD, 0.0, 0.1 * deviation,
                        prior=known(deviation), is_considered=True)
              for name, deviation in ATTITUDE.items()))
        self.place = {each.name: number
                      for number, each in enumerate(self.parameters)}

    def prior(self, parameter, _record):
        return parameter.prior

    def measured(self, segment: Segment):
        return numpy.array([segment[name] for name in self.outputs])

    def first_states(self, segment: Segment):
        few = slice(0, 10)
        true = (segment["airspeed"] / numpy.sqrt(segment.density_ratio))[few]
        speed, alpha, beta, phi, theta, height = (
            numpy.mean(each) for each in (
                true, *(segment[name][few] for name in self.outputs[1:])))
        return numpy.array([
            speed * numpy.cos(alpha) * numpy.cos(beta),
            speed * numpy.sin(beta),
            speed * numpy.sin(alpha) * numpy.cos(beta), phi, theta, height])

    def inputs(self, segment, times, values):
        delay = {name: bounded(values[self.place[f"delay {name}"]])
                 for name in ("rates", "accelerations")}
        return numpy.concatenate([
            segment.splines("p", "q", "r")(times + delay["rates"]),
            segment.splines("ax", "ay", "az")(
                times + delay["accelerations"]),
            [numpy.interp(times, segment.times,
                          numpy.sqrt(segment.density_ratio))]])

    def rates(self, states, inputs, values):
        u, v, w, phi, theta, _ = states
        p, q, r = (inputs[place] - values[self.place[f"bias {name}"]]
                   for place, name in enumerate("pqr"))
        ax, ay, az = (inputs[3 + place] - values[self.place[f"bias {name}"]]
                      for place, name in enumerate(("ax", "ay", "az")))
        sin_phi, cos_phi = numpy.sin(phi), numpy.cos(phi)
        sin_theta, cos_theta = numpy.sin(theta), numpy.cos(theta)
        turning = q * sin_phi + r * cos_phi
        return numpy.array([
            r * v - q * w - self.gravity * sin_theta + ax,
            p * w - r * u + self.gravity * sin_phi * cos_theta + ay,
            q * u - p * v + self.gravity * cos_phi * cos_theta + az,
            p + turning * sin_theta / cos_theta,
            q * cos_phi - r * sin_phi,
            u * sin_theta - (v * sin_phi + w * cos_phi) * cos_theta])

    def outputs_of(self, states, inputs, values):
        u, v, w, phi, theta, height = states
        p, q, r = inputs[:3]
        accelerations = self.rates(states, inputs, values)
        speed = numpy.sqrt(u * u + v * v + w * w)
        alpha = numpy.arctan2(w, u)
        beta = numpy.arcsin(numpy.clip(v / speed, -1.0, 1.0))
        # The airflow's words are late: what they show was so before.
        late = bounded(values[self.place["delay airflow"]])
        du, dv, dw = accelerations[:3]
        alpha = alpha - late * (u * dw - w * du) / (u * u + w * w)
        beta = beta - late * dv / speed
        shown = speed - late * du
        bias = {name: values[self.place[f"bias {name}"]]
                for name in ("airspeed", "alpha", "beta")}
        return numpy.array([
            shown * inputs[6] + bias["airspeed"],
            values[self.place["scale alpha"]] * alpha + bias["alpha"],
            values[self.place["scale beta"]] * beta + bias["beta"],
            phi + values[self.place["attitude phi"]],
            theta + values[self.place["attitude theta"]], height])


@dataclass
class Compatibility:
    """Errors of a record's sensors, and the fit that found them."""

    found: list[Found]
    fit: output_error.Fit
    segments: list[Segment]
    is_rough: bool
    """Gusts hide scale factors and delays: none is applied."""
    airspeed_deviation: float
    """Standard deviation of the airspeed's constant error, ft/s."""
    alpha_deviation: float
    """Standard deviation of alpha's constant error, rad."""
    contradictions: list[str]
    """Sensors that contradict each other by more than errors of sensors."""

    @property
    def by_name(self) -> dict[str, Found]:
        return {each.name: each for each in self.found}


def roughness(model, fit, segments):
    """The larger of Theil's coefficients of alpha and beta."""
    found = []
    for row in (1, 2):
        squares, size = 0.0, [0.0, 0.0]
        for part, outputs, residuals in zip(segments, fit.outputs,
                                            fit.residuals, strict=True):
            measured = model.measured(part)[row]
            middle = measured.mean()
            squares += (residuals[row] ** 2).sum()
            for place, values in enumerate((measured, outputs[row])):
                size[place] += ((values - middle) ** 2).sum()
        found.append(numpy.sqrt(squares) / max(
            numpy.sqrt(size).sum(), 1e-12))
    return max(found)


def contradictions(model, fit, segments, is_rough):
    """In words."""
    found = []
    for row, name in enumerate(model.outputs):
        if name not in CONTRADICTED or (is_rough and name == "airspeed"):
            continue
        least, text = CONTRADICTED[name]
        moved, left, count = 0.0, 0.0, 0
        for part, residuals in zip(segments, fit.residuals, strict=True):
            measured = model.measured(part)[row][part.is_fresh]
            moved += ((measured - measured.mean()) ** 2).sum()
            left += (residuals[row] ** 2).sum()
            count += len(measured)
        if moved > count * least ** 2 and left > CONTRADICTORY ** 2 * moved:
            found.append(text)
    return found


def check(segments: list[Segment], gravity=GRAVITY) -> Compatibility:
    """The errors of the sensors of one record, from its segments."""
    model = Kinematics(gravity)
    fit = output_error.estimate(output_error.Problem(model, segments))
    record = segments[0].record
    is_rough = roughness(model, fit, segments) > ROUGH
    applied, others = needed(model, fit, record, is_rough)
    # Beside an error that is not applied, the others would have a share of it.
    small = {each.name: each.prior[0] for each in model.parameters
             if each.name.split(" ")[0] in ("scale", "delay")
             and each.name not in applied}
    fit = output_error.estimate(output_error.Problem(model, segments, small))
    found = []
    for each in model.parameters:
        if each.is_considered:
            continue
        kind, name = each.name.split(" ")
        value, deviation = others.get(each.name) or (
            fit.of_records[each.name, record],
            fit.deviations[f"{each.name}/{record}"])
        unit, factor = {
            "bias": SHOWN[BIASES[name][0]] if kind == "bias" else None,
            "scale": ("", 1.0), "delay": ("ms", 1e3)}[kind]
        is_at_bound = kind == "delay" and abs(value) >= MOST_DELAY_S
        value = bounded(value) if is_at_bound else value
        determined = deviation < 0.5 * each.prior[1] and not is_at_bound
        found.append(Found(
            each.name, unit, value * factor, deviation * factor, determined,
            determined if kind == "bias" else
            each.name in applied and not is_at_bound, is_at_bound))
    return Compatibility(
        found, fit, segments, is_rough,
        *(min(fit.deviations[f"bias {name}/{record}"], BIASES[name][1])
          for name in ("airspeed", "alpha")),
        contradictions(model, fit, segments, is_rough))


def needed(model, fit, record, is_rough):
    """The scale factors and delays without which the data disagree; and for each
    other one its value and deviation, if it is the only one beside these.

    By forward selection: again and again the most significant one joins, judged
    as if those that have not joined were none. Estimated all at once, a scale
    factor of alpha and a delay of the accelerations compensate each other, and
    both look significant. In rough air none joins, and never a delay at its
    bound."""
    nominal = {each.name: each.prior[0] for each in model.parameters
               if each.name.split(" ")[0] in ("scale", "delay")}
    names = list(nominal)
    keys = [f"{name}/{record}" for name in names]
    rows = [fit.names.index(key) for key in keys]
    found = numpy.array([fit.of_records[name, record] - nominal[name]
                         for name in names])

    def covariance(correlations, deviations):
        sizes = numpy.array([deviations[key] for key in keys])
        return correlations[numpy.ix_(rows, rows)] * numpy.outer(sizes, sizes)

    information = numpy.linalg.pinv(covariance(
        fit.white_correlations, fit.white_deviations), hermitian=True)
    coloured = covariance(fit.correlations, fit.deviations)
    chosen = []
    while True:
        beside = {}
        for row, name in enumerate(names):
            if row not in chosen:
                both = [*chosen, row]
                # The estimate of these alone, from that of all.
                shares = (numpy.linalg.pinv(
                    information[numpy.ix_(both, both)], hermitian=True)
                    @ information[both])[-1]
                value = shares @ found
                beside[name] = (
                    bounded(value) if name.startswith("delay") else value,
                    numpy.sqrt(max(shares @ coloured @ shares, 1e-18)))
        large = {name: abs(value) / deviation
                 for name, (value, deviation) in beside.items()
                 if abs(value) > max(
                     SIGNIFICANT * deviation,
                     LEAST_DELAY_S if name.startswith("delay")
                     else LEAST_SCALE_ERROR)
                 and not (name.startswith("delay")
                          and abs(value) >= MOST_DELAY_S)}
        if is_rough or not large:
            return ([names[row] for row in chosen],
                    {name: (nominal[name] + value, deviation)
                     for name, (value, deviation) in beside.items()})
        chosen.append(names.index(max(large, key=large.get)))


def corrected(segment: Segment, known: Compatibility) -> Segment:
    """The segment without the errors that the data show."""
    errors = {}
    for each in known.found:
        if each.is_applied:
            errors[each.name] = known.fit.of_records[
                each.name, segment.record]
    delays = {}
    for name, (group, _) in DELAYS.items():
        delays |= {signal: errors.get(f"delay {name}", 0.0)
                   for signal in group}
    moved = measurements.shifted(segment, delays)
    return moved.with_signals(**{
        name: (moved[name] - errors.get(f"bias {name}", 0.0))
        / errors.get(f"scale {name}", 1.0) for name in BIASES})

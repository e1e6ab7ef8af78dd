# SPDX-License-Identifier: Apache-2.0
"""From records to derivatives with bounds (GND-61 to GND-64)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy
from scipy import stats

from urv.identification import (
    airframes,
    compatibility,
    consistency,
    equation_error,
    manoeuvres,
    measurements,
    output_error,
)

LEVEL = 0.95
FACTOR = float(stats.norm.ppf(0.5 + LEVEL / 2.0))

MOST_WIDTH = 0.5
"""A derivative is determined when half its interval is at most this share of
it."""

MOST_INFLATION = 30.0
"""A variable whose variance the others enlarge more moves with them: a small
error of the model then moves the estimate by more than its interval."""

CLOSE = 0.95
"""A correlation of two derivatives of which only a sum is known."""

NO_FIT = 0.6
"""Theil's coefficient of a model that does not follow an output at all."""
FOLLOWS_NOTHING = "the model does not follow the flight"

CONTRADICTION = "sensors of record {} contradict each other"

CHECKED, ESTIMATED = 5.0, {"longitudinal": 1.0, "lateral": 2.7}
"""Work of a record, in seconds of a processor: the check of its sensors, and its
part in the estimate of each axis."""
STEPS = 8
"""Steps of a usual search."""

NO_MANOEUVRES = "no manoeuvre moves this axis"


@dataclass(frozen=True)
class Derivative:
    """A derivative with its 95 % interval, per rad."""

    name: str
    value: float
    low: float
    high: float
    white_half_width: float
    """Half of the interval if residuals were white."""
    by_equation_error: float
    prior: float | None
    is_determined: bool
    reason: str = ""
    """Why the data do not determine it."""
    noise_half_width: float = numpy.nan
    """Half of the interval by the residuals alone: without delays and errors of
    sensors, and without the difference of both methods."""


@dataclass
class Flown:
    """A manoeuvre and its part in the estimate."""

    manoeuvre: manoeuvres.Manoeuvre
    record: int
    segment: measurements.Segment | None = None
    reason: str = ""
    """Why it is not used."""
    is_for_validation: bool = False
    outputs: numpy.ndarray | None = None
    residuals: numpy.ndarray | None = None
    inequality: dict[str, float] = field(default_factory=dict)
    """Theil's coefficient of each output: 0 is exact; below 0.3 is good."""


@dataclass
class Axis:
    """The result of one axis."""

    axis: str
    outputs: tuple[str, ...]
    flown: list[Flown]
    derivatives: dict[str, Derivative] = field(default_factory=dict)
    fit: output_error.Fit | None = None
    reason: str = ""
    """Why there is no result."""
    different: dict[int, dict[str, float]] = field(default_factory=dict)
    """Records whose own derivatives differ from those of the others:
    consistency.different."""


@dataclass
class Result:
    """The result of all records together."""

    records: list[str]
    compatibility: list[compatibility.Compatibility | None]
    axes: dict[str, Axis]


class Work:
    """How much of an identification is done, for progress.bar."""

    def __init__(self, records, told):
        self.told = told
        self.size = records * (CHECKED + sum(ESTIMATED.values()))
        self.position = self.done = 0.0

    def finish(self, work):
        """Adds a finished part."""
        self.done += work
        self.position = self.done
        self.told(self)

    def steps(self, work):
        """The function to call after each step of a search with that work."""
        count = 0

        def step():
            nonlocal count
            count = min(count + 1, STEPS)
            self.position = self.done + work * count / (STEPS + 1)
            self.told(self)
        return step


def identify(flights, aircraft, finders=manoeuvres.FINDERS,
             hold_out=1, told=lambda work: None) -> Result:
    """The derivatives of an aircraft from its flights. The last hold_out
    manoeuvres of each axis are for validation, where at least two more remain.
    told is called with the work done.
    """
    work = Work(len(flights), told)
    parts = []
    checks = []
    for record, flight in enumerate(flights):
        own = []
        for each in manoeuvres.found(flight, finders):
            flown = Flown(each, record, reason=each.reason)
            own.append(flown)
            if each.reason:
                continue
            try:
                flown.segment = measurements.without_delays(
                    measurements.segment(
                        flight, each.begin, each.end, record),
                    aircraft.delays)
            except measurements.Unusable as fault:
                flown.reason = str(fault)
        usable = [each for each in own if each.segment is not None]
        known = None
        if usable:
            known = compatibility.check(
                [each.segment for each in usable], aircraft.gravity)
            for each in usable:
                each.segment = measurements.smooth_airspeed(
                    compatibility.corrected(each.segment, known))
        work.finish(CHECKED)
        checks.append(known)
        parts += own
    deviations = {
        name: {record: getattr(known, f"{name}_deviation")
               for record, known in enumerate(checks) if known}
        for name in ("airspeed", "alpha")}
    axes = {}
    for kind in airframes.AXES:
        # A manoeuvre of both axes has a part in each.
        flown = [Flown(each.manoeuvre, each.record, each.segment, each.reason)
                 for each in parts if kind.axis in each.manoeuvre.axes]
        share = len(flights) * ESTIMATED[kind.axis]
        airframe = kind(aircraft, deviations)
        axis = of_axis(airframe, flown, hold_out, work.steps(share))
        # Gusts make derivatives that differ, and have a caution of their own.
        axis.different = consistency.different(
            airframe, [each.segment for each in flown if each.segment
                       and not checks[each.record].is_rough])
        axes[kind.axis] = axis
        work.finish(share)
        doubt(axes[kind.axis], checks)
    return Result([str(flight.path) for flight in flights], checks, axes)


def of_axis(airframe, flown, hold_out, told=lambda: None) -> Axis:
    """Equation error, output error, then validation. told is called after each
    step."""
    result = Axis(airframe.axis, airframe.outputs, flown)
    usable = [each for each in flown if each.segment is not None]
    if not usable:
        result.reason = NO_MANOEUVRES
        return result
    if 0 < hold_out <= len(usable) - 2:
        for each in usable[-hold_out:]:
            each.is_for_validation = True
    used = [each for each in usable if not each.is_for_validation]
    segments = [each.segment for each in used]
    start = equation_error.regress(airframe, segments)
    fixed = {f"{name}_{variable}": 0.0 for name in airframe.coefficients
             for variable in start.missing}
    problem = output_error.Problem(airframe, segments, fixed)
    begin(problem, airframe, start, segments)
    fit = output_error.estimate(problem, told)
    result.fit = fit
    for each, outputs, residuals in zip(used, fit.outputs, fit.residuals,
                                        strict=True):
        keep(each, airframe, outputs, residuals)
    for name in airframe.derivatives:
        result.derivatives[name] = derivative(name, airframe, start, fit)
    validate(airframe, fit, fixed,
             [each for each in usable if each.is_for_validation])
    return result


def doubt(axis, checks):
    """No interval contains an error of the record."""
    wrong = sorted({each.record for each in axis.flown if each.segment
                    and checks[each.record].contradictions})
    fits = [min(each.inequality.values()) for each in axis.flown
            if each.inequality]
    if wrong:
        reason = CONTRADICTION.format(wrong[0] + 1)
    elif fits and numpy.median(fits) >= NO_FIT:
        reason = FOLLOWS_NOTHING
    else:
        return
    for name, each in axis.derivatives.items():
        axis.derivatives[name] = replace(
            each, is_determined=False, reason=each.reason or reason)


def begin(problem, airframe, start, segments):
    """Puts the start by equation error into the problem."""
    for name, value in start.values.items():
        problem.start[problem.names.index(name)] = value
    for name, constants in start.constants.items():
        for number, (part, value) in enumerate(
                zip(segments, constants, strict=True)):
            problem.start[problem.names.index(
                f"{name}_0/{part.record}/{number}")] = value


def derivative(name, airframe, start, fit) -> Derivative:
    """A derivative's interval, and whether the data determine it."""
    prior = airframe.aircraft.prior.get(name)
    variable = name.split("_")[1]
    if variable in start.missing:
        return Derivative(name, numpy.nan, numpy.nan, numpy.nan, numpy.nan,
                          numpy.nan, prior, False, start.missing[variable])
    value = fit.values[name]
    # The two methods differ by what the model lacks.
    half = FACTOR * numpy.hypot(
        fit.deviations[name], (value - start.values[name]) / 2.0)
    inflation = start.inflation[variable]
    determined = bool(half <= MOST_WIDTH * abs(value)
                      and inflation <= MOST_INFLATION)
    reason = ""
    if inflation > MOST_INFLATION:
        reason = (f"{variable} moves with the other variables, which enlarge"
                  f" the variance {inflation:.0f} times")
    elif not determined:
        row = fit.names.index(name)
        closest = max(
            (other for other in airframe.derivatives
             if other != name and other in fit.names),
            key=lambda other: abs(
                fit.correlations[row, fit.names.index(other)]))
        close = fit.correlations[row, fit.names.index(closest)]
        reason = (f"it cannot be separated from {closest}: correlation"
                  f" {close:.2f}" if abs(close) > CLOSE else
                  "its effect is below the noise; it may be zero"
                  if half >= abs(value) else
                  "its effect is little above the noise")
    return Derivative(
        name, value, value - half, value + half,
        FACTOR * fit.white_deviations[name], start.values[name], prior,
        determined, reason, FACTOR * fit.noise_deviations[name])


def keep(flown, airframe, outputs, residuals):
    """Stores a manoeuvre's computed outputs and how well they fit."""
    flown.outputs, flown.residuals = outputs, residuals
    measured = airframe.measured(flown.segment)
    fresh = flown.segment.is_fresh
    for row, name in enumerate(airframe.outputs):
        # About the mean, so that a trim does not make a fit look good.
        middle = measured[row, fresh].mean()
        one, other = (each[row, fresh] - middle
                      for each in (measured, outputs))
        size = numpy.sqrt((one ** 2).mean()) + numpy.sqrt((other ** 2).mean())
        flown.inequality[name] = float(
            numpy.sqrt((residuals[row, fresh] ** 2).mean())
            / max(size, 1e-12))


def validate(airframe, fit, fixed, flown):
    """Computes manoeuvres that the estimate did not use. Their first states
    and constants are fitted; no derivative is."""
    if not flown:
        return
    known = fixed | fit.values
    segments = [each.segment for each in flown]
    problem = output_error.Problem(airframe, segments, known, fit.of_records)
    start = equation_error.regress(airframe, segments)
    del start
    answer = output_error.estimate(problem)
    for each, outputs, residuals in zip(flown, answer.outputs,
                                        answer.residuals, strict=True):
        keep(each, airframe, outputs, residuals)

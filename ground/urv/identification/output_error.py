# SPDX-License-Identifier: Apache-2.0
"""Maximum likelihood by output error, for any dynamic model (GND-62).

The model's states are integrated from its parameters alone; the difference of
outputs and measurements is noise. Gauss and Newton's method, of
scipy.optimize.least_squares, finds the parameters; the noise's variance of each
output comes from the residuals, until both rest.

All segments, and all changes of parameters for the derivatives of the outputs,
are integrated at once, as columns of one array.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy
from scipy import optimize

from urv.identification import bounds, measurements
from urv.identification.measurements import Segment

MOST_ROUNDS = 12
MOST_STEPS = 8
MOST_KEPT = 2
"""Results of a search that are kept: the best one and a step that failed."""

DRAWS = 50
"""Drawn histories of the inputs' noise. They give deviations to a tenth."""
MOST_AT_ONCE = 1_000_000
"""Times of all columns that are integrated at once for them."""

FAR = 1e4
"""States beyond this have diverged."""

HELD = 1e-6
"""Share of a considered parameter's deviation that the solution may use."""

SEGMENT, RECORD, ALL = "segment", "record", "all"


@dataclass(frozen=True)
class Parameter:
    """A parameter of a model, with the data that share it, its first value, and
    the size of a change that matters."""

    name: str
    scope: str
    start: float
    size: float
    is_input: bool = False
    """It changes the inputs, not only the equations."""
    prior: tuple[float, float] | None = None
    """Mean and standard deviation known before. With scope RECORD, prior and
    start may be given for each record by Model.prior."""
    is_considered: bool = False
    """Not estimated, but known with the prior's deviation only, which widens
    the bounds of all others."""


class Model(Protocol):
    """A dynamic model. Arrays have states, inputs or outputs as rows and any
    number of columns."""

    states: tuple[str, ...]
    outputs: tuple[str, ...]
    sizes: tuple[float, ...]
    """Changes of the first states that matter."""
    parameters: tuple[Parameter, ...]
    noisy: tuple[str, ...]
    """The measured signals among the inputs: the first rows, in this order."""

    def prior(self, parameter: Parameter, record: int):
        """Mean and standard deviation, or None."""

    def first_states(self, segment: Segment) -> numpy.ndarray: ...

    def inputs(self, segment: Segment, times: numpy.ndarray,
               values: numpy.ndarray) -> numpy.ndarray:
        """Inputs at the times, for one set of parameters."""

    def measured(self, segment: Segment) -> numpy.ndarray: ...

    def rates(self, states, inputs, values): ...

    def outputs_of(self, states, inputs, values): ...


@dataclass
class Fit:
    """Estimates, and the outputs that they give."""

    values: dict[str, float]
    """Values of the parameters with scope ALL."""
    of_records: dict[tuple[str, int], float]
    deviations: dict[str, float]
    """Standard deviations, corrected for coloured residuals. Parameters of
    records are named NAME/RECORD."""
    white_deviations: dict[str, float]
    """The same if the residuals were white."""
    noise_deviations: dict[str, float]
    """Coloured residuals alone, without what is only considered."""
    correlations: numpy.ndarray
    white_correlations: numpy.ndarray
    names: list[str]
    """Names of the rows of correlations."""
    noise: numpy.ndarray
    """Standard deviation of each output's residuals."""
    outputs: list[numpy.ndarray]
    """Outputs of each segment, as rows."""
    residuals: list[numpy.ndarray]
    rounds: int
    has_converged: bool


class Problem:
    """A model, its segments and where each local parameter is in the vector of
    all of them."""

    def __init__(self, model: Model, segments: list[Segment],
                 fixed: dict[str, float] | None = None,
                 of_records: dict[tuple[str, int], float] | None = None):
        """Parameters in fixed keep that value, those in of_records too."""
        self.model = model
        self.segments = segments
        self.records = sorted({each.record for each in segments})
        fixed, of_records = fixed or {}, of_records or {}
        self.local = len(model.parameters) + len(model.states)
        self.names: list[str] = []
        self.considered: dict[int, float] = {}
        start, size, priors = [], [], []
        places: dict[str, int] = {}
        constant = numpy.zeros((len(segments), self.local))
        self.places = numpy.full((len(segments), self.local), -1)

        def place(key, first, change, prior):
            if key not in places:
                places[key] = len(self.names)
                self.names.append(key)
                start.append(first if prior is None else prior[0])
                size.append(change)
                priors.append(prior)
            return places[key]

        for number, part in enumerate(segments):
            for local, each in enumerate(model.parameters):
                prior = (model.prior(each, part.record)
                         if each.scope == RECORD else each.prior)
                held = prior
                if each.is_considered:
                    prior = prior[0], HELD * prior[1]
                if each.name in fixed:
                    constant[number, local] = fixed[each.name]
                    continue
                if (each.name, part.record) in of_records:
                    constant[number, local] = of_records[
                        each.name, part.record]
                    continue
                key = {ALL: each.name, RECORD: f"{each.name}/{part.record}",
                       SEGMENT: f"{each.name}/{part.record}/{number}",
                       }[each.scope]
                index = self.places[number, local] = place(
                    key, each.start, each.size, prior)
                if each.is_considered:
                    self.considered[index] = held[1]
            firsts = model.first_states(part)
            for local, (name, first) in enumerate(
                    zip(model.states, firsts, strict=True)):
                self.places[number, len(model.parameters) + local] = place(
                    f"first {name}/{number}", first, model.sizes[local],
                    None)
        self.constant = constant
        self.start = numpy.array(start)
        self.size = numpy.array(size)
        self.priors = [(index, *prior) for index, prior in enumerate(priors)
                       if prior is not None]
        self.kept = {}
        self.told = lambda: None
        self.longest = max(len(each.times) for each in segments)
        self.measured = [model.measured(each) for each in segments]

    def locals(self, vector):
        """The local parameters of each segment, as rows."""
        values = numpy.where(
            self.places >= 0, vector[numpy.maximum(self.places, 0)],
            self.constant)
        return values

    def changes(self):
        """Local parameters that are estimated in any segment, with the size
        of a step."""
        for local in range(self.local):
            index = self.places[:, local].max()
            if index >= 0:
                yield local, 1e-4 * self.size[index]

    def integrate(self, vector, with_changes):
        """The outputs, as an array of outputs, times and segments; and the
        same with each parameter changed. The last results are kept: a search
        returns to them."""
        key = vector.tobytes()
        if key not in self.kept or with_changes > self.kept[key][0]:
            result = self.integrated(vector, with_changes)
            self.kept.pop(key, None)
            while len(self.kept) >= MOST_KEPT:
                del self.kept[next(iter(self.kept))]
            self.kept[key] = with_changes, result
            if with_changes:
                self.told()
        return self.kept[key][1]

    def integrated(self, vector, with_changes):
        """Columns are the segments, then the segments with each parameter
        changed; some segments at once, since the inputs take much memory."""
        count, many = len(self.segments), len(self.model.parameters)
        base = self.locals(vector)
        steps = list(self.changes()) if with_changes else []
        shape = len(self.model.outputs), self.longest, count
        found = [numpy.empty(shape) for _ in range(1 + len(steps))]
        at_once = max(1, MOST_AT_ONCE // (self.longest * len(found)))
        for first in range(0, count, at_once):
            group = slice(first, first + at_once)
            sets = [base[group]]
            for local, step in steps:
                changed = base[group].copy()
                changed[:, local] += step * (self.places[group, local] >= 0)
                sets.append(changed)
            table = numpy.concatenate(sets).T
            values, states = table[:many], table[many:].copy()
            out = self.outputs_of(self.input_table(
                self.segments[group], sets, steps), states, values)
            for each, part in zip(found, numpy.split(
                    out, len(found), axis=2), strict=True):
                each[:, :, group] = part
        return found[0], [(local, change, outputs) for (local, change), outputs
                          in zip(steps, found[1:], strict=True)]

    def outputs_of(self, inputs, states, values):
        """The outputs of all columns, by Runge and Kutta's method: outputs,
        times, columns."""
        model = self.model
        step = self.segments[0].step
        columns = states.shape[1]
        out = numpy.empty((len(model.outputs), self.longest, columns))
        with numpy.errstate(all="ignore"):
            for time in range(self.longest):
                now = inputs[2 * time]
                out[:, time] = model.outputs_of(states, now, values)
                if time + 1 == self.longest:
                    break
                middle, after = inputs[2 * time + 1], inputs[2 * time + 2]
                first = model.rates(states, now, values)
                second = model.rates(states + 0.5 * step * first, middle,
                                     values)
                third = model.rates(states + 0.5 * step * second, middle,
                                    values)
                fourth = model.rates(states + step * third, after, values)
                states = states + step / 6.0 * (
                    first + 2.0 * (second + third) + fourth)
                numpy.clip(states, -FAR, FAR, out=states)
        return numpy.nan_to_num(out, nan=FAR, posinf=FAR, neginf=-FAR)

    def disturbances(self, vector):
        """The changes of the outputs by noise of the measured inputs, drawn
        DRAWS times, some at once: for each segment draws, outputs, times."""
        chance = numpy.random.default_rng(0)
        left = DRAWS if self.model.noisy else 0
        while left:
            draws = max(1, min(left, MOST_AT_ONCE // (
                self.longest * len(self.segments))))
            yield self.disturbed(vector, draws, chance)
            left -= draws

    def disturbed(self, vector, draws, chance):
        many, count = len(self.model.parameters), len(self.segments)
        base = self.locals(vector)
        inputs = self.input_table(self.segments, [base], [])
        tiled = numpy.tile(inputs, (1, 1, draws))
        for row, name in enumerate(self.model.noisy):
            sizes = numpy.tile([measurements.noise_of(each[name])
                                for each in self.segments], draws)
            noise = chance.standard_normal(
                (self.longest, draws * count)) * sizes
            tiled[::2, row] += noise
            tiled[1::2, row] += 0.5 * (noise[:-1] + noise[1:])
        table = numpy.tile(base.T, draws)
        out = self.outputs_of(tiled, table[many:].copy(), table[:many])
        undisturbed, _ = self.integrate(vector, False)
        return [
            ((out[:, :, number::count] - undisturbed[:, :, number, None])
             .transpose(2, 0, 1)[:, :, :len(part.times)] * part.is_fresh)
            for number, part in enumerate(self.segments)]

    def input_table(self, segments, sets, steps):
        """Inputs at the frames and between them: times, inputs, columns."""
        model = self.model

        def of(values):
            found = []
            for part, row in zip(segments, values, strict=True):
                times = part.times[0] + 0.5 * part.step * numpy.arange(
                    2 * self.longest - 1)
                times = numpy.minimum(times, part.times[-1])
                found.append(model.inputs(
                    part, times, row[:len(model.parameters)]))
            return numpy.array(found).transpose(2, 1, 0)

        common = of(sets[0])
        tables = [common]
        for (local, _), changed in zip(steps, sets[1:], strict=True):
            is_input = (local < len(model.parameters)
                        and model.parameters[local].is_input)
            tables.append(of(changed) if is_input else common)
        return numpy.ascontiguousarray(numpy.concatenate(tables, axis=2))

    def differences(self, outputs):
        """Measured less computed, for each segment; 0 in gaps."""
        return [
            (measured - outputs[:, :len(part.times), number]) * part.is_fresh
            for number, (part, measured) in enumerate(
                zip(self.segments, self.measured, strict=True))]

    def columns(self, number):
        """The places of a segment's parameters, its own and the shared ones."""
        return numpy.unique(self.places[number][self.places[number] >= 0])

    def sensitivities(self, changed, base):
        """Sensitivities of each segment's outputs: outputs, times, parameters
        of `columns`."""
        for number, part in enumerate(self.segments):
            length = len(part.times)
            columns = self.columns(number)
            table = numpy.zeros((len(self.model.outputs), length,
                                 len(columns)))
            for local, change, outputs in changed:
                index = self.places[number, local]
                if index >= 0:
                    table[:, :, numpy.searchsorted(columns, index)] += (
                        outputs[:, :length, number]
                        - base[:, :length, number]) / change
            yield table * part.is_fresh[None, :, None]

    def reduced(self, vector, noise):
        """Residuals and slopes with the same sum of squares and the same normal
        equations as all of them, but few rows: each segment's are replaced by
        the triangle of their QR factors."""
        base, changed = self.integrate(vector, True)
        residuals, slopes = [], []
        for number, (each, table) in enumerate(zip(
                self.differences(base), self.sensitivities(changed, base),
                strict=True)):
            columns = self.columns(number)
            triangle = numpy.linalg.qr(numpy.column_stack((
                -(table / noise[:, None, None]).reshape(-1, len(columns)),
                (each / noise[:, None]).ravel())), "r")
            rows = numpy.zeros((len(triangle), len(vector)))
            rows[:, columns] = triangle[:, :-1]
            slopes.append(rows)
            residuals.append(triangle[:, -1])
        rows = numpy.zeros((len(self.priors), len(vector)))
        for row, (index, _, deviation) in enumerate(self.priors):
            rows[row, index] = 1.0 / deviation
        residuals.append(numpy.array(
            [(vector[index] - mean) / deviation
             for index, mean, deviation in self.priors]))
        return numpy.concatenate(residuals), numpy.concatenate([*slopes, rows])

    def solve(self, noise):
        """The vector of the most likely parameters for this noise, from the
        present start."""
        newest = [None, None]

        def reduced(vector):
            if newest[0] != vector.tobytes():
                newest[:] = vector.tobytes(), self.reduced(vector, noise)
            return newest[1]

        answer = optimize.least_squares(
            lambda vector: reduced(vector)[0], self.start,
            lambda vector: reduced(vector)[1], method="trf",
            x_scale=self.size, ftol=1e-5, xtol=1e-6, gtol=None,
            max_nfev=MOST_STEPS)
        return answer.x

    def gradients(self, drawn, tables, noise):
        """Gradients of the likelihood by changes of the outputs: draws,
        parameters."""
        found = numpy.zeros((len(drawn[0]), len(self.start)))
        for number, (each, table) in enumerate(zip(drawn, tables, strict=True)):
            found[:, self.columns(number)] += numpy.einsum(
                "dot,otp->dp", each / noise[:, None], table)
        return found

    def noise(self, differences):
        """The standard deviation of each output's residuals."""
        squares = sum((each ** 2).sum(axis=1) for each in differences)
        many = sum(part.is_fresh.sum() for part in self.segments)
        return numpy.maximum(numpy.sqrt(squares / many), 1e-9)


def estimate(problem: Problem, told=lambda: None) -> Fit:
    """The maximum of the likelihood. told is called after each step of the
    search."""
    problem.told = told
    base, _ = problem.integrate(problem.start, False)
    noise = problem.noise(problem.differences(base))
    has_converged = False
    vector = problem.start
    for number in range(1, MOST_ROUNDS + 1):
        before, last = noise, vector
        problem.start = vector = problem.solve(noise)
        base, _ = problem.integrate(vector, False)
        noise = problem.noise(problem.differences(base))
        if (abs(noise / before - 1.0) < 0.01).all() and (
                abs(vector - last) < 0.05 * problem.size).all():
            has_converged = True
            break
    base, changed = problem.integrate(vector, True)
    differences = problem.differences(base)
    tables = [each / noise[:, None, None]
              for each in problem.sensitivities(changed, base)]
    columns = [problem.columns(number)
               for number in range(len(problem.segments))]
    covariance, white, by_noise = bounds.covariances(
        tables, [each / noise[:, None] for each in differences],
        problem.priors, problem.considered,
        [problem.gradients(some, tables, noise)
         for some in problem.disturbances(vector)],
        columns, len(vector))
    deviations = numpy.sqrt(numpy.maximum(numpy.diag(covariance), 0.0))
    safe = numpy.where(deviations > 0, deviations, 1.0)
    whites = numpy.sqrt(numpy.diag(white))
    of_all = {each.name for each in problem.model.parameters}
    return Fit(
        {name: vector[index] for index, name in enumerate(problem.names)
         if name in of_all},
        {(name.split("/")[0], int(name.split("/")[1])): vector[index]
         for index, name in enumerate(problem.names)
         if name.count("/") == 1 and not name.startswith("first ")},
        dict(zip(problem.names, deviations, strict=True)),
        dict(zip(problem.names, whites, strict=True)),
        dict(zip(problem.names, numpy.sqrt(numpy.maximum(
            numpy.diag(by_noise), 0.0)), strict=True)),
        covariance / safe / safe[:, None],
        white / whites / whites[:, None], problem.names, noise,
        [base[:, :len(part.times), number]
         for number, part in enumerate(problem.segments)],
        differences, number, has_converged)

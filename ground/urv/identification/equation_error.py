# SPDX-License-Identifier: Apache-2.0
"""Equation error: least squares of each coefficient (GND-62).

Quick and without a start, but noise of alpha, beta and the rates draws its
derivatives towards zero. Output error starts from them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy
from scipy import linalg, signal

from urv.identification import bounds

WINDOW = 11
ORDER = 3
"""Savitzky and Golay's filter: 0.22 s, for slopes and values alike."""

LEAST_MOVEMENT = {"alpha": 2e-3, "q": 1e-4, "elevator": 2e-3, "speed": 5e-3,
                  "beta": 2e-3, "p": 1e-3, "r": 5e-4, "aileron": 2e-3,
                  "rudder": 2e-3}
"""Deviation of a regressor below which nothing has moved it: 0.1 deg of an
angle."""

MOST_INFLATION = 1e4
"""Growth of the variance by the other regressors: more means that two
regressors are the same signal."""


@dataclass
class Regression:
    """Derivatives by equation error, and what moved."""

    values: dict[str, float]
    deviations: dict[str, float]
    constants: dict[str, list[float]]
    """Constant of each coefficient, for each segment."""
    missing: dict[str, str]
    """Variables that these data say nothing about, each with the reason."""
    inflation: dict[str, float]
    """Growth of the variance of each variable's derivatives by the others."""


def regress(airframe, segments) -> Regression:
    """Derivatives of all coefficients from all segments."""
    lefts = {name: [] for name in airframe.coefficients}
    spins = {name: [] for name in airframe.coefficients}
    tables = {name: [] for name in airframe.coefficients}
    for part in segments:
        left, table, spin = airframe.equations(
            part,
            lambda values: signal.savgol_filter(values, WINDOW, ORDER),
            lambda values, step=part.step: signal.savgol_filter(
                values, WINDOW, ORDER, deriv=1, delta=step))
        for name, values in left.items():
            lefts[name].append(values)
            spins[name].append([spin[name]] if name in spin
                               else numpy.empty((0, len(values))))
            tables[name].append(table[name])
    # The regressors of all coefficients differ in time only.
    centred = numpy.concatenate(
        [table - table.mean(axis=1, keepdims=True)
         for table in tables[airframe.coefficients[0]]], axis=1)
    moved = centred.std(axis=1)
    missing = {
        variable: "nothing moved it"
        for variable, size in zip(airframe.variables, moved, strict=True)
        if size < LEAST_MOVEMENT[variable]}
    inflation = _inflation(airframe.variables, centred, missing)
    for variable, size in sorted(inflation.items(), key=lambda each: -each[1]):
        if size > MOST_INFLATION:
            missing[variable] = "it moves exactly as others do"
            break
    used = [place for place, variable in enumerate(airframe.variables)
            if variable not in missing]
    values, deviations, constants = {}, {}, {}
    for name in airframe.coefficients:
        matrix = numpy.concatenate([
            numpy.concatenate([
                table[used],
                [numpy.full(table.shape[1], float(number == other))
                 for other in range(len(segments))],
                spins[name][number]])
            for number, table in enumerate(tables[name])], axis=1).T
        left = numpy.concatenate(lefts[name])
        answer, *_ = linalg.lstsq(matrix, left)
        residual = left - matrix @ answer
        noise = max(residual.std(), 1e-12)
        cuts = numpy.cumsum([len(each.times) for each in segments])[:-1]
        covariance, *_ = bounds.covariances(
            [each[None] / noise for each in numpy.split(matrix, cuts)],
            [each[None] / noise for each in numpy.split(residual, cuts)])
        for place, index in enumerate(used):
            key = f"{name}_{airframe.variables[index]}"
            values[key] = answer[place]
            deviations[key] = numpy.sqrt(covariance[place, place])
        constants[name] = list(answer[len(used):len(used) + len(segments)])
    return Regression(values, deviations, constants, missing, inflation)


def _inflation(variables, centred, missing):
    """How many times the other regressors enlarge each one's variance."""
    used = [place for place, variable in enumerate(variables)
            if variable not in missing]
    if not used:
        return {}
    unit = centred[used] / numpy.sqrt((centred[used] ** 2).sum(axis=1))[:, None]
    values, vectors = linalg.eigh(unit @ unit.T)
    inverse = (vectors / numpy.maximum(values, 1e-12)) @ vectors.T
    return {variables[place]: inverse[row, row]
            for row, place in enumerate(used)}

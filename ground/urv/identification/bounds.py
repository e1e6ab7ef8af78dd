# SPDX-License-Identifier: Apache-2.0
"""Bounds of estimates whose residuals are coloured (GND-62).

Output error takes residuals for white noise. Those of a flight are not: they
contain what the model lacks, and turbulence. The bounds of white residuals are
then too narrow by a factor of 2 to 10. The covariance here has the measured
autocorrelation of the residuals (V. Klein and E. A. Morelli, Aircraft System
Identification, 2006, section 6.3).
"""

from __future__ import annotations

import numpy
from scipy import linalg, signal

LONGEST_SHARE = 0.25
"""Lags of the autocorrelation: up to this share of a manoeuvre's length, and
weighted by Bartlett's window, so that no variance is below zero."""

UNKNOWN = 1e6
"""The standard deviation of a parameter that changes no output."""


def covariances(slopes, residuals, priors=(), considered=None,
                gradients=(), columns=None, many=None):
    """The covariance for coloured residuals, that for white ones, and the first
    as if considered parameters were known exactly.

    slopes are those of each segment's outputs: outputs, times, parameters;
    residuals are outputs, times; both over the noise's deviation. priors are
    (parameter, mean, standard deviation). considered parameters were not
    estimated; each has the standard deviation with which it is known.
    gradients are of the likelihood, by changes of the outputs that noise of the
    inputs makes: arrays of draws, parameters. What a model integrates is coloured
    over more than any lag, so that the residuals show too little of it.
    columns are the places of each segment's parameters among the many of all;
    without them, each segment has all parameters.
    """
    considered = considered or {}
    many = many or slopes[0].shape[2]
    columns = columns or [numpy.arange(many)] * len(slopes)
    information = numpy.zeros((many, many))
    for each, own in zip(slopes, columns, strict=True):
        flat = each.reshape(-1, len(own))
        information[numpy.ix_(own, own)] += flat.T @ flat
    kernel = _kernel(residuals)
    middle = _middle(slopes, kernel, columns, many)
    # A considered parameter has a column only for its effect on the others.
    effect = {index: information[:, index].copy() for index in considered}
    for index in considered:
        for table in (information, middle):
            table[index] = table[:, index] = 0.0
    for index, _, deviation in priors:
        information[index, index] += deviation ** -2
        middle[index, index] += deviation ** -2
    for index in numpy.flatnonzero(numpy.diag(information) < UNKNOWN ** -2):
        information[index, index] = middle[index, index] = UNKNOWN ** -2
    white = _inverse(information)
    coloured = white @ middle @ white
    # Each estimated parameter uses up one independent residual.
    count = _independent(residuals, kernel)
    free = count / max(count - (many - len(considered)), count / 4.0)
    # Correlation of either sign: never narrower than for white residuals and
    # the noise of the inputs.
    least = numpy.diag(white) + _by_inputs(
        gradients, white, considered) / free
    scale = numpy.sqrt(numpy.maximum(
        least / numpy.maximum(numpy.diag(coloured), 1e-300), 1.0))
    coloured = free * coloured * scale * scale[:, None]
    by_noise = coloured.copy()
    for index, deviation in considered.items():
        effect[index][list(considered)] = 0.0
        moved = white @ effect[index] * deviation
        coloured += numpy.outer(moved, moved)
        coloured[index, index] = deviation ** 2
    return coloured, free * white, by_noise


def _by_inputs(gradients, white, considered):
    """The variance of each parameter by the noise of the inputs."""
    if not len(gradients):
        return 0.0
    gradients = numpy.concatenate(gradients)
    gradients[:, list(considered)] = 0.0
    return ((gradients @ white) ** 2).mean(axis=0)


def autocorrelation(residuals, longest):
    """Autocorrelation of each pair of outputs at lags from -longest to longest:
    outputs, outputs, lags."""
    outputs = len(residuals[0])
    found = numpy.zeros((outputs, outputs, 2 * longest + 1))
    count = sum(each.shape[1] for each in residuals)
    for each in residuals:
        length = each.shape[1]
        for one in range(outputs):
            for other in range(outputs):
                # At lag k: the sum of one(i) other(i + k).
                whole = signal.correlate(each[other], each[one], "full",
                                         "fft")
                reach = min(longest, length - 1)
                found[one, other, longest - reach:longest + reach + 1] += (
                    whole[length - 1 - reach:length + reach])
    return found / count


def _kernel(residuals):
    """The autocorrelation with its window: outputs, outputs, lags."""
    longest = max(1, round(LONGEST_SHARE * numpy.mean(
        [each.shape[1] for each in residuals])))
    window = 1.0 - abs(numpy.arange(-longest, longest + 1)) / (longest + 1)
    return autocorrelation(residuals, longest) * window


def _independent(residuals, kernel):
    """The number of independent residuals that are worth these."""
    middle = kernel.shape[2] // 2
    count = sum(each.shape[1] for each in residuals)
    total = 0.0
    for output in range(len(kernel)):
        own = kernel[output, output]
        if own[middle] > 0:
            total += count / max(own.sum() / own[middle], 1.0)
    return max(total, 1.0)


def _middle(slopes, kernel, columns, many):
    longest = kernel.shape[2] // 2
    middle = numpy.zeros((many, many))
    for table, own in zip(slopes, columns, strict=True):
        length = table.shape[1]
        for one in range(len(table)):
            for other in range(len(table)):
                # Sum over k of kernel(k) table(i + k).
                whole = signal.fftconvolve(
                    table[other], kernel[one, other, ::-1, None], axes=0)
                middle[numpy.ix_(own, own)] += (
                    table[one].T @ whole[longest:longest + length])
    return (middle + middle.T) / 2.0


def _inverse(information):
    """The inverse, by columns of equal size; a direction without information
    gets a very large variance."""
    size = numpy.sqrt(numpy.diag(information))
    values, vectors = linalg.eigh(information / size / size[:, None])
    values = numpy.maximum(values, 1e-12)
    return (vectors / values) @ vectors.T / size / size[:, None]

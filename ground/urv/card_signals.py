# SPDX-License-Identifier: Apache-2.0
"""The signals of test cards, as URV.Test_Inputs computes them (FTI-3, FTI-7)."""

import numpy

from urv import cards

UNIT, SINES, POWER_UNIT, POWERS, SHARE_UNIT = 16_384, 256, 2_048, 64, 256
SHARES = (256, 128, 96, 90, 86, 73, 69, 67, 61, 59, 56, 53)
"""The shares of URV.Signal_Tables; a test compares them."""
FINE = 64


def targets(card):
    """Words by surface and frame before the limit of the rate."""
    signals = {each: _unit(card, each) for each in card.surfaces}
    return {each: _toward_0(values * card.amplitude, UNIT)
            for each, values in signals.items()}


def words_added(card):
    """Words by surface and frame, until the input is back at 0."""
    found = {}
    for surface, wanted in targets(card).items():
        step = card.rate(surface) // cards.FRAMES_PER_S
        value, values = 0, []
        for target in [*wanted.tolist(), *[0] * (
                cards.MOST_AMPLITUDE // step + 1)]:
            value += max(-step, min(step, target - value))
            values.append(value)
        found[surface] = numpy.array(values)
    return found


def _unit(card, surface):
    frames = numpy.arange(card.length)
    if card.kind in cards.PULSES:
        up = {"step": (0,), "doublet": (0,), "3-2-1-1": (0, 1, 2, 5)}
        return numpy.where(
            numpy.isin(frames // card.frames, up[card.kind]), UNIT, -UNIT)
    phases = _phases(card)
    if card.kind != "multisine":
        return sine(phases)
    harmonics = card.harmonics(surface)
    count = len(harmonics)
    total = sum(
        sine((harmonic * phases % CYCLE
              + -(place * (place - 1) * CYCLE // (2 * count)) % CYCLE)
             % CYCLE)
        for place, harmonic in enumerate(harmonics))
    return numpy.clip(_toward_0(total * SHARES[count - 1], SHARE_UNIT),
                      -UNIT, UNIT)


def frequencies(card):
    """By frame, in parts of 0.01 Hz."""
    frames = numpy.arange(card.length)
    if card.kind == "linear sweep":
        return card.first * FINE + _toward_0(
            (card.last - card.first) * FINE * frames, card.length)
    if card.kind == "exponential sweep":
        octaves = card.last * 64 * frames // card.length
        part = octaves % 4_096
        table = numpy.array([round(POWER_UNIT * 2 ** (place / POWERS))
                             for place in range(POWERS + 1)])
        before = table[part // 64]
        factor = before + (table[part // 64 + 1] - before) * (
            part % 64) // 64
        return numpy.minimum(
            card.first * FINE * factor // POWER_UNIT
            << octaves // 4_096, cards.MOST_FREQUENCY * FINE)
    return numpy.full(card.length, card.first * FINE)


def _phases(card):
    moved = frequencies(card)
    return (numpy.cumsum(moved) - moved) % CYCLE


CYCLE = 100 * cards.FRAMES_PER_S * FINE


def sine(phases):
    """As URV.Test_Inputs.Sine."""
    table = numpy.array([
        round(UNIT * numpy.sin(2 * numpy.pi * place / SINES))
        for place in range(SINES + 1)])
    place, rest = numpy.divmod(phases * SINES, CYCLE)
    before = table[place]
    return before + _toward_0((table[place + 1] - before) * rest, CYCLE)


def _toward_0(values, divisor):
    """Ada's division."""
    return numpy.sign(values) * (abs(values) // divisor)

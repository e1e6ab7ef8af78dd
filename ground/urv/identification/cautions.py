# SPDX-License-Identifier: Apache-2.0
"""Cautions: contradictions in a result, in words for people (GND-63).

An interval contains noise and small errors. It contains neither a sensor with
a switched sign nor the mass of another aircraft: these are found here.
"""

from __future__ import annotations

import math

from urv import faults
from urv.identification import aircraft as aircraft_file
from urv.identification import analysis

GOOD_INEQUALITY = 0.3
"""Theil's coefficient of an output, below which a model is good."""

SIGNS = {"CZ_alpha": -1, "Cm_elevator": 1, "CY_beta": -1, "Cl_p": -1,
         "Cl_aileron": 1, "Cn_rudder": 1}
"""Signs that these derivatives have in each aircraft below the stall, since surfaces
are in the pilot's sense."""

SCALES = 0.5, 2.0
"""Least and largest factor that an error of a sensor explains."""
SURE = 3.0
"""A factor is negative if it is below 0 by this many standard deviations."""

OTHER_PRIOR = 0.2
"""A prior value that differs by more, and is outside of the interval, is that
of another aircraft."""
LEAST_PRIORS = 4


def of(result: analysis.Result, aircraft: aircraft_file.Aircraft
       ) -> list[str]:
    """Each caution is a sentence without its end."""
    return [*_of_records(result), *_of_different(result), *_of_axes(result),
            *_of_priors(result, aircraft)]


def _of_records(result):
    for record, known in enumerate(result.compatibility):
        name = faults.quoted(result.records[record])
        if known is None:
            yield f"{name}: no usable manoeuvre"
            continue
        for text in known.contradictions:
            yield (f"{name}: {text}; is a sign, a unit or a column of the"
                   " record wrong?")
        if known.is_rough and not known.contradictions:
            yield (f"{name}: the air is rough: no scale factor and no delay"
                   " is applied, and derivatives may be wrong by more than"
                   " their intervals")
        for each in known.found:
            if each.is_at_bound:
                late = each.name.partition(" ")[2]
                yield (f"{name}: the data want a delay of {late} of more than"
                       f" {abs(each.value):.0f} ms, as no sensor has; is a"
                       " sign, a unit or a column of the record wrong?")
            # In rough air a factor may be near 0, but hardly below.
            if each.name.startswith("scale ") and (
                    each.value + SURE * each.deviation < 0.0
                    or (each.is_applied
                        and not SCALES[0] <= each.value <= SCALES[1])):
                yield (f"{name}: {each.name.partition(' ')[2]} has a factor of"
                       f" {each.value:.2f}; is its sign or unit wrong?")


def _of_different(result):
    for record, path in enumerate(result.records):
        found = {}
        for axis in result.axes.values():
            found |= axis.different.get(record, {})
        if found:
            yield (f"{faults.quoted(path)}: {', '.join(found)} differ from those"
                   f" of the other records by up to {max(found.values()):.0%};"
                   " is it a record of the same aircraft and load?")


def _of_axes(result):
    for axis in result.axes.values():
        for name in axis.outputs:
            fits = [each.inequality[name] for each in axis.flown
                    if name in each.inequality]
            poor = [each for each in fits if each >= GOOD_INEQUALITY]
            if poor:
                yield (f"{axis.axis}: the model does not follow {name} in"
                       f" {len(poor)} of {len(fits)} manoeuvres: fit up to"
                       f" {max(poor):.2f}; below {GOOD_INEQUALITY} is good")
        for each in axis.derivatives.values():
            sign = SIGNS.get(each.name)
            if sign and max(sign * each.low, sign * each.high) < 0.0:
                yield (f"{each.name} is"
                       f" {'negative' if sign > 0 else 'positive'}: is the"
                       " sign of a surface or of a sensor wrong?")


def _of_priors(result, aircraft):
    known = [each for axis in result.axes.values()
             for each in axis.derivatives.values()
             if each.is_determined and each.prior is not None]
    other = [each for each in known
             if not each.low <= each.prior <= each.high
             and abs(each.value - each.prior) > OTHER_PRIOR * max(
                 abs(each.prior), math.ulp(1.0))]
    if len(known) >= LEAST_PRIORS and 2 * len(other) > len(known):
        yield (f"{len(other)} of {len(known)} prior values differ by more than"
               f" {OTHER_PRIOR:.0%} and are outside of their intervals; is the"
               f" aircraft file, {faults.quoted(aircraft.name)}, that of this"
               " aircraft?")

# SPDX-License-Identifier: Apache-2.0
"""Do the records show the same aircraft? (GND-63)

Equation error gives the main derivatives of each record alone, in a tenth of a
second. Their median is that of most records: a record of another aircraft moves
it little, and the joint estimate more.
"""

from __future__ import annotations

import statistics

import numpy

from urv.identification import equation_error

MAIN = {"longitudinal": ("CZ_alpha", "Cm_alpha", "Cm_q", "Cm_elevator"),
        "lateral": ("CY_beta", "Cl_p", "Cl_beta", "Cl_aileron", "Cn_beta",
                    "Cn_r", "Cn_rudder")}

SURE = 3.0
"""Standard deviations from which on two derivatives differ."""
OTHER = 0.2
"""The share by which they then differ at least: errors of the airspeed and of
other sensors change from record to record, and make 6 % in usual flights."""
LEAST = 2
"""Derivatives of an axis that differ in a record of another aircraft."""


def different(airframe, segments) -> dict[int, dict[str, float]]:
    """Records that differ from the others: their derivatives, each with the share
    by which it differs."""
    records = sorted({each.record for each in segments})
    if len(records) < 2:
        return {}
    found = {record: equation_error.regress(
        airframe, [each for each in segments if each.record == record])
        for record in records}
    differ = {record: {} for record in records}
    for name in MAIN[airframe.axis]:
        known = {record: (each.values[name], each.deviations[name])
                 for record, each in found.items() if name in each.values}
        if len(known) < 2:
            continue
        for record, (value, deviation) in known.items():
            # Two records are compared with each other: neither is the odd
            # one.
            others = [each for other, each in known.items()
                      if len(known) > 2 or other != record]
            middle, size = (statistics.median(each) for each in zip(
                *others, strict=True))
            change = abs(value - middle)
            if change > max(SURE * numpy.hypot(deviation, size),
                            OTHER * abs(middle)):
                differ[record][name] = float(
                    change / max(abs(middle), 1e-12))
    return {record: names for record, names in differ.items()
            if len(names) >= LEAST}

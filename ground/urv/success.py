# SPDX-License-Identifier: Apache-2.0
"""The success criteria of a campaign's flight, and the confidence of its rate.

Each limit gives the used share of it: up to 1 is a success.
"""

import math
from typing import NamedTuple

from urv.dispersions import CIRCUITS
from urv.monte_carlo import HISTORIES

# For values that cannot be measured, or events that must not occur.
BEYOND = 10.0


class Limit(NamedTuple):
    """A limit: its name, its text, and the measures with their bounds."""

    name: str
    text: str
    part: str
    measures: tuple
    most: float

    def used(self, summary):
        """The used share of the limit."""
        part = summary.get(self.part, {})
        values = [part.get(measure) for measure in self.measures]
        if any(value is None for value in values):
            return BEYOND
        return min(BEYOND, max(abs(value) for value in values) / self.most)


def must(name, text, part, measure, wanted):
    """A fact that must hold."""
    class Fact(Limit):
        def used(self, summary):
            said = summary.get(part, {}).get(measure)
            return 0.0 if said == wanted else BEYOND
    return Fact(name, text, part, (measure,), 1.0)


HELD = must("holds", "every active hold held in calm", "holds", "not_held",
            0)
FLOWN = (
    must("whole", "did not crash", "flight_quality", "crashed", False),
    Limit("bank", "bank within 60 degrees", "flight_quality",
          ("bank_left_deg", "bank_right_deg"), 60.0),
    Limit("altitude", "altitude within 150 ft in holds", "flight_quality",
          ("altitude_max_ft",), 150.0),
    Limit("airspeed", "airspeed within 15 kt in holds", "flight_quality",
          ("airspeed_max_kt",), 15.0),
    Limit("end", "at the end within 100 ft of the wanted altitude",
          "flight_quality", ("final_altitude_error_ft",), 100.0),
    HELD,
)
LANDED = (
    must("whole", "did not crash", "circuit", "crashed", False),
    Limit("sink", "touched down below 3 ft/s", "circuit",
          ("touchdown_sink_ft_s",), 3.0),
    Limit("centre", "touched down within 25 ft of the centre line",
          "circuit", ("touchdown_offset_ft",), 25.0),
    must("stop", "stopped on the runway", "circuit", "stopped_on_runway",
         True),
    HELD,
)


def limits(pilot):
    if pilot == HISTORIES:
        return (HELD,)
    return LANDED if pilot in CIRCUITS else FLOWN


def clopper_pearson(successes, trials, confidence=0.95):
    """The exact bounds of a rate."""
    tail = (1.0 - confidence) / 2.0
    least = 0.0 if successes == 0 else between(
        lambda rate: at_least(successes, trials, rate) < tail)
    most = 1.0 if successes == trials else between(
        lambda rate: at_least(successes + 1, trials, rate) < 1.0 - tail)
    return least, most


def between(is_below):
    """The place between 0 and 1 at which the condition ceases to hold."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2.0
        if is_below(middle):
            low = middle
        else:
            high = middle
    return (low + high) / 2.0


def at_least(successes, trials, rate):
    """The probability of at least this number of successes."""
    if rate <= 0.0 or rate >= 1.0:
        return float(rate >= 1.0 or successes <= 0)
    yes, no = math.log(rate), math.log1p(-rate)
    whole = math.lgamma(trials + 1)
    return min(1.0, math.fsum(
        math.exp(whole - math.lgamma(count + 1)
                 - math.lgamma(trials - count + 1)
                 + count * yes + (trials - count) * no)
        for count in range(successes, trials + 1)))

# SPDX-License-Identifier: Apache-2.0
"""The age of a page's message at its arrival (GND-51, D-36).

    arrivals = Arrivals()
    arrivals.is_new(sequence)           False: repeated, or out of order
    arrivals.age(sent_s, now)           seconds

The age is that of urv.ages: its clock is the page's.

When the page's clock steps back, every message looks old. A round trip reveals
this: the page answers a state, so its answer cannot be older than the state.
An old answer to a young state means that the clock has stepped.
"""

from __future__ import annotations

from collections import OrderedDict

from urv.ages import SenderClock
from urv.sticks import OLD_S

ROUND_TRIP_S = 0.3
"""A state answered within this time reveals the page's clock."""

STATES = 64
"""The number of unanswered states that are remembered."""


class Arrivals:
    """The messages of one page's session. Times are seconds: sent_s by the
    page's clock, now by the station's, which only rises."""

    def __init__(self) -> None:
        self._sequence = 0
        self._clock = SenderClock()
        self._states: OrderedDict[int, float] = OrderedDict()

    def is_new(self, sequence: int) -> bool:
        """True if the number is above all earlier ones."""
        if sequence <= self._sequence:
            return False
        self._sequence = sequence
        return True

    def age(self, sent_s: float, now: float) -> float:
        """The age of a message that arrives now, in seconds."""
        return self._clock.age(sent_s, now)

    def sends(self, number: int, now: float) -> None:
        """A state of this number is sent to the page."""
        self._states[number] = now
        if len(self._states) > STATES:
            self._states.popitem(last=False)

    def answer(self, number: int, sent_s: float, now: float) -> float | None:
        """The page answers the state of this number. Returns the seconds by
        which the page's clock has stepped back, if it has; from then on its
        messages count again."""
        age = self.age(sent_s, now)
        asked = self._states.get(number)
        if age <= OLD_S or asked is None or now - asked > ROUND_TRIP_S:
            return None
        # The answer was sent after the state: no age is underestimated.
        self._clock.step(asked - sent_s, now)
        return age

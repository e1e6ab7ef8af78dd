# SPDX-License-Identifier: Apache-2.0
"""How old a page's message is when it arrives (GND-51, D-36).

    arrivals = Arrivals()
    arrivals.is_new(sequence)           False: repeated, or out of order
    arrivals.age(sent_s, now)           seconds

The page's clock and the station's have an unknown offset. The least receive
time minus send time of the session is the best estimate of it: a message
cannot arrive before it was sent. The excess over it is the message's age,
whatever delayed it: the network, a queue, a browser or a station that hung.

When the page's clock steps back, every message looks old. A round trip tells
the two apart: the page answers a state, so that its answer cannot be older
than the state. An old answer to a young state is a clock that has stepped.
"""

from __future__ import annotations

from collections import OrderedDict

from urv.sticks import OLD_S

DRIFT = 500e-6
"""The best offset may be wrong by this much more each second: two clocks
whose rates are adjusted differ by this much at most."""

ROUND_TRIP_S = 0.3
"""A state that was answered within this time shows what the clock is."""

STATES = 64
"""As many states are remembered until the page has answered them."""


class Arrivals:
    """The messages of one page's session. Times are seconds: sent_s by the
    page's clock, now by the station's, which only rises."""

    def __init__(self) -> None:
        self._sequence = 0
        self._offset: float | None = None
        self._at = 0.0
        self._states: OrderedDict[int, float] = OrderedDict()

    def is_new(self, sequence: int) -> bool:
        """Whether the number is above all those before."""
        if sequence <= self._sequence:
            return False
        self._sequence = sequence
        return True

    def age(self, sent_s: float, now: float) -> float:
        """Of a message that arrives now, in seconds."""
        offset = now - sent_s
        if self._offset is not None:
            self._offset += DRIFT * (now - self._at)
        self._at = now
        if self._offset is None or offset < self._offset:
            self._offset = offset
        return offset - self._offset

    def sends(self, number: int, now: float) -> None:
        """A state of this number goes to the page."""
        self._states[number] = now
        if len(self._states) > STATES:
            self._states.popitem(last=False)

    def answer(self, number: int, sent_s: float, now: float) -> float | None:
        """The page answers the state of this number. Returns the seconds by
        which its clock has stepped back, when it has; from then on its
        messages count again."""
        age = self.age(sent_s, now)
        asked = self._states.get(number)
        if age <= OLD_S or asked is None or now - asked > ROUND_TRIP_S:
            return None
        # The answer was sent after the state was: no age is told too small.
        self._offset = asked - sent_s
        return age

# SPDX-License-Identifier: Apache-2.0
"""The age of a message, by the time at which its sender made it (GND-56,
D-58).

    clock = SenderClock()
    clock.age(sent_s, now)      seconds

The sender's clock and this one have an unknown offset. The least receive time
minus send time so far is the best estimate of it: a message cannot arrive
before it was sent. The excess over it is the message's age, whatever delayed
the message: the network, a queue, or a stopped receiver.

Pages (urv.arrivals), the station and MAVLink (urv.runs) use it, and through
the station Yamcs (urv.archive) and the report (urv.view).
"""

from __future__ import annotations

DRIFT = 500e-6
"""Seconds per second by which the best offset may become wrong: the largest
difference in rate between two adjusted clocks."""


class SenderClock:
    """The clock of one sender. Times are seconds: sent_s by the sender's
    clock, now by the receiver's, which only rises."""

    def __init__(self) -> None:
        self.offset: float | None = None
        """Now minus sent_s of the fastest message. None before the first
        one."""
        self._at = 0.0

    def lead(self, sent_s: float, now: float) -> float:
        """Seconds by which a message that arrives now is earlier than the best
        one before; negative when it is later."""
        if self.offset is None:
            return 0.0
        return self._drifted(now) - (now - sent_s)

    def age(self, sent_s: float, now: float) -> float:
        """The age of a message that arrives now, in seconds."""
        offset = now - sent_s
        self.offset = (offset if self.offset is None
                       else min(offset, self._drifted(now)))
        self._at = now
        return offset - self.offset

    def step(self, offset: float, now: float) -> None:
        """The sender's clock was set."""
        self.offset, self._at = offset, now

    def _drifted(self, now: float) -> float:
        return self.offset + DRIFT * (now - self._at)

# SPDX-License-Identifier: Apache-2.0
"""True if the ground's node takes this station's console packets (GND-58).

    answers.sent(sequence, now)      a console packet has left
    answers.look(frame, now)         a frame has come
    answers.flies                    the flying party in that frame
    answers.is_refused(now)          packets leave, and none is taken

The node takes the packets of one console and drops those of another. It
publishes the sequence number of the packet that it flies. Each station begins
at a random number (D-59), so the number says whose packet it is.
"""

from __future__ import annotations

import secrets
from collections import deque
from dataclasses import dataclass, field

from urv.packets import ConsoleState, FramePacket, Pilot

REMEMBERED = 500
"""Console packets: ten seconds of them."""
UNANSWERED_S = 0.6
"""Packets that leave for this time, while the node flies no later one, are
refused. A console that replaces another waits for 0.5 s."""
PAUSE_S = 0.2
"""After this time without a packet the next one is a first one."""

US, OTHER, PILOT, NOBODY = "us", "other", "pilot", "nobody"

_STARTS = 1 << 31


def first_sequence() -> int:
    """The number before that of the first console packet. There is room for a
    year of packets above it."""
    return secrets.randbelow(_STARTS)


@dataclass
class Answers:
    """The node's answers to the sent packets. Times are seconds of a clock
    that only rises."""

    flies: str = NOBODY
    """The flying party in the newest frame: this station, another console, the
    simulated pilot, or nobody."""
    stick_ms: float | None = None
    """The time from a packet's leaving to the frame that shows it."""
    new_drops: int = 0
    """Datagrams that the node has dropped at its console port between the last
    two frames."""
    _dropped: int | None = None
    _sent: deque[tuple[int, float]] = field(
        default_factory=lambda: deque(maxlen=REMEMBERED))
    _sent_at: float = float("-inf")
    _flown: int = 0
    _waits_since: float = 0.0
    _refused: bool = False

    def begin(self) -> None:
        """The node runs again: its counts begin at 0."""
        self._dropped = None

    def sent(self, sequence: int, now: float) -> None:
        """A console packet leaves."""
        if now - self._sent_at > PAUSE_S:
            self._waits_since = now
            self._refused = False
        self._sent_at = now
        self._sent.append((sequence, now))

    def look(self, frame: FramePacket, made: float, now: float) -> None:
        """A frame made at that time has arrived now."""
        dropped = frame.link["console_bad"]
        self.new_drops = max(0, dropped - (
            dropped if self._dropped is None else self._dropped))
        self._dropped = dropped
        at = dict(self._sent).get(frame.console_sequence)
        if frame.pilot == Pilot.FLIES:
            self.flies = PILOT
        elif frame.console_state != ConsoleState.LIVE:
            self.flies = NOBODY
        else:
            self.flies = OTHER if at is None else US
        if self.flies != US:
            self.stick_ms = None
        elif frame.console_sequence > self._flown:
            self._flown = frame.console_sequence
            self._waits_since = max(self._waits_since, made)
            self.stick_ms = round((now - at) * 1000, 1)
        self._refused = made - self._waits_since >= UNANSWERED_S

    def is_refused(self, now: float) -> bool:
        """Packets leave, and the node flies none of them."""
        return self._refused and now - self._sent_at <= PAUSE_S

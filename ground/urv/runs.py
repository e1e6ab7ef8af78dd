# SPDX-License-Identifier: Apache-2.0
"""Selection, order and age of frame packets (GND-46, GND-56, GND-57, D-37,
D-58, D-60).

    runs = Runs()
    runs.take(frame, now, sender)   True: the newest packet of the flight
    runs.age                        seconds, of the packet taken last

The packets of one sender and one run of its program are a source. Within a
source the sequence number is the order, and the clock: the node counts frames
of 20 ms, even while it is stopped, and that clock cannot be set.

A packet that does not follow the present packets is dropped while those arrive:
one of another source, one whose number is ahead of time, one whose UTC is far
from the UTC before. Two of its kind, one after the other, replace packets that
have stopped. A single datagram therefore never changes the display.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

from urv import packets
from urv.ages import SenderClock

AHEAD_S = 0.1
"""A packet may arrive earlier than the best one before by this much."""
SET_S = 1.0
"""The difference of UTC and sequence number may change by this much."""
ALIVE_S = 0.1
"""Packets that arrived within this time cannot be replaced."""
SILENT_S = 0.5
"""The same, for replacement by a former source or by lower numbers."""
FORMER_SOURCES = 64
"""The number of former sources that are remembered."""
STRAYS = 25
"""Packets of a former source between packets of the present one, after which
both are assumed to send. Fewer may have been delayed."""
RIVAL_S = 5.0
"""Another source is reported for this time after its last packet."""

Sender = tuple[str, int]
Source = tuple[Sender | None, int]


@dataclass
class _Series:
    """Consecutive packets of one source."""

    source: Source
    sequence: int
    zero_s: float
    """UTC of the source's frame 0, by the last packet."""
    came: float
    clock: SenderClock
    count: int = 1

    def is_followed_by(self, source: Source, sequence: int, zero_s: float,
                       now: float) -> bool:
        """True if a packet that arrives now can be a later one of these."""
        return (source == self.source and sequence > self.sequence
                and abs(zero_s - self.zero_s) <= SET_S
                and self.clock.lead(sequence * packets.FRAME_S, now)
                <= AHEAD_S)

    def take(self, sequence: int, zero_s: float, now: float) -> float:
        """Adds the next one. Returns its age."""
        self.sequence, self.zero_s, self.came = sequence, zero_s, now
        self.count += 1
        return self.clock.age(sequence * packets.FRAME_S, now)


@dataclass
class Runs:
    """Judges each packet."""

    age: float = 0.0
    """Seconds between the creation and the arrival of the packet taken
    last."""
    began: bool = False
    """True if it is the first one of its source."""
    missing: int = 0
    """The missing packets between it and the one before."""
    set_by: float = 0.0
    """Seconds by which the source's UTC was set between the two."""
    rival: Sender | None = None
    """The sender besides the present source, when known."""
    _now: _Series | None = None
    _next: _Series | None = None
    _stranger: Source | None = None
    _strays: int = 0
    _rival_at: float = float("-inf")
    _former: deque[Source] = field(
        default_factory=lambda: deque(maxlen=FORMER_SOURCES))

    def take(self, frame: packets.FramePacket, now: float,
             sender: Sender | None = None) -> bool:
        """True if the packet is newer than all earlier ones."""
        source = sender, frame.run
        sequence = frame.sequence
        zero_s = frame.time_us / 1e6 - sequence * packets.FRAME_S
        present = self._now
        if present is None:
            self._begin(source, sequence, zero_s, now)
        elif present.is_followed_by(source, sequence, zero_s, now):
            self.began, self.set_by = False, 0.0
            self.missing = sequence - present.sequence - 1
            self.age = present.take(sequence, zero_s, now)
            self._next = None
            self._see_rival(now)
        else:
            if source != present.source:
                self._stranger = source
            if not self._replaces(source, sequence, zero_s, now):
                return False
        return True

    def has_rival(self, now: float) -> bool:
        """True if another source sends to this port, too."""
        return now - self._rival_at <= RIVAL_S

    @property
    def zero_s(self) -> float:
        """UTC of the present source's frame 0, by its own clock."""
        return 0.0 if self._now is None else self._now.zero_s

    @property
    def offset(self) -> float:
        """The time of frame 0 of the present source, by this clock."""
        clock = None if self._now is None else self._now.clock
        return 0.0 if clock is None or clock.offset is None else clock.offset

    def _begin(self, source: Source, sequence: int, zero_s: float,
               now: float) -> None:
        present = self._now
        is_same = present is not None and present.source == source
        self.began = not is_same
        self.missing, self.set_by = 0, 0.0
        if is_same:
            clock = present.clock
            self.missing = max(0, sequence - present.sequence - 1)
            moved = zero_s - present.zero_s
            self.set_by = moved if abs(moved) > SET_S else 0.0
        else:
            clock = SenderClock()
            if source in self._former:
                self._former.remove(source)
            if present is not None:
                self._former.append(present.source)
            self._stranger, self._strays = None, 0
            self._rival_at = float("-inf")
        self.age = clock.age(sequence * packets.FRAME_S, now)
        self._now = _Series(source, sequence, zero_s, now, clock)
        self._next = None

    def _replaces(self, source: Source, sequence: int, zero_s: float,
                  now: float) -> bool:
        """True if this packet and the one before, which do not follow the
        present ones, replace them."""
        present, coming = self._now, self._next
        if coming is not None and coming.is_followed_by(
                source, sequence, zero_s, now):
            coming.take(sequence, zero_s, now)
        else:
            clock = SenderClock()
            clock.age(sequence * packets.FRAME_S, now)
            coming = self._next = _Series(source, sequence, zero_s, now,
                                          clock)
        is_back = (source == present.source
                   and sequence <= present.sequence)
        longest = (SILENT_S if is_back or source in self._former
                   else ALIVE_S)
        is_sure = coming.count > 1 and now - present.came >= longest
        # A single packet is no evidence yet.
        if not is_sure and (is_back or present.count > 1):
            return False
        self._begin(source, sequence, zero_s, now)
        self._now.count = coming.count
        return True

    def _see_rival(self, now: float) -> None:
        """Detects a packet of the present source after one of another."""
        if self._stranger is None:
            return
        sender, _ = self._stranger
        self._strays += 1
        if self._stranger not in self._former or self._strays >= STRAYS:
            self._rival_at, self.rival = now, sender
        self._stranger = None

# SPDX-License-Identifier: Apache-2.0
"""Detection of every start of a node from the frame packets (GND-45).

    Starts().look(frame)     the starts since the last frame

The ground's cold start is a new run. For other starts each node's error log
has a row with a count and with frame numbers. A count alone hides a restart:
it may be at its last value, or a cold start may have cleared it and another
restart restored it. Frame numbers are therefore compared, too: within one life
of a node a row's first frame never changes, and its last frame and count never
decrease.

With the control laws on the aircraft also reports its age, in frames since its
cold start. Between two rows it grows like the ground's frames. This reveals a
cold start that leaves no trace in the log.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

from urv import items, laws, packets

COLD = "cold_start"
RESTARTS = ("warm_reset", "processor_restart")
KINDS = (COLD, *RESTARTS)

FLYING_KT, FLYING_FT = 42.0, 50.0
"""Below both values the aircraft is on the ground, as for its control laws
(URV.Law_Gains)."""

MOST_APART = 6
"""The error of an age in its units, 2 s: a row arrives within 0.3 s, and is
sent again when a part of it was lost."""
AGES = 1 << laws.WORD_BITS

ROUND = 600
"""The number of fresh downlinks in which every row of the aircraft's log
arrives: its 36 kinds, 0.3 s each."""


@dataclass(frozen=True)
class Start:
    """A node has started, this number of times since the last look."""

    node: str
    kind: str
    count: int = 1
    frame: int | None = None
    """The node's frame at the last start; None when unknown."""


@dataclass
class Log:
    """The error log of a node, and the lives in which it was written."""

    node: str
    _seen: tuple[packets.LogRow, ...] = ()
    _rows: dict[str, packets.LogRow] = field(default_factory=dict)
    _unsure: set[str] = field(default_factory=set)
    """Kinds whose row may be from the previous life: a new row of them is no
    evidence of a start."""

    def look(self, rows: tuple[packets.LogRow, ...],
             oldest: int = 0) -> list[Start]:
        """The starts that new rows reveal. Errors before the node's frame
        `oldest` have been seen, or belong to an earlier life."""
        if rows == self._seen:
            return []
        first = not self._seen
        self._seen = rows
        found: list[Start] = []
        for kind, row in zip(packets.KINDS, rows):  # noqa: B905 - rows to spare
            old = self._rows.get(kind)
            if row.count == 0 or row == old:
                continue
            if not first:
                found += self._compare(kind, row, old, oldest)
            self._rows[kind] = row
        return found

    def begin_again(self) -> Start:
        """A cold start that no row has shown yet."""
        self._unsure = set(packets.KINDS)
        return Start(self.node, COLD)

    def _compare(self, kind: str, row: packets.LogRow,
                 old: packets.LogRow | None, oldest: int) -> list[Start]:
        found = []
        differs = (row.last_frame < oldest if old is None
                   else is_of_another_life(old, row))
        if differs and kind not in self._unsure:
            found.append(Start(self.node, COLD))
            self._unsure = set(self._rows) - {kind}
        self._unsure.discard(kind)
        if kind in RESTARTS:
            before = 0 if old is None or differs else old.count
            found.append(Start(self.node, kind,
                               max(row.count - before, 1), row.last_frame))
        return found


def is_of_another_life(old: packets.LogRow, row: packets.LogRow) -> bool:
    """True if a cold start has cleared the log between the two."""
    return (row.count < old.count or row.last_frame < old.last_frame
            or row.first_frame != old.first_frame)


@dataclass
class Age:
    """The age that the aircraft's node reports."""

    _age: int | None = None
    _sequence: int = 0
    _is_known: bool = False

    def look(self, frame: packets.FramePacket, is_known: bool) -> bool:
        """True if the age is less than the earlier one and the frames since. A
        known cold start is found once."""
        self._is_known |= is_known
        told = laws.Laws.of(frame)
        if told is None or not frame.is_fresh or told.age == self._age:
            return False
        is_first, is_known = self._age is None, self._is_known
        elapsed = (frame.sequence - self._sequence) // laws.AGE_FRAMES
        apart = (told.age - (self._age or 0) - elapsed + AGES // 2) % AGES
        self._age, self._sequence = told.age, frame.sequence
        self._is_known = False
        return (not is_first and not is_known
                and abs(apart - AGES // 2) > MOST_APART)


@dataclass
class Starts:
    """Finds the starts of both nodes."""

    _run: int | None = None
    _gsc: Log = field(default_factory=lambda: Log("gsc"))
    _mcs: Log = field(default_factory=lambda: Log("mcs"))
    _newest: tuple[int, int] | None = None
    """A frame of the aircraft's, and the ground's frame of its arrival."""
    _floors: deque[int] = field(default_factory=lambda: deque(maxlen=ROUND))
    _age: Age = field(default_factory=Age)

    def look(self, frame: packets.FramePacket) -> list[Start]:
        """The starts that this frame reveals, the ground's first."""
        found = []
        if self._run != frame.run:
            if self._run is not None:
                found.append(Start("gsc", COLD))
            self._run = frame.run
            self._gsc = Log("gsc")
            self._newest = None
            self._floors.clear()
            self._age = Age()
        gsc, mcs = frame.logs
        found += self._gsc.look(gsc)
        oldest = (self._floors[0] if len(self._floors) == ROUND else 0)
        of_aircraft = self._mcs.look(mcs, oldest)
        is_cold = any(start.kind == COLD for start in of_aircraft)
        if self._age.look(frame, is_cold):
            of_aircraft = [self._mcs.begin_again(), *of_aircraft]
            is_cold = True
        if is_cold:
            self._newest = None
            self._floors.clear()
        self._follow(frame, mcs)
        return found + of_aircraft

    def _follow(self, frame: packets.FramePacket,
                rows: tuple[packets.LogRow, ...]) -> None:
        """The aircraft's frame is at least the highest that it has reported,
        and the frames since."""
        if not frame.is_fresh:
            return
        told = max((row.last_frame for row in rows[:len(packets.KINDS)]
                    if row.count), default=None)
        if told is None:
            return
        if self._newest is None:
            self._newest = told, frame.sequence
        at, since = self._newest
        floor = max(told, at + frame.sequence - since)
        self._newest = floor, frame.sequence
        self._floors.append(floor)


@dataclass
class Flying:
    """True if the aircraft flies, from its fresh and valid words. An unknown
    value leaves the state unchanged."""

    now: bool = False

    def look(self, frame: packets.FramePacket) -> bool:
        told = laws.Laws.of(frame)
        not_valid = told.not_valid if told else ()
        if frame.is_fresh and not {"airspeed", "altitude"} & set(not_valid):
            value = {
                name: items.COLUMNS[f"gsc.downlink.{name}"].value(
                    frame.columns[f"gsc.downlink.{name}"])
                for name in ("airspeed", "altitude")}
            self.now = (value["airspeed"] >= FLYING_KT
                        or value["altitude"] >= FLYING_FT)
        return self.now

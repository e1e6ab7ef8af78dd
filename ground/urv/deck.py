# SPDX-License-Identifier: Apache-2.0
"""The test cards aboard, as the aircraft reports them, and those that a console
sends (FTI-2, FTI-8).

A row of the aircraft's log has the state, and part after part the words of all
cards (URV.Card_Status). Times are seconds of any clock that only rises; nothing
here waits.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field
from typing import Any

from urv import cards, faults, packets

VERDICTS = ("none", "complete", "switched off", "disconnected", "link lost",
            "stick moved", "sensor not valid", "envelope left",
            "surface failed", "warm start", "slot empty", "not followed",
            "inputs remain")
"""The reason of the last end, in the order of URV.Test_Runs.Verdict."""
EXPECTED = ("none", "complete", "switched off")
"""Ends that nobody needs to look at."""

REFUSED = {
    1: "it came damaged", 2: "a value is none that may be set",
    3: "a card runs, or switch 5 is on", 4: "its control laws are off",
    5: "its slot is empty"}
"""The reason, by the detail of the error."""
REFUSAL = packets.KINDS.index("card_refused")

PARTS = 3
WORDS = 11
BETWEEN_S = 0.2
"""Between two blocks; the node sends one in 0.1 s."""
PATIENCE_S = 90.0
"""The report of all cards takes up to about a minute."""

NIBBLE, WORD = 4, 16


@dataclass(frozen=True)
class Status:
    """The state word of the row."""

    chosen: int = 0
    running: int = 0
    last: int = 0
    ended: str = "none"
    frame: int = 0

    @classmethod
    def of(cls, row: packets.LogRow) -> Status:
        state, frame = divmod(row.count, 1 << WORD)
        chosen, running, last, ended = (
            state >> NIBBLE * place & 15 for place in range(4))
        return cls(chosen, running, last,
                   VERDICTS[ended] if ended < len(VERDICTS)
                   else f"number {ended}", frame)


@dataclass
class Deck:
    """The newest status, the cards read back, and the newest order."""

    status: Status = field(default_factory=Status)
    state: str = "none"
    text: str = ""
    said: list[tuple[str, str]] = field(default_factory=list)
    _parts: dict[int, tuple[int, ...]] = field(default_factory=dict)
    _names: dict[int, cards.Card] = field(default_factory=dict)
    _wanted: dict[int, cards.Card] = field(default_factory=dict)
    _waiting: deque[cards.Card] = field(default_factory=deque)
    _next: float = 0.0
    _until: float = 0.0
    _refused: int = 0

    def order(self, console: int, text: str,
              frame: packets.FramePacket | None, is_holder: bool,
              now: float) -> None:
        """Begins to send the cards of a file's text."""
        try:
            if not is_holder:
                raise faults.Refused(f"console {console} does not hold the"
                                     " sticks")
            if frame is None:
                raise faults.Refused("nothing comes from the ground's node")
            if self._waiting:
                raise faults.Refused("others are still on their way")
            wanted = cards.of_text(text, "cards")
        except faults.Refused as fault:
            # An order under way continues.
            self.said.append(("caution", f"refused here: {fault}"))
            if self.state != "waiting":
                self.state, self.text = "refused", f"refused here: {fault}"
            return
        self._wanted = {each.slot: each for each in wanted}
        self._names.update(self._wanted)
        self._waiting.extend(wanted)
        self._waiting.append(cards.Card(slot=wanted[0].slot, kind="choose"))
        self._next, self._until = now, now + PATIENCE_S
        self._refused = _row(frame, REFUSAL).count
        self._is("waiting", "info", f"{len(wanted)} on their way, to slot"
                 f" {', '.join(str(each.slot) for each in wanted)}")

    def due(self, now: float) -> cards.Card | None:
        """The card to send now."""
        if not self._waiting or now < self._next:
            return None
        self._next = now + BETWEEN_S
        return self._waiting.popleft()

    def begin(self) -> None:
        """Another run of the ground's node: nothing is known."""
        self.status = Status()
        self._parts.clear()

    def look(self, frame: packets.FramePacket | None, now: float) -> None:
        """Takes the aircraft's report."""
        if frame is None or frame.version < packets.WHOLE:
            return
        row = _row(frame, packets.CARDS_ROW - 1)
        if row != packets.LogRow():
            self._take(row)
        if self.state != "waiting":
            return
        refusal = _row(frame, REFUSAL)
        if refusal.count > self._refused:
            why = REFUSED.get(refusal.detail, f"reason {refusal.detail}")
            self._waiting.clear()
            self._is("refused", "caution", f"refused by the aircraft: {why}")
        elif not self._waiting and all(
                self.card(slot) == wanted
                for slot, wanted in self._wanted.items()):
            self._is("taken", "info", "read back word for word")
        elif now >= self._until:
            self._is("lost", "caution",
                     "not read back: some may be lost, send them again")

    def _take(self, row: packets.LogRow) -> None:
        status, before = Status.of(row), self.status
        self.status = status
        place, first = divmod(row.first_frame, 1 << WORD)
        self._parts[place] = (first, *divmod(row.last_frame, 1 << WORD),
                              row.detail)
        if status.running and (status.running != before.running
                               or status.frame < before.frame):
            self.said.append(("info", f"{status.running} runs"))
        if not status.running and status.last and (
                before.running or (status.last, status.ended)
                != (before.last, before.ended)):
            level = "info" if status.ended in EXPECTED else "caution"
            self.said.append((level, f"{status.last} ended:"
                              f" {status.ended}"))

    def card(self, slot: int) -> cards.Card | None:
        """The card in a slot, as far as it is known."""
        words = [word for part in range(PARTS)
                 for word in self._parts.get(slot * 16 + part, ())]
        return cards.Card.of_words(words[:WORDS]) if len(
            words) >= WORDS else None

    def shown(self) -> dict[str, Any]:
        """For pages."""
        slots = []
        for slot in cards.SLOTS:
            card = self.card(slot)
            if card is None:
                continue
            name = self._names.get(slot)
            slots.append({
                "slot": slot, "kind": card.kind, "seconds": card.seconds,
                "name": name.name if name == card else "",
                "moves": moved(card), "envelope": card.envelope()})
        status = self.status
        return {"chosen": status.chosen, "running": status.running,
                "last": status.last, "ended": status.ended,
                "expected": status.ended in EXPECTED,
                "at_s": round(status.frame / cards.FRAMES_PER_S, 1),
                "slots": slots, "state": self.state, "text": self.text}

    def _is(self, state: str, level: str, text: str) -> None:
        self.state, self.text = state, text
        self.said.append((level, text))


def moved(card: cards.Card) -> str:
    """The axes or single surfaces, sticks or commands that a card moves."""
    if card.place != "servo":
        return ", ".join(f"{each} {card.place}" for each in card.surfaces)
    names, surfaces = [], set(card.surfaces)
    for axis, pair in cards.AXES.items():
        if surfaces.issuperset(pair) and not card.is_single:
            names.append(axis)
            surfaces.difference_update(pair)
    return ", ".join([*names, *(each.replace("_", " ")
                                for each in cards.SURFACES
                                if each in surfaces)])


def _row(frame: packets.FramePacket, place: int) -> packets.LogRow:
    return frame.logs[packets.NODES.index("mcs")][place]

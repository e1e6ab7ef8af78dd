# SPDX-License-Identifier: Apache-2.0
"""The holder of the sticks: one console at a time, or the simulated pilot
(GND-21, GND-22).

Times are seconds of any clock that only rises; nothing here waits.
"""

from __future__ import annotations

from dataclasses import dataclass, field

ASKED_S = 5.0
"""The time in which a holder must answer a request for the sticks."""

SILENT_S = 0.2
"""A holder that is silent for this time is not live."""

LAPSED_S = 2.0
"""A holder that has been silent for this time is not asked any more."""

OLD_S = 0.5
"""Older words of the page are not flown (GND-51)."""


@dataclass
class Sticks:
    """The rules of taking and giving the sticks.

    said collects the events, for the log.
    """

    holder: int | None = None
    asker: int | None = None
    words: tuple[int, ...] | None = None
    said: list[str] = field(default_factory=list)
    _asked_at: float = 0.0
    _moved_at: float = float("-inf")
    _sent_at: float = float("-inf")

    def take(self, console: int, now: float) -> None:
        """A console requests the sticks: it gets them at once, or the holder
        is asked."""
        if self.holder == console:
            return
        if self.holder is None or now - self._moved_at > LAPSED_S:
            self._give(console, now)
        elif self.asker is None:
            self.asker = console
            self._asked_at = now
            self.said.append(
                f"console {console} asks console {self.holder} for the"
                " sticks")

    def answer(self, console: int, yes: bool, now: float) -> None:
        """The holder gives the sticks to the asking console, or keeps them."""
        if console != self.holder or self.asker is None:
            return
        if yes:
            self._give(self.asker, now)
        else:
            self.said.append(f"console {console} keeps the sticks")
            self.asker = None

    def release(self, console: int, why: str) -> None:
        """The holder releases the sticks, without asking."""
        if console == self.asker:
            self.asker = None
        if console == self.holder:
            self.said.append(f"console {console} let go: {why}")
            self.holder = None
            self.words = None

    def move(self, console: int, words: tuple[int, ...], now: float,
             age: float = 0.0) -> bool:
        """True if these sticks count: only the holder's do. The page sent them
        age seconds ago."""
        if console != self.holder:
            return False
        self.words = words
        self._moved_at = now
        self._sent_at = now - age
        return True

    def pause(self, console: int) -> None:
        """The holder's sticks are unreliable: none until it moves them
        again."""
        if console == self.holder:
            self.words = None

    def live(self, now: float) -> tuple[int, ...] | None:
        """The words to send now; None when the holder is not live."""
        if now - self._moved_at < SILENT_S and now - self._sent_at < OLD_S:
            return self.words
        return None

    def silence(self, now: float) -> float:
        """Seconds since the holder moved or took the sticks."""
        return now - self._moved_at

    def tick(self, now: float) -> None:
        """A holder that has not answered in time gives the sticks."""
        if self.asker is not None and (
                self.holder is None or now - self._asked_at >= ASKED_S):
            self._give(self.asker, now)

    def left(self, now: float) -> float:
        """Seconds that the holder still has for an answer."""
        if self.asker is None:
            return 0.0
        return max(0.0, ASKED_S - (now - self._asked_at))

    def _give(self, console: int, now: float) -> None:
        self.said.append(
            f"console {console} has the sticks" if self.holder is None else
            f"console {console} has the sticks, console {self.holder} had"
            " them")
        self.holder = console
        self.asker = None
        self.words = None
        # It has not moved them yet, but is no lapsed holder either.
        self._moved_at = now

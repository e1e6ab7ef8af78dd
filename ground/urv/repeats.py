# SPDX-License-Identifier: Apache-2.0
"""Errors that repeat are reported less and less often (GND-45).

    repeats.take(("gsc", "no_input"), 50, now)     how many are new, or None

The first one of a kind is reported at once. While it goes on, the next report
comes after 1 s, then after 2 s, 4 s and so on. A kind that has been quiet for
twice as long begins again. So each kind is reported once a second at most, and
none hides another.
"""

from __future__ import annotations

from dataclasses import dataclass, field

SHORTEST_S = 1.0
LONGEST_S = 32.0


@dataclass
class _Kind:
    count: int
    at: float
    wait: float = SHORTEST_S


@dataclass
class Repeats:
    """What has been reported of each kind."""

    _kinds: dict[tuple[str, ...], _Kind] = field(default_factory=dict)

    def take(self, key: tuple[str, ...], count: int,
             now: float) -> int | None:
        """How many have come since the last report, when one is due. A count
        that is lower than before began again."""
        kind = self._kinds.get(key)
        if kind is None:
            self._kinds[key] = _Kind(count, now)
            return count
        if count == kind.count or now - kind.at < kind.wait:
            return None
        new = count - kind.count if count > kind.count else count
        quiet = now - kind.at >= 2 * kind.wait
        self._kinds[key] = _Kind(
            count, now,
            SHORTEST_S if quiet else min(2 * kind.wait, LONGEST_S))
        return new

    def pass_over(self, key: tuple[str, ...], count: int) -> None:
        """What has come up to this count is no news."""
        kind = self._kinds.get(key)
        self._kinds[key] = (
            _Kind(count, float("-inf")) if kind is None
            else _Kind(count, kind.at, kind.wait))

    def forget(self) -> None:
        """All counts begin again."""
        self._kinds.clear()


def left_out(new: int) -> str:
    """For the end of a report about so many new ones."""
    return f", {new - 1} left out" if new > 1 else ""

# SPDX-License-Identifier: Apache-2.0
"""Repeated errors are reported ever more rarely (GND-45).

    repeats.take(("gsc", "no_input"), 50, now)     number of new ones, or None

The first one of a kind is reported at once. While the kind continues, the next
report comes after 1 s, then after 2 s, 4 s and so on. A kind that has been
quiet for twice as long begins again. Each kind is reported at most once a
second, and none hides another.
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
    """The reports so far of each kind."""

    _kinds: dict[tuple[str, ...], _Kind] = field(default_factory=dict)

    def take(self, key: tuple[str, ...], count: int,
             now: float) -> int | None:
        """The number of new ones since the last report, when one is due. A
        count that is lower than before has restarted."""
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
        """Treats all up to this count as reported."""
        kind = self._kinds.get(key)
        self._kinds[key] = (
            _Kind(count, float("-inf")) if kind is None
            else _Kind(count, kind.at, kind.wait))

    def forget(self) -> None:
        """All counts restart."""
        self._kinds.clear()


def left_out(new: int) -> str:
    """For the end of a report about that number of new ones."""
    return f", {new - 1} left out" if new > 1 else ""

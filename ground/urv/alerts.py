# SPDX-License-Identifier: Apache-2.0
"""Cautions and warnings: newest first, acknowledged by hand, never removed
(GND-26)."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

INFO, CAUTION, WARNING = "info", "caution", "warning"

CLEAR_S = 1.0
"""An alert ends when its reason has been absent for this time."""


@dataclass
class Alert:
    """One reason for attention, with its count."""

    key: str
    level: str
    name: str
    text: str
    came_us: int
    count: int = 1
    active: bool = True
    seen: bool = False
    away_since: float | None = None

    def shown(self) -> dict[str, Any]:
        """The alert as pages need it."""
        return {"key": self.key, "level": self.level, "name": self.name,
                "text": self.text, "came_us": self.came_us,
                "count": self.count, "active": self.active,
                "seen": self.seen}


@dataclass
class Alerts:
    """All alerts of the flight. Their number is that of the reasons, so none
    must be removed."""

    changed: int = 0
    raised: list[Alert] = field(default_factory=list)
    _all: dict[str, Alert] = field(default_factory=dict)

    def report(self, key: str, level: str, name: str, text: str,
               time_us: int) -> None:
        """The reason is present now."""
        alert = self._all.get(key)
        if alert is not None and alert.active:
            alert.away_since = None
            return
        count = 1 if alert is None else alert.count + 1
        # Inserted again, so that the newest is last.
        self._all.pop(key, None)
        alert = Alert(key, level, name, text, time_us, count)
        self._all[key] = alert
        self.raised.append(alert)
        self.changed += 1

    def away(self, key: str, now: float, after: float = CLEAR_S) -> None:
        """The reason is absent now; the alert stays in the list."""
        alert = self._all.get(key)
        if alert is None or not alert.active:
            return
        if alert.away_since is None:
            alert.away_since = now
        if now - alert.away_since >= after:
            alert.active = False
            self.changed += 1

    def acknowledge(self, key: str | None = None) -> None:
        """Marks this alert, or all, as seen."""
        for alert in self._all.values():
            if not alert.seen and key in (None, alert.key):
                alert.seen = True
                self.changed += 1

    def active(self, key: str) -> bool:
        """True if the reason is present."""
        alert = self._all.get(key)
        return alert is not None and alert.active

    def shown(self) -> list[dict[str, Any]]:
        """The newest first."""
        return [alert.shown() for alert in reversed(self._all.values())]

# SPDX-License-Identifier: Apache-2.0
"""Orders of the holder of the sticks (GND-35): the control laws' configuration
and the times of a lost link.

The aircraft accepts or refuses an order and reports that in its log, which
arrives a byte a frame. Until then the outcome is unknown. Times are seconds of
any clock that only rises; nothing here waits.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

from urv import packets
from urv.laws import Laws

TABLES = ("usual", "softer")
"""The tables of gains, by number."""

KIND = packets.KINDS.index("configuration_refused")
REFUSED = {
    1: "it came damaged", 2: "a value is none that may be set",
    3: "a control law flies the aircraft", 4: "its control laws are off"}
"""The reason, by the detail of that error."""

ROW_S = 0.3
"""The time in which a row of the log arrives."""
SETTLES_S = 1.0


@dataclass(frozen=True)
class Setting:
    """A configuration. Times are in tenths of a second since the last
    uplink."""

    table: int
    orbit: int
    end: int

    def __str__(self) -> str:
        return (f"{table_name(self.table)}, orbit after {self.orbit / 10:g} s,"
                f" end after {self.end / 10:g} s")


@dataclass
class Orders:
    """The newest order, and its outcome.

    said collects the events, a level and a text, for the log.
    """

    state: str = "none"
    text: str = ""
    said: list[tuple[str, str]] = field(default_factory=list)
    _known: dict[int, Setting] = field(default_factory=dict)
    _serial: int = 0
    _refused: int = 0
    _until: float = 0.0
    _run: int | None = None

    def order(self, console: int, wanted: Setting,
              frame: packets.FramePacket | None, is_holder: bool,
              now: float) -> int | None:
        """The number of the configuration to send; None when the station
        itself refuses it."""
        if not is_holder:
            why = f"console {console} does not hold the sticks"
        elif frame is None:
            why = "nothing comes from the ground's node"
        elif self.state == "waiting":
            why = f"number {self._serial} is still on its way"
        else:
            told = Laws.of(frame)
            # Different from the aircraft's, whoever sent that.
            last = max(self._serial, told.serial if told else 0)
            self._serial = last % packets.LARGEST_SERIAL + 1
            self._known[self._serial] = wanted
            self._refused = _row(frame).count
            self._until = now + _patience(frame)
            self._run = frame.run
            self._is("waiting", "info",
                     f"number {self._serial} ({wanted}) is on its way")
            return self._serial
        # An order under way continues.
        self.said.append(("caution", f"configuration refused here: {why}"))
        if self.state != "waiting":
            self.state, self.text = "refused", f"refused here: {why}"
        return None

    def look(self, frame: packets.FramePacket | None, now: float) -> None:
        """Checks whether the aircraft has answered, however late."""
        if self.state not in ("waiting", "lost") or frame is None:
            return
        told = Laws.of(frame)
        row = _row(frame)
        number = f"number {self._serial}"
        if told is not None and told.serial == self._serial:
            self._is("taken", "info", f"{number}"
                     f" ({self._known[self._serial]}) taken by the aircraft")
        elif frame.run == self._run and row.count > self._refused:
            why = REFUSED.get(row.detail, f"reason {row.detail}")
            self._is("refused", "caution",
                     f"{number} refused by the aircraft: {why}")
        elif self.state == "waiting" and now >= self._until:
            self._is("lost", "caution",
                     f"no answer to {number}: it may be lost, send it again")

    def shown(self, told: Laws | None) -> dict[str, Any]:
        """For pages: the newest order, and the configuration in force."""
        if told is None:
            force = "unknown: no report of the control laws"
        elif told.serial == 0:
            force = "as the aircraft was switched on"
        else:
            known = self._known.get(told.serial)
            force = (f"number {told.serial}: " + (
                str(known) if known and known.table == told.table else
                f"{table_name(told.table)}, times not known here"))
        return {"state": self.state, "text": self.text, "in_force": force}

    def _is(self, state: str, level: str, text: str) -> None:
        self.state, self.text = state, text
        self.said.append((level, f"configuration {text}"))


def table_name(table: int) -> str:
    """For people."""
    name = f" ({TABLES[table]})" if table < len(TABLES) else ""
    return f"gains {table}{name}"


def _row(frame: packets.FramePacket) -> packets.LogRow:
    return frame.logs[packets.NODES.index("mcs")][KIND]


def _patience(frame: packets.FramePacket) -> float:
    """Each kind of error that has occurred has a row, and after each comes the
    laws' own row; twice, in case one is missed."""
    log = frame.logs[packets.NODES.index("mcs")]
    rows = sum(row.count > 0 for row in log[:len(packets.KINDS)])
    return SETTLES_S + 2 * (rows + 1) * 2 * ROW_S

# SPDX-License-Identifier: Apache-2.0
"""Between the pages and the ground's node: sticks, hand-overs, orders, marks.

GND-21 who flies, GND-22 when nobody does, GND-29 the simulated pilot, GND-35
orders.
"""

from __future__ import annotations

import json
import secrets
import time
from collections.abc import Callable
from typing import Any

from urv import items, packets
from urv.orders import Orders, Setting
from urv.sticks import Sticks
from urv.view import CAUTION, INFO, View

PERIOD_S = packets.FRAME_S
INSISTS_S = 1.0
"""For so long the simulated pilot is asked again, while it does not do what
it is asked."""

LOST = {"hidden": ("HIDDEN", "its page is hidden"),
        "gamepad": ("GAMEPAD", "its gamepad is lost")}


class Controls:
    """What the pages may do.

    send takes a console packet's bytes; without it nobody can fly from here.
    """

    def __init__(self, view: View, send: Callable[[bytes], None] | None,
                 now: Callable[[], float] = time.monotonic) -> None:
        self.view = view
        self.sticks = Sticks()
        self.orders = Orders()
        self.refused = 0
        self.bad_messages = 0
        self.packets_sent = 0
        self.archive: dict[str, Any] | None = None
        self.pages = 0
        self._send = send
        self._now = now
        self._run = secrets.randbits(32)
        self._sequence = 0
        self._sent_at = float("-inf")
        self._pilot_wanted: bool | None = None
        self._insists_until = 0.0

    def hears(self, console: int, said: dict[str, Any]) -> None:
        """What a page says, already found to be well formed."""
        now = self._now()
        match said:
            case {"t": "sticks", "words": words}:
                if self.sticks.move(console, words, now):
                    self.view.alerts.away("HIDDEN", now, 0.0)
                    self.view.alerts.away("GAMEPAD", now, 0.0)
                    self._fly(now)
            case {"t": "take"}:
                if self._send is not None:
                    self.sticks.take(console, now)
            case {"t": "answer", "yes": yes}:
                self.sticks.answer(console, yes, now)
            case {"t": "disconnect"}:
                if self._pilot_flies() and self.sticks.holder is None:
                    self.view.note(INFO, "sticks", f"console {console}"
                                   " disconnects the simulated pilot")
                    self._want_pilot(False, now)
                else:
                    self.sticks.release(console, "disconnected")
            case {"t": "pilot"}:
                self._hand_to_pilot(console, now)
            case {"t": "lost", "what": what}:
                self._lose(console, what)
            case {"t": "order", "table": table, "orbit": orbit, "end": end}:
                self._order(console, Setting(table, orbit, end), now)
            case {"t": "mark", "text": text}:
                self.view.note(INFO, "mark", text or "mark")
            case {"t": "seen", "key": key}:
                self.view.alerts.acknowledge(key)
        self._tell()

    def gone(self, console: int) -> None:
        """A page has closed, or was dropped."""
        self.view.note(INFO, "console", f"console {console} closed")
        self.sticks.release(console, "its page has closed")
        self._tell()

    def tick(self) -> None:
        """Each 20 ms: what time alone brings about."""
        now = self._now()
        self.sticks.tick(now)
        self.view.look(now)
        self.orders.look(self.view.frame, now)
        if self.sticks.holder is None:
            for key in LOST:
                self.view.alerts.away(LOST[key][0], now, 0.0)
        if now - self._sent_at >= PERIOD_S:
            self._fly(now)
        self._tell()

    def hello(self, console: int) -> str:
        """What a page needs once."""
        return json.dumps({
            "t": "hello", "console": console,
            "columns": packets.COLUMNS, "commands": packets.COMMANDS,
            "items": {column: about(items.COLUMNS[column])
                      for column in packets.COLUMNS},
            "can_fly": self._send is not None})

    def shown(self) -> dict[str, Any]:
        """The state for all pages."""
        now = self._now()
        sticks = self.sticks
        return self.view.shown() | {
            "holder": sticks.holder,
            "live": sticks.live(now) is not None,
            "asker": sticks.asker,
            "left": round(sticks.left(now), 1),
            "archive": self.archive,
            "order": self.orders.shown(self.view.laws),
            "station": {"refused": self.refused, "bad": self.bad_messages,
                        "sent": self.packets_sent}}

    def _order(self, console: int, wanted: Setting, now: float) -> None:
        """Only the holder's orders go up, as only the holder's sticks do."""
        serial = self.orders.order(
            console, wanted, self.view.frame,
            self._send is not None and self.sticks.holder == console, now)
        if serial is not None:
            self._sequence += 1
            self._send(packets.OrderPacket(
                self._run, self._sequence, time.time_ns() // 1000, serial,
                wanted.table, wanted.orbit, wanted.end).encode())

    def _pilot_flies(self) -> bool:
        frame = self.view.frame
        return (frame is not None and frame.pilot == packets.Pilot.FLIES)

    def _hand_to_pilot(self, console: int, now: float) -> None:
        frame = self.view.frame
        if (self._send is None or frame is None
                or frame.pilot != packets.Pilot.HANDS_OFF
                or self.sticks.holder not in (None, console)):
            return
        self.view.note(INFO, "sticks",
                       f"console {console} hands over to the simulated pilot")
        self.sticks.release(console, "the simulated pilot flies")
        self._want_pilot(True, now)

    def _want_pilot(self, flies: bool, now: float) -> None:
        self._pilot_wanted = flies
        self._insists_until = now + INSISTS_S
        self._fly(now)

    def _lose(self, console: int, what: str) -> None:
        if console != self.sticks.holder:
            return
        self.sticks.pause(console)
        key, text = LOST[what]
        self.view.alerts.report(
            key, CAUTION, key, f"console {console}: {text}, no sticks",
            time.time_ns() // 1000)

    def _fly(self, now: float) -> None:
        """Sends a console packet, if there is somebody to send one for."""
        if self._send is None:
            return
        words = self.sticks.live(now)
        flags = packets.ConsoleFlags(0)
        if words is not None:
            self._pilot_wanted = None
        elif self._pilot_wanted is not None:
            frame = self.view.frame
            done = frame is None or self._pilot_flies() == self._pilot_wanted
            if done or now > self._insists_until:
                self._pilot_wanted = None
                return
            # The stick stays where it is while it changes hands.
            words = frame.words[:len(packets.COMMANDS)]
            if self._pilot_wanted:
                flags = packets.ConsoleFlags.PILOT_FLIES
        if words is None:
            return
        self._sequence += 1
        self._sent_at = now
        self.packets_sent += 1
        self.view.sent(self._sequence)
        self._send(packets.ConsolePacket(
            self._run, self._sequence, time.time_ns() // 1000, words,
            flags).encode())

    def _tell(self) -> None:
        for text in self.sticks.said:
            self.view.note(INFO, "sticks", text)
        self.sticks.said.clear()
        for level, text in self.orders.said:
            self.view.note(level, "order", text)
        self.orders.said.clear()


def about(item: items.Item) -> dict[str, Any]:
    """What a page draws an item by."""
    return {name: getattr(item, name) for name in (
        "unit", "at_0", "at_4095", "warning_low", "caution_low",
        "caution_high", "warning_high")} | {"places": item.decimals}

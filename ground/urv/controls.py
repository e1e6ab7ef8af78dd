# SPDX-License-Identifier: Apache-2.0
"""Between the pages and the ground's node: sticks, hand-overs, orders, marks.

GND-21 and GND-58: the flying party; GND-22: lost consoles; GND-29: the
simulated pilot; GND-35: orders; FTI-8: test cards; FTI-13: the flight recorder;
GND-51: old input; GND-52: gamepads.
"""

from __future__ import annotations

import json
import secrets
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from urv import items, packets
from urv.alerts import CLEAR_S
from urv.answers import first_sequence
from urv.fetcher import Fetcher
from urv.orders import Orders, Setting
from urv.sticks import OLD_S, Sticks
from urv.tables import TABLES
from urv.view import CAUTION, INFO, View

PERIOD_S = packets.FRAME_S
INSISTS_S = 1.0
"""Requests to the simulated pilot are repeated for this time, until it
complies."""

PROTOCOL = 2
"""The version of the messages between page and station. A page with another
version must reload."""

LOST = {"hidden": ("HIDDEN", "its page is hidden"),
        "gamepad": ("GAMEPAD", "its gamepad is lost"),
        "hung": ("BROWSER HUNG", "its browser hung for more than 0.5 s")}
SILENT, CLOSED = "PAGE SILENT", "PAGE CLOSED"
NOT_FLYING = (*(name for name, _ in LOST.values()), SILENT, CLOSED)
"""Alerts that end when a console or the pilot flies again."""
REPORTED_S = 0.4
"""A holder that is silent for this time is reported: within 0.5 s."""

INPUT = ("sticks", "take", "answer", "pilot", "order", "cards", "recorder")
"""Messages that must not be late. Others may be."""
OLD, REPEATED = "OLD INPUT", "REPEATED INPUT"
RELOAD, CLOCK, OTHER = "RELOAD PAGE", "PAGE CLOCK", "OTHER GAMEPAD"

GAMEPAD = {
    "chosen": "flies by gamepad", "lost": "lost its gamepad",
    "back": "has its gamepad again", "mapped": "has mapped its gamepad",
    "other": "has another gamepad, which is not used until the pilot chooses"
             " it",
    "unmapped": "has a gamepad that is not used until the pilot maps it",
}
"""A page's reports about gamepads."""


@dataclass(frozen=True)
class Late:
    """Successive input messages that came too late."""

    console: int
    count: int = 0
    most: float = 0.0
    at: float = 0.0


class Controls:
    """Carries out the messages of pages.

    send takes a console packet's bytes; without it no page can fly.
    """

    def __init__(self, view: View, send: Callable[[bytes], None] | None,
                 now: Callable[[], float] = time.monotonic,
                 fetcher: Fetcher | None = None) -> None:
        self.view = view
        self.fetcher = fetcher or Fetcher(None, Path())
        self.sticks = Sticks()
        self.orders = Orders()
        self.refused = 0
        self.bad_messages = 0
        self.old = self.repeats = 0
        self.packets_sent = 0
        self.archive: dict[str, Any] | None = None
        self.pages = 0
        self._send = send
        self._now = now
        self._run = secrets.randbits(32)
        self._sequence = first_sequence()
        self._sent_at = float("-inf")
        self._pilot_wanted: bool | None = None
        self._insists_until = 0.0
        self._outdated: set[int] = set()
        self._others: set[int] = set()
        self._late: Late | None = None

    def hears(self, console: int, said: dict[str, Any],
              age: float = 0.0) -> None:
        """Handles a page's message, already checked for its form and age
        seconds old."""
        now = self._now()
        if age > OLD_S and said["t"] in INPUT:
            self._drop(console, age, now)
            return
        match said:
            case {"t": "sticks", "words": words}:
                silence = self.sticks.silence(now)
                if self.sticks.move(console, words, now, age):
                    if silence >= REPORTED_S:
                        self.view.note(INFO, "sticks", f"console {console}"
                                       f" flies again after {silence:.1f} s")
                    for key in NOT_FLYING:
                        self.view.alerts.away(key, now, 0.0)
                    self._fly(now)
            case {"t": "take"}:
                if self._send is not None:
                    self.sticks.take(console, now)
            case {"t": "answer", "yes": yes}:
                self.sticks.answer(console, yes, now)
            case {"t": "release"}:
                if self._pilot_flies() and self.sticks.holder is None:
                    self.view.note(INFO, "sticks", f"console {console}"
                                   " stops the simulated pilot")
                    self._want_pilot(False, now)
                else:
                    self.sticks.release(console, "released")
            case {"t": "pilot"}:
                self._hand_to_pilot(console, now)
            case {"t": "lost", "what": what}:
                self._lose(console, what)
            case {"t": "gamepad", "what": what, "name": name}:
                self._gamepad(console, what, name, now)
            case {"t": "order", "table": table, "orbit": orbit, "end": end}:
                self._order(console, Setting(table, orbit, end), now)
            case {"t": "cards", "text": text}:
                self.view.deck.order(
                    console, text, self.view.frame, self._sends_for(console),
                    now)
            case {"t": "recorder", "what": what, "last": last}:
                self._recorder(console, what, last)
            case {"t": "mark", "text": text}:
                self.view.note(INFO, "mark", text or "mark")
            case {"t": "seen", "key": key}:
                self.view.alerts.acknowledge(key)
        self._tell()

    def gone(self, console: int) -> None:
        """A page has closed, or was dropped."""
        self.view.note(INFO, "console", f"console {console} closed")
        if console == self.sticks.holder:
            self._caution(CLOSED, f"console {console} had the sticks, and its"
                          " page has closed: no sticks")
        self.sticks.release(console, "its page has closed")
        self._outdated.discard(console)
        if not self._outdated:
            self.view.alerts.away(RELOAD, self._now(), 0.0)
        self._knows_its_gamepad(console, self._now())
        self._tell()

    def outdated(self, console: int) -> None:
        """A page whose messages have no number and no time may only watch."""
        self._outdated.add(console)
        self._caution(RELOAD, f"console {console} is older than the station:"
                      " reload its page; it cannot fly")

    def repeated(self, console: int, sequence: int) -> None:
        """A message was repeated, or came after a later one."""
        self.repeats += 1
        self._caution(REPEATED, f"console {console}: message {sequence} came"
                      " again or out of order, dropped")

    def stepped(self, console: int, seconds: float) -> None:
        """A page's clock has stepped back; its messages count again."""
        self._caution(CLOCK, f"console {console}: the clock of its page stepped"
                      f" by {seconds:.1f} s; its input counts again")

    def tick(self) -> None:
        """Each 20 ms: all effects of time."""
        now = self._now()
        self.sticks.tick(now)
        self.view.look(now)
        self.orders.look(self.view.frame, now)
        self._send_card(now)
        while self.fetcher.said:
            level, text = self.fetcher.said.popleft()
            self.view.note(level, "recorder", text if level == INFO
                           else f"recorder: {text}")
        alerts = self.view.alerts
        if self.sticks.holder is None:
            for key in NOT_FLYING:
                if key != CLOSED or self._pilot_flies():
                    alerts.away(key, now, 0.0)
        elif (self.sticks.silence(now) >= REPORTED_S
              and not any(map(alerts.active, NOT_FLYING))):
            self._caution(SILENT, f"console {self.sticks.holder}: nothing from"
                          f" its page for {REPORTED_S} s, no sticks")
        for key in (REPEATED, CLOCK):
            alerts.away(key, now)
        if self._late is not None and now - self._late.at >= CLEAR_S:
            self._end_of_late(now)
        if now - self._sent_at >= PERIOD_S:
            self._fly(now)
        self._tell()

    def hello(self, console: int) -> str:
        """The first message to a page."""
        return json.dumps({
            "t": "hello", "console": console,
            "columns": packets.COLUMNS, "commands": packets.COMMANDS,
            "items": {column: about(items.COLUMNS[column])
                      for column in packets.COLUMNS},
            "tables": {"frame_ms": packets.FRAME_US / 1000,
                       "middle": TABLES["neutral_word"],
                       "largest": items.LARGEST_WORD},
            "switches": [{"use": item.use, "works": item.works}
                         for item in items.SWITCHES],
            "protocol": PROTOCOL, "can_fly": self._send is not None})

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
            "recorder": self.fetcher.shown(),
            "station": {"refused": self.refused, "bad": self.bad_messages,
                        "old": self.old, "repeated": self.repeats,
                        "sent": self.packets_sent}}

    def _order(self, console: int, wanted: Setting, now: float) -> None:
        """Only the holder's orders are sent, like the sticks."""
        serial = self.orders.order(
            console, wanted, self.view.frame, self._sends_for(console), now)
        if serial is not None:
            self._sequence += 1
            self._send(packets.OrderPacket(
                self._run, self._sequence, time.time_ns() // 1000, serial,
                wanted.table, wanted.orbit, wanted.end).encode())

    def _recorder(self, console: int, what: str, last: int | None) -> None:
        """The holder of the sticks, or any page while nobody holds them."""
        if self.sticks.holder not in (None, console):
            return
        if what == "ask":
            self.fetcher.ask()
        elif what == "fetch":
            self.fetcher.fetch(last)
        else:
            self.fetcher.stop()

    def _sends_for(self, console: int) -> bool:
        return self._send is not None and self.sticks.holder == console

    def _send_card(self, now: float) -> None:
        card = self.view.deck.due(now)
        if card is not None and self._send is not None:
            self._sequence += 1
            self._send(packets.CardPacket(
                self._run, self._sequence, time.time_ns() // 1000,
                card.words()).encode())

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

    def _caution(self, name: str, text: str) -> None:
        self.view.alerts.report(name, CAUTION, name, text,
                                time.time_ns() // 1000)

    def _drop(self, console: int, age: float, now: float) -> None:
        """Counts input that is too old, and reports the begin and end of such
        input."""
        self.old += 1
        self._caution(OLD, f"console {console}: its input arrives {age:.1f} s"
                      " late and is dropped")
        late = self._late or Late(console)
        self._late = Late(console, late.count + 1, max(late.most, age), now)

    def _end_of_late(self, now: float) -> None:
        late, self._late = self._late, None
        self.view.alerts.away(OLD, now, 0.0)
        self.view.note(INFO, "sticks", f"console {late.console}: {late.count}"
                       f" messages dropped, up to {late.most:.1f} s late")

    def _gamepad(self, console: int, what: str, name: str,
                 now: float) -> None:
        text = f"console {console} {GAMEPAD[what]}: {name or 'no name'}"
        if what == "other":
            self._others.add(console)
            self._caution(OTHER, text)
        else:
            self.view.note(INFO, "sticks", text)
        if what in ("chosen", "back"):
            self._knows_its_gamepad(console, now)

    def _knows_its_gamepad(self, console: int, now: float) -> None:
        """Reports that the holder's gamepad was chosen, or has gone."""
        self._others.discard(console)
        if not self._others:
            self.view.alerts.away(OTHER, now, 0.0)

    def _lose(self, console: int, what: str) -> None:
        if console != self.sticks.holder:
            return
        self.sticks.pause(console)
        name, text = LOST[what]
        self._caution(name, f"console {console}: {text}, no sticks")

    def _fly(self, now: float) -> None:
        """Sends a console packet, if there is a source of sticks."""
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
            # The stick keeps its position during a hand-over.
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
        self.view.tell_of_cards()


def about(item: items.Item) -> dict[str, Any]:
    """An item's description for drawing."""
    return {name: getattr(item, name) for name in (
        "unit", "at_0", "at_4095", "warning_low", "caution_low",
        "caution_high", "warning_high")} | {"places": item.decimals}

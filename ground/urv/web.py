# SPDX-License-Identifier: Apache-2.0
"""The station's page over HTTP, its state and sticks over a WebSocket.

Input from outside is never trusted: a foreign origin is refused (GND-23),
sizes and rates have limits, and a slow or silent client is dropped, never
waited for (GND-24, SEC-11). Typed text is made one plain line (GND-27).
"""

from __future__ import annotations

import asyncio
import ipaddress
import json
import logging
import time
import unicodedata
from collections.abc import Awaitable, Callable
from pathlib import Path
from typing import Any

from aiohttp import WSMsgType, web
from aiohttp.http_exceptions import HttpProcessingError

from urv import items, packets
from urv.arrivals import Arrivals
from urv.controls import GAMEPAD, Controls
from urv.door import Door, Token, address_of, refusal

PAGE = Path(__file__).resolve().parent / "page"
TYPES = {".html": "text/html", ".css": "text/css", ".js": "text/javascript",
         ".svg": "image/svg+xml"}
COOKIE = "urv_token"

MOST_PAGES = 16
QUIET_S = 5.0
"""A page that is silent for this time gives its place to another one that
opens. The holder of the sticks never does."""
LONGEST_MARK = 200
LONGEST_CARDS = 3_500
"""A file of test cards, without comments, in characters."""
LONGEST_ESCAPE = len(r"\u0000")
"""The most bytes of a character in JSON. A pair of surrogates is two
characters for the page."""
LONGEST_MESSAGE = LONGEST_ESCAPE * LONGEST_CARDS + 512
"""In bytes, with room for the other fields: any file that a page accepts."""
LONGEST_FETCH_S = 100_000
"""More seconds than a recorder holds."""
MESSAGES_A_SECOND = 150.0
MOST_BAD_MESSAGES = 20
LARGEST_SEQUENCE = 2**53
LARGEST_TIME_MS = 1e13
LONGEST_NAME = 200
SLOW_S = 2.0
"""A page that does not read its states is dropped."""
UNDRAWN = 2
"""The number of states in transit to a page that reports the drawn ones: one
that waits for the next picture, and one after it. More would wait in the
network, and be old when they are seen."""

HEADERS = {
    "Content-Security-Policy":
        "default-src 'none'; script-src 'self'; style-src 'self';"
        " img-src 'self'; connect-src 'self'; base-uri 'none';"
        " form-action 'none'; frame-ancestors 'none'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "DENY",
    "Cache-Control": "no-store",
}

Handler = Callable[[web.Request], Awaitable[web.StreamResponse]]


def is_worth_telling(record: logging.LogRecord) -> bool:
    """True if a message of the server's log is about a fault in this program.
    An invalid request is reported only to its sender."""
    return not (record.exc_info
                and isinstance(record.exc_info[1], HttpProcessingError))


LOG = logging.getLogger("urv.web")
LOG.addFilter(is_worth_telling)


def is_loopback(address: str) -> bool:
    """True if only this machine can reach the address."""
    if address == "localhost":
        return True
    try:
        return ipaddress.ip_address(address).is_loopback
    except ValueError:
        return False


class Page:
    """An open page: a console, with its number."""

    def __init__(self, number: int, socket: web.WebSocketResponse) -> None:
        self.number = number
        self.socket = socket
        self.alerts = -1
        self.line = 0
        self.state: str | None = None
        self.sent = 0
        self.drawn: int | None = None
        self.left_out = 0
        self.wake = asyncio.Event()
        self.credit = 2 * MESSAGES_A_SECOND
        self.filled = 0.0
        self.heard = 0.0
        self.bad = 0
        self.arrivals = Arrivals()

    @property
    def is_behind(self) -> bool:
        """True if it reports its drawn states, and has enough to draw."""
        return self.drawn is not None and self.sent - self.drawn >= UNDRAWN

    def allowed(self, now: float) -> bool:
        """True if it may send one more message already."""
        self.credit = min(2 * MESSAGES_A_SECOND, self.credit
                          + (now - self.filled) * MESSAGES_A_SECOND)
        self.filled = now
        self.credit -= 1
        return self.credit >= 0


class Station:
    """The web side of the station."""

    def __init__(self, controls: Controls, token: str | None = None) -> None:
        self.controls = controls
        self.token = None if token is None else Token(token)
        self.door: Door | None = None
        self.pages: dict[int, Page] = {}
        self._dropping: set[asyncio.Task[None]] = set()
        self._numbers = 0
        self._fault = ""
        self.application = web.Application(
            middlewares=[self._guard], client_max_size=1)
        self.application.router.add_get("/", self._index)
        self.application.router.add_get("/page/{name}", self._file)
        self.application.router.add_get("/api/state", self._state)
        self.application.router.add_get("/ws", self._socket)

    # HTTP

    @web.middleware
    async def _guard(self, request: web.Request,
                     handler: Handler) -> web.StreamResponse:
        refused = refusal(request)
        if refused is not None:
            self.controls.refused += 1
            answer: web.StreamResponse = web.Response(
                status=403, text=f"refused: {refused}\n")
        elif (stranger := self._stranger(request)) is not None:
            answer = stranger
        else:
            if self.door is not None:
                self.door.knows(request.protocol)
            try:
                answer = await handler(request)
            except web.HTTPException as error:
                answer = web.Response(status=error.status,
                                      text=f"{error.reason}\n")
        if not answer.prepared:
            answer.headers.update(HEADERS)
            answer.force_close()
        return answer

    def _stranger(self, request: web.Request) -> web.Response | None:
        """The answer to a request without the token, or None. The token in the
        page's address goes into a cookie."""
        token = self.token
        if token is None:
            return None
        cookie = request.cookies.get(COOKIE, "")
        if token.is_session(cookie):
            return None
        now = asyncio.get_running_loop().time()
        address = address_of(request.remote)
        if not token.may_try(address, now):
            self.controls.refused += 1
            return web.Response(
                status=429, headers={"Retry-After": "1"},
                text="too many requests without the token\n")
        kind, _, bearer = request.headers.get(
            "Authorization", "").partition(" ")
        if token.is_token(cookie) or (kind == "Bearer"
                                      and token.is_token(bearer)):
            return None
        if request.path == "/" and token.is_token(
                request.query.get("token", "")):
            answer = web.Response(status=303, headers={"Location": "/"})
            answer.set_cookie(COOKIE, token.session, httponly=True,
                              samesite="Strict")
            return answer
        token.failed(address, now)
        self.controls.refused += 1
        return web.Response(
            status=401, text="a token is needed: open the address that the"
            " station printed\n")

    async def _index(self, _request: web.Request) -> web.StreamResponse:
        return self._read("index.html")

    async def _file(self, request: web.Request) -> web.StreamResponse:
        return self._read(request.match_info["name"])

    @staticmethod
    def _read(name: str) -> web.Response:
        # Only existing names: no path can lead elsewhere.
        known = {file.name: file for file in PAGE.iterdir()
                 if file.suffix in TYPES}
        if name not in known:
            raise web.HTTPNotFound
        return web.Response(body=known[name].read_bytes(),
                            content_type=TYPES[known[name].suffix],
                            charset="utf-8")

    async def _state(self, _request: web.Request) -> web.StreamResponse:
        return web.json_response(
            {"columns": packets.COLUMNS} | self.controls.shown()
            | {"alerts": self.controls.view.alerts.shown()})

    # WebSocket

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        now = asyncio.get_running_loop().time()
        if len(self.pages) >= MOST_PAGES and not self._drop_a_quiet_page(now):
            raise web.HTTPServiceUnavailable
        answer = web.WebSocketResponse(
            max_msg_size=LONGEST_MESSAGE, heartbeat=4.0, compress=False)
        await answer.prepare(request)
        if self.door is not None:
            self.door.leaves(request.protocol)
        self._numbers += 1
        page = Page(self._numbers, answer)
        page.filled = page.heard = now
        self.pages[page.number] = page
        self.controls.view.note("info", "console", f"console {page.number} opened")
        writer = asyncio.create_task(self._write(page, request))
        try:
            await self._listen(page)
        finally:
            self.pages.pop(page.number, None)
            self.controls.gone(page.number)
            writer.cancel()
            await asyncio.gather(writer, return_exceptions=True)
        return answer

    def _drop_a_quiet_page(self, now: float) -> bool:
        """Makes a place for another page, if one was silent for QUIET_S."""
        quiet = min((page for page in self.pages.values()
                     if page.number != self.controls.sticks.holder),
                    key=lambda page: page.heard, default=None)
        if quiet is None or now - quiet.heard < QUIET_S:
            return False
        del self.pages[quiet.number]
        self._dropping.add(dropping := asyncio.create_task(
            self._drop(quiet, "silent, and another page opens")))
        dropping.add_done_callback(self._dropping.discard)
        return True

    async def _listen(self, page: Page) -> None:
        loop = asyncio.get_running_loop()
        async for message in page.socket:
            if not page.allowed(loop.time()):
                await self._drop(page, "too many messages")
                return
            if message.type != WSMsgType.TEXT:
                said = None
            else:
                said = understood(message.data)
            if said is None:
                self.controls.bad_messages += 1
                page.bad += 1
                if page.bad > MOST_BAD_MESSAGES:
                    await self._drop(page, "messages of an unknown form")
                    return
            else:
                page.heard = loop.time()
                self._heard(page, said)

    def _heard(self, page: Page, said: dict[str, Any]) -> None:
        """A fault in this code costs only this message, never the pilot's
        sticks (GND-57)."""
        try:
            self._hears(page, said, page.heard)
        except Exception as error:  # noqa: BLE001 - whatever it is
            self.controls.bad_messages += 1
            fault = f"{said['t']}: {type(error).__name__}: {error}"
            if fault != self._fault:
                self._fault = fault
                self.controls.view.note(
                    "caution", "console", f"console {page.number}: a message"
                    f" could not be handled: {fault}")

    def _hears(self, page: Page, said: dict[str, Any], now: float) -> None:
        """Only messages with a new number count, and each has an age
        (GND-51)."""
        sequence, sent_s = said.get("sequence"), said.get("sent_s")
        if sequence is None or sent_s is None:
            self.controls.outdated(page.number)
        elif not page.arrivals.is_new(sequence):
            self.controls.repeated(page.number, sequence)
        elif said["t"] == "drawn":
            step = page.arrivals.answer(said["number"], sent_s, now)
            if step is not None:
                self.controls.stepped(page.number, step)
            # It cannot have drawn a state that was never sent.
            page.drawn = min(said["number"], page.sent)
            page.wake.set()
        else:
            self.controls.hears(page.number, said,
                                page.arrivals.age(sent_s, now))

    async def _drop(self, page: Page, why: str) -> None:
        self.controls.view.note("caution", "console",
                            f"console {page.number} dropped: {why}")
        try:
            await asyncio.wait_for(
                page.socket.close(code=1008, message=why.encode()), 1.0)
        except TimeoutError:
            pass

    async def _write(self, page: Page, request: web.Request) -> None:
        """Sends the newest state; a state that could not be sent in time is
        never sent late (GND-36). A state has its number, and the number of
        states left out before it."""
        try:
            await self._send(page, self.controls.hello(page.number))
            while True:
                await page.wake.wait()
                page.wake.clear()
                if page.is_behind:
                    continue
                alerts = self.controls.view.alerts
                if page.alerts != alerts.changed:
                    page.alerts = alerts.changed
                    await self._send(page, json.dumps(
                        {"t": "alerts", "alerts": alerts.shown()}))
                lines = [line.shown() for line in self.controls.view.log
                         if line.number > page.line][-200:]
                if lines:
                    page.line = lines[-1]["number"]
                    await self._send(page, json.dumps(
                        {"t": "log", "lines": lines}))
                state, page.state = page.state, None
                if state is not None:
                    page.sent += 1
                    page.arrivals.sends(
                        page.sent, asyncio.get_running_loop().time())
                    await self._send(
                        page, f'{state[:-1]},"number":{page.sent},'
                        f'"left_out":{page.left_out}}}')
        except (ConnectionError, RuntimeError):
            # It has gone; the code that listens to it notices that.
            pass
        except TimeoutError:
            self.controls.view.note("caution", "console",
                                f"console {page.number} dropped: too slow")
            if request.transport is not None:
                request.transport.abort()

    @staticmethod
    async def _send(page: Page, text: str) -> None:
        await asyncio.wait_for(page.socket.send_str(text), SLOW_S)

    def push(self) -> None:
        """Sends the newest state to every page."""
        if not self.pages:
            return
        state = json.dumps(
            {"t": "state", "sent_ms": round(1000 * time.monotonic(), 1)}
            | self.controls.shown(), separators=(",", ":"))
        for page in self.pages.values():
            page.left_out += page.state is not None
            page.state = state
            page.wake.set()


def understood(text: str) -> dict[str, Any] | None:
    """A page's message, if it has a valid form, with its number, sequence, and
    its time, sent_s. A page that is older than the station sends neither."""
    try:
        said = json.loads(text)
    except (ValueError, RecursionError):
        return None
    if not isinstance(said, dict):
        return None
    meant = meaning(said)
    if meant is None or ("sequence" not in said and "sent_ms" not in said):
        return meant
    match said:
        case {"sequence": int(sequence), "sent_ms": int() | float() as sent} if (
                type(sequence) is int and type(sent) is not bool
                and 0 < sequence <= LARGEST_SEQUENCE
                and 0 <= sent <= LARGEST_TIME_MS):
            return meant | {"sequence": sequence, "sent_s": sent / 1000}
    return None


def meaning(said: dict[str, Any]) -> dict[str, Any] | None:
    """The message without its number and time."""
    match said:
        case {"t": "sticks", "words": list(words)} if (
                len(words) == len(packets.COMMANDS)
                and all(type(word) is int
                        and 0 <= word <= items.LARGEST_WORD
                        for word in words)):
            return {"t": "sticks", "words": tuple(words)}
        case {"t": "drawn", "number": number} if (
                type(number) is int and number >= 0):
            return {"t": "drawn", "number": number}
        case {"t": "order", "table": table, "orbit": orbit, "end": end} if (
                all(type(value) is int
                    and 0 <= value <= packets.LARGEST_SERIAL
                    for value in (table, orbit, end))):
            return {"t": "order", "table": table, "orbit": orbit, "end": end}
        case {"t": "cards", "text": str(text)} if (
                len(text) <= LONGEST_CARDS):
            return {"t": "cards", "text": text}
        case {"t": "recorder", "what": "ask" | "fetch" | "stop" as what,
              "last": last} if last is None or (
                  type(last) is int and 1 <= last <= LONGEST_FETCH_S):
            return {"t": "recorder", "what": what, "last": last}
        case {"t": "answer", "yes": bool(yes)}:
            return {"t": "answer", "yes": yes}
        case {"t": "mark", "text": str(note)} if len(note) <= LONGEST_MARK:
            return {"t": "mark", "text": plain(note)}
        case {"t": "seen", "key": str() | None as key}:
            return {"t": "seen", "key": key}
        case {"t": "lost", "what": "hidden" | "gamepad" | "hung" as what}:
            return {"t": "lost", "what": what}
        case {"t": "gamepad", "what": str(what), "name": str(name)} if (
                what in GAMEPAD and len(name) <= LONGEST_NAME):
            return {"t": "gamepad", "what": what, "name": plain(name)}
        case {"t": "take" | "release" | "pilot" as what}:
            return {"t": what}
    return None


def plain(text: str) -> str:
    """A note in one line, without characters that move the cursor or hide
    text."""
    return " ".join("".join(
        " " if unicodedata.category(letter)[0] in "CZ" else letter
        for letter in text).split())

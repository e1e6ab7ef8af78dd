# SPDX-License-Identifier: Apache-2.0
"""Admission to the station's page, and time limits (GND-24, SEC-11).

A request by another name than this machine's, or from a foreign page, is
refused, here and at Yamcs's pages (GND-23, SEC-13).

A connection waits until its first request has been authenticated: with the
token where one is demanded, otherwise by Host and Origin. Waiting connections
have few places, each address a part of them, and little time. Strangers
therefore never occupy a pilot's place.
"""

from __future__ import annotations

import asyncio
import hashlib
import hmac
import ipaddress
import socket
from collections import Counter
from typing import Any
from urllib.parse import urlsplit

from aiohttp import web

MOST_WAITING = 48
"""Waiting connections, of all addresses."""
MOST_OF_ADDRESS = 16
"""Waiting connections, of one address. Browsers open six."""
MOST_KNOWN = 64
"""Connections with an authenticated request."""
WAITS_S = 3.0
"""A connection without authentication by then is closed."""
PATIENCE_S = 10.0
"""A connection whose answer has not been taken by then is closed, counted from
its beginning."""

BURST = 20
"""Requests without the token that an address may send at once."""
TRIES_A_SECOND = 1.0
"""And later ones each second."""
MOST_ADDRESSES = 1024
LONGEST_ERROR = 200


def address_of(host: str | None) -> str:
    """The owner of a connection: an IPv4 address, or an IPv6 network, which is
    assigned to one subscriber."""
    try:
        address = ipaddress.ip_address((host or "").partition("%")[0])
    except ValueError:
        return ""
    if isinstance(address, ipaddress.IPv6Address):
        if address.ipv4_mapped is not None:
            return str(address.ipv4_mapped)
        return str(ipaddress.ip_network((address, 64), strict=False))
    return str(address)


def is_own_host(host: str | None) -> bool:
    """True if Host names this machine in a way that no foreign name server
    can: by address, as localhost, or by the machine's own name."""
    if not host:
        return False
    try:
        name = urlsplit(f"//{host}").hostname
    except ValueError:
        return False
    if name is None:
        return False
    if name in ("localhost", socket.gethostname().lower()):
        return True
    try:
        ipaddress.ip_address(name)
    except ValueError:
        return False
    return True


def refusal(request: web.BaseRequest) -> str | None:
    """The reason why a request is not from this machine's own page or a
    program, or None. A foreign page may open the page, in a window of its
    own."""
    host = request.headers.get("Host")
    if not is_own_host(host):
        return "Host is not this machine's"
    origin = request.headers.get("Origin")
    if origin is not None and origin != f"http://{host}":
        return "foreign Origin"
    site = request.headers.get("Sec-Fetch-Site", "none")
    opened = (request.headers.get("Sec-Fetch-Mode") == "navigate"
              and request.headers.get("Sec-Fetch-Dest") == "document")
    if site not in ("same-origin", "none") and not opened:
        return "asked for by a foreign page"
    return None


class Visitor(web.RequestHandler):
    """A connection. An invalid request gets an answer of one line."""

    __slots__ = ("door", "address")

    def __init__(self, door: Door, *arguments: Any, **more: Any) -> None:
        super().__init__(*arguments, **more)
        self.door = door
        self.address = ""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        super().connection_made(transport)
        peer = transport.get_extra_info("peername")
        self.address = address_of(peer[0] if peer else None)
        self.door.enters(self)

    def connection_lost(self, exc: BaseException | None) -> None:
        self.door.leaves(self)
        super().connection_lost(exc)

    def handle_error(self, request: Any, status: int = 500,
                     exc: BaseException | None = None,
                     message: str | None = None) -> web.StreamResponse:
        answer = super().handle_error(request, status, exc, message)
        if isinstance(answer, web.Response):
            said = " ".join((answer.text or "").split())[:LONGEST_ERROR]
            answer.text = "".join(
                letter if letter.isprintable() else "?"
                for letter in said) + "\n"
        return answer


class Door:
    """Makes a connection's protocol, and closes idle connections.

    A request is answered and its connection closed within PATIENCE_S; only a
    WebSocket stays longer, which has its own limits.
    """

    def __init__(self, server: web.Server, **options: Any) -> None:
        """The options are those of the server's connections."""
        self._server, self._options = server, options
        # The oldest comes first.
        self._waiting: dict[Visitor, float] = {}
        self._known: dict[Visitor, float] = {}

    def __call__(self) -> asyncio.BaseProtocol:
        return Visitor(self, self._server, loop=asyncio.get_running_loop(),
                       **self._options)

    def enters(self, visitor: Visitor) -> None:
        """A connection waits. Without a free place, the oldest one of its
        address is closed, or of the address that has most."""
        address = visitor.address
        counts = Counter(each.address for each in self._waiting)
        if counts[address] < MOST_OF_ADDRESS:
            address = (counts.most_common(1)[0][0]
                       if len(self._waiting) >= MOST_WAITING else None)
        if address is not None:
            self._shut(next(each for each in self._waiting
                            if each.address == address))
        self._waiting[visitor] = asyncio.get_running_loop().time()

    def knows(self, visitor: Any) -> None:
        """The connection's request has been authenticated."""
        since = self._waiting.pop(visitor, None)
        if since is not None:
            if len(self._known) >= MOST_KNOWN:
                self._shut(next(iter(self._known)))
            self._known[visitor] = since

    def leaves(self, visitor: Any) -> None:
        """The connection has ended, or has become a WebSocket."""
        self._waiting.pop(visitor, None)
        self._known.pop(visitor, None)

    def look(self, now: float) -> None:
        """Closes connections that have been open for too long."""
        for group, most_s in ((self._waiting, WAITS_S),
                              (self._known, PATIENCE_S)):
            for visitor in [visitor for visitor, since in group.items()
                            if now - since > most_s]:
                self._shut(visitor)

    def _shut(self, visitor: Visitor) -> None:
        self.leaves(visitor)
        if visitor.transport is not None:
            visitor.transport.abort()


class Token:
    """The token of a page, and the rate of an address's tries.

    The token itself is compared only while its address has tries left. A
    browser then presents a session word that is slow to compute from the
    token, so that admitted pages stay admitted, whatever a stranger at their
    address does.
    """

    def __init__(self, token: str) -> None:
        self._token = token.encode()
        self.session = hashlib.scrypt(
            self._token, salt=b"urv: a page of the station",
            n=2**14, r=8, p=1).hex()
        # For each address: the remaining tries, and the time of that count.
        self._tries: dict[str, tuple[float, float]] = {}

    def is_session(self, word: str) -> bool:
        """True if this is the session word of a browser."""
        return hmac.compare_digest(octets(word), self.session.encode())

    def is_token(self, word: str) -> bool:
        """True if this is the token. may_try must have been called before."""
        return hmac.compare_digest(octets(word), self._token)

    def may_try(self, address: str, now: float) -> bool:
        """True if the address has a try left."""
        return self._left(address, now) >= 1

    def failed(self, address: str, now: float) -> None:
        """Counts a failed try."""
        left = self._left(address, now) - 1
        self._tries.pop(address, None)
        if len(self._tries) >= MOST_ADDRESSES:
            del self._tries[next(iter(self._tries))]
        self._tries[address] = (left, now)

    def _left(self, address: str, now: float) -> float:
        left, then = self._tries.get(address, (BURST, now))
        return min(BURST, left + (now - then) * TRIES_A_SECOND)


def octets(text: str) -> bytes:
    """The bytes of a received text, which may have invalid characters."""
    return text.encode("utf-8", "surrogateescape")

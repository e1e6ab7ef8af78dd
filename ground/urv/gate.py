# SPDX-License-Identifier: Apache-2.0
"""Yamcs's pages, for the browsers and programs of this machine (SEC-13).

Yamcs answers every request that reaches its port, including those of a foreign
page, or of a page whose name leads to this machine. It therefore listens below
a secret path, and the Gate listens at the public port. The Gate refuses
requests by another name and of foreign pages, and requests that do more than
read. It forwards the rest, WebSockets included.
"""

from __future__ import annotations

import asyncio
import contextlib
import re
from collections.abc import AsyncIterator

import aiohttp
from aiohttp import ClientResponse, WSMsgType, web
from yarl import URL

from urv.door import refusal

READS = re.compile(
    r"/api/[\w.-]+(/[\w.-]+)*"
    r":(list|batchGet|exportParameterValues|stream[A-Z]\w*)")
"""POST requests of Yamcs's API that only read; it uses them for long
queries."""

LARGEST_REQUEST = 1 << 16
"""In bytes, also of a message of a WebSocket: Yamcs takes no larger ones."""
LARGEST_PAGE = 1 << 20
"""In bytes, of an HTML page. Yamcs's has 50 kB."""
PART = 1 << 16

PATIENCE = aiohttp.ClientTimeout(total=None, sock_connect=5.0, sock_read=60.0)
"""A download may take long, but must deliver a byte each minute."""

ASKED = ("Accept", "Content-Type", "If-Modified-Since", "Range")
"""Headers of requests that are forwarded to Yamcs."""
ANSWERED = ("Accept-Ranges", "Cache-Control", "Content-Disposition",
            "Content-Length", "Content-Range", "Content-Type", "ETag",
            "Expires", "Last-Modified")
"""Headers of answers that are forwarded to browsers."""
HEADERS = {
    "Content-Security-Policy": "frame-ancestors 'self'",
    "Cross-Origin-Opener-Policy": "same-origin",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "same-origin",
    "X-Content-Type-Options": "nosniff",
    "X-Frame-Options": "SAMEORIGIN",
}

Socket = aiohttp.ClientWebSocketResponse | web.WebSocketResponse


def no_read(request: web.Request) -> str | None:
    """The reason why a request is more than a read, or None."""
    path = request.raw_path.partition("?")[0]
    if request.method in ("GET", "HEAD") or (
            request.method == "POST" and READS.fullmatch(path)):
        return None
    return "Yamcs's pages read, and change nothing"


class Gate:
    """Checks requests and forwards them to a Yamcs."""

    def __init__(self, yamcs: str) -> None:
        """Takes its URL, with its path."""
        self._yamcs = yamcs.rstrip("/")
        self._path = URL(self._yamcs).raw_path.rstrip("/")
        self._session: aiohttp.ClientSession | None = None
        self.application = web.Application(client_max_size=LARGEST_REQUEST)
        self.application.router.add_route("*", "/{path:.*}", self._answer)
        self.application.cleanup_ctx.append(self._with_session)

    async def _with_session(self, _app: web.Application
                            ) -> AsyncIterator[None]:
        async with aiohttp.ClientSession(
                timeout=PATIENCE, auto_decompress=False,
                connector=aiohttp.TCPConnector(limit=0),
                skip_auto_headers=("Accept-Encoding", "User-Agent"),
                ) as self._session:
            yield

    async def _answer(self, request: web.Request) -> web.StreamResponse:
        refused = refusal(request) or no_read(request)
        if refused is not None:
            return self._said(403, f"refused: {refused}")
        if not request.raw_path.startswith("/"):
            return self._said(400, "a path is needed")
        try:
            if request.headers.get("Upgrade", "").lower() == "websocket":
                return await self._socket(request)
            return await self._request(request)
        except (aiohttp.ClientError, TimeoutError):
            return self._said(502, "Yamcs does not answer")
        except web.HTTPRequestEntityTooLarge:
            return self._said(413, "the request is too large")

    @staticmethod
    def _said(status: int, text: str) -> web.Response:
        return web.Response(status=status, text=f"{text}\n", headers=HEADERS)

    def _place(self, request: web.Request) -> URL:
        """The same place at Yamcs. The path stays as received."""
        return URL(self._yamcs + request.raw_path, encoded=True)

    async def _request(self, request: web.Request) -> web.StreamResponse:
        assert self._session is not None
        async with self._session.request(
                request.method, self._place(request), allow_redirects=False,
                headers={name: request.headers[name] for name in ASKED
                         if name in request.headers},
                data=await request.read() or None) as answer:
            headers = HEADERS | {
                name: answer.headers[name] for name in ANSWERED
                if name in answer.headers}
            if answer.content_type == "text/html":
                return await self._page(answer, headers)
            ours = web.StreamResponse(status=answer.status, headers=headers)
            await ours.prepare(request)
            try:
                async for part in answer.content.iter_chunked(PART):
                    await ours.write(part)
                await ours.write_eof()
            except (aiohttp.ClientError, TimeoutError):
                # Its head was sent: the rest must not look complete.
                if request.transport is not None:
                    request.transport.abort()
            return ours

    async def _page(self, answer: ClientResponse, headers: dict[str, str]
                    ) -> web.Response:
        """A page names Yamcs's own path; it is replaced by the public one."""
        text = b""
        async for part in answer.content.iter_chunked(PART):
            text += part
            if len(text) > LARGEST_PAGE:
                return self._said(502, "Yamcs's page is too large")
        headers.pop("Content-Length", None)
        return web.Response(
            status=answer.status, headers=headers,
            body=text.replace(self._path.encode(), b""))

    # WebSocket

    async def _socket(self, request: web.Request) -> web.StreamResponse:
        assert self._session is not None
        wanted = [word.strip() for word in request.headers.get(
            "Sec-WebSocket-Protocol", "").split(",") if word.strip()]
        async with self._session.ws_connect(
                self._place(request), protocols=wanted,
                max_msg_size=0) as theirs:
            ours = web.WebSocketResponse(
                protocols=[theirs.protocol] if theirs.protocol else [],
                max_msg_size=LARGEST_REQUEST, compress=False)
            await ours.prepare(request)
            copying = [asyncio.create_task(copy(theirs, ours)),
                       asyncio.create_task(copy(ours, theirs))]
            try:
                await asyncio.wait(copying,
                                   return_when=asyncio.FIRST_COMPLETED)
            finally:
                for task in copying:
                    task.cancel()
                await asyncio.gather(*copying, return_exceptions=True)
                with contextlib.suppress(ConnectionError, TimeoutError):
                    await asyncio.wait_for(ours.close(), 1.0)
            return ours


async def copy(source: Socket, to: Socket) -> None:
    """Copies until either of them closes. A slow receiver slows the sender."""
    with contextlib.suppress(aiohttp.ClientError, ConnectionError,
                             RuntimeError):
        async for message in source:
            if message.type == WSMsgType.TEXT:
                await to.send_str(message.data)
            elif message.type == WSMsgType.BINARY:
                await to.send_bytes(message.data)

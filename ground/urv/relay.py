# SPDX-License-Identifier: Apache-2.0
"""Good frame packets, over TCP to one client that keeps them (GND-30, SEC-13).

Yamcs connects here. Its own link over UDP accepts any sender at any address of
the machine, and loses packets when it is slow.

Yamcs sends nothing. A client that sends is another program, a browser for
example, and gets nothing.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections import deque
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Awaitable, Callable

WAITING = 15_000
"""Frames kept for a slow or future client: five minutes."""
STUCK_S = 20.0
SPEAKS_S = 0.2
"""A browser sends its request within this time after it has connected."""


async def at_once() -> None:
    """For clients that are ready at once."""


class Relay:
    """The frames not taken yet, and their client. After a connection it waits
    until the client is ready for them."""

    def __init__(self, ready: Callable[[], Awaitable[None]] = at_once) -> None:
        self._ready = ready
        self.lost = 0
        self.sent = 0
        self._frames: deque[bytes] = deque()
        self._came = asyncio.Event()
        self._taken = False

    def put(self, frame: bytes) -> None:
        """Adds a frame, in its order."""
        if len(self._frames) >= WAITING:
            self._frames.popleft()
            self.lost += 1
        self._frames.append(frame)
        self._came.set()

    async def serve(self, reader: asyncio.StreamReader,
                    writer: asyncio.StreamWriter) -> None:
        """One client after the other; a second one at a time is refused."""
        if self._taken:
            writer.transport.abort()
            return
        self._taken = True
        gone = asyncio.create_task(self._until_no_yamcs(reader))
        ready = asyncio.ensure_future(self._ready())
        try:
            await asyncio.wait({ready, gone},
                               return_when=asyncio.FIRST_COMPLETED)
            await asyncio.wait({gone}, timeout=SPEAKS_S)
            while not gone.done():
                while self._frames and not gone.done():
                    writer.write(self._frames[0])
                    await asyncio.wait_for(writer.drain(), STUCK_S)
                    self._frames.popleft()
                    self.sent += 1
                self._came.clear()
                came = asyncio.create_task(self._came.wait())
                await asyncio.wait({came, gone},
                                   return_when=asyncio.FIRST_COMPLETED)
                came.cancel()
        except (ConnectionError, TimeoutError):
            pass
        finally:
            self._taken = False
            gone.cancel()
            ready.cancel()
            writer.transport.abort()
            await asyncio.gather(gone, ready, return_exceptions=True)

    @staticmethod
    async def _until_no_yamcs(reader: asyncio.StreamReader) -> None:
        """Returns when the client has gone, or has sent something."""
        with contextlib.suppress(ConnectionError):
            await reader.read(1)

# SPDX-License-Identifier: Apache-2.0
"""The station's log in the archive of a Yamcs, as its events (GND-30).

Yamcs is another program: it may be slow, die or come later. Nobody waits for
it here. Its absence is an alert, and so is an archive that takes no frames
(GND-60). An event that it does not take costs that event and no other
(GND-57).

Yamcs is also told how far the clock of the ground's node is from this
machine's, so that it knows how old a frame is (GND-56).
"""

from __future__ import annotations

import asyncio
from collections import deque
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING

import aiohttp

from urv import input_files, packets

if TYPE_CHECKING:
    from urv.controls import Controls
    from urv.relay import Relay
    from urv.view import Line, View

INSTANCE = "urv"
LINK = "frames"
PROCESSOR = "realtime"
CLOCK = "URV/clock_ahead"
SEVERITY = {"info": "INFO", "caution": "WARNING", "warning": "CRITICAL"}
WAITING = 1000
PATIENCE = aiohttp.ClientTimeout(total=5.0)
LOOKS_S = 1.0
RUNNING_LOOKS_S = 0.2
REFUSALS = 5
"""An event that Yamcs has failed to take this many times is left out."""
CLOCK_US = 5_000
"""A clock that differs by less than this from what Yamcs knows is no news."""
LONGEST_ANSWER = 1_048_576
"""Bytes; Yamcs's have some hundred."""
STARTS_S = 30.0
"""Yamcs may take so long to start before its absence is an alert."""
STALLS_S = 15.0
"""Frames come and the archive has taken none for this time: it is an alert.
Its link looks for the station each 10 s."""
FRESH_S = 1.0
"""Frames come when the last one is no older."""
NO_ANSWER = (aiohttp.ClientError, TimeoutError, ValueError)
"""There is none, or it is none that is of use."""


@dataclass(frozen=True)
class Link:
    """The link by which Yamcs fetches frames."""

    count: int
    """Frames that it has taken since it started."""
    is_disabled: bool = False


class Taken:
    """Whether Yamcs takes the frames that come."""

    def __init__(self) -> None:
        self._count = -1
        self._since = 0.0

    def wrong(self, link: Link, age_s: float | None, now: float) -> str:
        """Why it takes none, or nothing. The age is that of the last frame,
        None before the first; now is a time of any clock, in s."""
        comes = age_s is not None and age_s <= FRESH_S
        if link.count != self._count or not comes:
            self._count, self._since = link.count, now
        if link.is_disabled:
            return "its link is disabled"
        waited = now - self._since
        if waited >= STALLS_S:
            return f"its count has not risen for {waited:.0f} s"
        return ""


class Archive:
    """Hands lines to Yamcs, in their order."""

    def __init__(self, url: str) -> None:
        self._url = url.rstrip("/")
        self._lines: deque[Line] = deque()
        self._dropped = 0
        self._refusals = 0
        self._clock_us: int | None = None
        self._taken = Taken()

    def take(self, line: Line) -> None:
        """A line that Yamcs shall have, when it can."""
        if len(self._lines) >= WAITING:
            self._lines.popleft()
            self._dropped += 1
        self._lines.append(line)

    async def run(self, view: View, controls: Controls,
                  relay: Relay | None) -> None:
        """Without end."""
        loop = asyncio.get_running_loop()
        began = loop.time()
        there = False
        async with aiohttp.ClientSession(timeout=PATIENCE) as session:
            while True:
                try:
                    if not await self._is_running(session):
                        raise ValueError("it starts, or has failed")
                    link = await self._link(session)
                    await self._tell_clock(session, view)
                    while self._lines:
                        await self._hand_over(session)
                except NO_ANSWER:
                    self._clock_us = None
                    controls.archive = {"text": "no Yamcs", "lost": True}
                    if there or loop.time() - began > STARTS_S:
                        view.alerts.report(
                            "archive", "caution", "ARCHIVE",
                            "Yamcs does not answer",
                            int(datetime.now(UTC).timestamp() * 1e6))
                else:
                    if not there and view.alerts.active("archive"):
                        view.note("info", "archive", "Yamcs answers again")
                    there = True
                    text = f"{link.count} frames"
                    for lost, what in ((self._dropped, "events"),
                                       (relay.lost if relay else 0,
                                        "frames")):
                        if lost:
                            text += f", {lost} {what} lost"
                    wrong = self._taken.wrong(link, view.age_s(view.now()),
                                              loop.time())
                    if wrong:
                        text += f", {wrong}"
                        view.alerts.report(
                            "archive frames", "caution", "ARCHIVE STOPPED",
                            f"Yamcs takes no frames: {wrong}",
                            int(datetime.now(UTC).timestamp() * 1e6))
                    else:
                        view.alerts.away("archive frames", view.now(), 0.0)
                    controls.archive = {"text": text, "lost": bool(wrong)}
                    view.alerts.away("archive", view.now(), 0.0)
                await asyncio.sleep(LOOKS_S)

    async def until_running(self) -> None:
        """Until all of Yamcs's services run. It connects and answers before:
        what it is given until then is in no archive."""
        async with aiohttp.ClientSession(timeout=PATIENCE) as session:
            while not await self._is_running(session):
                await asyncio.sleep(RUNNING_LOOKS_S)

    async def _is_running(self, session: aiohttp.ClientSession) -> bool:
        try:
            said = await self._get(session, f"instances/{INSTANCE}")
        except NO_ANSWER:
            return False
        return said.get("state") == "RUNNING"

    async def _link(self, session: aiohttp.ClientSession) -> Link:
        said = await self._get(session, f"links/{INSTANCE}/{LINK}")
        return Link(count_in(said), said.get("disabled") is True)

    async def _get(self, session: aiohttp.ClientSession, what: str) -> dict:
        async with session.get(f"{self._url}/api/{what}") as answer:
            answer.raise_for_status()
            data = b""
            async for part in answer.content.iter_any():
                data += part
                if len(data) > LONGEST_ANSWER:
                    raise ValueError("longer than any answer")
            return answer_in(data)

    async def _tell_clock(self, session: aiohttp.ClientSession,
                          view: View) -> None:
        """What is added to the time of a frame for this machine's UTC."""
        ahead_us = view.clock_ahead_us()
        if ahead_us is None or (
                self._clock_us is not None
                and abs(ahead_us - self._clock_us) < CLOCK_US):
            return
        async with session.put(
                f"{self._url}/api/processors/{INSTANCE}/{PROCESSOR}"
                f"/parameters/{CLOCK}",
                json={"type": "DOUBLE", "doubleValue": ahead_us / 1e6},
        ) as answer:
            if answer.status < 400:
                self._clock_us = ahead_us

    async def _hand_over(self, session: aiohttp.ClientSession) -> None:
        """The first line. One that Yamcs refuses, or fails at again and again,
        is counted and left out."""
        status = await self._post(session, self._lines[0])
        if status >= 500:
            self._refusals += 1
            if self._refusals < REFUSALS:
                raise ValueError(f"Yamcs answers {status}")
        self._dropped += status >= 400
        self._refusals = 0
        self._lines.popleft()

    async def _post(self, session: aiohttp.ClientSession,
                    line: Line) -> int:
        """The status of the answer."""
        at = datetime.fromtimestamp(
            min(max(line.time_us, 0), packets.LATEST_US) // 10**6, UTC)
        at = at.replace(microsecond=line.time_us % 10**6)
        async with session.post(
                f"{self._url}/api/archive/{INSTANCE}/events",
                json={"source": "station", "type": line.kind,
                      "message": line.text,
                      "severity": SEVERITY[line.level],
                      "sequenceNumber": line.number,
                      "time": at.isoformat().replace("+00:00", "Z")},
        ) as answer:
            return answer.status


def answer_in(data: bytes) -> dict:
    """What Yamcs says. Raises ValueError when that is no object of JSON."""
    said = input_files.parsed(data.decode("utf-8"))
    if not isinstance(said, dict):
        raise ValueError("no object")
    return said


def count_in(said: dict) -> int:
    """The frames of what Yamcs says about its link. Raises ValueError."""
    count = str(said.get("dataInCount", 0))
    if not (count.isascii() and count.isdigit() and len(count) < 20):
        raise ValueError("no count")
    return int(count)

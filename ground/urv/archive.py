# SPDX-License-Identifier: Apache-2.0
"""The station's log in the archive of a Yamcs, as its events (GND-30).

Yamcs is another program: it may be slow, die or start later. The station never
waits for it. Its absence is an alert, and so is an archive that takes no
frames (GND-60). An event that it does not take costs only that event (GND-57).

Yamcs also receives the difference between the clock of the ground's node and
this machine's, so that it knows the age of a frame (GND-56).
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
"""A clock is reported only when it differs by more than this from the last
report."""
LONGEST_ANSWER = 1_048_576
"""Bytes; an answer of Yamcs has some hundred."""
STARTS_S = 30.0
"""The time that Yamcs has to start before its absence is an alert."""
STALLS_S = 15.0
"""An alert is raised when frames arrive and the archive has taken none for
this time. Yamcs's link looks for the station each 10 s."""
FRESH_S = 1.0
"""Frames arrive if the last one is no older."""
NO_ANSWER = (aiohttp.ClientError, TimeoutError, ValueError)
"""There is no answer, or a useless one."""


@dataclass(frozen=True)
class Link:
    """The link by which Yamcs fetches frames."""

    count: int
    """The number of frames taken since its start."""
    is_disabled: bool = False


class Taken:
    """True if Yamcs takes the arriving frames."""

    def __init__(self) -> None:
        self._count = -1
        self._since = 0.0

    def wrong(self, link: Link, age_s: float | None, now: float) -> str:
        """The reason why it takes none, or an empty text. The age is that of
        the last frame, None before the first; now is a time of any clock, in
        s."""
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
    """Sends lines to Yamcs, in their order."""

    def __init__(self, url: str) -> None:
        self._url = url.rstrip("/")
        self._lines: deque[Line] = deque()
        self._dropped = 0
        self._refusals = 0
        self._clock_us: int | None = None
        self._taken = Taken()

    def take(self, line: Line) -> None:
        """Queues a line for Yamcs."""
        if len(self._lines) >= WAITING:
            self._lines.popleft()
            self._dropped += 1
        self._lines.append(line)

    async def run(self, view: View, controls: Controls,
                  relay: Relay | None) -> None:
        """Runs without end."""
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
        """Waits until all of Yamcs's services run. It accepts connections and
        answers before that, but archives nothing."""
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
        """Sends the difference between a frame's time and this machine's
        UTC."""
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
        """Sends the first line. If Yamcs refuses it, or fails at it
        repeatedly, it is counted and left out."""
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
    """The JSON object in Yamcs's answer. Raises ValueError for anything
    else."""
    said = input_files.parsed(data.decode("utf-8"))
    if not isinstance(said, dict):
        raise ValueError("no object")
    return said


def count_in(said: dict) -> int:
    """The number of frames in Yamcs's report about its link. Raises
    ValueError."""
    count = str(said.get("dataInCount", 0))
    if not (count.isascii() and count.isdigit() and len(count) < 20):
        raise ValueError("no count")
    return int(count)

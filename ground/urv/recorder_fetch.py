# SPDX-License-Identifier: Apache-2.0
"""Fetches rows of the aircraft's flight recorder over the link (FTI-10, FTI-13).

    with recorder_fetch.Node("udp:127.0.0.1:6004") as node:
        fetch = recorder_fetch.Fetch(node)
        fetch.run()
        fetch.missing(), fetch.reason

A fetch waits for the node: the station runs one in a thread.
"""

from __future__ import annotations

import secrets
import socket
import threading
import time
from collections.abc import Callable

from urv import faults, packets, recorder_blocks, station

ROWS_AT_ONCE = 100
"""Rows of one request: a lost one costs little."""

SILENCE_S = 1.0
"""Without a block for longer, the aircraft is asked again."""

QUIET_REQUESTS = 15
"""Requests without any block in answer, before the fetch is given up."""

MOST_WRONG = 4
"""A row that has come whole so often with wrong sums is wrong aboard."""

GAP = 3
"""Rows that are asked for once more, rather than with a request of their
own."""

FRAMES_PER_S = round(1 / packets.FRAME_S)


class Stopped(Exception):
    """The fetch was stopped from outside."""


class Node:
    """The ground's node: requests go to its console's port.

    Once `over` is set, both operations raise Stopped."""

    def __init__(self, console: str, over: threading.Event | None = None):
        self.console = console
        self.address = station.address("--console", console)
        self.sequence = 0
        self.over = over or threading.Event()

    def __enter__(self):
        self.run = secrets.randbits(32)
        self.socket, there = station.sender_to("--console", self.address)
        try:
            self.socket.connect(there)
        except OSError as fault:
            self.socket.close()
            raise faults.Refused(
                f"--console {self.console}: {faults.reason(fault)}"
            ) from fault
        return self

    def __exit__(self, *_):
        self.socket.close()

    def ask(self, first: int, many: int) -> None:
        """Sends a request."""
        self._look()
        self.sequence += 1
        try:
            self.socket.send(packets.RequestPacket(
                self.run, self.sequence, time.time_ns() // 1000,
                recorder_blocks.request(first, many)).encode())
        except ConnectionRefusedError as fault:
            raise faults.Failed(
                f"--console {self.console}: nothing listens there"
            ) from fault

    def block(self):
        """The next block, kind and words, or None after a silence."""
        self.socket.settimeout(SILENCE_S)
        while True:
            self._look()
            try:
                data = self.socket.recv(256)
            except TimeoutError:
                return None
            except ConnectionRefusedError as fault:
                raise faults.Failed(
                    f"--console {self.console}: nothing listens there"
                ) from fault
            try:
                return packets.decode_recorder(data)
            except packets.PacketError:
                continue

    def _look(self) -> None:
        if self.over.is_set():
            raise Stopped


class Fetch:
    """A fetch of all rows, or of the newest seconds only.

    rows may have those of an earlier fetch. They are kept if the aircraft still
    holds the same recording.
    """

    def __init__(self, node, last: float | None = None,
                 rows: recorder_blocks.Rows | None = None):
        self.node = node
        self.last = last
        self.rows = rows or recorder_blocks.Rows()
        self.first = self.end = 0
        """The wanted rows; 0 before they are known."""
        self.is_another = True
        """The recording is not that of the earlier rows."""
        self.reason = ""

    def missing(self) -> list[int]:
        """The wanted rows that have not come."""
        return self.rows.missing(self.first, self.end)

    def look(self) -> None:
        """Asks for the recorder's state. Raises faults.Failed without one."""
        before = self.rows.reports
        for _ in range(QUIET_REQUESTS):
            self._asked(0, 0)
            if self.rows.reports > before:
                break
        else:
            raise faults.Failed(
                "no answer: the link is lost, or the aircraft has no recorder")
        if self.rows.report.answer == 1:
            raise faults.Failed(f"refused: {recorder_blocks.ANSWERS[1]}")

    def run(self, begins: Callable[[int], None] = lambda _many: None) -> None:
        """Asks until no row is missing; reason says why one still is. Calls
        begins with the number of wanted rows before it asks for any."""
        self.look()
        report = self.rows.report
        end = report.first + report.held
        first = report.first
        if self.last is not None:
            first = max(first, end - max(1, round(self.last * FRAMES_PER_S)))
        begins(end - first)
        if self.rows.rows:
            self._recognise(end - 1)
        self.first, self.end = first, end
        self.reason = self._complete(first, end)

    def _recognise(self, newest: int) -> None:
        """Keeps earlier rows if the newest row is the same, with its tick."""
        earlier = self.rows
        self.rows = recorder_blocks.Rows()
        self.rows.report = earlier.report
        self._complete(newest, newest + 1)
        found = self.rows.rows.get(newest)
        if found is not None and found == earlier.rows.get(newest):
            self.rows, self.is_another = earlier, False

    def _complete(self, first: int, end: int) -> str:
        quiet = 0
        # The newest row first: it marks the recording.
        newest = [end - 1] if end > first else []
        while wanted := [
                number for number in newest + self.rows.missing(first, end)
                if number not in self.rows.rows
                and self.rows.wrong.get(number, 0) < MOST_WRONG]:
            begin, many = joined(recorder_blocks.spans(wanted))
            came = self._asked(begin, min(many, ROWS_AT_ONCE))
            report = self.rows.report
            if report.answer == 1:
                return recorder_blocks.ANSWERS[1]
            if report.first > begin:
                return "the aircraft does not hold them any more"
            if report.first + report.held < end:
                return "the aircraft had a cold start"
            quiet = 0 if came else quiet + 1
            if quiet == QUIET_REQUESTS:
                return "the aircraft does not answer any more"
        return ("their sums are wrong aboard"
                if self.rows.missing(first, end) else "")

    def _asked(self, first: int, many: int) -> int:
        """Asks for rows and takes what comes, until all have come or nothing
        more does. The number of blocks."""
        rows = self.rows
        before, blocks = rows.reports, 0
        self.node.ask(first, many)
        while found := self.node.block():
            rows.take(*found)
            blocks += 1
            if rows.reports > before and (
                    many == 0 or rows.report.answer != 0
                    or not rows.missing(first, first + many)):
                break
            if (found[0] == recorder_blocks.ROWS and many
                    and is_last(found[1], first + many - 1)):
                break
        return blocks


def is_last(words, number: int) -> bool:
    """The block is the last one of that row."""
    return (words[0] >> 10 == 3
            and (words[0] & 0x3FF) << 12 | words[1] == number)


def joined(spans) -> tuple[int, int]:
    """The first span with those that follow closely."""
    begin, many = spans[0]
    for first, more in spans[1:]:
        if not 0 <= first - begin - many <= GAP:
            break
        many = first + more - begin
    return begin, many


def named(numbers) -> str:
    """Numbers of rows as text."""
    spans = [f"{first}" if many == 1 else f"{first} to {first + many - 1}"
             for first, many in recorder_blocks.spans(numbers)]
    return ", ".join(spans[:5]) + (", ..." if len(spans) > 5 else "")

# SPDX-License-Identifier: Apache-2.0
"""Outputs of a flying program, which never waits for them (GND-53, D-56).

A thread writes each of them, from a bounded queue. Data without room are left
out and counted. An output that cannot be written is closed, and later data are
dropped; `lost` has the reason.

    kept = Output("--events", lambda: open(path, "ab", buffering=0))
    kept.put(b"a line\\n")
    kept.close()
"""

from __future__ import annotations

import contextlib
import os
import sys
import threading
import time
from collections import deque
from typing import TYPE_CHECKING

from urv import faults, whole_files

if TYPE_CHECKING:
    from collections.abc import Callable

ROOM = 1 << 20
"""Characters that wait for an output: a thousand lines and more."""
CLOSES_S = 3.0
"""At the end an output that accepts nothing for this time is lost."""


class Output:
    """Bytes on their way to a file."""

    def __init__(self, name: str, file: int, room: int = ROOM) -> None:
        self.name = name
        self.lost: str | None = None
        self.left_out = 0
        self._file = file
        self._waiting: deque[bytes] = deque()
        self._room = room
        self._is_over = False
        self._steps = 0
        self._changed = threading.Condition()
        # It may hang in a write, and must not delay the program's end.
        self._writer = threading.Thread(target=self._write, daemon=True)
        self._writer.start()

    @classmethod
    def of_file(cls, name: str, path: os.PathLike | str,
                mode: int = os.O_APPEND, room: int = ROOM) -> Output:
        """Opens it without following a link. Raises OSError."""
        return cls(name, whole_files.no_link(
            path, os.O_WRONLY | os.O_CREAT | os.O_CLOEXEC | mode), room)

    def put(self, data: bytes) -> None:
        """Never waits."""
        with self._changed:
            if self.lost is not None or len(data) > self._room:
                self.left_out += 1
                return
            self._room -= len(data)
            self._waiting.append(data)
            self._changed.notify()

    def close(self) -> None:
        """Writes the buffered bytes. An output that accepts nothing is
        lost."""
        with self._changed:
            self._is_over = True
            self._changed.notify()
        until, steps = time.monotonic() + CLOSES_S, self._steps
        while self._writer.is_alive() and time.monotonic() < until:
            self._writer.join(0.02)
            if self._steps != steps:
                until, steps = time.monotonic() + CLOSES_S, self._steps
        if self._writer.is_alive():
            self.lost = "it takes nothing"

    def problem(self) -> str | None:
        """The problem to report about it."""
        if self.lost is not None:
            return f"{self.name} cannot be written: {self.lost}"
        if self.left_out:
            return f"{self.name}: {self.left_out} lines left out, it is slow"
        return None

    def _write(self) -> None:
        while True:
            with self._changed:
                while not self._waiting and not self._is_over:
                    self._changed.wait()
                if not self._waiting:
                    break
                data = self._waiting.popleft()
            try:
                rest = memoryview(data)
                while rest:
                    rest = rest[os.write(self._file, rest):]
            except OSError as error:
                with self._changed:
                    self.lost = faults.reason(error)
                    self._waiting.clear()
                break
            with self._changed:
                self._room += len(data)
                self._steps += 1
        with contextlib.suppress(OSError):
            os.close(self._file)


class Terminal:
    """Standard output, for lines whose writer must not wait."""

    name = "standard output"

    def __init__(self) -> None:
        try:
            self._output = Output(self.name, os.dup(sys.stdout.fileno()))
        except (OSError, ValueError, AttributeError):
            self._output = None

    def say(self, text: str) -> None:
        if self._output is None:
            print(text)
        else:
            self._output.put(f"{text}\n".encode(errors="replace"))

    def close(self) -> None:
        if self._output is not None:
            self._output.close()

    def problem(self) -> str | None:
        return self._output and self._output.problem()

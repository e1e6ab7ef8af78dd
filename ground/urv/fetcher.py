# SPDX-License-Identifier: Apache-2.0
"""The flight recorder aboard, as a station knows it, and its fetch (FTI-13).

A thread of its own fetches, so that the station never waits for the aircraft
nor for the disk. It is the only writer of the state that pages see.
"""

from __future__ import annotations

import threading
import time
from collections import deque
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from urv import faults, recorder_fetch, recordings, whole_files
from urv.alerts import CAUTION, INFO

LOOKS_S = 0.5
"""Between two looks at the rows that are missing."""
KEEPS_S = 60.0
"""Between two writes of the file during a fetch."""
ENDS_S = 3.0
"""The time that a station waits at its end for the file."""
AT_WORK = ("asking", "fetching")


@dataclass(frozen=True)
class State:
    """The recorder aboard, and the fetch of its rows."""

    state: str = "none"
    """none, asking, known, fetching, complete, gaps, stopped or failed."""
    text: str = ""
    """The reason of the last end that was not complete."""
    held: int | None = None
    """Rows aboard, by the last answer."""
    length: int | None = None
    """Rows that the recorder has room for."""
    wanted: int = 0
    """Rows of this fetch, and those of them that have come."""
    fetched: int = 0
    missing: str = ""
    """The missing rows by number, after an end."""
    rate: float = 0.0
    """Rows a second."""
    file: str = ""
    """The name of the recording at the ground."""


class _Watched(recorder_fetch.Node):
    """A node that calls look after each block and each silence."""

    look = staticmethod(lambda: None)

    def block(self):
        found = super().block()
        self.look()
        return found


class Fetcher:
    """Carries out what pages want of the recorder.

    console is the address of the ground's node; without it nothing is fetched.
    folder is for recordings.
    """

    def __init__(self, console: str | None, folder: Path) -> None:
        self.now = State()
        self.said: deque[tuple[str, str]] = deque()
        """Events that the station has not logged yet."""
        self._console = console
        self._folder = folder
        self._rows = None
        self._path: Path | None = None
        self._over = threading.Event()
        self._thread: threading.Thread | None = None

    @property
    def can(self) -> bool:
        return self._console is not None

    @property
    def is_busy(self) -> bool:
        return self._thread is not None and self._thread.is_alive()

    def ask(self) -> None:
        """Asks the aircraft for the state of its recorder."""
        self._begin(None, False)

    def fetch(self, last: float | None) -> None:
        """Fetches all missing rows, or those of the newest seconds."""
        self._begin(last, True)

    def stop(self) -> None:
        """Ends a fetch; its rows are kept, in the file, too."""
        self._over.set()

    def close(self) -> None:
        """The station ends."""
        self.stop()
        if self._thread is not None:
            self._thread.join(ENDS_S)

    def shown(self) -> dict[str, Any]:
        """For pages."""
        return vars(self.now) | {
            "can": self.can, "busy": self.now.state in AT_WORK}

    def _begin(self, last: float | None, is_fetch: bool) -> None:
        if not self.can or self.is_busy:
            return
        self._over.clear()
        self.now = replace(self.now, state="asking", text="", missing="",
                           rate=0.0, file="" if is_fetch else self.now.file)
        # It may wait for the disk, and must not delay the station's end.
        self._thread = threading.Thread(
            target=self._work, args=(last, is_fetch), daemon=True)
        self._thread.start()

    def _work(self, last: float | None, is_fetch: bool) -> None:
        try:
            with _Watched(self._console, self._over) as node:
                fetch = recorder_fetch.Fetch(node, last, self._rows)
                if is_fetch:
                    self._fetch(node, fetch)
                else:
                    fetch.look()
                    self._knows(fetch)
                    self.now = replace(self.now, state="known")
        except recorder_fetch.Stopped:
            self.now = replace(self.now, state="stopped")
            self.said.append((INFO, f"stopped, {self.now.fetched} of"
                              f" {self.now.wanted} rows"))
        except (faults.Failed, faults.Refused) as fault:
            self._fails(str(fault))
        except Exception as error:  # noqa: BLE001 - a state must be shown
            self._fails(f"{type(error).__name__}: {error}")

    def _fetch(self, node: _Watched, fetch: recorder_fetch.Fetch) -> None:
        began = looked = kept = time.monotonic()
        before = None

        def look() -> None:
            nonlocal looked, kept, before
            now = time.monotonic()
            if not fetch.end or now - looked < LOOKS_S:
                return
            looked = now
            self._knows(fetch)
            if before is None:
                before = self.now.fetched
            self.now = replace(
                self.now, state="fetching",
                rate=(self.now.fetched - before) / max(now - began, LOOKS_S))
            if now - kept > KEEPS_S:
                kept = now
                self._write(fetch)

        node.look = look
        self.said.append((INFO, "fetch begins"))
        try:
            fetch.run()
        finally:
            if fetch.end:
                self._rows = fetch.rows
                self._knows(fetch)
                self._write(fetch)
        missing = fetch.missing()
        count = f"{self.now.fetched} of {self.now.wanted} rows"
        if missing:
            self.now = replace(
                self.now, state="gaps", text=fetch.reason,
                missing=recorder_fetch.named(missing))
            self.said.append((CAUTION, f"{count}, missing"
                              f" {self.now.missing}: {fetch.reason}"))
        else:
            self.now = replace(self.now, state="complete")
            self.said.append((INFO, f"{count}, complete: {self.now.file}"))

    def _knows(self, fetch: recorder_fetch.Fetch) -> None:
        report = fetch.rows.report
        wanted = fetch.end - fetch.first
        self.now = replace(
            self.now, held=report.held, length=report.length, wanted=wanted,
            fetched=wanted - len(fetch.missing()))

    def _write(self, fetch: recorder_fetch.Fetch) -> None:
        """A recording has one file, which each fetch of it replaces."""
        if not fetch.rows.rows:
            return
        if self._path is None or fetch.is_another:
            self._path = self._folder / time.strftime(
                f"flight-%Y%m%d-%H%M%S{recordings.KIND}", time.gmtime())
            fetch.is_another = False
        with whole_files.replacing(self._path) as path:
            recordings.write(path, fetch.rows.in_order())
        self.now = replace(self.now, file=self._path.name)

    def _fails(self, reason: str) -> None:
        self.now = replace(self.now, state="failed", text=reason)
        self.said.append((CAUTION, reason))

# SPDX-License-Identifier: Apache-2.0
"""A progress bar for work of more than two seconds (GND-10).

    with progress.bar("reading") as told:
        ...
        told(record)        the record has a size and a position

It is drawn on standard error when that is a terminal, and removed at the end.
"""

import sys
import time
from contextlib import contextmanager

BEFORE_IT_IS_SHOWN_S = 2.0


class _Bar:
    """Draws nothing before its time."""

    def __init__(self, what):
        self.what = what
        self.began = time.monotonic()
        self.shown = None
        self.task = None

    def __call__(self, record):
        if self.shown is None:
            if time.monotonic() - self.began < BEFORE_IT_IS_SHOWN_S:
                return
            from rich.console import Console
            from rich.progress import Progress
            self.shown = Progress(console=Console(stderr=True),
                                  transient=True)
            self.shown.start()
            self.task = self.shown.add_task(self.what)
        self.shown.update(self.task, total=record.size,
                          completed=record.position)

    def close(self):
        if self.shown is not None:
            self.shown.stop()


@contextmanager
def bar(what):
    """A bar for that work; the result takes an object with a position."""
    if not sys.stderr.isatty():
        yield lambda record: None
        return
    shown = _Bar(what)
    try:
        yield shown
    finally:
        shown.close()

# SPDX-License-Identifier: Apache-2.0
"""Reports of commands that cannot do their work (GND-10).

One line on standard error and an exit status, like those of bin/urv_sim. Text
from files or the user is shown by `quoted` only: none of its control
characters reaches a terminal.
"""

import contextlib
import sys


class Refused(Exception):
    """Bad command line or bad input: exit status 2."""

    status = 2


class Failed(Exception):
    """A valid request that still cannot be done: exit status 1."""

    status = 1


class Unheard(Failed):
    """The work was done, but the link carried nothing: exit status 3."""

    status = 3


def note(text):
    """Prints a line for people during a command; a failed write is ignored."""
    with contextlib.suppress(OSError, ValueError):
        print(f"urv: {text}", file=sys.stderr, flush=True)


def note_cut_short(path, what):
    """Notes what a record that was cut short lacks, if it was."""
    if what:
        note(f"{quoted(path)} was cut short: {what}")


def quoted(text):
    """A name or a value as messages show it, on one line."""
    shown = "".join(
        letter if letter.isprintable() else ascii(letter)[1:-1]
        for letter in str(text))
    if len(shown) > 120:
        shown = f"{shown[:120]}..."
    return f'"{shown}"'


def reason(fault):
    """The system's reason of an OSError, without its number."""
    return fault.strerror or str(fault)

# SPDX-License-Identifier: Apache-2.0
"""What a command ends with when it cannot do what it was asked (GND-10).

One line on standard error and an exit status, as bin/urv_sim has them. What
is read or typed is shown by `quoted` only: no control character of it gets to
a terminal.
"""

import contextlib
import sys


class Refused(Exception):
    """Bad command line or bad input: exit status 2."""

    status = 2


class Failed(Exception):
    """It was asked well and still cannot be done: exit status 1."""

    status = 1


class Unheard(Failed):
    """It was done, and the link carried nothing: exit status 3."""

    status = 3


def note(text):
    """A line for people, beside what a command does, should anybody read
    it."""
    with contextlib.suppress(OSError, ValueError):
        print(f"urv: {text}", file=sys.stderr, flush=True)


def quoted(text):
    """A name or a value as messages show it, on one line."""
    shown = "".join(
        letter if letter.isprintable() else ascii(letter)[1:-1]
        for letter in str(text))
    if len(shown) > 120:
        shown = f"{shown[:120]}..."
    return f'"{shown}"'


def reason(fault):
    """What the system says of an OSError, without its number."""
    return fault.strerror or str(fault)

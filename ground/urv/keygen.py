# SPDX-License-Identifier: Apache-2.0
"""bin/urv keygen: a key of the sealed link in a file of its own (SEC-5).

The key is drawn from the operating system's source of random numbers. The
file is its owner's alone from the first moment; an old one is not touched
unless a key is to be added to it.
"""

import os
import re
import stat
from pathlib import Path
from typing import Annotated

import typer

from urv import faults

KEY_BYTES = 16
MODE = 0o600
_LINE = re.compile(r"key\s+(\d{1,3})\s+[0-9a-fA-F]{32}\s*(#.*)?")


def keygen(
    file: Annotated[Path, typer.Argument(
        metavar="FILE", help="Where to write it.")],
    number: Annotated[int | None, typer.Option(
        metavar="N", min=0, max=255,
        help="Its number, 0 to 255. [default: 1, or the next]")] = None,
    add: Annotated[bool, typer.Option(
        "--add", help="Put it before the key that is in the file.")] = False,
):
    """Make a key of the sealed link.

    With --add the file then has two: the new one, to call with, and the old,
    which is good until it is taken out.
    """
    old = _old_keys(file) if add else []
    if number is None:
        number = (old[0][0] + 1) % 256 if old else 1
    if old and old[0][0] == number:
        raise faults.Refused(
            f"{faults.quoted(file)}: the key that is there has the number"
            f" {number}, too")
    lines = ["# Keys of the sealed link. Whoever reads this flies the"
             " aircraft.",
             f"key {number} {os.urandom(KEY_BYTES).hex()}",
             *(line for _, line in old[:1])]
    if add:
        made = file.with_name(f".{file.name}.new")
        _write(made, lines)
        os.replace(made, file)
    else:
        _write(file, lines)
    print(f"{file}: key {number}"
          + (f", and key {old[0][0]} as before" if old else ""))


def _old_keys(file: Path) -> list[tuple[int, str]]:
    """The number and the line of each key in a file."""
    try:
        if stat.S_IMODE(file.stat().st_mode) != MODE:
            raise faults.Refused(
                f"{faults.quoted(file)} has not the mode 0600")
        lines = file.read_text("ascii").splitlines()
    except (OSError, UnicodeDecodeError) as fault:
        said = (faults.reason(fault) if isinstance(fault, OSError)
                else "it is not text")
        raise faults.Refused(
            f"{faults.quoted(file)} cannot be read: {said}") from None
    found = []
    for place, line in enumerate(lines, 1):
        line = line.strip()
        if line and not line.startswith("#"):
            key = _LINE.fullmatch(line)
            if not key:
                raise faults.Refused(f"{file}:{place}: this is no key")
            found.append((int(key[1]), line))
    if not found:
        raise faults.Refused(f"{faults.quoted(file)} has no key")
    return found


def _write(file: Path, lines: list[str]):
    """A new file, which nobody else can read at any time."""
    try:
        made = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, MODE)
        with os.fdopen(made, "w", encoding="ascii") as out:
            os.fchmod(made, MODE)
            out.write("\n".join(lines) + "\n")
            out.flush()
            os.fsync(made)
    except FileExistsError:
        raise faults.Refused(
            f"{faults.quoted(file)} is there already; it is not replaced"
        ) from None
    except OSError as fault:
        raise faults.Failed(
            f"{faults.quoted(file)} cannot be written:"
            f" {faults.reason(fault)}") from fault

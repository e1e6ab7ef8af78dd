# SPDX-License-Identifier: Apache-2.0
"""bin/urv keygen: a key of the sealed link in a file of its own (SEC-5,
SEC-14).

The key is drawn from the operating system's random number source. Only the
owner can access the file from the first moment; an existing file does not
change unless a key is added to it.
"""

import os
import re
import stat
from pathlib import Path
from typing import Annotated

import typer

from urv import faults, input_files, whole_files

KEY_BYTES = 16
MODE = 0o600
LONGEST = 4095
"""The largest size of a file of keys, in bytes, as for the nodes."""
LONGEST_REMARK = 1000
"""The largest kept text after a key, in characters."""
_LINE = re.compile(
    r"key[ \t]+([0-9]{1,3})[ \t]+([0-9a-fA-F]{32})[ \t]*(#[^\r]*)?")


def keygen(
    file: Annotated[Path, typer.Argument(
        metavar="FILE", help="The file to write.")],
    number: Annotated[int | None, typer.Option(
        metavar="N", min=0, max=255,
        help="Its number, 0 to 255. [default: 1, or the next]")] = None,
    add: Annotated[bool, typer.Option(
        "--add", help="Put it before the key that is in the file.")] = False,
):
    """Make a key of the sealed link.

    With --add the file then has two: the new one, used for calling, and the
    old one, which is valid until it is removed. A file has two at most: the
    oldest is removed, and named.
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
    text = "\n".join(lines) + "\n"
    if add:
        with whole_files.replacing(file, MODE) as path:
            write(os.open(path, os.O_WRONLY), text)
    else:
        make(file, text)
    print(f"{faults.quoted(file)}: key {number}"
          + (f", and key {old[0][0]} as before" if old else "")
          + "".join(f"; key {gone} is removed" for gone, _ in old[1:]))


def _old_keys(file: Path) -> list[tuple[int, str]]:
    """The number and the line of each key in a file."""
    with input_files.opened(file) as read:
        if stat.S_IMODE(os.fstat(read.fileno()).st_mode) != MODE:
            raise faults.Refused(
                f"{faults.quoted(file)} does not have mode 0600:"
                " chmod 600 gives it")
        data = read.read(LONGEST + 1)
    if len(data) > LONGEST or not data.isascii():
        raise faults.Refused(f"{faults.quoted(file)} is not a file of keys")
    found = []
    for place, line in enumerate(data.decode("ascii").split("\n"), 1):
        line = line.removesuffix("\r").strip(" \t")
        if line and not line.startswith("#"):
            key = _LINE.fullmatch(line)
            if not key or int(key[1]) > 255:
                raise faults.Refused(
                    f"{faults.quoted(file)[1:-1]}:{place}: this is not a key")
            found.append((int(key[1]), " ".join(
                ("key", key[1], key[2],
                 (key[3] or "")[:LONGEST_REMARK])).rstrip()))
    if not found:
        raise faults.Refused(f"{faults.quoted(file)} has no key")
    return found


def make(file: Path, text: str):
    """Makes a new file, which no other user can read at any time. If it cannot
    be written whole it is removed."""
    try:
        made = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, MODE)
        try:
            write(made, text)
        except OSError:
            os.unlink(file)
            raise
    except FileExistsError:
        raise faults.Refused(
            f"{faults.quoted(file)} is there already; it is not replaced"
        ) from None
    except OSError as fault:
        raise faults.Failed(
            f"{faults.quoted(file)} cannot be written:"
            f" {faults.reason(fault)}") from fault


def write(made: int, text: str):
    """Writes to a descriptor, closes it, and syncs the disk."""
    with os.fdopen(made, "w", encoding="ascii") as out:
        os.fchmod(made, MODE)
        out.write(text)
        out.flush()
        os.fsync(made)

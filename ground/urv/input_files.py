# SPDX-License-Identifier: Apache-2.0
"""Input files from any source (SEC-14, D-65).

    with input_files.opened(path) as file:
        file.read(...)

Only regular files are read: a pipe or a device may never end, or block for
ever. A command that reads foreign files calls `limit_memory` first. Each reader
has its own limits; this one covers the remaining cases, such as a Parquet page
that claims to be 2 GB long.
"""

import io
import json
import math
import os
import re
import resource
import stat

from urv import faults

MOST_MEMORY = 2 ** 30
"""Bytes in addition to those of the program before it reads."""

LARGEST_JSON = 16 * 2 ** 20
"""Bytes; a summary and the events of a flight are some kB."""

LARGEST_INTEGER = 2 ** 53


def opened(path):
    """The file, open for reading bytes. Refuses anything but a regular
    file."""
    try:
        # Without O_NONBLOCK a pipe without a writer would block.
        number = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_NOCTTY
                         | os.O_CLOEXEC)
    except OSError as fault:
        raise faults.Refused(f"{faults.quoted(path)} cannot be read:"
                             f" {faults.reason(fault)}") from fault
    mode = os.fstat(number).st_mode
    if not stat.S_ISREG(mode):
        os.close(number)
        raise faults.Refused(
            f"{faults.quoted(path)} is a folder" if stat.S_ISDIR(mode)
            else f"{faults.quoted(path)} is not a regular file")
    return open(number, "rb")


def opened_text(path):
    """The same as text; only line feeds end its lines."""
    return io.TextIOWrapper(opened(path), encoding="utf-8", newline="\n")


def opened_typed(path):
    """The same for a file that a person has written: some editors and
    spreadsheets begin UTF-8 with a byte order mark."""
    return io.TextIOWrapper(opened(path), encoding="utf-8-sig", newline="\n")


def opened_ascii(path):
    """The same as ASCII; each other byte is a character that no line has."""
    return io.TextIOWrapper(opened(path), encoding="ascii", errors="replace",
                            newline="\n")


def text(path):
    """All of a file of JSON. Refuses a file that is too large."""
    with opened(path) as file:
        read = file.read(LARGEST_JSON + 1)
    if len(read) > LARGEST_JSON:
        raise faults.Refused(f"{faults.quoted(path)} is larger than"
                             f" {LARGEST_JSON} bytes")
    try:
        return read.decode("utf-8-sig")
    except UnicodeDecodeError as fault:
        raise faults.Refused(f"{faults.quoted(path)}: not a text file"
                             ) from fault


def parsed(text):
    """The value of a JSON text. Raises ValueError for invalid JSON, for deep
    nesting, and for numbers that are not finite or whole numbers beyond
    2**53."""

    def finite(digits):
        if not math.isfinite(float(digits)):
            raise ValueError(f"{digits[:20]} is not a number")
        return float(digits)

    def whole(digits):
        if len(digits) > 17 or abs(int(digits)) > LARGEST_INTEGER:
            raise ValueError(f"{digits[:20]} is too large")
        return int(digits)

    try:
        return json.loads(text, parse_float=finite, parse_int=whole,
                          parse_constant=finite)
    except RecursionError as fault:
        raise ValueError("nested too deeply") from fault


def limit_memory():
    """Limits the additional memory of this process; beyond it there is a
    MemoryError. To be called before Arrow is imported. Returns the limits
    before."""
    # Arrow's own allocator reserves 1 GB at once if it can.
    os.environ["ARROW_DEFAULT_MEMORY_POOL"] = "system"
    with open("/proc/self/status", encoding="ascii") as file:
        used = re.search(r"VmData:\s+(\d+) kB", file.read())
    most = int(used[1]) * 1024 + MOST_MEMORY
    soft, hard = resource.getrlimit(resource.RLIMIT_DATA)
    least = min(limit for limit in (soft, hard, most)
                if limit != resource.RLIM_INFINITY)
    resource.setrlimit(resource.RLIMIT_DATA, (least, hard))
    return soft, hard

# SPDX-License-Identifier: Apache-2.0
"""Output files that are complete or not there (GND-15).

    with whole_files.replacing(target) as path:
        path.write_text(...)

What was under the name stays until the new file is complete. Where the file
system can, the new file has no name until then, so that a killed program
leaves nothing. Elsewhere it is .NAME.PID.part, and the next run removes those
of programs that have ended.
"""

import os
import re
import stat
from contextlib import contextmanager
from pathlib import Path

from urv import faults


@contextmanager
def replacing(target):
    """The path to write to. Raises faults.Failed when the file cannot be
    written. Devices and pipes are written in place."""
    named, target = target, Path(os.path.realpath(target))
    try:
        if not _can_be_replaced(target):
            yield target
            return
        _remove_abandoned(target)
        file = _nameless(target.parent)
        if file is None:
            with _named(target) as path:
                yield path
        else:
            with _closing(file):
                path = Path(f"/proc/self/fd/{file}")
                yield path
                _give_name(file, target)
    except OSError as fault:
        raise faults.Failed(f"{faults.quoted(named)} cannot be written:"
                            f" {faults.reason(fault)}") from fault


def _can_be_replaced(target):
    try:
        return stat.S_ISREG(target.stat().st_mode)
    except FileNotFoundError:
        return True


def _part(target, number):
    """Of a long name only so much that the whole fits."""
    name = os.fsdecode(os.fsencode(target.name)[:200])
    return target.with_name(f".{name}.{number}.part")


def _remove_abandoned(target):
    pattern = re.compile(
        re.escape(_part(target, "PID").name).replace("PID", "([0-9]+)"))
    for path in target.parent.iterdir():
        found = pattern.fullmatch(path.name)
        if found and not Path(f"/proc/{found[1]}").exists():
            path.unlink(missing_ok=True)


def _nameless(folder):
    """A file without a name in that folder; nothing where there are none."""
    try:
        return os.open(folder, os.O_TMPFILE | os.O_RDWR, 0o666)
    except (AttributeError, OSError):
        return None


@contextmanager
def _closing(file):
    try:
        yield
    finally:
        os.close(file)


def _give_name(file, target):
    """A link cannot replace a file, so it is made beside it and renamed."""
    part = _part(target, os.getpid())
    part.unlink(missing_ok=True)
    folder = os.open(target.parent, os.O_RDONLY | os.O_DIRECTORY)
    # With a folder's descriptor Python follows the link, without it does not.
    with _closing(folder):
        os.link(f"/proc/self/fd/{file}", part.name, dst_dir_fd=folder)
    os.replace(part, target)


@contextmanager
def _named(target):
    part = _part(target, os.getpid())
    try:
        yield part
        os.replace(part, target)
    finally:
        part.unlink(missing_ok=True)

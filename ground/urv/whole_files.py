# SPDX-License-Identifier: Apache-2.0
"""Output files that are complete or absent (GND-15, SEC-15, D-66).

    with whole_files.replacing(target) as path:
        path.write_text(...)

The old file stays until the new one is complete. If the file system allows it,
the new file has no name until then, so that a killed program leaves nothing.
Elsewhere it is .NAME.PID.TOKEN.part, where TOKEN cannot be guessed, and the
next run removes those of programs that have ended.

An output whose name is a symbolic link is refused: in a folder that others may
write to, a link could lead to any file of the user. The names of the program's
own descriptors, /dev/stdout and the like, are no such links.
"""

import errno
import os
import re
import secrets
import stat
from contextlib import contextmanager, suppress
from pathlib import Path

from urv import faults

OWN_DESCRIPTOR = re.compile(
    r"/dev/(stdout|stderr|fd/[0-9]+)|/proc/self/fd/[0-9]+")

IS_LINK = "is a symbolic link; an output must be a file"


@contextmanager
def replacing(target, mode=0o666):
    """The path to write to. Raises faults.Failed when the file cannot be
    written. Devices and pipes are written in place. The new file has the mode
    from the first moment, less the process's umask."""
    refuse_link(target)
    named, target = target, Path(target)
    try:
        if not _can_be_replaced(target):
            yield target
            return
        _remove_abandoned(target)
        file = _nameless(target.parent, mode)
        if file is None:
            with _named(target, mode) as path:
                yield path
        else:
            with _closing(file):
                path = Path(f"/proc/self/fd/{file}")
                yield path
                _give_name(file, target)
    except OSError as fault:
        raise faults.Failed(f"{faults.quoted(named)} cannot be written:"
                            f" {faults.reason(fault)}") from fault


def check(target):
    """Raises faults.Refused or faults.Failed if `replacing` could not write the
    file now: to be called before long work."""
    refuse_link(target)
    path = Path(target)
    try:
        if path.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR))
        if _can_be_replaced(path):
            part = _part(path, os.getpid())
            os.close(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL
                             | os.O_NOFOLLOW, 0o600))
            part.unlink()
    except OSError as fault:
        raise faults.Failed(f"{faults.quoted(target)} cannot be written:"
                            f" {faults.reason(fault)}") from fault


def check_distinct(outputs, inputs):
    """Raises faults.Refused if an output has the file of an input or of another
    output. Both map names of the command line to paths, or to None. Devices and
    the program's own descriptors keep nothing, so they may come twice."""
    outputs = [(name, path) for name, path in outputs.items() if path]
    others = [(name, path) for name, path in inputs.items() if path]
    for name, path in outputs:
        for other, its_path in others:
            if same_file(path, its_path):
                raise faults.Refused(f"{other} and {name} name the same file:"
                                     f" {faults.quoted(path)}")
        others.append((name, path))


def refuse_link(path):
    """Raises an error if an output is a symbolic link."""
    if (not OWN_DESCRIPTOR.fullmatch(os.fspath(path))
            and Path(path).is_symlink()):
        raise faults.Refused(f"{faults.quoted(path)} {IS_LINK}")


def no_link(path, flags):
    """An opener for open(), for outputs that are written in place. It follows
    no link, even one that was made a moment ago."""
    if not OWN_DESCRIPTOR.fullmatch(os.fspath(path)):
        flags |= os.O_NOFOLLOW
    return os.open(path, flags, 0o666)


def same_file(left, right):
    """True if both paths lead to one file, which may not exist yet. Devices
    are never the same."""
    left, right = Path(left), Path(right)
    if left.exists() and right.exists():
        return _can_be_replaced(left) and left.samefile(right)
    return left.resolve() == right.resolve()


def _can_be_replaced(target):
    if OWN_DESCRIPTOR.fullmatch(str(target)):
        return False
    try:
        return stat.S_ISREG(target.stat().st_mode)
    except FileNotFoundError:
        return True


def _part(target, number):
    """As much of a long name as fits; the token cannot be guessed."""
    name = os.fsdecode(os.fsencode(target.name)[:180])
    return target.with_name(
        f".{name}.{number}.{secrets.token_hex(8)}.part")


def _remove_abandoned(target):
    name = os.fsdecode(os.fsencode(target.name)[:180])
    pattern = re.compile(
        re.escape(f".{name}.") + r"([0-9]+)(\.[0-9a-f]{16})?\.part")
    for path in target.parent.iterdir():
        found = pattern.fullmatch(path.name)
        if found and not Path(f"/proc/{found[1]}").exists():
            # A file of another user must stay.
            with suppress(OSError):
                path.unlink()


def _nameless(folder, mode):
    """A nameless file in that folder; None where the system has none."""
    try:
        return os.open(folder, os.O_TMPFILE | os.O_RDWR, mode)
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
    folder = os.open(target.parent, os.O_RDONLY | os.O_DIRECTORY)
    # With a folder's descriptor Python follows the link, without it does not.
    with _closing(folder):
        os.link(f"/proc/self/fd/{file}", part.name, dst_dir_fd=folder)
    os.replace(part, target)


@contextmanager
def _named(target, mode):
    part = _part(target, os.getpid())
    file = os.open(part, os.O_RDWR | os.O_CREAT | os.O_EXCL | os.O_NOFOLLOW,
                   mode)
    try:
        with _closing(file):
            yield Path(f"/proc/self/fd/{file}")
        os.replace(part, target)
    finally:
        part.unlink(missing_ok=True)

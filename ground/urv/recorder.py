# SPDX-License-Identifier: Apache-2.0
"""bin/urv recorder: the rows of the aircraft's flight recorder (FTI-10)."""

import contextlib
import os
import tempfile
from pathlib import Path
from typing import Annotated, Optional

import typer

app = typer.Typer(help="Fetch the aircraft's flight recorder.")

OUT = Annotated[Path, typer.Argument(
    metavar="FILE", help="The recording to write, FILE.recording.")]

@app.command()
def fetch(
    file: OUT,
    console: Annotated[str, typer.Option(
        metavar="udp:HOST:PORT", help="As of urv_gsc --console.")
    ] = "udp:127.0.0.1:6004",
    last: Annotated[Optional[float], typer.Option(
        min=0.02, metavar="S", help="Only the newest seconds.")] = None,
):
    """Fetch the recorder's rows from an aircraft on the ground.

    Status 0: all rows have come. Status 1: some are missing; FILE has the
    others, and the missing ones are named. An interrupted fetch keeps its rows,
    too. If FILE cannot be written at the end, another file has them, which the
    error names."""
    from urv import faults, recorder_fetch, whole_files

    check_name(file)
    whole_files.check(file)
    ended = None
    with recorder_fetch.Node(console) as node:
        made = recorder_fetch.Fetch(node, last)
        try:
            made.run(lambda many: check_room(file, many))
        except (faults.Failed, OSError, KeyboardInterrupt) as fault:
            # The rows that have come are kept.
            ended = fault
    if ended is not None and not made.rows.rows:
        raise ended
    keep(file, made.rows.in_order())
    missing = made.missing()
    print(f"{made.end - made.first - len(missing)} of {made.end - made.first}"
          f" rows fetched, {made.first} to {made.end - 1}", flush=True)
    if isinstance(ended, KeyboardInterrupt):
        faults.note(lacking(missing, "interrupted"))
        raise ended
    if missing:
        raise faults.Failed(lacking(missing, ended or made.reason))


def check_room(file, many):
    """Raises faults.Failed if the file's disk has no room for these rows: a
    fetch of all takes most of an hour."""
    from urv import faults, recordings

    wanted = recordings.size_of(many)
    disk = os.statvfs(file.parent)
    free = disk.f_bavail * disk.f_frsize
    if free < wanted:
        raise faults.Failed(
            f"{faults.quoted(file)}: its disk has room for {free:,} bytes, the"
            f" recording has {wanted:,}")


def keep(file, rows):
    """Writes the rows to the file. If that fails, writes them to a new one in
    the folder of temporary files, and raises faults.Failed with its name."""
    from urv import faults, recordings, whole_files

    try:
        with whole_files.replacing(file) as path:
            recordings.write(path, rows)
    except faults.Failed as fault:
        raise faults.Failed(f"{fault}; {kept_elsewhere(file, rows)}"
                            ) from fault


def kept_elsewhere(file, rows):
    """Where the rows are now, in words."""
    from urv import faults, recordings

    path = None
    try:
        number, path = tempfile.mkstemp(
            recordings.KIND, f"{file.stem[:100]}-")
        os.close(number)
        recordings.write(Path(path), rows)
    except OSError as fault:
        if path is not None:
            with contextlib.suppress(OSError):
                os.unlink(path)
        return (f"the {len(rows)} fetched rows are lost, since"
                f" {faults.quoted(path or 'the folder of temporary files')}"
                f" cannot be written: {faults.reason(fault)}")
    return f"the {len(rows)} fetched rows are in {faults.quoted(path)}"


def lacking(missing, reason):
    from urv import recorder_fetch

    return (f"{len(missing)} rows are missing"
            f" ({recorder_fetch.named(missing)}): {reason}")


@app.command()
def read(
    blocks: Annotated[Path, typer.Argument(
        metavar="BLOCKS", help="As written by urv_sim --fetched.")],
    file: OUT,
):
    """Make a recording of the blocks of a simulated flight.

    They came down in it: urv_sim fly --fetched FILE."""
    from urv import faults, input_files, recorder_blocks, recordings, \
        whole_files

    check_name(file)
    whole_files.check_distinct({"FILE": file}, {"BLOCKS": blocks})
    rows = recorder_blocks.Rows()
    with input_files.opened_ascii(blocks) as source:
        while line := source.readline(4 * (recorder_blocks.BLOCK_WORDS + 1)
                                      + 2):
            try:
                kind, *words = (int(line[at:at + 4], 16) for at
                                in range(0, len(line.rstrip("\n")), 4))
            except ValueError as fault:
                raise faults.Refused(
                    f"{faults.quoted(blocks)}: not a file of --fetched"
                ) from fault
            rows.take(kind, words)
    with whole_files.replacing(file) as path:
        recordings.write(path, rows.in_order())
    print(f"{len(rows.rows)} rows, {len(rows.parts)} others not whole")


def check_name(file):
    from urv import faults, recordings

    if file.suffix != recordings.KIND:
        raise faults.Refused(f"{faults.quoted(file)}: a recording's name ends"
                             f" with {recordings.KIND}")

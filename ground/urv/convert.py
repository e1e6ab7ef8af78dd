# SPDX-License-Identifier: Apache-2.0
"""bin/urv convert: a record from one kind of file to another (GND-15)."""

import os
from pathlib import Path
from typing import Annotated

import typer

from urv import faults


def convert(
    source: Annotated[Path, typer.Argument(
        metavar="IN", help="A record: .csv, .mcap or .parquet.")],
    target: Annotated[Path, typer.Argument(
        metavar="OUT", help="The record to write: its name says of which"
        " kind.")],
):
    """Convert a record; nothing is lost.

    Both names end with .csv, .mcap or .parquet.
    """
    from urv import progress, records

    kind = target.suffix.lower()
    if kind not in records.KINDS:
        raise faults.Refused(f"{faults.quoted(target)}: {records.ENDINGS}")
    if source.exists() and target.exists() and source.samefile(target):
        raise faults.Refused("IN and OUT name the same file")
    with records.opened(source) as record, progress.bar(
            "converting") as told:
        # What stood under the name before stays until all is written.
        part = target.with_name(f".{target.name}.{os.getpid()}.part")
        try:
            with records.written(part, kind, record) as out:
                for rows in record.blocks():
                    out.write(rows)
                    told(record)
            os.replace(part, target)
        except OSError as fault:
            raise faults.Failed(f"{faults.quoted(target)} cannot be written:"
                                f" {faults.reason(fault)}") from fault
        finally:
            part.unlink(missing_ok=True)

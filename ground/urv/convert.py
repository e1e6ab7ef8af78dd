# SPDX-License-Identifier: Apache-2.0
"""bin/urv convert: a record from one kind of file to another (GND-15)."""

from pathlib import Path
from typing import Annotated

import typer

from urv import faults


def convert(
    source: Annotated[Path, typer.Argument(
        metavar="IN", help="A record: .csv, .mcap or .parquet.")],
    target: Annotated[Path, typer.Argument(
        metavar="OUT", help="The record to write: its name gives the"
        " kind.")],
):
    """Convert a record without loss.

    A record that was cut short is converted as far as it is whole, and the
    missing part is reported. Both names end with .csv, .mcap or .parquet.
    """
    from urv import input_files, progress, records, whole_files

    kind = target.suffix.lower()
    if kind not in records.KINDS:
        raise faults.Refused(f"{faults.quoted(target)}: {records.ENDINGS}")
    whole_files.check_distinct({"OUT": target}, {"IN": source})
    input_files.limit_memory()
    with records.opened(source, forgiving=True) as record, progress.bar(
            "converting") as told:
        with whole_files.replacing(target) as path, records.written(
                path, kind, record) as out:
            for rows in record.blocks():
                out.write(rows)
                told(record)
        faults.note_cut_short(source, record.cut_short)

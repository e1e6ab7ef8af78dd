# SPDX-License-Identifier: Apache-2.0
"""bin/urv report: a flight as one page of HTML (GND-14)."""

from pathlib import Path
from typing import Annotated, Optional

import typer

from urv import faults


def report(
    record: Annotated[Path, typer.Argument(
        metavar="RECORD", help="Record of the flight: .csv, .mcap, .parquet.")
    ],
    output: Annotated[Path, typer.Option(
        "-o", "--output", metavar="FILE", help="The page to write.")],
    compare: Annotated[Optional[Path], typer.Option(
        metavar="RECORD", help="Another flight, laid over it.")] = None,
    events: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="The flight's events, as --events wrote them.")
    ] = None,
    summary: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="The flight's summary, as --summary wrote it.")
    ] = None,
):
    """Make a report of a flight, as HTML.

    One page that needs no network.
    """
    from urv import (flights, input_files, progress, report_page,
                     whole_files)

    whole_files.check_distinct(
        {"--output": output}, {"RECORD": record, "--compare": compare,
                               "--events": events, "--summary": summary})
    input_files.limit_memory()
    with progress.bar("reading") as told:
        pages_events = flights.read_events(events) if events else []
        pages_summary = flights.read_summary(summary) if summary else None
        # Data that exceed the memory are kept beside the page.
        beside = output.parent if output.parent.is_dir() else None
        read = [flights.read(each, told, beside)
                for each in (record, compare) if each]
    with whole_files.replacing(output) as path, path.open(
            "w", encoding="utf-8") as page:
        for text in report_page.page(
                read, pages_events, pages_summary, beside):
            page.write(text)
    for flight in read:
        faults.note_cut_short(flight.path, flight.cut_short)

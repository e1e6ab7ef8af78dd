# SPDX-License-Identifier: Apache-2.0
"""bin/urv identify: derivatives from flights (GND-61 to GND-63)."""

import os
import resource
from pathlib import Path
from typing import Annotated, Optional

import typer

from urv import faults

MOST_RECORDS = 50


def identify(
    records: Annotated[list[Path], typer.Argument(
        metavar="RECORD...", help="Records of flights with manoeuvres.")],
    output: Annotated[Optional[Path], typer.Option(
        "-o", "--output", metavar="FILE", help="The report to write, HTML.")
    ] = None,
    json: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="The numbers, JSON.")] = None,
    model: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="The linear model to write, JSON.")] = None,
    aircraft: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="Mass properties and prior derivatives, JSON."
        " Without it, those of the simulated aircraft.")] = None,
    manoeuvres: Annotated[Optional[Path], typer.Option(
        metavar="FILE", help="Times of the manoeuvres, CSV: begin_s, end_s,"
        " axes. Without it they are found by the sticks. One RECORD only.")
    ] = None,
    hold_out: Annotated[int, typer.Option(
        min=0, max=100, metavar="N", help="Manoeuvres of each axis for"
        " validation.")] = 1,
):
    """Estimate stability and control derivatives from flights.

    Prints each derivative with its 95 % interval, and cautions.
    """
    # The arrays are small: more threads only wait for each other.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    from urv import flights, input_files, progress, whole_files
    from urv.identification import aircraft as aircraft_file
    from urv.identification import analysis, cautions, linear, page
    from urv.identification import manoeuvres as finding

    if len(records) > MOST_RECORDS:
        raise faults.Refused(f"there may be {MOST_RECORDS} records")
    if manoeuvres and len(records) > 1:
        raise faults.Refused("--manoeuvres has the times of one record")
    whole_files.check_distinct(
        {"--output": output, "--json": json, "--model": model},
        {"--aircraft": aircraft, "--manoeuvres": manoeuvres,
         **{f"RECORD {place}": each
            for place, each in enumerate(records, 1)}})
    for place, each in enumerate(records, 1):
        for other, its_place in zip(records, range(1, place)):
            if whole_files.same_file(each, other):
                raise faults.Refused(
                    f"RECORD {its_place} and RECORD {place} name the same file:"
                    f" {faults.quoted(each)}: its data would count twice")
    # The estimate of many records takes minutes.
    for each in (output, json, model):
        if each:
            whole_files.check(each)
    before = input_files.limit_memory()
    own = aircraft_file.read(aircraft or aircraft_file.DEFAULT)
    finders = ((finding.from_file(manoeuvres),) if manoeuvres
               else finding.FINDERS)
    with progress.bar("reading") as told:
        read = [flights.read(each, told) for each in records]
    for flight in read:
        faults.note_cut_short(flight.path, flight.cut_short)
    # The limit is for damaged files; many records rightly need more.
    resource.setrlimit(resource.RLIMIT_DATA, before)
    try:
        with progress.bar("estimating") as told:
            result = analysis.identify(read, own, finders, hold_out, told)
    except MemoryError as fault:
        raise faults.Failed(f"the manoeuvres of {len(read)} records need more"
                            " memory than there is: give fewer") from fault
    if all(axis.fit is None for axis in result.axes.values()):
        raise faults.Refused(no_result(result))
    for line in [*lines(result), *(f"caution: {each}" for each
                                   in cautions.of(result, own))]:
        print(line)
    if json:
        with whole_files.replacing(json) as path:
            path.write_text(page.as_json(result, own), "utf-8")
    if model:
        with whole_files.replacing(model) as path:
            path.write_text(linear.as_json(result, own), "utf-8")
    if output:
        with whole_files.replacing(output) as path, path.open(
                "w", encoding="utf-8") as file:
            for text in page.page(result, own):
                file.write(text)


def no_result(result):
    """One line: why there is nothing to estimate."""
    where = ", ".join(faults.quoted(each) for each in result.records)
    reasons = [
        f"{each.manoeuvre.begin:.1f} s: {each.reason}"
        for axis in result.axes.values() for each in axis.flown
        if each.reason]
    return f"{where}: " + (
        f"no usable manoeuvre; at {'; at '.join(dict.fromkeys(reasons))}"
        if reasons else "no manoeuvre: no stick moves by more than 2 % from"
        " its rest for 0.1 to 60 s; --manoeuvres gives times")


def lines(result):
    """The result as text."""
    for axis in result.axes.values():
        used = sum(each.outputs is not None and not each.is_for_validation
                   for each in axis.flown)
        checked = sum(each.is_for_validation for each in axis.flown)
        yield (f"{axis.axis}: {used} manoeuvres, {checked} for validation"
               + (f": {axis.reason}" if axis.reason else ""))
        for each in axis.flown:
            if each.segment is None:
                yield (f"  not used: {each.manoeuvre.begin:.2f} s:"
                       f" {each.reason}")
        if axis.fit and not axis.fit.has_converged:
            yield "  the estimate has not converged"
        for each in axis.derivatives.values():
            if not each.low <= each.high:
                yield f"  {each.name:<13} not determined: {each.reason}"
                continue
            half = (each.high - each.low) / 2.0
            yield (f"  {each.name:<13}{each.value:10.4f} +-{half:8.4f}"
                   + (f"  not determined: {each.reason}"
                      if not each.is_determined else ""))

# SPDX-License-Identifier: Apache-2.0
"""The manoeuvres of a flight (GND-61).

    manoeuvres.found(flight)

A finder takes a flight and returns its manoeuvres. The first finder that finds
any is used. `by_sticks` takes movements of the sticks after a rest; `from_file`
makes a finder of times that a person gives. A finder of marks in the downlink
goes first into FINDERS, and names its mark.
"""

from __future__ import annotations

import csv
import dataclasses
import itertools
from dataclasses import dataclass
from pathlib import Path

import numpy
from scipy import ndimage

from urv import faults, input_files, packets
from urv.identification import measurements

LONGITUDINAL, LATERAL = "longitudinal", "lateral"
AXES = {LONGITUDINAL: ("pitch",), LATERAL: ("roll", "yaw")}

REST_S = 20.0
"""A stick's rest is its median over this time."""

MOVED_PERCENT = 2.0
"""A stick that is further than this from its rest moves the aircraft."""

SAME_S = 3.0
"""Movements with a shorter pause are one manoeuvre."""

LEAD_S = 0.5
TAIL_S = 4.0
"""Time before the first and after the last movement that belongs to it."""

SHORTEST_S = 0.1
LONGEST_S = 60.0
"""Limits of the movement's length; hand-flying is longer."""

LONGEST_GIVEN_S = 120
"""The same of a manoeuvre of a file, with its rests."""

MOST = 200

ROWS_AT_ONCE = 10_000
"""For the rest of a stick: a damaged record may lack nearly all rows."""

GROUPS = ("console", "gsc.uplink", "mcs.uplink")
"""Groups of columns with the sticks, best first."""


@dataclass(frozen=True)
class Manoeuvre:
    """A part of a flight, in s of its record, and the axes that it moves."""

    begin: float
    end: float
    axes: tuple[str, ...]
    mark: str = ""
    """How it was found: "sticks", or a mark's name."""
    reason: str = ""
    """Why it cannot be judged and is not used."""


def by_sticks(flight) -> list[Manoeuvre]:
    """Movements of the sticks after a rest."""
    group = next((each for each in GROUPS
                  if flight.has_all(*(f"{each}.{stick}" for sticks
                                      in AXES.values() for stick in sticks))),
                 None)
    if group is None:
        return []
    moved = {axis: numpy.zeros(flight.rows, bool) for axis in AXES}
    for axis, sticks in AXES.items():
        for stick in sticks:
            values = numpy.asarray(flight.values(f"{group}.{stick}"))
            moved[axis] |= abs(
                values - rests(flight.seconds, values)) > MOVED_PERCENT
    rows = numpy.flatnonzero(sum(moved.values()))
    if not len(rows):
        return []
    seconds = flight.seconds
    runs = numpy.split(rows, numpy.flatnonzero(
        numpy.diff(seconds[rows]) > SAME_S) + 1)
    found = []
    for place, run in enumerate(runs):
        first, last = seconds[run[0]], seconds[run[-1]]
        if not SHORTEST_S <= last - first <= LONGEST_S:
            continue
        following = (seconds[runs[place + 1][0]] if place + 1 < len(runs)
                     else numpy.inf)
        found.append(Manoeuvre(
            max(first - LEAD_S, seconds[0]),
            min(last + TAIL_S, following - LEAD_S, seconds[-1]),
            tuple(axis for axis in AXES if moved[axis][run].any()),
            "sticks"))
    return found[:MOST]


def rests(seconds, values):
    """The median of the values over REST_S around each row. A missing row
    counts as the nearest one, so that this is a time and no number of rows."""
    size = round(REST_S / packets.FRAME_S) | 1
    # No row sees further than a window across a gap.
    frames = numpy.r_[0, numpy.cumsum(numpy.clip(numpy.rint(
        numpy.diff(seconds) / packets.FRAME_S), 1, size).astype(int))]
    size = min(size, frames[-1] + 1) | 1
    middles = (frames[:-1] + frames[1:] + 1) // 2
    found = numpy.empty(len(values))
    for first in range(0, len(values), ROWS_AT_ONCE):
        rows = slice(first, first + ROWS_AT_ONCE)
        wanted = numpy.arange(frames[rows][0] - size // 2,
                              frames[rows][-1] + size // 2 + 1)
        found[rows] = ndimage.median_filter(
            values[numpy.searchsorted(middles, wanted, "right")],
            size)[frames[rows] - wanted[0]]
    return found


SWITCH = "switch5"
CARD_MOVED_DEG = 0.3
"""A surface that moves by more than this, with the sticks at rest, has an
input."""

SURFACES = {LONGITUDINAL: ("elevator",), LATERAL: ("aileron", "rudder")}
DOWNLINKS = ("mcs.downlink", "gsc.downlink")
NOT_JUDGED = "switch 5 is on, but a gap in the downlink hides the surfaces"


def by_cards(flight) -> list[Manoeuvre]:
    """Test cards (FTI-7): from switch 5 on until the surfaces are at rest.

    Times in which a stick moves too are not cards. Where a gap hides the surfaces,
    the manoeuvre has the reason."""
    uplink = next((group for group in GROUPS if flight.has_all(
        f"{group}.{SWITCH}", f"{group}.pitch", f"{group}.roll",
        f"{group}.yaw")), None)
    downlink = next((group for group in DOWNLINKS if flight.has_all(*(
        f"{group}.{side}_{name}" for names in SURFACES.values()
        for name in names for side in ("left", "right")))), None)
    if uplink is None or downlink is None:
        return []
    seconds = flight.seconds
    is_on = numpy.asarray(flight.values(f"{uplink}.{SWITCH}")) >= 0.5
    edges = numpy.flatnonzero(numpy.diff(is_on.astype(int), prepend=0) == 1)
    found = []
    for place, row in enumerate(edges):
        off = numpy.flatnonzero(~is_on[row:])
        last = row + (off[0] if len(off) else len(is_on) - row) - 1
        rows = slice(row, last + 1)
        if last == row or any(
                numpy.ptp(flight.values(f"{uplink}.{stick}")[rows])
                > MOVED_PERCENT for sticks in AXES.values()
                for stick in sticks):
            continue
        rest = slice(max(row - round(LEAD_S / packets.FRAME_S), 0), row + 1)
        is_rest = seconds[rest] >= seconds[row] - LEAD_S - 1e-6
        moved = {axis: numpy.zeros(last - row + 1, bool) for axis in AXES}
        is_hidden = False
        for axis, names in SURFACES.items():
            for name in names:
                for side in ("left", "right"):
                    values = numpy.asarray(
                        flight.values(f"{downlink}.{side}_{name}"))
                    known = values[rest][
                        is_rest & ~numpy.isnan(values[rest])]
                    is_hidden |= not len(known) or longest_gap_s(
                        seconds[rows], values[rows]
                    ) > measurements.LONGEST_GAP_S + 1e-6
                    # A comparison with NaN is false: a gap moves nothing.
                    if len(known):
                        moved[axis] |= abs(values[rows] - numpy.median(
                            known)) > CARD_MOVED_DEG
        ends = numpy.flatnonzero(sum(moved.values()))
        if is_hidden and not len(ends):
            found.append(Manoeuvre(seconds[row], seconds[last], tuple(AXES),
                                   "card", NOT_JUDGED))
        if not len(ends) or seconds[row + ends[-1]] - seconds[row] > LONGEST_S:
            continue
        following = (seconds[edges[place + 1]] if place + 1 < len(edges)
                     else numpy.inf)
        found.append(Manoeuvre(
            max(seconds[row] - LEAD_S, seconds[0]),
            min(seconds[row + ends[-1]] + TAIL_S, following - LEAD_S,
                seconds[-1]),
            tuple(axis for axis in AXES if moved[axis].any()), "card"))
    return found[:MOST]


def longest_gap_s(seconds, values) -> float:
    """The longest time without a value; rows may be missing, too."""
    known = seconds[~numpy.isnan(values)]
    steps = numpy.diff(numpy.r_[seconds[0] - packets.FRAME_S, known,
                                seconds[-1] + packets.FRAME_S])
    return steps.max() - packets.FRAME_S


FINDERS = (by_cards, by_sticks)


def found(flight, finders=FINDERS) -> list[Manoeuvre]:
    """The manoeuvres of a flight by the first finder that finds any, and
    those before that cannot be judged."""
    manoeuvres = []
    for finder in finders:
        manoeuvres += finder(flight)
        if any(not each.reason for each in manoeuvres):
            break
    return manoeuvres


def from_file(path: Path):
    """A finder of the manoeuvres in a CSV file with the columns begin_s, end_s
    and axes: longitudinal, lateral or both. Raises faults.Refused."""
    where = faults.quoted(path)[1:-1]
    given, lines = [], []
    with input_files.opened_typed(path) as file:
        try:
            rows = csv.DictReader(file)
            if rows.fieldnames != ["begin_s", "end_s", "axes"]:
                raise faults.Refused(
                    f"{where}:1: the columns are begin_s,end_s,axes")
            for row in rows:
                given.append(_manoeuvre(row, f"{where}:{rows.line_num}"))
                lines.append(rows.line_num)
                if len(given) > MOST:
                    raise faults.Refused(
                        f"{where}:{rows.line_num}: there may be {MOST}"
                        " manoeuvres")
        except (UnicodeDecodeError, csv.Error) as fault:
            raise faults.Refused(f"{where}: no text of CSV") from fault
    if not given:
        raise faults.Refused(f"{where}: it has no manoeuvre")
    _check_apart(given, lines, where)
    return lambda flight: [_within(each, flight.seconds) for each in given]


def _check_apart(given, lines, where):
    """Refuses manoeuvres of an axis that overlap: data that count twice narrow
    the intervals without a reason."""
    for axis in AXES:
        flown = sorted((each.begin, each.end, line) for each, line
                       in zip(given, lines, strict=True) if axis in each.axes)
        for (_, end, before), (begin, _, line) in itertools.pairwise(flown):
            if begin < end:
                raise faults.Refused(
                    f"{where}:{line}: overlaps the {axis} manoeuvre of line"
                    f" {before}: its data would count twice")


def _within(given, seconds):
    """The manoeuvre, with the reason when the record does not have all of
    it."""
    first, last = seconds[0], seconds[-1]
    margin = measurements.LONGEST_GAP_S
    if first - margin <= given.begin and given.end <= last + margin:
        return given
    return dataclasses.replace(
        given, reason=f"it is not in the record, which has {first:.2f} to"
        f" {last:.2f} s")


def _manoeuvre(row, where):
    try:
        begin, end = float(row["begin_s"]), float(row["end_s"])
    except (TypeError, ValueError) as fault:
        raise faults.Refused(f"{where}: times are numbers") from fault
    if not 0 <= begin < end <= 1e7:
        raise faults.Refused(f"{where}: begin_s is before end_s")
    if end - begin > LONGEST_GIVEN_S:
        raise faults.Refused(
            f"{where}: a manoeuvre lasts at most {LONGEST_GIVEN_S} s")
    axes = {"both": tuple(AXES)} | {axis: (axis,) for axis in AXES}
    if row["axes"] not in axes:
        raise faults.Refused(
            f"{where}: axes are {', '.join(AXES)} or both")
    return Manoeuvre(begin, end, axes[row["axes"]], "file")

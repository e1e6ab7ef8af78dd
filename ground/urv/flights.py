# SPDX-License-Identifier: Apache-2.0
"""A flight in memory, in engineering units, with its gaps (GND-14, SEC-14).

Words of the downlink are those of the ground's CORE, or of the aircraft's in
the aircraft's own record. While they are stale, and before the first ones,
there are none: `values` has NaN there.
"""

from __future__ import annotations

import bisect
import json
import os
import tempfile
from collections.abc import Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy

from urv import faults, input_files, items, packets, records


STICKS = ("roll", "pitch", "yaw", "throttle", "brake")
SERVOS = ("left_aileron", "left_elevator", "left_rudder", "throttle", "brake")

LONGEST_LATENCY_FRAMES = 25

SAME_EXCEEDANCE_S = 0.5
"""Two exceedances with a shorter gap between them are one."""

MOST_EVENTS = 10_000
LONGEST_WORD = 250
"""Characters of an event's node or kind; a mark may have 200 of its own."""

CLOSE_S = 2.0
"""Occurrences within this time of an exceedance are listed with it."""

FEET_PER_NAUTICAL_MILE = 6076.12

CHANNEL_S = 16e-6
"""Between the samples of two successive words of a scan (docs/link.md)."""

FIRST_SAMPLE_S = {"report": 0.0, "fast": 0.003024}
"""By schedule: the sample of the first word, after the beginning of the frame
of its scan."""

SERVOS_WRITTEN_S = {"report": 0.004, "fast": -0.012}
"""By schedule: when the servos got the words that a downlink carries, after
the beginning of the frame of its scan."""

CLOCKS_FRAMES = 3
CLOCKS_DRIFT = 1.0 / 2400.0
"""Two nodes count the same frames within this and this share."""


@dataclass(frozen=True)
class Span:
    """From the first to the last row of an occurrence, in seconds."""

    begin: float
    end: float

    @property
    def seconds(self):
        return self.end - self.begin

    def is_close_to(self, other):
        return (self.begin - CLOSE_S <= other.end
                and other.begin <= self.end + CLOSE_S)


@dataclass(frozen=True)
class Exceedance:
    """An item beyond a limit for a while."""

    item: items.Item
    level: str
    span: Span
    worst: float
    at: float

    @property
    def limit(self):
        """The limit that the worst value is beyond."""
        side = "high" if self.worst > (
            getattr(self.item, f"{self.level}_high")
            if getattr(self.item, f"{self.level}_high") is not None
            else float("inf")) else "low"
        return getattr(self.item, f"{self.level}_{side}")


@dataclass(frozen=True)
class Event:
    """A kind of error of a node's log."""

    node: str
    kind: str
    count: int
    span: Span


class StoredColumns(Mapping):
    """The columns of a record in a nameless file, so that a flight may be
    longer than memory. A column is read on demand."""

    def __init__(self, names, folder):
        self.kinds = {name: numpy.dtype(
            numpy.uint16 if name in items.COLUMNS else numpy.float64)
            for name in names}
        self.folder = folder or tempfile.gettempdir()
        with self.kept():
            self.file = tempfile.TemporaryFile(dir=folder)
        self.blocks = []
        """The begin and the number of rows of each block."""
        self.begins = {}
        self.row_size = 0
        for name, kind in self.kinds.items():
            self.begins[name] = self.row_size
            self.row_size += kind.itemsize
        self.rows = 0

    def add(self, rows):
        """Adds some rows, all columns."""
        self.blocks.append((self.rows * self.row_size, len(rows)))
        self.rows += len(rows)
        with self.kept():
            for place, kind in enumerate(self.kinds.values()):
                self.file.write(rows[:, place].astype(kind).tobytes())

    def end(self):
        with self.kept():
            self.file.flush()

    @contextmanager
    def kept(self):
        """A refusal by the system is reported for the folder."""
        try:
            yield
        except OSError as fault:
            raise faults.Failed(
                f"{faults.quoted(self.folder)}: the flight cannot be kept"
                f" there: {faults.reason(fault)}") from fault

    def __getitem__(self, name):
        kind, begin = self.kinds[name], self.begins[name]
        column = numpy.empty(self.rows)
        first = 0
        for at, many in self.blocks:
            column[first:first + many] = numpy.frombuffer(os.pread(
                self.file.fileno(), many * kind.itemsize,
                at + begin * many), kind)
            first += many
        return column

    def __iter__(self):
        return iter(self.kinds)

    def __len__(self):
        return len(self.kinds)

    def __contains__(self, name):
        return name in self.kinds


ROWS_AT_ONCE = 100_000
"""For operations on many columns at once."""


def pieces(rows, before=0):
    """Parts of a flight's rows, from and to, each with some rows before."""
    for first in range(0, rows, ROWS_AT_ONCE):
        yield max(first - before, 0), first, min(first + ROWS_AT_ONCE, rows)


class Flight:
    """The numbers of a record, by column."""

    def __init__(self, path, columns, cut_short=None):
        self.path = Path(path)
        self.columns = columns
        self.cut_short = cut_short
        self.seconds = columns["time_ms"] / 1000.0
        self.rows = len(self.seconds)

    def __contains__(self, name):
        return name in self.columns

    @property
    def frames(self):
        """The number of flown frames, including those without a row."""
        frame = self.columns["frame"]
        return int(frame[-1] - frame[0]) + 1

    def has_all(self, *names):
        return all(name in self.columns for name in names)

    @cached_property
    def downlink(self):
        """The group whose words of the downlink are shown."""
        for group in ("gsc.downlink", "mcs.downlink"):
            if f"{group}.error" in self.columns:
                return group
        return None

    @cached_property
    def is_stale(self):
        """The rows whose words of the downlink are from an earlier frame."""
        if self.downlink is None:
            return numpy.zeros(self.rows, bool)
        error = self.columns[f"{self.downlink}.error"].astype(int)
        # CORE is cleared at a cold start: words that are all 0 are no data.
        has_none = numpy.ones(self.rows, bool)
        for item in items.of_buffer("downlink"):
            column = f"{self.downlink}.{item.name}"
            if column in self.columns:
                has_none &= self.columns[column] == 0
        return (error & items.STALE != 0) | has_none

    @cached_property
    def aircraft_frames(self):
        """The exact number of the aircraft's frame of each row's words of the
        downlink, counted on from the first one (FTI-12): NaN while they are
        stale, or without the column. None without any number.

        Numbers are modulo 4096: the rows' times give the multiples. A number
        that contradicts them begins a new count, that of an aircraft that has
        started, whose first frame has its row's distance from the last one."""
        column = f"{self.frame_group}.number"
        if self.downlink is None or column not in self.columns:
            return None
        words = self.columns[column]
        rows = numpy.flatnonzero(
            ~self.is_stale & (words != packets.UNKNOWN_WORD))
        if not len(rows):
            return None
        counted = numpy.rint(
            numpy.diff(self.seconds[rows]) / packets.FRAME_S)
        steps = numpy.diff(words[rows]) % packets.FRAME_NUMBERS
        steps += packets.FRAME_NUMBERS * numpy.maximum(numpy.rint(
            (counted - steps) / packets.FRAME_NUMBERS), 0)
        is_new = abs(steps - counted) > (
            CLOCKS_FRAMES + CLOCKS_DRIFT * abs(counted))
        steps[is_new] = numpy.maximum(counted[is_new], 1)
        found = numpy.full(self.rows, numpy.nan)
        found[rows] = words[rows[0]] + numpy.r_[0, numpy.cumsum(steps)]
        return found

    @property
    def frame_group(self):
        """The group with the frame of the downlink's words."""
        return self.downlink and self.downlink.replace("downlink", "frame")

    @cached_property
    def lost_frames(self):
        """The aircraft's frames between the first and the last row whose words
        did not come; None when their numbers are not known."""
        frames = self.aircraft_frames
        if frames is None:
            return None
        known = frames[~numpy.isnan(frames)]
        return int(known[-1] - known[0]) + 1 - len(numpy.unique(known))

    def sample_times(self, column, schedule="report"):
        """When each word of a column was sampled, in s of the aircraft's
        frames: a sensor by the converter, to its channel; a servo's word of
        the frame, since when it was at the servo. NaN in gaps, None when it is
        not known."""
        frames = self.aircraft_frames
        after = sample_offset(column, schedule)
        if frames is None or after is None:
            return None
        return packets.FRAME_S * frames + after

    def values(self, name):
        """A column in its unit, with NaN in gaps."""
        column = self.columns[name]
        item = records.item_of(name)
        if item is None:
            return column
        values = item.value(column) if item.is_scaled else column
        if name.startswith(f"{self.downlink}."):
            return numpy.where(self.is_stale, numpy.nan, values)
        return values

    def sensor(self, name):
        """A word of the downlink by its item's name, or None."""
        column = f"{self.downlink}.{name}"
        return self.values(column) if column in self.columns else None

    @cached_property
    def breaks(self):
        """The rows before which at least one is missing."""
        if self.rows < 2:
            return numpy.array([], int)
        steps = numpy.diff(self.seconds)
        return numpy.flatnonzero(
            (steps > 1.5 * packets.FRAME_S) | (steps < 0)) + 1

    @cached_property
    def silences(self):
        """The times without fresh words of the downlink, or without rows;
        excluding the time before the first ones."""
        fresh = numpy.flatnonzero(~self.is_stale)
        if not len(fresh) or self.downlink is None:
            return []
        ends = self.seconds[fresh]
        found = [Span(begin, end) for begin, end
                 in zip(ends[:-1], ends[1:], strict=True)
                 if end - begin > 1.5 * packets.FRAME_S]
        if self.seconds[-1] > ends[-1]:
            found.append(Span(ends[-1], self.seconds[-1]))
        return found

    @cached_property
    def downlink_age_ms(self):
        """The time since the words were last fresh; NaN before the first
        ones."""
        fresh = numpy.where(self.is_stale, numpy.nan, self.seconds)
        last = numpy.fmax.accumulate(fresh) if self.rows else fresh
        return numpy.round(1000.0 * (self.seconds - last), 3)

    @cached_property
    def latencies(self):
        """Times in s, and ms from the console to the servos, of each change of
        the sticks that arrived: in whole frames, the resolution of a
        record."""
        console = [f"console.{name}" for name in STICKS]
        servos = [f"pwm.{name}" for name in SERVOS]
        if not self.has_all(*console, *servos) or self.rows < 2:
            return numpy.array([]), numpy.array([])
        is_new, has_moved = (self.changes(names)
                             for names in (console, servos))
        moved = numpy.flatnonzero(has_moved)
        found = numpy.full(len(moved), -1)
        # Words, so that ten columns of a long flight fit into memory.
        asked, done = ([self.columns[name].astype(numpy.uint16)
                        for name in names] for names in (console, servos))
        for frames in range(LONGEST_LATENCY_FRAMES, 0, -1):
            before = numpy.maximum(moved - frames, 0)
            # Not beyond a gap, in which the servo may have moved at any time.
            fits = is_new[before] & (
                self.seconds[moved] - self.seconds[before]
                < (frames + 0.5) * packets.FRAME_S)
            for stick, servo in zip(asked, done, strict=True):
                fits &= stick[before] == servo[moved]
            found = numpy.where(fits, before, found)
        moved, found = moved[found >= 0], found[found >= 0]
        return (self.seconds[moved],
                1000.0 * (self.seconds[moved] - self.seconds[found]))

    def changes(self, names):
        """The rows in which one of these columns differs from the row
        before."""
        changed = numpy.zeros(self.rows, bool)
        for name in names:
            column = self.columns[name]
            changed[1:] |= column[1:] != column[:-1]
        return changed

    @cached_property
    def exceedances(self):
        """The exceedances of all limits, in the order of their beginnings."""
        found = []
        for item in items.of_buffer("downlink"):
            column = f"{self.downlink}.{item.name}"
            if item.limits and column in self.columns:
                values = self.values(column)
                for level, low, high in self.levels(item):
                    found += self.beyond(item, level, values, low, high)
        return sorted(found, key=lambda each: (each.span.begin,
                                               each.item.position))

    @cached_property
    def excursions(self):
        """The same, but a caution that became a warning counts only as
        that."""
        # Both levels of an item are in order of time and do not overlap.
        warnings = {}
        for each in self.exceedances:
            if each.level == "warning":
                warnings.setdefault(each.item.name, []).append(each.span)
        begins = {name: [span.begin for span in spans]
                  for name, spans in warnings.items()}

        def became_a_warning(each):
            name = each.item.name
            if name not in warnings:
                return False
            place = bisect.bisect_left(begins[name], each.span.begin)
            return (place < len(begins[name])
                    and warnings[name][place].end <= each.span.end)

        return [each for each in self.exceedances
                if each.level == "warning" or not became_a_warning(each)]

    @staticmethod
    def levels(item):
        """Each level of an item, with its limits."""
        for level in ("caution", "warning"):
            low = getattr(item, f"{level}_low")
            high = getattr(item, f"{level}_high")
            if low is not None or high is not None:
                yield (level, -numpy.inf if low is None else low,
                       numpy.inf if high is None else high)

    def beyond(self, item, level, values, low, high):
        """The times when an item was beyond the limits of a level."""
        # Comparisons with NaN are false: a gap is not out of limits.
        outside = numpy.flatnonzero(
            (values < low - 1e-6) | (values > high + 1e-6))
        if not len(outside):
            return
        cuts = numpy.flatnonzero(
            numpy.diff(self.seconds[outside]) > SAME_EXCEEDANCE_S) + 1
        for rows in numpy.split(outside, cuts):
            how_far = numpy.maximum(low - values[rows], values[rows] - high)
            worst = rows[numpy.argmax(how_far)]
            yield Exceedance(
                item, level,
                Span(self.seconds[rows[0]], self.seconds[rows[-1]]),
                values[worst], self.seconds[worst])

    @cached_property
    def switch_changes(self):
        """Time and words of each: "switch 8, half flaps: on"."""
        found = []
        for item in items.of_group("console")[5:]:
            name = f"console.{item.name}"
            if name not in self.columns:
                continue
            is_on = self.columns[name] >= 0x800
            for row in numpy.flatnonzero(is_on[1:] != is_on[:-1]) + 1:
                found.append((self.seconds[row], f"{item.label}: "
                              f"{'on' if is_on[row] else 'off'}"))
        return sorted(found)

    @cached_property
    def reckoned_track(self):
        """East and north in ft, integrated from airspeed and heading rate,
        from the first heading on; NaN in gaps, after which it continues from
        its last place. None when a sensor is missing."""
        names = ("airspeed", "altitude", "altitude_offset", "roll_attitude",
                 "pitch_attitude", "pitch_rate", "yaw_rate")
        if self.downlink is None or not self.has_all(
                *(f"{self.downlink}.{name}" for name in names)):
            return None
        # Words, so that seven columns of a long flight fit into memory.
        words = [self.columns[f"{self.downlink}.{name}"].astype(numpy.uint16)
                 for name in names]
        scales = [records.item_of(f"{self.downlink}.{name}")
                  for name in names]
        track = [numpy.empty(self.rows) for _ in range(2)]
        turned, place, any_known = 0.0, [0.0, 0.0], False
        for before, first, last in pieces(self.rows, 1):
            has_all = ~self.is_stale[first:last]
            any_known = any_known or has_all.any()
            speed, altitude, offset, bank, pitch, q, r = (
                numpy.where(has_all, item.value(word[first:last].astype(float)),
                            numpy.nan)
                for item, word in zip(scales, words, strict=True))
            # The standard atmosphere converts calibrated airspeed to the true
            # one.
            density = (1.0 - 6.8756e-6 * (altitude + offset)) ** 4.2559
            knots = speed / numpy.sqrt(density)
            bank, pitch, q, r = map(numpy.radians, (bank, pitch, q, r))
            turn = ((q * numpy.sin(bank) + r * numpy.cos(bank))
                    / numpy.maximum(numpy.cos(pitch), 0.05))
            step = numpy.diff(self.seconds[before:last])
            if before == first:
                step = numpy.r_[0.0, step]
            # There is no information about a gap.
            step[~has_all | (step > 1.5 * packets.FRAME_S) | (step < 0)] = 0.0
            turns = summed(numpy.where(has_all, turn, 0.0) * step, turned)
            turned = turns[-1]
            heading = numpy.radians(self.first_heading) + turns
            feet = (numpy.where(has_all, knots * numpy.cos(pitch), 0.0)
                    * FEET_PER_NAUTICAL_MILE / 3600.0 * step)
            for axis, (whole, share) in enumerate(zip(
                    track, (numpy.sin, numpy.cos), strict=True)):
                along = summed(feet * share(heading), place[axis])
                place[axis] = along[-1]
                whole[first:last] = numpy.where(has_all, along, numpy.nan)
        return tuple(track) if any_known else None

    @cached_property
    def first_heading(self):
        """In deg. There is no compass; without the truth, north."""
        if "truth.heading_deg" in self.columns and self.rows:
            return self.columns["truth.heading_deg"][0]
        return 0.0


def sample_offset(column, schedule="report"):
    """The time of a word's sample after the beginning of the frame of its
    scan, in s; None for a column without one."""
    group, item = records.group_of(column)
    if group.endswith(".downlink"):
        names = [each.name for each in items.of_buffer("downlink")][:-1]
        if item in names:
            return FIRST_SAMPLE_S[schedule] + CHANNEL_S * names.index(item)
    if (group.endswith(".frame") and item in packets.FRAME_WORDS
            and item not in ("number", "card", "phase")):
        return SERVOS_WRITTEN_S[schedule]
    return None


def summed(steps, start):
    """The running sum of a part, continued from the part before."""
    steps[:1] += start
    return numpy.cumsum(steps)


def read(path, progress, folder=None):
    """The flight of a record, kept in a nameless file in that folder. A record
    that was cut short is read as far as it is whole."""
    with records.opened(path, forgiving=True) as record:
        columns = StoredColumns(record.names, folder)
        place, last = record.names.index("time_ms"), 0.0
        for rows in record.blocks():
            check_order(path, numpy.r_[last, rows[:, place]], columns.rows)
            last = rows[-1, place]
            columns.add(rows)
            progress(record)
        if not columns.rows:
            raise faults.Refused(
                f"{faults.quoted(path)}: the record has no rows")
        columns.end()
        return Flight(path, columns, record.cut_short)


def check_order(path, times, before):
    """Refuses times that go back. The first one is that of the row before."""
    back = numpy.flatnonzero(numpy.diff(times) < 0)
    if len(back):
        row = back[0]
        raise faults.Refused(
            f"{faults.quoted(path)}: time_ms goes back from {times[row]:g} to"
            f" {times[row + 1]:g} at row {before + row + 1}: not the record of"
            " one flight")


def read_events(path):
    """The events of a file of JSON lines, as written by urv_sim."""
    found = []
    for number, line in enumerate(input_files.text(path).split("\n"), 1):
        if not line.strip():
            continue
        where = f"{faults.quoted(path)[1:-1]}:{number}"
        try:
            event = input_files.parsed(line)
            found.append(Event(
                _word(event["node"]), _word(event["kind"]),
                _number(event["count"], int),
                Span(_number(event["first_ms"]) / 1000.0,
                     _number(event["last_ms"]) / 1000.0)))
        except KeyError as fault:
            raise faults.Refused(
                f"{where}: the event has no {fault.args[0]}") from fault
        except (ValueError, TypeError) as fault:
            raise faults.Refused(f"{where}: no event") from fault
        if len(found) > MOST_EVENTS:
            raise faults.Refused(
                f"{where}: there may be {MOST_EVENTS} events")
    return found


def _word(value):
    """A name; an unpaired UTF-16 surrogate is not one."""
    if not isinstance(value, str) or len(value) > LONGEST_WORD:
        raise TypeError(value)
    value.encode("utf-8")
    return value


def _number(value, kind=(int, float)):
    if isinstance(value, bool) or not isinstance(value, kind) or not (
            0 <= value <= records.LONGEST_TIME_MS):
        raise TypeError(value)
    return value


def read_summary(path):
    """A summary, as written by urv_sim."""
    where = faults.quoted(path)[1:-1]
    try:
        summary = input_files.parsed(input_files.text(path))
    except json.JSONDecodeError as fault:
        raise faults.Refused(
            f"{where}:{fault.lineno}: not JSON: {fault.msg}") from fault
    except ValueError as fault:
        raise faults.Refused(f"{where}:1: {fault}") from fault
    if not isinstance(summary, dict) or "frames" not in summary:
        raise faults.Refused(f"{where}:1: no summary of a flight")
    return summary

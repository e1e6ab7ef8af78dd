# SPDX-License-Identifier: Apache-2.0
"""A flight's record, block by block, so that it may be longer than memory.

    with records.opened("record.csv") as record:
        for rows in record.blocks():        arrays, a row for each frame
            record.names, record.decimals   of their columns

A record has whole numbers, and columns of decimals with always as many places
(`truth.*`). Its text can therefore be made again from its numbers. Every block
is checked for that: any difference from the text that urv_sim would write is
refused with its line (GND-13).

A file may be hostile, so its demands are bounded (SEC-14): the lengths of a
line and a name, the columns, the rows, and each number.
"""

from __future__ import annotations

import re
from contextlib import contextmanager
from functools import wraps
from pathlib import Path

import numpy

from urv import faults, input_files, items, recordings
from urv.packets import FRAME_US

ROWS_PER_BLOCK = 2_000
"""Rows of a file for reading: half a minute, some MB."""

LONGEST_LINE = 65_536
"""Characters; a line of urv_sim has about a thousand."""

CHARACTERS_PER_BLOCK = 4 * 2 ** 20

MOST_COLUMNS = 1_024
LONGEST_NAME = 200
"""Characters of a column's name."""

MOST_ROWS = 24 * 3600 * 1_000_000 // FRAME_US
"""A day of major frames."""

MOST_DECIMALS = 9
LONGEST_NUMBER = 24
"""Characters."""

LONGEST_TIME_MS = 10_000_000_000
"""The longest time that urv_sim takes, 115 days."""

FORMULA = re.compile("\\s*[=+\\-@\uff1d\uff0b\uff0d\uff20]")
"""The beginning of a cell that a spreadsheet may execute: = + - @, narrow or
wide (SEC-16). Numbers of a record never begin so; the name of a column may."""

NO_NAME_HAS = '",;/'
"""Spreadsheets of some countries separate cells at semicolons; topics of MCAP
have slashes between their parts."""

TEXT_MARK = "'"
"""Precedes such a name in CSV: spreadsheets then treat it as text."""

LARGEST_WORD = 0xFFFF

LARGEST = 2 ** 53
"""Beyond it a number need not be exact."""

NUMBER = re.compile(r"-?[0-9]+(?:\.([0-9]+))?")


def is_word(name):
    """True if a column holds words of 16 bits: an item's, the laws', or of a
    downlink's frame."""
    return (name in items.COLUMNS
            or name.startswith(("laws.", "mcs.frame.", "gsc.frame.")))


class Columns:
    """Names of a record's columns, and their numbers of decimals."""

    def __init__(self, names, decimals):
        self.names = list(names)
        self.decimals = list(decimals)
        words = numpy.array([is_word(name) for name in names])
        self.scales = 10.0 ** numpy.array(self.decimals)
        self.largest = numpy.where(words, LARGEST_WORD, LARGEST)
        self.smallest = numpy.where(words, 0, -LARGEST)
        for name, most in (("frame", LARGEST), ("time_ms", LONGEST_TIME_MS)):
            place = self.names.index(name)
            self.smallest[place] = 0
            self.largest[place] = most * self.scales[place]
        self.row_format = ",".join(
            f"%.{places}f" if places else "%d"
            for places in self.decimals) + "\n"

    def text(self, rows):
        """The lines of CSV of some rows."""
        row_format = self.row_format
        return "".join([row_format % tuple(row) for row in rows.tolist()])

    @property
    def header(self):
        """The header in CSV; no name in it is a formula."""
        return ",".join(
            TEXT_MARK + name if FORMULA.match(name) else name
            for name in self.names) + "\n"

    def first_bad(self, rows):
        """The row and the name of the first number that no record can have:
        not finite, too large, a word beyond 16 bits, or with more decimals
        than its column. None when all are valid."""
        with numpy.errstate(all="ignore"):
            scaled = numpy.rint(rows * self.scales)
            good = ((scaled >= self.smallest) & (scaled <= self.largest)
                    & (scaled / self.scales == rows))
        if good.all():
            return None
        row, column = numpy.argwhere(~good)[0]
        return int(row), self.names[column]


def read_decimals(texts, names):
    """The decimals of each column, words have none. Raises ValueError."""
    if len(texts) != len(names):
        raise ValueError("as many as columns")
    for name, text in zip(names, texts, strict=True):
        if not (text.isascii() and text.isdigit() and len(text) == 1
                and int(text) <= (0 if is_word(name) else MOST_DECIMALS)):
            raise ValueError(text)
    return [int(text) for text in texts]


def bounded(blocks):
    """A reader's blocks, with at most a day's rows."""
    @wraps(blocks)
    def counted(record):
        many = 0
        for rows in blocks(record):
            many += len(rows)
            if many > MOST_ROWS:
                raise faults.Refused(f"{faults.quoted(record.path)}: more than"
                                     f" {MOST_ROWS} rows, a day of frames")
            yield rows
    return counted


def check_names(names, where):
    """Refuse columns that are not a record's."""
    if len(names) > MOST_COLUMNS:
        raise faults.Refused(f"{where}: {len(names)} columns; there may be"
                             f" {MOST_COLUMNS}")
    seen = set()
    for name in names:
        if (not name.isprintable() or not 0 < len(name) <= LONGEST_NAME
                or name[0] == TEXT_MARK
                or any(mark in name for mark in NO_NAME_HAS)):
            raise faults.Refused(
                f"{where}: {faults.quoted(name)} is not a column name")
        if name in seen:
            raise faults.Refused(
                f"{where}: the column {faults.quoted(name)} appears twice")
        seen.add(name)
    missing = [name for name in ("frame", "time_ms") if name not in seen]
    if missing:
        raise faults.Refused(
            f"{where}: not a flight's record: it has no column"
            f" {' and no '.join(missing)}")


class CsvRecord:
    """A record as written by urv_sim and the partitions."""

    def __init__(self, path, file, forgiving=False):
        self.path = path
        self.file = file
        self.forgiving = forgiving
        self.size = path.stat().st_size if path.is_file() else None
        self.cut_short = None
        """The missing part of a record that was cut short, for people."""

        self.number = 0
        """The number of lines read."""

        header = self.next_line(1)
        if header is None:
            raise faults.Refused(f"{self.where(1)}: the file is empty")
        for mark, what in (("\ufeff", "it begins with a byte order mark"),
                           ("\r\n", "its lines end with CR LF")):
            if header.startswith(mark) or header.endswith(mark):
                raise faults.Refused(
                    f"{self.where(1)}: {what}; a record is UTF-8 with LF"
                    " alone: save it so, or give the file as it was recorded")
        names = [name[1:] if FORMULA.match(name, 1)
                 and name[0] == TEXT_MARK else name
                 for name in header[:-1].split(",")]
        check_names(names, self.where(1))
        self.first = self.next_line(2)
        self.columns = Columns(names, self.kinds(names))

    @property
    def names(self):
        return self.columns.names

    @property
    def decimals(self):
        return self.columns.decimals

    @property
    def position(self):
        """The number of bytes read; of `size`."""
        return self.file.buffer.tell()

    def where(self, line):
        return f"{faults.quoted(self.path)[1:-1]}:{line}"

    def lines(self, many):
        """The next lines, up to that number, or to a block's length."""
        found, length = [], 0
        try:
            while len(found) < many and length < CHARACTERS_PER_BLOCK:
                line = self.file.readline(LONGEST_LINE + 1)
                if not line:
                    break
                if len(line) > LONGEST_LINE:
                    raise faults.Refused(
                        f"{self.where(self.number + len(found) + 1)}: the line"
                        f" is longer than {LONGEST_LINE} characters")
                found.append(line)
                length += len(line)
        except UnicodeDecodeError as fault:
            raise faults.Refused(
                f"{self.where('?')}: not a text file: byte"
                f" {fault.object[fault.start]:02x}h") from fault
        self.number += len(found)
        return found

    def next_line(self, number):
        """A line, or None at the end."""
        found = self.lines(1)
        if found and not found[0].endswith("\n"):
            if number == 2 and self.forgiving:
                self.leave_out(number)
                return None
            raise faults.Refused(
                f"{self.where(number)}: the last line has no end: the record"
                " was cut short")
        return found[0] if found else None

    def leave_out(self, number):
        self.cut_short = f"its line {number} is not whole and left out"

    def kinds(self, names):
        """The number of decimals of each column, from its first row."""
        if self.first is None:
            return [0] * len(names)
        cells = self.first[:-1].split(",")
        self.check_cells(2, self.first, [None] * len(names), names)
        return [len(NUMBER.fullmatch(cell)[1] or "") for cell in cells]

    @bounded
    def blocks(self):
        """Arrays of rows, in order."""
        if self.first is None:
            return
        lines, number = [self.first], 2
        while True:
            lines += self.lines(ROWS_PER_BLOCK - len(lines))
            if not lines:
                return
            if not lines[-1].endswith("\n"):
                last = number + len(lines) - 1
                if not self.forgiving:
                    raise faults.Refused(
                        f"{self.where(last)}: the last line has no end: the"
                        " record was cut short")
                self.leave_out(last)
                lines.pop()
                if not lines:
                    return
            yield self.numbers(number, lines)
            number += len(lines)
            lines = []

    def numbers(self, number, lines):
        """The rows of some lines; refuses lines that urv_sim would write
        otherwise."""
        text = "".join(lines)
        width = len(self.names)
        try:
            if text.count(",") != len(lines) * (width - 1):
                raise ValueError("cells")
            values = numpy.array(
                text.replace("\n", ",").split(",")[:-1], dtype=object)
            rows = values.astype(numpy.float64).reshape(len(lines), width)
            if (self.columns.first_bad(rows) is None
                    and self.columns.text(rows) == text):
                return rows
        except (ValueError, OverflowError):
            pass
        for place, line in enumerate(lines):
            self.check_cells(number + place, line, self.decimals, self.names)
        raise faults.Refused(f"{self.where(number)}: cannot be read")

    def check_cells(self, number, line, decimals, names):
        """Refuse the first wrong cell."""
        cells = line[:-1].split(",")
        if len(cells) != len(names):
            raise faults.Refused(
                f"{self.where(number)}: {len(cells)} cells, the header has"
                f" {len(names)}")
        for cell, name, places in zip(cells, names, decimals, strict=True):
            found = (NUMBER.fullmatch(cell) if len(cell) <= LONGEST_NUMBER
                     else None)
            here = f"{self.where(number)}: {name}: {faults.quoted(cell)}"
            if not found:
                raise faults.Refused(f"{here} is not a number")
            fine = len(found[1] or "")
            if fine > MOST_DECIMALS:
                raise faults.Refused(f"{here} has {fine} decimals, more than"
                                     f" {MOST_DECIMALS}")
            if places is not None and fine != places:
                raise faults.Refused(
                    f"{here} has {fine} decimals, the rows before have"
                    f" {places}")
            if is_word(name) and (
                    fine or not 0 <= int(cell) <= LARGEST_WORD):
                raise faults.Refused(
                    f"{here} is not a word, 0 to {LARGEST_WORD}")
            if (f"{float(cell):.{fine}f}" != cell
                    or abs(float(cell)) * 10 ** fine >= LARGEST):
                raise faults.Refused(
                    f"{here} is not written as a record's numbers are")
            if name == "frame" and float(cell) < 0:
                raise faults.Refused(f"{here} is not a frame number")
            if name == "time_ms" and not 0 <= float(cell) <= LONGEST_TIME_MS:
                raise faults.Refused(f"{here} is not a time, 0 to"
                                     f" {LONGEST_TIME_MS} ms")


class CsvWriter:
    """Writes a record as urv_sim would."""

    def __init__(self, path, columns):
        self.columns = columns
        self.file = path.open("w", newline="", encoding="utf-8")
        self.file.write(columns.header)

    def write(self, rows):
        self.file.write(self.columns.text(rows))

    def close(self, _is_whole):
        self.file.close()


KINDS = (".csv", ".mcap", ".parquet")
ENDINGS = "a record's name ends with .csv, .mcap or .parquet"


@contextmanager
def opened(path, forgiving=False):
    """A record for reading, of the kind given by its name.

    A forgiving reader reads a record that was cut short as far as it is whole;
    `cut_short` of the record then gives the missing part.
    """
    path = Path(path)
    kind = path.suffix.lower()
    if kind == ".csv":
        with input_files.opened_text(path) as file:
            yield CsvRecord(path, file, forgiving)
    elif kind == recordings.KIND:
        with recordings.opened(path, forgiving) as record:
            yield record
    elif kind in KINDS:
        with _module(kind).opened(path, forgiving) as record:
            yield record
    else:
        raise faults.Refused(f"{faults.quoted(path)}: {ENDINGS}")


@contextmanager
def written(path, kind, record):
    """A writer for a record of some kind, with another record's columns."""
    writer = CsvWriter if kind == ".csv" else _module(kind).Writer
    out = writer(path, record.columns)
    is_whole = False
    try:
        yield out
        is_whole = True
    finally:
        out.close(is_whole)


def _module(kind):
    """The module that reads and writes a kind; it needs packages of its
    own."""
    if kind == ".parquet":
        from urv import parquet_files
        return parquet_files
    from urv import mcap_files
    return mcap_files


def group_of(name):
    """The group of a column and its name there; no group without a dot."""
    group, _, item = name.rpartition(".")
    return group, item


def item_of(name):
    """The item of a column's word; None for other columns."""
    return items.COLUMNS.get(name)


def stale_rows(names, rows):
    """By group of columns with an error word: the rows whose words are from an
    earlier frame, or from none. CORE is cleared at a cold start: a downlink of
    zeros has not been received yet."""
    found = {}
    for place, name in enumerate(names):
        group, item = group_of(name)
        if item == "error" and name in items.COLUMNS:
            stale = rows[:, place].astype(numpy.int64) & items.STALE != 0
            if group.endswith("downlink"):
                words = [at for at, each in enumerate(names)
                         if group_of(each)[0] == group]
                stale |= ~rows[:, words].any(axis=1)
            found[group] = stale
    return found

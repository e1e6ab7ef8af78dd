# SPDX-License-Identifier: Apache-2.0
"""The rows of the aircraft's flight recorder (FTI-9 to FTI-11).

A recording is a text file: a line that names it, then a line for each row, 72
words of four hexadecimal digits, in the order of src/formats/
urv-recorder_rows.ads. The partition writes one (--recording), and so does
bin/urv recorder. A row counts only if its sums are right.
"""

from __future__ import annotations

import os
import re
import struct
import tempfile
from collections.abc import Sequence
from contextlib import contextmanager
from pathlib import Path

from urv import faults, input_files, items
from urv.tables import TABLES

KIND = ".recording"
"""The end of the name of a recording."""

TITLE = "urv recording 2"
FIRST_TITLE = "urv recording 1"
"""Its rows had other places."""

WORDS = 72
CONTENT = 70

MOST_ROWS = 2 ** 22
"""Numbers of rows are smaller."""

_LINE = re.compile(f"[0-9a-f]{{{4 * WORDS}}}")
_ROW = struct.Struct(f">{WORDS}H")

TICK_US = 2_000


def sums(words) -> tuple[int, int]:
    """The sum of the contents of a row, and that of its partial sums."""
    total = partials = 0
    for word in words[:CONTENT]:
        total += word
        partials += total
    return total & 0xFFFF, partials & 0xFFFF


def is_right(words) -> bool:
    """A row is as the aircraft made it."""
    return (len(words) == WORDS
            and tuple(words[CONTENT:]) == sums(words)
            and number_of(words) < MOST_ROWS)


def number_of(words) -> int:
    return words[0] << 16 | words[1]


def line_of(words) -> str:
    return "".join(f"{word:04x}" for word in words) + "\n"


def words_of(line: str):
    """The words of a line, or None if it is not a row with right sums."""
    text = line.rstrip("\n")
    if not _LINE.fullmatch(text):
        return None
    words = _ROW.unpack(bytes.fromhex(text))
    return words if is_right(words) else None


class Rows(Sequence):
    """Rows in order, in a nameless file: hours of them would not fit into
    memory (GND-13)."""

    def __init__(self):
        self.file = tempfile.TemporaryFile()
        self.many = 0

    def append(self, words):
        self.file.write(_ROW.pack(*words))
        self.many += 1

    def packed(self, first, last):
        """The bytes of the rows from first to before last."""
        self.file.flush()
        return os.pread(self.file.fileno(), (last - first) * _ROW.size,
                        first * _ROW.size)

    def __len__(self):
        return self.many

    def __getitem__(self, place):
        if isinstance(place, slice):
            return [self[each] for each in range(*place.indices(self.many))]
        place = range(self.many)[place]
        return _ROW.unpack(self.packed(place, place + 1))

    def __eq__(self, other):
        return list(self) == list(other)


class Recording:
    """The rows of a file since the last cold start, in order of their numbers;
    each once."""

    def __init__(self, path: Path):
        self.path = path
        self.rows = Rows()
        self.wrong = []
        """The lines that are no rows, but for a last one without its end."""
        self.cut_short = None
        with input_files.opened_ascii(path) as file:
            try:
                self.read(file)
            except OSError as fault:
                raise faults.Failed(
                    f"{faults.quoted(path)}: its rows cannot be kept in"
                    f" {tempfile.gettempdir()}: {faults.reason(fault)}"
                ) from fault

    def read(self, file):
        where = faults.quoted(self.path)
        first = file.readline(len(TITLE) + 2)
        if first == FIRST_TITLE + "\n":
            raise faults.Refused(
                f"{where}: a recording of version 1; this program reads"
                " version 2. Convert it with the URV that wrote it")
        if first != TITLE + "\n":
            raise faults.Refused(f"{where}: not a recording: it does not begin"
                                 f" with \"{TITLE}\"")
        number, last = 1, -1
        while line := file.readline(4 * WORDS + 2):
            number += 1
            if line == TITLE + "\n":
                self.rows, self.wrong, last = Rows(), [], -1
                continue
            words = words_of(line)
            if not line.endswith("\n"):
                self.cut_short = (f"its line {number} is not whole and left"
                                  " out")
            elif words is None or number_of(words) <= last:
                self.wrong.append(number)
            else:
                self.rows.append(words)
                last = number_of(words)
        if self.wrong:
            self.cut_short = (
                f"{len(self.wrong)} lines are no rows, the first is line"
                f" {self.wrong[0]}" + (f"; {self.cut_short}"
                                       if self.cut_short else ""))


def write(path: Path, rows) -> None:
    """A recording of rows, in order."""
    with path.open("w", encoding="ascii", newline="\n") as file:
        file.write(TITLE + "\n")
        for words in rows:
            file.write(line_of(words))


def size_of(many: int) -> int:
    """The bytes of a recording of this number of rows."""
    return len(TITLE) + 1 + many * (4 * WORDS + 1)


def _names(group):
    return [column for column in items.COLUMNS
            if column.startswith(group + ".")]


def _places():
    """The groups of columns, each with the place of its first word, from 0, and
    the place of the first word after them."""
    found, place = {}, 4
    for group in ("mcs.downlink", "mcs.uplink", "pwm"):
        found[group] = place
        place += len(_names(group))
    return found, place


GROUPS, LAWS_PLACE = _places()

LAWS = ("lateral", "vertical", "power", "link")


def columns_of(words) -> dict[str, int]:
    """A row as that of a record: the columns of the aircraft's own. Each word
    may be an array, of that word in many rows."""
    tick = words[2] << 16 | words[3]
    frame = tick * TICK_US // TABLES["frame_us"]
    found = {"frame": frame, "time_ms": (frame + 1) * TABLES["frame_us"] // 1000}
    for group, first in GROUPS.items():
        for place, name in enumerate(_names(group)):
            found[name] = words[first + place]
    modes, *reports, card, errors, last = words[LAWS_PLACE:LAWS_PLACE + 9]
    for place, name in enumerate(LAWS):
        found[f"laws.{name}"] = modes >> 4 * place & 15
    for name, word in zip(("invalid_low", "invalid_high", "silent", "failed",
                           "configuration"), reports, strict=True):
        found[f"laws.{name}"] = word
    found |= {
        "recorder.row": number_of(words), "recorder.tick": tick,
        "recorder.card": card >> 4 & 15,
        "recorder.card_state": card, "recorder.errors": errors,
        "recorder.last_error": last & 255, "recorder.warm_starts": last >> 8}
    return found


class Record:
    """A recording with the parts of a record that its readers need."""

    size = None
    position = 0

    def __init__(self, recording):
        from urv import records

        names = list(columns_of((0,) * WORDS))
        self.cut_short = recording.cut_short
        self.columns = records.Columns(names, [0] * len(names))
        self.rows = recording.rows

    @property
    def names(self):
        return self.columns.names

    @property
    def decimals(self):
        return self.columns.decimals

    def blocks(self):
        import numpy
        from urv import records

        many = len(self.rows)
        for first in range(0, many, records.ROWS_PER_BLOCK):
            words = numpy.frombuffer(self.rows.packed(
                first, min(first + records.ROWS_PER_BLOCK, many)),
                ">u2").reshape(-1, WORDS)
            yield numpy.array(
                [*columns_of(words.T.astype(numpy.int64)).values()],
                numpy.float64).T.copy()


@contextmanager
def opened(path, forgiving=False):
    """A recording as a record."""
    recording = Recording(Path(path))
    if recording.cut_short and not forgiving:
        raise faults.Refused(f"{faults.quoted(path)}: {recording.cut_short}")
    yield Record(recording)

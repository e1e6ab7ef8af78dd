# SPDX-License-Identifier: Apache-2.0
"""The blocks that fetch rows of the flight recorder (FTI-10): the layouts are
those of src/formats/urv-recorder_blocks.ads."""

from __future__ import annotations

from dataclasses import dataclass

from urv import recordings

ROWS = 0x700
"""The kind of a request, and of a block of a row."""
REPORT = 0x800

BLOCK_WORDS = 27
PARTS = 4
PART_WORDS = 18
LARGEST = 0xFFF
MOST_ROWS = LARGEST
"""Rows that one request may ask for."""

ANSWERS = ("accepted", "the aircraft flies, or its state is not known",
           "no row from the first one on is held")


def request(first: int, rows: int) -> tuple[int, ...]:
    """The 12 words of a request's block after its kind."""
    fields = (first >> 12, first & LARGEST, rows)
    total = sum(weight * field for weight, field
                in zip((1, 3, 5), fields, strict=True)) & LARGEST
    return (*fields, *(LARGEST - field for field in fields), total,
            0, 0, 0, 0, 0)


def is_whole(words) -> bool:
    """All words of a block agree."""
    return (len(words) == BLOCK_WORDS
            and all(0 <= word <= LARGEST for word in words)
            and words[-1] == sum(
                (2 * place + 1) * word
                for place, word in enumerate(words[:-1])) & LARGEST)


@dataclass(frozen=True)
class Report:
    """The recorder's answer to a request."""

    answer: int
    first: int
    held: int
    length: int

    @classmethod
    def of(cls, words) -> Report:
        return cls(words[0], *(words[at] << 12 | words[at + 1]
                               for at in (1, 3, 5)))


class Rows:
    """The rows that have come, whole or in part."""

    def __init__(self):
        self.parts = {}
        self.rows = {}
        self.wrong = {}
        """Rows that came whole with wrong sums, and how often."""
        self.report = None
        self.reports = 0

    def take(self, kind: int, words) -> None:
        """Takes a block; one that is not whole changes nothing."""
        if not is_whole(words):
            return
        if kind == REPORT:
            self.report = Report.of(words)
            self.reports += 1
        elif kind == ROWS:
            self.take_part(words)

    def take_part(self, words) -> None:
        number = (words[0] & 0x3FF) << 12 | words[1]
        if number in self.rows:
            return
        parts = self.parts.setdefault(number, {})
        parts[words[0] >> 10] = unpacked(words[2:26])
        if len(parts) == PARTS:
            row = tuple(word for part in range(PARTS) for word in parts[part])
            del self.parts[number]
            if (recordings.is_right(row)
                    and recordings.number_of(row) == number):
                self.rows[number] = row
            else:
                self.wrong[number] = self.wrong.get(number, 0) + 1

    def missing(self, first: int, last: int) -> list[int]:
        """The rows from first to before last that have not come."""
        return [number for number in range(first, last)
                if number not in self.rows]

    def in_order(self) -> list[tuple[int, ...]]:
        return [self.rows[number] for number in sorted(self.rows)]


def unpacked(fields) -> list[int]:
    """The words of a part from its fields of 12 bits."""
    words = []
    for at in range(0, len(fields), 4):
        bits = 0
        for field in fields[at:at + 4]:
            bits = bits << 12 | field
        words += [bits >> 32, bits >> 16 & 0xFFFF, bits & 0xFFFF]
    return words


def spans(numbers) -> list[tuple[int, int]]:
    """Rows in a row: the first of each, and how many."""
    found = []
    for number in numbers:
        if found and sum(found[-1]) == number and found[-1][1] < MOST_ROWS:
            found[-1] = (found[-1][0], found[-1][1] + 1)
        else:
            found.append((number, 1))
    return found

# SPDX-License-Identifier: Apache-2.0
"""The control laws in a recorded flight (GND-14).

    flown_laws.of(flight).answer()      for the head of a report
    flown_laws.of(flight).happened()    for its time axis

A record has the laws' status of the aircraft (`laws.lateral`), or the status
reported to the ground (`laws.told`), which is up to a second older.
"""

from __future__ import annotations

from functools import cached_property

import numpy

from urv import laws, orders
from urv.flights import Span
from urv.packets import FRAME_S
from urv.verdicts import CAUTION, WARNING, WELL, Answer, Line, number, worst

SETTLES_S = 2.5
"""After a start the laws reject every sensor for a second, and the report of
that takes another one: no news."""

TOLD = {"invalid_low": "told_invalid_low",
        "invalid_high": "told_invalid_high", "failed": "told_failed",
        "configuration": "told_configuration"}
"""Columns of the aircraft's record, and of the ground's."""


def of(flight):
    """None when the record has no data of the laws."""
    if "laws.lateral" in flight:
        return Flown(flight, {name: name for name in TOLD})
    return Flown(flight, TOLD) if "laws.told" in flight else None


class Flown:
    """The words of the laws, by row."""

    def __init__(self, flight, names):
        self.flight = flight
        self.names = names

    def word(self, name):
        """A column, or zeros where the record has none."""
        column = f"laws.{self.names[name]}"
        if column not in self.flight:
            return numpy.zeros(self.flight.rows, int)
        return self.flight.columns[column].astype(int)

    @cached_property
    def modes(self):
        """Lateral, vertical, power and link, by row."""
        if "laws.lateral" in self.flight:
            return [self.flight.columns[f"laws.{name}"].astype(numpy.uint16)
                    for name in ("lateral", "vertical", "power", "link")]
        told = self.flight.columns["laws.told"].astype(numpy.uint16)
        return [told >> laws.NIBBLE_BITS * place & 15 for place in range(4)]

    def spans(self, is_so):
        """The times of the rows where the condition holds, each to its row's
        end."""
        rows = numpy.flatnonzero(is_so)
        if not len(rows):
            return []
        seconds = self.flight.seconds
        cuts = numpy.flatnonzero(
            (numpy.diff(rows) > 1)
            | (numpy.diff(seconds[rows]) > 1.5 * FRAME_S)) + 1
        return [Span(seconds[some[0]] - FRAME_S, seconds[some[-1]])
                for some in numpy.split(rows, cuts)]

    @cached_property
    def flown(self):
        """The times of each mode except direct, by its name."""
        lateral, vertical, power, _ = self.modes
        codes = lateral | vertical << 4 | power << 8
        found = {}
        for code in numpy.unique(codes[codes != 0]):
            name = laws.mode_name(*(
                laws.name_of(names, code >> 4 * place & 15)
                for place, names in enumerate(
                    (laws.LATERAL, laws.VERTICAL, laws.POWER))))
            found[name] = self.spans(codes == code)
        return found

    @cached_property
    def alone(self):
        """The times of each state in which the aircraft flies by itself."""
        link = self.modes[3]
        return {name: spans for name in laws.ALONE
                if (spans := self.spans(link == laws.LINK.index(name)))}

    @cached_property
    def failed(self):
        """The times for which each surface was reported as failed."""
        return self.bits(laws.FAILING, self.word("failed"))

    @cached_property
    def not_valid(self):
        """The same for sensors that the laws rejected."""
        heard = numpy.flatnonzero(self.modes[3] != 0)
        bits = (self.word("invalid_low")
                | self.word("invalid_high") << laws.WORD_BITS)
        if not len(heard):
            return {}
        begins = self.flight.seconds[heard[0]] + SETTLES_S
        return self.bits(laws.SENSORS, numpy.where(
            self.flight.seconds < begins, 0, bits))

    def bits(self, names, words):
        return {name: spans for bit, name in enumerate(names)
                if (spans := self.spans(words >> bit & 1))}

    @cached_property
    def configurations(self):
        """The time, number and table of each accepted configuration."""
        words = self.word("configuration")
        new = numpy.flatnonzero(numpy.diff(words, prepend=0) != 0)
        return [(self.flight.seconds[row],
                 *divmod(int(words[row]), 1 << laws.NIBBLE_BITS))
                for row in new]

    def answer(self):
        """The laws' actions, in a sentence and in numbers."""
        lines = [Line(name, total(spans), "no limit")
                 for name, spans in self.flown.items()]
        lines += [Line(f"link lost: {name}", when(spans),
                       "flies by itself", WARNING)
                  for name, spans in self.alone.items()]
        lines += [Line(f"{name.replace('_', ' ')} failed", when(spans),
                       "never", WARNING)
                  for name, spans in self.failed.items()]
        lines += [Line(f"{name.replace('_', ' ')} not valid", when(spans),
                       "never", CAUTION)
                  for name, spans in self.not_valid.items()]
        lines += [Line(f"configuration {serial} taken",
                       f"{number(at, 2, 's')}, {orders.table_name(table)}",
                       "") for at, serial, table in self.configurations]
        parts = []
        seconds = sum(each.seconds for spans in self.flown.values()
                      for each in spans)
        parts.append(f"a law flew for {number(seconds, 1, 's')}" if seconds
                     else "the pilot flew direct")
        parts += [f"{len(found)} {what}{'' if len(found) == 1 else 's'} {how}"
                  for found, what, how in (
                      (self.failed, "surface", "failed"),
                      (self.not_valid, "sensor", "not believed"))
                  if found]
        if self.alone:
            parts.append("the link was lost: " + ", ".join(self.alone))
        return Answer(
            "What did the control laws do?", "Control laws",
            worst(line.level for line in lines) if lines else WELL,
            sentence("; ".join(parts)), lines)

    def happened(self):
        """Lines for the plot of events."""
        for level, what, found in (
                ("law", "law: {}", self.flown),
                (WARNING, "alone: {}", self.alone),
                (WARNING, "{} failed", self.failed),
                (CAUTION, "{} not valid", self.not_valid)):
            for name, spans in found.items():
                yield {"label": what.format(name.replace("_", " ")),
                       "level": level, "text": "",
                       "spans": [[each.begin, each.end] for each in spans]}


def sentence(text):
    return f"{text[0].upper()}{text[1:]}."


def total(spans):
    """Total seconds of the spans."""
    seconds = number(sum(each.seconds for each in spans), 2, "s")
    return seconds if len(spans) == 1 else f"{seconds}, {len(spans)} times"


def when(spans):
    """The first time, and the number of others."""
    first = (f"{number(spans[0].begin, 2, 's')} to"
             f" {number(spans[0].end, 2, 's')}")
    return first if len(spans) == 1 else f"{first}, and {len(spans) - 1} more"

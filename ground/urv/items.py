# SPDX-License-Identifier: Apache-2.0
"""The meaning of each word: the only table of the station (GND-11).

    items.COLUMNS["gsc.downlink.battery_volts"].value(2760)     27.6
    items.COLUMNS["gsc.downlink.battery_volts"].level(23.0)     "warning"

items.csv is the output of `bin/urv_sim items`, and a test compares the two.
Displays, reports, the mission database and MAVLink take units, scales and
limits from here.
"""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

from urv.tables import TABLES

TABLE = Path(__file__).with_name("items.csv")

LARGEST_WORD = TABLES["largest_word"]
"""The largest word of a converter."""

STALE = 1
"""The bit of an error word: the words before it are from an earlier frame."""

GROUPS = {
    "console": "uplink",
    "gsc.uplink": "uplink",
    "mcs.uplink": "uplink",
    "pwm": "pwm",
    "mcs.downlink": "downlink",
    "gsc.downlink": "downlink",
}
"""The groups of the record's columns, in its order, each with its buffer."""

_LIMITS = ("warning_low", "caution_low", "caution_high", "warning_high")


@dataclass(frozen=True)
class Item:
    """A word of a buffer. A word without a unit is bits, without a scale."""

    name: str
    buffer: str
    position: int
    unit: str
    at_0: float | None
    at_4095: float | None
    warning_low: float | None
    caution_low: float | None
    caution_high: float | None
    warning_high: float | None
    per_word: float | None
    zero_word: int | None
    use: str = ""
    """The function of a switch; empty for other items."""
    works: str = ""
    """The part of the aircraft that a switch works: "laws", "flaps"."""

    @property
    def is_scaled(self) -> bool:
        return self.per_word is not None

    @property
    def label(self) -> str:
        """For people: "battery volts", "switch 8, half flaps"."""
        words = self.name.replace("_", " ")
        if words[-1].isdigit() and words[-2] != " ":
            words = f"{words[:-1]} {words[-1]}"
        return f"{words}, {self.use}" if self.use else words

    @property
    def decimals(self) -> int:
        """The number of useful decimals: a step of the last one is at most ten
        words."""
        if not self.is_scaled or self.unit == "on":
            return 0
        return next(places for places in range(5)
                    if 10.0 ** -places <= 10.0 * self.per_word)

    def value(self, word):
        """The value in the item's unit; of an array of words, each."""
        return self.per_word * (word - self.zero_word)

    def word(self, value: float) -> int:
        """The nearest word."""
        nearest = round(value / self.per_word + self.zero_word)
        return min(max(nearest, 0), LARGEST_WORD)

    @property
    def limits(self) -> dict[str, float]:
        """The existing limits, from the lowest to the highest."""
        found = {name: getattr(self, name) for name in _LIMITS}
        return {name: at for name, at in found.items() if at is not None}

    def level(self, value: float) -> str:
        """"warning", "caution", or an empty text within the limits. A value at
        a limit is within, whatever the rounding of a multiplication."""
        value = round(value, 6)
        for name in ("warning", "caution"):
            low = getattr(self, f"{name}_low")
            high = getattr(self, f"{name}_high")
            if low is not None and value < low:
                return name
            if high is not None and value > high:
                return name
        return ""


def _read():
    def number(text):
        return float(text) if text else None

    with TABLE.open(newline="", encoding="utf-8") as table:
        for row in csv.DictReader(table):
            zero = row["zero_word"]
            yield Item(
                row["name"], row["buffer"], int(row["position"]), row["unit"],
                *(number(row[name]) for name in (
                    "at_0", "at_4095", *_LIMITS, "per_word")),
                int(zero) if zero else None, row["label"], row["works"])


ITEMS = tuple(_read())


def of_buffer(buffer: str) -> list[Item]:
    """The words of a buffer, in order."""
    return [item for item in ITEMS if item.buffer == buffer]


def of_group(group: str) -> list[Item]:
    """The words of a group of columns; the console has no error word."""
    return [item for item in of_buffer(GROUPS[group])
            if (group, item.name) != ("console", "error")]


COLUMNS = {f"{group}.{item.name}": item
           for group in GROUPS for item in of_group(group)}
"""The words of the record, by their column, in its order."""

SWITCHES = tuple(item for item in of_buffer("uplink") if item.use)
"""The pilot's switches, from 1 (GND-50)."""

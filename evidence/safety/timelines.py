# SPDX-License-Identifier: Apache-2.0
"""The words at a converter's channels over time, and the scans that may have
seen them."""

import bisect
import csv
import sys
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from flight_numbers import NUMBERS  # noqa: E402

# Channels are held one after another; the board converts all of them.
SCAN_US = NUMBERS.channels * NUMBERS.conversion_us
TICK_US = NUMBERS.tick_us
FRAME_US = NUMBERS.frame_us


class Scan(NamedTuple):
    """The longest duration of a scan, and its possible beginnings: this time
    after whole multiples of a time, or, about a start, any."""

    lasts_us: int
    grid_us: int
    is_free: bool = False
    offsets_us: tuple = (0,)

    def last_before(self, time):
        """When the last scan began before this time."""
        return max((time - 1 - offset) // self.grid_us * self.grid_us + offset
                   for offset in self.offsets_us)


def to_us(text):
    """Milliseconds with up to three decimals, as microseconds."""
    return round(float(text) * 1000)


def to_word(text):
    text = text.strip()
    return int(text, 16 if text[:2] in ("0x", "0X") else 10)


class Timeline:
    """Words that hold from their time until the next ones'. A channel of
    which nothing is known holds None."""

    def __init__(self, times, words):
        self.times = times
        self.words = words

    def at(self, time):
        """The words just before a time."""
        return self.words[max(0, bisect.bisect_left(self.times, time) - 1)]

    def map(self, change):
        return Timeline(self.times, [change(row) for row in self.words])

    def frozen(self, spans):
        """The same where nothing changes within these spans; what holds at
        the end of a span holds from then on."""
        times, words = [], []
        for first, last in spans:
            for time, row in zip(self.times, self.words, strict=True):
                if (times[-1] if times else -1) < time < first:
                    times.append(time)
                    words.append(row)
            times.append(last)
            words.append(self.at(last + 1))
        for time, row in zip(self.times, self.words, strict=True):
            if not times or time > times[-1]:
                times.append(time)
                words.append(row)
        return Timeline(times, words)

    def until(self, seen, time):
        """Until when these words stood, of a time before this one; None if
        they never did."""
        last = time
        for begins, words in zip(reversed(self.times), reversed(self.words),
                                 strict=True):
            if begins < time and all(
                    one in (other, None)
                    for one, other in zip(words, seen, strict=True)):
                return min(last, time)
            last = begins
        return None

    def earliest_scan(self, seen, first, last, scan):
        """When the earliest scan that sees these words may begin, between
        two times; None if there is none."""
        times, words = self.times, self.words
        begin = max(0, bisect.bisect_right(times, first) - 1)
        for place in range(begin, len(times)):
            if times[place] > last:
                break
            if words[place] == seen:
                return max(first, times[place])
            if self._straddles(seen, place, first, last, scan):
                return max(first, times[place])
        return None

    def _straddles(self, seen, place, first, last, scan):
        """A scan takes the first channels from this place's words, and others
        after the changes that follow."""
        times, words = self.times, self.words
        earliest = max(first, times[place])
        until = last if scan.is_free else last + scan.lasts_us
        crossed = begins = None
        for channel, word in enumerate(seen):
            while words[place][channel] not in (word, None):
                place += 1
                if (channel == 0 or place == len(times)
                        or times[place] > until):
                    return False
                time = times[place]
                # The last one before the change; one that begins with it
                # sees only what is new.
                grid = scan.last_before(time)
                if crossed is None:
                    crossed, begins = time, grid
                if scan.is_free:
                    if time - crossed >= scan.lasts_us:
                        return False
                elif (begins != grid or not earliest <= begins <= last
                        or time - begins >= scan.lasts_us):
                    return False
        return True


def of_script(path, names, neutral):
    """A script of sticks or sensors; columns that it has not hold the
    neutral words."""
    with open(path, newline="", encoding="utf-8-sig") as file:
        rows = [row for row in csv.reader(file) if any(map(str.strip, row))]
    titles = [title.strip() for title in rows[0]]
    time = titles.index("time_ms")
    columns = [titles.index(name) if name in titles else None
               for name in names]
    times, words = [0], [tuple(neutral)]
    for row in rows[1:]:
        at = to_us(row[time])
        if at == times[-1]:
            del times[-1], words[-1]
        times.append(at)
        words.append(tuple(
            other if column is None else to_word(row[column])
            for column, other in zip(columns, neutral, strict=True)))
    return Timeline(times, words)

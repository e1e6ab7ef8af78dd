"""What stood at a converter's channels when, and which scan may have seen
it."""

import bisect
import csv

# Channels are held one after another, 16 us apart; the board converts all 32.
SCAN_US = 512
FRAME_US = 20_000


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

    def earliest_scan(self, seen, first, last, lasts_us):
        """When the earliest scan that sees these words may begin; None if
        there is none. It lies within first and last, takes its channels in
        their order, and takes so long at most."""
        times, words = self.times, self.words
        begin = max(0, bisect.bisect_right(times, first) - 1)
        for place in range(begin, len(times)):
            if times[place] > last:
                break
            if words[place] == seen:
                return max(first, times[place])
            ends = self._mixed(seen, place, last, lasts_us)
            if ends is not None:
                return max(first, times[place], ends - lasts_us)
        return None

    def _mixed(self, seen, place, last, lasts_us):
        """When the last change comes that a scan sees which begins with the
        words of this place; None if it does not see the words sought."""
        times, words = self.times, self.words
        crossed = None
        for channel, word in enumerate(seen):
            while words[place][channel] not in (word, None):
                place += 1
                if place == len(times) or times[place] > last:
                    return None
                if crossed is None:
                    if channel == 0:
                        return None
                    crossed = times[place]
                if times[place] - crossed > lasts_us:
                    return None
        return times[place] if crossed is not None else 0


def of_script(path, names, neutral):
    """A script of sticks or sensors; columns that it has not hold the
    neutral words."""
    with open(path, newline="", encoding="utf-8") as file:
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

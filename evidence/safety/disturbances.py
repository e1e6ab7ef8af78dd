# SPDX-License-Identifier: Apache-2.0
"""When a script of faults disturbs what: the spans from which the monitor
knows how old a command may be, and where a wrong block may come from."""

import bisect
import math
from pathlib import Path

from timelines import FRAME_US, NUMBERS, to_us

NODES = ("gsc", "mcs")
WAYS = ("up", "down")
ENDLESS = 1 << 60

# The time of a start. The tasks run from the next major frame on, and CORE has
# the frame's words after this part of it (docs/starts.md).
START_US = 10_000
CORE_US = 8_000
ROM_READ_US = FRAME_US + 12_000

# The aircraft is switched on so much later at most (--phase).
LARGEST_LAG_US = 18_000

# A message's end, beyond the fault that spoils it.
MESSAGE_US = 10_000

# The fewest characters a frame has each way, when both nodes run.
CHARACTERS = {"up": NUMBERS.exchange_up_characters,
              "down": NUMBERS.exchange_down_characters}


class Spans:
    """Spans of time, merged and in order."""

    def __init__(self, spans):
        self.first, self.last = [], []
        for first, last in sorted(spans):
            if self.first and first <= self.last[-1]:
                self.last[-1] = max(self.last[-1], last)
            else:
                self.first.append(first)
                self.last.append(last)

    def __iter__(self):
        return zip(self.first, self.last, strict=True)

    def touch(self, first, last):
        """True when a span and these times have something in common."""
        place = bisect.bisect_right(self.first, last)
        return place > 0 and self.last[place - 1] >= first

    def within(self, first, last):
        """How much of these times lies in a span."""
        place = bisect.bisect_left(self.last, first)
        total = 0
        while place < len(self.first) and self.first[place] < last:
            total += min(last, self.last[place]) - max(
                first, self.first[place])
            place += 1
        return total

    def skipping(self, time, length):
        """The time at which a duration has passed since a time, without the
        spans."""
        for first, last in self:
            if last > time:
                gone = max(0, first - time)
                if gone >= length:
                    break
                length -= gone
                time = last
        return time + length


def orders(text):
    """The lines of a script, each as time and words; without those about the
    aircraft's surfaces, which disturb no word."""
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words and words[1:2] != ["surface"]:
            yield to_us(words[0]), words[1:]


def servo_faults(path):
    """When the first fault of each servo begins, by its name."""
    found = {}
    text = Path(path).read_text(encoding="utf-8-sig") if path else ""
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if words[1:2] == ["surface"]:
            time = to_us(words[0])
            found[words[2]] = min(time, found.get(words[2], time))
    return found


class Disturbances:
    """The disturbances of one flight.

    line[way]      characters of it may be altered
    stalls         a telemetry board stands still
    consoles       no packet of the pilot's console comes
    scans[node]    the converter stands still, or the scan it delays goes on
    down[node]     no task of the node runs, but for its board
    dead[node]     certainly none runs: it is halted, or has failed its test
    silent[node]   and until CORE has words of a scan again
    starts[node]   the same without the start at power up
    cold[node]     the node may begin again as at power up
    any            all of these
    """

    def __init__(self, script=""):
        line = {way: [] for way in WAYS}
        counted = []
        stalls, consoles, every = [], [], []
        scans = {node: [] for node in NODES}
        events = {node: [] for node in NODES}
        for at, (*before, kind, first, second) in (
                (at, self._spread(words)) for at, words in orders(script)):
            subject = before[0]
            if kind == "cut":
                for way in WAYS:
                    line[way].append((at, at + to_us(first) + MESSAGE_US))
            elif kind in ("ber", "replay"):
                line[subject].append((at, at + to_us(second) + MESSAGE_US))
            elif kind in ("flip", "drop", "dup", "insert"):
                counted.append((at, subject, int(first)))
            elif kind == "console":
                consoles.append((at, at + to_us(first)))
            elif kind == "stall" and first == "telemetry":
                stalls.append((at, at + to_us(second)))
            elif kind == "stall":
                scans[subject].append(
                    (at, at + to_us(second) + 2 * FRAME_US))
            else:
                events[subject].append((at, kind, first))
                # A board that starts again breaks off its message.
                if kind == "reset" and first != "processor":
                    for way in WAYS:
                        line[way].append((at, at + MESSAGE_US))
        self.stalls = Spans(stalls)
        self.consoles = Spans(consoles)
        self.scans = {node: Spans(scans[node]) for node in NODES}
        self.down, self.silent, self.starts, self.dead = {}, {}, {}, {}
        self.cold = {}
        for node in NODES:
            self.cold[node] = Spans(
                (at, at + START_US) for at, kind, first in events[node]
                if kind == "reset" and first == "cold")
            down, dead = self._down(
                node, sorted(events[node], key=lambda event: event[0]))
            again = FRAME_US + CORE_US
            self.dead[node] = Spans(dead)
            self.down[node] = Spans(down)
            self.silent[node] = Spans(
                (first, last + again) for first, last in down)
            self.starts[node] = Spans(
                (first, last + again) for first, last in down
                if last > LARGEST_LAG_US)
        # The Nth character from a time on comes later, the longer the nodes
        # or the line were silent.
        idle = Spans([*self.stalls, *line["up"], *line["down"],
                      *self.silent["gsc"], *self.silent["mcs"]])
        for at, way, count in counted:
            line[way].append((at, idle.skipping(
                at, FRAME_US * (2 + math.ceil(count / CHARACTERS[way])))
                + MESSAGE_US))
        self.line = {way: Spans(line[way]) for way in WAYS}
        for spans in (line["up"], line["down"], stalls,
                      *self.starts.values()):
            every += spans
        self.any = Spans(every)

    @staticmethod
    def _spread(words):
        """Subject, kind and up to two parameters."""
        subject = [words[0]] if words[0] in (*NODES, *WAYS) else [""]
        rest = words[1:] if subject[0] else words
        return [*subject, *rest, "", ""][:4]

    @staticmethod
    def _down(node, events):
        """From when until when no task of the node may run, and from when
        until when certainly none does. A halted node stays down until a reset,
        one that has failed its self-test until a processor restart, which does
        not test the memories."""
        on_by = 0 if node == "gsc" else LARGEST_LAG_US
        spans, dead = [[0, on_by]], []
        armed = tested_until = 0
        # A start that was broken off is made again, with its test.
        tests_until = on_by + START_US
        harmed = min((at for at, kind, _ in events
                      if kind in ("rom", "ram")), default=ENDLESS)
        for at, kind, first in events:
            if kind in ("rom", "ram"):
                if at <= tests_until:
                    spans[-1][1] = ENDLESS
                continue
            if kind == "reset" and first == "telemetry":
                continue
            if at > spans[-1][1]:
                spans.append([at, at])
                armed = 0
            fails = (kind == "reset" and first in ("cold", "warm")
                     and at >= harmed)
            if kind == "reset" and (first != "processor"
                                    or at <= tests_until):
                tests_until = max(tests_until, at + (armed + 1) * START_US)
            if kind == "bus_error":
                # At the next read of the ROM: the self-test of the next start,
                # or the task, at most this time after a start.
                armed += 1
                spans[-1][1] += ROM_READ_US + START_US
                if at <= tested_until and dead:
                    dead[-1][1] = min(dead[-1][1], tested_until - START_US)
            elif kind == "halt" or fails:
                spans[-1][1] = ENDLESS
                is_dead = bool(dead) and dead[-1][1] == ENDLESS
                if fails:
                    tested_until = at + START_US
                if fails and armed:
                    # It may break off the test: what starts then passes.
                    if is_dead:
                        dead[-1][1] = at
                elif at > on_by and not is_dead:
                    dead.append([at, ENDLESS])
            else:
                end = at + START_US + armed * (ROM_READ_US + START_US)
                if at <= tests_until and harmed <= at:
                    end = ENDLESS
                spans[-1][1] = (end if spans[-1][1] >= ENDLESS
                                else max(spans[-1][1], end))
                if dead:
                    dead[-1][1] = min(dead[-1][1], at)
        return spans, dead


def of_file(path):
    return Disturbances(
        Path(path).read_text(encoding="utf-8-sig") if path else "")

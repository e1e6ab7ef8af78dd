#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Looks at the record of a flight for what must never happen (SAF-1 to SAF-6,
SAF-9 to SAF-11, EXT-6). It knows the hazards and the record, and nothing of the
software: docs/evidence/safety-monitor.md says what it checks, and from what its
times come.

    python3 evidence/safety/monitor.py RECORD [--sticks FILE] [--sensors FILE]
            [--faults FILE] [--conditions FILE]
    python3 evidence/safety/monitor.py --gsc RECORD --mcs RECORD

A line for each violation, then a sum; exit status 1 when there is any. The
files are those the flight was given: without --sticks the console is taken to
move only as a frame of the ground begins, as the simulated pilot moves it.

For a test, with this folder in sys.path:

    findings = monitor.check(record, sticks=None, sensors=None, faults=None,
                             conditions=None)
    findings = monitor.check_partitions(gsc=None, mcs=None, starts=(),
                                        disturbed=(), schedule="report")
    assert findings.violations == []

All paths. `findings.violations` is a list of text; `findings.wrong_blocks` has
blocks that the checksum let through though the line had altered them, which a
fault of the line explains: known to happen (D-7), and never silent.

check_partitions takes the record of the ground, of the aircraft, or of both;
rows are joined by clock_us. `starts` are (node, clock_us) of each warm start,
`disturbed` (first_us, last_us) of each time in which something was done to
the link. How late the machine was is measured from the rows' clock_us.
"""

import argparse
import bisect
import itertools
import sys
from pathlib import Path
from typing import NamedTuple

sys.path.insert(0, str(Path(__file__).resolve().parent))

import disturbances  # noqa: E402
import holds  # noqa: E402
import timelines  # noqa: E402
from disturbances import ENDLESS, Spans  # noqa: E402
from safe_words import (  # noqa: E402
    ADDED,
    BRAKE,
    COMMANDS,
    MIDDLE,
    NEUTRAL_SENSORS,
    NEUTRAL_STICKS,
    SAFE_COMMANDS,
    SAFE_ROW,
    SENSORS,
    SERVOS,
    STALE,
    is_by_law,
    is_on,
    law_rows,
    orders_behind,
    orders_of,
    transformed,
    unattended,
    without_inputs,
)
from timelines import FRAME_US, SCAN_US, TICK_US, Scan, Timeline  # noqa: E402

# How old a scan may be when its commands reach the servos: 50 ms, and 20 ms
# until the row (docs/design.md). When anything disturbs link or nodes, a
# block may have waited for a frame, been sent twice with all waiting between,
# and have missed a frame of the aircraft.
CALM_US = 70_000
DISTURBED_US = 110_000

# From the row in which CORE has a message until the other node's row has it:
# commands so much less than from the scan; sensors wait for their command.
UNTIL_ROW_US = 30_000
SENSORS_CALM_US = 80_000
SENSORS_DISTURBED_US = 120_000

# Before the row's time, when the scan began that CORE has as fresh, by
# schedule. The aircraft's frame ends up to 18 ms after the ground's begins;
# in step it may last 2 ms longer. In the fast schedule the scan is the first,
# the second or the third of those that begin 6 ms before CORE.
OWN_SCAN_US = {
    "report": {"gsc": (40_000, 20_000), "mcs": (48_000, 8_000)},
    "fast": {"gsc": (20_000, 20_000 - SCAN_US),
             "mcs": (28_000, 6_000 - 3 * SCAN_US)}}

# Times after a tick at which the aircraft's scans begin, one after the other.
SCAN_OFFSETS_US = {"report": (0,), "fast": (0, SCAN_US, 2 * SCAN_US)}

# A console is lost after this time without a packet; on the ground the safe
# words go up after this time (GND-4). A frame may pass before the ground's
# next scan. The aircraft flies when it is this fast or this high
# (docs/items.md), whatever one of the two says.
CONSOLE_LOST_US = 500_000
CONSOLE_SAFE_US = 2_000_000
FLYING_SPEED, FLYING_HEIGHT = 42 * 32, 100

# The ground knows of the aircraft from downlinks that are this old at most,
# and believes a sensor after a second of good ones. The loss must be known,
# and the safe words must be there, after this time on the ground with a calm
# link and sensors that move less than this. Then a law has let go of the
# throttle.
KNOWN_US = 300_000
ON_GROUND_US = 3_000_000
CALM_WORDS = 50

# In the partitions a row is taken when CORE has the frame's words; between
# the rows that show a message at both ends, and at the console and in CORE.
PARTITION_UP_US = {"calm": 50_000, "disturbed": 90_000}
PARTITION_DOWN_US = {"calm": 60_000, "disturbed": 100_000}
PARTITION_SCAN_US = {"calm": 30_000, "disturbed": 30_000}
# In the fast schedule the ground's row comes 10 ms after its scan, when the
# aircraft may have had the uplink for 6.5: its row was first.
PARTITION_ROW_LATER_US = {"report": 0, "fast": 8_000}


# A test card may run this number of rows after the row that ends it, and before
# the row that shows the commands of its start; its inputs are back at 0 after
# the last number. The largest input in words, 10 degrees of an
# elevator, and its largest step in a frame.
CARD_ROWS = 3
CARD_ROWS_EARLY = 1
INPUT_ROWS = 12
MOST_INPUT = 800
MOST_INPUT_STEP = 150
LINKED = 1
STICK_WORDS = 200
SWITCH_5, SWITCH_7 = COMMANDS.index("switch5"), COMMANDS.index("switch7")

# Without a controller the outputs are safe after this time, and a frame until
# the row. The controller may have touched the board a frame before it stopped.
HOLD_US = 500_000


def is_near(words, rest):
    """Roll, pitch and yaw sticks are where they were at a card's start."""
    return all(abs(word - at) <= STICK_WORDS
               for word, at in zip(words[:3], rest[:3], strict=True))


class Findings(NamedTuple):
    violations: list
    wrong_blocks: list
    rows: int


class Record:
    """A record's rows: the times, and for each buffer its words."""

    def __init__(self, path, time="time_ms"):
        with open(path, encoding="utf-8") as file:
            titles, *lines = file.read().splitlines()
        titles = titles.split(",")
        rows = [line.split(",") for line in lines]
        place = titles.index(time)
        self.times = ([timelines.to_us(row[place]) for row in rows]
                      if time == "time_ms"
                      else [int(row[place]) for row in rows])
        self.counts = {
            name: [int(row[titles.index(name)]) for row in rows]
            for name in ("frame", "overruns") if name in titles}
        self.by_law = law_rows(titles, rows)
        self.failed = ([int(row[titles.index("laws.failed")]) for row in rows]
                       if "laws.failed" in titles else [0] * len(rows))
        truth = [column for column, title in enumerate(titles)
                 if title.startswith("truth.")]
        self.truth = [[row[column] for column in truth] for row in rows]
        for name, group, items in BUFFERS:
            wanted = [f"{group}.{item}" for item in items]
            if wanted[0] not in titles:
                continue
            first = titles.index(wanted[0])
            cells = slice(first, first + len(wanted))
            if titles[cells] != wanted:
                raise ValueError(f"{path}: the columns of {group} are not"
                                 " those of docs/items.md")
            setattr(self, name, self._words(rows, cells))
        self._take_cards(titles, rows)

    def _take_cards(self, titles, rows):
        """The running card and its inputs in each row, if any (FTI-3). The
        servos' words are then those without inputs."""
        self.cards, self.added = [], []
        if "laws.card" not in titles:
            return
        self.cards = [int(row[titles.index("laws.card")]) for row in rows]
        self.links = [int(row[titles.index("laws.link")]) for row in rows]
        first = titles.index(f"laws.added.{ADDED[0]}")
        self.added = self._words(rows, slice(first, first + len(ADDED)))
        where = [int(row[titles.index("laws.card_place")]) for row in rows]
        # The row may be taken between the law's task and that of the servos.
        is_late, before, found = False, None, []
        for place, words in enumerate(self.pwm):
            choices = {late: without_inputs(
                words, self.added[max(place - late, 0)],
                where[max(place - late, 0)])
                for late in (is_late, not is_late)}
            known = {transformed(row[:13])[:len(ADDED)] for row in
                     self.mcs_uplink[max(place - 1, 0):place + 2]}
            known.add(before)
            is_late = next((late for late, each in choices.items()
                            if each[:len(ADDED)] in known), is_late)
            taken = (words if words == unattended(words)
                     else choices[is_late])
            before = taken[:len(ADDED)]
            found.append(taken)
        self.pwm = found

    def lacks_rows(self, place):
        """The row before this one is not that of the frame before."""
        return self._more("frame", place) > 1

    def is_blurred_within(self, first, last):
        """A row between these times, or the next one, is blurred."""
        return any(map(self.is_blurred, range(
            bisect.bisect_left(self.times, first),
            min(bisect.bisect_right(self.times, last) + 1, len(self.times)))))

    def is_blurred(self, place):
        """Rows are missing before this one, or the node's tasks ran late in
        its frame: CORE may have missed a message, or a row what CORE had."""
        if place == 0:
            return self.counts.get("overruns", [0])[0] > 0
        return self.lacks_rows(place) or self._more("overruns", place) > 0

    def _more(self, name, place):
        counts = self.counts.get(name)
        return counts[place] - counts[place - 1] if counts and place else 0

    @staticmethod
    def _words(rows, cells):
        """A buffer's words in each row; the same object while unchanged."""
        found, before, words = [], None, None
        for row in rows:
            if row[cells] != before:
                before = row[cells]
                words = tuple(map(int, before))
            found.append(words)
        return found


# A bit each in laws.failed, and what measures it: docs/surfaces.md.
FAILED_BITS = (*(f"{side}_{name}" for name in (
    "aileron", "elevator", "rudder") for side in ("left", "right")),
    "left_flap_1", "right_flap_1", "left_flap_2", "right_flap_2", "throttle")
SURFACE_BITS = sum(1 << place for place, name in enumerate(FAILED_BITS)
                   if name != "throttle")
MEASURES = {"throttle": ("rpm", "airspeed")}

BUFFERS = (("console", "console", COMMANDS),
           ("gsc_uplink", "gsc.uplink", (*COMMANDS, "error")),
           ("mcs_uplink", "mcs.uplink", (*COMMANDS, "error")),
           ("pwm", "pwm", SERVOS),
           ("mcs_downlink", "mcs.downlink", (*SENSORS, "error")),
           ("gsc_downlink", "gsc.downlink", (*SENSORS, "error")))


def ms(time):
    return f"{time / 1000:.3f}".rstrip("0").rstrip(".")


def is_stale(message):
    return bool(message[-1] & STALE)


def changes(values, first):
    """The rows in which a buffer is not what it was, the first compared with
    what is given."""
    before = first
    for place, words in enumerate(values):
        if words is not before and words != before:
            yield place, before, words
        before = words


def differing(names, before, words):
    return ", ".join(
        f"{name} {old} to {new}"
        for name, old, new in zip(names, before, words, strict=True)
        if old != new)


class Sent:
    """The messages that a node's CORE had, to find where those of the other
    node came from."""

    def __init__(self, times, messages):
        self.times, self.messages = times, messages

    def _places(self, first, last):
        return range(bisect.bisect_left(self.times, first),
                     bisect.bisect_right(self.times, last))

    def between(self, first, last):
        """The messages of the rows between these times."""
        return [self.messages[place] for place in self._places(first, last)]

    def earliest(self, wanted, first, last):
        """The earliest time of a row that has the message."""
        for place in self._places(first, last):
            if self.messages[place] == wanted:
                return self.times[place]
        return None


class Checker:
    """Common to flights of the simulation and of the partitions."""

    def __init__(self):
        self.violations = []
        self.wrong_blocks = []

    def say(self, time, what):
        self.violations.append(f"{ms(time)} ms: {what}")

    def say_wrong(self, time, what):
        self.wrong_blocks.append(
            f"{ms(time)} ms: wrong block passed: {what}")

    def check_link(self, times, values, sent, window, excuse, name, names):
        """Fresh words of the other node in a node's CORE are words that the
        other had, and not older than the words they replace. The rows in which
        it is a wrong block."""
        wrong = set()
        floor = -ENDLESS
        before = (0,) * len(values[0])
        for place, (time, words) in enumerate(
                zip(times, values, strict=True)):
            old, before = before, words
            if is_stale(words):
                continue
            first, last = window(time)
            found = sent.earliest(words, max(first, floor), last)
            if found is not None:
                floor = found
                continue
            reason = excuse(time, first, words, words != old)
            if words == old and place - 1 not in wrong and reason == "wrong":
                reason = None
            if words == old:
                what = f"{name} is shown as fresh, unchanged"
            else:
                what = f"{name}: {differing(names, old, words)}"
            if reason == "wrong":
                wrong.add(place)
                if words != old:
                    self.say_wrong(time, what)
            elif reason is None:
                older = sent.earliest(words, -ENDLESS, last)
                self.say(time, what + (
                    ": the other node never had this" if older is None else
                    f": the other node had this at {ms(older)} ms,"
                    " which is too old"))
        return wrong

    def is_unattended(self, time, before, words):
        """These outputs are those of an aircraft without a controller, and
        it may have none."""
        return False

    def check_marks(self, record, after, near_start,
                    is_blurred=lambda place: False,
                    between_rows=lambda place, words: False):
        """A message that says that it is old moves nothing: what the servos
        do newly is what a message said that does not. CORE may have it after
        `after` rows, or have had it between two. Its words while tasks ran
        late are unknown."""
        times = record.times
        for place, before, words in changes(record.pwm, SAFE_ROW):
            near = record.mcs_uplink[place:place + after + 1]
            if len(near) < after + 1 or is_blurred(place) or near_start(
                    times[place]) or self.is_unattended(
                    times[place], before, words) or (
                    record.by_law[place] and is_by_law(
                        before, words, near, record.failed[place])):
                continue
            if not any(transformed(message[:13]) == words
                       for message in near if not is_stale(message)
                       ) and not between_rows(place + after, words):
                self.say(times[place],
                         f"pwm: {differing(SERVOS, before, words)}: no"
                         " message in mcs.uplink that is not marked as old"
                         " says so")


class Flight(Checker):
    """A flight of the simulation."""

    def __init__(self, record, sticks, sensors, faults, schedule, drift,
                 lock, conditions):
        super().__init__()
        self.servo_faults = disturbances.servo_faults(faults)
        self.measured_wrongly = {*self._scripted(sensors),
                                 *self._with_errors(conditions)}
        self.record = Record(record)
        self.files = record, faults
        self.own_scan_us = OWN_SCAN_US[schedule]
        self.scan_offsets_us = SCAN_OFFSETS_US[schedule]
        self.drifts = drift not in (None, "0")
        self.lock = lock
        self.faults = disturbances.of_file(faults)
        self.console = self._console(sticks).frozen(self.faults.consoles)
        self.orders = self.console.map(orders_of)
        self.sensors = self._sensors(sensors)
        self.fresh_uplinks = Sent(self.record.times, self.record.gsc_uplink)
        self.fresh_downlinks = Sent(self.record.times,
                                    self.record.mcs_downlink)

    def _console(self, sticks):
        times, console = self.record.times, self.record.console
        if sticks:
            line = timelines.of_script(sticks, COMMANDS, NEUTRAL_STICKS)
            for time, words in zip(times, console, strict=True):
                if line.at(time) != words:
                    raise ValueError(
                        f"{sticks}: at {ms(time)} ms the record has"
                        f" another console: {words}, not {line.at(time)}")
            return line
        begins, words = [0], [NEUTRAL_STICKS]
        for place, _, now in changes(console, NEUTRAL_STICKS):
            begins.append(times[place] - FRAME_US)
            words.append(now)
        return Timeline(begins, words)

    @staticmethod
    def _scripted(path):
        """The sensors that a script gives."""
        if not path:
            return []
        with open(path, encoding="utf-8-sig") as file:
            return [title.strip() for title in file.readline().split(",")]

    @staticmethod
    def _with_errors(path):
        """The sensors that the conditions give a bias or noise."""
        lines = (Path(path).read_text(encoding="utf-8").splitlines()
                 if path else [])
        return [words[1] for words in (
                    line.split("#")[0].split() for line in lines)
                if words and words[0] in ("bias", "noise")]

    @classmethod
    def _sensors(cls, path):
        """For the sensors that the script gives; the bench or the aircraft
        moves the others."""
        if not path:
            return None
        titles = cls._scripted(path)
        line = timelines.of_script(path, SENSORS, NEUTRAL_SENSORS)
        known = [name in titles for name in SENSORS]
        return line.map(lambda words: tuple(
            word if is_known else None
            for word, is_known in zip(words, known, strict=True)))

    def run(self):
        if self.record.times:
            self.check_own("gsc", self.record.gsc_uplink, self.console)
            self.check_own("mcs", self.record.mcs_downlink, self.sensors)
            wrong = self.check_link(
                self.record.times, self.record.mcs_uplink,
                self.fresh_uplinks, self.uplink_rows, self.excuse_uplink,
                "mcs.uplink", (*COMMANDS, "error"))
            self.check_servos(wrong)
            self.check_lost_console(wrong)
            self.check_unattended()
            self.check_marks(
                self.record, 1, lambda time: self.faults.starts["mcs"].touch(
                    time - FRAME_US, time + FRAME_US),
                between_rows=self.came_between_rows)
            self.check_link(
                self.record.times, self.record.gsc_downlink,
                self.fresh_downlinks, self.downlink_rows,
                self.excuse_downlink, "gsc.downlink", (*SENSORS, "error"))
            self.check_failed_surfaces()
            self.check_cards()
            self.violations += holds.check(*self.files).not_held
        return Findings(self.violations, self.wrong_blocks,
                        len(self.record.times))

    def check_cards(self):
        """A test card runs only while the pilot's switch 5 is on, laws
        disconnect is off, the link is there, the sticks rest and no surface
        has failed (FTI-4, FTI-5, FTI-6). Its
        inputs are within amplitude and rate, and end with it."""
        record = self.record
        idle = begin = 0
        for place, (time, card, added) in enumerate(zip(
                record.times, record.cards, record.added, strict=False)):
            if place == 0 or card != record.cards[place - 1]:
                begin = place
            idle = 0 if card else idle + 1
            near = range(max(place - CARD_ROWS, 0),
                         min(place + CARD_ROWS_EARLY + 1, len(record.times)))
            messages = [record.mcs_uplink[row] for row in near]
            if card and not any(
                    is_on(words[SWITCH_5]) and not is_on(words[SWITCH_7])
                    for words in messages):
                self.say(time, f"laws.card: card {card} runs, and switch 5 is"
                         " off or laws disconnect on")
            if card and all(record.links[row] != LINKED for row in near):
                self.say(time, f"laws.card: card {card} runs without a link")
            if card and all(record.failed[row] & SURFACE_BITS for row in near):
                self.say(time, f"laws.card: card {card} runs with a failed"
                         " surface")
            rests = record.mcs_uplink[max(begin - CARD_ROWS, 0):
                                      begin + CARD_ROWS_EARLY + 1]
            if card and not any(is_near(words, rest)
                                for words in messages for rest in rests):
                self.say(time, f"laws.card: card {card} runs, and a stick has"
                         " moved")
            if idle > INPUT_ROWS and any(
                    word != MIDDLE for word in added):
                self.say(time, "laws.added: an input without a card:"
                         f" {text(ADDED, added)}")
            if any(abs(word - MIDDLE) > MOST_INPUT for word in added):
                self.say(time, "laws.added: an input beyond its limit:"
                         f" {text(ADDED, added)}")
            if place and not self.faults.starts["mcs"].touch(
                    time - 5 * FRAME_US, time):
                before = record.added[place - 1]
                frames = 1 + round(
                    (time - record.times[place - 1]) / FRAME_US)
                disconnected = any(is_on(words[SWITCH_7])
                                   for words in messages)
                if not disconnected and any(
                        abs(word - old) > frames * MOST_INPUT_STEP
                        for word, old in zip(added, before, strict=True)):
                    self.say(time, "laws.added: faster than its limit:"
                             f" {differing(ADDED, before, added)}")

    def check_failed_surfaces(self):
        """A surface is reported as failed only when a fault of its servo is in
        force. After a crash no surface moves any more."""
        before, stood = 0, None
        for time, failed, truth in zip(
                self.record.times, self.record.failed, self.record.truth):
            if truth and truth == stood:
                return
            new, before, stood = failed & ~before, failed, truth
            for bit, name in enumerate(FAILED_BITS):
                if (new >> bit & 1
                        and self.servo_faults.get(name, ENDLESS) > time
                        and not self.measured_wrongly.intersection(
                            MEASURES.get(name, (name,)))):
                    self.say(time, f"laws.failed: {name} is reported, and no"
                             " fault of its servo is in force")

    def came_between_rows(self, place, words):
        """Two frames of the aircraft may end between two rows, for in step
        they are shorter. CORE may have no row of the words that came in the
        first; the ground's row has them, unmarked."""
        return self.lock and any(
            transformed(message[:13]) == words and not is_stale(message)
            for message in self.fresh_uplinks.between(
                *self.uplink_rows(self.record.times[place])))

    def window(self, time, calm_us, disturbed_us, sender):
        """From when on a scan may have begun whose words arrive newly at
        this time. A stalled telemetry board keeps its block; so does one whose
        node is down and gives it no newer one."""
        faults = self.faults
        if not faults.any.touch(time - disturbed_us, time):
            return time - calm_us
        kept = [faults.stalls, faults.down[sender]]
        first, before = time - disturbed_us, None
        while first != before:
            before = first
            first = time - disturbed_us - sum(
                spans.within(before, time) for spans in kept)
        return first

    def commands_from(self, time):
        return self.window(time, CALM_US, DISTURBED_US, "gsc")

    def uplink_rows(self, time):
        return self.commands_from(time) + UNTIL_ROW_US, time

    def downlink_rows(self, time):
        return (self.window(time, SENSORS_CALM_US, SENSORS_DISTURBED_US,
                            "mcs"), time)

    def scan(self, node, first, last):
        """How a node's converter scans: with each of its frames. When the
        aircraft's begin the record does not say, but at a tick, unless its
        clock drifts."""
        is_slow = self.faults.scans[node].touch(first, last)
        return Scan(
            FRAME_US if is_slow else SCAN_US,
            FRAME_US if node == "gsc" else TICK_US,
            self.faults.silent[node].touch(first, last)
            or node == "mcs" and (is_slow or self.drifts),
            self.scan_offsets_us if node == "mcs" else (0,))

    def check_own(self, node, values, line):
        """Fresh words of its own node in CORE are of the node's scan before
        this one's; while the node is down they may remain."""
        if line is None:
            return
        name = "gsc.uplink" if node == "gsc" else "mcs.downlink"
        names = COMMANDS if node == "gsc" else SENSORS
        early, late = self.own_scan_us[node]
        before = (0,) * len(values[0])
        for time, words in zip(self.record.times, values, strict=True):
            changed, before = words != before, words
            if is_stale(words) or (
                    node == "gsc" and self.is_of_lost_console(time, words)):
                continue
            if line.earliest_scan(
                    words[:-1], time - early, time - late,
                    self.scan(node, time - early, time)) is None:
                if changed or not self.faults.silent[node].touch(time, time):
                    until = line.until(words[:-1], time)
                    self.say(time, f"{name}, shown as fresh: "
                             + text(names, words[:-1]) + (
                                 ": this never stood there"
                                 if until is None else
                                 f": stood there until {ms(until)} ms"))

    def excuse_uplink(self, time, first, words, is_new):
        if not is_new and self.faults.silent["mcs"].touch(time, time):
            return "stands"
        scan = self.commands_from(time)
        # The ground may be down before its CORE has what it sent.
        if self.faults.starts["gsc"].touch(scan, time):
            if self.console.earliest_scan(
                    words[:-1], scan, time,
                    self.scan("gsc", scan, time)) is not None:
                return "sent"
        return "wrong" if self.faults.line["up"].touch(first, time) else None

    def excuse_downlink(self, time, first, words, is_new):
        if not is_new and self.faults.silent["gsc"].touch(time, time):
            return "stands"
        # A frame that ends between two rows, or before a start, has no row of
        # the aircraft's CORE.
        if self.lock or self.faults.starts["mcs"].touch(
                first - 2 * FRAME_US, time):
            if self.sensors is None or self.sensors.earliest_scan(
                    words[:-1], first - 2 * FRAME_US, time,
                    self.scan("mcs", first, time)) is not None:
                return "sent"
        return "wrong" if self.faults.line["down"].touch(first, time) else None

    def is_of_lost_console(self, time, words):
        """While the console is lost for less than 0.5 s, the words of its last
        scan go up; after 2 s the safe words may go up. Whether they may go up,
        check_lost_console says."""
        reach = self.own_scan_us["gsc"][0] + FRAME_US
        for first, last in self.faults.consoles:
            if first <= time < last + reach:
                if words[:-1] == SAFE_COMMANDS:
                    return time >= self.safe_words_from(first)
                if time < first + CONSOLE_LOST_US + reach:
                    scanned = self.last_scan_before(first)
                    return self.console.earliest_scan(
                        words[:-1], scanned, first,
                        self.scan("gsc", scanned, first)) is not None
        return False

    def safe_words_from(self, lost):
        """When the safe words of a lost console may go up first. One that has
        never come has been silent for ever."""
        return (lost + CONSOLE_SAFE_US
                if self.last_scan_before(lost) >= FRAME_US else 0)

    def last_scan_before(self, time):
        """From when on the ground's last scan of a live console may be: none
        is while the node is down, and none need be in less than a frame
        between two silences."""
        before = None
        while time != before:
            before = time
            for first, last in (*self.faults.consoles,
                                *self.faults.down["gsc"]):
                if first < time <= last + FRAME_US:
                    time = first
        return time - FRAME_US

    def held_scan(self, orders, first, time):
        """The last scan before a console was lost, if what went up in these
        times may be that scan's words still."""
        for began, _ in self.faults.consoles:
            if began <= time and first < began + CONSOLE_LOST_US:
                scanned = self.last_scan_before(began)
                found = self.orders.earliest_scan(
                    orders, scanned, began,
                    self.scan("gsc", scanned, began))
                if found is not None:
                    return found
        return None

    def has_safe_words(self, first, time):
        """Safe words may have gone up for a lost console in these times."""
        return any(self.safe_words_from(began) <= time and first <= last
                   for began, last in self.faults.consoles)

    def check_lost_console(self, wrong):
        """A lost console costs no aircraft (SAF-10). While it is lost nothing
        fresh reaches the aircraft but the safe words, and those only on the
        ground; there they do, and the servos have them."""
        times = self.record.times
        for began, last in self.faults.consoles:
            for place in range(
                    bisect.bisect_left(times, began + CONSOLE_LOST_US),
                    bisect.bisect_left(times, last)):
                time, words = times[place], self.record.mcs_uplink[place]
                sent = self.commands_from(time)
                if (sent > began + CONSOLE_LOST_US + FRAME_US
                        and not is_stale(words) and place not in wrong
                        and not self.faults.silent["mcs"].touch(time, time)):
                    self._check_fresh_of_lost(time, place, words)
                if (time > began + CONSOLE_SAFE_US + ON_GROUND_US
                        and self._is_calm_on_ground(place)
                        and (is_stale(words)
                             or words[:-1] != SAFE_COMMANDS
                             or self.record.pwm[place][7:9]
                             != SAFE_ROW[7:9])):
                    self.say(time, "the console is lost on the ground, and"
                             " the safe words have not come")
                    break

    def _check_fresh_of_lost(self, time, place, words):
        if words[:-1] != SAFE_COMMANDS:
            self.say(time, "the console is lost, and mcs.uplink has fresh"
                     " commands: " + text(COMMANDS, words[:-1]))
        elif all(self._flies(row) for row in self._sensors_before(
                place, KNOWN_US)):
            self.say(time, "the console is lost in flight, and the safe words"
                     " reach the aircraft")

    def _sensors_before(self, place, length_us):
        """The aircraft's sensors in the rows of this duration until this
        one."""
        first = bisect.bisect_left(self.record.times,
                                   self.record.times[place] - length_us)
        return self.record.mcs_downlink[first:place + 1]

    @staticmethod
    def _flies(row):
        return (row[SENSORS.index("airspeed")] >= FLYING_SPEED
                or row[SENSORS.index("altitude")] >= FLYING_HEIGHT)

    def _is_calm_on_ground(self, place):
        """For this time nothing has kept the ground from knowing it."""
        time = self.record.times[place]
        if self.faults.any.touch(time - ON_GROUND_US, time) or any(
                spans.touch(time - ON_GROUND_US, time)
                for node in disturbances.NODES
                for spans in (self.faults.scans[node],
                              self.faults.silent[node])):
            return False
        rows = self._sensors_before(place, ON_GROUND_US)
        if any(is_stale(row) or self._flies(row) for row in rows):
            return False
        return all(max(column) - min(column) <= CALM_WORDS
                   for column in zip(*(
                       [row[SENSORS.index(name)]
                        for name in ("airspeed", "altitude",
                                     "pitch_attitude")]
                       for row in rows), strict=True))

    def is_unattended(self, time, before, words):
        return (words == unattended(before)
                and self.faults.down["mcs"].within(time - HOLD_US, time)
                >= HOLD_US - 3 * FRAME_US)

    def check_unattended(self):
        """An aircraft without a controller has safe outputs after half a
        second, and its brake as it was."""
        times, pwm = self.record.times, self.record.pwm
        for first, last in self.faults.dead["mcs"]:
            begin = bisect.bisect_left(times, first + HOLD_US + FRAME_US)
            end = bisect.bisect_left(times, last)
            near = range(max(bisect.bisect_left(times, first) - 1, 0), begin)
            brakes = {pwm[place][BRAKE] for place in near if place < len(pwm)}
            for place in range(begin, end):
                words = pwm[place]
                if words != unattended(words) or words[BRAKE] not in brakes:
                    self.say(times[place],
                             "pwm: frozen outputs: no controller for"
                             f" {ms(times[place] - first)} ms, and the servos"
                             f" are not safe: {text(SERVOS, words)}")
                    break

    def check_servos(self, wrong):
        """New positions of the servos are of a scan within the window, not
        older than that of the positions before."""
        times, uplink = self.record.times, self.record.mcs_uplink
        floor = -ENDLESS
        for place, before, words in changes(self.record.pwm, SAFE_ROW):
            time = times[place]
            if self.is_unattended(time, before, words):
                continue
            first = self.commands_from(time)
            if self.record.by_law[place] and is_by_law(
                    before, words, [*uplink[place:place + 2],
                                    *self._without_row(place, first)],
                    self.record.failed[place]):
                continue
            orders = orders_behind(words)
            found = None if orders is None else self.orders.earliest_scan(
                orders, max(first, floor), time,
                self.scan("gsc", first, time))
            if found is None and orders is not None:
                found = self.held_scan(orders, first, time)
            if found is not None and found >= floor:
                floor = found
                continue
            if words == SAFE_ROW and (
                    self.has_safe_words(first, time)
                    or self.faults.cold["mcs"].touch(
                        time - 2 * FRAME_US, time)):
                floor = max(floor, first)
                continue
            if any(near in wrong
                   and transformed(uplink[near][:13]) == words
                   for near in (place, place + 1)):
                continue
            what = f"pwm: {differing(SERVOS, before, words)}"
            if (self.faults.line["up"].touch(first, time)
                    and self.faults.starts["mcs"].touch(time - FRAME_US,
                                                        time + FRAME_US)):
                self.say_wrong(time, what)
                continue
            self.say(time, what + ": " + self.why(orders, words, first, time))

    def _without_row(self, place, first):
        """Messages of which no row may know: they came after the last row,
        or the aircraft's node started again since."""
        time = self.record.times[place]
        if (place + 1 < len(self.record.times)
                and not self.faults.starts["mcs"].touch(first, time)):
            return []
        line = self.console
        begin = max(bisect.bisect_right(line.times, first) - 1, 0)
        end = bisect.bisect_right(line.times, time)
        return [(*words, 0) for words in line.words[begin:end]]

    def why(self, orders, words, first, time):
        """The violation of these outputs, as text."""
        if orders is None:
            return "no commands give these outputs"
        until = self.orders.until(orders, time)
        if until is not None:
            return (f"the console said so until {ms(until)} ms, before"
                    f" the last {ms(time - first)} ms or what the"
                    " servos did before")
        held = [row for at, row in zip(self.orders.times, self.orders.words,
                                       strict=True) if at <= time]
        unsaid = [name for channel, name in enumerate(COMMANDS)
                  if all(row[channel] != orders[channel] for row in held)]
        if words == SAFE_ROW:
            return "back to the safe words"
        return ("the console never said so: " + ", ".join(unsaid) if unsaid
                else "of no one scan of the console")


def check(record, sticks=None, sensors=None, faults=None,
          schedule="report", drift=None, lock=False, conditions=None):
    """A flight of the simulation, from its record and what it was given."""
    return Flight(record, sticks, sensors, faults, schedule, drift,
                  lock, conditions).run()


class Partitions(Checker):
    """A flight of one or both partitions."""

    def __init__(self, gsc, mcs, starts, disturbed, schedule):
        super().__init__()
        self.row_later_us = PARTITION_ROW_LATER_US[schedule]
        self.gsc = Record(gsc, "clock_us") if gsc else None
        self.mcs = Record(mcs, "clock_us") if mcs else None
        self.starts = {node: Spans((at - FRAME_US, at + 5 * FRAME_US)
                                   for which, at in starts if which == node)
                       for node in disturbances.NODES}
        every = [span for spans in self.starts.values() for span in spans]
        self.disturbed = Spans([*disturbed, *every])
        self.late = Spans(span for record, node in ((self.gsc, "gsc"),
                                                    (self.mcs, "mcs"))
                          if record for span in self._late(record, node))

    def _late(self, record, node):
        """The times in which rows were late, each as long as it was."""
        for before, time in itertools.pairwise(record.times):
            if (time - before > FRAME_US
                    and not self.starts[node].touch(before, time)):
                yield before + FRAME_US, time

    def window(self, time, reach):
        reach = reach["disturbed" if self.disturbed.touch(
            time - reach["disturbed"], time) else "calm"]
        first, before = time - reach, None
        while first != before:
            before = first
            first = time - reach - self.late.within(before, time)
        return first

    def late_before(self, time):
        return self.late.within(time - 10 * FRAME_US, time)

    def run(self):
        gsc, mcs = self.gsc, self.mcs
        if gsc and gsc.times:
            self.check_ground()
        if mcs and mcs.times:
            self.check_marks(
                mcs, 0, lambda time: self.starts["mcs"].touch(time, time),
                mcs.is_blurred)
        if gsc and mcs and gsc.times and mcs.times:
            self.check_link(
                mcs.times, mcs.mcs_uplink,
                Sent(gsc.times, gsc.gsc_uplink),
                lambda time: (self.window(time, PARTITION_UP_US),
                              time + self.row_later_us
                              + self.late_before(time)),
                lambda time, first, words, is_new: self.excuse(
                    "gsc", time, first, is_new),
                "mcs.uplink", (*COMMANDS, "error"))
            self.check_link(
                gsc.times, gsc.gsc_downlink,
                Sent(mcs.times, mcs.mcs_downlink),
                lambda time: (self.window(time, PARTITION_DOWN_US),
                              time + self.late_before(time)),
                lambda time, first, words, is_new: self.excuse(
                    "mcs", time, first, is_new),
                "gsc.downlink", (*SENSORS, "error"))
        return Findings(self.violations, self.wrong_blocks,
                        sum(len(record.times) for record in (gsc, mcs)
                            if record))

    def excuse(self, sender, time, first, is_new):
        """Words that remain while their node starts; words that a node sent
        and then started before its CORE had them, or whose tasks ran late."""
        listener = "mcs" if sender == "gsc" else "gsc"
        if not is_new and self.starts[listener].touch(time, time):
            return "stands"
        if self.starts[sender].touch(first, time):
            return "sent"
        if getattr(self, sender).is_blurred_within(first, time):
            return "sent"
        return "wrong" if self.disturbed.touch(first, time) else None

    def check_ground(self):
        """Fresh words in the ground's CORE were at its last scan."""
        times = self.gsc.times
        before = (0,) * 14
        for place, (time, words) in enumerate(
                zip(times, self.gsc.gsc_uplink, strict=True)):
            changed, before = words != before, words
            if is_stale(words):
                continue
            first = self.window(time, PARTITION_SCAN_US)
            near = place
            while near >= 0 and times[near] >= first:
                # The console's words in a missing row are unknown.
                if (self.gsc.console[near] == words[:-1]
                        or self.gsc.lacks_rows(near)):
                    break
                near -= 1
            else:
                if changed or not (place == 0 or self.starts["gsc"].touch(
                        time, time)):
                    self.say(time, "gsc.uplink, shown as fresh, is not what"
                             " stood at the last scan: "
                             + text(COMMANDS, words[:-1]))


def check_partitions(gsc=None, mcs=None, starts=(), disturbed=(),
                     schedule="report"):
    """A flight of the partitions, from their records."""
    return Partitions(gsc, mcs, starts, disturbed, schedule).run()


def text(names, words):
    return " ".join(f"{name}={word}"
                    for name, word in zip(names, words, strict=True))


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("record", nargs="?", help="of a simulated flight")
    for option in ("sticks", "sensors", "faults", "conditions"):
        parser.add_argument(f"--{option}", help="that the flight was given")
    parser.add_argument("--schedule", choices=sorted(OWN_SCAN_US),
                        default="report", help="that the nodes kept")
    parser.add_argument("--drift", help="of the aircraft's clock")
    parser.add_argument("--lock", action="store_true",
                        help="the aircraft came in step")
    for node in disturbances.NODES:
        parser.add_argument(f"--{node}", help="record of that partition")
    given = parser.parse_args()
    partitions = given.gsc or given.mcs
    if bool(given.record) == bool(partitions):
        parser.error("either a record, or --gsc or --mcs or both")
    try:
        findings = (
            check_partitions(given.gsc, given.mcs, schedule=given.schedule)
            if partitions
            else check(given.record, given.sticks, given.sensors,
                       given.faults, given.schedule, given.drift, given.lock,
                       given.conditions))
    except (OSError, ValueError) as error:
        print(f"monitor.py: {error}", file=sys.stderr)
        return 2
    for line in (*findings.violations, *findings.wrong_blocks):
        print(line)
    print(f"{findings.rows} rows, {len(findings.violations)} violations,"
          f" {len(findings.wrong_blocks)} wrong blocks passed")
    return 1 if findings.violations else 0


if __name__ == "__main__":
    sys.exit(main())

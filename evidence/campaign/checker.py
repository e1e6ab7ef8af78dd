# SPDX-License-Identifier: Apache-2.0
"""Reads a flight's record and wire and says whether the link kept its word.

Knows the protocol from docs/link.md and docs/security.md and nothing of the
flight software.
"""

import bisect
import re
from typing import NamedTuple

import data
import sealed_blocks
from cases import CHARACTER_US, FRAME_US, NUMBERS

# A major frame without a fault: one block each way, see link.* in the record.
CALM_FRAME = (1, 1, 0, 0, 1, 1, 0, 0, 0, 0)
LINK_NAMES = ("uplink_sent", "uplink_received", "uplink_bad",
              "uplink_scrapped", "downlink_sent", "downlink_received",
              "downlink_bad", "downlink_scrapped", "gsc_resets", "mcs_resets")

# Frames within which everything must be as without faults, by the group of
# the shard; else LINK_BOUND, after faults of the link or its boards.
BOUNDS = {"calm": 0, "start": 5}
LINK_BOUND = 3
LONGEST = max(LINK_BOUND, *BOUNDS.values())

# Columns of the record: the frame and its time, the console (an uplink
# without the error word), then the buffers.
UPLINK, DOWNLINK = NUMBERS.uplink_words, NUMBERS.downlink_words
_AT = 2 + (UPLINK - 1) + UPLINK
MCS_UPLINK = slice(_AT, _AT + UPLINK)
_AT = MCS_UPLINK.stop + NUMBERS.pwm_words + DOWNLINK
GSC_DOWNLINK = slice(_AT, _AT + DOWNLINK)
LINK = slice(GSC_DOWNLINK.stop, GSC_DOWNLINK.stop + 10)

# In place of a block's number.
NOTHING_YET = -1
NEVER_SENT = -2

# Error words that a block may have: words without an update in a frame are
# marked as old (SAF-5), as may the first ones after a start.
NO_ERROR, STALE = 0, 1

MESSAGE_LENGTHS = {
    "up": {0x1E: NUMBERS.uplink_characters, 0x4B: 1, 0xD2: 1, 0xCC: 1},
    "down": {0x87: NUMBERS.downlink_characters, 0x2D: 1, 0xD2: 1, 0x33: 1,
             0xCC: 1}}


def is_kept(block, before):
    """Nothing came: the same words, from then on marked as old."""
    words, _, mark = block.rpartition(",")
    words_before, _, mark_before = before.rpartition(",")
    return block == before or (
        words == words_before and int(mark) == int(mark_before) | STALE)


class Wrong(NamedTuple):
    """A block in CORE that never was sent."""

    frame: int
    way: str
    words: tuple


class Flight:
    """The record of a flight: for each frame the age of what CORE holds, whether
    it says of itself that it is old, and what the link counted in it; when
    each character was sent. wire_errors lists wrong messages on the wire and
    wrong counts of them. Came_twice is how many blocks a seal refuses because
    they are repeated."""

    def __init__(self, record, wire, frames, message_format=1, phase=0):
        self.newest = {"up": [], "down": []}
        self.stale = {"up": set(), "down": set()}
        self.link = []
        self.wrong = []
        self.errors = []
        self.wire_errors = []
        self._read_record(record, frames)
        self._read_wire(wire)
        self._check_counts()
        self._check_format(message_format)
        self.came_twice = (sealed_blocks.came_twice(self.said, phase)
                           if message_format == 2 else 0)

    def _read_record(self, path, frames):
        columns = {"up": MCS_UPLINK, "down": GSC_DOWNLINK}
        known = {}
        for way, count in (("up", 13), ("down", 27)):
            known[way] = {f"{data.text(n, count)},{word}": (n, word)
                          for n in range(frames)
                          for word in (NO_ERROR, STALE)}
        last = dict.fromkeys(columns, NOTHING_YET)
        before = dict.fromkeys(columns, "")
        with open(path, encoding="ascii") as record:
            next(record)
            for frame, line in enumerate(record):
                row = line.rstrip("\n").split(",")
                for way, column in columns.items():
                    block = ",".join(row[column])
                    number, mark = known[way].get(
                        block, (NEVER_SENT, NO_ERROR))
                    if mark == STALE:
                        self.stale[way].add(frame)
                    if number != NEVER_SENT:
                        if number < last[way]:
                            self.errors.append(
                                f"frame {frame}: {way} block {number} came"
                                f" after {last[way]}")
                        last[way] = number
                    elif last[way] == NOTHING_YET:
                        number = NOTHING_YET
                    elif not is_kept(block, before[way]):
                        self.wrong.append(
                            Wrong(frame, way, tuple(map(int, row[column]))))
                    before[way] = block
                    self.newest[way].append(number)
                self.link.append(tuple(map(int, row[LINK])))
        if len(self.link) != frames:
            self.errors.append(f"{len(self.link)} frames, not {frames}")

    def _read_wire(self, path):
        with open(path, "rb") as wire:
            text = wire.read()
        self.times = {}
        self.messages = {}
        self.said = {}
        for way in ("up", "down"):
            self.times[way] = [
                int(time) for time in
                re.findall(rb"^(\d+)," + way.encode(), text, re.MULTILINE)]
            sent = bytes.fromhex(b"".join(
                re.findall(rb"," + way.encode() + rb",(..)", text)).decode())
            counts = dict.fromkeys(MESSAGE_LENGTHS[way], 0)
            said = self.said[way] = []
            place = 0
            while place < len(sent):
                first = sent[place]
                length = MESSAGE_LENGTHS[way].get(first)
                if length is None:
                    self.wire_errors.append(
                        f"the {place}th byte {way} begins no message:"
                        f" {first:02x}")
                    break
                counts[first] += 1
                said.append((self.times[way][place],
                             sent[place:place + length]))
                place += length
            self.messages[way] = counts

    def _check_format(self, message_format):
        for way, said in self.said.items():
            blocks = [message[1:-1] for _, message in said if len(message) > 1]
            self.wire_errors += [
                f"{way}: {what}" for what in (
                    sealed_blocks.wrongs(blocks, way) if message_format == 2
                    else sealed_blocks.marked(blocks, way))]

    def _check_counts(self):
        """The boards' counts against what was on the wire."""
        total = dict(zip(LINK_NAMES, self.link[-1], strict=True))
        up, down = self.messages["up"], self.messages["down"]
        for what, on_wire, counted in (
            ("uplink_sent", up[0x1E], total["uplink_sent"]),
            ("downlink_sent", down[0x87], total["downlink_sent"]),
            ("uplink_received", down[0x2D] + down[0xD2],
             total["uplink_received"]),
            ("downlink_received", up[0xD2], total["downlink_received"]),
        ):
            if on_wire != counted:
                self.wire_errors.append(
                    f"{what} is {counted}, on the wire are {on_wire}")
        for bad, on_wire in (("uplink_bad", down[0x33] + down[0xCC]),
                             ("downlink_bad", up[0xCC])):
            if total[bad] < on_wire:
                self.wire_errors.append(
                    f"{bad} is {total[bad]}, on the wire are {on_wire}")
        for way in ("uplink", "downlink"):
            if total[f"{way}_scrapped"] * 2 > total[f"{way}_sent"]:
                self.errors.append(f"{way}: more scrapped than sent twice")
        before = (0,) * 10
        for frame, now in enumerate(self.link):
            if any(new < old for new, old in zip(now, before, strict=True)):
                self.errors.append(f"frame {frame}: a count went back")
            if now[1] > now[0] or now[5] > now[4]:
                self.errors.append(f"frame {frame}: received, never sent")
            before = now

    def learn_lags(self, frame):
        """How old the newest data is when nothing goes wrong."""
        self.lags = {way: frame - newest[frame]
                     for way, newest in self.newest.items()}

    def is_calm(self, frame):
        counted = tuple(new - old for new, old in zip(
            self.link[frame], self.link[frame - 1], strict=True))
        return counted == CALM_FRAME and all(
            self.newest[way][frame] == frame - lag
            and not self.is_new_and_marked(way, frame)
            for way, lag in self.lags.items())

    def is_new_and_marked(self, way, frame):
        """Words that came in this frame say that they are old. Those that
        came sooner than usual say so rightly in the frame after."""
        return frame in self.stale[way] and (
            self.newest[way][frame] != self.newest[way][frame - 1])

    def end_of(self, fault, start_us):
        """When the fault is over."""
        begin = start_us + fault.at_us
        if fault.duration_us is not None:
            return begin + fault.duration_us
        times = self.times[fault.way]
        index = bisect.bisect_left(times, begin) + fault.character - 1
        after = CHARACTER_US * (2 if fault.text.startswith("dup") else 1)
        return times[index] + after

    def recovery(self, case, first, stop):
        """Frames after the one in which the case's last fault ended, until
        all is and stays as without faults; None if that is never."""
        end = max(self.end_of(fault, first * FRAME_US)
                  for fault in case.faults) // FRAME_US
        disturbed = [frame for frame in range(end, stop)
                     if not self.is_calm(frame)]
        if end >= stop or (disturbed and disturbed[-1] == stop - 1):
            return None
        return disturbed[-1] + 1 - end if disturbed else 0

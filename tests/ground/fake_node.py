# SPDX-License-Identifier: Apache-2.0
"""Replaces urv_gsc: replays a record as frame packets, hears a console.

    with FakeNode(record, to=("127.0.0.1", 6003)) as node:
        node.words["gsc.downlink.battery_volts"] = 2200

As a program it replays one until it is ended:

    fake_node.py RECORD [FRAMES_PORT [CONSOLE_PORT]]
"""

import csv
import functools
import random
import socket
import struct
import sys
import threading
import time
from collections import deque
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "ground"))

from urv import packets, recordings  # noqa: E402 - found by the line above

START = 10
HELD_S, NEUTRAL_S = 0.5, 2.0
# More frames than pass in any test, on a slow machine, too.
MOST_HISTORY = 20_000
SAFE = (2048, 2048, 2048, 0, 4095, *[0] * 8)
NO_LOG = (packets.LogRow(),) * packets.ROWS_PER_LOG


@functools.cache
def read(record):
    """Its rows from START on, once for all tests."""
    with open(record, newline="", encoding="ascii") as file:
        rows = [[int(row[column]) for column in packets.COLUMNS]
                for row in csv.DictReader(file)]
    # Before the first downlink there is nothing to see.
    return rows[START:]


def laws_row(*words):
    """The laws' row of a log, with some of its words; the others are 0."""
    words = [*words, *[0] * (7 - len(words))]
    return packets.LogRow(*(high << 16 | low for high, low in zip(
        words[0:6:2], words[1:6:2], strict=True)), words[6])


def recording_of(rows, seed=1):
    """Rows of a recorder, by number."""
    chance = random.Random(seed)
    found = {}
    for number in rows:
        words = [number >> 16, number & 0xFFFF,
                 *(chance.randrange(65536) for _ in range(68))]
        found[number] = (*words, *recordings.sums(words))
    return found


def is_request(data):
    return int.from_bytes(data[24:26]) == packets.RequestPacket.KIND


def blocks_of(row):
    """The four blocks of a row, made independently of the aircraft's code."""
    number = row[0] << 16 | row[1]
    for part in range(4):
        bits = "".join(f"{word:016b}" for word in row[18 * part:18 * part + 18])
        yield with_sum([
            part << 10 | number >> 12, number & 0xFFF,
            *(int(bits[at:at + 12], 2) for at in range(0, 288, 12))])


def with_sum(words):
    words = [*words, *[0] * (26 - len(words))]
    return [*words, sum((2 * place + 1) * word
                        for place, word in enumerate(words)) % 4096]


class Recorder:
    """The aircraft's flight recorder, over the link: rows by number; flies
    refuses, silent answers nothing, a_frame blocks go down in each frame."""

    def __init__(self):
        self.rows = {}
        self.flies = self.silent = False
        self.a_frame = 100
        self._waiting = deque()
        self._to = None

    def ask(self, data, sender):
        high, low, many = packets.RequestPacket.decode(data).words[:3]
        first = max(high << 12 | low, min(self.rows, default=0))
        numbers = (min(self.rows, default=0), len(self.rows), 30_000)
        self._to = sender
        self._waiting = deque([(0x800, with_sum([
            int(self.flies), *(part for number in numbers
                               for part in (number >> 12, number & 0xFFF))]))])
        for number in range(first, first + many):
            if number in self.rows and not self.flies:
                self._waiting.extend((0x700, block) for block
                                     in blocks_of(self.rows[number]))

    def answer(self, socket):
        for _ in range(self.a_frame):
            if self._waiting and not self.silent:
                kind, words = self._waiting.popleft()
                socket.sendto(struct.pack(
                    ">IHHH27H", int.from_bytes(b"URVR"), 1, 64, kind, *words),
                    self._to)


class FakeNode(threading.Thread):
    """words replaces words of the record, cut stops the downlink, silent all
    packets; laws are words of the laws' row; refuses is why orders are refused,
    None when they are lost; speed 0 stops at a row. A packet leaves late_s
    after it was made. sent is the newest packet."""

    def __init__(self, record, to, console_port=0, row=0, pilot=False):
        super().__init__(daemon=True)
        self.rows = read(record)
        self.to = to
        self.row = row
        self.words = {}
        self.cut = self.silent = False
        self.speed = 1
        self.clock_us = 0
        self.late_s = 0.0
        self._waiting = deque()
        self.logs = [list(NO_LOG), list(NO_LOG)]
        self.counts = dict.fromkeys(packets.LINK_COUNTS, 0)
        self.laws = ()
        self.orders = []
        self.cards = []
        self.recorder = Recorder()
        self.refuses = 0
        self.pilot = (packets.Pilot.HANDS_OFF if pilot
                      else packets.Pilot.NONE)
        self.sent = None
        self.history = []
        self.heard = []
        self.sequence = 0
        self.run_number = int(time.time() * 1000) & 0xFFFF_FFFF
        self._old = None
        self._age = 0
        self._due = time.monotonic()
        self._ends = threading.Event()
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", console_port))
        self.socket.setblocking(False)
        self.console_port = self.socket.getsockname()[1]

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self._ends.set()
        self.join()
        self.socket.close()

    def hear(self):
        while True:
            try:
                data, sender = self.socket.recvfrom(2048)
            except BlockingIOError:
                return
            if len(data) == packets.CARD_LENGTH and is_request(data):
                self.recorder.ask(data, sender)
                continue
            if len(data) == packets.CARD_LENGTH:
                self.cards.append(packets.CardPacket.decode(data))
                continue
            if data.startswith(b"URVO"):
                self.obey(packets.OrderPacket.decode(data))
                continue
            try:
                packet = packets.ConsolePacket.decode(data)
            except packets.PacketError:
                self.counts["console_bad"] += 1
                continue
            now = time.monotonic()
            if (self.heard and packet.run != self.heard[-1][1].run
                    and now - self.heard[-1][0] < HELD_S):
                # The first console keeps the sticks.
                self.counts["console_bad"] += 1
                continue
            self.counts["console_packets"] += 1
            self.heard.append((now, packet))
            if self.pilot != packets.Pilot.NONE:
                self.pilot = (
                    packets.Pilot.FLIES if packet.flags
                    else packets.Pilot.HANDS_OFF)

    def obey(self, packet):
        """The aircraft takes an order, refuses it, or nothing comes of it."""
        self.orders.append(packet)
        if self.refuses:
            kind = packets.KINDS.index("configuration_refused")
            row = self.logs[1][kind]
            self.logs[1][kind] = packets.LogRow(
                row.count + 1, 7, 7, self.refuses)
        elif self.refuses is not None:
            self.laws = (*self.laws, *[0] * 6)[:6] + (
                packet.serial << 4 | packet.table,)

    def console(self):
        """State, words and sequence number at the converter."""
        states = packets.ConsoleState
        if not self.heard:
            return states.NONE, None, 0
        came, packet = self.heard[-1]
        silence = time.monotonic() - came
        if silence >= NEUTRAL_S:
            return states.NEUTRAL, SAFE, packet.sequence
        state = states.HELD if silence >= HELD_S else states.LIVE
        return state, packet.words, packet.sequence

    def frame(self):
        words = dict(zip(packets.COLUMNS, self.rows[self.row], strict=True))
        state, sticks, sequence = self.console()
        if sticks is not None and self.pilot != packets.Pilot.FLIES:
            for name, word in zip(packets.COMMANDS, sticks, strict=True):
                words[f"console.{name}"] = words[f"gsc.uplink.{name}"] = word
        words |= self.words
        down = {name: word for name, word in words.items()
                if name.startswith("gsc.downlink")}
        if self.cut:
            self._age += 1
            words |= self._old or {}
        else:
            self._age = 0
            self._old = down
            self.counts["downlink_received"] += 1
        link = (packets.LinkState.LOST if self._age >= 50
                else packets.LinkState.HEARD)
        self.logs[1][packets.LAWS_ROW - 1] = laws_row(*self.laws)
        return packets.FramePacket(
            run=self.run_number, sequence=self.sequence,
            time_us=self._due_us() + self.clock_us,
            downlink_age=self._age,
            console_state=state, link_state=link,
            console_sequence=sequence, counts=tuple(self.counts.values()),
            words=tuple(words[column] for column in packets.COLUMNS),
            logs=tuple(tuple(log) for log in self.logs),
            status=(0,) * len(packets.STATUS), pilot=self.pilot)

    def _due_us(self):
        """UTC of the present frame: a node's frames are 20 ms apart, whenever
        the machine lets it send them."""
        return round(time.time_ns() / 1000
                     + 1e6 * (self._due - time.monotonic()))

    def run(self):
        self._due = time.monotonic()
        while not self._ends.is_set():
            self.hear()
            self.recorder.answer(self.socket)
            if not self.silent:
                self.sent = self.frame()
                self.history.append(self.sent)
                del self.history[:-MOST_HISTORY]
                self._waiting.append((self._due, self.sent.encode()))
                while (self._waiting and self._waiting[0][0] + self.late_s
                       <= self._due):
                    self.socket.sendto(self._waiting.popleft()[1], self.to)
            self.sequence += 1
            self.row = (self.row + self.speed) % len(self.rows)
            self._due += packets.FRAME_S
            self._ends.wait(max(0.0, self._due - time.monotonic()))


if __name__ == "__main__":
    ports = [*map(int, sys.argv[2:]), *(6003, 6004)[len(sys.argv) - 2:]]
    with FakeNode(sys.argv[1], ("127.0.0.1", ports[0]), ports[1],
                  pilot=True) as node:
        node.join()

# SPDX-License-Identifier: Apache-2.0
"""The other end of the telemetry link, written from docs/link.md alone.

    with GroundPeer(port, peer_port, rows) as ground:
        ...
    assert ground.received[-1] == words

A peer speaks over UDP as docs/real-time.md says: a datagram carries one or
more characters. It sends blocks of words and keeps those it was sent. It is
no faster and no slower than it has to be: the ground waits for an answer far
longer than the dead space, for a loaded machine is not the link's fault.
"""

import os
import select
import socket
import threading
import time

from flight_numbers import NUMBERS

COMMAND = 0x4B
GOOD, GOOD_WANTS = 0xD2, 0x2D
BAD, BAD_WANTS = 0xCC, 0x33
UPLINK, DOWNLINK = 0x1E, 0x87
WORDS = {UPLINK: NUMBERS.uplink_words, DOWNLINK: NUMBERS.downlink_words}

# In the last word: the others are those of an earlier scan.
STALE = 1

CHARACTER_S = NUMBERS.character_us / 1e6
DEAD_SPACE_S = NUMBERS.dead_space_characters * CHARACTER_S
IDLE_S = NUMBERS.idle_characters * CHARACTER_S
FRAME_S = NUMBERS.frame_us / 1e6

# A node that is silent for this time is not there.
PATIENCE_S = 300


def be_prompt():
    """The other end of the link is another machine, which is not late when
    this one is busy: its thread goes first, where that is permitted."""
    try:
        os.sched_setscheduler(
            threading.get_native_id(), os.SCHED_FIFO, os.sched_param(1))
    except PermissionError:
        pass


def checksum(data):
    """CRC-8/DARC: x^8 + x^5 + x^4 + x^3 + 1, low bit first, from 0."""
    remainder = 0
    for byte in data:
        remainder ^= byte
        for _ in range(8):
            low = remainder & 1
            remainder >>= 1
            if low:
                remainder ^= 0x9C
    return remainder


def data_message(header, words):
    block = bytes([header]) + b"".join(w.to_bytes(2, "big") for w in words)
    return block + bytes([checksum(block)])


class Peer:
    """A telemetry board and its controller, on a thread of its own."""

    sends = None
    hears = None

    def __init__(self, port, peer_port, words=(), host="127.0.0.1",
                 hold_s=None):
        self.words = list(words)

        # With it each of the words is there for this time, from the beginning
        # on; otherwise each is sent once, the last again and again.
        self.hold_s = hold_s
        self._began = None
        self.received = []
        self.received_at = []
        self.bad = 0
        self.sent = 0
        self.answered = 0
        self._line = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._line.bind((host, port))
        self._to = (host, peer_port)
        self._pending = bytearray()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._live, daemon=True)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._ended.set()
        self._thread.join()
        self._line.close()

    def await_received(self, number):
        """Wait for a number of good data messages."""
        self._await(lambda: len(self.received) >= number)

    def await_answered(self, number):
        """Wait until a number of its own messages were found good."""
        self._await(lambda: self.answered >= number)

    def await_fresh(self, first, number):
        """Wait until a number of those received from that one on are not
        marked as old."""
        self._await(lambda: number <= sum(
            not words[-1] & STALE for words in self.received[first:]))

    @staticmethod
    def _await(condition):
        deadline = time.monotonic() + PATIENCE_S
        while not condition():
            assert time.monotonic() < deadline, "too few messages came"
            time.sleep(0.005)

    def _live(self):
        be_prompt()
        self._began = time.monotonic()
        self._run()

    def _words_after(self, number):
        """The block to send now, after a number of others."""
        if self.hold_s is not None:
            number = int((time.monotonic() - self._began) / self.hold_s)
        return self.words[min(number, len(self.words) - 1)]

    def _send(self, data):
        try:
            self._line.sendto(bytes(data), self._to)
        except OSError:
            pass

    def _character(self, limit_s):
        """The next character, or None when none comes in time."""
        if not self._pending:
            ready, _, _ = select.select([self._line], [], [], limit_s)
            if ready:
                try:
                    self._pending += self._line.recv(4096)
                except OSError:
                    pass
        return self._pending.pop(0) if self._pending else None

    def _be_silent(self, for_s):
        """Wait until the line was silent for this time."""
        self._pending.clear()
        while self._character(for_s) is not None and not self._ended.is_set():
            self._pending.clear()

    def _rest_of_data(self, limit_s):
        """Reads the rest of a data message after its header: is it good?"""
        block = bytearray([self.hears])
        length = 2 * WORDS[self.hears] + 2
        while len(block) < length:
            character = self._character(limit_s)
            if character is None:
                break
            block.append(character)
        if len(block) < length or checksum(block[:-1]) != block[-1]:
            self.bad += 1
            return False
        self.received_at.append(time.monotonic())
        *words, last = (int.from_bytes(block[i:i + 2], "big")
                        for i in range(1, length - 1, 2))
        # A sensor's spare bits have the frame of the downlink (FTI-9).
        self.received.append((*(word & 0xFFF for word in words), last))
        return True


class GroundPeer(Peer):
    """The bus master: sends commands, asks for what the aircraft has."""

    sends, hears = UPLINK, DOWNLINK
    patience_s = 0.050

    def _run(self):
        self._be_silent(IDLE_S)
        while not self._ended.is_set():
            began = time.monotonic()
            words = self._words_after(self.sent)
            self.sent += 1
            for _ in range(2):
                if self._exchange(words):
                    break
                self._be_silent(IDLE_S)
            self._ended.wait(max(0, began + FRAME_S - time.monotonic()))

    def _exchange(self, words):
        self._send(data_message(UPLINK, words))
        answer = self._character(self.patience_s)
        if answer not in (GOOD, GOOD_WANTS):
            return False
        self.answered += 1
        if answer == GOOD_WANTS:
            for _ in range(2):
                self._send([COMMAND])
                if self._character(self.patience_s) == DOWNLINK:
                    good = self._rest_of_data(self.patience_s)
                    self._send([GOOD if good else BAD])
                    break
                self._be_silent(IDLE_S)
        return True


class AircraftPeer(Peer):
    """The slave: answers, and sends its words when it is commanded."""

    sends, hears = DOWNLINK, UPLINK

    def _run(self):
        commanded = False
        place = 0
        while not self._ended.is_set():
            character = self._character(0.1)
            if character is None:
                continue
            if character == UPLINK:
                good = self._rest_of_data(DEAD_SPACE_S * 10)
                self._send([GOOD_WANTS if good else BAD_WANTS])
            elif character == COMMAND:
                words = self._words_after(place)
                self._send(data_message(DOWNLINK, words))
                self.sent += 1
                commanded = True
            elif character in (GOOD, BAD) and commanded:
                commanded = False
                if character == GOOD:
                    self.answered += 1
                    place += 1
            else:
                self._be_silent(DEAD_SPACE_S)

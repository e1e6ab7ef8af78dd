# SPDX-License-Identifier: Apache-2.0
"""The station's side of the ground's partition, for tests: it takes frame
packets, and sends console packets.

Both go by the frames' numbers and times, which the node gives, not by when
they come.
"""

import itertools
import socket
import sys
import threading
import time

from conftest import ROOT, TIME_LIMIT_S

sys.path.insert(0, str(ROOT / "ground"))

from urv.packets import (  # noqa: E402
    CardPacket, ConsoleFlags, ConsolePacket, FramePacket, OrderPacket)

# A console sends so often.
PERIOD_S = 0.02


def utc_us():
    return time.time_ns() // 1000


class Frames:
    """The frame packets that come, in their order."""

    def __init__(self):
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.place = f"udp:127.0.0.1:{self._socket.getsockname()[1]}"
        self.all = []
        self._more = threading.Condition()
        self._thread = threading.Thread(target=self._take, daemon=True)
        self._thread.start()

    def _take(self):
        while data := self._socket.recv(4096):
            packet = FramePacket.decode(data)
            with self._more:
                self.all.append(packet)
                self._more.notify_all()

    def wait_until(self, shows):
        """The first packet from now on that shows something."""
        deadline = time.monotonic() + TIME_LIMIT_S
        with self._more:
            for place in itertools.count(len(self.all)):
                while len(self.all) <= place:
                    left = deadline - time.monotonic()
                    assert left > 0, (
                        "no frame shows it, of"
                        f" {len(self.all)} the last is {self.all[-1:]}")
                    self._more.wait(left)
                if shows(self.all[place]):
                    return self.all[place]

    def show_within(self, number, shows):
        """True if one of the next packets shows something."""
        left = itertools.count(number - 1, -1)
        return shows(self.wait_until(
            lambda packet: shows(packet) or next(left) == 0))

    def wait_for(self, number):
        """A number of further packets."""
        for _ in range(number):
            self.wait_until(lambda _: True)

    def finish(self):
        """Takes what has come by now, and nothing more."""
        end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        end.sendto(b"", self._socket.getsockname())
        self._thread.join(TIME_LIMIT_S)
        end.close()

    def close(self):
        if self._thread.is_alive():
            self.finish()
        self._socket.close()


class Console:
    """A console that sends the same words again and again."""

    def __init__(self, port, run=1):
        self.place = f"udp:127.0.0.1:{port}"
        self.sent = {}
        self.run = run
        self.words = None
        self.flags = ConsoleFlags(0)
        self._to = ("127.0.0.1", port)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._lock = threading.Lock()
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._repeat, daemon=True)
        self._thread.start()

    def _repeat(self):
        while not self._ended.wait(PERIOD_S):
            with self._lock:
                if self.words is not None:
                    self.send()

    def send(self, **changes):
        """The next packet, or another one."""
        sequence = changes.pop("sequence", len(self.sent) + 1)
        packet = ConsolePacket(**{
            "run": self.run, "sequence": sequence, "time_us": utc_us(),
            "words": self.words, "flags": self.flags, **changes})
        self.sent.setdefault(sequence, packet)
        self.send_bytes(packet.encode())
        return packet

    def order(self, serial, table, orbit, end, **changes):
        """A configuration, with the next number: so it follows the sticks,
        which then must not be those of another packet."""
        with self._lock:
            sequence = changes.pop("sequence", len(self.sent) + 1)
            packet = OrderPacket(**{
                "run": self.run, "sequence": sequence, "time_us": utc_us(),
                "serial": serial, "table": table, "orbit": orbit, "end": end,
                **changes})
            self.sent.setdefault(sequence, packet)
            self.send_bytes(packet.encode())
            return packet

    def card(self, words):
        """The block of a test card, as an order."""
        with self._lock:
            packet = CardPacket(
                self.run, len(self.sent) + 1, utc_us(), words)
            self.sent[packet.sequence] = packet
            self.send_bytes(packet.encode())
            return packet

    def send_bytes(self, data):
        self._socket.sendto(data, self._to)

    def move(self, words, flags=ConsoleFlags(0)):
        with self._lock:
            self.words, self.flags = words, flags

    def fall_silent(self):
        """The last packet that was sent."""
        with self._lock:
            self.words = None
            return self.sent[len(self.sent)]

    def close(self):
        self._ended.set()
        self._thread.join()
        self._socket.close()

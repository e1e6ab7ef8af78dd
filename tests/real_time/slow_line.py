# SPDX-License-Identifier: Apache-2.0
"""A network between two partitions: each datagram comes out so much later.

    with SlowLine(ports, delay_s=0.0012) as line:
        start("gsc", line.ground)
        start("mcs", line.aircraft)
        ...
        assert line.latest_s < 0.0005

It never sends a datagram early. How late it was itself, on a busy machine,
`latest_s` says.
"""

import heapq
import itertools
import select
import socket
import threading
import time

from peer import be_prompt

HOST = "127.0.0.1"


class SlowLine:
    """Four ports of this machine: the nodes' and the line's two ends."""

    def __init__(self, ports, delay_s):
        ground, at_ground, aircraft, at_aircraft = ports
        self.ground = f"udp:{HOST}:{ground}:{HOST}:{at_ground}"
        self.aircraft = f"udp:{HOST}:{aircraft}:{HOST}:{at_aircraft}"
        self.delay_s = delay_s
        self.latest_s = 0.0
        self.carried = 0
        self._ends = []
        for own, node in ((at_ground, ground), (at_aircraft, aircraft)):
            end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            end.bind((HOST, own))
            end.connect((HOST, node))
            end.setblocking(False)
            self._ends.append(end)
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._carry, daemon=True)

    def __enter__(self):
        self._thread.start()
        return self

    def __exit__(self, *_):
        self._over.set()
        self._thread.join()
        for end in self._ends:
            end.close()

    def _carry(self):
        be_prompt()
        one, other = self._ends
        to = {one: other, other: one}
        coming, numbers = [], itertools.count()
        while not self._over.is_set():
            # The last half millisecond is waited for awake.
            now = time.monotonic()
            left = coming[0][0] - now if coming else 0.05
            ready, _, _ = select.select(
                self._ends, [], [], max(0.0, min(left - 0.0005, 0.05)))
            now = time.monotonic()
            for end in ready:
                try:
                    data = end.recv(4096)
                except OSError:  # nobody is there yet
                    continue
                heapq.heappush(
                    coming, (now + self.delay_s, next(numbers), to[end], data))
            while coming and coming[0][0] <= time.monotonic():
                due, _, end, data = heapq.heappop(coming)
                try:
                    end.send(data)
                except OSError:
                    continue
                self.carried += 1
                self.latest_s = max(self.latest_s, time.monotonic() - due)

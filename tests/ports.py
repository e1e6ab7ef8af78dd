# SPDX-License-Identifier: Apache-2.0
"""Ports for tests that run at once, of TCP and UDP.

A port that is found free is taken a little later only. The system gives none
of these to a program that asks for any port, each worker has its own, and none
is given twice before all of them were.
"""

import itertools
import os
import random
import socket

WORKER = int(os.environ.get("PYTEST_XDIST_WORKER", "gw0")[2:])
MOST_WORKERS = 16
PLACES = range(20_000 + 10 * (WORKER % MOST_WORKERS), 32_000,
               10 * MOST_WORKERS)
IN_TURN = itertools.cycle(random.sample(PLACES, len(PLACES)))


def free_ports(count):
    """A number of free ports in a row, 10 at most."""
    for first in itertools.islice(IN_TURN, len(PLACES)):
        ports = range(first, first + count)
        held = []
        try:
            for port in ports:
                for kind in (socket.SOCK_DGRAM, socket.SOCK_STREAM):
                    one = socket.socket(socket.AF_INET, kind)
                    held.append(one)
                    one.bind(("127.0.0.1", port))
            return ports
        except OSError:
            continue
        finally:
            for one in held:
                one.close()
    raise AssertionError("no free ports")

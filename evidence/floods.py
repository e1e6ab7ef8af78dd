#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the delay of a node's ticks by a flood (RTP-3).

    evidence/floods.py [SECONDS]    needs bin/urv_mcs (make real_time), or
                                   that of the folder URV_PARTITIONS

Flies the aircraft's node three times: beside nothing; beside a flood of
100,000 datagrams a second to a port that is not its own; and with that flood
to its port from its peer's address. Prints the delay of its clock's ticks, in us.
"""

import json
import multiprocessing
import os
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PARTITIONS = Path(os.environ.get("URV_PARTITIONS", ROOT / "bin"))
RATE = 100_000
AT_ONCE = 100


def flood(source, target, ended, sent):
    end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    end.bind(("127.0.0.1", source))
    due = time.monotonic()
    while not ended.is_set():
        for number in range(AT_ONCE):
            try:
                end.sendto(bytes([number]), ("127.0.0.1", target))
            except ConnectionRefusedError:
                pass
        sent.value += AT_ONCE
        due += AT_ONCE / RATE
        time.sleep(max(0, due - time.monotonic()))


def flown(seconds, source=None, target=None):
    ended, sent = multiprocessing.Event(), multiprocessing.Value("q", 0)
    flooder = source and multiprocessing.Process(
        target=flood, args=(source, target, ended, sent))
    with tempfile.TemporaryDirectory() as folder:
        summary = Path(folder, "summary.json")
        node = subprocess.Popen(
            [PARTITIONS / "urv_mcs", "--quiet", "--seconds", str(seconds),
             "--link", "udp:127.0.0.1:7101:127.0.0.1:7102",
             "--summary", summary])
        if flooder:
            time.sleep(0.2)
            flooder.start()
        status = node.wait()
        ended.set()
        if flooder:
            flooder.join()
        # Beside floods it is alone: its peer is never heard.
        if status not in (0, 3):
            sys.exit(f"urv_mcs ended with status {status}")
        return json.loads(summary.read_text("utf-8")), sent.value / seconds


def main(seconds=10):
    beside = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    beside.bind(("127.0.0.1", 7103))
    for name, places in (("no flood", ()), ("beside it", (7104, 7103)),
                         ("from its peer", (7102, 7101))):
        summary, rate = flown(seconds, *places)
        print(f"{name}: {rate:.0f} datagrams a second,"
              f" {summary['link']['bytes_discarded']} discarded,"
              f" ticks late {summary['release_jitter_us']}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))

# SPDX-License-Identifier: Apache-2.0
"""bin/urv ground for tests, and what its Yamcs has archived.

    with Ground(tmp_path) as ground:
        ground.wait(lambda state: state["seq"] > 100, "100 frames")
    assert ground.status == 0
"""

import csv
import json
import os
import resource
import shutil
import signal
import subprocess
import urllib.request
from collections import Counter
from datetime import UTC, datetime, timedelta
from pathlib import Path

import pytest
from ports import free_ports
from station_rig import PATIENCE_S, ROOT, until

from urv import items

needs_yamcs = pytest.mark.skipif(
    not (shutil.which("java") and (ROOT / "obj/yamcs/lib").is_dir()),
    reason="there is no Yamcs: scripts/setup.sh ground gets it with Maven")


def is_running(process):
    """False, too, for one that has ended and is not yet collected by init,
    which on a slow machine takes its time."""
    try:
        stat = Path(f"/proc/{process}/stat").read_text()
    except OSError:
        return False
    return stat.rpartition(")")[2].split()[0] not in "ZX"


class Ground:
    """bin/urv ground with ports of its own."""

    def __init__(self, folder, *options, most_bytes=None, terminal=None):
        self.folder = folder / "flight"
        self.options = options
        # The text of each file that it writes, and of its standard output,
        # else the log.
        self.most_bytes = most_bytes
        self.terminal = terminal
        self.log = folder / "ground.log"

    def __enter__(self):
        ports = free_ports(7)[0]
        self.page_port, self.yamcs_port = ports + 5, ports + 6
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                [ROOT / "bin" / "urv", "ground", "--folder", self.folder,
                 "--ports", str(ports), "--page-port", str(self.page_port),
                 "--yamcs-port", str(self.yamcs_port), *self.options],
                stdin=subprocess.DEVNULL, stdout=self.terminal or log,
                stderr=log, preexec_fn=self.be_limited)
        until(self.is_there, "a station", 2 * PATIENCE_S)
        assert self.process.poll() is None, self.said()
        return self

    def has_summaries(self):
        """Both nodes run: each has written a first version of its summary."""
        return all((self.folder / f"{name}.json").exists()
                   for name in ("ground", "aircraft"))

    def __exit__(self, *_):
        started = self.started()
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
        self.status = self.process.wait(PATIENCE_S)
        assert self.left() == [], self.said()
        assert not list(filter(is_running, started)), self.said()

    def be_limited(self):
        if self.most_bytes is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE,
                               (self.most_bytes, self.most_bytes))

    def is_there(self):
        """True if its page is, or it has ended."""
        if self.terminal is None:
            return ("page to fly" in self.said()
                    or self.process.poll() is not None)
        try:
            self.state()
        except OSError:
            return self.process.poll() is not None
        return True

    def said(self):
        return self.log.read_text("utf-8")

    def good_status(self):
        """The exit status of a flight without a fault: 3 when a slow machine
        has ended it before the link was there."""
        states = {
            json.loads((self.folder / f"{name}.json").read_text("utf-8"))
            ["link"]["state"] for name in ("ground", "aircraft")}
        return 3 if "never heard" in states else 0

    def started(self):
        """Processes below bin/urv ground. One that has a key may be looked
        into by root alone: whose child it is everybody may know."""
        parents = {}
        for stat in Path("/proc").glob("[0-9]*/stat"):
            try:
                after_name = stat.read_text().rpartition(")")[2]
            except OSError:
                continue
            parents[int(stat.parent.name)] = int(after_name.split()[1])
        found, new = set(), {self.process.pid}
        while new:
            new = {child for child, parent in parents.items() if parent in new}
            found |= new
        return found

    def left(self):
        """Processes in this flight's folder, whoever their parent is."""
        found = []
        for process in Path("/proc").glob("[0-9]*"):
            try:
                if Path(os.readlink(process / "cwd")) == self.folder:
                    found.append(int(process.name))
            except OSError:
                continue
        return found

    def named(self, word):
        """The process of the flight with that word in its command line."""
        for process in sorted(self.started()):
            try:
                line = Path(f"/proc/{process}/cmdline").read_bytes()
            except OSError:
                continue
            if word.encode() in line:
                return process
        raise AssertionError(f"no process {word}")

    def state(self):
        with urllib.request.urlopen(
                f"http://127.0.0.1:{self.page_port}/api/state",
                timeout=PATIENCE_S) as answer:
            return json.load(answer)

    def wait(self, condition, what):
        def look():
            state = self.state()
            return state if condition(state) else None
        return until(look, what, 3 * PATIENCE_S)

    def record(self, name="ground"):
        with (self.folder / f"{name}.csv").open(newline="") as file:
            return list(csv.DictReader(file))


def calibrated(column, row):
    return items.COLUMNS[column].value(int(row[column]))


class Archive:
    """The frames and values that a flight's Yamcs has, through its API."""

    def __init__(self, ground):
        from yamcs.client import YamcsClient
        self.client = YamcsClient(
            f"localhost:{ground.yamcs_port}").get_archive("urv")
        now = datetime.now(UTC)
        self.span = {"start": now - timedelta(hours=1),
                     "stop": now + timedelta(hours=1)}

    def events(self):
        return list(self.client.list_events(**self.span))

    def fetch(self, last, columns):
        """Waits until the frame of that number is there. Yamcs on a busy
        machine is late, and later when it is asked for everything."""
        until(lambda: self._newest() >= last, "the last frame",
              5 * PATIENCE_S, pause=0.5)
        self.stored = [(packet.sequence_number, packet.generation_time)
                       for packet in self._packets(page_size=500)]
        self.values = {
            column: until(lambda column=column: self._values(column), "values")
            for column in columns}

    def _newest(self):
        newest = next(iter(self._packets(page_size=1, descending=True)), None)
        return newest.sequence_number if newest else -1

    def _packets(self, **more):
        return self.client.list_packets(name="/URV/frame", **self.span, **more)

    def _values(self, column):
        from yamcs.client import YamcsError
        try:
            return {
                value.generation_time: value.eng_value for value in
                self.client.list_parameter_values(
                    "/URV/" + column.replace(".", "/"), page_size=500,
                    **self.span)}
        except YamcsError:
            # It does not like to be read while it writes.
            return None

    def compare(self, record, columns):
        """Every frame of the record is there up to the last one stored, and
        each value is the record's. Gives how many frames and values."""
        rows = {int(row["frame"]): row for row in record}
        sequences = sorted(sequence for sequence, _ in self.stored)
        assert sequences == [frame for frame in sorted(rows)
                             if frame <= sequences[-1]]
        # A list of values has one of two frames in the same millisecond.
        times = Counter(time for _, time in self.stored)
        at = {time: sequence for sequence, time in self.stored
              if times[time] == 1}
        compared = 0
        for column in columns:
            common = at.keys() & self.values[column].keys()
            assert len(common) > 100, column
            for time in common:
                assert self.values[column][time] == pytest.approx(
                    calibrated(column, rows[at[time]]), abs=1e-4)
            compared += len(common)
        return len(sequences), compared

# SPDX-License-Identifier: Apache-2.0
"""FTI-10, FTI-11: the flight recorder of the partitions, in a file that
survives a kill, and fetched over a line with errors."""

import random
import select
import signal
import socket
import subprocess
import sys
import threading
import time

import pytest
from conftest import PROGRAMS, ROOT, TIME_LIMIT_S, udp
from peer import be_prompt
from ports import free_ports

sys.path.insert(0, str(ROOT / "ground"))

from urv import recordings  # noqa: E402

URV = ROOT / "bin" / "urv"
FAST_AND_HIGH, STANDING = "2560,2000", "320,40"
HELD = 60
"""Rows of the ring in these flights."""


def sensors(folder, lands_ms):
    path = folder / "sensors.csv"
    path.write_text(
        f"time_ms,airspeed,altitude\n0,{FAST_AND_HIGH}\n"
        f"{lands_ms},{STANDING}\n", "ascii")
    return path


def started(node, folder, link, *options):
    return subprocess.Popen(
        [PROGRAMS[node], "--link", link, "--quiet", *map(str, options)],
        cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


class Line:
    """Carries datagrams between two nodes, with bit errors."""

    def __init__(self, ports, share):
        ground, at_ground, aircraft, at_aircraft = ports
        self.links = udp(aircraft, at_aircraft), udp(ground, at_ground)
        self.share = share
        self.chance = random.Random(1)
        self.wrong = 0
        self.ends = []
        for own, node in ((at_ground, ground), (at_aircraft, aircraft)):
            end = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
            end.bind(("127.0.0.1", own))
            end.connect(("127.0.0.1", node))
            self.ends.append(end)
        self.over = threading.Event()
        self.thread = threading.Thread(target=self.carry, daemon=True)

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.over.set()
        self.thread.join()
        for end in self.ends:
            end.close()

    def carry(self):
        be_prompt()
        to = dict(zip(self.ends, reversed(self.ends), strict=True))
        while not self.over.is_set():
            for end in select.select(self.ends, [], [], 0.1)[0]:
                try:
                    to[end].send(self.disturbed(end.recv(4096)))
                except OSError:
                    pass

    def disturbed(self, data):
        found = bytearray(data)
        for place in range(8 * len(found)):
            if self.chance.random() < self.share:
                found[place // 8] ^= 1 << place % 8
                self.wrong += 1
        return bytes(found)


@pytest.fixture
def flight(tmp_path):
    """Both nodes on a line with errors; the console's port."""
    programs = []

    def begin(share, lands_ms=3_000):
        *ports, console = free_ports(5)
        line = Line(ports, share)
        programs.append(line)
        line.__enter__()
        for node, link, *options in (
                ("mcs", line.links[0], "--sensors",
                 sensors(tmp_path, lands_ms), "--recording",
                 tmp_path / "aboard.recording", "--recorder",
                 HELD / 50, "--laws", "off"),
                ("gsc", line.links[1], "--console",
                 f"udp:127.0.0.1:{console}")):
            programs.append(started(node, tmp_path, link, *options))
        line.console = f"udp:127.0.0.1:{console}"
        line.programs = programs[1:]
        return line

    yield begin
    for each in reversed(programs):
        if isinstance(each, Line):
            each.__exit__()
        else:
            each.kill()
            each.wait()


def await_rows(path, wanted):
    """The recording has come to a state; its rows."""
    deadline = time.monotonic() + TIME_LIMIT_S
    while True:
        try:
            rows = recordings.Recording(path).rows
        except Exception:  # noqa: BLE001 - not there yet, or empty
            rows = []
        if wanted(rows):
            return rows
        assert time.monotonic() < deadline, len(rows)
        time.sleep(0.2)


def has_landed(rows):
    """The last row is the last one after a landing."""
    standing = [row for row in rows if row[4 + 24] < 42 * 32]
    return len(standing) >= 49


def fetch(folder, line, *options):
    return subprocess.run(
        [URV, "recorder", "fetch", folder / "fetched.recording", "--console",
         line.console, *options], capture_output=True, text=True,
        timeout=4 * TIME_LIMIT_S, check=False)


def test_fti10_a_recorder_fetched_with_errors_of_1e3_is_complete(
        tmp_path, flight):
    line = flight(1e-3)
    aboard = await_rows(tmp_path / "aboard.recording", has_landed)
    # On a starved machine the link may be lost for a moment.
    for _ in range(20):
        result = fetch(tmp_path, line)
        if "state is not known" not in result.stderr:
            break
    assert result.returncode == 0, result.stderr
    assert line.wrong > 100
    fetched = recordings.Recording(tmp_path / "fetched.recording")
    assert fetched.cut_short is None
    assert fetched.rows == aboard[-HELD:]
    # Both are records for the other commands.
    out = tmp_path / "record.csv"
    subprocess.run([URV, "convert", tmp_path / "fetched.recording", out],
                   check=True, timeout=TIME_LIMIT_S)
    assert len(out.read_text("utf-8").splitlines()) == HELD + 1


def test_fti10_in_flight_the_fetch_says_why(tmp_path, flight):
    line = flight(0, lands_ms=10_000_000)
    await_rows(tmp_path / "aboard.recording", lambda rows: len(rows) > 50)
    result = fetch(tmp_path, line)
    assert result.returncode == 1
    assert "refused: the aircraft flies" in result.stderr


def test_fti10_without_a_node_the_fetch_says_so(tmp_path, flight):
    line = flight(0)
    for program in line.programs:
        program.kill()
        program.wait()
    result = fetch(tmp_path, line)
    assert result.returncode == 1
    assert "nothing listens there" in result.stderr


def test_fti11_a_killed_node_leaves_rows_of_its_last_second(tmp_path):
    own, other = free_ports(2)
    path = tmp_path / "aboard.recording"
    program = started("mcs", tmp_path, udp(own, other), "--recording", path,
                      "--record", tmp_path / "record.csv")
    try:
        await_rows(path, lambda rows: len(rows) > 100)
    finally:
        program.send_signal(signal.SIGKILL)
        program.wait()
    rows = recordings.Recording(path).rows
    numbers = [recordings.number_of(row) for row in rows]
    assert numbers == list(range(len(rows)))
    # The node's record is written each second, so it is no newer.
    record = (tmp_path / "record.csv").read_text("utf-8").splitlines()
    last = int([line for line in record if line.count(",") > 50][-1]
               .split(",")[0])
    assert recordings.columns_of(rows[-1])["frame"] >= last - 50

    # Half a row at the end is left out and reported.
    text = path.read_text("ascii")
    path.write_text(text[:text.rindex("\n", 0, -1) + 60], "ascii")
    read = recordings.Recording(path)
    assert read.rows == rows[:-1] or len(read.rows) == len(rows) - 1
    assert "is not whole" in read.cut_short

# SPDX-License-Identifier: Apache-2.0
"""GND-53: outputs that are full, limited or slow cost no flight."""

import os
import time

import pytest

from urv import outputs, processes
from urv.outputs import CLOSES_S, ROOM, Output

needs_full_device = pytest.mark.skipif(
    not os.path.exists("/dev/full"), reason="no /dev/full")


def until(condition):
    limit = time.monotonic() + 60
    while not condition():
        assert time.monotonic() < limit
        time.sleep(0.01)


def test_gnd53_an_output_has_all_that_was_put(tmp_path):
    output = Output.of_file("a log", tmp_path / "log")
    for number in range(1_000):
        output.put(b"%d\n" % number)
    output.close()
    assert output.problem() is None
    assert (tmp_path / "log").read_text().split() == [
        str(number) for number in range(1_000)]


@needs_full_device
def test_gnd53_a_full_disk_is_found_at_once_and_closed():
    output = Output.of_file("a log", "/dev/full")
    output.put(b"a line\n")
    until(lambda: output.lost)
    assert output.problem() == (
        "a log cannot be written: No space left on device")
    output.put(b"another\n")
    output.close()


def test_gnd53_a_slow_output_holds_nobody_up_and_counts_what_it_leaves_out():
    ours, theirs = os.pipe()
    output = Output("a log", theirs)
    line = b"x" * 1_023 + b"\n"
    for _ in range(2 * ROOM // len(line)):
        output.put(line)
    # The pipe has taken at most what one has, and one line is on its way.
    most = (1 << 16) // len(line) + 1
    assert ROOM // len(line) - most <= output.left_out <= ROOM // len(line)
    assert output.lost is None
    assert "lines left out" in output.problem()
    began = time.monotonic()
    output.close()
    assert time.monotonic() - began >= CLOSES_S
    assert output.problem() == "a log cannot be written: it takes nothing"
    os.close(ours)


def test_gnd53_a_terminal_that_nobody_reads_is_reported(monkeypatch):
    ours, theirs = os.pipe()
    os.close(ours)

    class Closed:
        @staticmethod
        def fileno():
            return theirs

    monkeypatch.setattr(outputs.sys, "stdout", Closed)
    terminal = outputs.Terminal()
    os.close(theirs)
    terminal.say("a line")
    terminal.close()
    assert terminal.problem() == (
        "standard output cannot be written: Broken pipe")


@pytest.mark.parametrize("said, key, name", [
    ('--record: "x" cannot be written: No space left on device',
     "lost mcs record", "MCS RECORD LOST"),
    ('--events: "x" takes nothing: 12 characters are not written',
     "lost mcs events", "MCS EVENTS LOST"),
    ("standard output cannot be written: Broken pipe",
     "lost mcs standard output", "MCS STANDARD OUTPUT LOST"),
    ("--record: 12 rows left out by 31.2 s: the file is too slow",
     "slow mcs record", "MCS RECORD SLOW")])
def test_gnd53_what_a_node_loses_is_an_alert(said, key, name):
    report, = processes.reports_of("urv_mcs", said)
    assert (report.key, report.name, report.active) == (key, name, True)
    assert processes.is_loss(report)

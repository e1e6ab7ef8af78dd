# SPDX-License-Identifier: Apache-2.0
"""RTP-10: an output of a partition that is full, limited or slow costs that
output alone, and the node flies on."""

import fcntl
import json
import os
import resource
import select
import signal
import subprocess
import time

import pytest
from conftest import PROGRAMS, TIME_LIMIT_S, UNHEARD, of_the_link, udp
from ports import free_ports

NODES = ("gsc", "mcs")
KEPT = ("--record", "--summary", "--events")
LOST = 1

needs_full_device = pytest.mark.skipif(
    not os.path.exists("/dev/full"), reason="no /dev/full")


def started(node, folder, seconds, *options, **more):
    """A node alone, with all outputs in that folder but those that are
    given."""
    own, other = free_ports(2)
    files = [word for name in KEPT if name not in options
             for word in (name, name.strip("-"))]
    return subprocess.Popen(
        [PROGRAMS[node], "--link", udp(own, other), "--seconds", str(seconds),
         *files, *map(str, options)], cwd=folder,
        **({"stdout": subprocess.PIPE, "stderr": subprocess.PIPE,
            "text": True} | more))


def ended(process):
    out, err = process.communicate(timeout=TIME_LIMIT_S)
    return process.returncode, out, of_the_link(err or "")


def summary_in(folder):
    return json.loads((folder / "summary").read_text("utf-8"))


def full_pipe(folder):
    """A pipe with a name that takes nothing, and its reader."""
    path = folder / "pipe"
    os.mkfifo(path)
    reader = os.open(path, os.O_RDWR | os.O_NONBLOCK)
    fcntl.fcntl(reader, fcntl.F_SETPIPE_SZ, 4096)
    with pytest.raises(BlockingIOError):
        while True:
            os.write(reader, b"x" * 512)
    return path, reader


@needs_full_device
@pytest.mark.parametrize("option", KEPT)
@pytest.mark.parametrize("node", NODES)
def test_rtp10_a_full_disk_ends_no_run(node, option, tmp_path):
    status, _, said = ended(started(
        node, tmp_path, 2.5, "--quiet", option, "/dev/full"))
    assert said == [f'urv_{node}: {option}: "/dev/full" cannot be written:'
                    " No space left on device"]
    assert status == LOST
    if option != "--summary":
        summary = summary_in(tmp_path)
        assert summary["seconds"] == 2.5
        assert summary["lost_outputs"] == [option]
        # Rows after the loss are counted.
        assert (summary["rows_left_out"] > 0) == (option == "--record")
    if option != "--record":
        rows = (tmp_path / "record").read_text("utf-8").splitlines()
        assert int(rows[-1].partition(",")[0]) >= 124


@pytest.mark.parametrize("node", NODES)
def test_rtp10_a_limit_of_the_file_s_size_ends_no_run(node, tmp_path):
    limit = 20_000

    def be_limited():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    status, _, said = ended(started(node, tmp_path, 2.5, "--quiet",
                                    preexec_fn=be_limited))
    assert status == LOST
    assert said == [f'urv_{node}: --record: "record" cannot be written:'
                    " File too large"]
    assert (tmp_path / "record").stat().st_size == limit
    summary = summary_in(tmp_path)
    assert (summary["seconds"], summary["lost_outputs"]) == (
        2.5, ["--record"])


@pytest.mark.parametrize("node", NODES)
def test_rtp10_a_reader_that_ends_ends_no_run(node, tmp_path):
    ours, theirs = os.pipe()
    os.close(ours)
    with open(theirs, "w", encoding="utf-8") as closed:
        status, _, said = ended(started(
            node, tmp_path, 2.5, "--quiet", "--record", "-", stdout=closed))
    assert said == [f"urv_{node}: --record: standard output cannot be"
                    " written: Broken pipe"]
    assert status == LOST
    assert summary_in(tmp_path)["seconds"] == 2.5


@pytest.mark.parametrize("option", KEPT)
@pytest.mark.parametrize("node", NODES)
def test_rtp10_an_output_that_takes_nothing_holds_up_no_other(
        node, option, tmp_path):
    path, reader = full_pipe(tmp_path)
    status, _, said = ended(started(node, tmp_path, 1.5, "--quiet", option,
                                    path))
    os.close(reader)
    assert status == LOST
    assert len(said) == 1 and f"{option}: " in said[0], said
    assert " takes nothing: " in said[0]
    if option != "--summary":
        summary = summary_in(tmp_path)
        assert summary["frames"] in (75, 76)
        assert summary["lost_outputs"] == [option]
    if option != "--record":
        rows = (tmp_path / "record").read_text("utf-8").splitlines()
        assert int(rows[-1].partition(",")[0]) >= 74


@pytest.mark.parametrize("node", NODES)
def test_rtp10_a_signal_ends_a_run_whose_output_takes_nothing(
        node, tmp_path):
    path, reader = full_pipe(tmp_path)
    process = started(node, tmp_path, 1_000, "--quiet", "--record", path)
    limit = time.monotonic() + TIME_LIMIT_S
    while not (tmp_path / "summary").exists():
        assert time.monotonic() < limit
        time.sleep(0.05)
    time.sleep(1.0)
    process.send_signal(signal.SIGTERM)
    status, _, said = ended(process)
    os.close(reader)
    assert status == LOST
    assert " takes nothing: " in said[-1]


@pytest.mark.parametrize("node", NODES)
def test_rtp10_a_terminal_that_takes_nothing_holds_up_nobody(node, tmp_path):
    path, reader = full_pipe(tmp_path)
    # One that waits when it writes, as the other one does not.
    with path.open("w", encoding="utf-8") as terminal:
        process = started(node, tmp_path, 1.5, stderr=terminal,
                          stdout=terminal)
    # Its summary for people is not printed, which is an output lost.
    assert process.wait(TIME_LIMIT_S) in (LOST, UNHEARD)
    os.close(reader)
    assert summary_in(tmp_path)["frames"] == 75
    rows = (tmp_path / "record").read_text("utf-8").splitlines()
    assert int(rows[-1].partition(",")[0]) >= 74


def test_rtp10_a_slow_recording_gets_its_rows_later(tmp_path):
    """Nobody reads it until its buffer of 1 MB is full; the recorder aboard
    still has the rows."""
    path, reader = full_pipe(tmp_path)
    os.set_blocking(reader, True)
    program = started("mcs", tmp_path, 92, "--recording", path)
    time.sleep(88)
    text = b""
    while program.poll() is None or select.select([reader], [], [], 0)[0]:
        if select.select([reader], [], [], 0.1)[0]:
            text += os.read(reader, 65_536)
    os.close(reader)
    rows = text.decode("ascii").replace("x", "").splitlines()[1:]
    numbers = [int(row[:8], 16) for row in rows]
    assert numbers == list(range(len(numbers)))
    summary = summary_in(tmp_path)
    assert summary["rows_left_out"] == 0
    # More than the buffer has room for.
    assert len(numbers) > 4_000

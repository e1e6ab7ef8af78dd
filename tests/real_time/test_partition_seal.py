# SPDX-License-Identifier: Apache-2.0
"""SEC-1, SEC-5: the sealed link between two partitions."""

import re
import signal
import subprocess
import time
from pathlib import Path

import pytest

from conftest import (
    COMMANDS, FOLDER, HEARD, SAFE_COMMANDS, TIME_LIMIT_S, UNHEARD,
    different_rows, flies_again, free_ports, need, script, udp)

HOLD_MS = 100


@pytest.fixture
def key(tmp_path):
    """Makes a file of one key."""
    def make(name, number, byte):
        path = tmp_path / name
        path.write_text(f"key {number} {bytes([byte] * 16).hex()}\n", "ascii")
        path.chmod(0o600)
        return path
    return make


def sealed(path):
    return ("--format", "2", "--key", path)


@flies_again
def test_sec1_two_partitions_fly_sealed(start_both, write, key):
    rows = different_rows(20, len(COMMANDS), 8)
    path = key("link.key", 1, 0x5A)
    sticks = write("s.csv", script(COMMANDS, rows, HOLD_MS))
    mcs, gsc = (run.end() for run in start_both(
        mcs=(*sealed(path), "--seconds", 3),
        gsc=(*sealed(path), "--seconds", 3, "--sticks", sticks)))
    need(set(rows[2:-2]) <= set(mcs.words("mcs.uplink", COMMANDS)), mcs, gsc)
    for outputs in (mcs, gsc):
        for file in outputs.folder.iterdir():
            assert b"5a" * 8 not in file.read_bytes()


BOTH = ("mcs", "gsc")

# How the aircraft and the ground are told, and why their blocks are refused.
MISMATCHES = {
    "another number": ((1, 0x5A), (2, 0x5A), {3}),
    "another key": ((1, 0x5A), (1, 0xA5), {2}),
    "another format": ((1, 0x5A), None, {1}),
}


@pytest.mark.parametrize("name", MISMATCHES)
@flies_again
def test_sec5_nodes_that_do_not_agree_take_nothing(
        start_both, write, key, name):
    """Both say so in their logs, and the servos stay as they were. RTP-7:
    neither has heard the other, whatever came."""
    of_mcs, of_gsc, why = MISMATCHES[name]
    told = {node: sealed(key(f"{node}.key", *keys)) if keys else ()
            for node, keys in zip(BOTH, (of_mcs, of_gsc), strict=True)}
    rows = different_rows(10, len(COMMANDS), 9)
    sticks = write("s.csv", script(COMMANDS, rows, HOLD_MS))
    mcs, gsc = (run.end() for run in start_both(
        mcs=(*told["mcs"], "--seconds", 1.5),
        gsc=(*told["gsc"], "--seconds", 1.5, "--sticks", sticks)))
    assert set(mcs.words("mcs.uplink", COMMANDS)) <= {
        (0,) * 13, SAFE_COMMANDS}
    for outputs in (mcs, gsc):
        need("block_refused" in outputs.events, mcs, gsc)
        assert outputs.events["block_refused"]["last_detail"] in why
        link = outputs.summary["link"]
        assert link["state"] == "never heard"
        assert 0 < link["blocks_refused"] <= max(
            link.get("uplink_received", 0), link.get("downlink_received", 0))


@flies_again
def test_rtp7_refused_blocks_are_reported_and_end_as_a_link_unheard(
        start, key):
    up, down = free_ports(2)
    runs = [
        start(node, udp(*ports), "--phase", phase, "--seconds", 1.5,
              *sealed(key(f"{node}.key", 1, byte)), quiet=False)
        for node, ports, phase, byte in (
            ("mcs", (up, down), 3, 0x5A), ("gsc", (down, up), 0, 0xA5))]
    said = [run.program.communicate(timeout=TIME_LIMIT_S) for run in runs]
    flown = [run.outputs for run in runs]
    for run, (out, err) in zip(runs, said, strict=True):
        refused = run.outputs.summary["link"]["blocks_refused"]
        need(refused > 0, *flown)
        assert run.program.returncode == UNHEARD
        assert "peer heard" not in err
        # The first one at once, the flood of them in a line.
        assert len(re.findall(r"blocks? refused by", err)) == 1, err
        assert re.search(rf"peer never heard, .*, {refused} refused\b", out)


@flies_again
def test_rtp7_a_peer_that_comes_with_another_key_is_lost(start, key):
    up, down = free_ports(2)
    mine, other = key("mine.key", 1, 0x5A), key("other.key", 1, 0xA5)
    gsc = start("gsc", udp(down, up), "--phase", 0, *sealed(mine),
                quiet=False)
    assert "listening" in gsc.say_line()
    mcs = start("mcs", udp(up, down), "--phase", 3, *sealed(mine))
    assert "peer heard at" in gsc.say_line()
    mcs.stop()
    start("mcs", udp(up, down), "--phase", 3, *sealed(other))
    lines = [gsc.say_line() for _ in range(2)]
    need(any("peer lost at" in line for line in lines)
         and any("refused by" in line for line in lines), mcs.outputs)
    gsc.send(signal.SIGTERM)
    gsc.program.communicate(timeout=TIME_LIMIT_S)
    assert gsc.program.returncode == HEARD
    assert gsc.outputs.summary["link"]["state"] == "lost"


@pytest.mark.parametrize("node", BOTH)
def test_sec5_a_bad_key_is_an_error_at_the_start(tmp_path, key, node):
    path = key("link.key", 1, 0x5A)
    path.chmod(0o644)
    for options, said in (
            (sealed(path), "link.key:1: has mode 0644; keys must have 0600"),
            (("--format", "2"), "--format 2 needs --key FILE"),
            (("--key", path), "--key is of no use without --format 2")):
        found = subprocess.run(
            [FOLDER / f"urv_{node}", "--link",
             "udp:127.0.0.1:6001:127.0.0.1:6002", *options],
            text=True, capture_output=True, check=False, cwd=tmp_path,
            timeout=TIME_LIMIT_S)
        assert found.returncode == 2
        assert said in found.stderr
        assert found.stderr.count("\n") == 1


def test_sec5_a_process_with_a_key_leaves_no_core_dump(start_both, key):
    """Its memory is closed to others of its user, and cores are empty."""
    path = key("link.key", 1, 0x5A)
    runs = start_both(mcs=(*sealed(path), "--seconds", 2),
                      gsc=("--seconds", 2))
    process = Path("/proc", str(runs[0].program.pid))
    until = time.monotonic() + 60
    while cores_of(process) != "0" and time.monotonic() < until:
        time.sleep(0.01)
    assert cores_of(process) == "0"
    for run in runs:
        run.end()


def test_sec5_a_node_that_flies_has_its_key_once(start_both, tmp_path):
    """In its seal. The stack of a task has copies until it uses that place
    again: some look finds none."""
    digits = bytes(range(0xA0, 0xB0))
    path = tmp_path / "link.key"
    path.write_text(f"key 1 {digits.hex()}\n", "ascii")
    path.chmod(0o600)
    runs = start_both(mcs=(*sealed(path), "--seconds", 60),
                      gsc=(*sealed(path), "--seconds", 60))
    time.sleep(1.0)
    for run in runs:
        until = time.monotonic() + TIME_LIMIT_S
        counts = set()
        while 1 not in counts and time.monotonic() < until:
            run.send(signal.SIGSTOP)
            try:
                counts.add(copies_of(digits, run.program.pid))
            except PermissionError:
                pytest.skip("the memory of who has a key is closed, but to"
                            " root")
            finally:
                run.send(signal.SIGCONT)
            time.sleep(0.01)
        assert 1 in counts, counts
    for run in runs:
        run.stop()


def copies_of(what, process):
    """How many times the memory of a process has these bytes."""
    found = 0
    with open(f"/proc/{process}/mem", "rb", buffering=0) as memory:
        for line in Path(f"/proc/{process}/maps").read_text().splitlines():
            place, rights = line.split()[:2]
            if not rights.startswith("rw"):
                continue
            first, end = (int(part, 16) for part in place.split("-"))
            memory.seek(first)
            found += memory.read(end - first).count(what)
    return found


def cores_of(process):
    """The most bytes that a core dump may have, as text."""
    for line in (process / "limits").read_text("utf-8").splitlines():
        if line.startswith("Max core file size"):
            return line.split()[-3] if line.split()[-1] == "bytes" else ""
    return ""

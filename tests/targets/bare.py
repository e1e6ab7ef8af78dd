# SPDX-License-Identifier: Apache-2.0
"""Checks that are the same on each bare machine (BRD-1 to BRD-3)."""

import shutil
import subprocess
from pathlib import Path

import emulated
import pytest

ROOT = Path(__file__).resolve().parents[2]

SECONDS = 6

# Status words of CORE memory.
START, COLD, WARM, PROCESSOR, SELF_TEST = range(5)
ROM_FAILED, RAM_FAILED = 0x1000, 0x2000

# The error word of data that has not come.
OLD = 1

SAFE = [0x800] * 7 + [0, 0xFFF] + [0x800] * 4 + [0]


def needs(machine, *files):
    """Skips the tests of a machine whose tools are missing."""
    missing = [name for name in machine.needed if not shutil.which(name)]
    missing += [str(each) for each in files if not each.exists()]
    return pytest.mark.skipif(
        bool(missing), reason=f"not installed: {', '.join(missing)}")


def stack_size(machine, name):
    """The bytes that image.ld leaves for the stack."""
    symbols = subprocess.run(
        [f"{machine.prefix}nm", machine.images / f"{name}.elf"],
        check=True, capture_output=True, text=True).stdout
    place = {line.split()[2]: int(line.split()[0], 16)
             for line in symbols.splitlines() if len(line.split()) == 3}
    return place["urv_stack_top"] - place["urv_stack_bottom"]


def flies_like_the_simulation(machine, folder, laws, sealed=False):
    rows, runs = machine.fly_both(folder, SECONDS, laws, sealed)
    frames = SECONDS * emulated.FRAMES_PER_S
    assert len(rows) == frames
    assert list(emulated.differences(rows, runs)) == []
    # They differ from frame to frame, or this would not show much.
    servos = runs["mcs"].rows
    assert len({tuple(runs["mcs"].pwm(frame)) for frame in servos}) > frames / 4
    for name, node in runs.items():
        assert sorted(node.rows)[:frames - 1] == list(range(frames - 1))
        # A stack that overflows spoils variables: a fifth of it stays unused.
        assert node.numbers["stack"] < 0.8 * stack_size(machine, name)
        assert node.numbers["overruns"] == 0
        assert node.numbers.get("lost_times", 0) == 0
        assert node.numbers["received"] >= frames - 4
        assert node.numbers["bad"] == node.numbers["resets"] == 0
        last = max(node.rows)
        assert node.status(last)[:SELF_TEST + 1] == [1, 1, 0, 0, 0]


def restarts(machine, folder, events):
    """Two planted faults, at 0.5 and at 1 s. The words of the servos stay,
    and the node goes on."""
    tape = emulated.Tape(2)
    for number, (event, _) in enumerate(events, 1):
        tape.plant(500 * number, event)
    run = machine.fly({"mcs": tape}, folder)["mcs"]
    assert run.text.count("MCS processor restart\n") == 2
    for number, (_, reason) in enumerate(events, 1):
        assert run.has(f"restarts count {number} reason {reason}")
    counts = {frame: run.status(frame)[PROCESSOR] for frame in run.rows}
    assert [counts[frame] for frame in (23, 28, 48, 53)] == [0, 1, 1, 2]
    assert all(run.pwm(frame) == SAFE for frame in run.rows)
    # Ticks went on: a row each 20 ms, and the sensors are new ones again.
    assert sorted(run.rows) == list(range(len(run.rows)))
    assert len(run.rows) >= 98
    last = max(run.rows)
    assert run.downlink(last)[-1] & 1 == 0
    assert run.status(last)[:SELF_TEST + 1] == [3, 1, 0, 2, 0]


def refuses_a_changed_bit(machine, folder, place):
    image = bytearray((machine.images / "mcs.bin").read_bytes())
    # In the program, a bit of a text that the start does not need, beyond the
    # 64 KiB of a host's image. The filling is before the two sums.
    if place == "program":
        place = image.index(b"overruns", 0x1_0000)
    elif place == "filling":
        place = -9
        assert image[place] == 0xFF
    image[place] ^= 0x10
    (folder / "mcs.bin").write_bytes(image)
    run = machine.fly({"mcs": emulated.Tape(1)}, folder,
                      {"mcs": folder / "mcs.bin"})["mcs"]
    assert run.has("MCS refused") and not run.has("MCS started")
    last = max(run.rows)
    assert run.status(last)[SELF_TEST] == ROM_FAILED
    assert run.uplink(last) == [0] * (emulated.UPLINK - 1) + [OLD]
    assert run.pwm(last) == SAFE

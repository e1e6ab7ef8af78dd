# SPDX-License-Identifier: Apache-2.0
"""FRM-6: the aircraft's frames come in step with the ground's in real time,
where both follow the machine's clock and messages wait for the machine."""

import pytest

from conftest import (
    COMMANDS, different_rows, flies_again, free_ports, need, script, udp)

HOLD_MS = 100
SECONDS = 3

# In the simulation it takes 22 frames at most (docs/evidence/link.md). Here
# the first message comes when both are there.
FRAMES_TO_COME_IN_STEP = 40


@pytest.mark.parametrize("schedule", ["report", "fast"])
@pytest.mark.parametrize("phase", [0, 4, 8])
@flies_again
def test_frm6_frames_come_in_step_from_any_phase(
        start, write, phase, schedule):
    rows = different_rows(20, len(COMMANDS), 3 + phase)
    told = ("--lock", "--schedule", schedule, "--seconds", SECONDS)
    sticks = write("s.csv", script(COMMANDS, rows, HOLD_MS))
    up, down = free_ports(2)
    runs = (
        start("mcs", udp(up, down), "--phase", phase, *told),
        start("gsc", udp(down, up), "--phase", 0, *told, "--sticks", sticks))
    mcs, gsc = (run.end() for run in runs)
    lock, frames = mcs.summary["lock"], mcs.summary["frames"]
    need(lock["in_step"] == 1
         and lock["in_step_since_frame"] <= FRAMES_TO_COME_IN_STEP, mcs, gsc)
    # No downlink is left out but the first ones.
    need(mcs.summary["link"]["downlink_sent"] >= frames - 3, mcs, gsc)
    need(set(rows[2:-2]) <= set(mcs.words("mcs.uplink", COMMANDS)), mcs, gsc)
    assert "lock" not in gsc.summary


@flies_again
def test_frm6_who_comes_in_step_says_so(start):
    up, down = free_ports(2)
    told = ("--lock", "--seconds", 1.5)
    gsc = start("gsc", udp(down, up), *told)
    mcs = start("mcs", udp(up, down), *told, quiet=False)
    said = [mcs.say_line() for _ in range(3)]
    outputs = [run.program.communicate() and run.outputs for run in (mcs, gsc)]
    need(said[2].startswith("urv_mcs: in step with the ground at "), *outputs)

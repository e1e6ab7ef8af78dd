# SPDX-License-Identifier: Apache-2.0
"""FRM-6: the aircraft's frames come in step with the ground's from any phase,
stay so under drift and lost blocks, and then no downlink is left out; the
bounds of docs/design.md hold. evidence/in_step.py tries every phase and drift."""

import sys

import pytest
from conftest import ROOT, fly_in

sys.path.insert(0, str(ROOT / "evidence"))

import in_step  # noqa: E402


@pytest.mark.parametrize("phase, drift, schedule, processors", [
    (0, -200, "fast", 1), (6, 137, "fast", 2), (9, 200, "fast", 1),
    (2, -91, "report", 2), (3, 200, "report", 1),
])
def test_in_step_sticks_and_sensors_keep_their_bounds(
        phase, drift, schedule, processors):
    found = in_step.fly(phase, drift, schedule, processors, changed=200)
    assert list(in_step.wrongs(found, schedule)) == []
    # As soon as five corrections of four uplinks each.
    assert found.since_ms < 25 * in_step.FRAME_MS


@pytest.mark.parametrize("phase, drift", [(3, -200), (8, 200)])
def test_no_downlink_is_left_out_in_10000_frames(phase, drift):
    assert in_step.fly_long(phase, drift, "fast", 10_000) == 0


def test_without_lock_a_drift_leaves_downlinks_out(tmp_path):
    flight = fly_in(tmp_path, "--drift", "200", "--seconds", "120")
    assert in_step.left_out(flight.summary) > 3
    assert "lock" not in flight.summary


def test_without_uplinks_a_frame_is_ten_ticks(tmp_path):
    """Cut off as soon as it is in step, the aircraft corrects nothing and
    drifts away; 20 s after the link is back it is in step again."""
    (tmp_path / "faults.txt").write_text("2000 cut 36000\n")
    flights = [
        fly_in(tmp_path, "--lock", "--drift", "150", "--phase", "0",
               "--faults", "faults.txt", "--seconds", seconds).summary["lock"]
        for seconds in ("1.9", "37.9", "58")]
    assert flights[1] == flights[0]
    assert flights[2]["frames_of_9_ticks"] > flights[0]["frames_of_9_ticks"]
    assert 38 < flights[2]["in_step_since_s"] <= 58


def test_it_stays_in_step_while_blocks_are_lost(tmp_path):
    """Half a second without an uplink, over and over."""
    (tmp_path / "faults.txt").write_text("".join(
        f"{time} cut 460\n" for time in range(2_000, 58_000, 500)))
    lock = fly_in(tmp_path, "--lock", "--drift", "-200", "--schedule", "fast",
                  "--faults", "faults.txt", "--seconds", "60").summary["lock"]
    assert lock["in_step_since_s"] < 2
    assert lock["frames_of_11_ticks"] > 2


def test_a_reset_is_in_step_again(tmp_path):
    (tmp_path / "faults.txt").write_text("3000 mcs reset warm\n")
    lock = fly_in(tmp_path, "--lock", "--phase", "7", "--schedule", "fast",
                  "--faults", "faults.txt", "--seconds", "8").summary["lock"]
    assert 3 < lock["in_step_since_s"] < 4


def test_drifts_are_tried_either_way_up_to_200():
    drifts = in_step.DRIFTS
    assert sorted(-drift for drift in drifts) == sorted(drifts)
    assert max(drifts) == 200 and 0 in drifts

# SPDX-License-Identifier: Apache-2.0
"""LNK-11, D-38: over a line slower than a wire both boards wait longer, and a frame
has room for an exchange. docs/link.md has the bounds."""

import json
import subprocess
import sys

import pytest
from conftest import PROGRAM, ROOT, fly_in

sys.path.insert(0, str(ROOT / "evidence"))

import in_step  # noqa: E402

LONGEST_MS = 1.392
DELAYS_MS = (0.05, 0.43, 0.62, 1.0, LONGEST_MS)
SECONDS = 20
FRAMES = SECONDS * 50


def link_of(*options):
    """The link's counts after a flight."""
    result = subprocess.run(
        [PROGRAM, "fly", "--quiet", "--summary", "-", *map(str, options)],
        capture_output=True, text=True, check=True, timeout=120)
    return json.loads(result.stdout)["link"]


def went_wrong(link):
    return [name for name, count in link.items() if count and (
        name.endswith(("_bad", "_scrapped", "_resets")))]


@pytest.mark.parametrize("delay", DELAYS_MS)
def test_lnk11_at_any_phase_every_uplink_comes_and_no_board_gives_up(delay):
    for phase in range(10):
        link = link_of("--line-delay", delay, "--phase", phase,
                       "--seconds", SECONDS)
        assert went_wrong(link) == [], phase
        assert link["uplink_received"] == link["uplink_sent"] == FRAMES - 1
        # A block that comes between status and command waits for a frame.
        assert link["downlink_received"] >= FRAMES / 2 - 3, phase


@pytest.mark.parametrize("schedule", ["report", "fast"])
@pytest.mark.parametrize("delay", DELAYS_MS)
def test_lnk11_in_step_no_downlink_is_left_out(delay, schedule):
    for phase, drift in ((0, 200), (3, 0), (7, -200)):
        link = link_of("--line-delay", delay, "--phase", phase, "--lock",
                       "--drift", drift, "--schedule", schedule,
                       "--seconds", 40)
        assert went_wrong(link) == []
        # Before they are in step some may be.
        early = link_of("--line-delay", delay, "--phase", phase, "--lock",
                        "--drift", drift, "--schedule", schedule,
                        "--seconds", 20)
        assert (link["downlink_received"] - early["downlink_received"]
                == FRAMES), (phase, drift)


def test_lnk11_the_line_is_as_slow_as_it_says(fly):
    """The first status comes after the uplink, the line, the guard time, and
    the ground's command after the line again."""
    for delay_us in (0, 480, 1392):
        wire = fly("--line-delay", delay_us / 1000, "--seconds", "1",
                   name=str(delay_us)).wire
        up = [byte.time_us for byte in wire if byte.direction == "up"]
        down = [byte.time_us for byte in wire if byte.direction == "down"]
        answer = down[0] - (up[29] + 96)
        assert delay_us + 96 <= answer <= delay_us + 3 * 96
        assert up[30] >= down[0] + 96 + delay_us


def test_lnk11_without_delay_everything_is_as_it_was(fly):
    plain = fly("--seconds", "5", name="plain")
    none = fly("--seconds", "5", "--line-delay", "0", name="none")
    for file in ("record.csv", "wire.csv", "events.jsonl"):
        assert plain.path(file).read_bytes() == none.path(file).read_bytes()


@pytest.mark.parametrize("delay", (0.43, LONGEST_MS))
@pytest.mark.parametrize("seed", range(3))
def test_lnk11_lnk9_bit_errors_and_cuts_are_overcome(
        tmp_path, delay, seed):
    """The safety monitor has nothing to say, and three frames after the last
    fault each frame has its uplink."""
    faults = ["500 up ber 2e-4 9000", "500 down ber 2e-4 9000"]
    faults += [f"{time} cut {1 + time % 37}" for time in range(1000, 9000, 777)]
    faults += [f"{time} up insert 3 1e" for time in range(1300, 9000, 901)]
    faults += [f"{time} down dup 20" for time in range(1500, 9000, 1103)]
    (tmp_path / "faults.txt").write_text("\n".join(faults) + "\n")
    rows = fly_in(tmp_path, "--line-delay", delay, "--seed", seed, "--lock",
                  "--faults", "faults.txt", "--seconds", "12").rows
    at = {row["time_ms"]: row for row in rows}
    assert at[9600]["link.uplink_bad"] > 10
    assert (at[12_000]["link.uplink_received"]
            - at[9_600]["link.uplink_received"]) == 120
    assert at[12_000]["link.gsc_resets"] == at[9_600]["link.gsc_resets"]


def test_lnk11_a_stick_takes_the_delay_longer():
    """Theorems.Latency.In_Step_Both_Are_Bounded."""
    wire = in_step.fly(3, 0, "fast", 1, changed=60)
    slow = in_step.fly(3, 0, "fast", 1, changed=60,
                       options=("--line-delay", str(LONGEST_MS)))
    assert max(slow.servo_ms) <= max(wire.servo_ms) + LONGEST_MS + 2
    assert max(slow.servo_ms) <= 20 + 7.987 + LONGEST_MS
    assert max(slow.core_ms) <= 20 + 9.892 - LONGEST_MS + 20


@pytest.mark.parametrize("value", ["1.393", "2", "-0.1", "0.0001", "", "ms"])
def test_lnk11_a_delay_without_room_is_refused_with_the_range(urv_sim, value):
    result = urv_sim("fly", f"--line-delay={value}")
    assert result.returncode == 2
    assert result.stderr.count("\n") == 1
    assert value == "" or "from 0 to 1.392" in result.stderr

# SPDX-License-Identifier: Apache-2.0
"""GND-6: the JSBSim aircraft behind the boards of the aircraft's partition, in
lock-step with its frames; and the node's behaviour when it is late or dead."""

import json
import os
import signal
import sys
import time
from pathlib import Path

import pytest

from conftest import (
    COMMANDS, ROOT, SENSORS, TIME_LIMIT_S, flies_again, free_ports, in_turn,
    need, of_the_link, udp, wait_for_line,
)

pytestmark = pytest.mark.skipif(
    not (ROOT / ".venv" / "bin" / "python").exists()
    and "URV_PYTHON" not in os.environ,
    reason="no Python with JSBSim")

JSBSIM = ("--plant", "jsbsim")

# Right stick, half throttle, brake off.
BANKING = (2600, 2048, 2048, 2048, 2048) + (0,) * 8
HEADER = "time_ms," + ",".join(COMMANDS) + "\n"


def children(run):
    """The processes that a partition has started."""
    tasks = Path(f"/proc/{run.program.pid}/task").iterdir()
    return {int(pid) for task in tasks
            for pid in (task / "children").read_text("ascii").split()}


def plant_of(run):
    deadline = time.monotonic() + TIME_LIMIT_S
    while not (found := children(run)):
        assert time.monotonic() < deadline and run.program.poll() is None
        time.sleep(0.02)
    return found.pop()


@flies_again
def test_gnd6_sticks_move_the_aircraft_in_lock_step(start, write):
    up, down = free_ports(2)
    sticks = write("sticks.csv", HEADER + ",".join(map(str, (0, *BANKING))))
    mcs = start("mcs", udp(up, down), "--phase", 3, *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    gsc = start("gsc", udp(down, up), "--phase", 0, "--sticks", sticks,
                "--seconds", 4)
    gsc = gsc.end()
    mcs.send(signal.SIGTERM)
    mcs.program.communicate(timeout=TIME_LIMIT_S)
    assert mcs.program.returncode == 0
    mcs = mcs.outputs

    rows = mcs.rows
    heard = [row for row in rows if row["link.uplink_received"] > 0]
    before = [row for row in rows if row["link.uplink_received"] == 0]

    # It waits for the ground, in level flight: 70 kt, 1000 ft.
    name = "mcs.downlink.{}".format
    for row in before[5:]:
        assert abs(row[name("roll_attitude")] - 2048) <= 2
        assert abs(row[name("airspeed")] - 2240) <= 8
        assert abs(row[name("altitude")] - 2000) <= 2

    # As many frames were flown as the servos had commands: one for each.
    plant = mcs.summary["plant"]
    frames = heard[-1]["frame"] - heard[0]["frame"]
    assert plant["frames"] <= frames + 4
    need(plant["frames"] >= frames - plant["late"] - 4, mcs)
    assert plant["died"] == 0

    # The record has what it really does, as the sensors do a frame later.
    assert list(rows[0])[-9:] == [
        f"truth.{item}" for item in (
            "altitude_ft", "airspeed_kt", "bank_deg", "pitch_deg",
            "heading_deg", "alpha_deg", "beta_deg", "north_ft", "east_ft")]
    for row in before[5:]:
        assert abs(row["truth.altitude_ft"] - 1000) < 2
        assert abs(row["truth.airspeed_kt"] - 70) < 0.5
        assert abs(row["truth.heading_deg"] - 90) < 1
    assert rows[-1]["truth.east_ft"] > 100
    for row in heard[10:]:
        sensed = (row[name("roll_attitude")] - 2048) * 360 / 4096
        need(abs(sensed - row["truth.bank_deg"]) < 2, mcs)

    # Ailerons follow their servo; the aircraft banks to the right.
    need(len(heard) > 150, mcs, gsc)
    aileron = [row[name("right_aileron")] for row in heard]
    bank = [row[name("roll_attitude")] for row in heard]
    need(max(aileron) > 2300 and max(bank) > 2048 + 100, mcs, gsc)
    assert min(bank) > 2048 - 20


@flies_again
def test_rtp9_a_killed_plant_is_reported_and_the_node_flies_on(start):
    """GND-6, RTP-9: its sensors are old from the next scan on."""
    mcs = start("mcs", udp(*free_ports(2)), *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    plant = plant_of(mcs)
    os.kill(plant, signal.SIGKILL)
    wait_for_line(mcs, "plant has died at ")
    rows = len((mcs.outputs.folder / "record.csv").read_bytes())
    deadline = time.monotonic() + TIME_LIMIT_S
    while len((mcs.outputs.folder / "record.csv").read_bytes()) == rows:
        assert time.monotonic() < deadline
        time.sleep(0.05)
    mcs.send(signal.SIGTERM)
    _, said = mcs.program.communicate(timeout=TIME_LIMIT_S)
    assert mcs.program.returncode == 1
    assert of_the_link(said) == [
        "urv_mcs: --plant jsbsim: JSBSim's process has ended"]
    assert mcs.outputs.summary["plant"]["died"] == 1
    died = mcs.outputs.events["plant_died"]
    assert (died["node"], died["count"]) == ("mcs", 1)

    # The sensors keep the words of level flight, and are old.
    last = in_turn(mcs.outputs.words("mcs.downlink", SENSORS))[-1]
    assert abs(last[SENSORS.index("altitude")] - 2000) <= 2
    assert_old_after(mcs.outputs, died["first_frame"])


def assert_old_after(outputs, frame):
    """No scan that was begun in a later frame is fresh, and no surface has
    failed because of it."""
    late = [row for row in outputs.rows if row["frame"] > frame + 1]
    need(len(late) > 10, outputs)
    assert all(row["mcs.downlink.error"] & 1 for row in late)
    assert "surface_failed" not in outputs.events


@flies_again
def test_gnd6_a_plant_without_finite_numbers_is_reported(
        start, tmp_path, monkeypatch):
    """The words are never made of them: the sensors keep their words."""
    python = tmp_path / "python"
    python.write_text(f"""#!{sys.executable}
import sys
sys.path.insert(0, {str(ROOT / "sim" / "jsbsim")!r})
sys.argv[0:1] = []
import plant

class Broken(plant.Aircraft):
    frames = 0

    def begin(self, commands):
        sensors, truth, shown = map(list, super().begin(commands))
        self.frames += 1
        if self.frames >= 20:
            sensors[10] = float("nan")
        return sensors, truth, shown

plant.Aircraft = Broken
plant.main()
""", encoding="utf-8")
    python.chmod(0o755)
    monkeypatch.setenv("URV_PYTHON", str(python))
    up, down = free_ports(2)
    mcs = start("mcs", udp(up, down), "--phase", 3, *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    gsc = start("gsc", udp(down, up), "--phase", 0)
    wait_for_line(mcs, "plant has diverged at ")
    gsc.stop()
    mcs.send(signal.SIGTERM)
    _, said = mcs.program.communicate(timeout=TIME_LIMIT_S)
    assert mcs.program.returncode == 1
    assert "urv_mcs: --plant jsbsim: the aircraft's numbers are not finite" \
        in said.splitlines()
    assert mcs.outputs.summary["plant"]["died"] == 1
    alpha = mcs.outputs.words("mcs.downlink", ("alpha",))
    assert all(word[0] != 0 for word in alpha[5:])


@flies_again
def test_gnd6_a_stopped_plant_is_late_and_comes_back(
    start, write
):
    up, down = free_ports(2)
    sticks = write("sticks.csv", HEADER + ",".join(map(str, (0, *BANKING))))
    mcs = start("mcs", udp(up, down), "--phase", 3, *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    gsc = start("gsc", udp(down, up), "--phase", 0, "--sticks", sticks)
    wait_for_line(mcs, "peer heard at")
    plant = plant_of(mcs)
    os.kill(plant, signal.SIGSTOP)
    wait_for_line(mcs, "plant late at ")
    os.kill(plant, signal.SIGCONT)
    wait_for_line(mcs, "plant in time again at ")
    # It is late in each frame to the end, also while the outputs are written.
    os.kill(plant, signal.SIGSTOP)
    wait_for_line(mcs, "plant late at ")
    gsc.stop()
    mcs.send(signal.SIGTERM)
    mcs.program.communicate(timeout=TIME_LIMIT_S)
    # On a slow machine its silence may be long enough for a fault.
    assert mcs.program.returncode in (0, 1)
    late = mcs.outputs.events["plant_late"]
    assert late["count"] == mcs.outputs.summary["plant"]["late"] > 1
    assert mcs.outputs.summary["plant"]["died"] == 0


@flies_again
def test_rtp9_sensors_of_a_plant_that_does_not_answer_are_old(start, write):
    """And none of its surfaces is called failed; the run ends with 1."""
    up, down = free_ports(2)
    sticks = write("sticks.csv", HEADER + ",".join(map(str, (0, *BANKING))))
    mcs = start("mcs", udp(up, down), "--phase", 3, *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    gsc = start("gsc", udp(down, up), "--phase", 0, "--sticks", sticks)
    wait_for_line(mcs, "peer heard at")
    plant = plant_of(mcs)
    os.kill(plant, signal.SIGSTOP)
    wait_for_line(mcs, "plant does not answer at ")
    size = (mcs.outputs.folder / "record.csv").stat().st_size
    deadline = time.monotonic() + TIME_LIMIT_S
    # A second of rows, a surface would have failed in a quarter of it.
    while (mcs.outputs.folder / "record.csv").stat().st_size < size + 50_000:
        assert time.monotonic() < deadline
        time.sleep(0.05)
    gsc.stop()
    mcs.send(signal.SIGTERM)
    _, said = mcs.program.communicate(timeout=TIME_LIMIT_S)
    assert mcs.program.returncode == 1
    assert "JSBSim's process does not answer" in said
    assert_old_after(
        mcs.outputs, mcs.outputs.events["plant_late"]["first_frame"] + 3)


def times_still(run):
    """The summary so far; it is written again each second."""
    try:
        text = (run.outputs.folder / "summary.json").read_text("utf-8")
        return json.loads(text)["plant"]["stood_still"]
    except (OSError, ValueError):
        return 0


def test_rtp11_a_plant_that_stood_still_is_a_fault_though_it_comes_back(
        start, write):
    """Also without bin/urv ground: the terminal, and the exit status."""
    up, down = free_ports(2)
    mcs = start("mcs", udp(up, down), "--phase", 3, *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    gsc = start("gsc", udp(down, up), "--phase", 0)
    wait_for_line(mcs, "peer heard at")
    plant = plant_of(mcs)
    os.kill(plant, signal.SIGSTOP)
    wait_for_line(mcs, "plant does not answer at ")
    deadline = time.monotonic() + TIME_LIMIT_S
    while not times_still(mcs):
        assert time.monotonic() < deadline
        time.sleep(0.05)
    os.kill(plant, signal.SIGCONT)
    wait_for_line(mcs, "plant in time again at ")
    gsc.stop()
    mcs.send(signal.SIGTERM)
    _, said = mcs.program.communicate(timeout=TIME_LIMIT_S)
    assert mcs.program.returncode == 1
    assert said.splitlines()[-1] in (
        "urv_mcs: --plant jsbsim: JSBSim's process stood still",
        "urv_mcs: --plant jsbsim: JSBSim's process does not answer")


def test_gnd6_no_plant_outlives_its_partition(start):
    mcs = start("mcs", udp(*free_ports(2)), *JSBSIM, quiet=False)
    wait_for_line(mcs, "listening at")
    plant = plant_of(mcs)
    mcs.program.kill()
    mcs.program.wait()
    deadline = time.monotonic() + TIME_LIMIT_S
    while Path(f"/proc/{plant}/cmdline").exists():
        state = Path(f"/proc/{plant}/stat").read_text("ascii")
        if state.rpartition(")")[2].split()[0] == "Z":
            break
        assert time.monotonic() < deadline, "the plant goes on"
        time.sleep(0.05)

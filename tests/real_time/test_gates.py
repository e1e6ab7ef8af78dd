# SPDX-License-Identifier: Apache-2.0
"""D-30: what waits in a partition comes on."""

import subprocess

from conftest import ROOT, TIME_LIMIT_S

CROSSINGS = 2 * 20_000


def test_d30_two_tasks_go_through_a_gate_and_neither_stays_there(tmp_path):
    # At an entry in the gate's place one stays after a few thousand.
    folders = [f"-I{ROOT / folder}"
               for folder in ("tests/real_time/gates", "real_time")]
    subprocess.run(
        ["gnatmake", "-q", "-gnat2022", f"-gnatec={ROOT / 'partitions.adc'}",
         *folders, "cross_gate.adb"], cwd=tmp_path, check=True)
    done = subprocess.run([tmp_path / "cross_gate"], capture_output=True,
                          text=True, check=True, timeout=TIME_LIMIT_S)
    assert int(done.stdout) == CROSSINGS

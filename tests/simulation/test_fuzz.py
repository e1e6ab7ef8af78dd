# SPDX-License-Identifier: Apache-2.0
"""LNK-1, LNK-9, SEC-14: every first input of the fuzzing is replayed with
contracts executed, and AFL++ looks for more for a short while
(docs/evidence/exploration.md). For longer: `make -C evidence fuzz`."""

import shutil
import subprocess
import sys

import pytest

from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence" / "fuzz"))

from inputs import inputs  # noqa: E402

KINDS = {"urv_fuzz": "board", "urv_file_fuzz": "files"}
INPUTS = [pytest.param(program, data, id=f"{program}-{name}")
          for program, kind in KINDS.items()
          for name, data in inputs(kind).items()]


@pytest.fixture(scope="module", autouse=True)
def _programs_are_built():
    for program in KINDS:
        subprocess.run(
            ["gprbuild", "-q", "-p", "-P",
             ROOT / "evidence" / "fuzz" / f"{program}.gpr", "-XURV_Fuzz=replay"],
            check=True,
        )


def replay(program, data, folder):
    return subprocess.run(
        [ROOT / "bin" / "replay" / program], input=data, capture_output=True,
        cwd=folder, timeout=60, check=False
    )


@pytest.mark.parametrize("program, data", INPUTS)
def test_no_contract_is_violated(program, data, tmp_path):
    result = replay(program, data, tmp_path)
    assert result.returncode == 0, result.stderr.decode()
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not shutil.which("afl-fuzz"), reason="no afl-fuzz here")
def test_a_short_run_finds_nothing():
    # By the number of inputs: how long that takes is the machine's affair.
    result = subprocess.run(
        [ROOT / "evidence" / "fuzz.sh", "500", "5000"],
        capture_output=True, text=True, timeout=600, check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    assert int(result.stdout.split()[1]) >= 5_000, result.stdout


@pytest.mark.parametrize("numbers", [["0"], ["-1"], ["ten"], ["5", "0"]])
def test_sec14_fuzzing_for_no_time_is_refused(numbers):
    result = subprocess.run(
        [ROOT / "evidence" / "fuzz.sh", *numbers],
        capture_output=True, text=True, timeout=60, check=False)
    assert result.returncode == 2
    assert result.stderr == f"fuzz: not a number from 1 on: {numbers[-1]}\n"

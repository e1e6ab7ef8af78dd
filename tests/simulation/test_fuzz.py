# SPDX-License-Identifier: Apache-2.0
"""LNK-1, LNK-9: every input of the fuzzing corpus is replayed with contracts
executed, and AFL++ looks for more for a short while (docs/evidence/exploration.md).
For longer: `make fuzz`."""

import shutil
import subprocess

import pytest

from conftest import ROOT

CORPUS = sorted((ROOT / "fuzz" / "corpus").iterdir())
PROGRAM = ROOT / "bin" / "replay" / "urv_fuzz"


@pytest.fixture(scope="module", autouse=True)
def _program_is_built():
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P", ROOT / "fuzz" / "urv_fuzz.gpr",
         "-XURV_Fuzz=replay"],
        check=True,
    )


def replay(data):
    return subprocess.run(
        [PROGRAM], input=data, capture_output=True, timeout=60, check=False
    )


def test_there_is_a_corpus():
    assert CORPUS


@pytest.mark.parametrize("file", CORPUS, ids=lambda file: file.name)
def test_no_contract_is_violated(file):
    result = replay(file.read_bytes())
    assert result.returncode == 0, result.stderr.decode()


@pytest.mark.skipif(not shutil.which("afl-fuzz"), reason="no afl-fuzz here")
def test_a_short_run_finds_nothing():
    # By the number of inputs: how long that takes is the machine's affair.
    result = subprocess.run(
        [ROOT / "scripts" / "fuzz.sh", "500", "5000"],
        capture_output=True, text=True, timeout=600, check=False,
    )
    assert result.returncode == 0, result.stdout + result.stderr
    assert int(result.stdout.split()[1]) >= 5_000, result.stdout

"""Every input of the fuzzing corpus is replayed with contracts executed
(issue 3; docs/exploration.md). The fuzzing
itself is `make fuzz`."""

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

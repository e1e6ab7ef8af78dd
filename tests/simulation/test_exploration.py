# SPDX-License-Identifier: Apache-2.0
"""LNK-9, LNK-11, D-28: the boards that wait longest come in step in every case, with
blocks of a byte. `make -C evidence explore` explores everything and finds bugs
that it plants (docs/evidence/exploration.md)."""

import re
import subprocess

import pytest

from conftest import ROOT

TIME_LIMIT_S = 900


@pytest.fixture(scope="module", autouse=True)
def _program_is_built():
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P",
         ROOT / "evidence/explore/urv_explore.gpr", "-XURV_Mode=host"],
        check=True, timeout=TIME_LIMIT_S,
    )


def explore(*arguments):
    return subprocess.run(
        [ROOT / "bin" / "urv_explore", *arguments],
        capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False,
    )


def test_lnk11_boards_that_wait_longest_come_in_step():
    """On a wire: what they wait for is no part of it."""
    result = explore("1", "1", "in-step", "29")
    out = result.stdout
    assert result.returncode == 0, out + result.stderr
    assert "dead space 49, idle time 53," in out
    assert out.count("normal form exact") == 2
    states = re.search(r"back in step: (\d+) states", out)
    assert states and int(states[1]) > 1_000_000, out


@pytest.mark.parametrize("arguments", [("28",), ("28", "3"), ("x", "56"),
                                       ("28", "56", "all"),
                                       ("1", "1", "in-step", "30")])
def test_wrong_arguments_are_refused(arguments):
    result = explore(*arguments)
    assert result.returncode == 2
    assert any(each in result.stderr for each in
               ("usage", "1, 2, 4, 28 or 56", "is no round trip: 0 to 29"))

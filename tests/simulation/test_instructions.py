# SPDX-License-Identifier: Apache-2.0
"""EVI-14: a flight does not become slower unnoticed."""

import shutil
import subprocess
import sys

import pytest

from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence"))

import instructions  # noqa: E402 - found by the line above


@pytest.mark.skipif(not shutil.which("valgrind"),
                    reason="there is no valgrind")
def test_evi14_a_frame_takes_the_instructions_agreed():
    result = subprocess.run(
        [sys.executable, ROOT / "evidence" / "instructions.py"],
        capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stdout + result.stderr


@pytest.mark.parametrize(("more", "status"), [(1.0, 0), (1.029, 0),
                                              (1.031, 1), (0.5, 0)])
def test_evi14_three_per_cent_more_is_too_much(monkeypatch, capsys, more,
                                               status):
    agreed = {name: 100_000 for name in instructions.FLIGHTS}
    monkeypatch.setattr(instructions, "per_frame",
                        lambda options: round(100_000 * more))
    monkeypatch.setattr(instructions, "compiler", lambda: "one")
    monkeypatch.setattr(
        instructions.json, "loads",
        lambda text: {"compiler": "one", "per_frame": agreed})
    assert instructions.main([]) == status
    assert f"{more:.3f}" in capsys.readouterr().out

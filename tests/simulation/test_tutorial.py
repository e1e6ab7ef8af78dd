# SPDX-License-Identifier: Apache-2.0
"""The flight of docs/tutorial.md prints what the page shows (SIM-1), and the
gain that it changes is there."""

import re
import subprocess

import pytest
from conftest import PROGRAM, ROOT, TIME_LIMIT_S
from test_flight import has_jsbsim

PAGE = (ROOT / "docs" / "tutorial.md").read_text("utf-8")


def blocks(part):
    """The indented blocks of a part."""
    text = PAGE.partition(f"\n## {part}.")[2].partition("\n## ")[0]
    return [re.sub(r"^ {4}", "", block, flags=re.M)
            for block in re.findall(r"(?:^ {4}.*\n)+", text, re.M)]


def test_sim1_the_flight_of_the_tutorial_prints_what_it_shows(tmp_path):
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "urv_sim").symlink_to(PROGRAM)
    (tmp_path / "flight").mkdir()
    commands, shown = blocks(3)
    printed = subprocess.run(
        ["bash", "-e", "-c", commands], cwd=tmp_path, check=True, text=True,
        stdout=subprocess.PIPE, timeout=TIME_LIMIT_S).stdout
    # All but the speed of this machine.
    assert printed.splitlines()[1:] == shown.splitlines()[1:]


def test_sim1_the_gain_of_the_tutorial_is_there():
    found = re.search(r"sed -i 's/(.*?)/(.*?)/' \\\n +(\S+)", PAGE)
    assert found[1] in (ROOT / found[3]).read_text("utf-8")

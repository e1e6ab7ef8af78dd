# SPDX-License-Identifier: Apache-2.0
"""The flights of README.md and docs/tutorial.md print what the pages show
(SIM-1), and the gain that the tutorial changes is there."""

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


def test_sim1_the_standard_flight_prints_the_lines_of_the_readme():
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")
    readme = (ROOT / "README.md").read_text("utf-8")
    shown = [line.strip() for line in
             readme.partition("## Expected result")[2].splitlines()
             if line.startswith("    ")
             # The program prints neither make's lines nor the same speed.
             and not line.strip().startswith(("fly:", "flown", "N passed"))]
    assert len(shown) >= 8
    printed = subprocess.run(
        [PROGRAM, "fly", "--plant", "jsbsim", "--pilot", "standard"],
        check=True, text=True, stdout=subprocess.PIPE,
        timeout=TIME_LIMIT_S).stdout
    assert [line for line in shown if line not in
            map(str.strip, printed.splitlines())] == []


def test_sim1_the_gain_of_the_tutorial_is_there():
    found = re.search(r"sed -i 's/(.*?)/(.*?)/' \\\n +(\S+)", PAGE)
    assert found[1] in (ROOT / found[3]).read_text("utf-8")

# SPDX-License-Identifier: Apache-2.0
"""LNK-9: the exhaustive exploration of both boards finds nothing, and finds
bugs that were planted (docs/evidence/exploration.md)."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from conftest import ROOT

TIME_LIMIT_S = 600
TURNS = "src/telemetry/telemetry-turns.ads"

# Name: file, text, what stands there instead, what the exploration says.
CANARIES = {
    "the ground does not wait in its reset": (
        TURNS,
        "Idle_Time  : constant Character_Times := 24;",
        "Idle_Time  : constant Character_Times := 1;",
        "back in step: TOO LATE",
    ),
    "the aircraft waits longer than the ground ever does": (
        TURNS,
        "      else Dead_Space)",
        "      elsif Item.Role = Aircraft then 50 else Dead_Space)",
        "back in step: ",
    ),
}


def build(folder):
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P", folder / "explore/urv_explore.gpr",
         "-XURV_Mode=host"],
        check=True, timeout=TIME_LIMIT_S,
    )


def explore(folder):
    return subprocess.run(
        [folder / "bin" / "urv_explore"],
        capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False,
    )


def figure(text, pattern):
    found = re.search(pattern, text)
    assert found, f"no line {pattern!r} in:\n{text}"
    return int(found[1])


def test_everything_explored_recovers():
    build(ROOT)
    result = explore(ROOT)
    out = result.stdout
    assert result.returncode == 0, out + result.stderr
    assert out.endswith("explored: all is well\n")
    assert out.count("normal form exact") == 2
    assert figure(out, r"back in step: (\d+) states") > 10_000_000
    for way in ("uplink", "downlink"):
        assert figure(out, rf"fresh {way}: (\d+) states") > 1_000_000
        assert figure(out, rf"fresh {way}: worst after .*, (\d+) major") <= 3


@pytest.mark.parametrize("name", CANARIES)
def test_a_planted_bug_is_found(name, tmp_path):
    file, text, instead, says = CANARIES[name]
    for part in ("src", "explore", "proofs"):
        shutil.copytree(ROOT / part, tmp_path / part)
    for part in ("urv.gpr", "ravenscar.adc"):
        shutil.copy(ROOT / part, tmp_path)
    # What is built need not be built again, but for what sees the bug.
    for part in ("obj/host", "obj/explore-host"):
        if (ROOT / part).is_dir():
            shutil.copytree(ROOT / part, tmp_path / part,
                            ignore=lambda folder, names: [
                                name for name in names
                                if (Path(folder) / name).is_dir()])
    source = (tmp_path / file).read_text("utf-8")
    assert source.count(text) == 1, f"{file} has changed: renew the canary"
    (tmp_path / file).write_text(source.replace(text, instead), "utf-8")
    build(tmp_path)
    result = explore(tmp_path)
    assert result.returncode == 1, result.stdout + result.stderr
    assert says in result.stdout

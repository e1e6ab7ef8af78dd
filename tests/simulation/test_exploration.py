# SPDX-License-Identifier: Apache-2.0
"""LNK-9, D-28: the exploration of both boards finds nothing, and finds bugs
that were planted. Here blocks are short, and boards come in step;
`make -C evidence explore` explores everything (docs/evidence/exploration.md)."""

import re
import subprocess
import sys

import pytest

from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts"))

import tree_copy  # noqa: E402

TIME_LIMIT_S = 900
TURNS = "src/telemetry/telemetry-turns.ads"
CHANGES = "src/telemetry/telemetry-turns-changes.adb"

# Name: file, text, the replacement, and the exploration's message with blocks
# of 2 bytes: the real lengths take ten times as long.
CANARIES = {
    "the ground does not wait in its reset": (
        TURNS,
        "(if This.State = Idling then Idle_Time_On (This.Round_Trip)",
        "(if This.State = Idling then 1",
        "back in step: NEVER",
    ),
    "the aircraft waits longer than the ground ever does": (
        TURNS,
        "      else Dead_Space_On (This.Round_Trip))",
        "      elsif This.Role = Aircraft then 200 else Dead_Space)",
        "back in step: ",
    ),
    "the ground sends without limit": (
        CHANGES,
        "This.In_A_Row := This.In_A_Row + 1;",
        "null;",
        "back in step: NEVER",
    ),
}


def build(folder, *options):
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P",
         folder / "evidence/explore/urv_explore.gpr", "-XURV_Mode=host", *options],
        check=True, timeout=TIME_LIMIT_S,
    )


def explore(folder, *arguments):
    return subprocess.run(
        [folder / "bin" / "urv_explore", *arguments],
        capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False,
    )


def figure(text, pattern):
    found = re.search(pattern, text)
    assert found, f"no line {pattern!r} in:\n{text}"
    return int(found[1])


def test_lnk11_boards_that_wait_longest_come_in_step():
    """On a wire: what they wait for is no part of it."""
    build(ROOT)
    result = explore(ROOT, "1", "1", "in-step", "29")
    out = result.stdout
    assert result.returncode == 0, out + result.stderr
    assert "dead space 49, idle time 53," in out
    assert out.count("normal form exact") == 2
    assert figure(out, r"back in step: (\d+) states") > 1_000_000


@pytest.mark.parametrize("arguments", [("28",), ("28", "3"), ("x", "56"),
                                       ("28", "56", "all"),
                                       ("1", "1", "in-step", "30")])
def test_wrong_arguments_are_refused(arguments):
    build(ROOT)
    result = explore(ROOT, *arguments)
    assert result.returncode == 2
    assert any(each in result.stderr for each in
               ("usage", "1, 2, 4, 28 or 56", "is no round trip: 0 to 29"))


@pytest.fixture(scope="module")
def copied(tmp_path_factory):
    """A copy of the tree, with its objects."""
    build(ROOT)
    folder = tmp_path_factory.mktemp("exploration")
    tree_copy.renew_copy(ROOT, folder)
    tree_copy.take_objects(ROOT, folder, ("host", "explore-host"))
    return folder


@pytest.mark.parametrize("name", CANARIES)
def test_a_planted_bug_is_found(name, copied):
    file, text, instead, says = CANARIES[name]
    source = copied / file
    original = source.read_text("utf-8")
    assert original.count(text) == 1, f"{file} has changed: renew the canary"
    try:
        source.write_text(original.replace(text, instead), "utf-8")
        # The optimiser takes more time than it saves.
        build(copied, "-m2", "-cargs:Ada", "-O0")
        result = explore(copied, "2", "2", "in-step")
    finally:
        source.write_text(original, "utf-8")
    assert result.returncode == 1, result.stdout + result.stderr
    assert says in result.stdout

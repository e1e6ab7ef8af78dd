# SPDX-License-Identifier: Apache-2.0
"""BRD-8, D-99: the dual-ported memory of the MC68000's two processors, with all
orders of their accesses, by exploration of the programs' instructions."""

import os
import shutil
import subprocess
import time

import pytest

import bare
import emulated
import explorations

MACHINE = emulated.MC68000_BOARD
pytestmark = bare.needs(MACHINE, MACHINE.archive)

DUAL_PORTED = "targets/mc68000/telemetry-boards-dual_ported.adb"

CLAIM = "      Claim (Claimed);\n      if Claimed then\n         {}"
BY_CONTROLLER = CLAIM.replace("Claim (", "Claim_By_Controller (")


@pytest.fixture(scope="module", autouse=True)
def built():
    """The explorer and its program."""
    MACHINE.build("exploration")


def chosen(moment, operation):
    return list(explorations.scenarios(
        {moment: explorations.MOMENTS[moment]},
        {operation: explorations.OPERATIONS[operation]}))


def test_brd8_d99_operations_are_as_if_one_came_after_the_other():
    """Each of the controller's, beside the telemetry board's at the moments
    that change its buffers, with two switches: any pair of accesses."""
    lines, wrong = explorations.explored()
    assert wrong == set()
    assert len(lines) == (
        len(explorations.MOMENTS) * len(explorations.OPERATIONS))
    # Beyond one run to the end from each beginner, and orders that matter.
    assert all(explorations.number("runs", each) > 80
               for each in lines.values())
    assert sum(explorations.number("outcomes", each) > 1
               for each in lines.values()) > 30


def test_brd8_a_divided_tas_is_found():
    """Between its read and its write the other processor claims, too."""
    lines, wrong = explorations.explored(
        divided=True, chosen=chosen("third_block_ends", "take"))
    assert wrong == {"take_as_third_block_ends"}
    # The same run is wrong again, when the printed command makes it. Both
    # processors read a free lock before one of them takes it.
    name, = wrong
    program, *arguments = explorations.command(name, lines[name]).split()
    assert program == "targets/explorations.py"
    status, text = explorations.again(
        arguments[0], arguments[1], arguments[2:], divided=True)
    results = lines[name].partition("; results")[2].partition(" runs ")[0]
    assert status == 1 and f"; results{results}\n{name} runs 1 " in text
    locks = [line.split()[2:3] + line.split()[5:] for line in text.splitlines()
             if " 200004 " in line]
    assert ["0", "reads", "200004", "00"] in locks
    first = next(place for place, each in enumerate(locks)
                 if each[1:] == ["writes", "200004", "80"])
    assert sorted(locks[:first])[-2:] == [
        ["0", "reads", "200004", "00"], ["1", "reads", "200004", "00"]]
    # Whole, it is right.
    assert explorations.again(
        arguments[0], arguments[1])[0] == 0


@pytest.fixture(scope="module")
def copy(tmp_path_factory):
    """The sources and objects of the exploration's program."""
    folder = tmp_path_factory.mktemp("dual_port")
    for name in ("src", "targets", "obj/targets/mc68000/runtime",
                 "obj/targets/mc68000/objects"):
        shutil.copytree(bare.ROOT / name, folder / name, symlinks=True)
    return folder


@pytest.mark.parametrize("text, planted, moment, operation", [
    ("if not Is_Taken_By_Other then",
     "if not Is_Taken_By_Other or else Is_Ready then",
     "third_block_ends", "take"),
    (BY_CONTROLLER.format("Take"), "      Claimed := Is_Ready;\n"
     "      if Claimed then\n         Take", "third_block_ends", "take"),
    (BY_CONTROLLER.format("Put"), "      Claimed := Is_Ready;\n"
     "      if Claimed then\n         Put", "new_block_begins", "put"),
    (CLAIM.format("News := 0"), "      Claimed := Is_Ready;\n"
     "      if Claimed then\n         News := 0", "new_block_begins", "put"),
    ("         Put (Shared, Data, Overwrote);\n         News := 1;\n"
     "         Release;\n",
     "         Release;\n         Put (Shared, Data, Overwrote);\n"
     "         News := 1;\n", "new_block_begins", "put"),
], ids=["no claim", "Take without a claim", "Put without a claim",
        "Next_Character without a claim", "released before Put"])
def test_brd8_d99_a_removed_claim_is_found(
        copy, text, planted, moment, operation):
    path = copy / DUAL_PORTED
    good = path.read_text()
    assert good.count(text) == 1
    # The builder compares whole seconds, and builds what is newer.
    later = max(path.stat().st_mtime, time.time()) + 2
    path.write_text(good.replace(text, planted))
    os.utime(path, (later, later))
    try:
        subprocess.run(
            [copy / "targets/build.sh", MACHINE.name, "exploration"],
            check=True)
        _, wrong = explorations.explored(
            folder=copy / "obj/targets/mc68000",
            chosen=chosen(moment, operation))
    finally:
        path.write_text(good)
        os.utime(path, (later + 2, later + 2))
    assert wrong == {f"{operation}_as_{moment}"}

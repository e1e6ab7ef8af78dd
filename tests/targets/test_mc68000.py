# SPDX-License-Identifier: Apache-2.0
"""BRD-1 to BRD-4: both nodes on the report's processor, on an emulated board
beside the simulation of the same flight."""

import pytest

import bare
import emulated

MACHINE = emulated.MC68000_BOARD
pytestmark = bare.needs(MACHINE, MACHINE.archive)

ILLEGAL, ADDRESS_ERROR, UNUSED_VECTOR = 4, 3, 200


@pytest.fixture(scope="module", autouse=True)
def built():
    """The board and both images."""
    for node in ("mcs", "gsc"):
        MACHINE.build(node)


@pytest.mark.parametrize("laws", [False, True], ids=["direct", "laws"])
def test_brd4_each_frame_has_the_words_of_the_simulation(tmp_path, laws):
    """The board traps words at odd addresses, and none comes."""
    bare.flies_like_the_simulation(MACHINE, tmp_path, laws)


@pytest.mark.parametrize("events", [
    [(emulated.ILLEGAL_INSTRUCTION, ILLEGAL),
     (emulated.UNEXPECTED_INTERRUPT, UNUSED_VECTOR)],
    [(emulated.ODD_ADDRESS, ADDRESS_ERROR),
     (emulated.ODD_ADDRESS, ADDRESS_ERROR)]],
    ids=["illegal instruction, unused interrupt", "odd address"])
def test_brd2_d81_a_fault_of_the_processor_restarts_it(tmp_path, events):
    bare.restarts(MACHINE, tmp_path, events)


@pytest.mark.parametrize("place", [-1, 0x1_8000, "program"],
                         ids=["sum", "over 64 KiB", "program"])
def test_brd3_tst1_a_changed_bit_of_the_image_is_refused(tmp_path, place):
    bare.refuses_a_changed_bit(MACHINE, tmp_path, place)


def test_d83_a_flight_is_the_same_on_every_run(tmp_path):
    texts = []
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        runs = MACHINE.fly({"gsc": emulated.Tape(1),
                            "mcs": emulated.Tape(1, lag=emulated.LAG)},
                           tmp_path / name)
        texts.append([run.text for run in runs.values()])
    assert texts[0] == texts[1]

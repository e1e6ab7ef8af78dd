# SPDX-License-Identifier: Apache-2.0
"""BRD-1, BRD-2, BRD-3: both nodes on a bare Cortex-M4, in QEMU, beside the
simulation of the same flight."""

import time

import pytest

import bare
import emulated
import image_sum

MACHINE = emulated.CORTEX_M
pytestmark = bare.needs(MACHINE)


@pytest.fixture(scope="module", autouse=True)
def built():
    """Both images."""
    for node in ("mcs", "gsc"):
        MACHINE.build(node)


@pytest.mark.parametrize("laws", [False, True], ids=["direct", "laws"])
def test_brd1_each_frame_has_the_words_of_the_simulation(tmp_path, laws):
    bare.flies_like_the_simulation(MACHINE, tmp_path, laws)


def test_brd1_a_node_that_starts_later_loses_no_character(
        tmp_path, monkeypatch):
    start = MACHINE.start

    def late(*given):
        for node in start(*given):
            yield node
            time.sleep(2)

    monkeypatch.setattr(MACHINE, "start", late)
    rows, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    assert list(emulated.differences(rows, runs)) == []


def test_brd1_a_difference_is_found(tmp_path):
    rows, runs = MACHINE.fly_both(tmp_path, 1, laws=False)
    rows[20]["pwm.throttle"] = str(int(rows[20]["pwm.throttle"]) ^ 1)
    rows[30]["gsc.downlink.alpha"] = "4096"
    assert list(emulated.differences(rows, runs)) == [
        (20, "pwm"), (30, "gsc.downlink")]


def test_brd2_d81_a_fault_of_the_processor_restarts_it(tmp_path):
    bare.restarts(MACHINE, tmp_path, [
        (emulated.ILLEGAL_INSTRUCTION, 3),       # hard fault
        (emulated.UNEXPECTED_INTERRUPT, 23)])    # interrupt 7


@pytest.mark.parametrize("place", [-5, -1, 0x1_0000, "program"],
                         ids=["filling", "sum", "over 64 KiB", "program"])
def test_brd3_tst1_a_changed_bit_of_the_image_is_refused(tmp_path, place):
    bare.refuses_a_changed_bit(MACHINE, tmp_path, place)


def test_brd3_the_sum_is_that_of_the_flight_software():
    """The register after the image and its sum is one known number."""
    source = (bare.ROOT / "src/kernel/self_test/urvos-image_sums.ads").read_text()
    good = int(source.split("Good_Image : constant Sum := 16#")[1]
               .split("#")[0].replace("_", ""), 16)
    image = image_sum.image_of(b"a program", MACHINE.rom_size)
    assert len(image) == MACHINE.rom_size
    assert image_sum.crc(image) ^ 0xFFFFFFFF == good


def test_brd3_a_program_that_is_too_long_gets_no_sum():
    with pytest.raises(ValueError, match="114685 bytes: 114684 is the most"):
        image_sum.image_of(bytes(MACHINE.rom_size - 3), MACHINE.rom_size)


def test_d80_the_runtime_needs_no_tasks_and_no_exceptions():
    text = (MACHINE.images / "runtime/adainclude/system.ads").read_text()
    for restriction in ("No_Tasking", "No_Exception_Propagation",
                        "No_Finalization"):
        assert f"pragma Restrictions ({restriction});" in text


def test_d82_a_flight_is_the_same_on_every_run(tmp_path):
    texts = []
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        line = {"quantum": MACHINE.quantum,
                "line_delay_us": MACHINE.line_delay_us}
        tapes = {"gsc": emulated.Tape(1, **line),
                 "mcs": emulated.Tape(1, lag=emulated.LAG, **line)}
        runs = MACHINE.fly(tapes, tmp_path / name)
        texts.append([runs[node].text for node in tapes])
    assert texts[0] == texts[1]

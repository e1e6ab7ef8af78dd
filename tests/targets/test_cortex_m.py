# SPDX-License-Identifier: Apache-2.0
"""BRD-1, BRD-2, BRD-3: both nodes on a bare Cortex-M4, in QEMU, beside the
simulation of the same flight."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "targets"))

import emulated  # noqa: E402
import image_sum  # noqa: E402

NEEDED = ("qemu-system-arm", "arm-linux-gnueabihf-gnatmake-12")
MISSING = [name for name in NEEDED if not shutil.which(name)]
pytestmark = pytest.mark.skipif(
    bool(MISSING), reason=f"not installed: {', '.join(MISSING)}")

SECONDS = 6

# Status words of CORE memory.
START, COLD, WARM, PROCESSOR, SELF_TEST = range(5)
ROM_FAILED = 0x1000

SAFE = [0x800] * 7 + [0, 0xFFF] + [0x800] * 4 + [0]


@pytest.fixture(scope="module", autouse=True)
def built():
    """Both images."""
    for node in ("mcs", "gsc"):
        subprocess.run([ROOT / "targets" / "build.sh", "cortex_m", node],
                       check=True)


@pytest.mark.parametrize("laws", [False, True], ids=["direct", "laws"])
def test_brd1_each_frame_has_the_words_of_the_simulation(tmp_path, laws):
    rows, runs = emulated.fly_both(tmp_path, SECONDS, laws)
    frames = SECONDS * emulated.FRAMES_PER_S
    assert len(rows) == frames
    assert list(emulated.differences(rows, runs)) == []
    # They differ from frame to frame, or this would not show much.
    servos = runs["mcs"].rows
    assert len({tuple(runs["mcs"].pwm(frame)) for frame in servos}) > frames / 4
    for node in runs.values():
        assert sorted(node.rows)[:frames - 1] == list(range(frames - 1))
        assert node.numbers["overruns"] == 0
        assert node.numbers["received"] >= frames - 4
        assert node.numbers["bad"] == node.numbers["resets"] == 0
        last = max(node.rows)
        assert node.status(last)[:SELF_TEST + 1] == [1, 1, 0, 0, 0]


def test_brd1_a_difference_is_found(tmp_path):
    rows, runs = emulated.fly_both(tmp_path, 1, laws=False)
    rows[20]["pwm.throttle"] = str(int(rows[20]["pwm.throttle"]) ^ 1)
    rows[30]["gsc.downlink.alpha"] = "4096"
    assert list(emulated.differences(rows, runs)) == [
        (20, "pwm"), (30, "gsc.downlink")]


def test_brd2_d81_a_fault_of_the_processor_restarts_it(tmp_path):
    """The words of the servos stay, and the node goes on."""
    tape = emulated.Tape(2)
    tape.plant(500, emulated.ILLEGAL_INSTRUCTION)
    tape.plant(1000, emulated.UNEXPECTED_INTERRUPT)
    run = emulated.fly({"mcs": tape}, tmp_path)["mcs"]
    assert run.text.count("MCS processor restart\n") == 2
    assert run.has("restarts count 1 reason 3")        # hard fault
    assert run.has("restarts count 2 reason 23")       # interrupt 7
    counts = {frame: run.status(frame)[PROCESSOR] for frame in run.rows}
    assert [counts[frame] for frame in (23, 28, 48, 53)] == [0, 1, 1, 2]
    assert all(run.pwm(frame) == SAFE for frame in run.rows)
    # Ticks went on: a row each 20 ms, and the sensors are new ones again.
    assert sorted(run.rows) == list(range(len(run.rows)))
    assert len(run.rows) >= 98
    last = max(run.rows)
    assert run.downlink(last)[-1] & 1 == 0
    assert run.status(last)[:SELF_TEST + 1] == [3, 1, 0, 2, 0]


@pytest.mark.parametrize("place", [-5, -1, 0x1_0000, 0x2000],
                         ids=["filling", "sum", "over 64 KiB", "program"])
def test_brd3_tst1_a_changed_bit_of_the_image_is_refused(tmp_path, place):
    image = bytearray((emulated.IMAGES / "mcs.bin").read_bytes())
    # In the program, a bit of a text or table that the start does not need.
    if place == 0x2000:
        place = image.index(b"overruns")
    image[place] ^= 0x10
    (tmp_path / "mcs.bin").write_bytes(image)
    run = emulated.fly({"mcs": emulated.Tape(1)}, tmp_path,
                       {"mcs": tmp_path / "mcs.bin"})["mcs"]
    assert run.has("MCS refused") and not run.has("MCS started")
    last = max(run.rows)
    assert run.status(last)[SELF_TEST] == ROM_FAILED
    assert run.uplink(last) == [0] * emulated.UPLINK
    assert run.pwm(last) == SAFE


def test_brd3_the_sum_is_that_of_the_flight_software():
    """The register after the image and its sum is one known number."""
    source = (ROOT / "src/kernel/self_test/urvos-image_sums.ads").read_text()
    good = int(source.split("Good_Image : constant Sum := 16#")[1]
               .split("#")[0].replace("_", ""), 16)
    image = image_sum.image_of(b"a program")
    assert len(image) == image_sum.SIZE
    assert image_sum.crc(image) ^ 0xFFFFFFFF == good


def test_brd3_a_program_that_is_too_long_gets_no_sum():
    with pytest.raises(ValueError, match="98301 bytes: 98300 is the most"):
        image_sum.image_of(bytes(image_sum.SIZE - 3))


def test_d80_the_runtime_needs_no_tasks_and_no_exceptions():
    text = (emulated.IMAGES / "runtime/adainclude/system.ads").read_text()
    for restriction in ("No_Tasking", "No_Exception_Propagation",
                        "No_Finalization"):
        assert f"pragma Restrictions ({restriction});" in text


def test_d82_a_flight_is_the_same_on_every_run(tmp_path):
    texts = []
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
        tapes = {"gsc": emulated.Tape(1, quantum=emulated.QUANTUM),
                 "mcs": emulated.Tape(1, quantum=emulated.QUANTUM, lag=emulated.LAG)}
        runs = emulated.fly(tapes, tmp_path / name)
        texts.append([runs[node].text for node in tapes])
    assert texts[0] == texts[1]

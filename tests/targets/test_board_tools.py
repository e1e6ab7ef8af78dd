# SPDX-License-Identifier: Apache-2.0
"""BRD-1, BRD-4, BRD-5, BRD-8: the programs in targets report what they miss,
and claim nothing of a flight that did not end."""

import shutil
import subprocess
import sys

import pytest

import bare
import emulated

EMULATOR = "#!/bin/sh\necho 'board: mcs: reads nothing at 400000' >&2\nexit 2\n"


@pytest.fixture(name="copy")
def fixture_copy(tmp_path):
    """The programs alone, in a repository where nothing was built."""
    shutil.copytree(bare.ROOT / "targets", tmp_path / "targets",
                    ignore=shutil.ignore_patterns("__pycache__"))
    return tmp_path


def ended(copy, *arguments):
    """The exit status of a program and its last line."""
    name, *more = arguments
    program = [copy / "targets" / name]
    if name.endswith(".py"):
        program.insert(0, sys.executable)
    done = subprocess.run([*program, *more], capture_output=True, text=True,
                          check=False, cwd=copy)
    assert "Traceback" not in done.stderr
    return done.returncode, (done.stderr.strip().splitlines() or [""])[-1]


@pytest.mark.parametrize("arguments, status, line", [
    (("figures.py", "cortex_m"), 1, "figures.py: missing: "),
    (("figures.py", "mc68000", "1"), 1, "figures.py: missing: "),
    (("figures.py", "cortex_m", "361"), 1,
     "figures.py: 361 s: a flight has up to 360 s"),
    (("figures.py", "cortex_m", "0"), 1,
     "figures.py: 0 s: a flight has up to 360 s"),
    (("figures.py", "cortex_m", "ten"), 1, "Exit status: 0 when all words"),
], ids=["cortex_m", "mc68000", "too long", "no time", "no number"])
def test_brd1_figures_reports_what_it_cannot_fly(
        copy, arguments, status, line):
    found, last = ended(copy, *arguments)
    assert found == status and last.startswith(line)


def test_brd5_cost_reports_missing_images(copy):
    found, last = ended(copy, "cost.py", "mc68000")
    assert found == 1 and last.startswith("cost.py: missing: ")


def test_brd4_alignments_does_not_praise_types_that_it_has_not_seen(copy):
    assert ended(copy, "alignments.py") == (
        2, "alignments.py: no listings to look at: make mc68000 makes them")


def test_brd8_explorations_reports_a_missing_program(copy):
    found, last = ended(copy, "explorations.py")
    assert found == 1
    assert last.startswith("explorations.py: missing: explore: ")
    for arguments in (["two"], ["1", "2"], ["take_as_start"],
                      ["take_as_start", "one"]):
        assert ended(copy, "explorations.py", *arguments)[1].startswith(
            "the same operations one after the other.")


@pytest.mark.parametrize("arguments", [(), ("cortex_m",)])
def test_brd1_a_build_without_a_program_shows_its_usage(copy, arguments):
    assert ended(copy, "build.sh", *arguments) == (
        2, "usage: targets/build.sh MACHINE PROGRAM, as cortex_m mcs")


def test_brd1_a_failed_emulator_ends_the_flight_with_its_reason(
        tmp_path, monkeypatch):
    emulator = tmp_path / "board"
    emulator.write_text(EMULATOR)
    emulator.chmod(0o755)
    monkeypatch.setattr(emulated, "IMAGES", tmp_path.parent)
    monkeypatch.setattr(emulated.MC68000_BOARD, "name", tmp_path.name)
    with pytest.raises(emulated.Failed, match="reads nothing at 400000"):
        emulated.MC68000_BOARD.fly({"mcs": emulated.Tape(1)}, tmp_path)


def test_brd1_an_emulator_that_does_not_end_fails_the_flight(
        tmp_path, monkeypatch):
    emulator = tmp_path / "board"
    emulator.write_text("#!/bin/sh\nexec sleep 60\n")
    emulator.chmod(0o755)
    monkeypatch.setattr(emulated, "IMAGES", tmp_path.parent)
    monkeypatch.setattr(emulated.MC68000_BOARD, "name", tmp_path.name)
    with pytest.raises(emulated.Failed, match="no end after 0.1 s"):
        emulated.MC68000_BOARD.fly({"mcs": emulated.Tape(1)}, tmp_path,
                                   limit_s=0.1)


def test_brd1_a_frame_without_a_row_is_found():
    """A node that has no row of a frame has no words that differ."""
    rows = [{"frame": str(frame)} for frame in range(4)]
    run = emulated.Run("row frame 0 1\nrow frame 2 1\n")
    assert list(emulated.missing(rows, {"gsc": run})) == [(1, "gsc")]

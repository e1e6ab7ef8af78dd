# SPDX-License-Identifier: Apache-2.0
"""LNK-9, INI-1, SEC-1: the smallest campaign, and that its checker sees what it
should."""

import subprocess
import sys

import pytest
from conftest import PROGRAM, ROOT

sys.path.insert(0, str(ROOT / "evidence" / "campaign"))

import cases  # noqa: E402
import checker  # noqa: E402
import run  # noqa: E402


@pytest.fixture(autouse=True)
def _same_program(monkeypatch):
    monkeypatch.setattr(run, "PROGRAM", PROGRAM)


@pytest.mark.parametrize("name", [
    name for name in cases.plan("tiny") if not name.startswith("mix")])
def test_link_recovers(name):
    result = run.run_shard(name)
    assert result["failures"] == []
    assert sum(result["recovered_within"]) == result["cases"] > 0


@pytest.mark.parametrize("name", [
    "single/3/0/72000/400", "many/3/0/400", "stall/0/mcs/5/2000",
    "reset/7/gsc/2000", "start/3/mcs/warm/2000", "start/3/gsc/processor/2000",
    "cut/3/3/60", "soak/3/4/1e-2/2000", "calm/6/200", "mix/0/20"])
def test_sec1_a_sealed_link_recovers_in_the_same_bounds(name):
    result = run.run_shard(name, 2)
    assert result["failures"] == []
    assert result["wrong"] == 0
    if not name.startswith("mix"):
        assert sum(result["recovered_within"]) == result["cases"] > 0


def test_sec1_what_the_checksum_lets_through_is_refused():
    """Not the same blocks: other bytes agree with the checksum by chance."""
    name = "many/3/0/400"
    plain, sealed = (run.run_shard(name, number) for number in (1, 2))
    assert plain["wrong"] > 0 == plain["refused"]
    assert sealed["refused"] > 0 == sealed["wrong"]
    assert sealed["came_twice"] > 0
    assert sealed["failures"] == []


# --- what the checker sees ------------------------------------------------

FRAMES = 80


@pytest.fixture
def flown(tmp_path):
    """A flight with these faults; its record and wire may be altered."""

    def fly(faults="", alter=None, message_format=1, flown=None):
        result = run.fly(tmp_path, 3, 1, FRAMES, faults or "# none\n",
                         flown or message_format)
        assert result.returncode == 0, result.stderr
        if alter:
            name, change = alter
            path = tmp_path / name
            path.write_text(change(path.read_text()))
        flight = checker.Flight(
            tmp_path / "record.csv", tmp_path / "wire.csv", FRAMES,
            message_format)
        flight.learn_lags(39)
        return flight

    return fly


def altered(row, column, word):
    """Puts another word into the record."""

    def change(text):
        lines = text.split("\n")
        cells = lines[row + 1].split(",")
        cells[lines[0].split(",").index(column)] = str(word)
        lines[row + 1] = ",".join(cells)
        return "\n".join(lines)

    return "record.csv", change


def test_a_flight_without_faults_is_calm(flown):
    flight = flown()
    assert flight.errors == flight.wire_errors == flight.wrong == []
    assert all(flight.is_calm(frame) for frame in range(10, FRAMES))


def test_sec1_a_sealed_flight_without_faults_is_calm(flown, tmp_path):
    flight = flown(message_format=2)
    assert flight.errors == flight.wire_errors == flight.wrong == []
    assert all(flight.is_calm(frame) for frame in range(10, FRAMES))
    assert (tmp_path / "key").stat().st_mode & 0o777 == 0o600
    assert run.refused_in(tmp_path) == flight.came_twice == 0


def test_sec1_what_no_checksum_sees_a_seal_does(flown, tmp_path):
    """Two bits of data 17 apart, and the parity bits of their characters: the
    checksum's polynomial divides x^17 + 1."""
    faults = "1000 up flip 7 101\n1000 up flip 9 102\n"
    assert [wrong.way for wrong in flown(faults).wrong] == ["up"]
    flight = flown(faults, message_format=2)
    assert flight.wrong == flight.errors == flight.wire_errors == []
    assert run.refused_in(tmp_path) == 1
    assert flight.came_twice == 0


@pytest.mark.parametrize("told, flown_in", [(1, 2), (2, 1)])
def test_a_flight_of_the_other_format_is_seen(flown, told, flown_in):
    errors = flown(message_format=told, flown=flown_in).wire_errors
    assert [error.split(":")[0] for error in errors] == ["up", "down"]


@pytest.mark.parametrize("column", ["mcs.uplink.switch8",
                                    "gsc.downlink.altitude",
                                    "mcs.uplink.error"])
def test_a_block_never_sent_is_seen(flown, column):
    flight = flown(alter=altered(50, column, 4099))
    assert [block.frame for block in flight.wrong] == [50]
    assert not flight.is_calm(50) and flight.is_calm(51)


def test_an_old_block_after_a_newer_one_is_seen(flown):
    def change(text):
        lines = text.split("\n")
        lines[51], lines[61] = lines[61], lines[51]
        return "\n".join(lines)

    errors = flown(alter=("record.csv", change)).errors
    assert any("came after" in error for error in errors)


@pytest.mark.parametrize("count", [
    "uplink_sent", "uplink_received", "downlink_sent", "downlink_received"])
def test_a_count_that_is_not_the_wires_is_seen(flown, count):
    flight = flown(alter=altered(FRAMES - 1, f"link.{count}", 70))
    assert any(error.startswith(f"{count} is 70")
               for error in flight.wire_errors)


def test_a_byte_that_begins_no_message_is_seen(flown):
    flight = flown(alter=("wire.csv", lambda text: text.replace(
        ",up,4b", ",up,00", 1)))
    assert any("begins no message: 00" in error
               for error in flight.wire_errors)


def test_a_start_that_takes_too_long_is_seen(monkeypatch):
    monkeypatch.setitem(checker.BOUNDS, "start", 2)
    failures = run.run_shard("start/3/mcs/processor/4000")["failures"]
    assert len(failures) == 5
    assert all("recovered after" in failure for failure in failures)


@pytest.mark.parametrize("cut_ms, frames", [(0, 0), (30, 2), (400, None)])
def test_recovery_is_counted_from_the_last_fault(flown, cut_ms, frames):
    # The case says 0 ms; the cut is longer, so recovery comes later.
    flight = flown(f"800 cut {cut_ms}\n")
    case = cases.case([cases.lasting(0, "", "cut {ms}", 0)], 0)
    took = flight.recovery(case, 40, 40 + case.frames)
    assert (took is None) == (frames is None)
    if frames is not None:
        assert took >= frames


def test_a_shard_that_cannot_fly_fails(monkeypatch):
    monkeypatch.setattr(run, "fly", lambda *_: subprocess.CompletedProcess(
        [], 1, "", "urv_sim: internal fault"))
    assert run.run_shard("cut/3/0/400")["failures"] == [
        "cut/3/0/400: status 1: urv_sim: internal fault"]


def shard_result(**changed):
    return {"shard": "many/3/0/100", "cases": 100, "frames": 1000,
            "faults": 250, "recovered_within": [0, 50, 50, 0, 0, 0],
            "wrong": 0, "refused": 0, "came_twice": 0,
            "wrong_by_theory": 1.0, "failures": [], **changed}


@pytest.mark.parametrize("changed, status", [
    ({}, 0),
    ({"wrong": 3}, 0),
    ({"wrong": 30}, 1),
    ({"refused": 3, "came_twice": 90}, 0),
    ({"wrong": 15, "refused": 15}, 1),
    ({"failures": ["many/3/0/100: 800 up drop 1: recovered after 4 frames"]},
     1),
])
def test_report_fails_when_a_check_did(
        monkeypatch, tmp_path, capsys, changed, status):
    monkeypatch.setattr(run, "RESULTS", tmp_path)
    results = [shard_result(), shard_result(**changed)]
    assert run.report(results, "tiny", 1.0) == status
    said = capsys.readouterr().out
    assert f"tiny: 500 faults, {status} failures" in said
    assert ("FAILED" in said) == (status == 1)
    assert (tmp_path / "results.csv").exists()


# --- the command ----------------------------------------------------------

# The arguments of a measurement of nothing, and of workers that do nothing.
NOTHING = [
    ("attack.py", "--flights", "0"), ("attack.py", "--jobs", "0"),
    ("campaign/run.py", "tiny", "--jobs", "0"),
    ("derivatives.py", "--flights", "0"), ("in_step.py", "--frames", "0"),
    ("laws/sound_flights.py", "--flights", "0"),
    ("laws/surfaces.py", "--sample", "0"),
    ("laws/surfaces.py", "--sample", "301"),
    ("laws/surfaces.py", "--sound", "-1"),
    ("link_cuts.py", "--every", "0"), ("link_cuts.py", "--first", "181"),
    ("mutation/run.py", "--jobs", "0"), ("mutation/run.py", "--only", "?"),
    ("planted.py", "nothing"), ("safety/card_flights.py", "--flights", "0"),
    ("seal_tags.py", "0"), ("timing.py", "--seconds", "4")]


@pytest.mark.parametrize(
    "arguments", NOTHING, ids=[" ".join(each) for each in NOTHING])
def test_sec1_a_measurement_of_nothing_is_refused(arguments):
    name, *more = arguments
    done = subprocess.run(
        [sys.executable, ROOT / "evidence" / name, *more], timeout=120,
        capture_output=True, text=True, check=False, cwd=ROOT)
    assert done.returncode != 0
    assert "Traceback" not in done.stderr
    assert more[-1] in (done.stdout + done.stderr).splitlines()[-1]


@pytest.mark.parametrize("name", [
    "calm/0", "single/3/0/0/1", "mix/5", "mix/3/2", "quiet/3/200"])
def test_lnk9_a_name_of_no_shard_is_refused(monkeypatch, capsys, name):
    monkeypatch.setattr(sys, "argv", ["run.py", "shard", name])
    with pytest.raises(SystemExit) as ended:
        run.main()
    assert ended.value.code == 2
    assert f"no such shard: {name}" in capsys.readouterr().err


@pytest.mark.parametrize("failures", [[], ["calm/3/40: not calm"]])
def test_lnk9_a_shard_that_is_repeated_fails_again(monkeypatch, failures):
    monkeypatch.setattr(sys, "argv", ["run.py", "shard", "calm/3/40"])
    monkeypatch.setattr(run, "run_shard",
                        lambda *_: shard_result(failures=failures))
    assert run.main() == len(failures)

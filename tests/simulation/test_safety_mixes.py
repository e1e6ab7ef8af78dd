# SPDX-License-Identifier: Apache-2.0
"""SAF-9: random mixes of all kinds of faults, with nothing unasked at a servo
and nothing old shown as fresh."""

import sys

import pytest
from conftest import PROGRAM, ROOT

sys.path.insert(0, str(ROOT / "evidence" / "campaign"))

import cases  # noqa: E402
import mixes  # noqa: E402
import monitor  # noqa: E402
import run  # noqa: E402

AS_REPORTED = ([], {}, "report", "0")
MIXES = [name for name in cases.plan("tiny") if name.startswith("mix")]


@pytest.fixture(autouse=True)
def _same_program(monkeypatch):
    monkeypatch.setattr(run, "PROGRAM", PROGRAM)


@pytest.mark.parametrize("name", MIXES)
def test_saf9_nothing_unasked_happens_in_a_random_mix(name):
    result = run.run_shard(name)
    assert result["failures"] == []
    assert result["frames"] >= 100 * result["cases"] == 100 * 100


# In step two frames of the aircraft end between two rows: CORE has marked in
# the second what came in the first, or has newer words, and no row shows them.
@pytest.mark.parametrize("number", (1224, 1298, 1545, 7252, 16472,
                                    10870, 14484, 17798))
def test_saf9_what_came_between_two_rows_is_no_violation(number):
    assert run.run_shard(f"mix/{number}/{number + 1}")["failures"] == []


def test_saf9_a_scan_that_was_held_up_sees_a_change_at_its_end():
    assert run.run_shard("mix/8089/8090")["failures"] == []


# The converter stalls in two frames: the first one's scan ends, too late, and
# the second's does not.
def test_saf9_frm5_a_late_scan_is_not_shown_as_the_next_frame_s():
    assert run.run_shard("mix/13020/13021")["failures"] == []


# Memory that is harmed while a start tests it; bus errors before a start that
# does not test; starts that are broken off.
@pytest.mark.parametrize("number", (711, 953, 4433, 4282, 14959, 15332))
def test_saf9_a_start_that_takes_its_time_is_known(number):
    assert run.run_shard(f"mix/{number}/{number + 1}")["failures"] == []


# The console changes within the last scan before it is lost, or is lost while
# the ground's node is down: its last scan is the one before.
@pytest.mark.parametrize("number", (6991, 8454, 3692, 12649, 16184, 17223))
def test_saf9_a_console_is_held_at_its_last_scan(number):
    assert run.run_shard(f"mix/{number}/{number + 1}")["failures"] == []


@pytest.mark.parametrize("size, fewest", [("tiny", 500), ("full", 20_000)])
def test_there_are_as_many_mixes_as_promised(size, fewest):
    shards = [name.split("/")[1:] for name in cases.plan(size)
              if name.startswith("mix")]
    numbers = [number for first, stop in shards
               for number in range(int(first), int(stop))]
    assert numbers == list(range(len(numbers))) and len(numbers) >= fewest


def test_each_kind_of_fault_of_the_program_is_in_the_mixes(urv_sim):
    made = "".join(mixes.of_number(number).files["faults"]
                   for number in range(500))
    for words in ("cut", "up ber", "down ber", "up flip", "down flip",
                  "up drop", "down drop", "up dup", "down dup", "up insert",
                  "down insert",
                  *(f"{node} {kind}" for node in ("gsc", "mcs")
                    for kind in ("stall adc", "stall telemetry",
                                 "reset warm", "reset processor",
                                 "reset telemetry", "bus_error", "rom",
                                 "ram", "halt"))):
        assert f" {words}" in made, words
    phases = {mixes.of_number(number).options[3] for number in range(100)}
    assert phases == set("0123456789")


def test_half_of_the_mixes_fly_as_the_report_has_it():
    made = [mixes.of_number(number) for number in range(500)]
    plain = [mix for mix in made if len(mix.options) == 8]
    assert 200 < len(plain) < 300
    said = [" ".join(mix.options) for mix in made]
    for option in ("--schedule fast", "--lock", "--drift=", "--format 2"):
        assert 50 < sum(option in words for words in said), option
    flying = len(made) - len(plain)
    for rare in ("key", "orders"):
        share = sum(rare in mix.files for mix in made) / flying
        assert share == pytest.approx(0.3, abs=0.1), rare
    drifts = [int(mix.drift) for mix in made]
    assert max(map(abs, drifts)) <= mixes.MOST_DRIFT_PPM
    for sign in (1, -1):
        assert sum(sign * drift > mixes.MOST_DRIFT_PPM / 2
                   for drift in drifts) > 10
    assert any(all(option in words for option in (
        "--schedule fast", "--lock", "--drift=", "--format 2"))
        for words in said)
    assert all(mix.schedule == "fast" for mix in made
               if "fast" in mix.options)
    ordered = "".join(mix.files.get("orders", "") for mix in made)
    assert ordered.count("configure") > 50 and ordered.count("block") > 50


def test_the_words_of_a_mix_stay_at_the_console_for_two_frames():
    for number in range(50):
        rows = mixes.of_number(number).files["sticks"].splitlines()[1:]
        times = [float(row.split(",")[0]) for row in rows]
        assert all(after - before > 39.998 for before, after in zip(
            times, times[1:], strict=False))


def test_a_mix_can_be_flown_again_alone(tmp_path, capsys):
    assert run.show_mix(7, tmp_path / "seven") == 0
    said = capsys.readouterr().out
    assert "--sticks sticks.csv" in said
    assert "mix 7: 0 violations" in said
    first = (tmp_path / "seven" / "record.csv").read_text()
    assert run.show_mix(7, tmp_path / "again") == 0
    assert (tmp_path / "again" / "record.csv").read_text() == first


@pytest.mark.parametrize("number", [149, 271, 314, 319, 381])
def test_saf9_a_stalled_converter_makes_a_scan_straddle_a_change(
        number, monkeypatch, tmp_path):
    """These five of the first 400 look wrong to one who takes a scan for
    half a millisecond, though the ground's converter stood still. They were
    flown as the report has it."""
    monkeypatch.setattr(mixes, "ways_to_fly", lambda *_: AS_REPORTED)
    run.fly_mix(mixes.of_number(number), tmp_path)
    assert run.findings_in(tmp_path).violations == []
    scan = monitor.Flight.scan
    monkeypatch.setattr(monitor.Flight, "scan", lambda *given: scan(
        *given)._replace(lasts_us=monitor.SCAN_US))
    flagged = run.findings_in(tmp_path).violations
    assert any("gsc.uplink, shown as fresh" in what for what in flagged)


@pytest.fixture
def found(monkeypatch):
    """The monitor finds this in every flight."""

    def set_to(violations=(), wrong=()):
        monkeypatch.setattr(monitor, "check", lambda *_: monitor.Findings(
            list(violations), list(wrong), 100))

    return set_to


def test_what_the_monitor_finds_fails_the_mix(found, tmp_path, capsys):
    found(["20 ms: pwm: unasked"], ["40 ms: wrong block passed"])
    result = run.run_shard("mix/3/5")
    assert result["failures"] == ["mix 3: 20 ms: pwm: unasked",
                                  "mix 4: 20 ms: pwm: unasked"]
    assert result["wrong"] == 2
    assert run.show_mix(3, tmp_path) == 1
    assert "20 ms: pwm: unasked\n40 ms: wrong block" in capsys.readouterr().out


def test_sec1_a_wrong_block_fails_a_sealed_mix(found, tmp_path):
    found(wrong=["40 ms: wrong block passed"])
    assert run.run_shard("mix/3/4")["failures"] == []
    assert run.run_shard("mix/3/4", 2)["failures"] == [
        "mix 3: sealed, and yet: 40 ms: wrong block passed"]
    assert run.show_mix(3, tmp_path, 2) == 1


def test_all_mixes_of_a_sealed_campaign_are_sealed():
    for number in range(100):
        mix, sealed = (mixes.of_number(number, each) for each in (1, 2))
        assert " ".join(sealed.options).count("--format 2") == 1
        assert sealed.files["key"] == mixes.KEY
        # Else they are as in format 1.
        assert [option for option in sealed.options if option not in (
            "--format", "2")] == [option for option in mix.options
                                  if option not in ("--format", "2")]
        assert sealed.files | mix.files == sealed.files


def test_what_the_monitor_finds_fails_a_case_of_the_campaign(found):
    found(["20 ms: pwm: unasked"])
    name = "calm/3/10"
    assert run.run_shard(name)["failures"] == [f"{name}: 20 ms: pwm: unasked"]


def test_a_mix_that_cannot_fly_fails(monkeypatch):
    monkeypatch.setattr(run, "PROGRAM", "false")
    assert run.run_shard("mix/3/4")["failures"] == ["mix 3: status 1: "]

# SPDX-License-Identifier: Apache-2.0
"""EVI-10, LNK-9: whatever may be wrong with a flight of the campaign makes it fail,
each thing alone. The flights here are written by hand, and perfect but for
one thing."""

import json
import subprocess
import sys

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "scripts" / "campaign"))

import cases  # noqa: E402
import checker  # noqa: E402
import run  # noqa: E402

from urv import cargo, workers  # noqa: E402

FRAMES = 60
LAG = {"up": 3, "down": 4}


class ByHand(checker.Flight):
    """A flight without faults: a block each way in every frame."""

    def __init__(self, frames=FRAMES):
        self.newest = {way: [frame - lag for frame in range(frames)]
                       for way, lag in LAG.items()}
        self.stale = {way: set() for way in LAG}
        self.lags = dict(LAG)
        self.link = [tuple(each * (frame + 1) for each in checker.CALM_FRAME)
                     for frame in range(frames)]
        self.times = {way: [] for way in LAG}
        self.messages = {"up": {0x1E: frames, 0xD2: frames, 0xCC: 0},
                         "down": {0x87: frames, 0x2D: frames, 0xD2: 0,
                                  0x33: 0, 0xCC: 0}}
        self.wrong, self.errors, self.wire_errors = [], [], []

    def counts(self, frame, **more):
        """From this frame on, so many more are counted."""
        for place in range(frame, len(self.link)):
            self.link[place] = tuple(
                count + more.get(name, 0) for name, count in zip(
                    checker.LINK_NAMES, self.link[place], strict=True))

    def disturb(self, *frames, way="up"):
        for frame in frames:
            self.newest[way][frame] -= 1

    def checked(self):
        self._check_counts()
        return self.errors + self.wire_errors


def test_a_perfect_flight_is_well():
    flight = ByHand()
    assert flight.checked() == []
    assert all(flight.is_calm(frame) for frame in range(1, FRAMES))


# --- counts ----------------------------------------------------------------

@pytest.mark.parametrize("bad, first, place", [
    ("uplink_bad", "down", 0x33), ("uplink_bad", "down", 0xCC),
    ("downlink_bad", "up", 0xCC)])
def test_what_was_answered_bad_and_not_counted_is_told(bad, first, place):
    flight = ByHand()
    flight.messages[first][place] = 2
    flight.counts(20, **{bad: 2})
    assert flight.checked() == []
    flight.messages[first][place] = 3
    assert flight.checked() == [f"{bad} is 2, on the wire are 3"]


@pytest.mark.parametrize("way", ["uplink", "downlink"])
def test_more_scrapped_than_were_sent_twice_is_told(way):
    flight = ByHand()
    flight.counts(20, **{f"{way}_scrapped": FRAMES // 2})
    assert flight.checked() == []
    flight.counts(20, **{f"{way}_scrapped": 1})
    assert flight.checked() == [f"{way}: more scrapped than sent twice"]


@pytest.mark.parametrize("name", checker.LINK_NAMES)
def test_a_count_that_goes_back_is_told(name):
    flight = ByHand()
    flight.counts(0, uplink_sent=2, downlink_sent=2)
    for each in checker.LINK_NAMES:
        if each not in ("uplink_sent", "downlink_sent"):
            flight.counts(0, **{each: 1})
    flight.counts(20, **{name: -2})
    assert "frame 20: a count went back" in flight.checked()


@pytest.mark.parametrize("way", ["uplink", "downlink"])
def test_more_received_than_sent_is_told(way):
    flight = ByHand()
    flight.counts(FRAMES - 1, **{f"{way}_received": 1})
    assert f"frame {FRAMES - 1}: received, never sent" in flight.checked()


@pytest.mark.parametrize("change", [-1, 1])
@pytest.mark.parametrize("name", checker.LINK_NAMES)
def test_a_frame_with_another_count_is_not_calm(name, change):
    flight = ByHand()
    flight.counts(20, **{name: change})
    assert [frame for frame in range(1, FRAMES)
            if not flight.is_calm(frame)] == [20]


@pytest.mark.parametrize("change", [-1, 1])
@pytest.mark.parametrize("way", LAG)
def test_a_frame_with_older_or_newer_words_is_not_calm(way, change):
    flight = ByHand()
    flight.newest[way][20] += change
    assert [frame for frame in range(1, FRAMES)
            if not flight.is_calm(frame)] == [20]


@pytest.mark.parametrize("way", LAG)
def test_a_frame_whose_words_say_that_they_are_old_is_not_calm(way):
    flight = ByHand()
    flight.stale[way].update((20, 40))
    # Those of frame 40 came the frame before, and are as old as ever.
    flight.newest[way][39] += 1
    assert [frame for frame in range(1, FRAMES)
            if not flight.is_calm(frame)] == [20, 39]


# --- recovery ----------------------------------------------------------------

@pytest.mark.parametrize("disturbed, took", [
    ([], 0), ([40], 1), ([39], 0), ([40, 41, 42], 3), ([42], 3), ([40, 45], 6),
    ([49], None), ([40, 49], None), (range(40, 50), None), ([50], 0)])
def test_recovery_lasts_until_all_is_calm_and_stays_so(disturbed, took):
    flight = ByHand()
    flight.disturb(*disturbed)
    case = cases.case([cases.lasting(0, "", "cut {ms}", 100),
                       cases.lasting(0, "", "cut {ms}", 200)], 200)
    assert flight.recovery(case, 40, 50) == took


def test_recovery_is_counted_from_the_fault_that_ends_last():
    flight = ByHand()
    flight.disturb(*range(40, 44))
    faults = [cases.lasting(0, "", "cut {ms}", 50_000),
              cases.lasting(1_000, "", "cut {ms}", 0)]
    for order in (faults, faults[::-1]):
        assert flight.recovery(cases.case(order, 50_000), 40, 52) == 2


@pytest.mark.parametrize("harm, characters", [
    ("drop {n}", 1), ("flip {n} 1", 1), ("dup {n}", 2)])
def test_a_fault_of_a_character_ends_with_it(harm, characters):
    flight = ByHand()
    flight.times["up"] = [1_000, 1_096, 5_000, 9_000]
    fault = cases.of_character(1_090, "up", harm, 2)
    assert flight.end_of(fault, 0) == 5_000 + 96 * characters
    assert flight.end_of(fault, -90) == 1_096 + 96 * characters


def test_the_bounds_are_those_of_the_page():
    page = (ROOT / "docs" / "evidence" / "link.md").read_text("utf-8")
    assert checker.LINK_BOUND == 3
    assert checker.BOUNDS == {"calm": 0, "start": 5}
    assert "within 3 major frames (5 for start)" in page


# --- the record ----------------------------------------------------------------

def record_of(frames, change=lambda row: None):
    rows = []
    for frame in range(frames):
        row = [0] * 123
        for way, column, count in (("up", checker.MCS_UPLINK, 13),
                                   ("down", checker.GSC_DOWNLINK, 27)):
            number = frame - LAG[way]
            if number >= 0:
                row[column] = [*checker.data.words(number, count), 0]
        row[checker.LINK] = [each * (frame + 1)
                             for each in checker.CALM_FRAME]
        row[0] = frame
        change(row)
        rows.append(",".join(map(str, row)))
    return "\n".join(["header", *rows]) + "\n"


def read(tmp_path, text, frames=FRAMES):
    flight = ByHand()
    flight.newest = {way: [] for way in LAG}
    flight.link = []
    (tmp_path / "record.csv").write_text(text, encoding="ascii")
    flight._read_record(tmp_path / "record.csv", frames)
    return flight


def test_a_record_is_read(tmp_path):
    flight = read(tmp_path, record_of(FRAMES))
    assert flight.wrong == flight.errors == []
    assert flight.newest["up"] == [max(-1, n - 3) for n in range(FRAMES)]
    assert flight.newest["down"] == [max(-1, n - 4) for n in range(FRAMES)]


@pytest.mark.parametrize("mark, is_known", [(0, True), (1, True), (2, False),
                                            (3, False)])
def test_old_words_may_say_so_and_no_other_mark_is_known(
        tmp_path, mark, is_known):
    def change(row):
        if row[0] == 30:
            row[checker.MCS_UPLINK.stop - 1] = mark

    flight = read(tmp_path, record_of(FRAMES, change))
    assert [each.frame for each in flight.wrong] == ([] if is_known else [30])
    assert flight.newest["up"][30] == (27 if is_known else checker.NEVER_SENT)
    assert flight.stale == {"up": {30} if mark == 1 else set(), "down": set()}
    assert flight.is_calm(30) == (mark == 0)


@pytest.mark.parametrize("frames", [FRAMES - 1, FRAMES + 1])
def test_a_record_of_another_length_is_told(tmp_path, frames):
    flight = read(tmp_path, record_of(frames))
    assert flight.errors == [f"{frames} frames, not {FRAMES}"]


@pytest.mark.parametrize("way, column", [
    ("up", checker.MCS_UPLINK), ("down", checker.GSC_DOWNLINK)])
@pytest.mark.parametrize("frame", [7, 30])
def test_words_never_sent_are_told_once_data_has_come(
        tmp_path, frame, way, column):
    def change(row):
        if row[0] in (frame, frame + 1):
            row[column.start] += 1

    flight = read(tmp_path, record_of(FRAMES, change))
    assert [(each.frame, each.way) for each in flight.wrong] == [
        (frame, way), (frame + 1, way)]
    assert flight.newest[way][frame] == checker.NEVER_SENT


# --- a shard -------------------------------------------------------------------

GROUPS = {
    "single/3/0/37/37": (True, 3), "many/3/0/1": (True, 3),
    "cut/3/0/1000": (True, 3), "stall/3/gsc/1/20000": (True, 3),
    "reset/3/gsc/20000": (False, 3), "start/3/gsc/warm/20000": (False, 5),
    "soak/3/0/1e-3/100": (True, 3), "calm/3/200": (True, 0),
}


@pytest.fixture
def shard(monkeypatch):
    """The result of a shard of one case, in a flight that is calm but for
    what is changed."""

    def fly(name, change=lambda flight, first: None):
        def flight(record, wire, frames):
            one = ByHand(frames)
            change(one, cases.LEAD)
            for way in LAG:
                # Characters so late that any fault ends in frame 40.
                one.times[way] = [20_000 * cases.LEAD + 12_000] * 1_000
            return one

        monkeypatch.setattr(run, "fly", lambda *_:
                            subprocess.CompletedProcess([], 0, "", ""))
        monkeypatch.setattr(run.checker, "Flight", flight)
        monkeypatch.setattr(run, "findings_in", lambda _:
                            run.monitor.Findings([], [], 0))
        return run.run_shard(name)

    return fly


@pytest.mark.parametrize("name", GROUPS)
def test_a_calm_shard_is_well(shard, name):
    result = shard(name)
    assert result["failures"] == []
    assert result["recovered_within"][0] == result["cases"] == 1


@pytest.mark.parametrize("name", GROUPS)
def test_an_error_fails_in_every_shard(shard, name):
    result = shard(name, lambda flight, _: flight.errors.append("odd"))
    assert result["failures"] == [f"{name}: odd"]


@pytest.mark.parametrize("name", GROUPS)
def test_an_error_on_the_wire_fails_but_where_messages_break_off(shard, name):
    result = shard(name, lambda flight, _:
                      flight.wire_errors.append("odd"))
    assert result["failures"] == ([f"{name}: odd"] if GROUPS[name][0] else [])


@pytest.mark.parametrize("frame", [cases.LEAD // 2, cases.LEAD - 2])
@pytest.mark.parametrize("name", GROUPS)
def test_a_shard_that_is_not_calm_before_its_first_case_fails(
        shard, name, frame):
    result = shard(name, lambda flight, _: flight.disturb(frame))
    assert result["failures"] == [f"{name}: not calm before the first case"]


@pytest.mark.parametrize("more", [0, 1])
@pytest.mark.parametrize("name", GROUPS)
def test_a_recovery_that_is_longer_than_its_bound_fails(shard, name, more):
    bound = GROUPS[name][1]
    ends = {"cut": None, "soak": 93}.get(name.split("/")[0], 0)
    if ends is None:
        case = cases.of_shard(name)[2][0].faults[0]
        ends = (case.at_us + case.duration_us) // cases.FRAME_US
    last = ends + bound + more - 1
    result = shard(name, lambda flight, first:
                      flight.disturb(first + last)
                      if last >= ends else None)
    assert len(result["failures"]) == more
    if more:
        assert f"recovered after {bound + 1} frames" in result["failures"][0]
    else:
        assert result["recovered_within"][bound] == 1


@pytest.mark.parametrize("name", GROUPS)
def test_a_case_that_never_recovers_fails(shard, name):
    result = shard(name, lambda flight, first:
                      flight.disturb(len(flight.link) - 1))
    assert len(result["failures"]) == 1
    assert "recovered after None frames" in result["failures"][0]


@pytest.mark.parametrize("name", GROUPS)
def test_wrong_words_fail_where_one_fault_cannot_make_them(shard, name):
    result = shard(name, lambda flight, first: flight.wrong.append(
        checker.Wrong(first + 1, "up", (1,) * checker.UPLINK)))
    # Of several faults chance may make them: they are counted.
    several = name.startswith(("many", "soak"))
    assert len(result["failures"]) == (not several)
    assert result["wrong"] == 1


# --- the sum ---------------------------------------------------------------------

@pytest.mark.parametrize("count, expected, is_too_many", [
    (3, 0, False), (4, 0, True), (7, 1, False), (9, 1, False), (10, 1, True),
    (153, 100, False), (154, 100, True)])
def test_too_many_is_what_chance_does_once_in_a_million(
        count, expected, is_too_many):
    assert run.too_many(count, expected) == is_too_many


def test_theory_of_pairs_and_triples_is_one_in_256():
    assert run.by_theory("many/3/0/512", ByHand()) == 2
    for name in GROUPS:
        if not name.startswith(("many", "soak")):
            assert run.by_theory(name, ByHand()) == 0


def test_theory_of_bit_errors_is_small_and_grows_with_the_flight():
    few, many = (run.by_theory("soak/3/0/1e-3/100", ByHand(frames))
                 for frames in (1_000, 2_000))
    assert many == pytest.approx(2 * few)
    # Two or more of 30 or 58 characters, each with two wrong bits: about
    # (30 * 29 + 58 * 57) / 2 times (36 / 10**6) ** 2, every 256th unseen.
    assert few / 1_000 == pytest.approx(2_088 * 3.6e-5 ** 2 / 256, rel=0.5)


@pytest.mark.parametrize("size", ["tiny", "short"])
@pytest.mark.parametrize("lost", [0, 1])
def test_a_shard_without_a_result_fails(
        monkeypatch, tmp_path, capsys, size, lost):
    names = list(cases.plan(size))

    def done(sent, jobs, scheduler, count):
        assert (scheduler, count) == ("tcp://somewhere:1", 2)
        jobs = list(jobs)
        assert [job["name"] for job in jobs] == names
        # In any order.
        for place, job in reversed(list(enumerate(jobs))):
            yield job, ({"fault": "KilledWorker"} if place < lost else {
                "said": {
                    "shard": job["name"], "cases": 1, "faults": 1,
                    "frames": 1, "wrong": 0, "wrong_by_theory": 0.0,
                    "recovered_within": [1] + [0] * checker.LONGEST,
                    "failures": []}})

    monkeypatch.setattr(run, "RESULTS", tmp_path)
    monkeypatch.setattr(workers, "done", done)
    assert run.run_campaign(size, 2, "tcp://somewhere:1") == lost
    said = capsys.readouterr().out
    assert (f"FAILED {names[0]}: no result: KilledWorker" in said) == (
        lost == 1)
    shards = [json.loads(line)["shard"] for line in (
        tmp_path / "shards.jsonl").read_text("utf-8").splitlines()]
    assert shards == names


def test_workers_fly_shards_as_they_are_flown_here(tmp_path):
    """From the cargo alone, unpacked elsewhere."""
    there = cargo.Cargo(cargo.packed(run.ROOT, run.CARGO), cargo.run_python)
    there.unpack(tmp_path)
    name = next(name for name in cases.plan("tiny")
                if not name.startswith("mix"))
    answer = there.do({"name": name, "command": [
        "scripts/campaign/run.py", "shard", name]})
    assert answer == {"cargo": there.hash, "said": run.run_shard(name)}
    wrong = there.do({"name": "x", "command": [
        "scripts/campaign/run.py", "shard", "x"]})
    assert "said" not in wrong
    assert wrong["fault"]

# SPDX-License-Identifier: Apache-2.0
"""LNK-9, SEC-1: whatever may be wrong with a flight of the campaign
makes it fail, each thing alone. The flights here are written by hand, and
perfect but for one thing."""

import subprocess
import sys
from collections import Counter

import pytest
from conftest import ROOT

sys.path.insert(0, str(ROOT / "evidence" / "campaign"))

import cases  # noqa: E402
import checker  # noqa: E402
import run  # noqa: E402
import sealed_blocks  # noqa: E402

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
        self.came_twice = 0

    def counts(self, frame, **more):
        """From this frame on, this many more are counted."""
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
def test_what_was_answered_bad_and_not_counted_is_reported(bad, first, place):
    flight = ByHand()
    flight.messages[first][place] = 2
    flight.counts(20, **{bad: 2})
    assert flight.checked() == []
    flight.messages[first][place] = 3
    assert flight.checked() == [f"{bad} is 2, on the wire are 3"]


@pytest.mark.parametrize("way", ["uplink", "downlink"])
def test_more_scrapped_than_were_sent_twice_is_reported(way):
    flight = ByHand()
    flight.counts(20, **{f"{way}_scrapped": FRAMES // 2})
    assert flight.checked() == []
    flight.counts(20, **{f"{way}_scrapped": 1})
    assert flight.checked() == [f"{way}: more scrapped than sent twice"]


@pytest.mark.parametrize("name", checker.LINK_NAMES)
def test_a_count_that_goes_back_is_reported(name):
    flight = ByHand()
    flight.counts(0, uplink_sent=2, downlink_sent=2)
    for each in checker.LINK_NAMES:
        if each not in ("uplink_sent", "downlink_sent"):
            flight.counts(0, **{each: 1})
    flight.counts(20, **{name: -2})
    assert "frame 20: a count went back" in flight.checked()


@pytest.mark.parametrize("way", ["uplink", "downlink"])
def test_more_received_than_sent_is_reported(way):
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
    # The words of frame 40 came the frame before, and are as old as usual.
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
    assert "3 major frames (5 for start)" in page


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
def test_a_record_of_another_length_is_reported(tmp_path, frames):
    flight = read(tmp_path, record_of(frames))
    assert flight.errors == [f"{frames} frames, not {FRAMES}"]


@pytest.mark.parametrize("way, column", [
    ("up", checker.MCS_UPLINK), ("down", checker.GSC_DOWNLINK)])
@pytest.mark.parametrize("frame", [7, 30])
def test_words_never_sent_are_reported_once_data_has_come(
        tmp_path, frame, way, column):
    def change(row):
        if row[0] in (frame, frame + 1):
            row[column.start] += 1

    flight = read(tmp_path, record_of(FRAMES, change))
    assert [(each.frame, each.way) for each in flight.wrong] == [
        (frame, way), (frame + 1, way)]
    assert flight.newest[way][frame] == checker.NEVER_SENT


@pytest.mark.parametrize("marks, told", [
    ((0, 1, 1), [30]), ((2, 3), [30]), ((1, 1), [30]), ((0, 0), [30]),
    ((1, 0), [30, 31]), ((0, 2), [30, 31]), ((0, 3), [30, 31])])
def test_wrong_words_are_reported_again_unless_they_are_kept(
        tmp_path, marks, told):
    def change(row):
        if 30 <= row[0] < 30 + len(marks):
            row[checker.MCS_UPLINK] = [7] * 13 + [marks[row[0] - 30]]

    flight = read(tmp_path, record_of(FRAMES, change))
    assert [each.frame for each in flight.wrong] == told


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

    def fly(name, change=lambda flight, first: None, message_format=1,
            refused=0):
        def flight(record, wire, frames, *_):
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
        monkeypatch.setattr(run, "refused_in", lambda _: refused)
        return run.run_shard(name, message_format)

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
    # Several faults may make them by chance: they are counted.
    several = name.startswith(("many", "soak"))
    assert len(result["failures"]) == (not several)
    assert result["wrong"] == 1


@pytest.mark.parametrize("name", GROUPS)
def test_sec1_wrong_words_fail_in_every_sealed_shard(shard, name):
    result = shard(name, lambda flight, first: flight.wrong.append(
        checker.Wrong(first + 1, "up", (1,) * checker.UPLINK)), 2)
    assert len(result["failures"]) == result["wrong"] == 1
    assert "wrong data" in result["failures"][0]


@pytest.mark.parametrize("message_format", [1, 2])
@pytest.mark.parametrize("refused, twice", [(0, 0), (2, 2), (3, 2), (1, 2)])
@pytest.mark.parametrize("name", GROUPS)
def test_what_is_refused_came_twice_or_was_altered_by_several_faults(
        shard, name, refused, twice, message_format):
    def change(flight, _):
        flight.came_twice = twice

    result = shard(name, change, message_format, refused)
    if not GROUPS[name][0]:
        # In groups whose messages break off, repeated ones are unknown.
        twice = 0
    several = name.startswith(("many", "soak"))
    assert result["came_twice"] == twice
    assert result["refused"] == refused - twice
    assert result["failures"] == (
        [] if refused == twice or several and refused > twice else
        [f"{name}: {refused} blocks refused, {twice} came twice"])


# --- sealed blocks on the wire -----------------------------------------------

HELLO = bytes([0xB0]) + bytes(55)


def sealed_block(way, number, other=0):
    block = bytearray([0xA0, other] + [0] * (26 if way == "up" else 54))
    if way == "up":
        block[20:22] = (0x3000 + number % 64 * 64).to_bytes(2, "big")
    else:
        block[43:48] = number.to_bytes(5, "big")
    return bytes(block)


WIRES = {
    "hellos, then blocks": (("hello", "hello", 1, 2, 2, 3), None),
    "one that was never sent": ((1, 3), None),
    "a hello within a session": ((1, "hello"), "begins with b0 after"),
    "a plain one at first": (("hello", "plain"), "begins with 00 before"),
    "a plain one": ((1, 2, "plain"), "begins with 00 after"),
    "an older one": ((1, 3, 2), "block 2 after 3"),
    "another with that number": ((1, 2, "other 2"), "block 2 after 2"),
    "one without a number": ((0,), "block 0 after none"),
}


@pytest.mark.parametrize("way", LAG)
@pytest.mark.parametrize("name", WIRES)
def test_sec3_sealed_blocks_are_in_order(way, name):
    numbers, wrong = WIRES[name]
    said = {"hello": HELLO, "plain": bytes(56),
            "other 2": sealed_block(way, 2, 1)}
    blocks = [said.get(each) or sealed_block(way, each) for each in numbers]
    found = list(sealed_blocks.wrongs(blocks, way))
    assert len(found) == (wrong is not None)
    assert wrong is None or wrong in found[0]


def test_sec4_an_uplink_has_6_bits_of_its_number():
    blocks = [sealed_block("up", number) for number in range(1, 150, 25)]
    assert list(sealed_blocks.wrongs(blocks, "up")) == []
    assert list(sealed_blocks.wrongs(blocks[::-1], "up")) != []


def test_sec4_a_downlink_has_24_bits_of_its_number():
    blocks = [sealed_block("down", number)
              for number in (2**23 - 1, 2**24 - 2, 1)]
    assert list(sealed_blocks.wrongs(blocks, "down")) == []


@pytest.mark.parametrize("way, first, marked", [
    ("up", 0, 0), ("up", 0x0F, 0), ("up", 0x10, 1), ("up", 0x50, 1),
    ("up", 0xA0, 1), ("down", 0x0F, 0), ("down", 0x50, 0),
    ("down", 0x5F, 0), ("down", 0x60, 1), ("down", 0xB0, 1)])
def test_blocks_of_format_1_have_no_mark_of_format_2(way, first, marked):
    found = list(sealed_blocks.marked(
        [bytes(28), bytes([first] + [0] * 27)], way))
    assert len(found) == marked


@pytest.mark.parametrize("way", LAG)
@pytest.mark.parametrize("phase, times, twice", [
    (0, (5_000,), 0),
    # The newest of a frame is taken: the same one again takes its place.
    (0, (5_000, 12_000), 0), (0, (5_000, 21_000), 1),
    (0, (5_000, 21_000, 41_000), 2),
    (0, (19_999, 20_000), 0), (0, (20_000, 20_001), 1),
    # The aircraft's frames begin 2 ms a tick later, the ground's do not.
    (7, (5_000, 12_000), {"up": 0, "down": 0}),
    (7, (5_000, 15_000), {"up": 1, "down": 0}),
    (7, (15_000, 21_000), {"up": 0, "down": 1})])
def test_what_came_twice_is_counted_by_the_receivers_frames(
        way, phase, times, twice):
    receiver, good = sealed_blocks.ANSWERED_BY[way]
    message = bytes([0x1E]) + sealed_block(way, 1) + b"\0"
    for answer in good:
        said = {way: [(time - 3_000, message) for time in times],
                receiver: [(time, bytes([answer])) for time in times]}
        assert sealed_blocks.came_twice(said, phase) == (
            twice[way] if isinstance(twice, dict) else twice)
    said[way] = [(at, bytes([0x1E]) + HELLO + b"\0") for at, _ in said[way]]
    assert sealed_blocks.came_twice(said, phase) == 0
    said[receiver] = [(time, b"\xcc") for time in times]
    assert sealed_blocks.came_twice(said, phase) == 0


# --- the sum ---------------------------------------------------------------------

@pytest.mark.parametrize("count, expected, is_too_many", [
    (3, 0, False), (4, 0, True), (7, 1, False), (9, 1, False), (10, 1, True),
    (153, 100, False), (154, 100, True)])
def test_too_many_is_what_chance_does_once_in_a_million(
        count, expected, is_too_many):
    assert run.too_many(count, expected) == is_too_many


def test_a_shard_without_a_result_fails(monkeypatch, tmp_path, capsys):
    names = list(cases.plan("tiny"))

    def run_shard(name, _message_format):
        if name == names[0]:
            raise ValueError("no such fault")
        return run.new_result(name) | {"faults": 1}

    monkeypatch.setattr(run, "RESULTS", tmp_path)
    monkeypatch.setattr(run, "run_shard", run_shard)
    assert run.run_campaign("tiny", 2) == 1
    said = capsys.readouterr().out
    assert f"FAILED {names[0]}: no result: ValueError('no such fault')" in said
    assert f"tiny: {len(names) - 1} faults, 1 failures" in said


@pytest.mark.parametrize("length, times", [(30, 2.22), (58, 2.29)])
def test_lnk5_two_characters_with_two_wrong_bits(length, times):
    """How many pass, counted over all of them, in times of 1 in 256. The
    ninth bit of a character is its parity."""
    patterns = [1 << one | 1 << other for one in range(9)
                for other in range(one)]
    sums = []
    for place in range(length):
        after = [pattern & 0xFF for pattern in patterns]
        for _ in range(length - 1 - place):
            for index, value in enumerate(after):
                for _ in range(8):
                    value = value >> 1 ^ (0x9C if value & 1 else 0)
                after[index] = value
        sums.append(Counter(after))
    passed = sum(count * sums[other][value]
                 for place, one in enumerate(sums)
                 for other in range(place)
                 for value, count in one.items())
    pairs = length * (length - 1) // 2 * len(patterns) ** 2
    assert len(patterns) == 36
    assert 256 * passed / pairs == pytest.approx(times, abs=0.005)

# SPDX-License-Identifier: Apache-2.0
"""FTI-10, FTI-11: rows of the flight recorder at the ground: blocks that are
damaged, files that are not whole, and the packets."""

import errno
import os
import random
import re
import tempfile
from types import SimpleNamespace

import pytest
from conftest import run_measured
from fake_node import blocks_of

from urv import (faults, flights, packets, recorder, recorder_blocks,
                 recorder_fetch, recordings, records)


def row_of(number, chance):
    words = [number >> 16, number & 0xFFFF,
             *(chance.randrange(65536) for _ in range(68))]
    return (*words, *recordings.sums(words))


@pytest.fixture
def rows():
    chance = random.Random(1)
    return [row_of(number, chance) for number in
            (0, 1, 4_095, 4_096, 70_000, 2 ** 22 - 1)]


def test_fti10_rows_come_from_their_blocks_in_any_order(rows):
    blocks = [block for row in rows for block in blocks_of(row)]
    random.Random(2).shuffle(blocks)
    found = recorder_blocks.Rows()
    for block in blocks:
        found.take(recorder_blocks.ROWS, block)
    assert found.in_order() == rows


def test_fti10_a_wrong_block_is_not_taken(rows):
    """One wrong word in any place, with any wrong bit."""
    row = rows[4]
    for block in blocks_of(row):
        for place in range(27):
            for bit in range(12):
                wrong = list(block)
                wrong[place] ^= 1 << bit
                found = recorder_blocks.Rows()
                found.take(recorder_blocks.ROWS, wrong)
                assert not found.parts and not found.rows


def test_fti10_a_wrong_row_is_not_taken_and_asked_again(rows):
    """Blocks that agree, of a row with a wrong word."""
    words = list(rows[4])
    words[20] ^= 1
    found = recorder_blocks.Rows()
    for block in blocks_of(words):
        found.take(recorder_blocks.ROWS, block)
    assert found.wrong == {70_000: 1}
    assert found.missing(70_000, 70_001) == [70_000]
    for block in blocks_of(rows[4]):
        found.take(recorder_blocks.ROWS, block)
    assert found.in_order() == [rows[4]]


class Aircraft:
    """Answers requests as the aircraft does, over a line that loses blocks."""

    def __init__(self, rows, lost=0.0):
        self.rows = {recordings.number_of(row): row for row in rows}
        self.lost = lost
        self.chance = random.Random(3)
        self.waiting = []

    def ask(self, first, many):
        report = [0] * 27
        oldest = min(self.rows)
        for at, value in ((1, oldest), (3, len(self.rows)), (5, 99)):
            report[at:at + 2] = value >> 12, value & 0xFFF
        report[26] = sum((2 * place + 1) * word for place, word
                         in enumerate(report[:26])) % 4096
        self.waiting = [(recorder_blocks.REPORT, report)]
        for number in range(max(first, oldest), max(first, oldest) + many):
            if number in self.rows:
                self.waiting += [(recorder_blocks.ROWS, block)
                                 for block in blocks_of(self.rows[number])]

    def block(self):
        while self.waiting:
            block = self.waiting.pop(0)
            if self.chance.random() >= self.lost:
                return block
        return None


@pytest.mark.parametrize("lost", [0.0, 0.3, 0.7])
def test_fti10_lost_blocks_are_asked_for_again(lost):
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(4_000, 4_300)]
    fetch = recorder_fetch.Fetch(Aircraft(aboard, lost))
    fetch.run()
    assert (fetch.first, fetch.end, fetch.reason) == (4_000, 4_300, "")
    assert fetch.rows.in_order() == aboard


def test_fti10_only_the_newest_seconds():
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(300)]
    fetch = recorder_fetch.Fetch(Aircraft(aboard), 1.0)
    fetch.run()
    assert fetch.rows.in_order() == aboard[-50:]


class Interrupted(Aircraft):
    """Falls silent after a number of blocks."""

    def __init__(self, rows, blocks):
        super().__init__(rows)
        self.left = blocks

    def block(self):
        self.left -= 1
        return super().block() if self.left >= 0 else None


def test_fti10_a_fetch_goes_on_where_an_earlier_one_ended():
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(300)]
    part = recorder_fetch.Fetch(Interrupted(aboard, 500))
    part.run()
    assert part.reason == "the aircraft does not answer any more"
    kept = len(part.rows.rows)
    assert 100 <= kept < 130
    rest = Interrupted(aboard, 10_000)
    again = recorder_fetch.Fetch(rest, rows=part.rows)
    again.run()
    assert again.rows.in_order() == aboard
    # The newest row came twice, and four reports with the others.
    assert not again.is_another
    assert 10_000 - rest.left <= 4 * (301 - kept) + 4


def test_fti10_rows_of_another_recording_are_forgotten():
    chance = random.Random(4)
    before, after = ([row_of(number, chance) for number in range(300)]
                     for _ in range(2))
    fetch = recorder_fetch.Fetch(Aircraft(before))
    fetch.run()
    fetch = recorder_fetch.Fetch(Aircraft(after), rows=fetch.rows)
    fetch.run()
    assert fetch.is_another
    assert fetch.rows.in_order() == after
    longer = after + [row_of(300, chance)]
    fetch = recorder_fetch.Fetch(Aircraft(longer), rows=fetch.rows)
    fetch.run()
    assert fetch.rows.in_order() == longer


def test_fti10_a_row_that_is_wrong_aboard_is_named():
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(30)]
    wrong = list(aboard[7])
    wrong[9] ^= 4
    aboard[7] = tuple(wrong)
    fetch = recorder_fetch.Fetch(Aircraft(aboard))
    fetch.run()
    assert fetch.missing() == [7]
    assert fetch.reason == "their sums are wrong aboard"
    assert recorder_fetch.named([7, 9, 10]) == "7, 9 to 10"


def test_fti10_the_request_is_that_of_the_page():
    words = recorder_blocks.request(70_000, 200)
    assert words == (17, 368, 200, 4078, 3727, 3895,
                     (17 + 3 * 368 + 5 * 200) % 4096, 0, 0, 0, 0, 0)
    packet = packets.RequestPacket(5, 6, 7, words)
    data = packet.encode()
    assert (len(data), data[24:26]) == (50, b"\x07\x00")
    assert packets.RequestPacket.decode(data) == packet
    with pytest.raises(packets.PacketError):
        packets.CardPacket.decode(data)


def test_fti10_a_recorder_packet_is_checked():
    data = bytes.fromhex("55525652 0001 0040 0700") + bytes(range(54))
    kind, words = packets.decode_recorder(data)
    assert (kind, len(words), words[1]) == (0x700, 27, 0x0203)
    for wrong in (data[:-1], data + b"\0", b"X" + data[1:],
                  data[:5] + b"\2" + data[6:], data[:8] + b"\6" + data[9:]):
        with pytest.raises(packets.PacketError):
            packets.decode_recorder(wrong)


def test_fti11_a_recording_that_was_cut_short(tmp_path, rows):
    path = tmp_path / "a.recording"
    recordings.write(path, rows)
    text = path.read_text("ascii")
    for kept in range(1, 290):
        path.write_text(text[:-kept], "ascii")
        read = recordings.Recording(path)
        assert read.rows == rows[:-1]
        assert (read.cut_short is None) == (kept == 289)
    path.write_text(text[:-5], "ascii")
    with pytest.raises(faults.Refused, match="is not whole"):
        with records.opened(path):
            pass
    with records.opened(path, forgiving=True) as record:
        assert "is not whole" in record.cut_short


def test_fti11_rows_after_a_cold_start_are_those_of_the_file(tmp_path, rows):
    path = tmp_path / "a.recording"
    recordings.write(path, rows)
    path.write_text(path.read_text("ascii") + "urv recording 2\n"
                    + recordings.line_of(rows[1]), "ascii")
    assert recordings.Recording(path).rows == [rows[1]]


def test_fti11_a_recording_of_version_1_is_refused(tmp_path, rows):
    path = tmp_path / "a.recording"
    recordings.write(path, rows)
    path.write_text(path.read_text("ascii").replace("recording 2",
                                                    "recording 1"), "ascii")
    with pytest.raises(faults.Refused, match="a recording of version 1"):
        recordings.Recording(path)


def long_recording(path, rows):
    """Rows with right sums, all words of the sensors alike."""
    with path.open("w", encoding="ascii") as file:
        file.write(recordings.TITLE + "\n")
        for number in range(rows):
            tick = 10 * number
            words = (number >> 16, number & 0xFFFF, tick >> 16, tick & 0xFFFF,
                     *(2_048,) * 66)
            file.write(recordings.line_of((*words, *recordings.sums(words))))


def test_gnd13_a_recording_of_an_hour_needs_little_memory(tmp_path):
    """As a list of tuples its rows took 430 MB, and 8 hours more than there
    is."""
    rows = 180_000
    long_recording(tmp_path / "a.recording", rows)
    status, said, most = run_measured(
        tmp_path, "convert", "a.recording", "a.parquet")
    assert (status, said) == (0, "")
    assert most < 200
    with records.opened(tmp_path / "a.parquet") as record:
        frames = record.names.index("frame")
        times = record.names.index("time_ms")
        table = [row for block in record.blocks()
                 for row in block[:, [frames, times]].tolist()]
    assert table == [[number, 20 * number + 20] for number in range(rows)]


def test_fti11_another_file_is_no_recording(tmp_path):
    path = tmp_path / "a.recording"
    path.write_text("frame,time_ms\n0,20\n", "ascii")
    with pytest.raises(faults.Refused, match="not a recording"):
        flights.read(path, lambda record: None)


def test_fti11_bytes_that_are_no_text_are_a_wrong_line(tmp_path, rows):
    path = tmp_path / "a.recording"
    recordings.write(path, rows)
    data = bytearray(path.read_bytes())
    # In the second row.
    data[16 + 289 + 40] = 0xFF
    path.write_bytes(data)
    read = recordings.Recording(path)
    assert [*map(tuple, read.rows)] == [rows[0], *rows[2:]]
    assert read.cut_short == "1 lines are no rows, the first is line 3"
    path.write_bytes(b"\xff\xfe" + data)
    with pytest.raises(faults.Refused, match="not a recording"):
        recordings.Recording(path)


def test_fti10_blocks_that_are_no_text_are_refused_in_one_line(urv, tmp_path):
    (tmp_path / "blocks.txt").write_bytes(b"0700\xff\xfe\n")
    result = urv("recorder", "read", "blocks.txt", "a.recording")
    assert (result.returncode, result.stderr) == (
        2, 'urv: "blocks.txt": not a file of --fetched\n')
    assert not (tmp_path / "a.recording").exists()


class Ended(Aircraft):
    """Raises a fault after 500 blocks, as a node that ends or a signal does."""

    def __init__(self, rows, fault):
        super().__init__(rows)
        self.left, self.fault = 500, fault

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def block(self):
        self.left -= 1
        if self.left < 0:
            raise self.fault
        return super().block()


@pytest.mark.parametrize("fault", [
    KeyboardInterrupt(), faults.Failed("nothing listens there"),
    OSError(101, "Network is unreachable")], ids=["signal", "node", "network"])
def test_fti10_a_fetch_that_ends_early_keeps_its_rows(
        tmp_path, monkeypatch, capsys, fault):
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(300)]
    monkeypatch.setattr(recorder_fetch, "Node",
                        lambda _console: Ended(aboard, fault))
    file = tmp_path / "a.recording"
    with pytest.raises((KeyboardInterrupt, faults.Failed)) as ended:
        recorder.fetch(file, "udp:127.0.0.1:6004", None)
    kept = [*map(tuple, recordings.Recording(file).rows)]
    assert kept == [*aboard[:len(kept) - 1], aboard[-1]]
    assert 100 <= len(kept) < 130
    said = capsys.readouterr()
    assert said.out == f"{len(kept)} of 300 rows fetched, 0 to 299\n"
    assert (f"{300 - len(kept)} rows are missing ({len(kept) - 1} to 298): "
            in said.err + str(ended.value))


class Whole(Ended):
    """Answers to the end, and then does something."""

    def __init__(self, rows, at_end=lambda: None):
        super().__init__(rows, None)
        self.left, self.at_end = 10_000, at_end

    def __exit__(self, *_):
        self.at_end()


def full(monkeypatch, folders):
    """Files in these folders find no room from now on."""
    write = recordings.write

    def fails(path, rows):
        if path.resolve().parent in folders:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        write(path, rows)
    monkeypatch.setattr(recordings, "write", fails)


@pytest.mark.parametrize("has_other", [True, False])
def test_fti10_a_disk_that_is_full_at_the_end_costs_no_rows_without_a_word(
        tmp_path, monkeypatch, has_other):
    """A fetch of all rows takes an hour."""
    chance = random.Random(4)
    aboard = [row_of(number, chance) for number in range(300)]
    own, other = tmp_path / "own", tmp_path / "other"
    own.mkdir()
    other.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(other))
    node = Whole(aboard, lambda: full(
        monkeypatch, [own] if has_other else [own, other]))
    monkeypatch.setattr(recorder_fetch, "Node", lambda _console: node)
    file = own / "a.recording"
    with pytest.raises(faults.Failed) as ended:
        recorder.fetch(file, "udp:127.0.0.1:6004", None)
    said = str(ended.value)
    assert said.startswith(
        f'"{file}" cannot be written: No space left on device; the 300 fetched'
        " rows are ")
    assert not any(own.iterdir())
    found = [*other.iterdir()]
    if has_other:
        assert said.endswith(f'rows are in "{found[0]}"')
        assert recordings.Recording(found[0]).rows == aboard
    else:
        assert "rows are lost, since " in said
        assert not found


def test_fti10_a_disk_without_room_for_the_rows_is_reported_before_them(
        tmp_path, monkeypatch):
    chance = random.Random(4)
    node = Whole([row_of(number, chance) for number in range(300)])
    monkeypatch.setattr(recorder_fetch, "Node", lambda _console: node)
    monkeypatch.setattr(os, "statvfs", lambda _folder: SimpleNamespace(
        f_bavail=21, f_frsize=4096))
    with pytest.raises(faults.Failed, match=re.escape(
            "its disk has room for 86,016 bytes, the recording has 86,716")):
        recorder.fetch(tmp_path / "a.recording", "udp:127.0.0.1:6004", None)
    # Only the recorder's state was asked for.
    assert node.left > 9_990
    recordings.write(tmp_path / "b.recording", node.rows.values())
    assert (tmp_path / "b.recording").stat().st_size == 86_716


def test_fti10_an_interruption_before_the_first_row_leaves_no_file(
        tmp_path, monkeypatch):
    chance = random.Random(4)
    node = Ended([row_of(0, chance)], KeyboardInterrupt())
    node.left = 0
    monkeypatch.setattr(recorder_fetch, "Node", lambda _console: node)
    with pytest.raises(KeyboardInterrupt):
        recorder.fetch(tmp_path / "a.recording", "udp:127.0.0.1:6004", None)
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("name", ["none/a.recording", "folder.recording"])
def test_fti10_a_file_that_cannot_be_written_is_refused_first(
        tmp_path, monkeypatch, name):
    (tmp_path / "folder.recording").mkdir()
    monkeypatch.setattr(recorder_fetch, "Node", lambda _console: pytest.fail(
        "the aircraft was asked"))
    with pytest.raises(faults.Failed, match="cannot be written"):
        recorder.fetch(tmp_path / name, "udp:127.0.0.1:6004", None)
    assert [each.name for each in tmp_path.iterdir()] == ["folder.recording"]

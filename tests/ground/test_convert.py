# SPDX-License-Identifier: Apache-2.0
"""GND-15, GND-13: records as MCAP and Parquet, and back."""

import csv
import itertools
import math
import os
import shutil
import signal
import subprocess
import time

import pyarrow.parquet
import pytest
from conftest import URV, fly, run_measured
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

from urv import items

KINDS = ("csv", "mcap", "parquet")


@pytest.fixture(scope="session")
def spoilt(tmp_path_factory):
    """A flight of JSBSim with gaps in its downlink."""
    folder = tmp_path_factory.mktemp("spoilt")
    (folder / "faults.txt").write_text("3000 cut 1000\n", encoding="utf-8")
    return fly(folder, "--seconds", "6", "--plant", "jsbsim", "--faults",
               "faults.txt")


@pytest.fixture
def convert(urv, tmp_path):
    """Converts, and gives the file."""
    def run(source, target):
        result = urv("convert", source, target)
        assert (result.returncode, result.stdout, result.stderr) == (
            0, "", "")
        return tmp_path / target
    return run


def rows_of(record):
    with record.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


@pytest.mark.parametrize(
    "way", list(itertools.permutations(KINDS)), ids=" ".join)
def test_gnd15_every_way_round_gives_the_same_bytes(convert, spoilt, way):
    record = spoilt / "record.csv"
    file = record
    for place, kind in enumerate(way):
        file = convert(file, f"{place}.{kind}")
    assert convert(file, "end.csv").read_bytes() == record.read_bytes()


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("text", [
    "frame,time_ms\n",
    "frame,time_ms\n0,20\n",
    "time_ms,frame,servos_us,link.uplink_sent\n20,0,9007199254740991,-3\n",
    "frame,time_ms,truth.bank_deg\n0,20,-0.000\n1,40,12.345\n",
    "frame,time_ms,pwm.brake\n0,20,65535\n7,160,0\n",
    "frame,time_ms,some thing,é.x.y\n0,20,1,2\n",
])
def test_gnd15_records_of_few_columns_too(convert, tmp_path, kind, text):
    (tmp_path / "a.csv").write_text(text, encoding="utf-8")
    convert(convert("a.csv", f"b.{kind}"), "c.csv")
    assert (tmp_path / "c.csv").read_text(encoding="utf-8") == text


def test_gnd15_a_flight_longer_than_a_block(convert, standard):
    """And longer than a row group of Parquet, when there are three of it."""
    lines = (standard / "record.csv").read_bytes().splitlines(True)
    long = standard / "long.csv"
    long.write_bytes(b"".join([lines[0], *(3 * lines[1:])]))
    for kind in ("mcap", "parquet"):
        back = convert(convert(long, f"a.{kind}"), "b.csv")
        assert back.read_bytes() == long.read_bytes()


def test_gnd15_mcap_is_read_by_others(convert, spoilt):
    """By PyPI's mcap and protobuf, with the schemas in the file."""
    file = convert(spoilt / "record.csv", "a.mcap")
    rows = rows_of(spoilt / "record.csv")
    checked = 0
    with file.open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        topics = {channel.topic for channel
                  in reader.get_summary().channels.values()}
        assert topics == {
            "/frame", "/console", "/gsc/uplink", "/mcs/uplink", "/pwm",
            "/mcs/downlink", "/gsc/downlink", "/mcs/frame", "/gsc/frame",
            "/link", "/truth", "/laws"}
        for _, channel, message, decoded in reader.iter_decoded_messages():
            row = rows[message.sequence]
            assert message.log_time == int(row["time_ms"]) * 1_000_000
            group = channel.topic[1:].replace("/", ".")
            for name, cell in row.items():
                if name.rpartition(".")[0] != group:
                    continue
                short = name.rpartition(".")[2]
                item = items.COLUMNS.get(name)
                if item is None:
                    assert getattr(decoded, short) == float(cell)
                    continue
                assert getattr(decoded.raw, short) == int(cell)
                if item.is_scaled:
                    value = getattr(decoded.value, short)
                    if math.isnan(value):
                        continue
                    assert value == pytest.approx(item.value(int(cell)))
                checked += 1
    assert checked > 0.7 * len(rows) * len(items.COLUMNS)


def is_missing(value):
    return value is None or math.isnan(value)


def test_gnd15_values_of_stale_words_are_left_out(convert, spoilt):
    rows = rows_of(spoilt / "record.csv")
    stale = [bool(int(row["gsc.downlink.error"]) & items.STALE)
             or all(cell == "0" for name, cell in row.items()
                    if name.startswith("gsc.downlink."))
             for row in rows]
    assert 45 < sum(stale) < 70
    table = pyarrow.parquet.read_table(
        convert(spoilt / "record.csv", "a.parquet"))
    column = table["gsc.downlink.altitude.value"].to_pylist()
    assert [is_missing(value) for value in column] == stale
    words = table["gsc.downlink.altitude"].to_pylist()
    assert words == [int(row["gsc.downlink.altitude"]) for row in rows]
    with convert(spoilt / "record.csv", "a.mcap").open("rb") as stream:
        reader = make_reader(stream, decoder_factories=[DecoderFactory()])
        found = [is_missing(decoded.value.altitude) for *_, decoded
                 in reader.iter_decoded_messages(["/gsc/downlink"])]
    assert found == stale


def test_gnd15_parquet_has_values_with_their_units(convert, spoilt):
    table = pyarrow.parquet.read_table(
        convert(spoilt / "record.csv", "a.parquet"))
    checked = 0
    for name, item in items.COLUMNS.items():
        if not item.is_scaled:
            assert f"{name}.value" not in table.column_names
            continue
        field = table.schema.field(f"{name}.value")
        assert field.metadata[b"unit"].decode() == item.unit
        for word, value in zip(table[name].to_pylist(),
                               table[f"{name}.value"].to_pylist(),
                               strict=True):
            if value is not None:
                assert value == pytest.approx(item.value(word))
                checked += 1
    assert checked > 20_000


BAD = {
    "": ":1: the file is empty",
    "a,b\n1,2\n": (":1: not a flight's record: it has no column frame and no"
                   " time_ms"),
    "frame,time_ms\r\n0,20\r\n": (
        ":1: its lines end with CR LF; a record is UTF-8 with LF alone: save"
        " it so, or give the file as it was recorded"),
    "frame,time_ms\n0,20\n1,NaN\n": ':3: time_ms: "NaN" is not a number',
    "frame,time_ms\n0,20\n1,4_0\n": ':3: time_ms: "4_0" is not a number',
    "frame,time_ms\n0,20\n1,9007199254740993\n": (
        ':3: time_ms: "9007199254740993" is not written as a record\'s numbers'
        " are"),
    "frame,time_ms,pwm.brake\n0,20,0\n1,40,65536\n": (
        ':3: pwm.brake: "65536" is not a word, 0 to 65535'),
    "frame,time_ms,pwm.brake\n0,20,-1\n": (
        ':2: pwm.brake: "-1" is not a word, 0 to 65535'),
    "frame,time_ms,truth.x\n0,20,1.50\n1,40,1.5\n": (
        ':3: truth.x: "1.5" has 1 decimals, the rows before have 2'),
    "frame,time_ms\n0,20\n1,40,3\n": ":3: 3 cells, the header has 2",
}


@pytest.mark.parametrize("text", BAD, ids=repr)
def test_gnd13_what_is_no_record_is_refused_with_its_line(
        urv, tmp_path, text):
    (tmp_path / "bad.csv").write_bytes(text.encode())
    result = urv("convert", "bad.csv", "out.csv")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr == f"urv: bad.csv{BAD[text]}\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["bad.csv"]


def test_gnd13_a_bad_line_far_down_is_named(urv, tmp_path):
    lines = ["frame,time_ms"] + [f"{n},{20 * n + 20}" for n in range(9000)]
    lines[7654] = "7653,x"
    (tmp_path / "bad.csv").write_text("\n".join(lines) + "\n", "utf-8")
    result = urv("convert", "bad.csv", "out.mcap")
    assert result.returncode == 2
    assert result.stderr == 'urv: bad.csv:7655: time_ms: "x" is not a number\n'


def test_gnd13_what_is_no_text_is_refused(urv, tmp_path):
    (tmp_path / "bad.csv").write_bytes(b"frame,time_ms\n0,\xff\n")
    result = urv("convert", "bad.csv", "out.mcap")
    assert (result.returncode, result.stdout) == (2, "")
    assert "not a text file: byte ffh" in result.stderr


# MCAP with a whole beginning is read as far as it is whole.
@pytest.mark.parametrize(("kind", "cut"), [
    *(("mcap", cut) for cut in (0, 1, 7)),
    *(("parquet", cut) for cut in (0, 1, 7, 0.5, 0.99))])
def test_gnd15_a_damaged_file_is_refused(
        urv, convert, tmp_path, spoilt, kind, cut):
    whole = convert(spoilt / "record.csv", f"whole.{kind}").read_bytes()
    length = int(cut * len(whole)) if isinstance(cut, float) else cut
    (tmp_path / f"cut.{kind}").write_bytes(whole[:length])
    result = urv("convert", f"cut.{kind}", "out.csv")
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1
    assert f"cut.{kind}" in result.stderr
    assert not (tmp_path / "out.csv").exists()


@pytest.mark.parametrize("kind", ["mcap", "parquet"])
def test_gnd15_bytes_that_have_changed_are_refused_or_change_nothing(
        urv, convert, tmp_path, spoilt, kind):
    """A checksum or a schema tells; what neither covers is no number."""
    whole = convert(spoilt / "record.csv", f"whole.{kind}").read_bytes()
    record = (spoilt / "record.csv").read_bytes()
    refused = 0
    for part in (0.1, 0.3, 0.5, 0.7, 0.9):
        spoilt_file = bytearray(whole)
        for at in range(20):
            spoilt_file[int(part * len(whole)) + at] ^= 0x55
        (tmp_path / f"spoilt.{kind}").write_bytes(spoilt_file)
        result = urv("convert", f"spoilt.{kind}", "out.csv")
        assert result.returncode in (0, 2), result.stderr
        assert len(result.stderr.splitlines()) == (result.returncode == 2)
        if result.returncode == 0:
            assert (tmp_path / "out.csv").read_bytes() == record
        refused += result.returncode == 2
    assert refused > 0


def test_gnd15_files_of_others_are_refused(urv, tmp_path):
    pyarrow.parquet.write_table(
        pyarrow.table({"frame": [1], "time_ms": [20]}),
        tmp_path / "other.parquet")
    result = urv("convert", "other.parquet", "out.csv")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr == ('urv: "other.parquet": no record: bin/urv convert'
                             " has not written it\n")


def test_gnd15_what_stood_there_stays_until_the_new_one_is_whole(
        urv, tmp_path):
    (tmp_path / "bad.csv").write_text("frame,time_ms\n0,20\n1,x\n", "utf-8")
    (tmp_path / "out.mcap").write_bytes(b"before")
    assert urv("convert", "bad.csv", "out.mcap").returncode == 2
    assert (tmp_path / "out.mcap").read_bytes() == b"before"
    assert len(list(tmp_path.iterdir())) == 2


@pytest.mark.parametrize("arguments, status, message", [
    (["a.csv", "a.csv"], 2, "IN and OUT name the same file"),
    (["a.csv", "a.xls"], 2,
     '"a.xls": a record\'s name ends with .csv, .mcap or .parquet'),
    (["a.txt", "b.csv"], 2,
     '"a.txt": a record\'s name ends with .csv, .mcap or .parquet'),
    (["none.mcap", "b.csv"], 2,
     '"none.mcap" cannot be read: No such file or directory'),
    (["none.parquet", "b.csv"], 2, '"none.parquet" cannot be read: '),
    (["a.csv", "no/b.csv"], 1,
     '"no/b.csv" cannot be written: No such file or directory'),
    (["a.csv", "no/b.mcap"], 1,
     '"no/b.mcap" cannot be written: No such file or directory'),
    (["a.csv", "no/b.parquet"], 1, '"no/b.parquet" cannot be written: '),
    (["a.csv"], 2, "Missing argument"),
])
def test_gnd15_what_cannot_be_done_is_said(
        urv, tmp_path, arguments, status, message):
    (tmp_path / "a.csv").write_text("frame,time_ms\n0,20\n", "utf-8")
    result = urv("convert", *arguments)
    assert (result.returncode, result.stdout) == (status, "")
    assert len(result.stderr.splitlines()) == 1
    assert message in result.stderr
    assert (tmp_path / "a.csv").read_text("utf-8") == "frame,time_ms\n0,20\n"


@pytest.fixture(scope="module")
def whole_mcap(tmp_path_factory, standard):
    target = tmp_path_factory.mktemp("whole") / "whole.mcap"
    subprocess.run([URV, "convert", standard / "record.csv", target],
                   check=True)
    return target.read_bytes()


@pytest.mark.parametrize("cut", [0.3, 0.5, 0.9, 0.99, -1])
def test_gnd15_an_mcap_that_was_cut_short_is_read_as_far_as_it_is_whole(
        urv, whole_mcap, tmp_path, standard, cut):
    record = (standard / "record.csv").read_bytes()
    length = int(cut * len(whole_mcap)) if cut > 0 else len(whole_mcap) + cut
    (tmp_path / "cut.mcap").write_bytes(whole_mcap[:length])
    result = urv("convert", "cut.mcap", "out.csv")
    assert (result.returncode, result.stderr) == (
        0, 'urv: "cut.mcap" was cut short: it has no end; what came before is'
        " read\n")
    read = (tmp_path / "out.csv").read_bytes()
    assert record.startswith(read) and read.endswith(b"\n")
    assert len(read) > 0.6 * cut * len(record)


def test_d39_a_record_that_was_cut_short_is_converted(
        urv, tmp_path, standard):
    """A record after kill -9: its last line has no end."""
    record = (standard / "record.csv").read_bytes()
    (tmp_path / "cut.csv").write_bytes(record[:-50])
    lines = record.count(b"\n")
    result = urv("convert", "cut.csv", "out.mcap")
    assert (result.returncode, result.stderr) == (
        0, f'urv: "cut.csv" was cut short: its line {lines} is not whole and'
        " left out\n")
    assert urv("convert", "out.mcap", "back.csv").returncode == 0
    back = (tmp_path / "back.csv").read_bytes()
    assert record.startswith(back) and back.count(b"\n") == lines - 1


# Measured with 8 hours: 95 to 230 MB, whatever the way.
MOST_MB = 300


def test_gnd15_memory_does_not_grow_with_the_flight(
        tmp_path, standard):
    """20 minutes, and each way of it in less memory than 8 hours may take; half
    an hour once took 560 MB from MCAP."""
    head, *rows = (standard / "record.csv").read_text("utf-8").splitlines()
    rows = [row.split(",", 2)[2] for row in rows]
    with (tmp_path / "long.csv").open("w", encoding="utf-8") as out:
        out.write(head + "\n")
        for frame in range(60_000):
            out.write(f"{frame},{20 * frame + 20},"
                      f"{rows[frame % len(rows)]}\n")
    for arguments in (
            ("convert", "long.csv", "long.mcap"),
            ("convert", "long.mcap", "long.parquet"),
            ("convert", "long.parquet", "back.csv"),
            ("report", "long.mcap", "-o", "report.html")):
        status, said, most = run_measured(tmp_path, *arguments)
        assert (status, said) == (0, "")
        assert most < MOST_MB
    assert (tmp_path / "back.csv").read_bytes() == (
        tmp_path / "long.csv").read_bytes()


@pytest.mark.parametrize("signal_number", [signal.SIGKILL, signal.SIGTERM])
def test_gnd15_a_killed_conversion_leaves_nothing(
        tmp_path, standard, signal_number):
    lines = (standard / "record.csv").read_bytes().splitlines(True)
    (tmp_path / "long.csv").write_bytes(
        b"".join([lines[0], *(20 * lines[1:])]))
    (tmp_path / "out.mcap").write_bytes(b"before")
    with subprocess.Popen([URV, "convert", "long.csv", "out.mcap"],
                          cwd=tmp_path, stderr=subprocess.DEVNULL) as running:
        descriptors = f"/proc/{running.pid}/fd"
        deadline = time.monotonic() + 60
        # Until it writes: a file without a name in the folder.
        while not any(str(tmp_path) in target for target in links(descriptors)
                      if "long.csv" not in target):
            assert time.monotonic() < deadline and running.poll() is None
            time.sleep(0.01)
        running.send_signal(signal_number)
    assert running.returncode != 0
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        "long.csv", "out.mcap"]
    assert (tmp_path / "out.mcap").read_bytes() == b"before"


def links(folder):
    """The targets of the links of a folder that changes."""
    for name in os.listdir(folder):
        try:
            yield os.readlink(f"{folder}/{name}")
        except OSError:
            continue


def test_gnd15_what_a_killed_program_left_is_removed(urv, tmp_path, spoilt):
    """On a file system without unnamed files."""
    (tmp_path / ".out.mcap.999999999.part").write_bytes(b"part")
    (tmp_path / f".out.mcap.{os.getpid()}.part").write_bytes(b"written")
    assert urv("convert", spoilt / "record.csv", "out.mcap").returncode == 0
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        f".out.mcap.{os.getpid()}.part", "out.mcap"]


NAMES = ("a:b", "file:a", "s3:--a", "a b", "a%20b", "-a", os.fsdecode(b"\xff"),
         "\u00e9", "a\nb", "x" * 240)


@pytest.mark.parametrize("name", NAMES, ids=ascii)
def test_gnd15_any_name_of_a_file_will_do(urv, tmp_path, spoilt, name):
    """Arrow took one with a colon for an address, and one that is not UTF-8
    for a mistake of the program."""
    shutil.copy(spoilt / "record.csv", tmp_path / f"{name}.csv")
    before = f"{name}.csv"
    for kind in ("parquet", "mcap", "csv"):
        result = urv("convert", f"./{before}", f"./2{name}.{kind}")
        assert (result.returncode, result.stderr) == (0, "")
        before = f"2{name}.{kind}"
    assert (tmp_path / before).read_bytes() == (
        spoilt / "record.csv").read_bytes()
    result = urv("report", f"./{before}", "-o", f"./{name}.html")
    assert (result.returncode, result.stderr) == (0, "")
    assert (tmp_path / f"{name}.html").stat().st_size > 10_000

# SPDX-License-Identifier: Apache-2.0
"""SEC-14 to SEC-16, D-65, D-66: files that others made, to do harm."""

import json
import os
import re
import resource
import stat
import struct
import subprocess
from types import SimpleNamespace

import lz4.frame
import numpy
import pyarrow
import pyarrow.parquet
import pytest
import zstandard
from conftest import URV, run_measured
from mcap.data_stream import RecordBuilder
from mcap.records import Channel, Header, Metadata

from urv import (
    faults, ground, mcap_files, parquet_files, pictures, records, whole_files)

# A file of 5 MB took 4 GB. A program with all its libraries takes 100.
MOST_MB = 400
TIME_LIMIT_S = 900
FIVE_MB = 5_000_000
MAGIC = b"\x89MCAP0\r\n"
CHUNK, MESSAGE = 6, 5


def built(record):
    builder = RecordBuilder()
    record.write(builder)
    return builder.end()


def mcap(columns="frame,time_ms", decimals="0,0"):
    """The beginning of a record."""
    return MAGIC + built(Header("", "")) + built(Metadata(
        mcap_files.MARK, {"version": mcap_files.VERSION, "columns": columns,
                          "decimals": decimals}))


def part(kind, data):
    return bytes([kind]) + struct.pack("<Q", len(data)) + data


def chunk(compression, data, size, claimed=None):
    name = compression.encode()
    return part(CHUNK, struct.pack("<QQQII", 0, 0, size, 0, len(name)) + name
                + struct.pack("<Q", len(data) if claimed is None else claimed)
                + data)


def zeros(size):
    """Gigabytes in some kB."""
    pack = zstandard.ZstdCompressor(level=1).compressobj(size=size)
    block = bytes(2 ** 22)
    return b"".join(pack.compress(block)
                    for _ in range(size // len(block))) + pack.flush()


def no_end():
    """One topic's messages for ever, none of the other's."""
    columns = records.Columns(["frame", "time_ms", "pwm.brake"], [0, 0, 0])
    layout = mcap_files.layouts(columns)[0]
    message = layout.encoded(numpy.zeros((1, 3)), None)[0]
    one = part(MESSAGE, struct.pack("<HIQQ", 1, 0, 0, 0) + message)
    data = one * (2 ** 23 // len(one))
    return (mcap("frame,time_ms,pwm.brake", "0,0,0")
            + built(Channel(1, layout.topic, "protobuf", {}, 0))
            + 200 * chunk("zstd", zstandard.compress(data), len(data)))


def written_mcap(names, decimals, row):
    def made(path):
        out = mcap_files.Writer(path, records.Columns(names, decimals))
        out.write(numpy.array([row], float))
        out.close(True)
    return made


def parquet(columns, decimals=None, **options):
    def made(path):
        fields = [pyarrow.field(name, column.type, metadata={
            "urv.decimals": (decimals or {}).get(name, "0")})
            for name, column in columns.items()]
        pyarrow.parquet.write_table(
            pyarrow.Table.from_arrays(
                list(columns.values()),
                schema=pyarrow.schema(fields, metadata={"urv.record": "1"})),
            path, compression="zstd", **options)
    return made


def ends_arrow(path):
    """With this byte of its metadata Arrow 26 ends its process by SIGABRT."""
    out = parquet_files.Writer(path, records.Columns(
        ["frame", "time_ms", "pwm.brake"], [0, 0, 0]))
    out.write(numpy.array([[0, 20, 1], [1, 40, 2]], float))
    out.close(True)
    data = bytearray(path.read_bytes())
    data[-1307] = 0
    path.write_bytes(data)


def many(count):
    return [f"c{number:x}" for number in range(count)]


ONE = pyarrow.array([0], pyarrow.int64())


def long_column():
    return pyarrow.array(numpy.zeros(20_000_000, numpy.int64))


def csv(*lines):
    return "".join(f"{line}\n" for line in lines).encode()


HOSTILE = {
    "wide.csv": lambda: csv(
        ",".join(["frame", "time_ms", *many(450_000)]),
        ",".join(["0"] * 450_002)),
    "one_line.csv": lambda: b"a" * FIVE_MB,
    "commas.csv": lambda: csv("frame,time_ms", "0,20", "," * FIVE_MB),
    "long_number.csv": lambda: csv(
        "frame,time_ms", "9" * FIVE_MB + ",20"),
    "digits.csv": lambda: csv("frame,time_ms,pwm.brake",
                              f"0,20,{'1' * 5000}"),
    "laws.csv": lambda: csv("frame,time_ms,laws.told", "0,20,65536"),
    "decimals.csv": lambda: csv("frame,time_ms,truth.x",
                                f"0,20,0.{'0' * 400}"),
    "time.csv": lambda: csv("frame,time_ms", "0,9007199254740991"),
    "before.csv": lambda: csv("frame,time_ms", "0,-20"),
    "two_topics.csv": lambda: csv("frame,time_ms,a.b.c,a/b.c", "0,20,1,2"),
    "bomb.mcap": lambda: mcap() + chunk("zstd", zeros(2 ** 32), 2 ** 32),
    "liar.mcap": lambda: mcap() + chunk("zstd", zeros(2 ** 32), 1000),
    "lz4.mcap": lambda: mcap() + chunk(
        "lz4", lz4.frame.compress(bytes(2 ** 29)), 1000),
    "length.mcap": lambda: mcap() + bytes([CHUNK]) + struct.pack(
        "<Q", 2 ** 62),
    "length_within.mcap": lambda: mcap() + chunk("", b"abc", 3, 2 ** 32 - 1),
    "beyond_any_length.mcap": lambda: mcap() + chunk(
        "", bytes(1) + struct.pack("<Q", 2 ** 63), 9),
    "huge_length_within.mcap": lambda: mcap() + chunk("", b"", 0, 2 ** 63),
    "wide.mcap": lambda: mcap(
        ",".join(["frame", "time_ms", *many(450_000)]),
        ",".join(["0"] * 450_002)),
    "few_decimals.mcap": lambda: mcap("frame,time_ms,truth.x", "0,0"),
    "many_decimals.mcap": lambda: mcap("frame,time_ms,truth.x", "0,0,400"),
    "one_topic.mcap": no_end,
    "word.mcap": written_mcap(
        ["frame", "time_ms", "pwm.brake"], [0, 0, 0], [0, 20, 70_000]),
    "nan.mcap": written_mcap(
        ["frame", "time_ms", "truth.x"], [0, 0, 3], [0, 20, numpy.nan]),
    "laws.mcap": written_mcap(
        ["frame", "time_ms", "laws.told"], [0, 0, 0], [0, 20, 2 ** 40]),
    "word.parquet": parquet({
        "frame": ONE, "time_ms": ONE,
        "pwm.brake": pyarrow.array([70_000], pyarrow.int64())}),
    "nan.parquet": parquet(
        {"frame": ONE, "time_ms": ONE,
         "truth.x": pyarrow.array([float("nan")])}, {"truth.x": "3"}),
    "missing.parquet": parquet({
        "frame": ONE, "time_ms": pyarrow.array([None], pyarrow.int64())}),
    "text.parquet": parquet({
        "frame": ONE, "time_ms": pyarrow.array(["a"])}),
    "decimals.parquet": parquet(
        {"frame": ONE, "time_ms": ONE}, {"time_ms": "x"}),
    "ends_arrow.parquet": lambda path: ends_arrow(path),
    "wide.parquet": parquet({
        "frame": ONE, "time_ms": ONE, **dict.fromkeys(many(15_000), ONE)}),
    "page.parquet": lambda path: parquet(
        {"frame": long_column(), "time_ms": long_column()},
        row_group_size=2 ** 30, data_page_size=2 ** 30,
        use_dictionary=False)(path),
    "rows.parquet": lambda path: parquet(
        {"frame": long_column(), "time_ms": long_column()},
        row_group_size=2 ** 30)(path),
}
"""The contents of a file, or a procedure that writes it."""


@pytest.fixture(scope="module")
def hostile(tmp_path_factory):
    """The folder of them."""
    folder = tmp_path_factory.mktemp("hostile")
    for name, made in HOSTILE.items():
        if made.__code__.co_argcount:
            made(folder / name)
        else:
            (folder / name).write_bytes(made())
    return folder


@pytest.mark.parametrize("command", [
    ("convert", "{}", "out.parquet"), ("report", "{}", "-o", "out.html")],
    ids=["convert", "report"])
@pytest.mark.parametrize("name", HOSTILE)
def test_sec14_a_hostile_file_gets_one_line_in_bounded_memory(
        hostile, name, command):
    status, said, most = run_measured(hostile, *(
        word.format(name) for word in command))
    assert (status, len(said.splitlines())) == (2, 1), said
    assert name in said and len(said) < 400
    assert most < MOST_MB


HOSTILE_EVENT = {"node": "gsc", "kind": "a", "count": 1, "first_ms": 0,
                 "last_ms": 0}


@pytest.mark.parametrize("option, text", [
    ("--summary", "[" * 100_000),
    ("--summary", '{"frames":' + "9" * 5_000 + "}"),
    ("--summary", '{"frames":1,"latency_ms":{"max":1e999}}'),
    ("--summary", '{"frames":1,"latency_ms":{"max":NaN}}'),
    ("--summary", '{"frames":1,"a":"' + "a" * 2 ** 25 + '"}'),
    ("--events", '{"node":' * 50_000),
    ("--events", json.dumps(HOSTILE_EVENT | {"count": 10 ** 400})),
    ("--events", json.dumps(HOSTILE_EVENT | {"last_ms": float("inf")})),
    ("--events", json.dumps(HOSTILE_EVENT | {"last_ms": float("nan")})),
    ("--events", json.dumps(HOSTILE_EVENT | {"first_ms": -1})),
    ("--events", json.dumps(HOSTILE_EVENT | {"node": "\ud800"})),
    ("--events", json.dumps(HOSTILE_EVENT | {"kind": "a" * 1_000})),
    ("--events", (json.dumps(HOSTILE_EVENT) + "\n") * 50_000),
], ids=range(13))
def test_sec14_hostile_json_gets_one_line(tmp_path, option, text):
    (tmp_path / "a.csv").write_bytes(csv("frame,time_ms", "0,20"))
    (tmp_path / "bad.json").write_text(text, encoding="utf-8")
    status, said, most = run_measured(tmp_path, "report", "a.csv", option,
                              "bad.json", "-o", "out.html")
    assert (status, len(said.splitlines())) == (2, 1), said[:1000]
    assert "bad.json" in said and len(said) < 400
    assert most < MOST_MB
    assert not (tmp_path / "out.html").exists()


def test_d65_what_no_limit_of_a_reader_sees_ends_at_the_memory_s(tmp_path):
    """Also Arrow's part of the program has no more."""
    result = subprocess.run(
        [URV.resolve().parents[1] / ".venv" / "bin" / "python", "-c",
         "import pyarrow\n"
         "from urv import input_files, main, parquet_files\n"
         "def convert(*_args):\n"
         "    input_files.limit_memory()\n"
         "    parquet_files._told('a', lambda: pyarrow.allocate_buffer("
         "2 * input_files.MOST_MEMORY))\n"
         "main.app = lambda **_options: convert()\n"
         "raise SystemExit(main.main([]))\n"],
        env={**os.environ, "PYTHONPATH": str(
            URV.resolve().parents[1] / "ground")},
        capture_output=True, text=True, check=False, timeout=TIME_LIMIT_S)
    assert result.returncode == 2
    assert len(result.stderr.splitlines()) == 1
    assert "memory" in result.stderr


def test_sec14_a_record_with_an_exceedance_every_second_row_has_a_report(
        tmp_path):
    """Its page took the square of their number."""
    (tmp_path / "a.csv").write_bytes(csv(
        "frame,time_ms,gsc.downlink.error,gsc.downlink.battery_volts",
        *(f"{row},{row * 1000},0,{4095 * (row & 1)}"
          for row in range(100_000))))
    status, said, most = run_measured(
        tmp_path, "report", "a.csv", "-o", "out.html")
    assert (status, said) == (0, "")
    assert most < MOST_MB


def test_sec14_an_age_of_months_is_drawn_without_a_word(tmp_path):
    """It does not fit the page's numbers."""
    (tmp_path / "a.csv").write_bytes(csv(
        "frame,time_ms,gsc.downlink.error,gsc.downlink.altitude",
        "0,20,0,65535", "1,8501629754,1,4095"))
    assert run_measured(
        tmp_path, "report", "a.csv", "-o", "out.html")[:2] == (0, "")


@pytest.mark.parametrize("arguments", [
    ("convert", "pipe.csv", "out.mcap"), ("convert", "pipe.mcap", "out.csv"),
    ("convert", "pipe.parquet", "out.csv"),
    ("report", "pipe.csv", "-o", "out.html"),
    ("report", "a.csv", "--events", "pipe.csv", "-o", "out.html"),
    ("report", "a.csv", "--summary", "pipe.csv", "-o", "out.html"),
    ("report", "a.csv", "--summary", "/dev/zero", "-o", "out.html"),
], ids=" ".join)
def test_sec14_pipes_and_devices_are_refused_at_once(tmp_path, arguments):
    (tmp_path / "a.csv").write_bytes(csv("frame,time_ms", "0,20"))
    for kind in ("csv", "mcap", "parquet"):
        os.mkfifo(tmp_path / f"pipe.{kind}")
    status, said, _ = run_measured(tmp_path, *arguments)
    assert (status, len(said.splitlines())) == (2, 1)
    assert said.endswith(" is not a regular file\n")


# Each command that writes a file that the user names.
OUTPUTS = [("convert", "a.csv", "link"), ("report", "a.csv", "-o", "link"),
           ("xtce", "-o", "link")]


@pytest.mark.parametrize("arguments", OUTPUTS, ids=lambda words: words[0])
@pytest.mark.parametrize("is_there", [True, False])
def test_d66_an_output_that_is_a_link_is_refused(tmp_path, arguments, is_there):
    (tmp_path / "a.csv").write_bytes(csv("frame,time_ms", "0,20"))
    target = tmp_path / "precious"
    if is_there:
        target.write_text("precious", encoding="utf-8")
    link = tmp_path / ("link.csv" if arguments[0] == "convert" else "link")
    link.symlink_to("precious")
    status, said, _ = run_measured(tmp_path, *(
        link.name if word == "link" else word for word in arguments))
    assert (status, said) == (
        2, f'urv: "{link.name}" is a symbolic link; an output must be a'
        " file\n")
    assert link.is_symlink() and target.exists() == is_there
    assert not is_there or target.read_text("utf-8") == "precious"


@pytest.mark.parametrize("arguments", [
    *OUTPUTS, ("keygen", "--add", "link")], ids=lambda words: words[0])
def test_gnd15_an_output_for_which_there_is_no_room_is_as_before(
        tmp_path, arguments):
    """A full disk looks to a program as a limit of a file's size does."""
    most = 40
    (tmp_path / "a.csv").write_bytes(csv("frame,time_ms", *(
        f"{row},{20 * row}" for row in range(5_000))))
    name = "link.csv" if arguments[0] == "convert" else "link"
    before = f"key 1 {'0a' * 16}\n".encode()
    (tmp_path / name).write_bytes(before)
    (tmp_path / name).chmod(0o600)
    ended = subprocess.run(
        [URV, *(name if word == "link" else word for word in arguments)],
        cwd=tmp_path, capture_output=True, text=True, check=False,
        stdin=subprocess.DEVNULL, timeout=TIME_LIMIT_S,
        preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (most, most)))
    assert (ended.returncode, ended.stderr.count("\n")) == (1, 1)
    assert ended.stderr.endswith(": File too large\n")
    assert (tmp_path / name).read_bytes() == before
    assert {each.name for each in tmp_path.iterdir()} == {"a.csv", name}


def test_sec15_a_new_key_for_which_there_is_no_room_is_not_there(tmp_path):
    ended = subprocess.run(
        [URV, "keygen", "new.key"], cwd=tmp_path, capture_output=True,
        text=True, check=False, stdin=subprocess.DEVNULL,
        timeout=TIME_LIMIT_S, preexec_fn=lambda: resource.setrlimit(
            resource.RLIMIT_FSIZE, (9, 9)))
    assert ended.returncode == 1 and ended.stderr.count("\n") == 1
    assert not list(tmp_path.iterdir())


YAMCS_FILES = ("mdb/urv.xml", "displays/flight.opi", "etc/yamcs.urv.yaml")


@pytest.mark.parametrize("name", YAMCS_FILES)
def test_d66_what_configures_yamcs_follows_no_link(tmp_path, name, capsys):
    flight = ground.Flight(tmp_path, 1, 2, 3)
    flight.configure_yamcs()
    text = (tmp_path / name).read_bytes()
    assert text
    (tmp_path / name).unlink()
    (tmp_path / name).symlink_to(tmp_path / "precious")
    assert not flight.start_yamcs()
    flight.terminal.close()
    assert not (tmp_path / "precious").exists()
    assert "is a symbolic link" in flight.losses["yamcs"]


def test_d66_a_picture_follows_no_link(tmp_path):
    page = SimpleNamespace(screenshot=lambda: b"picture")
    pictures._keep(page, tmp_path / "page.png")
    assert (tmp_path / "page.png").read_bytes() == b"picture"
    (tmp_path / "link.png").symlink_to("precious")
    with pytest.raises(faults.Refused, match="symbolic link"):
        pictures._keep(page, tmp_path / "link.png")
    assert not (tmp_path / "precious").exists()


def test_sec15_standard_output_may_be_an_output(tmp_path):
    (tmp_path / "a.csv").write_bytes(csv("frame,time_ms", "0,20"))
    with (tmp_path / "out.html").open("wb") as out:
        subprocess.run([URV, "report", "a.csv", "-o", "/dev/stdout"],
                       cwd=tmp_path, check=True, stdout=out,
                       timeout=TIME_LIMIT_S)
    assert (tmp_path / "out.html").stat().st_size > 10_000


def test_sec15_a_temporary_name_cannot_be_guessed(tmp_path, monkeypatch):
    """On a file system without unnamed files; nobody else makes the name."""
    monkeypatch.setattr(whole_files, "_nameless", lambda _folder, _mode: None)
    names, precious = set(), tmp_path / "precious"
    precious.write_bytes(b"precious")
    # The name that it had.
    (tmp_path / f".out.{os.getpid()}.part").symlink_to("precious")
    for _ in range(2):
        with whole_files.replacing(tmp_path / "out") as path:
            path.write_bytes(b"new")
            names |= {each.name for each in tmp_path.iterdir()
                      if re.fullmatch(r"\.out\.[0-9]+\.[0-9a-f]{16}\.part",
                                      each.name)}
    assert len(names) == 2
    assert (tmp_path / "out").read_bytes() == b"new"
    assert precious.read_bytes() == b"precious"


def test_sec15_outputs_in_place_are_opened_without_following(tmp_path):
    (tmp_path / "link").symlink_to("precious")
    with pytest.raises(OSError, match="symbolic links"):
        open(tmp_path / "link", "w", encoding="utf-8",
             opener=whole_files.no_link)
    assert not (tmp_path / "precious").exists()
    with open(tmp_path / "log", "w", encoding="utf-8",
              opener=whole_files.no_link) as log:
        log.write("a")
    assert stat.S_ISREG((tmp_path / "log").stat().st_mode)


FORMULAS = ("=1+1", "+1", "-1", "@SUM(A1)", " =1", "\uff1d1")


def test_sec16_no_cell_of_a_csv_is_a_formula(tmp_path):
    names = ["frame", "time_ms", *FORMULAS, "truth.x"]
    parquet({**{name: ONE for name in names[:-1]},
             "truth.x": pyarrow.array([-1.5])},
            {"truth.x": "1"})(tmp_path / "a.parquet")
    assert run_measured(
        tmp_path, "convert", "a.parquet", "a.csv")[:2] == (0, "")
    head, row = (tmp_path / "a.csv").read_text("utf-8").splitlines()
    assert head.split(",") == [
        "frame", "time_ms", *(f"'{name}" for name in FORMULAS), "truth.x"]
    # A number below zero stays one.
    assert row.split(",")[-1] == "-1.5"
    # The mark is no part of the name.
    for before, after in (("a.csv", "b.mcap"), ("b.mcap", "c.parquet"),
                          ("c.parquet", "d.csv"), ("a.csv", "e.csv")):
        assert run_measured(tmp_path, "convert", before, after)[:2] == (0, "")
    assert pyarrow.parquet.read_schema(
        tmp_path / "c.parquet").names[:len(names)] == names
    for name in ("d.csv", "e.csv"):
        assert (tmp_path / name).read_bytes() == (
            tmp_path / "a.csv").read_bytes()


@pytest.mark.parametrize("name", ["a;=1", "a/b", "'a", "''=1", "x" * 201])
def test_sec16_a_name_that_no_record_has_is_refused(tmp_path, name):
    (tmp_path / "a.csv").write_bytes(csv(f"frame,time_ms,{name}", "0,20,1"))
    status, said, _ = run_measured(tmp_path, "convert", "a.csv", "b.csv")
    assert (status, len(said.splitlines())) == (2, 1)
    assert "is not a column name" in said

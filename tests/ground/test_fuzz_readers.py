# SPDX-License-Identifier: Apache-2.0
"""SEC-14, GND-57: each reader of bin/urv gets inputs that hypothesis makes: files
and messages that are damaged, and such as are well formed and make no sense.

A reader gives a result or refuses in one line. Commands run in this process
with the limit of memory that they have.

Here some hundred inputs a reader, always the same. `make -C evidence fuzz
FUZZ=readers SECONDS=3600` continues for that time with others (URV_FUZZ_SECONDS).
"""

import contextlib
import io
import json
import os
import random
import resource
import signal
import struct
import time
import traceback
import warnings

import lz4.frame
import numpy
import pyarrow
import pyarrow.parquet
import pytest
import typer
import zstandard
from conftest import ROOT
from hypothesis import HealthCheck, Phase, configuration, given, settings
from hypothesis import strategies as some
from mcap.data_stream import RecordBuilder
from mcap.records import Channel, Chunk, Header, Message, Metadata
from mcap.stream_reader import StreamReader

from test_node_starts import Clock, frame_of
from urv import (archive, controls, faults, flights, ground, main, mavlink,
                 mcap_files, packets, processes, records, station,
                 view, web)
from urv.door import Token, address_of, is_own_host

SECONDS = float(os.environ.get("URV_FUZZ_SECONDS", "0"))
"""Time of all tests here together, when there are more inputs than usual."""

PHASES = (Phase.generate,) if SECONDS else tuple(Phase)
"""To look for a smaller input takes minutes."""

LONGEST_WORD = 400
"""Characters of a refusal."""

# In a program's own process Arrow does so without a reserve of 1 GB.
pyarrow.allocate_buffer(2 ** 20)

configuration.set_hypothesis_home_dir(ROOT / "obj" / "hypothesis")

NAMES = ("pwm.brake", "gsc.downlink.error", "gsc.downlink.battery_volts",
         "gsc.downlink.altitude", "gsc.downlink.airspeed", "console.switch1",
         "truth.x", "laws.told", "link.uplink_sent")
DECIMALS = {"truth.x": 3}


def tried(name, examples, check, *inputs):
    """Gives `check` a number of inputs, or as many as there is time for."""
    count = 0

    @settings(max_examples=examples, deadline=None, database=None,
              derandomize=not SECONDS, phases=PHASES,
              suppress_health_check=list(HealthCheck))
    @given(some.tuples(*inputs))
    def try_one(made):
        nonlocal count
        count += 1
        with warnings.catch_warnings():
            # A warning would be a second line.
            warnings.simplefilter("error")
            warnings.simplefilter("ignore", ResourceWarning)
            # Python 3.12 and later warn of a fork beside threads of libraries,
            # but only tests show it.
            warnings.filterwarnings(
                "ignore", ".* is multi-threaded", DeprecationWarning)
            try:
                check(*made)
            except Exception:
                if SECONDS:
                    print(f"fuzz: {name}: {made!r}\n{traceback.format_exc()}",
                          flush=True)
                raise

    tests = sum(each.startswith("test_") for each in globals())
    ends = time.monotonic() + SECONDS / tests
    try_one()
    while time.monotonic() < ends:
        try_one()
    if SECONDS:
        print(f"fuzz: {name}: {count} inputs", flush=True)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("fuzz")


@pytest.fixture(autouse=True)
def as_it_was(monkeypatch):
    """A command changes its process: this one goes on."""
    monkeypatch.setattr(main, "drop_standard_output", lambda: None)
    # typer would make the commands again for each input.
    monkeypatch.setattr(main, "app", typer.main.get_command(main.app))
    limits = resource.getrlimit(resource.RLIMIT_DATA)
    terminates = signal.getsignal(signal.SIGTERM)
    yield
    signal.signal(signal.SIGTERM, terminates)
    resource.setrlimit(resource.RLIMIT_DATA, limits)


def is_done(*arguments):
    """Runs a command of bin/urv. Whether it was done; else it was refused as
    it should be."""
    said = io.StringIO()
    with contextlib.redirect_stderr(said), contextlib.redirect_stdout(
            io.StringIO()):
        status = main.main([str(each) for each in arguments])
    lines = said.getvalue().splitlines()
    assert status in (0, 2), lines
    assert len(lines) <= 1 or status == 0, lines
    assert status == 0 or len(lines) == 1
    assert all(line.startswith("urv: ") and len(line) < LONGEST_WORD
               for line in lines), lines
    return status == 0


# Bytes and values by chance

EDITS = some.lists(some.tuples(
    some.floats(0, 1),
    some.one_of(
        some.tuples(some.just("set"), some.integers(0, 255)),
        some.tuples(some.just("flip"), some.integers(0, 7)),
        some.tuples(some.just("cut"), some.integers(1, 99)),
        some.tuples(some.just("add"), some.binary(max_size=9)),
        some.tuples(some.just("put"), some.sampled_from([
            struct.pack(order + kind, value)
            for order in "<>" for kind, value in (
                ("I", 2 ** 31), ("I", 2 ** 32 - 1), ("Q", 2 ** 63),
                ("Q", 2 ** 64 - 1), ("H", 2 ** 15), ("H", 2 ** 16 - 1))])),
    )), max_size=8)


def edited(data, edits):
    """The bytes with each edit at its place, from 0 to 1."""
    data = bytearray(data)
    for place, (how, value) in edits:
        at = min(int(place * len(data)), len(data) - 1)
        if not data:
            break
        if how == "set":
            data[at] = value
        elif how == "flip":
            data[at] ^= 1 << value
        elif how == "cut":
            del data[at:at + value]
        elif how == "add":
            data[at:at] = value
        else:
            data[at:at + len(value)] = value
    return bytes(data)


# Half characters of UTF-16 too, which JSON can have.
TEXT = some.text(some.characters(exclude_categories=()), max_size=12)
NUMBERS = some.one_of(
    some.integers(), some.floats(), some.integers(-9, 9),
    some.sampled_from([2 ** 53, 10 ** 10, 10 ** 400, 1e308, -0.0]))
VALUES = some.recursive(
    some.one_of(some.none(), some.booleans(), NUMBERS, TEXT),
    lambda inner: some.one_of(
        some.lists(inner, max_size=3),
        some.dictionaries(TEXT, inner, max_size=3)), max_leaves=8)


def objects(**fields):
    """An object of JSON with these fields, of which some are missing or are
    anything."""
    return some.fixed_dictionaries({}, optional={
        name: some.one_of(value, value, value, VALUES)
        for name, value in fields.items()})


def json_of(*values):
    """Its text, or one that is none."""
    return some.one_of(
        *(value.map(json.dumps) for value in values),
        VALUES.map(json.dumps), TEXT,
        some.integers(0, 40_000).map(lambda deep: "[" * deep),
        some.integers(0, 9_000).map(lambda many: "9" * many))


def octets(text):
    return text.encode("utf-8", "surrogatepass")


# Records

CELLS = some.one_of(
    some.integers(0, 65_535).map(str), some.integers(-10, 70_000).map(str),
    some.decimals(allow_nan=False, allow_infinity=False, places=3,
                  min_value=-10 ** 6, max_value=10 ** 6).map(str),
    some.sampled_from(["0", "1", "1e9", "nan", "-0", "9007199254740992",
                       "10000000000"]), TEXT)
HEADS = some.lists(some.one_of(some.sampled_from(NAMES), TEXT), max_size=9)


@some.composite
def any_csv(draw):
    """Cells that may be anything."""
    names = draw(HEADS)
    if draw(some.booleans()):
        names = ["frame", "time_ms", *names]
    rows = draw(some.lists(some.lists(
        CELLS, min_size=len(names), max_size=len(names)), max_size=6))
    return octets("\n".join(map(",".join, [names, *rows]))
                  + draw(some.sampled_from(["\n", ""])))


@some.composite
def good_csv(draw):
    """A record of a flight that cannot have been."""
    names = draw(some.lists(some.sampled_from(NAMES), unique=True))
    chance = random.Random(draw(some.integers(0, 2 ** 32)))
    times = draw(some.lists(some.one_of(
        some.integers(0, 10 ** 10), some.integers(0, 10 ** 5)), min_size=1,
        max_size=12))
    rows = [[str(chance.randrange(99)), str(at), *(
        f"{chance.uniform(-1e6, 1e6):.3f}" if name in DECIMALS
        else str(chance.choice([0, 1, 2047, 4095, 65_535]))
        for name in names)] for at in times]
    return octets("".join(f"{','.join(row)}\n" for row in [
        ["frame", "time_ms", *names], *rows]))


CSV = some.one_of(any_csv(), good_csv(), TEXT.map(octets),
                  some.builds(edited, good_csv(), EDITS))


def rows_of(path):
    """The text of a record."""
    with records.opened(path, True) as record:
        return "".join(map(record.columns.text, record.blocks()))


def check_record(folder, kind, data):
    """It has a report, and goes through each kind of file unchanged; or it is
    refused by both commands."""
    source = folder / f"in{kind}"
    source.write_bytes(data)
    has_report = is_done("report", source, "-o", folder / "out.html")
    if has_report:
        (folder / "out.html").read_text("utf-8")
    rows = None
    for target in records.KINDS:
        out = folder / f"out{target}"
        if is_done("convert", source, out):
            rows = rows_of(source) if rows is None else rows
            assert rows_of(out) == rows
        else:
            # A record without rows has no report.
            assert not has_report and rows is None


def test_sec14_records_of_csv(folder):
    tried("csv", 40, lambda data: check_record(folder, ".csv", data), CSV)


# Files of bin/urv identify

MASSES = some.one_of(
    some.floats(1e-9, 1e12), some.floats(1, 3000), NUMBERS)
AIRCRAFT = json_of(objects(
    aircraft=TEXT, gravity_ft_s2=some.floats(31.9, 32.4),
    derivatives=some.dictionaries(TEXT, NUMBERS, max_size=3),
    ixz_slug_ft2=some.floats(-99, 99),
    **dict.fromkeys(("mass_slug", "ixx_slug_ft2", "iyy_slug_ft2",
                     "izz_slug_ft2", "wing_area_ft2", "span_ft",
                     "chord_ft"), MASSES)))
TIMES = some.one_of(TEXT, some.lists(some.one_of(
    some.builds("{:g},{:g},{}".format, some.floats(), some.floats(),
                some.one_of(TEXT, some.just("both"))),
    some.builds("{:.2f},{:.2f},{}".format, some.floats(0, 9),
                some.floats(9, 99), some.sampled_from(
                    ["both", "lateral", "longitudinal"])),
    TEXT), max_size=4).map(
        lambda rows: "\n".join(["begin_s,end_s,axes", *rows])))


def check_identify(folder, own, times):
    """Refused in any case: the record has no sensors."""
    (folder / "own.json").write_bytes(own)
    (folder / "times.csv").write_bytes(times)
    (folder / "in.csv").write_text("frame,time_ms,pwm.brake\n0,0,2048\n")
    assert not is_done("identify", folder / "in.csv", "--aircraft",
                       folder / "own.json", "--manoeuvres",
                       folder / "times.csv")


def test_sec14_aircraft_files_and_times_of_manoeuvres(folder):
    good = ROOT / "sim/jsbsim/aircraft/lambda/derivatives.json"
    own = some.one_of(
        AIRCRAFT.map(octets), some.just(good.read_bytes()),
        some.builds(edited, some.just(good.read_bytes()), EDITS))
    tried("identify", 60, lambda *files: check_identify(folder, *files),
          own, some.one_of(
              TIMES.map(octets),
              some.builds(edited, TIMES.map(octets), EDITS)))


def sample(folder, kind, many=20):
    """The bytes of a record."""
    chance = numpy.random.default_rng(1)
    names = ["frame", "time_ms", *NAMES]
    columns = records.Columns(names, [DECIMALS.get(name, 0) for name in names])
    rows = chance.integers(0, 4096, (many, len(names))).astype(float)
    rows[:, 0] = numpy.arange(many)
    rows[:, 1] = 20 * numpy.arange(many)
    at = names.index("truth.x")
    rows[:, at] = numpy.round(rows[:, at] / 7, 3)
    path = folder / f"sample{kind}"
    module = mcap_files if kind == ".mcap" else pyarrow_files()
    out = module.Writer(path, columns)
    out.write(rows)
    out.close(True)
    return path.read_bytes()


def pyarrow_files():
    from urv import parquet_files
    return parquet_files


def built(part):
    builder = RecordBuilder()
    part.write(builder)
    return builder.end()


COLUMNS = some.one_of(
    some.just("frame,time_ms,pwm.brake"), some.just("frame,time_ms"),
    HEADS.map(",".join), HEADS.map(lambda names: ",".join(
        ["frame", "time_ms", *names])))
PLACES = some.one_of(some.just("0,0,0"), some.just("0,0"), TEXT,
                     some.lists(some.integers(-1, 10)).map(
                         lambda many: ",".join(map(str, many))))
LONG = some.one_of(some.integers(0, 99), some.sampled_from(
    [2 ** 24, 2 ** 32 - 1, 2 ** 63, 2 ** 64 - 1]))


def whole(text):
    """As UTF-8 can have it."""
    return text.encode("utf-8", "replace").decode("utf-8")


@some.composite
def any_mcap(draw):
    """Parts in any order, in chunks of any kind, whose lengths may lie."""
    inner = b"".join(draw(some.lists(some.one_of(
        some.builds(lambda number, topic: built(Channel(
            number, topic, "protobuf", {}, 0)), some.integers(0, 2),
            some.sampled_from(["/frame", "/pwm", "/"])),
        some.builds(lambda number, data: built(Message(
            number, 0, data, 0, 0)), some.integers(0, 2),
            some.binary(max_size=40)),
        some.builds(lambda kind, size, data: bytes([kind]) + struct.pack(
            "<Q", size) + data, some.integers(0, 15), LONG,
            some.binary(max_size=20))), max_size=6)))
    packing = draw(some.sampled_from(["", "zstd", "lz4", "none", "\0"]))
    packed = (zstandard.compress(inner) if packing == "zstd" else
              lz4.frame.compress(inner) if packing == "lz4" else inner)
    size = draw(some.one_of(some.just(len(inner)), LONG))
    head = (b"\x89MCAP0\r\n" + built(Header("", "")) + built(Metadata(
        draw(some.sampled_from([mcap_files.MARK, ""])),
        draw(some.fixed_dictionaries({}, optional={
            "version": some.sampled_from([mcap_files.VERSION, ""]),
            "columns": COLUMNS.map(whole), "decimals": PLACES.map(whole)})))))
    return head + (built(Chunk(packing, packed, 0, 0, 0, size))
                   if draw(some.booleans()) else inner)


def within_chunks(data, edits):
    """The file with the contents of its chunks edited, and no checksums."""
    parts = []
    for part in StreamReader(io.BytesIO(data), emit_chunks=True).records:
        if isinstance(part, Chunk):
            inner = edited(zstandard.decompress(
                part.data, part.uncompressed_size), edits)
            part = Chunk("zstd", zstandard.compress(inner), 0, 0, 0,
                         len(inner))
        parts.append(built(part))
    return b"\x89MCAP0\r\n" + b"".join(parts) + b"\x89MCAP0\r\n"


def test_sec14_records_of_mcap(folder):
    good = sample(folder, ".mcap")
    assert within_chunks(good, []) != good
    tried("mcap", 60, lambda data: check_record(folder, ".mcap", data),
          some.one_of(EDITS.map(lambda edits: edited(good, edits)),
                      EDITS.map(lambda edits: within_chunks(good, edits)),
                      any_mcap()))


KINDS = some.sampled_from([
    pyarrow.int64(), pyarrow.uint16(), pyarrow.uint64(), pyarrow.int8(),
    pyarrow.float64(), pyarrow.float16(), pyarrow.string(),
    pyarrow.bool_(), pyarrow.list_(pyarrow.int64()),
    pyarrow.timestamp("ns"), pyarrow.decimal128(5, 2)])


@some.composite
def any_parquet(draw):
    """A table of any types, values and remarks."""
    names = draw(some.lists(some.one_of(
        some.sampled_from(NAMES), some.text(max_size=9)), max_size=6))
    if draw(some.integers(0, 3)):
        names = ["frame", "time_ms", *names]
    many = draw(some.integers(0, 4))
    fields, columns = [], []
    for name in names:
        kind = draw(some.one_of(
            some.just(pyarrow.float64() if name in DECIMALS
                      else pyarrow.int64()), KINDS))
        values = draw(some.lists(some.one_of(
            some.integers(0, 99), NUMBERS, some.none()),
            min_size=many, max_size=many))
        try:
            column = pyarrow.array(values).cast(kind)
        except (pyarrow.ArrowException, OverflowError):
            column = pyarrow.nulls(many, kind)
        columns.append(column)
        fields.append(pyarrow.field(name, kind, metadata=draw(some.one_of(
            some.just({"urv.decimals": str(DECIMALS.get(name, 0))}),
            some.none(), some.text(max_size=3).map(
                lambda text: {"urv.decimals": text})))))
    schema = pyarrow.schema(fields, metadata=draw(some.sampled_from(
        [{"urv.record": "1"}, {"urv.record": "2"}, None])))
    out = io.BytesIO()
    pyarrow.parquet.write_table(
        pyarrow.Table.from_arrays(columns, schema=schema), out,
        compression=draw(some.sampled_from(["zstd", "none", "snappy"])),
        use_dictionary=draw(some.booleans()))
    return out.getvalue()


def test_sec14_records_of_parquet(folder):
    good = sample(folder, ".parquet")
    tried("parquet", 30, lambda data: check_record(folder, ".parquet", data),
          some.one_of(EDITS.map(lambda edits: edited(good, edits)),
                      any_parquet(), some.builds(edited, any_parquet(),
                                                 EDITS)))


# Summary and events

EVENT = objects(
    node=some.sampled_from(["gsc", "mcs", "station"]),
    kind=some.sampled_from(["block_refused", "warm_reset", "a"]),
    count=some.integers(1, 9), first_ms=some.integers(0, 10 ** 5),
    last_ms=some.integers(0, 10 ** 5))
COUNT = some.integers(0, 9)
SUMMARY = objects(
    frames=COUNT, unfinished=some.text(max_size=9),
    link=objects(uplink_received=COUNT, downlink_received=COUNT,
                 blocks_refused=COUNT, late_answers=COUNT,
                 round_trip_us=objects(measured=COUNT, median=COUNT,
                                       max=COUNT)),
    latency_ms=objects(median=COUNT, p99=COUNT, max=COUNT),
    flight_quality=objects(
        crashed=some.booleans(), crashed_at_s=COUNT,
        ended_level=some.booleans(), altitude_rms_ft=COUNT,
        bank_left_deg=COUNT, bank_right_deg=COUNT),
    events=some.dictionaries(some.sampled_from(
        ["gsc.block_refused", "mcs.block_refused"]), COUNT)
).map(lambda made: {"frames": 1, **made})


def test_sec14_summary_and_events(folder):
    def check(record, summary, events, has_summary, has_events):
        (folder / "in.csv").write_bytes(record)
        (folder / "summary.json").write_bytes(octets(summary))
        (folder / "events.jsonl").write_bytes(octets(events))
        options = []
        if has_summary:
            options += ["--summary", folder / "summary.json"]
        if has_events:
            options += ["--events", folder / "events.jsonl"]
        if is_done("report", folder / "in.csv", "-o", folder / "out.html",
                   *options):
            (folder / "out.html").read_text("utf-8")

    tried("json", 50, check, good_csv(), json_of(SUMMARY),
          some.lists(json_of(EVENT), max_size=4).map("\n".join),
          some.booleans(), some.booleans())


# Keys, certificates and addresses

@some.composite
def key_lines(draw):
    return draw(some.sampled_from(["\n", "\n", "\r\n", "\r", "\v"])).join(
        draw(some.lists(some.one_of(
            some.builds("key {} {}".format, some.integers(0, 999), some.text(
                "0123456789abcdefABCDEF", min_size=31, max_size=33)),
            some.just(f"key 1 {'0a' * 16}"), some.just("# a key"), TEXT),
            max_size=4))) + "\n"


def test_sec14_key_files(folder):
    def check(data):
        path = folder / "keys"
        path.write_bytes(data)
        path.chmod(0o600)
        if is_done("keygen", path, "--add"):
            # It reads its own files.
            assert is_done("keygen", path, "--add")
        assert path.stat().st_mode & 0o777 == 0o600

    tried("keys", 40, check, some.one_of(
        key_lines().map(octets), some.binary(max_size=99)))


def test_sec14_certificates(folder):
    pytest.importorskip("distributed")
    from urv import certificates

    place = folder / "certificates"
    place.mkdir()
    certificates.temporary(place)
    (place / "ca.pem").write_bytes((place / "cert.pem").read_bytes())
    good = {name: (place / name).read_bytes() for name in certificates.FILES}

    def check(name, edits):
        for each, data in good.items():
            (place / each).write_bytes(
                edited(data, edits) if each == name else data)
        with contextlib.suppress(faults.Refused):
            certificates.of_folder(place)

    tried("certificates", 60, check, some.sampled_from(certificates.FILES),
          EDITS)


def test_sec14_addresses_and_tokens():
    token = Token("a token of many")

    def check(host, port, word):
        word = word.decode("utf-8", "surrogateescape")
        assert not token.is_token(word) and not token.is_session(word)
        for text in (host, f"udp:{host}:{port}", f"tcp:{host}", f"{host}:1"):
            with contextlib.suppress(faults.Refused):
                found, number = station.address("--frames", text)
                # The system's look-up encodes a name so.
                found.encode("idna")
                assert 0 <= number <= 65_535
            with contextlib.suppress(faults.Refused):
                station.ip_address("--sender", text)
            address_of(text)
            assert is_own_host(text) in (True, False)

    tried("addresses", 200, check,
          some.one_of(some.text(max_size=80), some.sampled_from(
              ["127.0.0.1", "[::1]", "::ffff:1.2.3.4", "fe80::1%eth0", "[",
               "a" * 64, "a..b"])),
          some.one_of(some.integers().map(str), TEXT,
                      some.just("1" * 5000)), some.binary(max_size=40))


# The station

def test_gnd57_packets():
    """Decoded, a packet is what it was, or it is refused."""
    kinds = (packets.FramePacket, packets.ConsolePacket, packets.OrderPacket,
             packets.CardPacket)
    good = [
        frame_of(3).encode(), frame_of(3, version=packets.VERSION).encode(),
        packets.ConsolePacket(1, 2, 3, (0,) * len(packets.COMMANDS)).encode(),
        packets.OrderPacket(1, 2, 3, 4, 0, 50, 1200).encode(),
        packets.CardPacket(1, 2, 3, (259, *range(11))).encode()]

    def check(data):
        for kind in kinds:
            with contextlib.suppress(packets.PacketError):
                assert kind.decode(data).encode() == data

    tried("packets", 150, check, some.one_of(
        some.binary(max_size=1500),
        some.builds(edited, some.sampled_from(good), EDITS)))


LONG_AGO_US = 1_700_000_000_000_000


@some.composite
def frames(draw):
    """Frame packets, some of them damaged within, when each comes, and from
    where."""
    found = []
    sequence = draw(some.integers(0, 99))
    for _ in range(draw(some.integers(1, 12))):
        sequence = max(0, sequence + draw(some.one_of(
            some.just(1), some.integers(-3, 30), some.integers(
                0, 2 ** 32 - 1)))) % 2 ** 32
        data = bytearray(frame_of(
            sequence, run=draw(some.sampled_from([1, 1, 1, 2, 2 ** 32 - 1])),
            time_us=draw(some.one_of(
                some.just(LONG_AGO_US + sequence * packets.FRAME_US),
                some.integers(0, packets.LATEST_US))),
            downlink_age=draw(some.sampled_from([0, 0, 1, packets.NEVER])),
            console_state=draw(some.sampled_from(packets.ConsoleState)),
            link_state=draw(some.sampled_from(packets.LinkState)),
            console_sequence=draw(some.integers(0, 2 ** 32 - 1)),
            pilot=draw(some.sampled_from(packets.Pilot)),
            version=draw(some.sampled_from(list(packets.LENGTHS)))).encode())
        # Counts, words and logs may be anything.
        first, last = packets.WORDS_AT - 4 * len(packets.LINK_COUNTS), len(data)
        for at, part in draw(some.lists(some.tuples(
                some.integers(first, last - 1), some.binary(max_size=30)),
                max_size=4)):
            if not at <= packets.MORE_AT - 2 < at + len(part):
                data[at:at + len(part)] = part[:last - at]
        found.append((draw(some.floats(0, 3)), draw(some.sampled_from(
            [("127.0.0.1", 1), ("::1", 2), None])), bytes(data)))
    return found


def test_gnd57_frames_on_the_page_in_yamcs_and_as_mavlink():
    """Each packet that is a frame's is shown, sent and logged without a
    fault."""

    class Sink:
        @staticmethod
        def write(_data):
            pass

    def told(line):
        json.dumps(line.shown(), allow_nan=False)
        assert "could not be shown" not in line.text, line.text

    def check(coming):
        clock = Clock()
        seen = view.View(told, now=clock)
        bridge = mavlink.Bridge(Sink, now=clock)
        for delay_s, sender, data in coming:
            clock.now += delay_s
            is_new = seen.datagram(data, sender)
            before = bridge.frames
            bad = bridge.bad
            bridge.datagram(data, sender)
            assert (bridge.frames, bridge.bad) == (
                before + is_new, bad + (not is_new))
            seen.look(clock.now)
            json.dumps([seen.shown(), seen.alerts.shown(),
                        seen.clock_ahead_us()], allow_nan=False)

    tried("frames", 40, check, frames())


SEQUENCE = some.one_of(some.integers(1, 99), NUMBERS)


def said(**fields):
    return objects(**fields, sequence=SEQUENCE,
                   sent_ms=some.integers(0, 10 ** 6))


WORD = some.integers(0, 4095)
MESSAGES = some.lists(json_of(
    said(t=some.just("sticks"), words=some.lists(
        WORD, min_size=len(packets.COMMANDS),
        max_size=len(packets.COMMANDS))),
    said(t=some.just("drawn"), number=some.integers(0, 9)),
    said(t=some.just("order"), table=WORD, orbit=WORD, end=WORD),
    said(t=some.just("answer"), yes=some.booleans()),
    said(t=some.just("mark"), text=TEXT),
    said(t=some.just("seen"), key=some.one_of(some.none(), TEXT)),
    said(t=some.just("lost"), what=some.sampled_from(
        ["hidden", "gamepad", "hung"])),
    said(t=some.just("gamepad"), what=some.sampled_from(
        list(controls.GAMEPAD)), name=TEXT),
    said(t=some.sampled_from(["take", "release", "pilot"])),
), max_size=8)


def test_sec14_messages_of_pages():
    """Only an understood order is carried out, and goes to pages, file and
    archive."""
    def told(line):
        json.dumps(line.shown(), allow_nan=False).encode("utf-8")
        assert line.text.isprintable()
        line.text.encode("utf-8")

    def check(messages):
        clock = Clock()
        seen = view.View(told, now=clock)
        sent = []
        run = controls.Controls(seen, sent.append, now=clock)
        served = web.Station(run)
        pages = [web.Page(number, None) for number in (1, 2)]
        seen.datagram(frame_of(3, pilot=packets.Pilot.HANDS_OFF).encode())
        for place, text in enumerate(messages):
            clock.now += 0.1
            meant = web.understood(text)
            if meant is not None:
                served._hears(pages[place % 2], meant, clock.now)
            run.tick()
            json.dumps([run.shown(), seen.alerts.shown()], allow_nan=False)
        for data in sent:
            kind = (packets.CardPacket if len(data) == packets.CARD_LENGTH
                    else packets.OrderPacket if data.startswith(b"URVO")
                    else packets.ConsolePacket)
            kind.decode(data)

    tried("messages", 80, check, MESSAGES)


def test_sec14_reports_about_programs():
    def check(text):
        seen = view.View()
        with contextlib.suppress(ValueError):
            seen.report(processes.Report.of(text))
            seen.look(seen.now())
            json.dumps(seen.alerts.shown(), allow_nan=False)

    tried("reports", 150, check, json_of(objects(
        key=TEXT, level=some.sampled_from(["caution", "warning"]), name=TEXT,
        text=TEXT, active=some.booleans())))


def test_sec14_answers_of_yamcs():
    def check(text):
        with contextlib.suppress(ValueError):
            answer = archive.answer_in(octets(text))
            answer.get("state")
            assert archive.count_in(answer) >= 0

    tried("yamcs", 150, check, json_of(objects(
        state=some.just("RUNNING"), dataInCount=some.one_of(
            COUNT, COUNT.map(str)))))


def test_sec14_lines_of_the_station_s_log(folder):
    """Each is an event that the report takes, none, or refused."""
    def check(text):
        with contextlib.suppress(ValueError):
            event = ground.event_in(text)
            if event is not None:
                path = folder / "station.jsonl"
                path.write_text(json.dumps(event), encoding="utf-8")
                assert len(flights.read_events(path)) == 1

    tried("log", 150, check, json_of(objects(
        number=COUNT, time_us=COUNT, frame=some.one_of(some.none(), COUNT),
        level=some.sampled_from(["info", "caution", "warning"]),
        kind=some.sampled_from(["mark", "alert", "error"]), text=TEXT)))

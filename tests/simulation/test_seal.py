# SPDX-License-Identifier: Apache-2.0
"""SEC-1 to SEC-5: the sealed link. The blocks on the wire are opened here by
docs/security.md alone, with libsodium's SipHash."""

import inspect
import json
import os
import random
import subprocess

import pytest
from conftest import (
    COMMANDS,
    EXCHANGE,
    ROOT,
    columns,
    different_rows,
    fly_in,
    messages,
    run_program,
    script,
)
import attack
import seal_tags
from nacl.bindings import crypto_shorthash_siphash24 as siphash

KEY = bytes(range(3, 19))
SECONDS = 5
ROWS = different_rows(200, len(COMMANDS), 4)
COVERED = {"up": 22, "down": 48}
TAG = {"up": 6, "down": 8}
WORDS = {"up": 14, "down": 28}
HELLO, BLOCKS = {"up": 0, "down": 1}, {"up": 2, "down": 3}

TOOL = ROOT / "bin" / "urv_seal"


@pytest.fixture(scope="module")
def tool():
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P", ROOT / "evidence/seal/urv_seal.gpr",
         "-XURV_Mode=host"], check=True, timeout=600)
    return TOOL


def write_key(path, text=f"key 1 {KEY.hex()}\n", mode=0o600):
    path.write_text(text, "utf-8")
    path.chmod(mode)
    return path


def key_of(use, ground, aircraft):
    """The key of one use, from the nonces as they are on the wire."""
    return b"".join(
        siphash(bytes([use, half]) + ground + aircraft, KEY)
        for half in (0, 1))


def has_tag(block, way, key, number, echo):
    cut = COVERED[way]
    tag = siphash(number.to_bytes(4, "big") + echo.to_bytes(4, "big")
                  + block[:cut], key)
    return block[cut:cut + TAG[way]] == tag[:TAG[way]]


def words_of(block, way):
    """The fields of 12 bits of a sealed block, and its four flags."""
    digits = block[1:2 + WORDS[way] * 3 // 2].hex()
    return ([int(digits[at:at + 3], 16)
             for at in range(0, 3 * WORDS[way], 3)], block[0] & 15)


def blocks_of(flight):
    """Each block on the wire, and which way it went."""
    return [(message.direction, bytes(message.data[1:-1]))
            for message in messages(flight.wire) if len(message.data) > 6]


@pytest.fixture(scope="module")
def flights(tmp_path_factory):
    """The same flight in both formats."""
    found = {}
    for number in (1, 2):
        folder = tmp_path_factory.mktemp(f"format{number}")
        (folder / "sticks.csv").write_text(
            script(COMMANDS, ROWS, 500), "utf-8")
        options = ["--seconds", str(SECONDS), "--sticks", "sticks.csv"]
        if number == 2:
            options += ["--format", "2", "--key",
                        str(write_key(folder / "keys"))]
        found[number] = fly_in(folder, *options)
    return found


def test_sec1_not_one_more_byte(flights):
    """32 characters up and 59 down in each frame (D-5)."""
    for flight in flights.values():
        for way, number in EXCHANGE.items():
            sent = [row for row in flight.wire if row.direction == way
                    and 1_000_000 <= row.time_us < 3_000_000]
            assert len(sent) == 100 * number


def test_sec1_what_arrives_is_the_same(flights):
    """The words of the console at the servos and in both CORE memories."""
    one, two = (
        {group: columns(flights[number], group, names)[10:]
         for group, names in (("pwm", ("left_aileron", "throttle")),
                              ("mcs.uplink", COMMANDS),
                              ("gsc.downlink", ("alpha", "airspeed")))}
        for number in (1, 2))
    assert len(set(one["mcs.uplink"])) > 190
    assert one == two
    assert two["mcs.uplink"][-1] == tuple(ROWS[-1])
    for flight in flights.values():
        assert not any("refused" in event for event in flight.summary["events"])


def test_sec3_the_wire_is_what_the_page_says(flights):
    """Hellos until both nonces are told; then blocks have the numbers of
    their sender's frames, and echo the newest number of the other node."""
    blocks = blocks_of(flights[2])
    hellos = [(way, block) for way, block in blocks if block[0] == 0xB0]
    sealed = [(way, block) for way, block in blocks if block[0] >> 4 == 0xA]
    assert len(hellos) + len(sealed) == len(blocks)
    nothing = bytes(8)
    for way, block in hellos:
        assert has_tag(block, way, key_of(HELLO[way], nothing, nothing), 0, 0)
        assert block[1] == 1
    ground = next(b for way, b in hellos if way == "up")[2:10]
    answers = [b for way, b in hellos if way == "down" and any(b[10:18])]
    assert {answer[10:18] for answer in answers} == {ground}
    aircraft = answers[0][2:10]
    assert len(hellos) < 12

    keys = {way: key_of(BLOCKS[way], ground, aircraft) for way in BLOCKS}
    last, counts = {"up": 0, "down": 0}, {"up": 0, "down": 0}
    for way, block in sealed:
        if way == "up":
            told = words_of(block, way)[0][-1]
            number = last[way] + ((told >> 6) - last[way]) % 64
            code = told & 63
        else:
            assert block[44] == 0
            number = int.from_bytes(block[45:48], "big")
            code = block[43]
        peer = last["down" if way == "up" else "up"]
        echo = 0 if code == 63 else peer - (peer - code) % 63
        assert peer - echo <= 3 or not counts[way]
        assert has_tag(block, way, keys[way], number, echo)
        assert not has_tag(block, way, keys[way], number + 64, echo)
        assert not has_tag(block, way, keys[way], number, echo + 63)
        assert number - last[way] == 1 or not counts[way]
        last[way] = number
        counts[way] += 1
    assert min(counts.values()) > 200
    up = [words_of(block, "up")[0][:-1] for way, block in sealed if way == "up"]
    assert list(ROWS[-1]) == up[-1]
    assert {tuple(row) for row in ROWS} <= set(map(tuple, up))


def test_sec1_format_1_is_as_ever(flights):
    """Words of two bytes, and no block of it looks sealed: commands have 12
    bits, a downlink the mark of its frame above them (D-98)."""
    for way, block in blocks_of(flights[1]):
        assert block[0] >> 4 == {"up": 0, "down": 5}[way]
        assert len(block) == 2 * WORDS[way]


def test_sec1_faults_are_overcome(tmp_path):
    """Noise, a cut, starts of either node: no wrong words, and the servos
    follow again within as many frames as without a seal, and the three of a
    handshake where a node has lost its session."""
    (tmp_path / "sticks.csv").write_text(
        script(COMMANDS, ROWS, 4_000), "utf-8")
    (tmp_path / "faults.txt").write_text(
        "500 up ber 0.001 1000\n500 down ber 0.001 1000\n2000 cut 500\n"
        "3000 mcs reset processor\n3300 gsc reset warm\n", "utf-8")
    options = ["--seconds", "9", "--sticks", "sticks.csv",
               "--faults", "faults.txt"]
    sealed = ["--format", "2", "--key", str(write_key(tmp_path / "keys"))]
    one, two = (
        columns(fly_in(tmp_path, *options, *more), "mcs.uplink", COMMANDS)
        for more in ([], sealed))
    assert {tuple(row) for row in ROWS} <= set(two)
    assert set(two) <= set(one)
    assert two[-1] == tuple(ROWS[-1])


BAD_FILES = {
    "others may read it": ("key 1 " + KEY.hex(), 0o640, "has mode 0640"),
    "too short": ("key 1 0123", 0o600, ":1: this is not"),
    "no number": ("# keys\nkey one " + KEY.hex(), 0o600, ":2: this is not"),
    "a number too high": ("key 256 " + KEY.hex(), 0o600, ":1: this is not"),
    "more behind": (f"key 1 {KEY.hex()} x", 0o600, ":1: this is not"),
    "no key": ("# nothing\n", 0o600, "has no key"),
    "zeros": ("key 1 " + 32 * "0", 0o600, "zeros"),
    "one number twice": (f"key 1 {KEY.hex()}\nkey 1 {KEY[::-1].hex()}", 0o600,
                         ":2: the second key has the number"),
    "a line within a line": (f"# mine\rkey 1 {KEY.hex()}\n", 0o600,
                             ":1: a carriage return"),
    "three": (f"key 1 {KEY.hex()}\nkey 2 {KEY[::-1].hex()}\n"
              f"key 3 {KEY.hex()}", 0o600, ":3: a third key"),
}


@pytest.mark.parametrize("name", BAD_FILES)
def test_sec5_a_bad_file_of_keys_is_refused(tmp_path, name):
    text, mode, said = BAD_FILES[name]
    path = write_key(tmp_path / "keys", text, mode)
    result = run_program(
        tmp_path, "fly", "--format", "2", "--key", str(path))
    assert result.returncode == 2
    assert said in result.stderr and str(path) in result.stderr
    assert result.stderr.count("\n") == 1
    assert KEY.hex() not in result.stderr


def test_sec5_a_file_of_keys_may_come_from_windows(tmp_path):
    path = write_key(tmp_path / "keys", f"# mine\r\nkey 1 {KEY.hex()}\r\n")
    result = run_program(tmp_path, "fly", "--seconds", "1", "--format", "2",
                         "--key", str(path))
    assert (result.returncode, result.stderr) == (0, "")


def test_sec5_a_pipe_is_not_waited_for(tmp_path):
    os.mkfifo(tmp_path / "keys", 0o600)
    result = run_program(
        tmp_path, "fly", "--format", "2", "--key", str(tmp_path / "keys"))
    assert result.returncode == 2
    assert result.stderr.endswith("keys:1: is not a file\n")


@pytest.mark.skipif(os.geteuid() != 0, reason="only root gives files away")
def test_sec5_keys_of_another_user_are_refused(tmp_path):
    path = write_key(tmp_path / "keys")
    os.chown(path, 65534, 65534)
    result = run_program(
        tmp_path, "fly", "--format", "2", "--key", str(path))
    assert result.returncode == 2
    assert result.stderr.endswith("keys:1: belongs to another user\n")


@pytest.mark.parametrize("options, said", [
    (["--format", "2"], "--format 2 needs --key"),
    (["--key", "keys"], "--key is of no use without --format 2"),
    (["--format", "3", "--key", "keys"], "is neither 1 nor 2"),
    (["--format", "2", "--key", "nowhere"], "nowhere:1: cannot be read"),
    (["--format", "2", "--key", "/"], "is not a file"),
])
def test_sec5_options_that_make_no_sense_are_refused(tmp_path, options, said):
    result = run_program(tmp_path, "fly", *options)
    assert result.returncode == 2
    assert said in result.stderr


def test_sec5_no_key_is_in_an_output(flights):
    flight = flights[2]
    for path in flight.folder.iterdir():
        if path.name != "keys":
            data = path.read_bytes().lower()
            for half in (KEY, KEY[:8], KEY[8:]):
                assert half not in data and half.hex().encode() not in data


def test_sec2_the_script_of_tags_compares_them(tool, capsys, monkeypatch):
    """It tries a million by itself."""
    assert inspect.signature(seal_tags.main).parameters[
        "number"].default == 1_000_000
    assert seal_tags.main(2_000, 5) == 0
    assert capsys.readouterr().out == "2000 tags, all the same\n"
    monkeypatch.setattr(seal_tags, "siphash", lambda message, key: bytes(8))
    assert seal_tags.main(10, 5) == 1


def test_sec2_tags_are_those_of_a_known_library(tool):
    """As many as a second allows."""
    drawn = random.Random(17)
    cases = [(drawn.randbytes(16), drawn.randbytes(drawn.randrange(64)))
             for _ in range(20_000)]
    result = subprocess.run(
        [tool, "tags"], input="".join(
            f"{key.hex()} {message.hex()}\n" for key, message in cases),
        text=True, capture_output=True, check=True, timeout=300)
    wanted = [int.from_bytes(siphash(message, key), "little")
              for key, message in cases]
    assert [int(line) for line in result.stdout.split()] == wanted


@pytest.mark.parametrize("number", range(1, 22))
def test_sec4_an_attacked_flight_takes_nothing_late(number, tmp_path):
    """make -C evidence attack flies 2,000 of them."""
    attack.prepare(tmp_path)
    assert attack.fly(number, 7, tmp_path)[0] == []


def test_sec4_the_attacks_show_a_link_without_a_seal(tmp_path):
    attack.prepare(tmp_path)
    shown = [attack.fly(number, 7, tmp_path, ("--format", "1"))[0]
             for number in range(1, 10)]
    assert any("words too late" in line for found in shown for line in found)


def test_sec4_a_block_that_is_late_is_refused_for_that(tmp_path):
    (tmp_path / "faults.txt").write_text("1000 up replay 20 1000\n", "utf-8")
    flight = fly_in(tmp_path, "--seconds", "3", "--faults", "faults.txt",
                    "--format", "2", "--key", str(write_key(tmp_path / "keys")))
    events = [json.loads(line) for line in
              (tmp_path / "events.jsonl").read_text("utf-8").splitlines()]
    [refused] = [event for event in events if event["node"] == "mcs"
                 and event["kind"] == "block_refused"]
    assert refused["last_detail"] == 5


def test_sec1_of_100000_tries_none_is_taken(tool):
    """bin/urv_seal tries 10000000 1 is the same, longer."""
    result = subprocess.run(
        [tool, "tries", "100000", "2"], text=True, capture_output=True,
        check=False, timeout=300)
    assert result.returncode == 0, result.stdout
    assert result.stdout.endswith(" 100000 tries, 0 taken\n")
    kinds = {line.split()[0] for line in result.stdout.splitlines()[:-1]}
    assert len(kinds) == 9

# SPDX-License-Identifier: Apache-2.0
"""EXT-2, D-26: blocks of another kind than commands, from the ground's console
to the aircraft."""

import json

import pytest
from conftest import fly_in

CONFIGURE = "configure 1 2000 9000"
SET = 1 * 16 + 1
"""The first configuration, with table 1, as it is told."""
LINKED, HOLDING, ORBITING, TERMINATED = 1, 2, 3, 4


def flight_with(folder, orders, *options, sticks=None, faults=None):
    folder.mkdir(exist_ok=True)
    (folder / "orders.txt").write_text(orders, encoding="ascii")
    options = [*options, "--orders", "orders.txt"]
    for name, text in (("sticks", sticks), ("faults", faults)):
        if text:
            (folder / name).write_text(text, encoding="ascii")
            options += [f"--{name}", name]
    return fly_in(folder, "--laws", "on", *options)


def event(flight, name):
    """How often, and the last detail; nothing when it did not happen."""
    for line in flight.path("events.jsonl").read_text("utf-8").splitlines():
        said = json.loads(line)
        if f"{said['node']}.{said['kind']}" == name:
            return said["count"], said["last_detail"]
    return None


def up_bytes(flight):
    return [row.byte for row in flight.wire if row.direction == "up"]


def frames_of(flight, link):
    return flight.record["laws.link"].count(link)


@pytest.mark.parametrize("sealed", [False, True], ids=["format 1", "sealed"])
def test_ext2_a_configuration_is_taken_reported_and_flown(tmp_path, sealed):
    keys = tmp_path / "keys"
    keys.write_text(f"key 1 {bytes(range(16)).hex()}\n", encoding="ascii")
    keys.chmod(0o600)
    options = ["--format", "2", "--key", str(keys)] if sealed else []
    flight = flight_with(
        tmp_path / "f", f"1000 {CONFIGURE}\n", *options, "--seconds", "16",
        faults="4000 cut 60000\n")
    assert event(flight, "mcs.configuration_refused") is None
    assert set(flight.record["laws.configuration"]) == {0, SET}
    assert set(flight.record["laws.told_configuration"]) == {0, SET}
    # 25 silent frames, then 2 s and 9 s after the last uplink.
    assert frames_of(flight, HOLDING) == 100 - 25
    assert frames_of(flight, ORBITING) == 450 - 100
    assert flight.record["laws.link"][-1] == TERMINATED


def test_ext2_an_order_takes_one_frame_and_moves_nothing(tmp_path):
    """The bytes of one message are others; the earlier commands remain, marked
    as old, and no servo moves."""
    sticks = "time_ms,roll,throttle\n0,2100,700\n2500,2300,900\n"
    plain, ordered, unknown = (
        flight_with(tmp_path / name, orders, "--seconds", "4", sticks=sticks)
        for name, orders in (
            ("plain", "# nothing\n"), ("ordered", f"1000 {CONFIGURE}\n"),
            ("unknown", "1000 block 600 1 2 3 4 5 6 7 8 9 10 11 12\n")))
    assert event(plain, "mcs.unknown_code") is None
    assert event(unknown, "mcs.unknown_code") == (1, 0x600)
    for flight in ordered, unknown:
        differ = [place for place, (one, other) in enumerate(
            zip(up_bytes(plain), up_bytes(flight), strict=True))
            if one != other]
        assert differ and differ[-1] - differ[0] < 30
        for name in plain.record:
            if name.startswith("pwm."):
                assert flight.record[name] == plain.record[name], name
        old = [frame for frame, (one, other) in enumerate(zip(
            plain.record["mcs.uplink.error"],
            flight.record["mcs.uplink.error"], strict=True)) if one != other]
        assert len(old) == 1
        assert flight.record["mcs.uplink.error"][old[0]] == 1
        for name in plain.record:
            if name.startswith("mcs.uplink.") and "error" not in name:
                assert flight.record[name] == plain.record[name], name


@pytest.mark.parametrize("orders, sticks, why", [
    ("1000 configure 2 2000 9000", "", 2),
    ("1000 configure 1 9000 9000", "", 2),
    ("1000 configure 1 900 9000", "", 2),
    ("1000 block 400 1 1 20 90 4094 4094 4075 4005 734", "", None),
    ("1000 block 400 1 1 20 90 4094 4094 4075 4005 733", "", 1),
    ("1000 block 400 1 1 21 90 4094 4094 4075 4005 734", "", 1),
    (f"3000 {CONFIGURE}", "time_ms,switch2\n0,4095\n", 3)])
def test_ext2_it_is_taken_whole_in_range_and_while_no_law_flies(
        tmp_path, orders, sticks, why):
    flight = flight_with(tmp_path / "f", orders + "\n", "--seconds", "6",
                         sticks=sticks)
    assert event(flight, "mcs.configuration_refused") == (
        None if why is None else (1, why))
    assert flight.record["laws.configuration"][-1] == (
        SET if why is None else 0)


def test_ext2_without_laws_there_is_nothing_to_set(tmp_path):
    (tmp_path / "orders.txt").write_text(f"1000 {CONFIGURE}\n")
    flight = fly_in(tmp_path, "--seconds", "3", "--orders", "orders.txt")
    assert event(flight, "mcs.configuration_refused") == (1, 4)


BAD = [
    ("x configure 1 2 3",
     'TIME_MS: "x" is not a time from 0 to 10000000000 ms with at most three'
     " decimals"),
    ("1000 hover", 'unknown order "hover"; there are configure, block'),
    ("1000", 'unknown order ""; there are configure, block'),
    ("1000 configure 1 2000",
     'the form is "TIME_MS configure TABLE ORBIT_MS END_MS"'),
    ("1000 configure -1 2000 9000",
     'TABLE: "-1" is not a whole number from 0 to 4095'),
    ("1000 configure 1 2050 9000",
     'ORBIT_MS: "2050" is not a multiple of 100 ms'),
    ("1000 configure 1 2000 409600",
     'END_MS: "409600" is not a whole number from 0 to 409500'),
    ("1000 block", 'the form is "TIME_MS block KIND [WORD ...]", with 12'
     " words at most"),
    ("1000 block 1000", 'KIND: "1000" is not hexadecimal from 0 to fff'),
    ("1000 block 500 4096",
     'WORD: "4096" is not a whole number from 0 to 4095'),
    ("1000 block 500\n1099 block 500",
     "TIME_MS: an order comes 100 ms after the one before, or later"),
]


@pytest.mark.parametrize("orders, message", BAD)
def test_ext2_bad_orders_are_refused(urv_sim, tmp_path, orders, message):
    path = tmp_path / "orders.txt"
    path.write_text(orders + "\n", encoding="ascii")
    result = urv_sim("fly", "--orders", str(path))
    assert result.returncode == 2
    assert result.stderr == (
        f"{path}:{orders.count(chr(10)) + 1}: {message}\n")

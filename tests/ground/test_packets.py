# SPDX-License-Identifier: Apache-2.0
"""GND-1: the codec of the station's packets is that of
docs/station-packets.md, and refuses what is not such a packet."""

import random
import re
import sys
from dataclasses import replace
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "ground"))

from urv import packets  # noqa: E402
from urv.packets import (  # noqa: E402
    CardPacket, ConsoleFlags, ConsolePacket, ConsoleState, Event, FramePacket,
    LinkState, LogRow, OrderPacket, PacketError, Pilot)

PAGE = (ROOT / "docs" / "station-packets.md").read_text(encoding="utf-8")


def some_frame(version=2):
    """A packet in which each number differs from the others."""
    log = tuple(LogRow(70_000 + row, 80_000 + row, 90_000 + row, 100 + row)
                if row < 32 or version >= 2 else LogRow()
                for row in range(packets.ROWS_PER_LOG))
    empty = tuple(LogRow() for _ in range(packets.ROWS_PER_LOG))
    return FramePacket(
        run=0x01020304, sequence=0x05060708, time_us=0x020A0B0C0D0E0F10,
        downlink_age=packets.NEVER, console_state=ConsoleState.HELD,
        link_state=LinkState.LOST, console_sequence=0x11121314,
        counts=tuple(range(0x20000000, 0x20000000 + 10)),
        words=tuple(range(0x300, 0x300 + 55)), logs=(log, empty),
        version=version, status=tuple(range(0x500, 0x500 + 12)),
        pilot=Pilot.FLIES, **({} if version < 3 else {
            "downlink_frame": tuple(range(0x400, 0x400 + 10))}))


def some_console():
    return ConsolePacket(
        run=0x01020304, sequence=0x05060708, time_us=0x020A0B0C0D0E0F10,
        words=tuple(range(0x700, 0x700 + 13)),
        flags=ConsoleFlags.PILOT_FLIES)


def some_order():
    return OrderPacket(
        run=0x01020304, sequence=0x05060708, time_us=0x020A0B0C0D0E0F10,
        serial=0x111, table=0x222, orbit=0x333, end=0x444)


def some_card():
    return CardPacket(
        run=0x01020304, sequence=0x05060708, time_us=0x020A0B0C0D0E0F10,
        words=tuple(range(0x100, 0x100 + 12)))


def table_after(heading):
    """Offset and size of each name in the first table after a heading."""
    rows = {}
    for line in PAGE.split(heading, 1)[1].splitlines():
        cells = [cell.strip().strip("`") for cell in line.strip("|").split(
            "|")]
        if line.startswith("|") and cells[0].isdecimal():
            rows[cells[2]] = (int(cells[0]), int(cells[1]))
        elif rows:
            break
    return rows


def number(data, place):
    offset, size = place
    return int.from_bytes(data[offset:offset + size])


def words(data, place, size=2):
    return [number(data, (offset, size))
            for offset in range(place[0], sum(place), size)]


@pytest.mark.parametrize("version, length", [
    (1, 1108), (2, 1332), (3, 1352)])
def test_gnd1_a_frame_packet_is_laid_out_as_on_the_page(version, length):
    packet = some_frame(version)
    data = packet.encode()
    at = table_after("## Frame packet")
    assert number(data, at["magic"]) == 0x55525646
    assert number(data, at["version"]) == version
    assert number(data, at["length"]) == len(data) == length
    for name, value in (
            ("run", packet.run), ("sequence", packet.sequence),
            ("time", packet.time_us), ("downlink_age", packet.downlink_age),
            ("console_state", 2), ("link_state", 2), ("pilot", 2),
            ("console_sequence", packet.console_sequence)):
        assert number(data, at[name]) == value, name
    assert words(data, at["link counts"], 4) == list(packet.counts)
    assert tuple(words(data, at["console.*"])
                 + words(data, at["gsc.uplink.*"])
                 + words(data, at["gsc.downlink.*"])) == packet.words
    assert tuple(words(data, at["status"])) == packet.status

    row = table_after("A row of a log")
    for name, log in zip(("log of gsc", "log of mcs"), packet.logs,
                         strict=True):
        parts = [(at[name.replace("of ", "of `")], log[:32])]
        if version >= 2:
            parts.append((at[name.replace("log of ", "more of `")], log[32:]))
        for (offset, size), rows in parts:
            for which, entry in enumerate(rows):
                begin = offset + which * 14
                assert entry == LogRow(*(
                    number(data, (begin + row[field][0], row[field][1]))
                    for field in ("count", "first_frame", "last_frame",
                                  "detail")))
            assert size == 14 * len(rows)
    last = {1: "pilot", 2: "more of `mcs", 3: "gsc.frame.*"}[version]
    assert sum(at[last]) == len(data)
    if version == 3:
        assert tuple(words(data, at[last])) == packet.downlink_frame


def test_gnd1_the_second_version_begins_as_the_first_does():
    """A reader of the first format finds every word in its place."""
    first, second, third = (some_frame(each).encode() for each in (1, 2, 3))
    assert second[8:len(first)] == first[8:]
    assert third[8:len(second)] == second[8:]


def test_fti12_a_packet_has_the_frame_of_the_downlink():
    words = some_frame(3).frame_words
    assert list(words) == list(packets.FRAME_WORDS)
    assert (words["number"], words["card"], words["throttle"]) == (
        0x400, 0x401, 0x409)
    unknown = replace(some_frame(3), downlink_frame=(65_535,) * 10)
    assert set(unknown.frame_words.values()) == {None}
    assert set(some_frame(2).frame_words.values()) == {None}


def test_gnd1_a_console_packet_is_laid_out_as_on_the_page():
    packet = some_console()
    data = packet.encode()
    at = table_after("## Console packet")
    assert number(data, at["magic"]) == 0x55525643
    assert number(data, at["version"]) == 1
    assert number(data, at["length"]) == len(data) == 52
    assert number(data, at["run"]) == packet.run
    assert number(data, at["sequence"]) == packet.sequence
    assert number(data, at["time"]) == packet.time_us
    assert tuple(words(data, at["console.*"])) == packet.words
    assert number(data, at["flags"]) == 1
    assert sum(at["flags"]) == len(data)


def test_gnd35_an_order_packet_is_laid_out_as_on_the_page():
    packet = some_order()
    data = packet.encode()
    at = table_after("## Order packet")
    for name, value in (
            ("magic", 0x5552564F), ("version", 1), ("length", 34),
            ("run", packet.run), ("sequence", packet.sequence),
            ("time", packet.time_us), ("kind", 0x400), ("serial", 0x111),
            ("table", 0x222), ("orbit", 0x333), ("end", 0x444)):
        assert number(data, at[name]) == value, name
    assert sum(at["end"]) == len(data) == 34


@pytest.mark.parametrize("name, wrong", [
    ("serial", 0), ("serial", 4096), ("table", 4096), ("orbit", -1),
    ("end", 4096)])
def test_gnd35_an_order_is_of_what_a_block_can_carry(name, wrong):
    with pytest.raises(PacketError, match=f"{name} is {wrong}, not"):
        replace(some_order(), **{name: wrong}).encode()
    with pytest.raises(PacketError, match="kind 0401h, not 0400h"):
        data = some_order().encode()
        OrderPacket.decode(data[:24] + b"\4\1" + data[26:])


def test_gnd1_what_is_encoded_is_decoded():
    for version in (1, 2, 3):
        packet = some_frame(version)
        assert FramePacket.decode(packet.encode()) == packet
    assert ConsolePacket.decode(some_console().encode()) == some_console()
    assert OrderPacket.decode(some_order().encode()) == some_order()
    assert CardPacket.decode(some_card().encode()) == some_card()


def test_fti8_a_card_packet_is_laid_out_as_on_the_page():
    at = table_after("## Test card packet")
    data = some_card().encode()
    packet = some_card()
    for name, value in (
            ("magic", 0x5552564F), ("version", 1), ("length", len(data)),
            ("run", packet.run), ("sequence", packet.sequence),
            ("time", packet.time_us), ("kind", 0x500)):
        assert number(data, at[name]) == value, name
    offset, size = at["words"]
    assert size == 24 and offset + size == len(data) == 50
    assert tuple(number(data, (offset + 2 * place, 2))
                 for place in range(12)) == packet.words
    with pytest.raises(PacketError, match="kind 0501h, not 0500h"):
        CardPacket.decode(data[:24] + b"\5\1" + data[26:])
    for words in ((0,) * 11, (4_096, *range(11)), (-1, *range(11))):
        with pytest.raises(PacketError, match="there are 12 words"):
            replace(packet, words=words).encode()


def test_gnd1_link_counts_stand_in_the_page_s_order():
    counts = PAGE.split("| link count |", 1)[1].split("\n\n", 1)[0]
    assert tuple(re.findall(r"^\| `(\w+)`", counts, re.M)) == (
        packets.LINK_COUNTS)


def test_gnd1_words_have_the_names_of_the_record():
    names = {"uplink": [], "downlink": []}
    for line in (ROOT / "docs/items.md").read_text(
            encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and cells[1] in names:
            names[cells[1]].append(cells[0])
    assert list(packets.COLUMNS) == [
        *(f"console.{name}" for name in names["uplink"][:-1]),
        *(f"gsc.uplink.{name}" for name in names["uplink"]),
        *(f"gsc.downlink.{name}" for name in names["downlink"])]
    columns = some_frame().columns
    assert columns["console.roll"] == 0x300
    assert columns["gsc.downlink.error"] == 0x300 + 54


def test_gnd1_only_what_has_happened_is_an_event():
    packet = some_frame()
    happened = replace(packet, logs=(packet.logs[1], (
        *packet.logs[1][:22], LogRow(3, 10, 12, 1), *packet.logs[1][23:])))
    assert happened.events == [
        Event("mcs", "link_reset", LogRow(3, 10, 12, 1))]


@pytest.mark.parametrize("kind, packet, lengths, versions", [
    (FramePacket, some_frame(1), "1108 or 1332 or 1352", "1 or 2 or 3"),
    (FramePacket, some_frame(2), "1108 or 1332 or 1352", "1 or 2 or 3"),
    (FramePacket, some_frame(3), "1108 or 1332 or 1352", "1 or 2 or 3"),
    (ConsolePacket, some_console(), "52", "1"),
    (OrderPacket, some_order(), "34", "1"),
    (CardPacket, some_card(), "50", "1")])
def test_gnd1_another_length_magic_or_version_is_refused(
        kind, packet, lengths, versions):
    data = packet.encode()
    for spoilt, why in (
            (data[:-1], f"{len(data) - 1} bytes, not {lengths}"),
            (data + b"\0", f"{len(data) + 1} bytes, not {lengths}"),
            (b"", f"0 bytes, not {lengths}"),
            (b"X" + data[1:], "begins with 58525"),
            (data[:4] + b"\0\4" + data[6:], f"version 4, not {versions}"),
            (data[:6] + b"\0\1" + data[8:], "length field is 1 bytes")):
        with pytest.raises(PacketError, match=why):
            kind.decode(spoilt)


def test_gnd1_each_version_has_a_length_of_its_own():
    for version, other in ((1, 2), (2, 1), (3, 2), (2, 3)):
        data = some_frame(version).encode()
        with pytest.raises(PacketError, match=f"bytes of version {other}"):
            FramePacket.decode(data[:5] + bytes([other]) + data[6:])


def test_gnd1_states_that_are_none_are_refused():
    data = some_frame().encode()
    for offset, name in ((28, "ConsoleState"), (30, "LinkState"),
                         (1106, "Pilot")):
        with pytest.raises(PacketError, match=f"9 is not a {name}"):
            FramePacket.decode(
                data[:offset] + b"\0\x09" + data[offset + 2:])


def test_gnd1_console_words_are_those_of_the_converter():
    packet = some_console()
    for wrong, why in (
            (replace(packet, words=packet.words[:-1]), "12 words, not 13"),
            (replace(packet, words=(4096, *packet.words[1:])),
             "roll is 4096, not 0 to 4095"),
            (replace(packet, words=(-1, *packet.words[1:])), "roll is -1")):
        with pytest.raises(PacketError, match=why):
            wrong.encode()
    data = packet.encode()
    with pytest.raises(PacketError, match="pitch is 4096"):
        ConsolePacket.decode(data[:26] + b"\x10\0" + data[28:])
    with pytest.raises(PacketError, match="unknown flags 0003h"):
        ConsolePacket.decode(data[:-2] + b"\0\3")


def test_gnd1_numbers_that_do_not_fit_are_refused():
    with pytest.raises(PacketError):
        replace(some_frame(), sequence=2 ** 32).encode()
    with pytest.raises(PacketError):
        replace(some_console(), sequence=-1).encode()
    with pytest.raises(PacketError, match="logs are 2 of 40 rows"):
        replace(some_frame(), logs=((), ())).encode()


def test_gnd1_garbage_raises_nothing_but_a_packet_error():
    chance = random.Random(1)
    for kind, packet in ((FramePacket, some_frame(1)),
                         (FramePacket, some_frame(2)),
                         (ConsolePacket, some_console()),
                         (OrderPacket, some_order()),
                         (CardPacket, some_card())):
        good = packet.encode()
        for _ in range(2_000):
            data = bytearray(good[:chance.randrange(len(good) + 1)]
                             if chance.random() < 0.5 else good)
            for _ in range(chance.randrange(1, 20)):
                if data:
                    data[chance.randrange(len(data))] = chance.randrange(256)
            try:
                kind.decode(bytes(data))
            except PacketError:
                continue
            assert len(data) == len(good)

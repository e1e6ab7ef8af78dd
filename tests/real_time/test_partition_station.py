# SPDX-License-Identifier: Apache-2.0
"""GND-2: GSC CORE goes out in frame packets. GND-3, GND-4: sticks come in
console packets; SAF-10: a console that falls silent is held, or on the ground
neutral.
GND-5: the simulated pilot aboard the ground's partition. GND-7: the reports of
the aircraft's laws. GND-35: orders besides the sticks."""

import contextlib
import random
import re
import signal
import struct
import time
from dataclasses import replace

import pytest

from conftest import (
    COMMANDS, RanLate, TIME_LIMIT_S, assert_in_order, different_rows,
    flies_again, free_ports, in_turn, need, of_the_link, script,
    script_seconds, udp,
)
from safe_words import transformed
from station import Console, Frames, utc_us
from urv import cards
from urv.deck import Status
from urv.laws import Laws
from urv.packets import (
    CARDS_ROW, KINDS, LAWS_ROW, NEVER, ConsoleFlags, ConsoleState, LinkState,
    LogRow, Pilot,
)

STICKS = different_rows(12, len(COMMANDS), 21)
ONE, OTHER, THIRD = STICKS[:3]

# D-13: throttle idle, brake full on.
SAFE = (0x800, 0x800, 0x800, 0, 0xFFF) + (0,) * 8

STALE = 1

# The bench's aircraft is on the ground; without this it flies at 64 kt and
# 1024 ft.
ON_GROUND = "time_ms,airspeed,altitude\n0,0,0\n"

# A row is taken two ticks after its scan and as late as the machine is.
FRAME_US = 20_000


@pytest.fixture
def station():
    """Makes a new station for each flight of a test."""
    made = []

    def make(kind):
        made.append(Frames() if kind is Frames else Console(*free_ports(1)))
        return made[-1]

    yield make
    for each in made:
        each.close()


def sticks_of(packet):
    return packet.words[:len(COMMANDS)]


def assert_like_the_record(packets, rows):
    """Every row was sent once, unchanged."""
    sent = {packet.sequence: packet for packet in packets}
    assert len(sent) == len(packets)
    assert [packet.sequence for packet in packets] == sorted(sent)
    assert len({packet.run for packet in packets}) == 1
    for row in rows:
        packet = sent[row["frame"]]
        for name, word in packet.columns.items():
            assert word == row[name], (name, packet.sequence)
        for name, column in (
                ("uplink_sent", "link.uplink_sent"),
                ("uplink_scrapped", "link.uplink_scrapped"),
                ("downlink_received", "link.downlink_received"),
                ("downlink_bad", "link.downlink_bad"),
                ("resets", "link.gsc_resets"), ("overruns", "overruns")):
            assert packet.link[name] == row[column]


@flies_again
def test_gnd2_the_published_words_are_the_record_s(start_both, write, station):
    frames = station(Frames)
    sticks = write("sticks.csv", script(COMMANDS, STICKS))
    seconds = script_seconds(STICKS)
    again = station(Frames)
    begun_us = utc_us()
    mcs, gsc = start_both(
        mcs=("--seconds", seconds),
        gsc=("--seconds", seconds, "--sticks", sticks,
             "--publish", frames.place, "--publish", again.place))
    mcs, gsc = mcs.end(), gsc.end()
    frames.finish()
    again.finish()
    need(gsc.summary["rows_left_out"] == gsc.summary["publish_not_sent"] == 0,
         gsc)
    assert_like_the_record(frames.all, gsc.rows)
    assert_like_the_record(again.all, gsc.rows)
    assert {packet.version for packet in frames.all} == {1}
    times = [packet.time_us for packet in frames.all]
    assert begun_us < times[0] and times == sorted(times)
    assert times[-1] < utc_us()
    need(gsc.rows[-1]["frame"] > 50, gsc)
    assert all(packet.console_state == ConsoleState.NONE
               and packet.pilot == Pilot.NONE for packet in frames.all)


@flies_again
def test_gnd2_the_downlink_s_age_and_the_link_state_are_reported(start, station):
    frames = station(Frames)
    ground, aircraft = free_ports(2)
    gsc = start("gsc", udp(ground, aircraft), "--publish", frames.place)
    frames.wait_for(5)
    mcs = start("mcs", udp(aircraft, ground))
    frames.wait_until(lambda packet: packet.is_fresh)
    frames.wait_for(20)
    mcs.stop()
    frames.wait_until(lambda packet: packet.link_state == LinkState.LOST)
    outputs = gsc.stop()

    fresh_at, received, heard_at = None, 0, None
    # The node judges what it has received two frames later (RTP-7).
    heard = [None, None]
    for packet in frames.all:
        link = packet.link
        if link["downlink_received"] != received:
            received, heard_at = link["downlink_received"], packet.sequence
        heard.append(heard_at)
        judged = heard[-3]
        if received and not packet.columns["gsc.downlink.error"] & STALE:
            fresh_at = packet.sequence
        age = NEVER if fresh_at is None else packet.sequence - fresh_at
        assert packet.downlink_age == age
        assert packet.link_state == (
            LinkState.NEVER_HEARD if judged is None
            else LinkState.LOST if packet.sequence > judged + 50
            else LinkState.HEARD)
    assert frames.all[0].downlink_age == NEVER
    need(frames.all[-1].downlink_age > 50, outputs)


@flies_again
def test_gnd2_the_error_logs_of_both_nodes_are_reported(start_both, station):
    frames = station(Frames)
    mcs, gsc = start_both(gsc=("--publish", frames.place))
    frames.wait_until(lambda packet: packet.is_fresh)
    mcs.send(signal.SIGUSR2)
    told = frames.wait_until(lambda packet: any(
        (event.node, event.kind) == ("mcs", "warm_reset")
        for event in packet.events))
    mcs, gsc = mcs.stop(), gsc.stop()
    for event in told.events:
        log = (mcs if event.node == "mcs" else gsc).events[event.kind]
        assert event.row.first_frame == log["first_frame"]
        assert event.row.count <= log["count"]
        assert event.row.last_frame <= log["last_frame"]
    assert mcs.events["warm_reset"]["count"] == 1
    assert told.core_status["cold_starts"] == 1


# The simple plant has no engine: after some six seconds the laws report that
# its throttle is not followed.
@pytest.mark.parametrize("options, may_have_failed", [
    (("--laws", "on"), ("throttle",)), (("--plant", "jsbsim"), ())],
    ids=["asked", "jsbsim"])
@flies_again
def test_gnd7_the_second_version_has_the_laws_report(
    start_both, station, options, may_have_failed
):
    """And the rows of an error log that the first has no room for. With
    JSBSim the laws are on unless they are told not to be."""
    frames = station(Frames)
    mcs, gsc = start_both(
        mcs=options,
        gsc=("--packets", "2", "--publish", frames.place))
    linked = Laws("direct", "direct", "direct", "linked", (), 0, ())

    def shows(packet):
        laws = Laws.of(packet)
        return laws is not None and replace(laws, age=0) in (
            linked, replace(linked, failed=may_have_failed))

    came = frames.show_within(500, shows)
    told = frames.all[-1]
    mcs, gsc = mcs.stop(), gsc.stop()
    frames.finish()
    need(came, mcs, gsc)
    assert told.version == 2
    # The record has the same, by the names that the simulation's has.
    sent = {packet.sequence: packet.logs[1][LAWS_ROW - 1]
            for packet in frames.all}
    columns = [f"laws.told{name}" for name in (
        "", "_invalid_low", "_invalid_high", "_silent", "_failed",
        "_configuration")]
    assert {row["laws.told"] for row in gsc.rows} > {0}
    # The aircraft's log has the same, of its own knowledge: nothing else comes
    # down.
    own = ("lateral", "vertical", "power", "link", "invalid_low",
           "invalid_high", "silent", "failed", "configuration")
    assert [name for name in mcs.rows[0] if name.startswith("laws.")] == [
        f"laws.{name}" for name in own]
    said = {sum(row[f"laws.{name}"] << 4 * place
                for place, name in enumerate(own[:4])) for row in mcs.rows}
    assert {row["laws.told"] for row in gsc.rows} <= said | {0}
    for row in gsc.rows:
        if row["frame"] in sent:
            words = sent[row["frame"]]
            assert [row[name] for name in columns] == [
                words.count >> 16, words.count & 0xFFFF,
                words.first_frame >> 16, words.first_frame & 0xFFFF,
                words.last_frame >> 16, words.detail], row["frame"]
    for row in told.logs[1][len(KINDS):LAWS_ROW - 1] + told.logs[0][
            len(KINDS):]:
        assert row == LogRow()


@flies_again
def test_gnd2_a_node_whose_frames_nobody_takes_flies_on(start_both):
    closed, = free_ports(1)
    place = ("--publish", f"udp:127.0.0.1:{closed}")
    mcs, gsc = start_both(mcs=("--seconds", 1),
                          gsc=("--seconds", 1, *place))
    mcs, gsc = mcs.end(), gsc.end()
    need(gsc.summary["frames"] == 50, gsc)
    need(gsc.summary["link"]["downlink_received"] > 40, gsc, mcs)


@flies_again
def test_gnd3_a_moved_stick_reaches_the_servos(start_both, station):
    frames = station(Frames)
    console = station(Console)
    mcs, gsc = start_both(
        gsc=("--publish", frames.place, "--console", console.place))
    frames.wait_until(lambda packet: packet.is_fresh)
    for words in STICKS:
        console.move(words)
        frames.wait_until(lambda packet: sticks_of(packet) == words)
        frames.wait_for(10)
    mcs, gsc = mcs.stop(), gsc.stop()
    frames.finish()

    for packet in frames.all:
        if packet.console_sequence:
            sent = console.sent[packet.console_sequence]
            assert sticks_of(packet) == sent.words
            assert packet.console_state in (
                ConsoleState.LIVE, ConsoleState.HELD)
        else:
            assert sticks_of(packet) == SAFE
            assert packet.console_state == ConsoleState.HELD
    assert_like_the_record(frames.all, gsc.rows)

    expected = [tuple(transformed(words)) for words in (SAFE, *STICKS)]
    servos = in_turn([
        tuple(word for name, word in row.items() if name.startswith("pwm."))
        for row in mcs.rows])
    need(expected[0] in servos, mcs, gsc)
    servos = servos[servos.index(expected[0]):]
    assert gsc.summary["console"]["neutral"] == 0
    assert_in_order(servos, expected)
    need(servos == expected, mcs, gsc)


@flies_again
def test_gnd4_saf10_a_silent_console_is_held_while_the_aircraft_may_fly(
    start_both, station
):
    """Nothing fresh goes up, however long it lasts, before the first packet
    and after the last. Nobody waits for a time: the frames are counted."""
    frames = station(Frames)
    console = station(Console)
    mcs, gsc = start_both(
        mcs=("--laws", "on"),
        gsc=("--publish", frames.place, "--console", console.place))
    frames.wait_until(lambda packet: packet.is_fresh)
    frames.wait_for(120)
    console.move(ONE)
    frames.wait_until(
        lambda packet: packet.columns["gsc.uplink.roll"] == ONE[0])
    last = console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.HELD)
    frames.wait_for(250)
    console.move(OTHER)
    frames.wait_until(
        lambda packet: packet.columns["gsc.uplink.roll"] == OTHER[0])
    mcs, gsc = mcs.stop(), gsc.stop()
    frames.finish()

    assert {packet.console_state for packet in frames.all} == {
        ConsoleState.HELD, ConsoleState.LIVE}
    assert gsc.summary["console"]["neutral"] == 0
    # The scan of a frame is in the next frame's uplink.
    for before, packet in zip(frames.all, frames.all[1:]):
        if (before.console_state == ConsoleState.HELD
                and packet.sequence == before.sequence + 1):
            assert packet.columns["gsc.uplink.error"] & STALE, packet.sequence
    held = [packet for packet in frames.all
            if packet.console_sequence == last.sequence
            and packet.console_state == ConsoleState.HELD]
    need(len(held) >= 200, gsc)
    # The aircraft makes of it what it makes of a lost link.
    lost = [row for row in mcs.rows if row["laws.link"] in (2, 3)]
    assert lost and {row["laws.link"] for row in mcs.rows} >= {0, 1, 2}
    assert all(row["mcs.uplink.error"] & STALE for row in lost[:100])
    assert not [row for row in lost if row["pwm.brake"] == 0xFFF]


@flies_again
def test_gnd4_saf10_a_silent_console_is_neutral_on_the_ground(
    start_both, station, write
):
    frames = station(Frames)
    console = station(Console)
    mcs, gsc = start_both(
        mcs=("--sensors", write("sensors.csv", ON_GROUND)),
        gsc=("--publish", frames.place, "--console", console.place))
    begun = frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.NEUTRAL)
    assert not [packet for packet in frames.all
                if packet.console_state == ConsoleState.LIVE]
    console.move(ONE)
    frames.wait_until(
        lambda packet: packet.columns["gsc.uplink.roll"] == ONE[0])
    console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.NEUTRAL
        and packet.sequence > begun.sequence)
    frames.wait_for(100)
    mcs, gsc = mcs.stop(), gsc.stop()
    frames.finish()
    need(gsc.summary["console"]["neutral"] == 1, gsc)
    assert sticks_of(frames.all[-1]) == SAFE
    fresh = [row for row in gsc.rows[-50:]
             if not row["gsc.uplink.error"] & STALE]
    need(len(fresh) > 40, gsc)
    assert {(row["pwm.throttle"], row["pwm.brake"])
            for row in mcs.rows[-20:]} == {(0, 0xFFF)}


@flies_again
def test_gnd4_a_silent_console_is_reported(start, station, write):
    frames = station(Frames)
    console = station(Console)
    ports = free_ports(2)
    start("mcs", udp(*ports),
          "--sensors", write("sensors.csv", ON_GROUND))
    gsc = start("gsc", udp(*reversed(ports)), "--publish", frames.place,
                "--console", console.place, quiet=False)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.NEUTRAL)
    console.move(ONE)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.LIVE)
    last = console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.NEUTRAL)
    console.move(OTHER)
    frames.wait_until(lambda packet: sticks_of(packet) == OTHER)
    gsc.send(signal.SIGTERM)
    _, said = gsc.program.communicate(timeout=TIME_LIMIT_S)
    outputs = gsc.outputs
    frames.finish()

    states = in_turn([packet.console_state for packet in frames.all])
    if ConsoleState.HELD not in states[2:] or len(states) > 6:
        # The machine or the console's own thread stood still.
        raise RanLate
    assert states == [ConsoleState.HELD, ConsoleState.NEUTRAL,
                      ConsoleState.LIVE,
                      ConsoleState.HELD, ConsoleState.NEUTRAL,
                      ConsoleState.LIVE]
    live = next(place for place, packet in enumerate(frames.all)
                if packet.console_state == ConsoleState.LIVE)
    for state, words, after_s in ((ConsoleState.HELD, ONE, 0.5),
                                  (ConsoleState.NEUTRAL, SAFE, 2)):
        first = next(packet for packet in frames.all[live:]
                     if packet.console_state == state)
        silent_us = first.time_us - last.time_us
        assert silent_us >= after_s * 1_000_000
        need(silent_us <= after_s * 1_000_000 + 2 * FRAME_US, outputs)
        assert sticks_of(first) == words
    held = [packet for packet in frames.all[live:]
            if packet.console_state == ConsoleState.HELD]
    assert {sticks_of(packet) for packet in held} == {ONE}
    assert {packet.console_sequence for packet in held} == {last.sequence}

    # It is said, it is counted, and it is among the events.
    lines = [line for line in of_the_link(said) if "console" in line]
    for line, what in zip(lines, (
            "console held at .*: no packet yet, nothing fresh goes up",
            "console neutral at .*: no packet yet, the aircraft is on the"
            " ground", "console live at",
            "console held at .*: no packet for 0.5 s, nothing fresh goes up",
            "console neutral at .*: no packet for 2 s, the aircraft is on the"
            " ground", "console live at"), strict=True):
        assert re.search(what, line), line
    counted = outputs.summary["console"]
    assert (counted["held"], counted["neutral"]) == (1, 1)
    # The node goes on while its outputs are written.
    flown = [packet for packet in frames.all
             if packet.sequence < outputs.summary["frames"]]
    assert (flown[-1].link["console_packets"] <= counted["packets"]
            <= len(console.sent))
    for kind, packet in (("console_held", held[0]),):
        event = outputs.events[kind]
        assert event["count"] == 1
        assert abs(event["first_frame"] - packet.sequence) <= 1
    assert outputs.events["console_neutral"]["count"] == 1


def wrong_packets(console):
    """Packets that are no console packets, each with its reason."""
    good = console.send(sequence=1).encode()
    now = utc_us()

    def put(offset, form, value):
        data = bytearray(good)
        struct.pack_into(">I", data, 12, 1_000_000)
        struct.pack_into(">Q", data, 16, now)
        struct.pack_into(f">{form}", data, offset, value)
        return bytes(data)

    yield "magic", put(0, "I", 0x55525646)
    yield "version", put(4, "H", 2)
    yield "length told", put(6, "H", 51)
    yield "another run", put(8, "I", 99)
    yield "sequence 0", put(12, "I", 0)
    yield "old sequence", put(12, "I", 1)
    yield "old", put(16, "Q", now - 2_000_000)
    yield "of the future", put(16, "Q", now + 60_000_000)
    yield "time 0", put(16, "Q", 0)
    yield "last time", put(16, "Q", 2 ** 64 - 1)
    for place in range(13):
        yield f"word {place}", put(24 + 2 * place, "H", 0x1000)
    yield "flags", put(50, "H", 2)
    yield "short", put(0, "I", 0x55525643)[:-1]
    yield "long", put(0, "I", 0x55525643) + b"\0"


def test_gnd3_what_is_no_console_packet_is_counted_and_dropped(
    start, station
):
    frames = station(Frames)
    console = station(Console)
    gsc = start("gsc", udp(*free_ports(2)), "--publish", frames.place,
                "--console", console.place)
    # The record begins with the second scan: all is as it was then.
    frames.wait_for(3)
    console.move(ONE)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.LIVE)
    begun = len(frames.all) - 1
    bad = frames.all[-1].link["console_bad"]
    chance = random.Random(3)
    cases = [*wrong_packets(console), ("empty", b""), *(
        (f"{length} bytes", chance.randbytes(length))
        for length in (1, 8, 51, 52, 53, 104, 105, 1_400, 9_000))]
    # The good one that they are made from is an old one.
    bad += 1
    for why, data in cases:
        console.send_bytes(data)
        bad += 1
        found = frames.wait_until(
            lambda packet: packet.link["console_bad"] >= bad)
        assert found.link["console_bad"] == bad, why
    for packet in frames.all[begun:]:
        assert sticks_of(packet) in (ONE, SAFE)
        if packet.console_state == ConsoleState.LIVE:
            assert sticks_of(packet) == ONE
    outputs = gsc.stop()
    assert outputs.summary["console"]["bad"] == bad


@flies_again
def test_gnd59_a_packet_of_the_future_has_no_age_and_is_dropped(
    start, station
):
    """A third of a second ahead of the machine's clock."""
    frames = station(Frames)
    console = station(Console)
    gsc = start("gsc", udp(*free_ports(2)), "--publish", frames.place,
                "--console", console.place)
    frames.wait_for(3)
    console.move(ONE)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.LIVE)
    last = console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.HELD)
    bad = frames.all[-1].link["console_bad"]
    sent = []
    for ahead_us in (400_000, 300_000, 100_000):
        console.words = OTHER
        sent.append(console.send(time_us=utc_us() + ahead_us))
        console.words = None
        bad += 1
        frames.wait_until(
            lambda packet: packet.link["console_bad"] >= bad
            or packet.console_sequence != last.sequence)
    outputs = gsc.stop()
    need(outputs.summary["console"]["bad"] == bad, outputs)
    need({packet.console_sequence for packet in frames.all}.isdisjoint(
        {packet.sequence for packet in sent}), outputs)


def test_gnd3_the_first_console_keeps_the_sticks_while_it_is_there(
    start, station
):
    frames = station(Frames)
    console = station(Console)
    gsc = start("gsc", udp(*free_ports(2)), "--publish", frames.place,
                "--console", console.place)
    frames.wait_for(3)
    console.move(ONE)
    frames.wait_until(lambda packet: sticks_of(packet) == ONE)
    second = Console(int(console.place.rpartition(":")[2]), run=2)
    second.move(OTHER)
    frames.wait_until(lambda packet: packet.link["console_bad"] >= 20)
    first = console.fall_silent()
    taken = frames.wait_until(lambda packet: sticks_of(packet) == OTHER)
    second.close()
    gsc.stop()
    silent = next(packet for packet in frames.all
                  if sticks_of(packet) == OTHER)
    assert taken.console_state == ConsoleState.LIVE
    # The console's own thread may have stood still; never is it earlier.
    gap_us = silent.time_us - first.time_us
    sent = sorted(packet.time_us for packet in console.sent.values())
    longest = max(later - earlier for earlier, later in zip(sent, sent[1:]))
    assert gap_us >= 500_000 or longest >= 400_000


def test_gnd5_the_pilot_flies_until_a_console_takes_the_sticks(
    start_both, station
):
    frames = station(Frames)
    console = station(Console)
    mcs, gsc = start_both(gsc=(
        "--publish", frames.place, "--console", console.place,
        "--pilot", "level"))
    begun = frames.wait_until(lambda packet: packet.pilot == Pilot.FLIES)
    assert sticks_of(begun) != SAFE
    console.move(ONE)
    frames.wait_until(lambda packet: packet.pilot == Pilot.HANDS_OFF)
    frames.wait_for(5)
    console.move(OTHER, ConsoleFlags.PILOT_FLIES)
    frames.wait_until(lambda packet: packet.pilot == Pilot.FLIES)
    frames.wait_for(5)
    console.move(THIRD)
    frames.wait_until(lambda packet: sticks_of(packet) == THIRD)
    # It flies on when a console that has handed over falls silent.
    console.move(OTHER, ConsoleFlags.PILOT_FLIES)
    frames.wait_until(lambda packet: packet.pilot == Pilot.FLIES)
    console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.HELD
        and packet.pilot == Pilot.FLIES)
    frames.wait_for(60)
    mcs.stop()
    gsc = gsc.stop()
    frames.finish()
    assert_like_the_record(frames.all, gsc.rows)
    for packet in frames.all:
        if packet.pilot == Pilot.FLIES:
            assert packet.console_sequence == 0
            assert sticks_of(packet) not in (ONE, OTHER, THIRD)
        else:
            assert packet.pilot == Pilot.HANDS_OFF
            assert sticks_of(packet) in (ONE, THIRD, SAFE)


REFUSED = KINDS.index("configuration_refused")


def configured(packet):
    """Number and table of the configuration that the aircraft has."""
    told = Laws.of(packet)
    return told and (told.serial, told.table)


def taken(frames, console, flown, serial, table, *times):
    """An order, sent again until the aircraft reports it: a late machine may
    lose the block with the order, and the aircraft's report."""
    for _ in range(10):
        order = console.order(serial, table, *times)
        if frames.show_within(
                50, lambda packet: configured(packet) == (serial, table)):
            return order
    return need(False, *(run.stop() for run in flown))


@flies_again
def test_gnd35_orders_of_a_file_go_up_in_their_time(
    start_both, station, write
):
    frames = station(Frames)
    orders = write("orders.txt", "500 configure 1 2000 9000\n"
                   "600 configure 7 2000 9000\n700 block 600 1 2\n")
    mcs, gsc = start_both(
        mcs=("--laws", "on"),
        gsc=("--packets", "2", "--publish", frames.place, "--orders", orders))
    # A machine that is late may lose the one block that an order goes up in.
    came = frames.show_within(
        500, lambda packet: configured(packet) == (1, 1)
        and packet.logs[1][REFUSED].count)
    told = frames.all[-1]
    mcs, gsc = mcs.stop(), gsc.stop()
    need(came, mcs, gsc)
    assert gsc.summary["orders_sent"] == 3
    assert told.logs[1][REFUSED].detail == 2
    need("configuration_refused" in mcs.events
         and "unknown_code" in mcs.events, mcs, gsc)
    assert mcs.events["unknown_code"]["last_detail"] == 0x600
    assert mcs.events["configuration_refused"]["count"] == 1


CARD = cards.Card(slot=2, kind="doublet", surfaces=cards.AXES["pitch"],
                  amplitude=100, time=50, bank=30)


def card_words(frames):
    """The words of the card in slot 2, as far as they were reported."""
    found = {}
    for packet in frames.all:
        row = packet.logs[1][CARDS_ROW - 1]
        place, first = divmod(row.first_frame, 1 << 16)
        found[place] = (first, *divmod(row.last_frame, 1 << 16), row.detail)
    return tuple(word for part in range(3)
                 for word in found.get(2 * 16 + part, ()))


@flies_again
def test_fti8_a_card_of_the_console_goes_up_and_is_read_back(
    start_both, station
):
    """One with a wrong sum does not leave the ground."""
    frames = station(Frames)
    console = station(Console)
    mcs, gsc = start_both(
        mcs=("--laws", "on"),
        gsc=("--packets", "2", "--publish", frames.place,
             "--console", console.place))
    console.move(ONE[:5] + (0,) * 8)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.LIVE
        and packet.is_fresh)
    bad = frames.all[-1].link["console_bad"]
    console.card((*CARD.words()[:11], CARD.words()[11] ^ 1))
    frames.wait_until(lambda packet: packet.link["console_bad"] > bad)
    for _ in range(10):
        console.card(CARD.words())
        if frames.show_within(
                100, lambda packet: packet.logs[1][CARDS_ROW - 1].count):
            break
    came = frames.show_within(
        2_000, lambda packet: card_words(frames)[:11] == CARD.words()[:11])
    need(came, mcs.stop(), gsc.stop())
    assert Status.of(frames.all[-1].logs[1][CARDS_ROW - 1]).chosen == 2


@flies_again
def test_gnd35_orders_of_the_console_that_has_the_sticks_go_up(
    start_both, station, write
):
    """Those of another one are dropped while its packets come, and so is what
    is no order, an old one, and one that comes again."""
    frames = station(Frames)
    console = station(Console)
    # In flight a lost console has a law fly, and no order is taken.
    mcs, gsc = start_both(
        mcs=("--laws", "on", "--sensors", write("sensors.csv", ON_GROUND)),
        gsc=("--packets", "2", "--publish", frames.place,
             "--console", console.place))
    console.move(ONE[:5] + (0,) * 8)
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.LIVE
        and packet.is_fresh)
    good = taken(frames, console, (mcs, gsc), 5, 1, 20, 90)
    bad = frames.all[-1].link["console_bad"]
    later = len(console.sent) + 10_000
    for why, data in (
            ("again", good.encode()),
            ("short", good.encode()[:-1]),
            ("another run", replace(good, run=9, sequence=later,
                                    time_us=utc_us()).encode()),
            ("old", replace(good, sequence=later).encode())):
        if why == "old":
            time.sleep(0.6)
        console.send_bytes(data)
        bad += 1
        frames.wait_until(
            lambda packet, bad=bad: packet.link["console_bad"] >= bad)
        need(frames.all[-1].link["console_bad"] == bad)
    # When nobody has the sticks, who is there may order.
    console.fall_silent()
    frames.wait_until(
        lambda packet: packet.console_state == ConsoleState.HELD)
    port = int(console.place.rpartition(":")[2])
    with contextlib.closing(Console(port, run=2)) as other:
        taken(frames, other, (mcs, gsc), 6, 0, 30, 80)
    mcs, gsc = mcs.stop(), gsc.stop()
    assert gsc.summary["orders_sent"] >= 2
    need("configuration_refused" not in mcs.events, mcs, gsc)

# SPDX-License-Identifier: Apache-2.0
"""bin/urv station without a browser: frames, sticks, who may what."""

import contextlib
import dataclasses
import itertools
import logging
import random
import re
import socket
import struct
import threading
import time
from pathlib import Path

import pytest
import websocket
from aiohttp.http_exceptions import BadHttpMethod
from fake_node import recording_of
from station_rig import PATIENCE_S, Station, moved, until

from urv import cards, deck, door, items, laws, packets, recordings, web
from urv.alerts import Alerts
from urv.controls import Controls
from urv.processes import Report
from urv.sticks import ASKED_S, LAPSED_S, SILENT_S, Sticks
from urv.view import View

ROOT = Path(__file__).resolve().parents[2]

WORDS = (3000, 2048, 2048, 2048, 2048, *[0] * 8)

# The effects of a machine that runs the simulated node late.
OF_THE_MACHINE = ("FRAMES", "NO FRAMES", "FRAMES LATE", "LINK LOST",
                  "SENSORS OLD")


def of_the_test(state):
    """The alerts, without those."""
    return [alert for alert in state["alerts"]
            if alert["name"] not in OF_THE_MACHINE]


@pytest.fixture
def record(standard):
    return standard / "record.csv"


@pytest.fixture
def station(record, tmp_path):
    with Station(record, tmp_path) as station:
        station.flying()
        yield station


# The holder of the sticks

def test_gnd21_the_first_page_that_takes_them_has_them():
    sticks = Sticks()
    sticks.take(1, 0.0)
    assert sticks.holder == 1
    assert sticks.move(1, WORDS, 0.1)
    assert not sticks.move(2, WORDS, 0.1)
    assert sticks.live(0.1) == WORDS


def test_gnd21_the_holder_is_asked_and_may_keep_them():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    sticks.take(2, 1.1)
    assert (sticks.holder, sticks.asker) == (1, 2)
    sticks.answer(2, True, 1.2)
    assert sticks.holder == 1, "who asks cannot answer"
    sticks.answer(1, False, 1.3)
    assert (sticks.holder, sticks.asker) == (1, None)
    sticks.move(1, WORDS, 1.4)
    sticks.take(2, 1.5)
    sticks.answer(1, True, 1.6)
    assert sticks.holder == 2


def test_gnd21_no_answer_gives_them_after_five_seconds():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    sticks.take(2, 1.0)
    for tenth in range(10, int((1.0 + ASKED_S) * 10)):
        sticks.move(1, WORDS, tenth / 10)
        sticks.tick(tenth / 10)
        assert sticks.holder == 1
    sticks.tick(1.0 + ASKED_S)
    assert sticks.holder == 2
    assert sticks.live(1.0 + ASKED_S) is None, (
        "the words of the last holder are not the next one's")


def test_gnd21_a_third_does_not_push_in():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    sticks.take(2, 1.0)
    sticks.take(3, 1.1)
    assert sticks.asker == 2


def test_gnd21_release_never_asks_and_a_lapsed_holder_is_not_asked():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    sticks.release(1, "released")
    assert sticks.holder is None and sticks.live(1.0) is None
    sticks.take(1, 2.0)
    sticks.move(1, WORDS, 2.0)
    sticks.take(2, 2.1 + LAPSED_S)
    assert sticks.holder == 2


def test_gnd21_the_page_that_asked_gets_them_when_the_holder_goes():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    sticks.take(2, 1.1)
    sticks.release(1, "its page has closed")
    sticks.tick(1.2)
    assert sticks.holder == 2


def test_gnd22_a_silent_or_paused_holder_is_not_live():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0)
    assert sticks.live(1.0 + SILENT_S - 0.001) == WORDS
    assert sticks.live(1.001 + SILENT_S) is None
    sticks.move(1, WORDS, 2.0)
    sticks.pause(1)
    assert sticks.live(2.0) is None


def test_gnd21_over_sockets_a_second_console_cannot_take_them(station):
    first, second = station.console(), station.console()
    first.take()

    def both():
        first.sticks(3000)
        second.sticks(100)

    def is_asked():
        both()
        second.say({"t": "take"})
        return any(f"console {second.number} asks console {first.number}"
                   in line["text"] for line in station.lines())

    for _ in range(150):
        both()
        time.sleep(0.005)
    until(is_asked, "the question", pause=0.05)
    assert {packet.words[0] for _, packet in station.node.heard} == {3000}
    # The holder says nothing more: the sticks go to who asked.
    second.until(lambda state: state["holder"] == second.number,
                 "the sticks after five seconds")
    station.logged(f"console {second.number} has the sticks")


def test_gnd21_the_sticks_of_a_closed_page_are_free(station):
    first, second = station.console(), station.console()
    first.take()
    first.close()
    second.until(lambda state: state["holder"] is None, "free sticks")
    second.take()


def test_gnd22_packets_stop_when_the_holder_falls_silent(station):
    console = station.console()
    console.take()
    for _ in range(40):
        console.sticks(2500)
        time.sleep(0.01)
    until(lambda: station.node.heard, "a console packet")
    # The station has taken all of them when it has taken what follows.
    console.say({"t": "mark", "text": "silent now"})
    station.logged("silent now")
    sent = station.wait(lambda state: not state["live"],
                        "silence")["station"]["sent"]
    state = station.wait(lambda state: state["console"] == "held",
                         "held sticks")
    assert not state["live"]
    state = station.wait(lambda state: state["console"] == "neutral")
    assert state["station"]["sent"] == sent, "nothing more goes up"
    assert {"STICKS HELD", "STICKS NEUTRAL"} <= {
        alert["name"] for alert in state["alerts"]}


def test_gnd22_packets_stop_and_silence_is_reported_within_half_a_second():
    now, sent = 0.0, []
    controls = Controls(View(now=lambda: now), lambda _: sent.append(now),
                        now=lambda: now)
    controls.hears(1, {"t": "take"})
    for frame in range(100):
        now = frame * packets.FRAME_S
        if frame <= 50:
            controls.hears(1, {"t": "sticks", "words": WORDS})
        controls.tick()
        silent = now - 50 * packets.FRAME_S
        told = controls.view.alerts.active("PAGE SILENT")
        assert told <= (silent > SILENT_S), "told too early"
        assert told or silent < 0.5, "told too late"
    assert 50 * packets.FRAME_S <= sent[-1] <= 1.0 + SILENT_S


def test_gnd22_a_holder_that_is_silent_or_closed_is_a_caution(station):
    """On every page, within half a second, which frames count."""
    first, other = station.console(), station.console()
    first.take()
    for _ in range(20):
        first.sticks()
        time.sleep(0.02)

    def alert(name):
        def look(state):
            return [alert for alert in state["alerts"]
                    if alert["name"] == name and alert["active"]]
        return look
    station.wait(alert("PAGE SILENT"), "a caution")
    until(lambda: "PAGE SILENT" in {
        each["name"] for each in other.next("alerts")["alerts"]}, "the alert")
    first.insist(moved(2048), lambda state: not alert("PAGE SILENT")(
        station.state()), "its end")
    station.logged(f"console {first.number} flies again after")
    first.close()
    state = station.wait(alert("PAGE CLOSED"), "a caution")
    assert state["holder"] is None
    # It lasts until somebody flies.
    other.take()
    assert alert("PAGE CLOSED")(station.state())
    other.insist(moved(2048), lambda state: not alert("PAGE CLOSED")(
        station.state()), "its end")


@pytest.mark.parametrize(("what", "name"),
                         [("hidden", "HIDDEN"), ("gamepad", "GAMEPAD"),
                          ("hung", "BROWSER HUNG")])
def test_gnd22_a_hidden_page_or_lost_gamepad_is_a_caution(
        station, what, name):
    console = station.console()
    console.take()
    console.sticks()
    console.say({"t": "lost", "what": what})
    state = station.wait(lambda state: name in {
        alert["name"] for alert in of_the_test(state)}, "an alert")
    [alert] = [alert for alert in of_the_test(state)
               if alert["name"] == name]
    assert (alert["level"], alert["active"]) == ("caution", True)
    station.sends_nothing(state)

    def over(state):
        return not [alert for alert in state["alerts"]
                    if alert["name"] == name and alert["active"]]
    console.insist(moved(2048), lambda _: over(station.state()),
                   "the end of it")
    # A node that has gone cannot be hidden any more.
    console.say({"t": "lost", "what": what})
    station.wait(lambda state: not over(state), "the caution again")
    console.close()
    station.wait(over, "the end of it")


def test_gnd29_the_simulated_pilot_takes_over_and_gives_back(
        record, tmp_path):
    with Station(record, tmp_path, pilot=True) as station:
        station.flying()
        console = station.console()
        console.take()
        console.sticks(2100)
        station.sends_nothing(console.insist(
            {"t": "pilot"}, lambda state: state["pilot"] == "flies"
            and state["holder"] is None, "the pilot flies"))
        console.take()
        assert station.state()["pilot"] == "flies", "not moved yet"
        console.insist(moved(2200), lambda state: state["pilot"]
                       == "hands_off", "hands off")
        console.insist({"t": "pilot"}, lambda state: state["pilot"]
                       == "flies", "flies")
        console.say({"t": "release"})
        console.until(lambda state: state["pilot"] == "hands_off",
                      "stopped")


# Frames

def test_gnd20_every_frame_is_taken_and_calibrated(station):
    state = station.wait(lambda state: state["rate"] >= 40)
    sent = {packet.sequence: packet for packet in list(station.node.history)}
    packet = sent[state["seq"]]
    assert tuple(state["words"]) == packet.words
    for column, word, value in zip(packets.COLUMNS, state["words"],
                                   state["values"], strict=True):
        item = items.COLUMNS[column]
        if item.is_scaled:
            assert value == pytest.approx(item.value(word), abs=1e-4)
        else:
            assert value is None
    # A station that the machine runs late may have lost some, and counts them.
    assert state["packets"]["bad"] == 0
    first = int(station.logged("the ground's node runs, frame")[0][
        "text"].rpartition(" ")[2])
    assert state["packets"]["frames"] + state["packets"]["missing"] == (
        state["seq"] - first + 1)


def test_gnd20_malformed_packets_are_counted_and_dropped(station):
    chance = random.Random(1)
    good = station.node.sent.encode()
    bad = [chance.randbytes(length) for length in range(0, 1400, 7)]
    bad += [good[:-1], good + b"\0", b"XXXX" + good[4:]]
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for data in bad:
            sender.sendto(data, station.frames)
            time.sleep(0.002)
    state = station.wait(
        lambda state: state["packets"]["bad"] >= len(bad), "all counted")
    assert state["packets"]["bad"] == len(bad)
    before = state["seq"]
    station.wait(lambda state: state["seq"] > before + 10, "frames go on")


def test_gnd20_frames_that_are_missing_or_old_are_reported(station):
    old = station.node.sent.encode()
    station.node.silent = True
    skipped = station.node.sequence + 20
    until(lambda: station.node.sequence > skipped, "frames not sent")
    station.wait(lambda state: [alert for alert in state["alerts"]
                                if alert["name"] == "NO FRAMES"
                                and alert["active"]], "NO FRAMES")
    station.node.silent = False
    state = station.wait(lambda state: state["packets"]["missing"] > 0)
    assert "FRAMES" in {alert["name"] for alert in state["alerts"]}
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        sender.sendto(old, station.frames)
    station.wait(lambda state: state["packets"]["late"] == 1, "the old one")


# Alerts, marks

def test_gnd26_an_alert_stays_when_its_reason_goes():
    alerts = Alerts()
    alerts.report("a", "caution", "A", "first", 1)
    alerts.report("b", "warning", "B", "second", 2)
    assert [alert["name"] for alert in alerts.shown()] == ["B", "A"]
    alerts.away("a", 1.0)
    assert alerts.active("a"), "not away for long enough"
    alerts.away("a", 2.5)
    assert not alerts.active("a")
    [_, old] = alerts.shown()
    assert (old["name"], old["active"], old["seen"]) == ("A", False, False)
    alerts.acknowledge("a")
    alerts.report("a", "caution", "A", "again", 3)
    newest = alerts.shown()[0]
    assert (newest["name"], newest["count"], newest["seen"]) == ("A", 2, False)
    alerts.acknowledge()
    assert all(alert["seen"] for alert in alerts.shown())


def test_gnd26_a_battery_sag_is_a_caution_then_a_warning(station):
    column = "gsc.downlink.battery_volts"
    item = items.COLUMNS[column]
    low = {"caution": (item.warning_low + item.caution_low) / 2,
           "warning": item.warning_low - 1}
    for level, volts in low.items():
        station.node.words[column] = item.word(volts)
        state = station.wait(lambda state, level=level: [
            alert for alert in state["alerts"] if alert["name"] == "BATTERY"
            and alert["level"] == level and alert["active"]], level)
        assert of_the_test(state)[0]["name"] == "BATTERY"
    del station.node.words[column]
    station.wait(lambda state: not any(
        alert["active"] for alert in of_the_test(state)), "the end")
    assert len(of_the_test(station.state())) == 2


def test_gnd26_errors_of_both_nodes_are_logged_once(station):
    kind = packets.KINDS.index("processor_restart")
    station.node.logs[1][kind] = packets.LogRow(1, 77, 77, 0)
    state = station.wait(of_the_test, "an alert")
    assert of_the_test(state)[0]["name"] == "PROCESSOR RESTART MCS"
    time.sleep(0.5)
    told = station.logged("error", kind="kind")
    assert [line["text"] for line in told] == [
        "mcs processor_restart: 1 times, last in its frame 77"]


def test_gnd46_a_ground_that_starts_again_with_an_earlier_clock(station):
    station.flying()
    station.node.clock_us = -3_600_000_000
    station.node.sequence = 0
    station.node.run_number ^= 1 << 22
    state = station.wait(
        lambda state: state["seq"] < 50 and "COLD START GSC" in {
            alert["name"] for alert in state["alerts"]}, "the new run")
    station.wait(lambda now: now["seq"] > state["seq"] + 10, "its frames")


def test_gnd47_reports_about_other_programs_are_alerts(record, tmp_path):
    station = Station(record, tmp_path, "--reports", reads=True)
    with station:
        for line in (
                Report("plant", "warning", "PLANT GONE", "it died").line(),
                "nonsense\n", '{"key": 1}\n', "x" * 100_000 + "\n"):
            station.process.stdin.write(line)
            station.process.stdin.flush()
        state = station.wait(lambda state: "PLANT GONE" in {
            alert["name"] for alert in state["alerts"]}, "an alert")
        station.process.stdin.write(Report("plant", active=False).line())
        station.process.stdin.close()
        station.wait(lambda state: [
            alert for alert in state["alerts"]
            if alert["name"] == "PLANT GONE" and not alert["active"]],
            "its end")
        # Without who reports it goes on.
        station.wait(lambda now: now["seq"] > state["seq"] + 10, "frames")
        station.logged("process", 3, kind="kind")


ROLL_RATE = 1 << laws.SENSORS.index("roll_rate") - 16
RUDDER = 1 << laws.SURFACES.index("left_rudder")


def of_the_laws(station):
    """A slow machine has others."""
    return [alert for alert in station.state()["alerts"]
            if re.search("ALONE|NOT VALID|FAILED", alert["name"])]


def test_gnd7_the_laws_report_is_an_alert(station):
    def active():
        return {(alert["level"], alert["name"])
                for alert in of_the_laws(station) if alert["active"]}
    station.node.laws = (0x1133,)
    state = station.wait(lambda state: state["laws"], "the laws")
    assert state["laws"]["short"] == "level alt spd"
    assert not active()
    for words, alert in (
            ((0x2133, 0, 0, 30), ("warning", "ALONE: HOLDING")),
            ((0x3143, 0, 0, 300), ("warning", "ALONE: ORBITING")),
            ((0x1133, 0, ROLL_RATE), ("caution", "ROLL RATE NOT VALID")),
            ((0x1133, 0xFFFF, 0x7FF), ("caution", "SENSORS NOT VALID")),
            ((0x1133, 0, 0, 0, RUDDER), ("warning", "LEFT RUDDER FAILED"))):
        station.node.laws = words
        until(lambda alert=alert: active() == {alert}, alert)
    station.node.laws = ()
    station.wait(lambda state: state["laws"] is None, "nothing told")
    until(lambda: not active(), "no alert")
    assert station.logged("the laws")[0]["text"] == (
        "the laws: wings level/altitude/airspeed")


def test_gnd7_what_the_laws_say_of_a_start_is_no_news(station):
    """They believe no sensor for a second."""
    station.node.run_number += 1
    station.node.laws = (0x1000, 0xFFFF, 0x7FF)
    first = station.wait(lambda state: state["laws"], "laws")["seq"]
    station.wait(lambda state: state["seq"] > first + 25, "half a second")
    station.node.laws = (0x1000,)
    station.wait(lambda state: state["seq"] > first + 150, "the rest")
    assert of_the_laws(station) == []


def test_gnd26_a_refused_block_is_an_alert(station):
    kind = packets.KINDS.index("block_refused")
    station.node.logs[0][kind] = packets.LogRow(3, 70, 77, 2)
    station.wait(lambda state: ("BLOCK REFUSED GSC", "caution") in {
        (alert["name"], alert["level"]) for alert in state["alerts"]},
        "an alert")


def test_gnd27_a_mark_is_an_event_in_one_line(station):
    console = station.console()
    console.say({"t": "mark", "text": "gear\u001b[31m \n<b>up</b>\u202e"})
    line = station.logged("mark", kind="kind")[0]
    assert line["text"] == "gear [31m <b>up</b>"
    assert line["frame"] is not None and line["time_us"] > 0
    console.say({"t": "mark", "text": "x" * 201})
    until(lambda: station.state()["station"]["bad"] == 1, "refused")


# Orders

WANTED = {"t": "order", "table": 1, "orbit": 20, "end": 90}
REFUSED_KIND = packets.KINDS.index("configuration_refused")


def ordered(station, state):
    """Wait for the station's message about the newest order."""
    return station.wait(
        lambda found: found["order"]["state"] == state, state)["order"]


def give(station, console, message=WANTED):
    """The station has an order or cards from a page. A slow machine drops input
    that was half a second on its way (GND-51): it is said again."""
    part = message["t"]
    before = station.state()[part]

    def is_there():
        console.say(message)
        ends = time.monotonic() + 2
        while station.state()[part] == before:
            if time.monotonic() >= ends:
                return False
            time.sleep(0.02)
        return True
    until(is_there, part)


def holder(station):
    """A page with the sticks."""
    console = station.console()
    console.take()
    console.listen()
    return console


def test_gnd35_the_holder_s_order_goes_up_and_the_aircraft_takes_it(station):
    console = holder(station)
    assert station.state()["order"]["state"] == "none"
    give(station, console)
    assert "taken by the aircraft" in ordered(station, "taken")["text"]
    [packet] = station.node.orders
    assert (packet.serial, packet.table, packet.orbit, packet.end) == (
        1, 1, 20, 90)
    state = station.wait(lambda state: state["laws"], "laws")
    assert (state["laws"]["serial"], state["laws"]["table"]) == (1, 1)
    assert state["order"]["in_force"] == (
        "number 1: gains 1 (softer), orbit after 2 s, end after 9 s")
    give(station, console, WANTED | {"table": 0})
    until(lambda: len(station.node.orders) == 2, "another")
    assert station.node.orders[1].serial == 2
    # Its number follows those of the sticks.
    assert packet.sequence < station.node.orders[1].sequence


CARDS = """
[[card]]
name = "first"
kind = "doublet"
moves = ["pitch"]
amplitude_deg = 2
pulse_s = 0.4
bank_deg = 30
slowest_kt = 50

[[card]]
slot = 3
kind = "step"
moves = ["left_rudder"]
amplitude_deg = 1
pulse_s = 1
"""


def aboard(station, state=0, frame=0, sent=()):
    """The aircraft reports its cards, part after part, each until the station
    has it."""
    node = station.node
    place = packets.CARDS_ROW - 1
    for card in sent:
        words = (*card.words()[:11], 0)
        for part in range(3):
            one, two, three, four = words[4 * part:4 * part + 4]
            node.logs[1][place] = packets.LogRow(
                state << 16 | frame, (card.slot * 16 + part) << 16 | one,
                two << 16 | three, four)
            next_frame = node.sequence + 1
            station.wait(lambda state: state["seq"] > next_frame, "a part")
    row = node.logs[1][place]
    node.logs[1][place] = packets.LogRow(
        state << 16 | frame, row.first_frame, row.last_frame, row.detail)


def test_fti8_the_holder_s_cards_go_up_and_are_read_back(station):
    console = holder(station)
    give(station, console, {"t": "cards", "text": CARDS})
    until(lambda: len(station.node.cards) == 3, "cards")
    sent = cards.of_text(CARDS, "cards")
    assert [packet.words for packet in station.node.cards] == [
        *(card.words() for card in sent),
        cards.Card(slot=1, kind="choose").words()]
    numbers = [packet.sequence for packet in station.node.cards]
    assert numbers == sorted(set(numbers))
    assert station.state()["cards"]["state"] == "waiting"
    aboard(station, 1, 0, sent)
    shown = station.wait(
        lambda state: state["cards"]["state"] == "taken", "read back")["cards"]
    assert [each["slot"] for each in shown["slots"]] == [1, 3]
    assert shown["slots"][0] | {"slot": 1} == {
        "slot": 1, "kind": "doublet", "seconds": 0.8, "name": "first",
        "moves": "pitch", "envelope": "bank 30 deg, airspeed from 50 kt"}
    assert shown["slots"][1]["moves"] == "left rudder"
    # It runs, and ends by a stick.
    aboard(station, 1 | 1 << 4 | 1 << 8, 12)
    station.wait(lambda state: state["cards"]["running"] == 1, "it runs")
    aboard(station, 1 | 1 << 8 | 5 << 12, 13)
    shown = station.wait(
        lambda state: not state["cards"]["running"], "it ends")["cards"]
    assert (shown["last"], shown["ended"]) == (1, "stick moved")
    assert not shown["expected"]


def test_fti8_wrong_cards_and_those_of_a_watcher_go_nowhere(station):
    console = holder(station)
    watcher = station.console()
    give(station, watcher, {"t": "cards", "text": CARDS})
    shown = station.wait(
        lambda state: state["cards"]["state"] == "refused", "refused")
    assert "does not hold the sticks" in shown["cards"]["text"]
    give(station, console,
         {"t": "cards", "text": CARDS.replace("0.4", "50")})
    station.wait(lambda state: "pulse_s is a number" in state["cards"]["text"],
                 "its reason")
    console.say({"t": "cards", "text": "x" * 3_600})
    give(station, console, {"t": "cards", "text": CARDS})
    until(lambda: len(station.node.cards) == 3, "good ones")
    kind = packets.KINDS.index("card_refused")
    station.node.logs[1][kind] = packets.LogRow(1, 7, 7, 3)
    station.wait(lambda state: "a card runs" in state["cards"]["text"],
                 "the aircraft's reason")


@pytest.mark.parametrize("wrong", [
    CARDS.replace('"doublet"', '"doublet"\nadded_to = ["stick"]'),
    "a = " + 3_000 * "["], ids=["list", "deep"])
def test_fti8_a_mistake_in_a_file_leaves_the_pilot_the_sticks(station, wrong):
    console = holder(station)
    give(station, console, {"t": "cards", "text": wrong})
    state = station.wait(
        lambda state: state["cards"]["state"] == "refused", "refused")
    assert state["holder"] == console.number
    # Its page is still heard.
    give(station, console, {"t": "cards", "text": CARDS})
    assert station.state()["holder"] == console.number


@pytest.mark.parametrize("letter", ["\u20ac", "\x01", "\U0001f6e9"],
                         ids=["euro", "control", "pair"])
def test_fti8_the_longest_file_of_the_page_is_heard(station, letter):
    """A letter has up to three bytes, with JSON's escapes six; the page counts
    a letter beyond 16 bits as two."""
    longest = int(re.search(r"const LONGEST = ([0-9_]+);", (
        web.PAGE / "cards.js").read_text("utf-8"))[1])
    assert longest == web.LONGEST_CARDS
    console = holder(station)
    many = longest // (len(letter.encode("utf-16-le")) // 2)
    give(station, console, {"t": "cards", "text": many * letter})
    state = station.wait(
        lambda state: state["cards"]["state"] == "refused", "refused")
    assert state["holder"] == console.number


def test_gnd24_a_fault_of_the_station_costs_one_message():
    controls = Controls(View(), None)
    controls.hears = lambda *_: 1 // 0
    page = web.Page(1, None)
    station = web.Station(controls)
    for sequence in (1, 2):
        station._heard(page, {"t": "take", "sequence": sequence,
                              "sent_s": 1.0})
    assert controls.bad_messages == 2 and page.bad == 0
    assert [line.text for line in controls.view.log] == [
        "console 1: a message could not be handled: take: ZeroDivisionError:"
        " integer division or modulo by zero"]


# The flight recorder

MARKS = itertools.count()


def fetches(station, console, what="fetch", last=None):
    """The station has the page's order, though a slow machine drops input that
    was half a second on its way (GND-51): it is said again then. A mark is not
    dropped, and shows that the order before it has come."""
    def is_heard():
        old = station.state()["station"]["old"]
        mark = f"order {next(MARKS)}"
        console.say({"t": "recorder", "what": what, "last": last})
        console.say({"t": "mark", "text": mark})
        station.logged(mark)
        return station.state()["station"]["old"] == old
    until(is_heard, what)


def listening(console):
    """A page that looks at no state answers the station's pings, too."""
    console.listen()
    return console


def recorder(station, *wanted):
    """The recorder's state once it is one of these."""
    return station.wait(lambda state: state["recorder"]["state"] in wanted,
                        f"recorder {wanted}")["recorder"]


@pytest.fixture
def recording(record, tmp_path):
    """A station whose aircraft has 300 rows in its recorder."""
    with Station(record, tmp_path, "--recordings", tmp_path) as station:
        station.node.recorder.rows = recording_of(range(4_000, 4_300))
        station.flying()
        yield station


def rows_of(tmp_path, shown):
    return recordings.Recording(tmp_path / shown["file"]).rows


def test_fti13_a_page_asks_for_the_recorder_and_fetches_it(
        recording, tmp_path):
    console = listening(recording.console())
    assert recording.state()["recorder"]["state"] == "none"
    fetches(recording, console, "ask")
    shown = recorder(recording, "known")
    assert (shown["held"], shown["length"]) == (300, 30_000)
    fetches(recording, console, last=2)
    shown = recorder(recording, "complete")
    assert (shown["wanted"], shown["fetched"]) == (100, 100)
    aboard = list(recording.node.recorder.rows.values())
    assert rows_of(tmp_path, shown) == aboard[200:]
    # The rest goes into the same file.
    fetches(recording, console)
    until(lambda: recording.state()["recorder"]["fetched"] == 300, "all rows")
    again = recorder(recording, "complete")
    assert again["file"] == shown["file"]
    assert rows_of(tmp_path, again) == aboard
    assert recording.logged("300 of 300 rows, complete")[0]["kind"] == (
        "recorder")


def test_fti13_a_stopped_fetch_and_gaps_go_on_later(recording, tmp_path):
    console = listening(recording.console())
    node = recording.node.recorder
    node.a_frame = 1
    fetches(recording, console)
    until(lambda: recording.state()["recorder"]["fetched"] > 5, "rows")
    fetches(recording, console, "stop")
    shown = recorder(recording, "stopped")
    assert 5 < shown["fetched"] < 300
    stopped = rows_of(tmp_path, shown)
    assert len(stopped) == shown["fetched"]
    # A row that is wrong aboard remains missing, and is named.
    node.a_frame = 100
    wrong = list(node.rows[4_250])
    wrong[9] ^= 4
    node.rows[4_250] = tuple(wrong)
    fetches(recording, console)
    shown = recorder(recording, "gaps")
    assert (shown["fetched"], shown["missing"], shown["text"]) == (
        299, "4250", "their sums are wrong aboard")
    assert len(rows_of(tmp_path, shown)) == 299
    assert recording.logged("299 of 300 rows, missing 4250")[0]["level"] == (
        "caution")
    # Another flight has a file of its own.
    node.rows = recording_of(range(5_000, 5_020), seed=2)
    time.sleep(1)
    fetches(recording, console)
    other = recorder(recording, "complete")
    assert other["file"] != shown["file"]
    assert rows_of(tmp_path, other) == list(node.rows.values())


def test_fti13_in_flight_and_without_a_link_the_page_says_why(recording):
    console = listening(recording.console())
    recording.node.recorder.flies = True
    fetches(recording, console)
    shown = recorder(recording, "failed")
    assert "refused: the aircraft flies" in shown["text"]
    recording.node.recorder.flies = False
    recording.node.recorder.silent = True
    fetches(recording, console)
    recording.wait(lambda state: "no answer: the link is lost"
                   in state["recorder"]["text"], "no answer")


def test_fti13_only_the_holder_of_the_sticks_fetches(recording):
    console = holder(recording)
    watcher = listening(recording.console())
    fetches(recording, watcher)
    for bad in ({"what": "erase", "last": None}, {"what": "fetch", "last": 0},
                {"what": "fetch", "last": 1.5}, {"what": "fetch"}):
        watcher.say({"t": "recorder"} | bad)
    recording.wait(lambda state: state["station"]["bad"] == 4, "bad ones")
    assert recording.state()["recorder"]["state"] == "none"
    fetches(recording, console)
    recorder(recording, "complete")


def test_fti13_a_recording_that_cannot_be_written_is_a_reason(
        record, tmp_path):
    with Station(record, tmp_path, "--recordings", tmp_path / "gone") as (
            station):
        station.node.recorder.rows = recording_of(range(20))
        station.flying()
        console = listening(station.console())
        fetches(station, console)
        assert "cannot be written" in recorder(station, "failed")["text"]
        # The rows are not lost.
        (tmp_path / "gone").mkdir()
        fetches(station, console)
        shown = recorder(station, "complete")
        assert len(rows_of(tmp_path / "gone", shown)) == 20


def test_fti8_reasons_are_those_of_the_aircraft():
    text = (ROOT / "src/laws/urv-test_runs.ads").read_text("utf-8")
    for name, known in (("Verdict", len(deck.VERDICTS)),
                        ("Answer", len(deck.REFUSED) + 1)):
        body = re.search(rf"type {name} is\s*\((.*?)\);", text, re.DOTALL)[1]
        assert len(re.sub("--.*", "", body).split(",")) == known


def test_gnd35_only_the_holder_of_the_sticks_orders(station):
    watcher = station.console()
    give(station, watcher)
    assert "does not hold the sticks" in ordered(station, "refused")["text"]
    console = holder(station)
    watcher.say(WANTED)
    give(station, console)
    ordered(station, "taken")
    assert len(station.node.orders) == 1


@pytest.mark.parametrize("reason, said", [
    (2, "a value is none that may be set"),
    (3, "a control law flies the aircraft"),
    (4, "its control laws are off")])
def test_gnd35_what_the_aircraft_refuses_is_reported_with_its_reason(
        station, reason, said):
    station.node.logs[1][REFUSED_KIND] = packets.LogRow(4, 1, 2, 1)
    station.node.refuses = reason
    console = holder(station)
    give(station, console)
    told = ordered(station, "refused")
    assert told["text"] == f"number 1 refused by the aircraft: {said}"
    assert station.wait(lambda state: state["order"], "it")["order"][
        "in_force"] != told["text"]
    line = until(lambda: [line for line in station.lines()
                          if line["kind"] == "order"
                          and line["level"] == "caution"], "a line")[0]
    assert said in line["text"]


def test_gnd35_a_lost_order_is_reported_and_another_may_follow(station):
    station.node.refuses = None
    console = holder(station)
    give(station, console)
    ordered(station, "waiting")
    console.say(WANTED)
    assert "no answer to number 1" in ordered(station, "lost")["text"]
    assert len(station.node.orders) == 1
    station.node.refuses = 0
    give(station, console)
    ordered(station, "taken")
    assert station.node.orders[1].serial == 2


def test_gnd35_an_answer_that_comes_late_is_one(station):
    """A machine that is late shows the aircraft's word after its time."""
    station.node.refuses = None
    console = holder(station)
    give(station, console)
    ordered(station, "lost")
    station.node.laws = (0, 0, 0, 0, 0, 0, 1 << 4 | 1)
    ordered(station, "taken")


def test_gnd35_its_number_is_another_than_the_aircraft_has(station):
    """Whoever set that: a file, or a station before this one."""
    station.node.laws = (0x1000, 0, 0, 0, 0, 0, 4095 << 4)
    console = holder(station)
    told = station.wait(
        lambda state: (state["laws"] or {}).get("serial") == 4095, "laws")
    assert told["order"]["in_force"] == (
        "number 4095: gains 0 (usual), times not known here")
    give(station, console)
    ordered(station, "taken")
    assert station.node.orders[0].serial == 1


# Safety

FOREIGN = [
    {"Origin": "http://evil.example"},
    {"Origin": "http://127.0.0.1:1"},
    {"Origin": "null"},
    {"Host": "evil.example"},
    {"Host": "127.0.0.1.evil.example:80"},
    {"Sec_Fetch_Site": "cross-site", "Sec_Fetch_Mode": "no-cors"},
]


def test_gnd23_foreign_origins_are_refused(station):
    for path in ("/", "/page/main.js", "/api/state", "/ws"):
        for headers in FOREIGN:
            assert station.get(path, **headers)[0] == 403, (path, headers)
        own = {"Origin": f"http://localhost:{station.port}",
               "Host": f"localhost:{station.port}",
               "Sec_Fetch_Site": "same-origin"}
        assert station.get(path, **own)[0] != 403


def test_gnd23_a_foreign_page_gets_no_socket(station):
    with pytest.raises(websocket.WebSocketBadStatusException) as refused:
        station.console(origin="http://evil.example")
    assert refused.value.status_code == 403
    station.console(origin=f"http://127.0.0.1:{station.port}").close()


def test_gnd23_nothing_else_is_served(station):
    for path in ("/page/../station.py", "/page/%2e%2e%2fstation.py",
                 "/page/", "/page//etc/passwd", "/etc/passwd",
                 "/page/index.html%00.js"):
        assert station.get(path)[0] in (400, 404), path


def test_gnd23_headers_forbid_all_else(station):
    with socket.create_connection(("127.0.0.1", station.port)) as client:
        client.sendall(f"GET / HTTP/1.1\r\nHost: localhost:{station.port}"
                       "\r\n\r\n".encode())
        answer = b""
        while data := client.recv(65536):
            answer += data
    head = answer.split(b"\r\n\r\n")[0].decode()
    policy = next(line for line in head.splitlines()
                  if line.startswith("Content-Security-Policy"))
    assert "default-src 'none'" in policy
    assert "unsafe" not in policy and "*" not in policy


def test_sec11_elsewhere_than_here_a_token_is_demanded_with_a_warning(record, tmp_path):
    with Station(record, tmp_path, "--listen", "0.0.0.0") as station:
        [warning] = [line for line in station.said
                     if "other machines" in line]
        assert "plain HTTP" in warning and "take the sticks and fly" in warning
        token = station.url.partition("token=")[2]
        assert len(token) >= 16
        for path in ("/", "/api/state", "/ws", "/page/main.js",
                     "/?token=wrong"):
            assert station.get(path)[0] == 401
        assert station.get("/api/state",
                           Authorization=f"Bearer {token}")[0] == 200
        assert station.get("/", Cookie=f"{web.COOKIE}={token}")[0] == 200
        with pytest.raises(websocket.WebSocketBadStatusException):
            station.console()
        station.console(cookie=f"{web.COOKIE}={token}").close()


@pytest.mark.parametrize("arguments", [
    ("--frames", "udp:nowhere"), ("--frames", "tcp:127.0.0.1:1"),
    ("--console", "udp:127.0.0.1:70000"), ("--port", "99999"),
    ("--token", "short"), ("--yamcs", "https://127.0.0.1"),
    ("--listen", "203.0.113.1"),
    # A variable of a shell that is not set: it listened at every address.
    ("--listen", ""),
    # It started, looked the name up for each packet, and no stick went up.
    ("--console", "udp:no-such.invalid:6004")])
def test_gnd23_bad_options_are_refused(urv, arguments):
    result = urv("station", "--seconds", "0.1", *arguments)
    assert result.returncode == 2
    assert result.stderr.startswith("urv: ")
    assert len(result.stderr.splitlines()) == 1
    assert arguments[0] in result.stderr


def test_fti13_recordings_in_a_file_are_refused_at_the_start(urv, tmp_path):
    """The station started, and the first fetch of a minute was in vain."""
    (tmp_path / "file").touch()
    result = urv("station", "--seconds", "0.1", "--port", "0",
                 "--frames", "udp:127.0.0.1:0", "--recordings", "file")
    assert (result.returncode, result.stderr) == (
        2, 'urv: --recordings "file": not a folder\n')


@pytest.mark.parametrize("said", [
    b"GET / HTTP/1.1\r\nHost: here\r\n\r\n\x00\x01\x02 no request\r\n\r\n",
    b"GET / HTTP/1.1\r\nno header\r\n\r\n",
    b"GET / HTTP/9.9.9\r\n\r\n",
    b"GET /" + b"x" * 20_000 + b" HTTP/1.1\r\n\r\n",
    b"GET / HTTP/1.1\r\nContent-Length: many\r\n\r\n",
    b"POST / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\nno length\r\n",
])
def test_gnd24_a_request_without_sense_is_nothing_to_tell(station, said):
    # The fixture checks that nothing was written to standard error.
    with socket.create_connection(("127.0.0.1", station.port)) as client:
        client.sendall(said)
        answer = b"".join(iter(lambda: client.recv(1000), b""))
    assert b" 400 " in answer or b" 404 " in answer or b" 405 " in answer
    assert station.get()[0] == 200


def test_gnd24_a_fault_in_the_station_is_reported_a_senseless_request_is_not():
    def logged(error):
        return web.is_worth_telling(logging.LogRecord(
            "", logging.ERROR, "", 0, "", (), (type(error), error, None)))

    assert logged(ValueError())
    assert not logged(BadHttpMethod("x"))
    assert web.is_worth_telling(
        logging.LogRecord("", logging.ERROR, "", 0, "", (), None))


def test_gnd24_garbage_at_the_page_stops_nobody(station):
    chance = random.Random(2)
    console = station.console()
    for length in (0, 1, 10, 1000, 100_000):
        with socket.create_connection(("127.0.0.1", station.port)) as client:
            try:
                client.sendall(chance.randbytes(length))
                client.shutdown(socket.SHUT_WR)
                client.recv(1000)
            except OSError:
                pass
    before = station.state()["seq"]
    console.until(lambda state: state["seq"] > before + 25, "frames go on")


def test_gnd24_frames_that_come_while_it_ends_stop_nobody(record, tmp_path):
    ended = threading.Event()

    def flood(packet, to):
        # Each frame is an event for the file.
        states = (packets.LinkState.LOST, packets.LinkState.HEARD)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not ended.is_set():
                packet = dataclasses.replace(
                    packet, sequence=packet.sequence + 1,
                    link_state=states[packet.sequence % 2])
                sender.sendto(packet.encode(), to)
                time.sleep(0.000_1)

    # The rig checks that nothing was written to standard error.
    try:
        with Station(record, tmp_path) as station:
            station.flying()
            station.node.silent = True
            sender = threading.Thread(
                target=flood, args=(station.node.sent, station.frames))
            sender.start()
            station.wait(
                lambda state: state["seq"] > station.node.sequence + 100,
                "the flood")
    finally:
        ended.set()
    sender.join()


@pytest.mark.parametrize("message", [
    "", "{", "[]", "1", '{"t": "sticks"}', '{"t": "sticks", "words": [1]}',
    '{"t": "sticks", "words": [-1,0,0,0,0,0,0,0,0,0,0,0,0]}',
    '{"t": "sticks", "words": [4096,0,0,0,0,0,0,0,0,0,0,0,0]}',
    '{"t": "sticks", "words": [true,0,0,0,0,0,0,0,0,0,0,0,0]}',
    '{"t": "sticks", "words": [1e3,0,0,0,0,0,0,0,0,0,0,0,0]}',
    '{"t": "mark", "text": 7}', '{"t": "lost", "what": "x"}',
    '{"t": "drawn"}', '{"t": "drawn", "number": -1}',
    '{"t": "drawn", "number": true}', '{"t": "drawn", "number": 1.5}',
    '{"t": "order"}', '{"t": "order", "table": 1, "orbit": 20}',
    '{"t": "order", "table": 1, "orbit": 20, "end": 4096}',
    '{"t": "order", "table": -1, "orbit": 20, "end": 90}',
    '{"t": "order", "table": true, "orbit": 20, "end": 90}',
    '{"t": "order", "table": 1, "orbit": 2.5, "end": 90}',
    '{"t": "gamepad", "what": "x", "name": "a"}',
    '{"t": "gamepad", "what": "lost", "name": 7}',
    '{"t": "gamepad", "what": "lost", "name": "' + 201 * "a" + '"}',
    '{"t": "answer", "yes": 1}', '{"t": "nothing"}', "[" * 4000])
def test_gnd24_an_unknown_message_of_a_page_is_not_understood(message):
    assert web.understood(message) is None


def test_gnd24_a_page_that_talks_nonsense_is_dropped(station):
    console = station.console()
    with pytest.raises((websocket.WebSocketException, OSError)):
        for _ in range(1000):
            console.socket.send("nonsense")
            time.sleep(0.002)
            console.next("state")
    station.logged("dropped: messages")
    station.console().close()


def test_gnd24_a_page_that_floods_is_dropped(station):
    console = station.console()
    with pytest.raises((websocket.WebSocketException, OSError)):
        for _ in range(100_000):
            console.sticks()
        console.next("hello")
    station.logged("dropped: too many")


def test_gnd24_one_too_large_message_ends_its_page(station):
    console = station.console()
    console.socket.send("x" * (web.LONGEST_MESSAGE + 1))
    with pytest.raises((websocket.WebSocketException, OSError)):
        while True:
            if console.socket.recv() == "":
                raise OSError("closed")


def test_gnd24_a_page_that_takes_nothing_is_dropped(station):
    console = station.console()
    deaf = station.console()
    deaf.socket.sock.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 2048)
    # It reads no more; the others see each frame.
    before = station.state()["seq"]
    console.until(lambda state: state["seq"] > before + 50, "frames go on")
    until(lambda: console.next("state") and any(
        f"console {deaf.number} dropped" in line["text"]
        or f"console {deaf.number} closed" in line["text"]
        for line in station.lines()), "a word of it")


def test_gnd36_a_slow_page_gets_the_newest_frame(station):
    """It says which state it has drawn. Later messages are of the frames that
    the station had by then, however many it left out."""
    station.wait(lambda state: state["rate"] >= 40, "frames")
    slow = station.console()
    first = last = slow.next("state")["number"]
    slow.say({"t": "drawn", "number": first})
    known, left_out = {}, []
    for _ in range(16):
        state = slow.next("state")
        assert state["number"] == last + 1
        last = state["number"]
        # Data in transit before its first word comes first.
        if last - first > 8:
            assert state["seq"] >= known[last - 2] - 2
        left_out.append(state["left_out"])
        time.sleep(0.2)
        known[last] = station.state()["seq"]
        slow.say({"t": "drawn", "number": last})
    assert left_out == sorted(left_out)
    assert left_out[-1] - left_out[3] > 20


def test_gnd36_a_page_that_draws_nothing_is_sent_no_more(station):
    console = station.console()
    first = console.next("state")["number"]
    console.say({"t": "drawn", "number": first})
    # Those on the way when it said so, and two.
    console.socket.settimeout(2.0)
    with pytest.raises(websocket.WebSocketTimeoutException):
        while True:
            last = console.next("state")["number"]
    # It is there all the same, and goes on when it has drawn them.
    console.socket.settimeout(PATIENCE_S)
    console.say({"t": "drawn", "number": last})
    assert console.next("state")["number"] == last + 1


def test_gnd24_half_open_and_slow_clients_do_not_hold_the_door(station):
    idle = [socket.create_connection(("127.0.0.1", station.port))
            for _ in range(door.MOST_WAITING * 2)]
    try:
        for number, client in enumerate(idle):
            try:
                client.sendall(b"GET / HTTP/1.1\r\nHost: lo"[:number % 25])
            except OSError:
                pass
        # While they are open.
        assert station.get("/")[0] == 200
        for client in idle:
            client.settimeout(PATIENCE_S)
            with contextlib.suppress(ConnectionError):
                client.recv(1000)
    finally:
        for client in idle:
            client.close()


def test_gnd24_connections_that_have_ended_take_no_place(station):
    """More of them, one after the other, than there are places."""
    for _ in range(200):
        assert station.state()["seq"] is not None


FULL_EVENTS = (
    1, "urv: --events cannot be written: No space left on device\n" * 2)
"""Once when it is lost, and why the station ends with a fault."""


def test_gnd24_a_full_disk_under_the_events_stops_nobody(record, tmp_path):
    with Station(record, tmp_path, "--events", "/dev/full") as station:
        station.ends = FULL_EVENTS
        station.wait(lambda state: "EVENTS FILE" in {
            alert["name"] for alert in state["alerts"]}, "an alert")
        before = station.state()["seq"]
        station.wait(lambda state: state["seq"] > before + 25, "frames go on")


def test_gnd24_it_ends_well_with_pages_open_that_do_not_answer(
        record, tmp_path):
    with Station(record, tmp_path) as station:
        station.flying()
        silent = [station.console() for _ in range(3)]
        reset = station.console()
        reset.socket.sock.setsockopt(
            socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
        reset.socket.sock.close()
    for console in silent:
        console.socket.sock.close()

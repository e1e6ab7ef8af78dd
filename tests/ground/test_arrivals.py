# SPDX-License-Identifier: Apache-2.0
"""GND-51, D-36: how old a page's input is, whatever delayed it."""

import contextlib
import json
import random
import re
import signal
import threading
import time

import pytest
import websocket
from station_rig import Console, Station, until

from urv import web
from urv.ages import DRIFT
from urv.arrivals import OLD_S, ROUND_TRIP_S, STATES, Arrivals
from urv.controls import INPUT, PROTOCOL
from urv.sticks import SILENT_S, Sticks

WORDS = (3000, 2048, 2048, 2048, 2048, *[0] * 8)


@pytest.fixture
def station(standard, tmp_path):
    with Station(standard / "record.csv", tmp_path) as station:
        station.flying()
        yield station


# The age of a message

@pytest.mark.parametrize("offset", [-1e6, -3.0, 0.0, 7.5, 1e9])
def test_gnd51_the_age_is_the_delay_whatever_the_clocks_show(offset):
    arrivals = Arrivals()
    chance = random.Random(3)
    arrivals.age(100.0 + offset, 100.002)
    for step in range(1, 500):
        at = 100.0 + step * 0.02
        delay = chance.choice((0.002, 0.01, 0.2, 3.0))
        found = arrivals.age(at + offset, at + delay)
        assert delay - 0.002 - 1e-4 <= found + DRIFT * 11
        assert found <= delay


def test_gnd51_a_queue_that_is_flushed_at_once_is_as_old_as_each_message():
    """Fifty messages of one second arrive together, 2 s later."""
    arrivals = Arrivals()
    arrivals.age(10.0, 10.01)
    for number in range(50):
        sent = 11.0 + number * 0.02
        assert arrivals.age(sent, 14.0) == pytest.approx(
            14.0 - sent - 0.01, abs=0.01)


def test_d36_clocks_of_different_rates_are_never_late():
    """200 ppm apart for ten hours."""
    arrivals = Arrivals()
    for second in range(36_000):
        assert arrivals.age(second * (1 - 200e-6), second + 0.005) < 0.01


def test_gnd51_a_constant_delay_is_not_forgiven_for_many_minutes():
    arrivals = Arrivals()
    arrivals.age(0.0, 0.0)
    for second in range(1, 900):
        assert arrivals.age(second, second + 1.0) > OLD_S


def test_d36_a_clock_that_stepped_back_counts_again_after_a_round_trip():
    arrivals = Arrivals()
    for step in range(10):
        arrivals.sends(step, step * 0.04)
        assert arrivals.answer(step, step * 0.04, step * 0.04 + 0.02) is None
    # An hour back.
    assert arrivals.age(1.0 - 3600, 1.0) > OLD_S
    arrivals.sends(10, 1.1)
    assert arrivals.answer(10, 1.11 - 3600, 1.15) == pytest.approx(
        3600, abs=1)
    for step in range(50):
        at = 1.2 + step * 0.02
        assert arrivals.age(at - 3600, at + 0.01) <= ROUND_TRIP_S
        assert arrivals.age(at - 3600, at + 0.7) > OLD_S


def test_d36_a_queue_is_never_taken_for_a_clock_that_stepped():
    """Answers that waited as the input did show no young round trip."""
    arrivals = Arrivals()
    for step in range(10):
        arrivals.sends(step, step * 0.04)
        arrivals.answer(step, step * 0.04 + 0.01, step * 0.04 + 0.02)
    arrivals.sends(10, 0.5)
    for step in range(100):
        # All that the page sends now takes 2 s.
        at = 0.52 + step * 0.02
        assert arrivals.answer(10, at, at + 2.0) is None
        assert arrivals.age(at, at + 2.0) > OLD_S


def test_gnd51_an_answer_to_a_state_that_was_never_sent_says_nothing():
    arrivals = Arrivals()
    arrivals.age(0.0, 0.0)
    for number in range(3 * STATES):
        arrivals.sends(number, number * 0.04)
    assert arrivals.answer(10**9, 1.0, 99.0) is None
    assert arrivals.answer(0, 1.0, 99.0) is None


def test_gnd51_numbers_rise():
    arrivals = Arrivals()
    assert [arrivals.is_new(number) for number in (1, 2, 2, 1, 7, 3, 8)] == [
        True, True, False, False, True, False, True]


def test_gnd51_words_are_flown_until_they_are_half_a_second_old():
    sticks = Sticks()
    sticks.take(1, 0.0)
    sticks.move(1, WORDS, 1.0, age=0.4)
    assert sticks.live(1.09) == WORDS
    assert sticks.live(1.11) is None
    sticks.move(1, WORDS, 2.0)
    assert sticks.live(2.0 + SILENT_S - 0.01) == WORDS


# At the station

def hold(station):
    console = station.console()
    console.take()
    threading.Thread(target=read, args=(console,), daemon=True).start()
    return console


def read(console):
    """As a browser does: the station drops a page that answers no ping, and
    waits for the answer to each state."""
    with contextlib.suppress(OSError, websocket.WebSocketException):
        while True:
            number = console.next("state")["number"]
            if console.answers:
                console.say({"t": "drawn", "number": number})


def named(state, name):
    return [alert for alert in state["alerts"] if alert["name"] == name]


def test_gnd51_sticks_that_come_late_are_dropped_and_reported(station):
    console = hold(station)
    for _ in range(20):
        console.sticks(3000)
        time.sleep(0.02)
    until(lambda: station.node.heard, "sticks")
    console.late_s = 0.9
    for _ in range(30):
        console.sticks(100)
        time.sleep(0.02)
    state = station.wait(lambda state: named(state, "OLD INPUT"), "a caution")
    [alert] = named(state, "OLD INPUT")
    assert alert["level"] == "caution"
    assert f"console {console.number}: its input arrives" in alert["text"]
    station.wait(lambda state: state["station"]["old"] >= 30, "all counted")
    assert {packet.words[0] for _, packet in station.node.heard} == {3000}
    state = station.wait(lambda state: not named(state, "OLD INPUT")[0][
        "active"], "its end")
    # A machine that pauses makes several times of it.
    until(lambda: sum(int(found[1]) for line in station.lines() if (
        found := re.search(r"(\d+) messages dropped, up to \d", line["text"])))
        >= 30, "how many")
    # Frames in time are shown as flying again.
    console.late_s = 0.0
    until(lambda: console.sticks(2900) or station.node.heard[-1][
        1].words[0] == 2900, "sticks that come in time")


@pytest.mark.parametrize("what", [
    message for message in (
        {"t": "take"}, {"t": "answer", "yes": True}, {"t": "pilot"},
        {"t": "order", "table": 0, "orbit": 50, "end": 1200})])
def test_gnd51_no_other_input_comes_late(station, what):
    """A take that was asked for a second ago takes nothing."""
    assert what["t"] in INPUT
    console = station.console()
    console.say({"t": "mark", "text": "in time"})
    console.late_s = 1.0
    console.say(what)
    state = station.wait(lambda state: state["station"]["old"], "a count")
    assert (state["holder"], station.node.orders) == (None, [])
    assert named(state, "OLD INPUT")


def test_gnd51_what_waits_at_a_station_that_stood_still_is_dropped(station):
    """The station is stopped for 2 s; the page sends all the while."""
    console = hold(station)
    for _ in range(20):
        console.sticks(3000)
        time.sleep(0.02)
    until(lambda: station.node.heard, "sticks")
    station.process.send_signal(signal.SIGSTOP)
    try:
        for _ in range(50):
            console.sticks(100)
            time.sleep(0.02)
        time.sleep(1.0)
    finally:
        station.process.send_signal(signal.SIGCONT)
    station.wait(lambda state: state["station"]["old"] >= 50, "50 dropped")
    assert {packet.words[0] for _, packet in station.node.heard} == {3000}


def test_gnd51_a_repeated_message_is_dropped_and_reported(station):
    console = hold(station)
    until(lambda: console.sticks(3000) or station.node.heard, "sticks")
    console.sequence -= 1
    console.sticks(100)
    console.sequence -= 1
    console.sticks(100)
    state = station.wait(lambda state: state["station"]["repeated"] == 2,
                         "both counted")
    assert named(state, "REPEATED INPUT")
    assert {packet.words[0] for _, packet in station.node.heard} == {3000}


def test_gnd51_a_clock_that_steps_does_not_lock_the_pilot_out(station):
    console = hold(station)
    until(lambda: console.sticks(3000) or station.node.heard, "sticks")
    console.late_s = 3600.0
    console.answers = True

    until(lambda: console.sticks(2500) or station.node.heard[-1][
        1].words[0] == 2500, "sticks again")
    state = station.wait(lambda state: named(state, "PAGE CLOCK"), "a report")
    assert re.search(r"stepped by 3(600|599)\.\d s",
                     named(state, "PAGE CLOCK")[0]["text"])


def test_gnd51_an_old_page_must_reload_and_only_watches(station):
    class Old(Console):
        def say(self, message):
            self.socket.send(json.dumps(message))
    old = Old(station.port)
    assert old.hello["protocol"] == PROTOCOL
    old.say({"t": "take"})
    state = station.wait(lambda state: named(state, "RELOAD PAGE"),
                         "a caution")
    assert state["holder"] is None
    assert (f"console {old.number} is older than the station: reload its page"
            in named(state, "RELOAD PAGE")[0]["text"])
    # It sees that itself.
    until(lambda: "RELOAD PAGE" in {
        alert["name"] for alert in old.next("alerts")["alerts"]}, "the alert")
    old.close()
    station.wait(lambda state: not named(state, "RELOAD PAGE")[0]["active"],
                 "the end of it")


@pytest.mark.parametrize("stamp", [
    '"sequence": 1', '"sent_ms": 1', '"sequence": 0, "sent_ms": 1',
    '"sequence": 1.5, "sent_ms": 1', '"sequence": true, "sent_ms": 1',
    '"sequence": 1, "sent_ms": true', '"sequence": 1, "sent_ms": -1',
    '"sequence": 1, "sent_ms": NaN', '"sequence": 1, "sent_ms": Infinity',
    '"sequence": 1, "sent_ms": "1"', '"sequence": 1, "sent_ms": 1e14',
    '"sequence": 9007199254740993, "sent_ms": 1'])
def test_gnd51_a_number_or_time_that_is_none_is_not_understood(stamp):
    assert web.understood('{"t": "take", ' + stamp + "}") is None


def test_gnd51_number_and_time_are_understood():
    assert web.understood('{"t": "take", "sequence": 7, "sent_ms": 12.5}') == {
        "t": "take", "sequence": 7, "sent_s": 0.0125}

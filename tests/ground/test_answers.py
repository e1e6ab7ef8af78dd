# SPDX-License-Identifier: Apache-2.0
"""GND-58, D-59: who flies is the node's answer, and refused sticks are reported."""

import socket
import threading
import time

import pytest

from station_rig import Station, until
from test_ages import Node
from test_page import Pages
from urv import packets
from urv.answers import (
    NOBODY, OTHER, PILOT, UNANSWERED_S, US, Answers, first_sequence)
from urv.controls import Controls
from urv.packets import ConsoleState, Pilot
from urv.sticks import SILENT_S

WORDS = (3000, 2048, 2048, 2048, 2048, *[0] * 8)


@pytest.mark.parametrize("state, sequence, pilot, flies", [
    (ConsoleState.LIVE, 1001, Pilot.NONE, US),
    (ConsoleState.LIVE, 1000, Pilot.NONE, OTHER),
    (ConsoleState.LIVE, 1, Pilot.HANDS_OFF, OTHER),
    (ConsoleState.HELD, 1001, Pilot.NONE, NOBODY),
    (ConsoleState.NEUTRAL, 0, Pilot.NONE, NOBODY),
    (ConsoleState.NONE, 0, Pilot.NONE, NOBODY),
    (ConsoleState.HELD, 0, Pilot.FLIES, PILOT)])
def test_gnd58_who_flies_is_what_the_frame_says(state, sequence, pilot, flies):
    answers = Answers()
    answers.sent(1001, 10.0)
    frame = Node().made(5, console_state=state, console_sequence=sequence,
                        pilot=pilot)
    answers.look(frame, 10.02, 10.03)
    assert answers.flies == flies
    assert answers.stick_ms == (30.0 if flies == US else None)


def test_d59_each_station_begins_at_a_number_of_its_own():
    numbers = {first_sequence() for _ in range(100)}
    assert len(numbers) > 95
    assert all(0 <= number < 2**31 for number in numbers)


class Flight(Node):
    """A holder whose sticks the node takes, or does not."""

    def __init__(self):
        super().__init__()
        self.taken = []
        self.controls = Controls(self.seen, self.take, now=self.clock)
        self.is_taking = True
        self.dropped = 0
        self.sequence = 0
        self.state = ConsoleState.NONE
        self.controls.hears(1, {"t": "take"})

    def take(self, data):
        packet = packets.ConsolePacket.decode(data)
        if self.is_taking:
            self.taken.append(packet)
        else:
            self.dropped += 1

    def step(self, moves=True, **changes):
        """A frame later."""
        if moves:
            self.controls.hears(1, {"t": "sticks", "words": WORDS})
        self.controls.tick()
        counts = [0] * len(packets.LINK_COUNTS)
        counts[packets.LINK_COUNTS.index("console_bad")] = self.dropped
        self.comes(self.sequence, **{
            "counts": tuple(counts),
            "console_state": (ConsoleState.LIVE if self.taken
                              else ConsoleState.NONE),
            "console_sequence": (self.taken[-1].sequence if self.taken
                                 else 0), **changes})
        self.sequence += 1


def test_gnd58_sticks_that_the_node_refuses_are_reported_within_a_second():
    flight = Flight()
    for _ in range(100):
        flight.step()
        assert not {"STICKS REFUSED", "CONSOLE PACKETS DROPPED"} & (
            flight.active())
    assert flight.seen.shown()["flies"] == US
    flight.is_taking = False
    refused_at = flight.clock.now
    while "STICKS REFUSED" not in flight.active():
        flight.step(console_state=ConsoleState.LIVE, console_sequence=77)
        assert flight.clock.now - refused_at < 1.0
        # A packet that is dropped is reported with the next frame.
        assert "CONSOLE PACKETS DROPPED" in flight.active() or (
            flight.dropped == 0)
    assert flight.clock.now - refused_at >= UNANSWERED_S - 0.05
    assert flight.seen.shown()["flies"] == OTHER
    flight.is_taking = True
    for _ in range(100):
        flight.step()
    assert not {"STICKS REFUSED", "CONSOLE PACKETS DROPPED"} & (
        flight.active())


@pytest.mark.parametrize("frames_stop", [True, False])
def test_gnd58_what_is_not_known_is_not_refused(frames_stop):
    """No frames come, or the page sends nothing."""
    flight = Flight()
    for _ in range(50):
        flight.step()
    for _ in range(50):
        if frames_stop:
            flight.clock.now += packets.FRAME_S
            flight.controls.hears(1, {"t": "sticks", "words": WORDS})
            flight.controls.tick()
        else:
            flight.step(moves=False)
    assert "STICKS REFUSED" not in flight.active()
    assert SILENT_S < UNANSWERED_S


class Rival(threading.Thread):
    """Another station, which flies already."""

    def __init__(self, node):
        super().__init__(daemon=True)
        self.to = ("127.0.0.1", node.console_port)
        self.ends = threading.Event()

    def __enter__(self):
        self.start()
        return self

    def __exit__(self, *_):
        self.ends.set()
        self.join()

    def run(self):
        sequence = 0
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            while not self.ends.wait(0.01):
                sequence += 1
                sender.sendto(packets.ConsolePacket(
                    3, sequence, time.time_ns() // 1000, WORDS).encode(),
                    self.to)


@pytest.fixture
def record(standard):
    return standard / "record.csv"


def test_gnd58_two_stations_and_the_page_says_who_really_flies(
        record, tmp_path, browser):
    with Station(record, tmp_path) as station:
        station.flying()
        pages = Pages(browser, station)
        page = pages.open()

        def says(text):
            until(lambda: text in page.locator("#holder").inner_text(), text)
        with Rival(station.node):
            says("another station flies")
            page.keyboard.press("t")
            says("ANOTHER STATION flies, you REFUSED")
            station.wait(lambda state: {
                "STICKS REFUSED", "CONSOLE PACKETS DROPPED"} <= {
                    alert["name"] for alert in state["alerts"]
                    if alert["active"]}, "the alerts")
            assert page.locator("#holder.mine").count() == 0
        says("YOU fly")
        station.wait(lambda state: not {
            "STICKS REFUSED", "CONSOLE PACKETS DROPPED"} & {
                alert["name"] for alert in state["alerts"]
                if alert["active"]}, "their end")
        for context in pages.contexts:
            context.close()
        assert pages.errors == []

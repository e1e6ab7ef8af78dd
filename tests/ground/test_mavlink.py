# SPDX-License-Identifier: Apache-2.0
"""GND-40, GND-41: the flight as MAVLink 2, as the client pymavlink receives
it. The frames are those of the standard flight's record, sent as fast as the
client takes them: rates are counted in frames."""

import csv
import ctypes
import math
import os
import random
import signal
import socket
import subprocess
import time
from dataclasses import replace
from pathlib import Path

import pytest
from conftest import TIME_LIMIT_S, URV
from test_ground import Ground

os.environ["MAVLINK20"] = "1"

from pymavlink import mavutil  # noqa: E402 - after the version is chosen
from pymavlink.dialects.v20 import common  # noqa: E402

from fake_node import laws_row  # noqa: E402
from urv import items, mavlink, packets  # noqa: E402
from urv.packets import (  # noqa: E402
    NEVER, ConsoleState, FramePacket, LinkState, LogRow, Pilot)

KNOT = 1852 / 3600
FEET = 0.3048
NO_LOG = (LogRow(),) * packets.ROWS_PER_LOG
FLOWN_S = 60
FRAMES = 50 * FLOWN_S

# The flight of make fly turns from its 15th second on.
FIRST = 500


def frame_of(row, sequence, **changes):
    """The packet of a row, with a good link."""
    words = tuple(int(row[name]) for name in packets.COLUMNS)
    return FramePacket(**{
        "run": 1, "sequence": sequence, "time_us": sequence * 20_000,
        "downlink_age": 0, "console_state": ConsoleState.NONE,
        "link_state": LinkState.HEARD, "console_sequence": 0,
        "counts": (0,) * len(packets.LINK_COUNTS), "words": words,
        "logs": (NO_LOG, NO_LOG), "status": (0,) * len(packets.STATUS),
        "pilot": Pilot.NONE, **changes})


@pytest.fixture(scope="module")
def rows(standard):
    with (standard / "record.csv").open(encoding="ascii") as file:
        return list(csv.DictReader(file))[FIRST:FIRST + FRAMES]


def heed_signals():
    """Whoever runs the tests may have them ignored."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Client:
    """A ground station of somebody else's, and bin/urv mavlink beside it."""

    def __init__(self):
        self.link = mavutil.mavlink_connection("udpin:127.0.0.1:0")
        port = self.link.port.getsockname()[1]
        self.program = subprocess.Popen(
            [URV, "mavlink", "--listen", "udp:127.0.0.1:0",
             "--to", f"udp:127.0.0.1:{port}"],
            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
            preexec_fn=heed_signals)
        said = self.program.stdout.readline()
        self.to = ("127.0.0.1", int(said.split()[2].rpartition(":")[2]))
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.messages = []

    def send(self, data):
        self.socket.sendto(data, self.to)

    def await_message(self, shows):
        """Takes what comes up to the message that shows it."""
        deadline = time.monotonic() + TIME_LIMIT_S
        while True:
            message = self.link.recv_match(blocking=True, timeout=1)
            assert time.monotonic() < deadline, "it does not come"
            if message is not None:
                self.messages.append(message)
                if shows(message):
                    return message

    def fly(self, frames):
        """Sends frames, and waits now and then until what is due with them
        has come: a datagram that finds no room is lost."""
        for frame in frames:
            self.send(frame.encode())
            if frame.sequence % mavlink.STATUS == 0:
                # It is sent even when the machine was late.
                self.await_message(
                    lambda message: message.get_type() == "SYS_STATUS")

    def of(self, name):
        return [message for message in self.messages
                if message.get_type() == name]

    def end(self):
        self.program.send_signal(signal.SIGINT)
        out, err = self.program.communicate(timeout=TIME_LIMIT_S)
        assert (self.program.returncode, err) == (0, "")
        return out

    def close(self):
        if self.program.poll() is None:
            self.program.kill()
            self.program.communicate()
        self.socket.close()
        self.link.close()


@pytest.fixture
def client():
    made = Client()
    yield made
    made.close()


class Clock:
    """One that the test moves."""

    def __init__(self):
        self.now = 10.0

    def __call__(self):
        return self.now


class Messages:
    """Replaces the network: the messages sent, as pymavlink reads them."""

    def __init__(self):
        self.all = []
        self._reader = common.MAVLink(None)

    def write(self, data):
        self.all += self._reader.parse_buffer(bytes(data)) or []

    def take(self, kind=None):
        """Those since the last time."""
        taken, self.all = self.all, []
        return [message for message in taken
                if kind in (None, message.get_type())]


@pytest.fixture
def sent():
    return Messages()


class Timely(mavlink.Bridge):
    """Each frame comes when it was made. A new run begins a second after the
    one before, and with two frames: one alone shows nothing yet (GND-57)."""

    def __init__(self, sender):
        self.clock = Clock()
        self.run = None
        super().__init__(sender, self.clock)

    def datagram(self, data):
        frame = FramePacket.decode(data)
        if frame.run != self.run:
            first = self.run is None
            self.run = frame.run
            self.clock.now += 1.0
            self.began = self.clock.now - frame.sequence * packets.FRAME_S
            if not first:
                super().datagram(data)
                frame = replace(frame, sequence=frame.sequence + 1)
        self.clock.now = max(self.clock.now, self.began
                             + frame.sequence * packets.FRAME_S)
        super().datagram(frame.encode())


@pytest.fixture
def bridge(sent):
    return Timely(sent)


def value(row, name, group="gsc.downlink"):
    column = f"{group}.{name}"
    return items.COLUMNS[column].value(int(row[column]))


def assert_attitude(message, row):
    for angle, name in ((message.roll, "roll_attitude"),
                        (message.pitch, "pitch_attitude"),
                        (message.rollspeed, "roll_rate"),
                        (message.pitchspeed, "pitch_rate"),
                        (message.yawspeed, "yaw_rate")):
        assert math.degrees(angle) == pytest.approx(
            value(row, name), abs=1e-5, rel=1e-6), name
    assert math.isnan(message.yaw)


def assert_servos(message, row):
    pulses = [getattr(message, f"servo{place}_raw") for place in range(1, 17)]
    for pulse, name in zip(pulses, (
            "left_aileron", "right_aileron", "left_elevator",
            "right_elevator", "left_rudder", "right_rudder", "left_flap_1",
            "right_flap_1", "left_flap_2", "right_flap_2")):
        word = int(row[f"gsc.downlink.{name}"])
        assert abs((pulse - 1500) * 4.096 - (word - 2048)) <= 2.1, name
    assert pulses[10:] == [0] * 6


def assert_hud(message, row):
    assert message.airspeed == pytest.approx(
        KNOT * value(row, "airspeed"), rel=1e-6)
    assert message.alt == pytest.approx(
        FEET * (value(row, "altitude") + value(row, "altitude_offset")),
        rel=1e-6)
    throttle = value(row, "throttle", "gsc.uplink")
    assert abs(message.throttle - throttle) <= 0.5
    assert math.isnan(message.groundspeed)
    assert message.heading == -1


def assert_status(message, row):
    assert abs(message.voltage_battery / 1000
               - value(row, "battery_volts")) <= 0.0005 + 1e-9
    assert message.drop_rate_comm == 0
    assert (message.onboard_control_sensors_health
            == message.onboard_control_sensors_present != 0)


def assert_radio(message, row):
    assert abs(message.remrssi / 1.9 - 127
               - value(row, "uplink_signal_strength")) <= 0.5 / 1.9 + 1e-9
    assert message.rssi == 255


def test_gnd40_every_frame_comes_to_another_program(rows, client):
    flown = FRAMES - mavlink.STATUS + 1
    client.fly([frame_of(row, sequence)
                for sequence, row in enumerate(rows[:flown])])
    assert client.of("BAD_DATA") == []
    numbers = [message.get_seq() for message in client.messages]
    assert numbers == [place % 256 for place in range(len(numbers))]
    said = client.end()
    assert f" {flown} frames, 0 missing, 0 bad, " in said
    assert said.endswith(" messages, 0 not sent\n")


def test_gnd40_every_kind_comes_at_its_rate_with_the_record_s_values(
        rows, bridge, sent):
    for sequence, row in enumerate(rows):
        bridge.datagram(frame_of(row, sequence).encode())
    messages = sent.take()

    def of(name):
        return [message for message in messages
                if message.get_type() == name]

    for name, every in (("HEARTBEAT", 50), ("ATTITUDE", 2), ("VFR_HUD", 5),
                        ("SERVO_OUTPUT_RAW", 5), ("SYS_STATUS", 25),
                        ("RADIO_STATUS", 50)):
        assert abs(len(of(name)) - FRAMES / every) <= 1, name

    # A message without a time follows one of its frame that has one.
    seen, place = set(), 0
    for message in messages:
        name = message.get_type()
        seen.add(name)
        if name == "ATTITUDE":
            place = message.time_boot_ms // 20
            assert_attitude(message, rows[place])
        elif name == "SERVO_OUTPUT_RAW":
            place = message.time_usec // 20_000
            assert_servos(message, rows[place])
        elif name == "VFR_HUD":
            assert_hud(message, rows[place])
        elif name == "SYS_STATUS":
            assert_status(message, rows[place])
        elif name == "RADIO_STATUS":
            assert_radio(message, rows[place])
        elif name == "HEARTBEAT":
            assert message.type == common.MAV_TYPE_FIXED_WING
            assert message.system_status == common.MAV_STATE_ACTIVE
        assert message.get_srcSystem() == 1
    assert seen == {"HEARTBEAT", "ATTITUDE", "VFR_HUD", "SERVO_OUTPUT_RAW",
                    "SYS_STATUS", "RADIO_STATUS", "STATUSTEXT"}
    bank = [math.degrees(message.roll) for message in of("ATTITUDE")]
    climb = [message.climb for message in of("VFR_HUD")]
    assert min(bank) < -20 and max(bank) > 20
    assert max(climb) - min(climb) > 0.5


def test_gnd40_a_flight_in_real_time_comes_whole(tmp_path):
    """bin/urv ground starts it: what arrives is what the record has."""
    link = mavutil.mavlink_connection("udpin:127.0.0.1:0")
    port = link.port.getsockname()[1]
    taken, seen = [], set()
    with Ground(tmp_path, "--no-yamcs",
                "--mavlink", f"udp:127.0.0.1:{port}") as ground:
        deadline = time.monotonic() + TIME_LIMIT_S
        while len(taken) < 250 or len(seen) < 7:
            assert time.monotonic() < deadline, seen
            message = link.recv_match(blocking=True, timeout=1)
            if message is not None:
                taken.append(message)
                seen.add(message.get_type())
    link.close()
    assert ground.status == 0, ground.said()
    assert seen == {"HEARTBEAT", "ATTITUDE", "VFR_HUD", "SERVO_OUTPUT_RAW",
                    "SYS_STATUS", "RADIO_STATUS", "STATUSTEXT"}
    flown = {int(row["frame"]): row for row in ground.record()}
    for message in taken:
        if message.get_type() == "ATTITUDE":
            assert_attitude(message, flown[message.time_boot_ms // 20])
        elif message.get_type() == "SERVO_OUTPUT_RAW":
            assert_servos(message, flown[message.time_usec // 20_000])


def test_gnd40_the_climb_is_that_of_the_path(rows, bridge, sent):
    """In the middle of the standard flight it climbs 720 ft/min."""
    heights = []
    for sequence, row in enumerate(rows):
        bridge.datagram(frame_of(row, sequence).encode())
    huds = sent.take("VFR_HUD")
    for message in huds:
        heights.append(message.alt)
    # Over ten seconds the reckoned and the measured climb agree.
    for first in range(0, len(huds) - 100, 50):
        reckoned = sum(message.climb for message
                       in huds[first:first + 100]) / 100
        measured = (heights[first + 100] - heights[first]) / 10
        assert abs(reckoned - measured) < 0.4


def test_gnd41_what_is_stale_is_not_sent_as_fresh(rows, bridge, sent):
    row = rows[0]
    told = {"HEARTBEAT", "SYS_STATUS", "RADIO_STATUS", "ATTITUDE", "VFR_HUD",
            "SERVO_OUTPUT_RAW", "STATUSTEXT"}
    for sequence in range(100):
        bridge.datagram(frame_of(row, sequence).encode())
    assert {message.get_type() for message in sent.take()} == told

    for sequence in range(100, 200):
        age = sequence - 99
        bridge.datagram(frame_of(
            row, sequence, downlink_age=age,
            link_state=LinkState.HEARD if age <= 50 else LinkState.LOST,
        ).encode())
    stale = sent.take()
    assert {message.get_type() for message in stale} == {
        "HEARTBEAT", "SYS_STATUS", "RADIO_STATUS", "STATUSTEXT"}
    for message in stale:
        if message.get_type() == "SYS_STATUS":
            assert message.voltage_battery == 65_535
            assert message.onboard_control_sensors_health == 0
        elif message.get_type() == "RADIO_STATUS":
            assert message.remrssi == 255
    assert stale[-2].get_type() != "HEARTBEAT"
    assert [message.get_type() for message in stale].count("HEARTBEAT") == 1
    assert [message.drop_rate_comm for message in stale
            if message.get_type() == "SYS_STATUS"][-1] == 10_000
    assert [(message.severity, message.text) for message in stale
            if message.get_type() == "STATUSTEXT"] == [(2, "link lost")]

    # With the first fresh frame all is there again.
    bridge.datagram(frame_of(row, 201).encode())
    assert {message.get_type() for message in sent.take()} >= {
        "ATTITUDE", "VFR_HUD", "SERVO_OUTPUT_RAW", "HEARTBEAT"}


def test_gnd41_nothing_is_known_before_the_first_downlink(
    rows, bridge, sent
):
    for sequence in range(100):
        bridge.datagram(frame_of(
            rows[0], sequence, downlink_age=NEVER,
            link_state=LinkState.NEVER_HEARD).encode())
    assert {message.get_type() for message in sent.take()} == {
        "SYS_STATUS", "RADIO_STATUS"}


def test_gnd40_new_errors_are_reported_with_their_severity(rows, bridge, sent):
    def log(**counts):
        return tuple(
            LogRow(counts.get(kind, 0), 1, 1, 0) for kind in packets.KINDS
        ) + (LogRow(),) * (packets.ROWS_PER_LOG - len(packets.KINDS))

    def texts(sequence, gsc, mcs):
        bridge.datagram(frame_of(
            rows[0], sequence, logs=(log(**gsc), log(**mcs))).encode())
        return [(message.severity, message.text)
                for message in sent.take("STATUSTEXT")
                if not message.text.startswith("link ")]

    assert texts(0, {}, {}) == []
    assert texts(1, {"no_input": 1}, {"rom_check_failed": 1}) == [
        (6, "gsc no_input: 1"), (2, "mcs rom_check_failed: 1")]
    assert texts(2, {"no_input": 1}, {"rom_check_failed": 1}) == []

    # A flood of one kind is told once in a second at most, with how many
    # were left out.
    for sequence in range(3, 51):
        assert texts(sequence, {"no_input": sequence}, {}) == []
    assert texts(51, {"no_input": 77}, {"link_reset": 2}) == [
        (6, "gsc no_input: 77, 75 left out"),
        (4, "mcs link_reset: 2, 1 left out")]
    longest = max(packets.KINDS, key=len)
    assert texts(200, {longest: 4_294_967_295}, {}) == [
        (6, f"gsc {longest}: 4294967295, 4294967294 left out"[:50])]


def log_of(**rows):
    made = list(NO_LOG)
    for kind, row in rows.items():
        made[packets.KINDS.index(kind)] = LogRow(*row, 0)
    return tuple(made)


def test_gnd45_every_start_is_reported_and_a_cold_one_in_flight_is_critical(
        rows, bridge, sent):
    def texts(sequence, mcs=NO_LOG, run=1):
        bridge.datagram(frame_of(
            rows[0], sequence, run=run, logs=(NO_LOG, mcs)).encode())
        return [(message.severity, message.text)
                for message in sent.take("STATUSTEXT")
                if not message.text.startswith("link ")]

    assert texts(0) == []
    assert texts(1, log_of(processor_restart=(1, 40, 40))) == [
        (4, "mcs processor_restart: 1")]
    # Two between two looks, and one with the same count after a cold start.
    assert texts(2, log_of(processor_restart=(3, 40, 90))) == [
        (4, "mcs processor_restart: 2")]
    assert texts(3, log_of(processor_restart=(3, 10, 30))) == [
        (2, "mcs cold_start: 1 in flight"), (4, "mcs processor_restart: 3")]
    assert texts(0, run=2) == [(4, "gsc cold_start: 1")]


def test_gnd45_a_lost_link_is_not_buried(rows, bridge, sent):
    """A minute of what a lost link causes: it is told each 10 s, alone."""
    for sequence in range(60 * 50):
        count = max(0, sequence - 50)
        row = (count, 51, sequence)
        bridge.datagram(frame_of(
            rows[0], sequence, downlink_age=count,
            link_state=(LinkState.LOST if sequence > 100
                        else LinkState.HEARD),
            logs=(log_of(no_input=row, telin_no_block=row,
                         core_no_downlink=row, link_reset=row)
                  if count else NO_LOG, NO_LOG)).encode())
    texts = [message.text for message in sent.take("STATUSTEXT")]
    after = texts[texts.index("link lost"):]
    assert after == ["link lost", *(
        f"link lost for {seconds} s" for seconds in range(10, 60, 10))]
    bridge.datagram(frame_of(
        rows[0], 3000, logs=(log_of(no_input=(2950, 51, 2999)),
                             NO_LOG)).encode())
    assert [message.text for message in sent.take("STATUSTEXT")][:2] == [
        "link heard", "gsc no_input: 2950, 2948 left out"]


def test_gnd47_a_link_whose_blocks_are_refused_is_reported(rows, bridge, sent):
    for sequence in range(100):
        refused = (sequence, 1, sequence)
        bridge.datagram(frame_of(
            rows[0], sequence, downlink_age=NEVER,
            link_state=LinkState.NEVER_HEARD,
            logs=(log_of(block_refused=refused) if sequence else NO_LOG,
                  NO_LOG)).encode())
    messages = sent.take()
    assert "HEARTBEAT" not in {each.get_type() for each in messages}
    assert [(each.severity, each.text) for each in messages
            if each.get_type() == "STATUSTEXT"] == [
        (2, "link refused: 1 blocks"), (2, "link refused: 51 blocks")]


def test_gnd40_an_aircraft_that_flies_is_armed(rows, bridge, sent):
    landed = dict(rows[0])
    for name in ("airspeed", "altitude"):
        landed[f"gsc.downlink.{name}"] = 0
    for sequence, row, armed, state in (
            (0, landed, 0, 3), (50, rows[0], 128, 4), (100, landed, 0, 3)):
        bridge.datagram(frame_of(row, sequence).encode())
        [beat] = sent.take("HEARTBEAT")
        assert (beat.base_mode & 128, beat.system_status) == (armed, state)
    # An unknown message changes nothing.
    bridge.datagram(frame_of(rows[0], 101).encode())
    bridge.datagram(frame_of(landed, 150, downlink_age=3).encode())
    [beat] = sent.take("HEARTBEAT")
    assert beat.base_mode & 128


UNKNOWN = {
    "SYS_STATUS": {"current_battery": -1, "battery_remaining": -1},
    "RADIO_STATUS": {"rssi": 255, "noise": 255, "remnoise": 255},
    "VFR_HUD": {"heading": -1}}
NEVER_KNOWN = {"SYS_STATUS": {"voltage_battery": 65_535},
               "RADIO_STATUS": {"remrssi": 255}}
"""The value of each field that means "unknown" in common.xml; VFR_HUD has
none for its heading, -1 is no heading."""


def test_gnd41_what_nobody_knows_has_the_value_that_says_so(
        rows, bridge, sent):
    bridge.datagram(frame_of(rows[0], 0).encode())
    found = {each.get_type(): each for each in sent.take()}
    for name, fields in UNKNOWN.items():
        for each, value_of_it in fields.items():
            assert getattr(found[name], each) == value_of_it, (name, each)
    assert math.isnan(found["ATTITUDE"].yaw)
    assert math.isnan(found["VFR_HUD"].groundspeed)
    bridge.datagram(frame_of(
        rows[0], 0, run=2, downlink_age=NEVER).encode())
    found = {each.get_type(): each for each in sent.take()}
    for name, fields in NEVER_KNOWN.items():
        for each, value_of_it in fields.items():
            assert getattr(found[name], each) == value_of_it, (name, each)


def test_gnd46_a_former_run_that_is_late_changes_nothing(rows, sent):
    clock = Clock()
    bridge = mavlink.Bridge(sent, clock)
    for now, sequence, run in (
            (10.0, 500, 9), (10.02, 501, 9), (10.2, 0, 4), (10.22, 1, 4),
            (10.23, 502, 9), (10.24, 2, 4)):
        clock.now = now
        bridge.datagram(frame_of(rows[0], sequence, run=run).encode())
    # One packet of another run alone shows nothing yet.
    assert (bridge.frames, bridge.bad, bridge.missing) == (4, 2, 0)


ALIVE = {"ATTITUDE", "HEARTBEAT", "VFR_HUD", "SERVO_OUTPUT_RAW"}


def test_gnd56_a_bridge_that_stood_still_sends_nothing_old_as_fresh(
        rows, sent):
    """Three seconds of frames wait for it, and come at once."""
    clock = Clock()
    bridge = mavlink.Bridge(sent, clock)
    texts = []

    def send(sequence):
        bridge.datagram(frame_of(rows[0], sequence).encode())
        messages = sent.take()
        texts.extend(message.text for message in messages
                     if message.get_type() == "STATUSTEXT")
        return messages
    for sequence in range(100):
        clock.now += packets.FRAME_S
        send(sequence)
    clock.now += 3.0
    kinds = set()
    for sequence in range(100, 250):
        late_s = (249 - sequence) * packets.FRAME_S
        for message in send(sequence):
            kind = message.get_type()
            if late_s < 0.51:
                kinds.add(kind)
                continue
            assert kind not in ALIVE, late_s
            if kind == "SYS_STATUS":
                assert message.voltage_battery == 65_535
                assert message.onboard_control_sensors_health == 0
    assert {"ATTITUDE", "VFR_HUD", "SERVO_OUTPUT_RAW"} <= kinds
    assert texts == ["link heard", "frames 3.0 s late", "frames in time"]


def test_gnd57_a_fault_of_the_bridge_costs_one_frame(
        rows, bridge, sent, monkeypatch):
    bridge.datagram(frame_of(rows[0], 0).encode())
    with monkeypatch.context() as broken:
        broken.setattr(mavlink.Flight, "texts", lambda *_: 1 // 0)
        bridge.datagram(frame_of(rows[0], 1).encode())
    assert bridge.bad == 1
    sent.take()
    bridge.datagram(frame_of(rows[0], 2).encode())
    assert sent.take("ATTITUDE") and bridge.bad == 1


def test_gnd57_words_and_counts_of_all_bits_are_carried(rows, bridge, sent):
    """Such as no converter gives."""
    words = (2**16 - 1,) * len(packets.COLUMNS)
    log = (LogRow(*(2**32 - 1,) * 3, 2**16 - 1),) * packets.ROWS_PER_LOG
    for sequence in range(0, 200, 2):
        bridge.datagram(frame_of(
            rows[0], sequence, words=words, logs=(log, log),
            counts=(2**32 - 1,) * len(packets.LINK_COUNTS)).encode())
        sent.take()
        bridge.datagram(frame_of(rows[0], sequence + 1).encode())
        assert [message.time_boot_ms for message in sent.take("ATTITUDE")
                ] in ([], [20 * (sequence + 1)])
    bridge.datagram(frame_of(rows[0], 225).encode())
    assert sent.take("ATTITUDE") and bridge.bad == 0


def test_gnd7_the_laws_report_is_sent_once(rows, bridge, sent):
    def texts(sequence, *words):
        log = (*NO_LOG[:-1], laws_row(*words))
        bridge.datagram(frame_of(
            rows[0], sequence, logs=(NO_LOG, log)).encode())
        return [(message.severity, message.text)
                for message in sent.take("STATUSTEXT")
                if not message.text.startswith("link ")]

    assert texts(0) == []
    assert texts(1, 0x1133) == [(6, "laws: wings level/altitude/airspeed")]
    assert texts(2, 0x1133) == []
    assert texts(3, 0x2133, 0, 1 << 8, 30, 1) == [
        (2, "alone: holding"), (4, "airspeed not valid"),
        (2, "left_aileron failed")]
    assert texts(4, 0x1133, 0, 1 << 8, 30, 1) == []
    assert texts(5, 0x1133, 0xFFFF, 0x7FF) == [(4, "no sensor is valid")]


def test_gnd7_a_sensor_that_is_not_believed_is_not_healthy(
        rows, bridge, sent):
    def ill(sequence, *words):
        log = (*NO_LOG[:-1], laws_row(*words))
        bridge.datagram(frame_of(
            rows[0], sequence, logs=(NO_LOG, log)).encode())
        [message] = sent.take("SYS_STATUS")
        return (message.onboard_control_sensors_present
                & ~message.onboard_control_sensors_health)

    assert ill(0, 0x1000) == 0
    airspeed, roll_rate = 1 << 8, 1 << 5
    assert ill(25, 0x1000, 0, roll_rate) == 1
    assert ill(50, 0x1000, 0, airspeed) == 16


def test_gnd40_another_run_of_the_node_starts_from_zero(rows, bridge, sent):
    for sequence in range(100):
        bridge.datagram(frame_of(rows[0], sequence).encode())
    sent.take()
    bridge.datagram(frame_of(rows[0], 0, run=2).encode())
    assert [message.time_boot_ms for message in sent.take("ATTITUDE")] == [20]
    assert bridge.missing == 0


def test_gnd40_missing_and_old_frames_are_counted(rows, bridge, sent):
    for sequence in (0, 1, 4, 3, 4, 5):
        bridge.datagram(frame_of(rows[0], sequence).encode())
    assert (bridge.frames, bridge.missing, bridge.bad) == (4, 2, 2)
    assert [message.time_boot_ms for message
            in sent.take("ATTITUDE")] == [0, 80]


def test_gnd40_a_signal_that_interrupts_no_wait_ends_it(client):
    """As one that comes just before a wait. No packet comes, either."""
    main = client.program.pid
    tasks = Path(f"/proc/{main}/task")
    deadline = time.monotonic() + TIME_LIMIT_S
    while " S " not in (tasks / str(main) / "stat").read_text():
        assert time.monotonic() < deadline, "it does not wait"
        time.sleep(0.01)
    other = next(int(task.name) for task in tasks.iterdir()
                 if task.name != str(main))
    assert ctypes.CDLL(None).tgkill(main, other, signal.SIGINT) == 0
    out, err = client.program.communicate(timeout=TIME_LIMIT_S)
    assert (client.program.returncode, err) == (0, "")
    assert "mavlink: 0 frames" in out


def test_gnd40_garbage_is_counted_and_harms_nothing(rows, client):
    chance = random.Random(7)
    for length in (0, 1, 2, 50, 1107, 1108, 1109, 4096, 9000):
        client.send(chance.randbytes(length))
    client.fly([frame_of(rows[0], sequence) for sequence in range(51)])
    assert client.of("ATTITUDE")
    assert " 51 frames, 0 missing, 9 bad, " in client.end()


@pytest.mark.parametrize("arguments, what", [
    (("--listen", "udp:0.0.0.0:6005"), "not this machine's loopback"),
    (("--listen", "6005"), "not udp:HOST:PORT"),
    (("--to", "serial:x"), "not udp:HOST:PORT"),
    (("--listen", "udp:127.0.0.1:0", "--to", "udp:no-such.invalid:1"),
     "there is no host"),
])
def test_gnd40_what_is_wrong_is_said(urv, arguments, what):
    result = urv("mavlink", *arguments)
    assert (result.returncode, result.stdout) == (2, "")
    assert len(result.stderr.splitlines()) == 1 and what in result.stderr

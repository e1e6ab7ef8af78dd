# SPDX-License-Identifier: Apache-2.0
"""GND-40: the flight as a ground station sees it that shares no line with
pymavlink: MAVSDK, in C++."""

import signal
import socket
import subprocess

import pytest
from conftest import URV
from fake_node import FakeNode
from ports import free_ports
from station_rig import until

from urv import items, packets

mavsdk = pytest.importorskip("mavsdk")
telemetry = pytest.importorskip("mavsdk.plugins.telemetry")

FRAMES = 300
FAILS_AT = 100
FRAME_US = packets.FRAME_US


class Watcher:
    """A ground station that hears one aircraft."""

    def __init__(self, port):
        self.attitudes, self.flown, self.texts = {}, [], []
        self.station = mavsdk.Mavsdk(
            mavsdk.Configuration.create_with_component_type(
                mavsdk.ComponentType.GROUND_STATION))
        self.station.add_any_connection(f"udpin://127.0.0.1:{port}")

    def find(self):
        """True if the aircraft has been found; then it is listened to."""
        # A system is counted before its autopilot is.
        system = self.station.first_autopilot(0.0)
        if system is None:
            return False
        self.aircraft = telemetry.Telemetry(system)
        self.aircraft.subscribe_attitude_euler(
            lambda one, *_: self.attitudes.update(
                {one.timestamp_us: (one.roll_deg, one.pitch_deg)}))
        self.aircraft.subscribe_fixedwing_metrics(
            lambda one, *_: self.flown.append(
                (one.airspeed_m_s, one.absolute_altitude_m)))
        self.aircraft.subscribe_status_text(
            lambda one, *_: self.texts.append((one.type, one.text)))
        return True


@pytest.fixture
def flight(standard):
    """The node's packets of the record, and its bridge to a port."""
    port = free_ports(1)[0]
    node = FakeNode(standard / "record.csv", None, row=500)
    bridge = subprocess.Popen(
        [URV, "mavlink", "--listen", "udp:127.0.0.1:0",
         "--to", f"udp:127.0.0.1:{port}"], stdout=subprocess.PIPE, text=True)
    to = int(bridge.stdout.readline().split()[2].rpartition(":")[2])
    yield node, port, ("127.0.0.1", to)
    node.socket.close()
    bridge.send_signal(signal.SIGTERM)
    bridge.wait()
    bridge.stdout.close()


@pytest.fixture
def watcher(flight):
    watcher = Watcher(flight[1])
    yield watcher
    # Its threads end before what they call.
    watcher.station.destroy()


def test_gnd40_another_kind_of_station_sees_the_flight(flight, watcher):
    node, _, to = flight
    sent, found = {}, False
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        for sequence in range(FRAMES):
            node.sequence, node.row = sequence, 500 + sequence
            if sequence == FAILS_AT:
                node.laws = (0x1000, 0, 0, 0, 1)
            frame = node.frame()
            sent[sequence * FRAME_US] = frame.columns
            sender.sendto(frame.encode(), to)
            if not found:
                # The first heartbeat is in the first frame.
                found = until(watcher.find, "the aircraft")
            elif sequence % 20 == 0:
                until(lambda at=sequence * FRAME_US: at in watcher.attitudes,
                      "the newest attitude")
    assert set(watcher.attitudes) >= set(
        range(2 * FRAME_US, 281 * FRAME_US, 2 * FRAME_US))
    # The attitudes of the last frames are still to come.
    for at, angles in watcher.attitudes.copy().items():
        for angle, name in zip(angles, ("roll_attitude", "pitch_attitude"),
                               strict=True):
            column = f"gsc.downlink.{name}"
            assert angle == pytest.approx(
                items.COLUMNS[column].value(sent[at][column]), abs=1e-3)
    until(lambda: len(watcher.flown) >= FRAMES // 5 - 5, "air data")
    until(lambda: "left_aileron failed" in {
        text for _, text in watcher.texts}, "the text of a failed surface")

# SPDX-License-Identifier: Apache-2.0
"""GND-56, GND-57, D-58, D-60: how old frames are by their own time, and that no datagram
takes the station's sight."""

import json
import random
import signal
import socket
import struct
import time

import pytest

from station_rig import Station, until
from test_node_starts import Clock, frame_of
from urv import flights, ground, packets, station as station_command, view
from urv.packets import FRAME_S, FramePacket
from urv.runs import ALIVE_S, SILENT_S

HERE = ("127.0.0.1", 5000)
THERE = ("127.0.0.1", 6000)
BEGAN_US = 1_700_000_000_000_000


class Node:
    """A ground's node, and a station that hears it."""

    def __init__(self):
        self.clock = Clock()
        self.began = self.clock.now
        self.seen = view.View(now=self.clock)
        self.run = 7
        self.utc_us = BEGAN_US

    def made(self, sequence, **changes):
        """A frame packet."""
        return frame_of(sequence, **{
            "run": self.run,
            "time_us": self.utc_us + sequence * packets.FRAME_US, **changes})

    def comes(self, sequence, late_s=0.0, sender=HERE, **changes):
        """It arrives this time after it was made, and not before an earlier
        frame."""
        self.clock.now = max(self.clock.now, self.began + late_s
                             + sequence * FRAME_S)
        return self.seen.datagram(self.made(sequence, **changes).encode(),
                                  sender)

    def come(self, first, last, **more):
        return [self.comes(each, **more) for each in range(first, last)]

    def active(self):
        return {alert["name"] for alert in self.seen.alerts.shown()
                if alert["active"]}

    def age_ms(self):
        return self.seen.shown()["age_ms"]


# Age at the source

@pytest.mark.parametrize("late_s", [0.6, 3.0, 6.0])
def test_gnd56_what_waited_in_a_queue_is_as_old_as_it_is(late_s):
    """The station is starved: the queue grows from frame to frame."""
    node = Node()
    node.come(0, 100)
    assert node.age_ms() == 0 and "FRAMES LATE" not in node.active()
    for sequence in range(100, 400):
        waits = late_s * (sequence - 99) / 300
        assert node.comes(sequence, waits)
        assert node.age_ms() == pytest.approx(1000 * waits, abs=15)
    assert "FRAMES LATE" in node.active()
    shown = node.seen.shown()
    assert shown["down_ms"] == pytest.approx(1000 * late_s - 20, abs=15)
    # It has caught up.
    node.come(400 + int(late_s / FRAME_S), 600 + int(late_s / FRAME_S))
    assert node.age_ms() < 20 and "FRAMES LATE" not in node.active()
    assert [line.text for line in node.seen.log if line.kind == "frames"] == [
        f"frames came up to {late_s:.1f} s late"]


def test_gnd56_a_burst_after_a_stop_is_old_until_its_end():
    node = Node()
    node.come(0, 100)
    node.clock.now += 3.0
    for sequence in range(100, 250):
        node.comes(sequence)
        late_s = (249 - sequence) * FRAME_S
        assert node.age_ms() == pytest.approx(1000 * late_s, abs=15)
        assert ("FRAMES LATE" in node.active()) >= (late_s >= view.LOST_S)
    assert node.seen.shown()["rate"] <= 51, "not 150 in a second"


def test_gnd56_the_first_frames_of_a_starved_station_are_no_measure():
    """Two seconds wait when it begins: the best of them is."""
    node = Node()
    node.clock.now += 2.0
    node.come(0, 200)
    node.comes(250, 0.5)
    assert node.age_ms() == pytest.approx(500, abs=15)


def test_gnd56_a_station_s_own_lines_are_of_the_frame_that_the_node_is_in():
    """A mark while frames are 2 s old."""
    node = Node()
    node.come(0, 100)
    node.come(100, 120, late_s=2.0)
    line = node.seen.note("info", "mark", "now")
    assert abs(line.frame - (119 + 100)) <= 1
    # The words of a frame are of that frame.
    assert node.seen.note("info", "error", "then", 5).frame == 119


@pytest.mark.parametrize("set_s", [-3600.0, -5.0, 5.0, 3600.0])
def test_d58_a_clock_that_is_set_makes_no_frame_older(set_s):
    """The node's UTC is set: its frames are shown again at once."""
    node = Node()
    node.come(0, 100)
    node.utc_us += round(1e6 * set_s)
    taken = node.come(100, 200)
    assert taken.index(True) * FRAME_S <= ALIVE_S + FRAME_S
    assert all(taken[taken.index(True):]) and node.age_ms() < 20
    assert [line.text for line in node.seen.log
            if "was set" in line.text] == [
        f"the clock of the ground's node was set by {set_s:.1f} s"]
    assert "COLD START GSC" not in node.active()


def test_gnd56_yamcs_gets_the_time_of_the_node_s_clock():
    """A node whose clock is an hour ahead, and frames that come late."""
    node = Node()
    node.utc_us = time.time_ns() // 1000 + 3_600_000_000
    node.come(0, 50)
    node.come(50, 100, late_s=3.0)
    before = time.time()
    ahead_s = node.seen.clock_ahead_us() / 1e6
    after = time.time()
    # The age of frame 0 by the test's clock.
    zero_s = node.utc_us / 1e6 + node.clock.now - node.began
    assert before - zero_s - 0.01 <= ahead_s <= after - zero_s + 0.01


# Far-off datagrams

FAR = 2**32 - 2


@pytest.mark.parametrize("changes", [
    {"sequence": FAR}, {"sequence": 2000}, {"time_us": 0},
    {"time_us": packets.LATEST_US}, {"time_us": BEGAN_US + 100_000_000},
    {"run": 8}, {"run": 8, "sequence": FAR, "time_us": 1}, {"sequence": 0}])
@pytest.mark.parametrize("sender", [HERE, THERE])
@pytest.mark.parametrize("many", [1, 3])
def test_gnd57_one_far_off_datagram_changes_nothing(changes, sender, many):
    node = Node()
    node.come(0, 100)
    shown = node.seen.frame
    far = FramePacket(**vars(node.made(100)) | changes).encode()
    for _ in range(many):
        node.clock.now += 0.001
        assert not node.seen.datagram(far, sender), "taken"
    assert node.seen.frame is shown
    assert node.comes(100), "the next good one"
    assert node.age_ms() < 20
    assert "COLD START GSC" not in node.active()


def test_gnd57_the_first_datagram_of_all_may_be_far_off():
    for sequence, time_us, run in ((FAR, 1, 9), (FAR, packets.LATEST_US, 7),
                                   (5, packets.LATEST_US, 9)):
        node = Node()
        node.seen.datagram(node.made(
            sequence, time_us=time_us, run=run).encode(), THERE)
        assert all(node.come(0, 10)), "the good ones"
        assert node.seen.frame.sequence == 9 and node.age_ms() < 20


def test_gnd57_a_time_that_no_calendar_has_is_no_packet():
    data = bytearray(frame_of(1).encode())
    data[16:24] = struct.pack(">Q", packets.LATEST_US + 1)
    with pytest.raises(packets.PacketError, match="time is"):
        FramePacket.decode(bytes(data))


def test_gnd57_a_second_sender_is_reported_and_not_shown():
    """Within a second; a ground that starts again is none."""
    node = Node()
    node.come(0, 100)
    for sequence in range(100, 110):
        assert not node.comes(sequence, sender=THERE)
        assert node.comes(sequence)
    [alert] = [each for each in node.seen.alerts.shown()
               if each["name"] == "TWO GROUNDS"]
    assert alert["level"] == "warning" and alert["active"]
    assert alert["text"].endswith(", from 127.0.0.1, port 6000")
    node.come(110, 600)
    assert "TWO GROUNDS" not in node.active()
    # The first one ends, and another one is started.
    node.began = node.clock.now + 1.0
    node.run = 8
    taken = node.come(0, 50, sender=THERE)
    assert taken == [False] + [True] * 49
    assert "TWO GROUNDS" not in node.active()
    assert "COLD START GSC" in node.active()


def random_packet(chance, node, sequence):
    """Any datagram: of a good one's bytes some are others."""
    if chance.random() < 0.2:
        return chance.randbytes(chance.choice((0, 8, 1108, 1332)))
    data = bytearray(node.made(
        chance.choice((sequence, sequence + 3, 0, FAR))).encode())
    for _ in range(chance.choice((1, 1, 2, 40))):
        at = chance.choice((chance.randrange(8, 76),
                            chance.randrange(len(data))))
        data[at] = chance.randrange(256)
    return bytes(data)


@pytest.mark.parametrize("seed", range(20))
def test_gnd57_whatever_comes_the_next_good_frame_is_shown(seed):
    """Between good frames comes any datagram, from the node's own address or
    from another; now and then many at once."""
    chance = random.Random(seed)
    node = Node()
    node.come(0, 3)
    for sequence in range(3, 300):
        for _ in range(chance.choice((0, 1, 1, 2, 30))):
            node.seen.datagram(random_packet(chance, node, sequence),
                               chance.choice((HERE, THERE)))
            node.seen.shown()
        # One that looks like a later frame may have come just now.
        ahead = node.seen.frame.run == node.run and (
            node.seen.frame.sequence - sequence)
        assert ahead is not False and ahead < ALIVE_S / FRAME_S
        assert node.comes(sequence) or ahead >= 0
        assert node.age_ms() <= 1000 * ALIVE_S
    assert not [line for line in node.seen.log
                if "could not be shown" in line.text]
    node.come(300, 400)
    assert node.seen.frame.sequence == 399
    for alert in node.seen.alerts.shown():
        assert 0 <= alert["came_us"] <= packets.LATEST_US


def test_gnd57_a_fault_of_the_station_costs_one_frame():
    node = Node()
    node.come(0, 10)

    def fault(frame):
        raise IndexError("7")
    look, node.seen._calibrate = node.seen._calibrate, fault
    assert not node.comes(10) and not node.comes(11)
    node.seen._calibrate = look
    assert node.comes(12)
    assert [line.text for line in node.seen.log
            if line.kind == "packet"] == [
        "a frame could not be shown: IndexError: 7"]


def test_d60_lower_numbers_of_a_run_replace_what_has_stopped():
    """A pair of packets ahead of time came while the node was silent: its own
    are shown again, and as old by what cannot be known."""
    node = Node()
    node.come(0, 50)
    node.clock.now += 2 * ALIVE_S
    for sequence in (5000, 5001):
        node.seen.datagram(node.made(sequence).encode(), HERE)
    assert node.seen.frame.sequence == 5001
    node.began = node.clock.now - 60 * FRAME_S
    taken = node.come(60, 160)
    assert taken.index(True) * FRAME_S <= SILENT_S + 2 * FRAME_S
    assert all(taken[taken.index(True):])


def test_gnd57_a_bad_line_of_the_station_s_log_costs_itself(tmp_path, capsys):
    """The lines of events.jsonl, which bin/urv report reads."""
    flight = ground.Flight(tmp_path, 1, 2, 3)
    good = {"number": 1, "time_us": 1, "frame": 50, "level": "info",
            "kind": "mark", "text": "gear"}
    (tmp_path / "ground.jsonl").write_text(
        '{"node":"gsc","kind":"a","count":1,"first_ms":0,"last_ms":0}\n')
    (tmp_path / "station.jsonl").write_text("\n".join((
        json.dumps(good), "{", "7", "{}", json.dumps(good | {"frame": "x"}),
        json.dumps(good | {"text": None}), json.dumps(good | {"frame": None}),
        json.dumps(good | {"kind": "state"}), "[" * 9_000,
        json.dumps(good | {"frame": 2 ** 32 - 1}),
        json.dumps(good | {"text": "a" * 200}), json.dumps(good))) + "\n")
    flight.collect_events()
    lines = (tmp_path / "events.jsonl").read_text().splitlines()
    assert [json.loads(line).get("kind") for line in lines] == [
        "a", "mark: gear", f"mark: {'a' * 200}", "mark: gear"]
    assert len(flights.read_events(tmp_path / "events.jsonl")) == 4
    assert capsys.readouterr().out == (
        "ground: 7 lines of station.jsonl are none and left out\n")


# In a station

@pytest.fixture
def station(standard, tmp_path):
    with Station(standard / "record.csv", tmp_path) as station:
        station.flying()
        yield station


def test_gnd56_frames_that_waited_at_a_stopped_station_are_late(station):
    """True if it shows them as old or not at all, never as new."""
    station.wait(lambda state: state["rate"] > 20 and state["age_ms"] < 200)
    station.process.send_signal(signal.SIGSTOP)
    time.sleep(3.0)
    station.process.send_signal(signal.SIGCONT)
    station.logged("frames came up to")
    station.wait(lambda state: state["age_ms"] < 200, "new frames")


def test_gnd57_a_far_off_datagram_and_a_stranger_at_the_station(station):
    station.wait(lambda state: state["rate"] > 10)
    far = station.node.sent
    changed = FramePacket(**{**vars(far), "sequence": FAR,
                             "time_us": packets.LATEST_US})
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger:
        stranger.sendto(changed.encode(), station.frames)
        state = station.wait(lambda state: [
            alert for alert in state["alerts"]
            if alert["name"] == "TWO GROUNDS"], "an alert")
    station.wait(lambda now: state["seq"] + 10 < now["seq"] < FAR, "frames")


def test_gnd57_frames_of_another_machine_than_the_sender_are_not_taken(
        standard, tmp_path):
    with Station(standard / "record.csv", tmp_path, "--sender",
                 "127.0.0.2") as station:
        state = station.wait(lambda state: state["packets"]["foreign"] > 10)
        assert "words" not in state
        assert "FOREIGN FRAMES" in {
            alert["name"] for alert in state["alerts"] if alert["active"]}


@pytest.mark.parametrize("given, written", [
    ("192.168.1.7", "192.168.1.7"), ("[::1]", "::1"), ("0:0::1", "::1"),
    ("::ffff:10.0.0.1", "10.0.0.1")])
def test_gnd57_an_address_is_compared_in_one_way_of_writing(given, written):
    assert station_command.ip_address("--sender", given) == written
    assert station_command.plain_address(written) == written


def test_gnd57_a_port_that_others_reach_is_said(standard, tmp_path):
    with Station(standard / "record.csv", tmp_path, "--frames",
                 "udp:0.0.0.0:0") as station:
        assert [line for line in station.said if
                "any machine that reaches udp:0.0.0.0 can send" in line]
        station.flying()


def test_gnd57_a_sender_that_is_no_address_is_refused(urv):
    result = urv("station", "--sender", "my host")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr == ('urv: --sender "my host": no IP address, such as'
                             " 192.168.1.7\n")

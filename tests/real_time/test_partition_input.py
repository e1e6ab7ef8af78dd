# SPDX-License-Identifier: Apache-2.0
"""SAF-4: nothing that was sent before a node was switched on, or while it stood
still, is acted upon by it, and what it sends is young. SAF-8: a node hears its
peer only. Seen from the other end of its link.
"""

import contextlib
import itertools
import os
import select
import signal
import socket
import time
import tty

import pytest

from conftest import (
    COMMANDS, SENSORS, TIME_LIMIT_S, different_rows, flies_again, free_ports,
    need, udp,
)
from peer import (
    BAD, DOWNLINK, FRAME_S, GOOD, GOOD_WANTS, STALE, UPLINK, AircraftPeer,
    data_message,
)

BEFORE, OLD, YOUNG = different_rows(3, len(COMMANDS), 11)


def uplink(commands):
    return data_message(UPLINK, (*commands, 0))


class UDPEnd:
    """The ground's end of a UDP link."""

    def __init__(self, host="127.0.0.1"):
        self.node_port, self.port = free_ports(2)
        self.link = udp(self.node_port, self.port)
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((host, self.port))
        self.file = self._socket.fileno()

    def write(self, data):
        try:
            self._socket.sendto(data, ("127.0.0.1", self.node_port))
        except ConnectionRefusedError:
            pass

    def read(self):
        try:
            return self._socket.recv(4096)
        except ConnectionRefusedError:
            return b""

    def close(self):
        self._socket.close()


class SerialEnd:
    """The ground's end of a serial line."""

    def __init__(self):
        self.file, self._device = os.openpty()
        tty.setraw(self._device)
        os.set_blocking(self.file, False)
        self.link = f"serial:{os.ttyname(self._device)}"

    def write(self, data):
        try:
            os.write(self.file, data)
        except BlockingIOError:
            pass

    def read(self):
        return os.read(self.file, 4096)

    def close(self):
        os.close(self.file)
        os.close(self._device)


def answer(line, limit_s):
    """All characters until the line is silent for this time."""
    heard = b""
    while select.select([line.file], [], [], limit_s)[0]:
        heard += line.read()
    return heard


def command(line, commands, times=10):
    """Send them until the aircraft has said so often that they came well:
    it has then had the time of as many frames to do something with them."""
    deadline = time.monotonic() + TIME_LIMIT_S
    while times > 0:
        assert time.monotonic() < deadline, "no answer"
        line.write(uplink(commands))
        heard = answer(line, FRAME_S)
        times -= bool(heard) and heard[-1] in (GOOD, GOOD_WANTS)


def await_state(run, wanted):
    """Wait until the system says that of the program's process."""
    deadline = time.monotonic() + TIME_LIMIT_S
    while True:
        with open(f"/proc/{run.program.pid}/stat", encoding="ascii") as file:
            state = file.read().rpartition(")")[2].split()[0]
        if (state == "T") == (wanted == "T"):
            return
        assert time.monotonic() < deadline
        time.sleep(0.001)


def unasked_answer(line, run):
    """A node's reports of data sent before it was switched on. At its start
    the controller discards the blocks of its board, which would hide that the
    board took one; but a board that takes a message answers."""
    run.await_begin()
    time.sleep(15 * FRAME_S)
    return answer(line, FRAME_S)


def acted_upon(outputs, commands):
    """True if the commands came to the servos or to CORE."""
    return commands in outputs.words("mcs.uplink", COMMANDS) or any(
        row["pwm.throttle"] == commands[COMMANDS.index("throttle")]
        for row in outputs.rows
    )


@pytest.mark.parametrize("copies", [1, 400])
@flies_again
def test_saf4_characters_on_a_serial_line_at_power_up_are_discarded(
    start, copies
):
    with contextlib.closing(SerialEnd()) as line:
        for _ in range(copies):
            line.write(uplink(OLD))
        run = start("mcs", line.link)
        assert unasked_answer(line, run) == b""

        # It answers what is sent to it now, so it has had the rest.
        command(line, YOUNG)
        mcs = run.stop()
    assert not acted_upon(mcs, OLD)
    need(acted_upon(mcs, YOUNG), mcs)


def await_port(port):
    """Wait until somebody has opened that UDP port."""
    deadline = time.monotonic() + TIME_LIMIT_S
    while True:
        with open("/proc/net/udp", encoding="ascii") as file:
            if f":{port:04X} " in file.read():
                return
        assert time.monotonic() < deadline
        time.sleep(0.001)


@flies_again
def test_saf4_datagrams_before_power_up_are_discarded(start):
    """A node that waits for its phase opens its port 38 ms before it is
    switched on, or more. A command that comes too late to show anything is
    sent to another node."""
    for _ in range(20):
        with contextlib.closing(UDPEnd()) as line:
            run = start("mcs", line.link, "--phase", 9)
            await_port(line.node_port)
            line.write(uplink(OLD))
            sent_at = time.monotonic()
            heard = unasked_answer(line, run)
            command(line, YOUNG)
            mcs = run.stop()
        if sent_at < mcs.summary["switched_on_us"] / 1e6:
            assert heard == b""
            assert not acted_upon(mcs, OLD)
            need(acted_upon(mcs, YOUNG), mcs)
            return
    pytest.fail("the command was never sent in time")


def pauses_of(outputs):
    """How often the node may have stood still for five frames."""
    at = [outputs.summary["switched_on_us"],
          *(row["clock_us"] for row in outputs.rows)]
    return sum(
        after - before > 100_000 for before, after in itertools.pairwise(at))


@pytest.mark.parametrize(
    "restart", [None, signal.SIGUSR1, signal.SIGUSR2],
    ids=["alone", "restart", "reset"],
)
@pytest.mark.parametrize("end", [UDPEnd, SerialEnd], ids=["udp", "serial"])
@flies_again
def test_saf4_characters_for_a_stopped_aircraft_are_discarded(
    start, end, restart
):
    with contextlib.closing(end()) as line:
        run = start("mcs", line.link)
        command(line, BEFORE)
        run.send(signal.SIGSTOP)
        await_state(run, "T")
        for _ in range(10):
            line.write(uplink(OLD))
            time.sleep(FRAME_S)
        time.sleep(0.5)
        if restart:
            run.send(restart)
        run.send(signal.SIGCONT)

        # Silence, in which it may do what it likes with what it has.
        time.sleep(0.5)
        answer(line, 0.05)
        command(line, YOUNG)
        mcs = run.stop()
    assert not acted_upon(mcs, OLD)
    assert mcs.summary["stood_still"] >= 1
    need(mcs.summary["stood_still"] <= pauses_of(mcs), mcs)
    assert mcs.summary["link"]["board_restarts"] >= 1
    need(acted_upon(mcs, YOUNG), mcs)


def test_saf4_a_ground_that_stood_still_sends_nothing_old(start, write):
    """The aircraft hears what the console holds now, not what it held when
    the ground was stopped."""
    rows = different_rows(100, len(COMMANDS), 12)
    hold_s, first_s, stopped_s = 0.1, 0.2, 2
    sticks = write("sticks.csv", "\n".join(
        ["time_ms," + ",".join(COMMANDS)]
        + [f"{round(1000 * (first_s + hold_s * place))},"
           + ",".join(map(str, row)) for place, row in enumerate(rows)]
    ) + "\n")
    own, other = free_ports(2)
    run = start("gsc", udp(own, other), "--sticks", sticks)
    with AircraftPeer(other, own, [(0x800,) * (len(SENSORS) + 1)]) as aircraft:
        aircraft.await_received(20)
        run.send(signal.SIGSTOP)
        await_state(run, "T")
        time.sleep(stopped_s)
        before = len(aircraft.received)
        run.send(signal.SIGCONT)
        aircraft.await_fresh(before, 20)
        after = list(zip(aircraft.received, aircraft.received_at))[before:]
    gsc = run.stop()
    on_at = gsc.summary["switched_on_us"] / 1e6
    # Words that say of themselves that they are old move nothing (SAF-5). The
    # last row is held for ever.
    fresh = [(words, came_at) for words, came_at in after
             if not words[-1] & STALE]
    assert fresh
    for words, came_at in fresh:
        place = rows.index(words[:-1])
        held_until = on_at + first_s + hold_s * (place + 1)
        assert place == len(rows) - 1 or came_at - held_until < stopped_s / 2
    assert gsc.summary["stood_still"] >= 1


STRANGERS = {
    "another port": ("127.0.0.1", lambda port: 0),
    "another address": ("127.0.0.2", lambda port: port),
}


@pytest.mark.parametrize("who", STRANGERS)
@flies_again
def test_saf8_a_stranger_is_not_heard_over_udp(start, who):
    host, port = STRANGERS[who]
    line = UDPEnd()
    stranger = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    stranger.bind((host, port(line.port)))
    stranger.settimeout(FRAME_S)
    run = start("mcs", line.link)
    answered = 0
    try:
        command(line, BEFORE)
        for _ in range(50):
            stranger.sendto(uplink(OLD), ("127.0.0.1", line.node_port))
            try:
                answered += bool(stranger.recv(4096))
            except (TimeoutError, ConnectionRefusedError):
                pass
        command(line, YOUNG)
        mcs = run.stop()
    finally:
        line.close()
        stranger.close()
    assert answered == 0
    assert not acted_upon(mcs, OLD)
    need(acted_upon(mcs, BEFORE) and acted_upon(mcs, YOUNG), mcs)


@flies_again
def test_saf8_a_stranger_does_not_disturb_the_ground(start):
    """Whatever a stranger sends, the ground sees its aircraft."""
    own, other = free_ports(2)
    words = tuple(range(300, 300 + len(SENSORS))) + (0,)
    strange = tuple(range(700, 700 + len(SENSORS))) + (0,)
    said = [data_message(DOWNLINK, strange), bytes([DOWNLINK, 0, BAD])]
    sent = 0
    deadline = time.monotonic() + TIME_LIMIT_S
    run = start("gsc", udp(own, other))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as stranger, \
            AircraftPeer(other, own, [words]) as aircraft:
        while len(aircraft.received) < 50 or aircraft.answered < 25:
            assert time.monotonic() < deadline, (
                "the ground does not hear its aircraft")
            stranger.sendto(said[sent % len(said)], ("127.0.0.1", own))
            sent += 1
            time.sleep(0.001)
    gsc = run.stop()
    shown = gsc.words("gsc.downlink", SENSORS)
    assert strange[:-1] not in shown
    # The aircraft's own may be bad on a machine that sends its characters late.
    need(words[:-1] in shown
         and gsc.summary["link"]["downlink_bad"] < aircraft.answered, gsc)


def reads_in(program, seconds):
    """The reads that it makes meanwhile, of any file."""
    def made():
        text = open(f"/proc/{program.pid}/io", encoding="ascii").read()
        return int(text.partition("syscr:")[2].split()[0])

    before = made()
    time.sleep(seconds)
    return made() - before


def test_rtp1_a_serial_line_without_another_end_takes_no_processor(start):
    """The operating system reports its end together with input and errors."""
    file, device = os.openpty()
    tty.setraw(file)
    run = start("gsc", f"serial:{os.ttyname(device)}", quiet=False)
    assert "listening" in run.say_line()
    os.close(device)
    silent = reads_in(run.program, 1)
    os.close(file)
    time.sleep(0.5)
    # The station itself reads nothing: these are the board's.
    assert reads_in(run.program, 1) <= 3 * silent + 5_000
    run.send(signal.SIGTERM)
    run.program.communicate(timeout=TIME_LIMIT_S)
    assert run.program.returncode == 3

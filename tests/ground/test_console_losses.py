# SPDX-License-Identifier: Apache-2.0
"""SAF-10, GND-4, GND-22: each way to lose the console, with both partitions
and a station as processes. In flight the aircraft flies alone as without a link;
on the ground the safe words stop it.

Nothing here goes by clocks: what happens is read from the frames' numbers, so a
loaded machine takes longer and sees the same.
"""

import csv
import json
import re
import signal
import socket
import subprocess
import threading
import urllib.request

import pytest
from ports import free_ports
from station_rig import PATIENCE_S, ROOT, Console, until

from urv import packets

HELD, LIVE, NEUTRAL = (packets.ConsoleState.HELD, packets.ConsoleState.LIVE,
                       packets.ConsoleState.NEUTRAL)
STALE = 1
MOST_FRAMES = 3_000
ROLL = 2500

# The bench's sensors: on the ground, or in flight at 64 kt and 1024 ft.
SENSORS = {"flight": "time_ms,battery_volts\n0,2760\n",
           "ground": "time_ms,airspeed,altitude\n0,0,0\n"}

GAMEPAD = """
window.pad = {id: "test pad", connected: true, index: 0,
  axes: [0, 0, 0, 0], mapping: "standard",
  buttons: Array.from({length: 17}, () => ({pressed: false, value: 0}))};
navigator.getGamepads = () => [window.pad];
"""


class Flight:
    """Both partitions with the bench, a station, and the frames it is sent."""

    def __init__(self, folder, sensors):
        self.folder = folder
        ports = free_ports(5)
        mcs, gsc, console, frames, self.page_port = ports
        (folder / "sensors.csv").write_text(sensors)
        self.frames, self._more = [], threading.Condition()
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind(("127.0.0.1", 0))
        self.mcs = self._start(
            "mcs", ROOT / "bin/urv_mcs", "--laws", "on", "--phase", "3",
            "--link", f"udp:127.0.0.1:{mcs}:127.0.0.1:{gsc}",
            "--sensors", folder / "sensors.csv", *self._outputs("mcs"))
        self.gsc = self._start(
            "gsc", ROOT / "bin/urv_gsc", "--packets", "2", "--phase", "0",
            "--link", f"udp:127.0.0.1:{gsc}:127.0.0.1:{mcs}",
            "--console", f"udp:127.0.0.1:{console}",
            "--publish", f"udp:127.0.0.1:{frames}", "--publish",
            f"udp:127.0.0.1:{self._socket.getsockname()[1]}",
            *self._outputs("gsc"))
        self.station = self._start(
            "station", ROOT / "bin/urv", "station", "--port", self.page_port,
            "--frames", f"udp:127.0.0.1:{frames}", "--console",
            f"udp:127.0.0.1:{console}", "--events", folder / "station.jsonl")
        self._thread = threading.Thread(target=self._take, daemon=True)
        self._thread.start()

    def _outputs(self, node):
        return ("--record", self.folder / f"{node}.csv", "--summary",
                self.folder / f"{node}.json")

    def _start(self, name, *command):
        with (self.folder / f"{name}.log").open("w") as log:
            return subprocess.Popen(
                list(map(str, command)), stdout=log, stderr=log,
                stdin=subprocess.DEVNULL)

    def _take(self):
        while data := self._socket.recv(4096):
            with self._more:
                self.frames.append(packets.FramePacket.decode(data))
                self._more.notify_all()

    def frame(self, shows, what):
        """The first frame from now on that shows something, of the next minute."""
        with self._more:
            place = len(self.frames)
            last = place + MOST_FRAMES
            while place < last:
                while place < len(self.frames):
                    if shows(self.frames[place]):
                        return self.frames[place]
                    place += 1
                assert self._more.wait(PATIENCE_S), f"no frame: {what}"
            raise AssertionError(f"no frame of {MOST_FRAMES}: {what}")

    def pass_frames(self, number):
        last = self.frames[-1].sequence
        self.frame(lambda frame: frame.sequence >= last + number, "more")

    def said(self, name):
        return (self.folder / f"{name}.log").read_text()

    def is_served(self):
        return "frames at" in self.said("station")

    def state(self):
        """The station's state, as /api/state has it."""
        with urllib.request.urlopen(
                f"http://127.0.0.1:{self.page_port}/api/state",
                timeout=PATIENCE_S) as answer:
            return json.load(answer)

    def rows(self, node):
        with (self.folder / f"{node}.csv").open() as file:
            return list(csv.DictReader(file))

    def logged(self):
        """The station's log, as text."""
        return [json.loads(line)["text"] for line in
                (self.folder / "station.jsonl").read_text().splitlines()]

    def end(self):
        if not self._thread.is_alive():
            return
        for process in (self.station, self.gsc, self.mcs):
            if process.poll() is None:
                process.send_signal(signal.SIGTERM)
        for process in (self.station, self.gsc, self.mcs):
            process.wait(PATIENCE_S)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as last:
            last.sendto(b"", self._socket.getsockname())
        self._thread.join(PATIENCE_S)
        self._socket.close()


@pytest.fixture
def flights(tmp_path):
    made = []

    def fly(place):
        flight = Flight(tmp_path, SENSORS[place])
        made.append(flight)
        until(flight.is_served, "a station")
        flight.frame(lambda frame: frame.is_fresh, "the aircraft")
        return flight

    yield fly
    for flight in made:
        flight.end()


PRESSES = 40


@pytest.fixture
def open_page(browser):
    made = []

    def open_it(flight):
        context = browser.new_context()
        made.append(context)
        page = context.new_page()
        page.set_default_timeout(PATIENCE_S * 1000)
        page.add_init_script(GAMEPAD)
        page.goto(f"http://127.0.0.1:{flight.page_port}/")
        page.wait_for_selector("body[data-down=fresh]")
        # A button counts after it was seen released, and a late machine's
        # page drops what has waited: it is pressed until it counts.
        for _ in range(PRESSES):
            page.evaluate("pad.buttons[9] = {pressed: false, value: 0}")
            page.wait_for_timeout(500)
            page.evaluate("pad.buttons[9] = {pressed: true, value: 1}")
            page.wait_for_timeout(1_000)
            if page.locator("#holder.mine").count():
                break
        page.wait_for_selector("#holder.mine")
        page.evaluate("pad.axes[2] = 0.5")
        flight.frame(lambda frame: frame.console_state == LIVE
                     and frame.columns["gsc.uplink.roll"] > ROLL, "sticks")
        return page

    yield open_it
    for context in made:
        context.close()


def take_silently(flight):
    """A page whose script hangs: its socket is open, and says nothing."""
    console = Console(flight.page_port)
    console.take()
    ended = threading.Event()

    def move():
        while not ended.wait(0.02):
            console.sticks(ROLL + 1)

    mover = threading.Thread(target=move)
    mover.start()
    flight.frame(lambda frame: frame.columns["gsc.uplink.roll"] > ROLL,
                 "sticks")
    ended.set()
    mover.join()
    return console


HIDE = """() => {
    Object.defineProperty(document, "hidden", {get: () => true,
      configurable: true});
    document.dispatchEvent(new Event("visibilitychange"));
}"""


def lose(way, flight, request):
    """Loses the console; what the station says about it."""
    if way == "hung browser":
        request.addfinalizer(take_silently(flight).close)
        return "console lost"
    page = request.getfixturevalue("open_page")(flight)
    if way == "closed page":
        page.close()
        return "its page has closed"
    if way == "hidden page":
        page.evaluate(HIDE)
        return "its page is hidden"
    if way == "unplugged gamepad":
        page.evaluate("window.pad = null")
        return "its gamepad is lost"
    flight.station.kill()
    return None


WAYS = ("closed page", "hidden page", "unplugged gamepad", "hung browser",
        "killed station")


@pytest.mark.parametrize("way", WAYS)
def test_saf10_gnd4_gnd22_in_flight_it_is_a_lost_link(flights, request, way):
    flight = flights("flight")
    reported = lose(way, flight, request)
    flight.frame(lambda frame: frame.console_state == HELD, "it is lost")
    lost_at = flight.frames[-1].sequence
    # 5 s: today's 2 s until the safe words are over for long.
    flight.pass_frames(250)
    last = flight.frames[-1]
    if reported:
        assert "STICKS HELD" in {
            alert["name"] for alert in flight.state()["alerts"]}
    flight.end()

    lost = [frame for frame in flight.frames
            if lost_at <= frame.sequence <= last.sequence]
    assert {frame.console_state for frame in lost} == {HELD}
    assert all(frame.columns["gsc.uplink.error"] & STALE
               for frame in lost[2:])
    # The aircraft flies alone, and has no safe words: the laws are on.
    # A machine that is late has lost the link before, too.
    rows = flight.rows("mcs")
    end = max(place for place, row in enumerate(rows)
              if row["laws.link"] == "1")
    linked, alone = rows[end], rows[end + 1:]
    assert {row["laws.link"] for row in alone} <= {"2", "3"}
    assert alone
    assert all(int(row["mcs.uplink.error"]) & STALE for row in alone)
    # The page took the sticks where they were: its brake is the pilot's.
    assert {(row["mcs.uplink.roll"], row["pwm.brake"]) for row in alone} == {
        (linked["mcs.uplink.roll"], linked["pwm.brake"])}
    # It is reported: terminal, summary, page and its log.
    assert re.search("console held at .*: no packet for 0.5 s",
                     flight.said("gsc"))
    assert "console neutral" not in flight.said("gsc")
    counted = json.loads((flight.folder / "gsc.json").read_text())["console"]
    # A machine that is late for half a second has lost it before, too.
    assert counted["held"] >= 1 and counted["neutral"] == 0
    if reported:
        assert any(reported in text for text in flight.logged())


@pytest.mark.parametrize("way", ["closed page", "killed station"])
def test_saf10_gnd4_gnd22_on_the_ground_the_safe_words_stop_it(
        flights, request, way):
    flight = flights("ground")
    lose(way, flight, request)
    flight.frame(lambda frame: frame.console_state == NEUTRAL, "safe words")
    flight.pass_frames(100)
    flight.end()
    assert [row["pwm.throttle"] + " " + row["pwm.brake"]
            for row in flight.rows("mcs")[-10:]] == ["0 4095"] * 10
    assert re.search("console neutral at .*: no packet for 2 s, the aircraft"
                     " is on the ground", flight.said("gsc"))

# SPDX-License-Identifier: Apache-2.0
"""A station with a stand-in of the ground's node, for tests.

    with Station(record, tmp_path) as station:
        state = station.wait(lambda state: state["rate"] >= 40)
        page = station.console()
        page.take()
"""

import contextlib
import json
import re
import signal
import subprocess
import sys
import threading
import time
import urllib.request
from pathlib import Path

import websocket

ROOT = Path(__file__).resolve().parents[2]
# However slow the machine: what must come has come by then.
PATIENCE_S = 150

sys.path.insert(0, str(ROOT / "ground"))

from fake_node import FakeNode  # noqa: E402 - finds the packages


def until(condition, what, patience=PATIENCE_S, pause=0.05):
    """The first thing that is so, or the test fails."""
    ends = time.monotonic() + patience
    while True:
        found = condition()
        if found:
            return found
        assert time.monotonic() < ends, f"never came: {what}"
        time.sleep(pause)


KEYS_COUNT = """
Object.defineProperty(Event.prototype, "timeStamp",
  {get() { return performance.now(); }});
"""
"""For a page on a slow machine: no key or click has waited in its browser, so
the page drops none (GND-51). An event may have a time of its own."""


def take_sticks(page):
    """The page takes the sticks. The station drops a request that was half a
    second on its way (GND-51), as on a slow machine: the key is pressed again
    until it counts."""
    def are_taken():
        page.keyboard.press("t")
        for _ in range(20):
            if page.locator("#holder.mine").count():
                return True
            page.wait_for_timeout(100)
        return False
    until(are_taken, "the sticks")


class Station:
    def __init__(self, record, folder, *options, reads=False, **node):
        self.record, self.options, self.more = record, options, node
        self.input = subprocess.PIPE if reads else subprocess.DEVNULL
        self.events = folder / "events.jsonl"
        self.log = folder / "station.log"
        # The exit status, and what standard error has.
        self.ends = (0, "")

    def __enter__(self):
        self.node = FakeNode(self.record, None, **self.more)
        self.errors = self.log.open("w")
        self.process = subprocess.Popen(
            [ROOT / "bin" / "urv", "station", "--port", "0", "--frames",
             "udp:127.0.0.1:0", "--console",
             f"udp:127.0.0.1:{self.node.console_port}", "--events", self.events,
             *self.options], stdout=subprocess.PIPE, stderr=self.errors,
            text=True, stdin=self.input)
        self.said = []
        for line in self.process.stdout:
            self.said.append(line.strip())
            if "frames at" in line:
                break
        assert self.said and "frames at" in self.said[-1], (
            self.log.read_text())
        self.url = re.search(r"http://\S+", self.said[0]).group()
        self.port = int(re.search(r":(\d+)/", self.url).group(1))
        self.frames = ("127.0.0.1", int(self.said[-1].rpartition(":")[2]))
        self.node.to = self.frames
        self.node.__enter__()
        return self

    def __exit__(self, *_):
        self.node.__exit__()
        self.process.send_signal(signal.SIGTERM)
        status = self.process.wait(PATIENCE_S)
        self.process.stdout.close()
        self.errors.close()
        assert (status, self.log.read_text()) == self.ends

    def get(self, path="/", **headers):
        """Status and body of an answer."""
        request = urllib.request.Request(
            f"http://127.0.0.1:{self.port}{path}",
            headers={name.replace("_", "-"): value
                     for name, value in headers.items()})
        try:
            with urllib.request.urlopen(request, timeout=PATIENCE_S) as answer:
                return answer.status, answer.read().decode()
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode()

    def state(self):
        return json.loads(self.get("/api/state")[1])

    def wait(self, condition, what="a state", patience=PATIENCE_S):
        def look():
            state = self.state()
            return state if condition(state) else None
        return until(look, what, patience)

    def flying(self):
        """The state once frames come."""
        return self.wait(lambda state: state.get("words"), "a frame")

    def console(self, **more):
        return Console(self.port, **more)

    def sends_nothing(self, since, frames=15):
        """It has sent no console packet since that state, for a number of
        frames."""
        state = self.wait(lambda state: state["seq"] >= since["seq"] + frames,
                          "frames")
        assert state["station"]["sent"] == since["station"]["sent"]

    def lines(self):
        """The station's log."""
        if not self.events.exists():
            return []
        return [json.loads(line)
                for line in self.events.read_text("utf-8").splitlines()]

    def logged(self, text, number=1, kind="text"):
        """Waits for that number of lines with the text, and returns them: a
        thread of the station writes the log."""
        return until(lambda: (found := [
            line for line in self.lines() if text in line[kind]])[
            number - 1:] and found, text)


CLOCK_S = 1e6
"""A page's clock shows another time than the station's."""


def moved(roll):
    """The message of sticks."""
    return {"t": "sticks", "words": [roll, 2048, 2048, 2048, 2048, *[0] * 8]}


class Console:
    """A page without a browser. late_s makes its messages that old."""

    def __init__(self, port, **more):
        self.socket = websocket.create_connection(
            f"ws://127.0.0.1:{port}/ws", timeout=PATIENCE_S, **more)
        self.late_s = 0.0
        self.answers = False
        self.saying = threading.Lock()
        self.sequence = 0
        self.hello = self.next("hello")
        self.number = self.hello["console"]

    def say(self, message):
        with self.saying:
            self.sequence += 1
            self.socket.send(json.dumps(message | {
                "sequence": self.sequence, "sent_ms": 1000 * (
                    CLOCK_S + time.monotonic() - self.late_s)}))

    def sticks(self, roll=2048):
        self.say(moved(roll))

    def next(self, kind):
        """The next message of that kind."""
        while True:
            text = self.socket.recv()
            if not text:
                raise OSError("the station has closed this page")
            message = json.loads(text)
            if message["t"] == kind:
                return message

    def until(self, condition, what):
        """The first state in which it is so."""
        ends = time.monotonic() + PATIENCE_S
        while True:
            state = self.next("state")
            if condition(state):
                return state
            assert time.monotonic() < ends, f"never came: {what}"

    def insist(self, message, condition, what):
        """Says it until a state shows it, and returns that state. A slow
        machine drops input that was half a second on its way (GND-51)."""
        ends = time.monotonic() + PATIENCE_S
        while True:
            self.say(message)
            for _ in range(25):
                state = self.next("state")
                if condition(state):
                    return state
            assert time.monotonic() < ends, f"never came: {what}"

    def listen(self):
        """Reads all that comes, in a thread of its own, and so answers the
        station's pings: it shuts a page that does not."""
        def read():
            with contextlib.suppress(Exception):
                while self.socket.recv():
                    pass
        threading.Thread(target=read, daemon=True).start()

    def take(self):
        """Takes the sticks."""
        return self.insist({"t": "take"}, lambda state: state["holder"]
                           == self.number, "the sticks")

    def close(self):
        self.socket.close()

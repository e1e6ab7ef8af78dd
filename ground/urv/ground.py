# SPDX-License-Identifier: Apache-2.0
"""bin/urv ground: a flight in real time with everything around it (GND-31).

Both nodes, the aircraft, the station and a Yamcs are a process each. When the
program that ends the flight ends, all end. When another one dies or stops, the
terminal and the page report it, the rest flies on, and the flight ends with a
fault (GND-47, GND-54). The same holds for an output that cannot be written
(GND-53).
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import queue
import secrets
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.error
import urllib.request
from pathlib import Path

import typer

from urv import (faults, input_files, outputs, packets, processes, programs,
                 whole_files)
from urv.alerts import CAUTION, WARNING
from urv.processes import Report

ROOT = Path(__file__).resolve().parents[2]
YAMCS = ROOT / "ground" / "yamcs"
JARS = ROOT / "obj" / "yamcs" / "lib"
DISPLAY = "flight.opi"
HERE = "127.0.0.1"

LOOKS_S = 0.1
UNHEARD = 3
"""The status of a node that never received anything that it took."""
LOST = 1
"""The status of a node that lost an output, among other faults."""
REFUSES = 2
"""The status of a node that refuses its command line."""
ENDS_S = 10.0
"""A program that has not ended by then is killed."""
STARTS_S = 30.0
LATER_BY = 5
"""The niceness of Yamcs above that of the flying programs."""
LONGEST_LINE = 4_096
LAST_FRAME = 500_000_000
"""The last frame of an event: 115 days, the limit of bin/urv report."""
LONGEST_KIND = 250
"""Characters of an event's kind, the limit of bin/urv report."""
DEATH_SIGNAL = 1  # PR_SET_PDEATHSIG

NODES = ("urv_mcs", "urv_gsc")
PASSED_ON = {"--format": NODES, "--key": NODES, "--processors": NODES,
             "--lock": NODES, "--line-delay": NODES,
             "--schedule": NODES, "--laws": ("urv_mcs",),
             "--orders": ("urv_gsc",),
             "--orbit-after": ("urv_mcs",), "--terminate-after": ("urv_mcs",)}
"""Options of the nodes, and the nodes that have them. The nodes themselves
check their values."""

OWN_OPTIONS = {
    "station": {"--listen": "--page-port", "--frames": "--ports",
                "--relay": "--ports"},
    "yamcs_gate": {"--port": "--yamcs-port"}, "mavlink": {"--to": "--mavlink"}}
"""The option of this command for each one of a program that it starts."""


def ground(
    seconds: float | None = typer.Option(
        None, min=0.0, help="Ends the flight after this time."),
    folder: Path = typer.Option(
        Path("flight/ground"), metavar="FOLDER",
        help="For records, logs and Yamcs's archive."),
    pilot: str = typer.Option(
        "standard", metavar="NAME",
        help="The simulated pilot that flies until a page takes the sticks;"
        " \"none\": no pilot."),
    yamcs: bool = typer.Option(
        True, help="Start a Yamcs."),
    mavlink: str | None = typer.Option(
        None, metavar="udp:HOST:PORT",
        help="Also sends the flight there as MAVLink 2: QGroundControl"
        " receives at udp:127.0.0.1:14550."),
    message_format: str | None = typer.Option(
        None, "--format", metavar="N",
        help="Format of the link's messages, 1 or 2, which is sealed. It goes"
        " to both nodes, as the next five do."),
    key: Path | None = typer.Option(
        None, metavar="FILE", help="The keys of format 2."),
    processors: str | None = typer.Option(
        None, metavar="N", help="Processors of each node, 1 to 4."),
    lock: bool = typer.Option(
        False, "--lock", help="Brings the aircraft's frames in step."),
    line_delay: str | None = typer.Option(
        None, metavar="MS",
        help="One-way delay of a link slower than a wire; else 0."),
    schedule: str | None = typer.Option(
        None, metavar="NAME", help="Schedule of the tasks, report or fast."),
    laws: str | None = typer.Option(
        None, metavar="LAWS",
        help="The aircraft's control laws, on or off; on by default."),
    orbit_after: str | None = typer.Option(
        None, metavar="S",
        help="Seconds without uplink before the aircraft begins an orbit;"
        " else 5."),
    terminate_after: str | None = typer.Option(
        None, metavar="S",
        help="Seconds without uplink before the flight is terminated;"
        " else 120."),
    orders: Path | None = typer.Option(
        None, metavar="FILE",
        help="The ground's orders besides the sticks."),
    page_port: int = typer.Option(8090, min=1, max=65535,
                                  help="Port of the station's page."),
    yamcs_port: int = typer.Option(8092, min=1, max=65535,
                                   help="Port of Yamcs's pages."),
    ports: int = typer.Option(
        6001, min=1, max=65531,
        help="The first of five ports of this machine between the"
        " programs."),
):
    """Fly in real time, with page and Yamcs."""
    for program in ("urv_gsc", "urv_mcs"):
        if not (ROOT / "bin" / program).exists():
            raise faults.Refused(f"bin/{program} is not built; make ground"
                                 " builds it")
    if yamcs and not (programs.found("java") and JARS.is_dir()):
        raise faults.Refused(
            "there is no Yamcs; scripts/setup.sh ground gets it, --no-yamcs"
            " goes without")
    folder.mkdir(parents=True, exist_ok=True)
    # A shell starts background programs with interrupts ignored.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    flight = Flight(folder.resolve(), ports, page_port, yamcs_port)
    flight.given = {
        "--format": message_format, "--key": key and key.resolve(),
        "--processors": processors, "--lock": lock or None,
        "--line-delay": line_delay,
        "--schedule": schedule, "--laws": laws,
        "--orders": orders and orders.resolve(),
        "--orbit-after": orbit_after, "--terminate-after": terminate_after}
    try:
        flight.start(pilot, yamcs, mavlink, seconds)
        status = flight.watch()
    except KeyboardInterrupt:
        status = 0   # a deliberate end (D-39)
    finally:
        flight.end()
    if status == REFUSES:
        raise faults.Refused(flight.complaint)
    if status:
        raise faults.Failed("a node has ended by itself: see"
                            f" {faults.quoted(folder)}")
    flight.judge()


def event_in(text: str) -> dict | None:
    """A line of the station's log as an event of bin/urv_sim; None when it is
    no mark and no alert, or has no frame. Markup characters are removed from
    typed text. Raises ValueError when it is no such line."""
    match input_files.parsed(text):
        case {"kind": str(kind), "text": str(said), "frame": None | int()
              as frame, "level": "info" | "caution" | "warning" as level}:
            said.encode("utf-8")
        case _:
            raise ValueError("no line of the log")
    if kind not in ("mark", "alert") or frame is None:
        return None
    if not 0 <= frame <= LAST_FRAME:
        raise ValueError("no frame")
    at = frame * packets.FRAME_US // 1000
    said = said.translate(str.maketrans("<>&", "\u2039\u203a+"))
    said = (f"mark: {said}" if kind == "mark"
            else f"{level} {said.partition(':')[0]}")
    return {"node": "station", "kind": said[:LONGEST_KIND], "count": 1,
            "first_frame": int(frame), "last_frame": int(frame),
            "first_ms": at, "last_ms": at, "last_detail": 0}


class Flight:
    """The processes, in the order in which they were started."""

    def __init__(self, folder: Path, ports: int, page_port: int,
                 yamcs_port: int) -> None:
        self.folder = folder
        # Each flight has its own events; the archive continues.
        (folder / "station.jsonl").unlink(missing_ok=True)
        (self.gsc_link, self.mcs_link, self.frames, self.console,
         self.relay) = range(ports, ports + 5)
        self.page_port, self.yamcs_port = page_port, yamcs_port
        # Yamcs itself, at a port that no web page knows (SEC-13). The port
        # stays bound here: no other program gets it before Yamcs listens
        # there.
        self.yamcs_place = socket.socket()
        self.yamcs_place.setsockopt(socket.SOL_SOCKET,
                                    socket.SO_REUSEADDR, 1)
        self.yamcs_place.bind((HERE, 0))
        self.yamcs_path = f"/{secrets.token_hex(16)}"
        self.yamcs = (f"http://{HERE}:{self.yamcs_place.getsockname()[1]}"
                      f"{self.yamcs_path}")
        self.running: dict[str, subprocess.Popen] = {}
        self.groups: list[int] = []
        self.given: dict[str, object] = {}
        self.complaint = ""
        # The status of each program that has ended, and the reported state of
        # each running one.
        self.statuses: dict[str, int] = {}
        self.fallen: list[str] = []
        self.stopped: set[str] = set()
        self.stood_still: dict[str, None] = {}
        self.losses: dict[str, str] = {}
        self.terminal = outputs.Terminal()
        # For each program: its log, the thread that reads its output, and its
        # last line.
        self.logs: dict[str, outputs.Output] = {}
        self.readers: dict[str, threading.Thread] = {}
        self.last_words: dict[str, str] = {}
        self.lines: queue.SimpleQueue[tuple[str, str]] = queue.SimpleQueue()
        self.active: dict[str, str] = {}
        self.began = time.monotonic()

    def start(self, pilot: str, yamcs: bool, mavlink: str | None,
              seconds: float | None) -> None:
        here = HERE
        station = [*programs.URV, "station",
                   "--port", self.page_port,
                   "--frames", f"udp:{here}:{self.frames}",
                   "--console", f"udp:{here}:{self.console}",
                   "--events", self.folder / "station.jsonl", "--reports",
                   "--recordings", self.folder]
        if yamcs:
            station += ["--relay", f"tcp:{here}:{self.relay}"]
        # The receiver of the frames is ready before the first one.
        self.run("station", *station, tells=True, hears=True,
                 yamcs=self.yamcs if yamcs else None)
        if yamcs:
            self.start_gate()
        self.await_station()
        if yamcs:
            self.await_line("yamcs_gate", "pages at")
        publish = ["--packets", packets.FRAMED,
                   "--publish", f"udp:{here}:{self.frames}"]
        if mavlink is not None:
            publish += ["--publish", self.start_mavlink(mavlink)]
        lasts = [] if seconds is None else ["--seconds", seconds]
        up = f"udp:{here}:{self.gsc_link}:{here}:{self.mcs_link}"
        down = f"udp:{here}:{self.mcs_link}:{here}:{self.gsc_link}"
        # The ground ends the flight; the aircraft runs until then.
        self.run("urv_mcs", ROOT / "bin" / "urv_mcs", "--link", down,
                 "--phase", 3, "--plant", "jsbsim",
                 *self.passed_on("urv_mcs"), *self.outputs("aircraft"))
        flies = [] if pilot == "none" else ["--pilot", pilot]
        self.run("urv_gsc", ROOT / "bin" / "urv_gsc", "--link", up,
                 "--phase", 0, *flies, *lasts,
                 *publish, *self.passed_on("urv_gsc"),
                 "--console", f"udp:{here}:{self.console}",
                 *self.outputs("ground"))
        self.say(f"ground: page to fly and watch by: http://{here}:"
              f"{self.page_port}/")
        if yamcs and self.start_yamcs():
            threading.Thread(target=self.await_yamcs, daemon=True).start()

    def passed_on(self, node: str) -> list:
        """The given options of this node. True is the value of a switch, which
        has no word."""
        return [word for option, value in self.given.items()
                if value is not None and node in PASSED_ON[option]
                for word in (option, value) if word is not True]

    def outputs(self, name: str) -> list:
        """The output files of a node."""
        return ["--record", self.folder / f"{name}.csv",
                "--summary", self.folder / f"{name}.json",
                "--events", self.folder / f"{name}.jsonl"]

    def start_yamcs(self) -> bool:
        """True if Yamcs could be started, on a disk that may be full."""
        try:
            self.configure_yamcs()
        except (OSError, faults.Refused, faults.Failed) as error:
            reason = (faults.reason(error) if isinstance(error, OSError)
                      else str(error))
            self.lose("yamcs", "yamcs is not started: its files cannot be"
                      f" written: {reason}")
            return False
        # A small machine has no time for optimised compilation.
        self.run("yamcs", programs.found("java"), "-Xmx512m",
                 "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1", "-cp",
                 f"{JARS}/*",
                 "org.yamcs.YamcsServer", "--no-color", "--log", "1",
                 "--etc-dir", self.folder / "etc",
                 "--data-dir", self.folder / "yamcs-data", later=LATER_BY)
        return True

    def configure_yamcs(self) -> None:
        for name in ("mdb", "displays", "etc"):
            (self.folder / name).mkdir(exist_ok=True)
        from urv import display, xtce
        self.write("mdb/urv.xml", xtce.mission_database())
        self.write(f"displays/{DISPLAY}", display.flight())
        port = self.yamcs_place.getsockname()[1]
        for source in (YAMCS / "etc").glob("*.yaml"):
            text = source.read_text("utf-8")
            text = text.replace("port: 8092", f"port: {port}")
            text = text.replace("contextPath: /yamcs",
                                f"contextPath: {self.yamcs_path}")
            text = text.replace("port: 6005", f"port: {self.relay}")
            self.write(f"etc/{source.name}", text)

    def write(self, name: str, text: str) -> None:
        """Writes a file of the folder, without following a link (SEC-15)."""
        with whole_files.replacing(self.folder / name) as path:
            path.write_text(text, encoding="utf-8")

    def start_gate(self) -> None:
        """Starts the Gate to Yamcs's pages, at the public port."""
        self.run("yamcs_gate", *programs.URV, "yamcs-gate",
                 "--port", self.yamcs_port, tells=True, later=LATER_BY,
                 yamcs=self.yamcs)

    def run(self, name: str, *command, tells: bool = False,
            later: int = 0, hears: bool = False,
            yamcs: str | None = None) -> None:
        """Starts a program that ends with this one, whatever the reason. It
        gets Yamcs's URL in its environment."""
        parent = os.getpid()
        library = ctypes.CDLL(None)

        def become() -> None:
            library.prctl(DEATH_SIGNAL, signal.SIGTERM)
            os.nice(later)
            if os.getppid() != parent:
                os._exit(1)

        said, log = os.pipe()
        self.running[name] = subprocess.Popen(
            list(map(str, command)), cwd=self.folder,
            stdin=subprocess.PIPE if hears else subprocess.DEVNULL,
            stdout=subprocess.PIPE if tells else log, stderr=log,
            # A Ctrl-C at the terminal reaches only this program: it ends the
            # others in their order.
            start_new_session=True, preexec_fn=become, text=True,
            env=os.environ | {"URV_PYTHON": sys.executable,
                              "URV_YAMCS": yamcs or ""})
        os.close(log)
        self.read(name, said)
        self.groups.append(self.running[name].pid)

    def read(self, name: str, said: int) -> None:
        """Copies a program's output to its log and its follower. A full or
        slow disk delays neither (D-56)."""
        try:
            log = outputs.Output.of_file(
                f"{name}.log", self.folder / f"{name}.log", os.O_TRUNC)
        except OSError as error:
            log = None
            self.lose(f"{name}.log", f"{name}.log cannot be written:"
                      f" {faults.reason(error)}")
        else:
            self.logs[name] = log

        def take() -> None:
            rest = b""
            with open(said, "rb", buffering=0) as stream:
                while data := stream.read(1 << 16):
                    if log is not None:
                        log.put(data)
                    *lines, rest = (rest + data).split(b"\n")
                    # A line without an end is cut off.
                    rest = rest[-LONGEST_LINE:]
                    for line in lines:
                        text = line.decode("utf-8", "replace")
                        if text.strip():
                            self.last_words[name] = text.strip()
                        self.lines.put((name, text))

        self.readers[name] = threading.Thread(target=take, daemon=True)
        self.readers[name].start()

    def say(self, text: str) -> None:
        """Prints a line on the terminal, if possible."""
        self.terminal.say(text)

    def lose(self, output: str, text: str) -> None:
        """An output is lost: the flight continues, and ends with a fault."""
        if output not in self.losses:
            self.losses[output] = text
            self.say(f"ground: {text}; the flight goes on")
            self.tell(Report(f"lost {output}", CAUTION, "OUTPUT LOST", text))

    def look_at_outputs(self) -> None:
        """Checks the outputs of this program."""
        for output in (*self.logs.values(), self.terminal):
            problem = output.problem()
            if problem is not None:
                self.lose(output.name, problem)

    def await_station(self) -> None:
        """Waits until the station reports the port for frames."""
        self.await_line("station", "frames at")

    def start_mavlink(self, to: str) -> str:
        """Starts MAVLink; returns its port for frames."""
        self.run("mavlink", *programs.URV, "mavlink",
                 "--listen", "udp:127.0.0.1:0", "--to", to, tells=True)
        return self.await_line("mavlink", "mavlink: from ").split()[2]

    def await_line(self, name: str, what: str) -> str:
        """Waits for the first line with this text."""
        process = self.running[name]
        for line in process.stdout:
            if what in line:
                return line
        status = process.wait()
        said = (self.last_word_of(name).removeprefix("urv: ")
                or f"{name} has ended at once")
        option, _, rest = said.partition(" ")
        said = " ".join((OWN_OPTIONS.get(name, {}).get(option, option), rest))
        if status == REFUSES:
            raise faults.Refused(said)
        raise faults.Failed(said)

    def last_word_of(self, name: str) -> str:
        """The last line of a program, which gives the reason of its end."""
        self.await_end_of_words(name)
        return self.last_words.get(name, "")

    def await_end_of_words(self, name: str) -> None:
        """Waits for the remaining output of a program that has ended."""
        if name in self.readers:
            self.readers[name].join(1.0)

    def await_yamcs(self) -> None:
        """Reports when Yamcs's pages are ready."""
        while "yamcs" in self.running:
            try:
                with urllib.request.urlopen(f"{self.yamcs}/api/links/urv",
                                            timeout=2.0):
                    break
            except (urllib.error.URLError, OSError):
                time.sleep(0.3)
        else:
            return
        self.say(f"ground: Yamcs: http://{HERE}:{self.yamcs_port}"
                 f"/telemetry/displays/files/{DISPLAY}?c=urv__realtime")
        self.say(f"ground: live after {time.monotonic() - self.began:.0f} s;"
              " Ctrl-C ends it")

    def watch(self) -> int:
        """Waits until the flight is over; 0 when it ended normally."""
        while True:
            time.sleep(LOOKS_S)
            self.follow_programs()
            self.look_at_outputs()
            for name, process in list(self.running.items()):
                status = process.poll()
                if status is None:
                    self.look_whether_stopped(name, process.pid)
                    continue
                del self.running[name]
                self.statuses[name] = status
                self.await_end_of_words(name)
                self.follow_programs()
                if name == "urv_gsc" and (
                        status in (0, UNHEARD)
                        or status == LOST and self.has_losses(name)):
                    return 0
                how = (f"status {status}" if status > 0 else
                       signal.Signals(-status).name if status else "status 0")
                self.say(f"ground: {name} has ended, {how}"
                      + ("" if name in NODES else
                         "; the flight goes on"))
                self.fallen.append(name)
                self.tell(Report(
                    f"process {name}", CAUTION, f"{name.upper()} GONE",
                    f"the program has ended, {how}"))
                if name in NODES:
                    self.complaint = self.last_word_of(name)
                    return REFUSES if status == REFUSES else 1

    def follow_programs(self) -> None:
        """Prints the nodes' reports about themselves, the plant and each
        other, and sends them to the page. For other programs only losses."""
        while not self.lines.empty():
            name, line = self.lines.get()
            if name in NODES:
                self.follow(name, line.removeprefix(f"{name}: "))
            elif name != "yamcs":
                said = line.removeprefix("urv: ")
                for report in processes.reports_of(name, said):
                    if processes.is_loss(report):
                        self.lose(f"{name} {report.key}", f"{name}: {said}")

    def follow(self, name: str, said: str) -> None:
        """Handles a report of a node."""
        reports = processes.reports_of(name, said)
        is_news = bool(processes.ALONE.match(said))
        for report in reports:
            if report.active:
                # Both nodes lack the same right.
                is_news |= self.active.get(report.key) != said
                self.active[report.key] = said
            else:
                is_news |= self.active.pop(report.key, None) is not None
            if processes.is_loss(report):
                self.losses.setdefault(f"{name} {report.key}",
                                       f"{name}: {said}")
            self.tell(report)
        if is_news:
            self.say(f"ground: {name}: {said}")

    def look_whether_stopped(self, name: str, pid: int) -> None:
        """A stopped program does nothing, but has not ended. The same applies
        to the aircraft, which its node has started."""
        self.look_at_process(name, pid, WARNING if name in NODES else CAUTION)
        if name == "urv_mcs":
            with contextlib.suppress(OSError, ValueError):
                children = Path(f"/proc/{pid}/task/{pid}/children")
                for child in map(int, children.read_text("ascii").split()):
                    self.look_at_process("plant", child, WARNING)

    def look_at_process(self, name: str, pid: int, level: str) -> None:
        """Reports whether the process is stopped."""
        try:
            text = Path(f"/proc/{pid}/stat").read_text("utf-8", "replace")
        except OSError:
            return
        is_stopped = text.rpartition(")")[2].split()[0] in "Tt"
        if is_stopped == (name in self.stopped):
            return
        (self.stopped.add if is_stopped else self.stopped.discard)(name)
        if is_stopped:
            self.stood_still[name] = None
        self.say(f"ground: {name}"
                 f" {'is stopped' if is_stopped else 'runs again'}")
        self.tell(Report(
            f"stopped {name}", level, f"{name.upper()} STOPPED",
            "the program is stopped", is_stopped))

    def tell(self, report: Report) -> None:
        """Sends a report to the page. A station that does not read it delays
        nothing."""
        station = self.running.get("station")
        if station is not None:
            with contextlib.suppress(OSError):
                os.set_blocking(station.stdin.fileno(), False)
                os.write(station.stdin.fileno(), report.line().encode())

    def has_losses(self, name: str) -> bool:
        """True if an output of that program is lost."""
        return any(each.startswith(f"{name} ") for each in self.losses)

    def judge(self) -> None:
        """Raises the fault of a flight that has ended, if there is one."""
        for name in NODES:
            status = self.statuses.get(name, 0)
            if status not in (0, UNHEARD) and not (
                    status == LOST and self.has_losses(name)):
                raise faults.Failed(
                    self.last_word_of(name) or f"{name} has failed")
        if self.fallen:
            raise faults.Failed(
                f"{' and '.join(self.fallen)} ended during the flight: see"
                f" {faults.quoted(self.shown())}")
        if self.stood_still:
            raise faults.Failed(
                f"{' and '.join(self.stood_still)} stood still during the"
                " flight")
        if self.losses:
            raise faults.Failed("; ".join(self.losses.values()))
        if UNHEARD in self.statuses.values():
            raise faults.Unheard("the link carried nothing: a node never"
                                 " heard the other one")

    def end(self) -> None:
        """Ends all programs. The nodes end first, with whole records, then the
        receivers of their frames."""
        # A second Ctrl-C must not leave half of them.
        for number in (signal.SIGINT, signal.SIGTERM):
            signal.signal(number, signal.SIG_IGN)
        for names in (NODES, ("station", "mavlink"),
                      ("yamcs", "yamcs_gate")):
            group = {name: self.running.pop(name)
                     for name in names if name in self.running}
            for process in group.values():
                process.send_signal(signal.SIGTERM)
                # A stopped program cannot end.
                process.send_signal(signal.SIGCONT)
            late = time.monotonic() + ENDS_S
            for name, process in group.items():
                try:
                    process.wait(max(0.0, late - time.monotonic()))
                except subprocess.TimeoutExpired:
                    self.say(f"ground: {name} did not end and was killed")
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
                self.statuses[name] = process.returncode
        self.end_groups()
        for name in self.readers:
            self.await_end_of_words(name)
        self.follow_programs()
        for log in self.logs.values():
            log.close()
        # Without a flight the files are those of an earlier one.
        if self.statuses.get("urv_gsc", REFUSES) != REFUSES:
            self.collect_events()
        self.look_at_outputs()
        self.say(f"ground: records and logs are in {self.shown()}")
        self.terminal.close()
        self.look_at_outputs()

    def end_groups(self) -> None:
        """Waits for the processes that the programs have started, including
        the aircraft of a killed node."""
        late = time.monotonic() + ENDS_S
        for group in self.groups:
            with contextlib.suppress(ProcessLookupError):
                while True:
                    os.killpg(group, 0 if time.monotonic() < late
                              else signal.SIGKILL)
                    time.sleep(LOOKS_S / 10)

    def collect_events(self) -> None:
        """Writes the ground's error log with marks and alerts, for the
        report."""
        try:
            lines = (self.folder / "ground.jsonl").read_text("utf-8")
            told = (self.folder / "station.jsonl").read_text("utf-8")
            bad = 0
            for line in told.splitlines():
                try:
                    event = event_in(line)
                except ValueError:
                    # One bad row costs one row (GND-57).
                    bad += 1
                    continue
                if event is not None:
                    lines += json.dumps(event) + "\n"
            if bad:
                self.say(f"ground: {bad} lines of station.jsonl are none and"
                         " left out")
            data = lines.encode()
            made = outputs.Output.of_file(
                "events.jsonl", self.folder / "events.jsonl", os.O_TRUNC,
                room=len(data))
            made.put(data)
            made.close()
            self.logs["events.jsonl"] = made
        except (OSError, ValueError) as error:
            reason = (f"{Path(error.filename).name}: {faults.reason(error)}"
                      if isinstance(error, OSError) and error.filename
                      else str(error))
            self.say(f"ground: events.jsonl is not written: {reason}")

    def shown(self) -> str:
        try:
            return str(self.folder.relative_to(Path.cwd()))
        except ValueError:
            return str(self.folder)

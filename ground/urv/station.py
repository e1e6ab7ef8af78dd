# SPDX-License-Identifier: Apache-2.0
"""bin/urv station: the pilot's and the engineer's page (GND-20, GND-24,
GND-53, GND-57, SEC-11)."""

from __future__ import annotations

import asyncio
import contextlib
import ipaddress
import json
import re
import secrets
import signal
import socket
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote, urlsplit

import typer

from urv import faults, outputs, packets, whole_files

if TYPE_CHECKING:
    from urv.view import Line

PUSHES_S = 0.04
IDLE_PUSH_S = 0.1


def station(
    port: int = typer.Option(
        8090, min=0, max=65535, help="Port of the page; 0 takes a free one."),
    listen: str = typer.Option(
        "127.0.0.1", metavar="ADDRESS",
        help="Address of the page. Any other than this machine's"
        " loopback demands a token."),
    token: str | None = typer.Option(
        None, envvar="URV_TOKEN", show_envvar=True, metavar="WORD",
        help="Token that a page must present. By default one is generated"
        " if demanded."),
    frames: str = typer.Option(
        "udp:127.0.0.1:6003", metavar="udp:HOST:PORT",
        help="Port of the frame packets: urv_gsc --publish. At any other host"
        " than this machine's loopback, other machines can send them."),
    sender: str | None = typer.Option(
        None, "--sender", metavar="ADDRESS",
        help="The machine whose frame packets are taken, by its IP address;"
        " those of others raise an alert. By default any machine."),
    console: str = typer.Option(
        "udp:127.0.0.1:6004", metavar="udp:HOST:PORT",
        help="Destination of console packets: urv_gsc --console. \"none\": the"
        " pages only watch."),
    relay: str | None = typer.Option(
        None, metavar="tcp:HOST:PORT",
        help="Port at which one client, a Yamcs, gets the good frame packets."
        " With --yamcs it gets them as soon as all of that Yamcs runs."),
    events: Path | None = typer.Option(
        None, metavar="FILE",
        help="Marks, alerts, errors and hand-overs as JSON lines."),
    recordings: Path = typer.Option(
        Path("."), metavar="FOLDER",
        help="Folder for the rows of the aircraft's flight recorder that a"
        " page fetches, flight-DATE-TIME.recording."),
    yamcs: str | None = typer.Option(
        None, envvar="URV_YAMCS", show_envvar=True, metavar="URL",
        help="A Yamcs that receives the same as events."),
    seconds: float | None = typer.Option(
        None, min=0.0, help="Ends the station after this time."),
    reports: bool = typer.Option(
        False, "--reports", help="Take reports about the flight's other"
        " programs from standard input, as bin/urv ground sends them."),
):
    """Serve the page, for flying and watching."""
    from urv import web
    from urv.fetcher import Fetcher

    if not web.is_loopback(listen) and token is None:
        token = secrets.token_urlsafe(16)
    if token is not None and len(token) < 8:
        raise faults.Refused("--token: shorter than 8 characters")
    if token is not None and not (token.isascii() and token.isprintable()):
        raise faults.Refused("--token: a word of printable ASCII characters"
                             " is needed")
    if yamcs is not None:
        check_yamcs(yamcs)
    if not is_name(listen):
        raise faults.Refused(f"--listen {faults.quoted(listen)}: no address")
    # A missing folder may still be made before a fetch.
    if recordings.exists() and not recordings.is_dir():
        raise faults.Refused(
            f"--recordings {faults.quoted(recordings)}: not a folder")
    if sender is not None:
        sender = ip_address("--sender", sender)
    asyncio.run(until_ended(serve(
        listen, port, token, address("--frames", frames),
        None if console == "none" else address("--console", console),
        None if relay is None else address("--relay", relay, "tcp"),
        events, yamcs, seconds, reports, sender,
        None if console == "none" else Fetcher(console, recordings))))


async def until_ended(work):
    """Runs until the work is done or a signal ends it, which is the normal end
    of a station."""
    task = asyncio.ensure_future(work)
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, task.cancel)
    try:
        await task
    except asyncio.CancelledError:
        pass


def address(option: str, given: str, wanted: str = "udp"
            ) -> tuple[str, int]:
    """The host and port of udp:HOST:PORT."""
    kind, _, rest = given.partition(":")
    host, _, port = rest.rpartition(":")
    if kind != wanted or not is_name(host) or not re.fullmatch(
            "[0-9]{1,5}", port) or int(port) > 65535:
        raise faults.Refused(
            f"{option} {faults.quoted(given)}: not {wanted}:HOST:PORT")
    return host.strip("[]"), int(port)


def sender_to(option: str, place: tuple[str, int]
              ) -> tuple[socket.socket, tuple]:
    """A socket that sends datagrams to a host and port, and the address for
    sendto. The name is looked up once: a look-up may take seconds, and a sender
    must not wait."""
    try:
        family, kind, _, _, there = socket.getaddrinfo(
            *place, type=socket.SOCK_DGRAM)[0]
    except OSError as error:
        raise faults.Refused(f"{option}: there is no host"
                             f" {faults.quoted(place[0])}") from error
    return socket.socket(family, kind), there


def check_yamcs(url: str) -> None:
    """Raises faults.Refused for anything but a URL of a Yamcs."""
    try:
        parts = urlsplit(url)
        is_one = (url.isascii() and url.isprintable() and " " not in url
                  and parts.scheme == "http" and bool(parts.hostname)
                  and is_name(parts.hostname) and parts.port != 0
                  and not parts.query and not parts.fragment)
    except ValueError:
        is_one = False
    if not is_one:
        raise faults.Refused(f"--yamcs {faults.quoted(url)}: not"
                             " http://HOST:PORT or http://HOST:PORT/PATH")


def is_name(host: str) -> bool:
    """True if the operating system can look up the host."""
    try:
        return bool(host.strip("[]").encode("idna"))
    except UnicodeError:
        return False


def ip_address(option: str, given: str) -> str:
    """The address as the operating system writes it."""
    try:
        return plain_address(str(ipaddress.ip_address(given.strip("[]"))))
    except ValueError as error:
        raise faults.Refused(f"{option} {faults.quoted(given)}: no IP address,"
                             " such as 192.168.1.7") from error


def plain_address(host: str) -> str:
    """An IPv6 socket writes an IPv4 address in its own way."""
    mapped = getattr(ipaddress.ip_address(host), "ipv4_mapped", None)
    return host if mapped is None else str(mapped)


class Frames(asyncio.DatagramProtocol):
    """Receives frame packets with their senders."""

    def __init__(self, take) -> None:
        self._take = take

    def datagram_received(self, data: bytes, addr) -> None:
        self._take(data, addr[:2])

    def error_received(self, exc: Exception) -> None:
        """Without a receiver at the other end there is nothing to do."""


def bound(kind: int, host: str, port: int, what: str) -> socket.socket:
    """A socket at that address, or an error with the reason."""
    family = socket.AF_INET6 if ":" in host else socket.AF_INET
    made = socket.socket(family, kind)
    try:
        if kind == socket.SOCK_STREAM:
            made.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        made.bind((host, port))
    except OSError as error:
        made.close()
        raise faults.Refused(f"{what} {faults.quoted(host)}, port {port}:"
                             f" {faults.reason(error)}") from error
    made.setblocking(False)
    return made


async def serve(listen, port, token, frames, console, relay, events, yamcs,
                seconds, reports=False, only=None, fetcher=None):
    """Runs the station until it is ended."""
    from aiohttp import web as http

    from urv import archive, processes, relay as relays, web
    from urv.controls import Controls
    from urv.view import View

    loop = asyncio.get_running_loop()
    keeper = archive.Archive(yamcs) if yamcs else None
    sender = None
    if console is not None:
        sender, console = sender_to("--console", console)
    if events:
        whole_files.refuse_link(events)
    kept = outputs.Output.of_file("--events", events) if events else None

    def told(line: Line) -> None:
        if keeper is not None:
            keeper.take(line)
        if kept is not None:
            kept.put(json.dumps(line.shown()).encode() + b"\n")

    def look_at_events() -> None:
        """A full or slow disk is reported, and never blocks the flight."""
        nonlocal reported
        problem = kept.problem() if kept is not None else None
        if problem is not None and not reported:
            reported = True
            faults.note(problem)
            view.alerts.report(
                "events file", "caution", "EVENTS FILE",
                f"not written any more: {kept.lost}" if kept.lost else problem,
                time.time_ns() // 1000)

    reported = False
    terminal = outputs.Terminal()
    view = View(told)
    receiver = bound(socket.SOCK_DGRAM, *frames, "--frames")
    fetched = None if relay is None else bound(
        socket.SOCK_STREAM, *relay, "--relay")
    door = bound(socket.SOCK_STREAM, listen, port, "--listen")
    receiver.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 20)
    if sender is not None:
        sender.setblocking(False)

    def send(packet: bytes) -> None:
        try:
            sender.sendto(packet, console)
        except OSError:
            # The node is absent, or the machine does not accept the packet.
            # The frames show that no packet arrives.
            pass

    controls = Controls(view, None if sender is None else send,
                        fetcher=fetcher)
    page = web.Station(controls, token)
    options = {"access_log": None, "logger": web.LOG,
               "keepalive_timeout": 5.0, "lingering_time": 1.0}
    runner = http.AppRunner(page.application, **options,
                            handler_cancellation=True, shutdown_timeout=1.0)
    await runner.setup()
    page.door = web.Door(runner.server, **options)
    pushed = 0.0
    keeps = None
    if fetched is not None:
        keeps = (relays.Relay(keeper.until_running) if keeper is not None
                 else relays.Relay())
        fetching = await asyncio.start_server(
            keeps.serve, sock=fetched, backlog=4)

    def take(data: bytes, sender: tuple[str, int]) -> None:
        nonlocal pushed
        if only is not None and plain_address(sender[0]) != only:
            view.stranger(sender[0])
        elif view.datagram(data, sender):
            if keeps is not None:
                keeps.put(data)
            now = loop.time()
            # Every second frame, as it arrives; the next one if that is
            # missing.
            if view.frame.sequence % 2 == 0 or now - pushed >= PUSHES_S:
                pushed = now
                page.push()

    incoming, _ = await loop.create_datagram_endpoint(
        lambda: Frames(take), sock=receiver)
    server = await loop.create_server(page.door, sock=door, backlog=64)
    host, at = door.getsockname()[:2]
    told_at = f"http://{f'[{host}]' if ':' in host else host}:{at}/"
    if token is None:
        terminal.say(f"station: {told_at}")
    else:
        terminal.say(f"station: {told_at}?token={quote(token, safe='')}")
        if not web.is_loopback(listen):
            terminal.say(
                f"station: other machines reach it at {listen}, over plain"
                " HTTP: a listener on the network can read the token, take"
                " the sticks and fly; a tunnel (SSH, WireGuard) keeps"
                " listeners out")
    if only is None and not web.is_loopback(frames[0]):
        terminal.say(
            f"station: any machine that reaches udp:{frames[0]} can send"
            " frames, and the page shows them; --sender ADDRESS takes"
            " those of one machine")
    terminal.say(f"station: frames at udp:{frames[0]}:"
                 f"{receiver.getsockname()[1]}")
    tasks = []
    if keeper is not None:
        tasks.append(asyncio.create_task(keeper.run(view, controls, keeps)))
    if reports:
        tasks.append(asyncio.create_task(processes.take(sys.stdin, view)))
    ends = None if seconds is None else loop.time() + seconds
    looked = 0.0
    try:
        while ends is None or loop.time() < ends:
            await asyncio.sleep(packets.FRAME_S)
            controls.tick()
            now = loop.time()
            if now - pushed >= IDLE_PUSH_S:
                pushed = now
                page.push()
            if now - looked >= 1.0:
                looked = now
                page.door.look(now)
                look_at_events()
    finally:
        for task in tasks:
            task.cancel()
        server.close()
        if keeps is not None:
            fetching.close()
        # A page that has gone, or does not answer, causes no delay.
        await asyncio.gather(*(
            asyncio.wait_for(one.socket.close(
                code=1001, message=b"the station ends"), 1.0)
            for one in list(page.pages.values())), return_exceptions=True)
        await runner.cleanup()
        # A frame that arrives now has no receiver.
        incoming.close()
        controls.fetcher.close()
        if kept is not None:
            kept.close()
            look_at_events()
        terminal.close()
        problems = [each.problem() for each in (kept, terminal)
                    if each is not None and each.problem() is not None]
        if problems:
            raise faults.Failed("; ".join(problems))

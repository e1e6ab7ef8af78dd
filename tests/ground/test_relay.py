# SPDX-License-Identifier: Apache-2.0
"""GND-30: frames and events go to a Yamcs when it can keep them. GND-57: an
event that it does not take costs that event alone. GND-56: it is told what the
clock of the frames shows. GND-60: an archive that stops is an alert. SEC-13: a
browser gets no frames."""

import asyncio
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import asynccontextmanager, suppress
from datetime import datetime
from types import SimpleNamespace

import pytest
from aiohttp import web
from test_node_starts import frame_of
from urv import packets
from urv.archive import (
    FRESH_S, INSTANCE, LINK, STALLS_S, Archive, Link, Taken)
from urv.relay import Relay
from urv.view import View

LONG_S = 300.0


class Yamcs:
    """The answer of a Yamcs about itself."""

    def __init__(self):
        self.state = "STARTING"
        self.asked = 0
        self.events = []
        self.clocks = []
        self.link = {"dataInCount": "7"}

    async def answer(self, _):
        self.asked += 1
        if self.state is None:
            raise web.HTTPServiceUnavailable
        return web.json_response({"name": INSTANCE, "state": self.state})

    async def count(self, _):
        return web.json_response(self.link)

    async def take(self, request):
        event = await request.json()
        if event["message"].startswith("bad "):
            return web.Response(status=int(event["message"][4:]))
        datetime.fromisoformat(event["time"])
        self.events.append(event["message"])
        return web.json_response({})

    async def set(self, request):
        self.clocks.append((await request.json())["doubleValue"])
        return web.json_response({})


@asynccontextmanager
async def relaying():
    """A Yamcs, and a relay that asks it, with two frames."""
    yamcs = Yamcs()
    application = web.Application()
    application.router.add_get(f"/api/instances/{INSTANCE}", yamcs.answer)
    application.router.add_get(f"/api/links/{INSTANCE}/{LINK}", yamcs.count)
    application.router.add_post(f"/api/archive/{INSTANCE}/events", yamcs.take)
    application.router.add_put(
        f"/api/processors/{INSTANCE}/realtime/parameters/URV/clock_ahead",
        yamcs.set)
    runner = web.AppRunner(application)
    await runner.setup()
    site = web.TCPSite(runner, "127.0.0.1", 0)
    await site.start()
    port = runner.addresses[0][1]
    archive = Archive(f"http://127.0.0.1:{port}")
    relay = Relay(archive.until_running)
    relay.put(b"one")
    relay.put(b"two")
    server = await asyncio.start_server(relay.serve, "127.0.0.1", 0)
    try:
        yield yamcs, archive, relay, server.sockets[0].getsockname()
    finally:
        server.close()
        await runner.cleanup()


async def nothing_goes(yamcs, relay):
    """While the Yamcs is asked twice and more."""
    while yamcs.asked < 3:
        await asyncio.sleep(0.05)
    assert relay.sent == 0


def in_time(work):
    """In a thread of its own: that of a worker that has driven a browser has a
    loop already."""
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, asyncio.wait_for(work, LONG_S)).result()


@pytest.mark.parametrize("state", ["STARTING", "INITIALIZED", None])
def test_gnd30_frames_wait_until_every_service_of_yamcs_runs(state):
    """Its link connects before its archive listens: what it was given then
    was in no archive."""
    async def work():
        async with relaying() as (yamcs, _, relay, place):
            yamcs.state = state
            reader, writer = await asyncio.open_connection(*place)
            await nothing_goes(yamcs, relay)
            yamcs.state = "RUNNING"
            assert await reader.readexactly(6) == b"onetwo"
            writer.close()
    in_time(work())


def test_gnd30_a_yamcs_that_goes_while_it_starts_takes_no_frame_with_it():
    async def work():
        async with relaying() as (yamcs, _, relay, place):
            reader, writer = await asyncio.open_connection(*place)
            await nothing_goes(yamcs, relay)
            writer.close()
            await writer.wait_closed()
            yamcs.state = "RUNNING"
            # One client at a time: until the first has gone, it is refused.
            data = b""
            while not data:
                reader, writer = await asyncio.open_connection(*place)
                try:
                    data = await reader.read(6)
                except ConnectionError:
                    pass
            data += await reader.readexactly(6 - len(data))
            assert data == b"onetwo"
            assert relay.lost == 0
            writer.close()
    in_time(work())


def test_sec13_a_client_that_sends_a_request_gets_no_frame():
    async def work():
        async with relaying() as (yamcs, _, relay, place):
            yamcs.state = "RUNNING"
            reader, writer = await asyncio.open_connection(*place)
            writer.write(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
            with suppress(ConnectionError):
                assert await reader.read() == b""
            writer.close()
            # Its place is free for Yamcs.
            reader, writer = await asyncio.open_connection(*place)
            assert await reader.readexactly(6) == b"onetwo"
            writer.close()
    in_time(work())


@pytest.mark.parametrize("state", ["STARTING", "FAILED", None])
def test_gnd30_events_wait_until_every_service_of_yamcs_runs(state):
    async def work():
        async with relaying() as (yamcs, archive, relay, _):
            yamcs.state = state
            controls = SimpleNamespace(archive=None)
            view = View(archive.take)
            view.note("info", "mark", "gear up")
            running = asyncio.create_task(
                archive.run(view, controls, relay))
            while yamcs.asked < 2:
                await asyncio.sleep(0.1)
            assert yamcs.events == []
            assert controls.archive == {"text": "no Yamcs", "lost": True}
            yamcs.state = "RUNNING"
            while controls.archive["lost"]:
                await asyncio.sleep(0.1)
            assert yamcs.events == ["gear up"]
            assert controls.archive["text"] == "7 frames"
            running.cancel()
    in_time(work())


def test_gnd57_an_event_that_yamcs_does_not_take_costs_itself():
    """Whatever its status, and whatever time it has."""
    async def work():
        async with relaying() as (yamcs, archive, relay, _):
            yamcs.state = "RUNNING"
            controls = SimpleNamespace(archive=None)
            view = View(archive.take)
            for time_us in (-1, 0, packets.LATEST_US, 2**64 - 1, 10**30):
                view.note("info", "mark", f"at {time_us}", time_us)
                view.note("info", "mark", "bad 400")
            view.note("info", "mark", "bad 500")
            view.note("info", "mark", "the last")
            running = asyncio.create_task(
                archive.run(view, controls, relay))
            while "the last" not in yamcs.events:
                assert not running.done(), running.result()
                await asyncio.sleep(0.1)
            assert yamcs.events == [
                *(f"at {time_us}" for time_us in (
                    -1, 0, packets.LATEST_US, 2**64 - 1, 10**30)),
                "the last"]
            while (controls.archive or {}).get("text") != (
                    "7 frames, 6 events lost"):
                await asyncio.sleep(0.1)
            running.cancel()
    in_time(work())


def test_gnd60_a_disabled_link_of_yamcs_is_an_alert():
    def alerts(view):
        return {alert["name"]: alert for alert in view.alerts.shown()}

    async def work():
        async with relaying() as (yamcs, archive, relay, _):
            yamcs.state = "RUNNING"
            yamcs.link["disabled"] = True
            controls = SimpleNamespace(archive={"text": ""})
            view = View(archive.take)
            running = asyncio.create_task(
                archive.run(view, controls, relay))
            while "ARCHIVE STOPPED" not in alerts(view):
                await asyncio.sleep(0.1)
            alert = alerts(view)["ARCHIVE STOPPED"]
            assert alert["level"] == "caution"
            assert controls.archive == {
                "text": "7 frames, its link is disabled", "lost": True}
            yamcs.link["disabled"] = False
            while controls.archive["lost"]:
                await asyncio.sleep(0.1)
            assert not alerts(view)["ARCHIVE STOPPED"]["active"]
            running.cancel()
    in_time(work())


def test_gnd56_yamcs_gets_the_clock_of_the_frames_once():
    async def work():
        async with relaying() as (yamcs, archive, relay, _):
            yamcs.state = "RUNNING"
            controls = SimpleNamespace(archive=None)
            view = View(archive.take)
            running = asyncio.create_task(
                archive.run(view, controls, relay))
            while controls.archive is None or controls.archive["lost"]:
                await asyncio.sleep(0.1)
            assert yamcs.clocks == [], "no frame has come"
            view.datagram(frame_of(0, time_us=round(
                1e6 * (time.time() + 3600.0))).encode())
            asked = yamcs.asked
            while yamcs.asked < asked + 4:
                await asyncio.sleep(0.1)
            [ahead_s] = yamcs.clocks
            assert ahead_s == pytest.approx(-3600.0, abs=1.0)
            running.cancel()
    in_time(work())


def test_gnd60_an_archive_that_takes_no_frames_while_they_come_is_reported():
    taken, fresh = Taken(), 0.5 * FRESH_S
    assert taken.wrong(Link(7), fresh, 100.0) == ""
    assert taken.wrong(Link(7), fresh, 99.9 + STALLS_S) == ""
    assert taken.wrong(Link(7), fresh, 100.0 + STALLS_S) == (
        "its count has not risen for 15 s")
    assert taken.wrong(Link(8), fresh, 101.0 + STALLS_S) == ""
    # Without frames nothing can be taken; another Yamcs counts from nothing.
    for age in (None, 2 * FRESH_S):
        assert taken.wrong(Link(8), age, 200.0) == ""
    assert taken.wrong(Link(8), fresh, 199.9 + STALLS_S) == ""
    assert taken.wrong(Link(0), fresh, 200.1 + STALLS_S) == ""
    assert taken.wrong(Link(0, True), fresh, 200.2 + STALLS_S) == (
        "its link is disabled")

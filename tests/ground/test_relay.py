# SPDX-License-Identifier: Apache-2.0
"""GND-30: frames go to a Yamcs when it can keep them."""

import asyncio
from contextlib import asynccontextmanager

import pytest
from aiohttp import web
from urv.archive import INSTANCE, Archive
from urv.relay import Relay

LONG_S = 30.0
SHORT_S = 0.5


class Yamcs:
    """What a Yamcs says of itself."""

    def __init__(self):
        self.state = "STARTING"
        self.asked = 0

    async def answer(self, _):
        self.asked += 1
        if self.state is None:
            raise web.HTTPServiceUnavailable
        return web.json_response({"name": INSTANCE, "state": self.state})


@asynccontextmanager
async def relaying():
    """A Yamcs, and a relay that asks it, with two frames."""
    yamcs = Yamcs()
    application = web.Application()
    application.router.add_get(f"/api/instances/{INSTANCE}", yamcs.answer)
    runner = web.AppRunner(application)
    await runner.setup()
    site = web.TCPSite(runner, "127.0.0.1", 0)
    await site.start()
    port = runner.addresses[0][1]
    relay = Relay(Archive(f"http://127.0.0.1:{port}").until_running)
    relay.put(b"one")
    relay.put(b"two")
    server = await asyncio.start_server(relay.serve, "127.0.0.1", 0)
    try:
        yield yamcs, relay, server.sockets[0].getsockname()
    finally:
        server.close()
        await runner.cleanup()


async def nothing_comes(reader):
    with pytest.raises(TimeoutError):
        await asyncio.wait_for(reader.read(1), SHORT_S)


def in_time(work):
    asyncio.run(asyncio.wait_for(work, LONG_S))


@pytest.mark.parametrize("state", ["STARTING", "INITIALIZED", None])
def test_gnd30_frames_wait_until_every_service_of_yamcs_runs(state):
    """Its link connects before its archive listens: what it was given then
    was in no archive."""
    async def work():
        async with relaying() as (yamcs, relay, place):
            yamcs.state = state
            reader, writer = await asyncio.open_connection(*place)
            await nothing_comes(reader)
            assert yamcs.asked > 1
            assert relay.sent == 0
            yamcs.state = "RUNNING"
            assert await reader.readexactly(6) == b"onetwo"
            writer.close()
    in_time(work())


def test_gnd30_a_yamcs_that_goes_while_it_starts_takes_no_frame_with_it():
    async def work():
        async with relaying() as (yamcs, relay, place):
            reader, writer = await asyncio.open_connection(*place)
            await nothing_comes(reader)
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

# SPDX-License-Identifier: Apache-2.0
"""bin/urv yamcs-gate: Yamcs's pages for this machine alone (SEC-13)."""

from __future__ import annotations

import asyncio
import socket

import typer

from urv import outputs
from urv.station import bound, check_yamcs, until_ended

HERE = "127.0.0.1"


def yamcs_gate(
    yamcs: str = typer.Option(
        ..., envvar="URV_YAMCS", show_envvar=True, metavar="URL",
        help="URL of a Yamcs, with the path of its contextPath."),
    port: int = typer.Option(
        8092, min=0, max=65535,
        help="Port of the pages, at this machine's loopback; 0 takes a free"
        " one."),
):
    """Serve the pages of a Yamcs to this machine."""
    check_yamcs(yamcs)
    asyncio.run(until_ended(serve(yamcs, port)))


async def serve(yamcs: str, port: int) -> None:
    """Serves the pages until it is ended."""
    from aiohttp import web as http

    from urv import gate, web

    door = bound(socket.SOCK_STREAM, HERE, port, "--port")
    runner = http.AppRunner(
        gate.Gate(yamcs).application, access_log=None, logger=web.LOG,
        keepalive_timeout=15.0, handler_cancellation=True,
        shutdown_timeout=1.0)
    await runner.setup()
    try:
        await http.SockSite(runner, door).start()
        outputs.Terminal().say(
            f"yamcs-gate: pages at http://{HERE}:{door.getsockname()[1]}/")
        await asyncio.Event().wait()
    finally:
        await runner.cleanup()

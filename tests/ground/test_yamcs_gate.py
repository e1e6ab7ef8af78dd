# SPDX-License-Identifier: Apache-2.0
"""SEC-13: no web page controls Yamcs. The Gate before it refuses foreign
pages, other names of this machine and requests that change something. Yamcs
itself is below a path that no page knows, and its guest may only do what the
station does."""

import asyncio
import contextlib
import json
import re
import urllib.error
import urllib.request
from concurrent.futures import ThreadPoolExecutor

import aiohttp
import pytest
import websocket
from aiohttp import WSMsgType, web
from flight_rig import Ground, needs_yamcs
from station_rig import PATIENCE_S, until
from yarl import URL

from urv import gate, ground

SECRET = "/7cd1f0"
LARGE = 3 * gate.PART
INDEX = f'<base href="{SECRET}/"><script src="{SECRET}/main.js"></script>'

FOREIGN = (
    {"Host": "evil.example"}, {"Host": "evil.localhost"}, {"Host": ""},
    {"Origin": "http://evil.example"}, {"Origin": "null"},
    {"Origin": "https://127.0.0.1:{port}"}, {"Origin": "http://127.0.0.1:1"},
    {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"},
    {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate",
     "Sec-Fetch-Dest": "iframe"})
OWN = (
    {}, {"Host": "localhost:{port}"}, {"Origin": "http://127.0.0.1:{port}"},
    {"Sec-Fetch-Site": "same-origin"}, {"Sec-Fetch-Site": "none"},
    # A link on a foreign page, which opens Yamcs's own.
    {"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "navigate",
     "Sec-Fetch-Dest": "document"})

READS = (
    "archive/urv/events:list", "archive/urv/packets:list?fields=id",
    "mdb/urv/parameters:batchGet",
    "processors/urv/realtime/parameters:batchGet",
    "archive/urv:exportParameterValues", "archive/urv:streamEventIndex",
    "stream-archive/urv:streamPackets", "timeline/urv/items:list")

CLOCK = "processors/urv/realtime/parameters/URV/clock_ahead"
CONTROL = (
    ("POST", "links/urv/frames:disable", {}),
    ("POST", "links/urv/frames:resetCounters", {}),
    ("POST", "instances/urv:stop", {}),
    ("POST", "instances/urv:restart", {}),
    ("POST", "instances", {"name": "other", "template": "x"}),
    ("POST", "services/urv/parameter-archive:stop", {}),
    ("POST", "processors", {"instance": "urv", "name": "replay",
                            "type": "Archive", "persistent": True}),
    ("PATCH", "processors/urv/realtime", {"state": "paused"}),
    ("PUT", "processors/urv/realtime/parameters/URV/sequence",
     {"type": "UINT32", "uint32Value": 7}),
    ("POST", "processors/urv/realtime/parameters:batchSet", {"request": [
        {"id": {"name": "/URV/sequence"},
         "value": {"type": "UINT32", "uint32Value": 7}}]}),
    ("POST", "archive/urv:executeSql", {"statement": "drop table tm"}),
    ("POST", "archive/urv:executeStreamingSql",
     {"statement": "select * from tm"}),
    ("POST", "archive/urv/tables/tm:rebuildHistogram", {}),
    ("POST", "archive/urv/parameterArchive:purge", {}),
    ("POST", "buckets/_global/displays/objects/flight.opi", {}),
    ("DELETE", "buckets/_global/displays/objects/flight.opi", {}),
    ("DELETE", "storage/buckets/displays", {}),
    ("POST", "storage/buckets", {"name": "more"}),
    ("POST", "users", {"name": "me", "password": "12345678"}),
    ("POST", "timeline/urv/items", {"type": "EVENT", "start":
                                    "2026-01-01T00:00:00Z", "duration": "1s"}),
    ("PATCH", "mdb-overrides/urv/realtime/parameters/URV/sequence", {}))
WRITES = (
    ("POST", "archive/urv/events", {"message": "no"}),
    ("PUT", CLOCK, {"type": "DOUBLE", "doubleValue": 9.0}))
"""Requests that the station may send to Yamcs itself."""


class Yamcs:
    """A server at a secret path, and the requests that it got."""

    def __init__(self):
        self.asked = []
        self.go = asyncio.Event()
        self.application = web.Application(client_max_size=1 << 20)
        add = self.application.router.add_route
        add("GET", SECRET + "/", self.index)
        add("GET", SECRET + "/api/websocket", self.socket)
        add("GET", SECRET + "/api/large", self.large)
        add("GET", SECRET + "/api/broken", self.broken)
        add("*", SECRET + "/api/{path:.*}", self.api)

    async def index(self, request):
        self.asked.append(request)
        return web.Response(text=INDEX, content_type="text/html",
                            headers={"Set-Cookie": "a=b"})

    async def api(self, request):
        self.asked.append(request)
        return web.json_response({
            "path": request.raw_path, "body": await request.text(),
            "host": request.headers["Host"],
            "headers": sorted(request.headers)})

    async def large(self, request):
        answer = web.StreamResponse()
        await answer.prepare(request)
        await answer.write(b"first")
        await self.go.wait()
        await answer.write(bytes(LARGE))
        return answer

    async def broken(self, request):
        answer = web.StreamResponse(headers={"Content-Length": "100"})
        await answer.prepare(request)
        await answer.write(b"a part")
        request.transport.close()
        return answer

    async def socket(self, request):
        self.asked.append(request)
        answer = web.WebSocketResponse(protocols=("protobuf", "json"),
                                       max_msg_size=1 << 20)
        await answer.prepare(request)
        async for message in answer:
            if message.data == "large":
                await answer.send_str("x" * LARGE)
            elif message.data == "end":
                break
            elif message.type == WSMsgType.TEXT:
                await answer.send_str(message.data)
            else:
                await answer.send_bytes(message.data)
        return answer


@contextlib.asynccontextmanager
async def served(application, **more):
    """It, at the port that comes."""
    runner = web.AppRunner(application, shutdown_timeout=1.0, **more)
    await runner.setup()
    site = web.TCPSite(runner, "127.0.0.1", 0)
    await site.start()
    try:
        yield runner.addresses[0][1]
    finally:
        await runner.cleanup()


def in_time(work):
    """In a thread of its own: that of a worker that has driven a browser has a
    loop already."""
    with ThreadPoolExecutor(1) as thread:
        thread.submit(asyncio.run, asyncio.wait_for(work, PATIENCE_S)).result()


def through_the_gate(work):
    """Carries it out, with a Yamcs, the gate's port and a client."""
    async def all_of_it():
        yamcs = Yamcs()
        async with (served(yamcs.application) as place,
                    served(gate.Gate(f"http://127.0.0.1:{place}{SECRET}")
                           .application, handler_cancellation=True) as port,
                    aiohttp.ClientSession(
                        f"http://127.0.0.1:{port}") as client):
            await work(yamcs, port, client)
    in_time(all_of_it())


def as_it_is(port, path):
    """A URL that the client does not put into another form."""
    return URL(f"http://127.0.0.1:{port}{path}", encoded=True)


def filled(headers, port):
    return {name: value.format(port=port) for name, value in headers.items()}


def test_sec13_foreign_names_and_pages_get_403_and_reach_nothing():
    async def work(yamcs, port, client):
        for headers in FOREIGN:
            more = filled(headers, port)
            for method, path in (("GET", "/"), ("GET", "/api/user"),
                                 ("POST", f"/api/{READS[0]}"),
                                 ("POST", f"/api/{CONTROL[0][1]}")):
                async with client.request(method, path,
                                          headers=more) as answer:
                    assert answer.status == 403, (headers, path)
                    assert (await answer.text()).startswith("refused: ")
            with pytest.raises(aiohttp.WSServerHandshakeError) as error:
                await client.ws_connect("/api/websocket", headers=more)
            assert error.value.status == 403, headers
        assert yamcs.asked == []
    through_the_gate(work)


def test_sec13_own_pages_and_programs_get_the_answer():
    async def work(_, port, client):
        for headers in OWN:
            async with client.get(
                    as_it_is(port, "/api/a%2Fb?c=%20d&e"), headers=filled(
                        headers | {"Cookie": "a=b"}, port)) as answer:
                assert answer.status == 200, headers
                said = await answer.json()
                assert said["path"] == f"{SECRET}/api/a%2Fb?c=%20d&e"
                assert said["headers"] == ["Accept", "Host"]
                assert answer.headers["X-Frame-Options"] == "SAMEORIGIN"
                assert answer.headers["X-Content-Type-Options"] == "nosniff"
    through_the_gate(work)


def test_sec13_requests_that_change_something_get_403():
    async def work(yamcs, port, client):
        for method, path, body in CONTROL + WRITES:
            async with client.request(method, f"/api/{path}",
                                      json=body) as answer:
                assert answer.status == 403, (method, path)
        # A path that only the gate would take for a read does not pass either.
        for path in ("/api/links/urv%2Fframes:disable:list", "/api/x:list/y",
                     "/api/archive/urv:executeSql?:list", "/auth/token",
                     "/api/archive/urv/events%3Alist", "/:list"):
            async with client.post(as_it_is(port, path)) as answer:
                assert answer.status == 403, path
        for method in ("PUT", "DELETE", "PATCH", "OPTIONS", "TRACE"):
            async with client.request(method, f"/api/{READS[0]}") as answer:
                assert answer.status == 403, method
        assert yamcs.asked == []
        for path in READS:
            async with client.post(f"/api/{path}", json={"q": 1}) as answer:
                assert answer.status == 200, path
                said = await answer.json()
                assert said["path"] == f"{SECRET}/api/{path}"
                assert said["body"] == '{"q": 1}'
    through_the_gate(work)


def test_sec13_no_answer_says_the_path():
    async def work(_, port, client):
        async with client.get("/") as answer:
            assert await answer.text() == INDEX.replace(SECRET, "")
            assert SECRET not in str(answer.headers)
            assert "Set-Cookie" not in answer.headers
        async with client.get(as_it_is(port, "/../elsewhere")) as answer:
            assert answer.status == 404
            assert SECRET not in await answer.text()
    through_the_gate(work)


def test_sec13_a_socket_passes_both_ways():
    async def work(_, port, client):
        async with client.ws_connect(
                "/api/websocket", protocols=("json",), max_msg_size=1 << 20,
                headers={"Origin": f"http://127.0.0.1:{port}"}) as socket:
            assert socket.protocol == "json"
            await socket.send_str("a text")
            assert await socket.receive_str() == "a text"
            await socket.send_bytes(b"bytes\0")
            assert await socket.receive_bytes() == b"bytes\0"
            await socket.send_str("large")
            assert len(await socket.receive_str()) == LARGE
            await socket.send_str("end")
            assert (await socket.receive()).type in (
                WSMsgType.CLOSE, WSMsgType.CLOSING, WSMsgType.CLOSED)
    through_the_gate(work)


def test_sec13_a_large_answer_passes_as_it_comes_and_never_seems_whole():
    async def work(yamcs, _, client):
        async with client.get("/api/large") as answer:
            assert await answer.content.readexactly(5) == b"first"
            yamcs.go.set()
            assert len(await answer.read()) == LARGE
        with pytest.raises(aiohttp.ClientError):
            async with client.get("/api/broken") as answer:
                await answer.read()
        async with client.post(f"/api/{READS[0]}", data=bytes(
                gate.LARGEST_REQUEST + 1)) as answer:
            assert answer.status == 413
    through_the_gate(work)


def test_sec13_without_a_yamcs_it_says_so():
    async def work():
        async with (served(gate.Gate("http://127.0.0.1:1/x").application
                           ) as port,
                    aiohttp.ClientSession() as client,
                    client.get(f"http://127.0.0.1:{port}/") as answer):
            assert answer.status == 502
            assert await answer.text() == "Yamcs does not answer\n"
    in_time(work())


@pytest.mark.parametrize("name", ["etc/yamcs.yaml", "mdb/urv.xml"])
def test_sec15_yamcs_s_files_are_not_written_through_links(tmp_path, name):
    elsewhere = tmp_path / "elsewhere"
    elsewhere.write_text("whole", "utf-8")
    folder = tmp_path / "flight"
    (folder / name).parent.mkdir(parents=True)
    (folder / name).symlink_to(elsewhere)
    flight = ground.Flight(folder, 6001, 8090, 8092)
    assert not flight.start_yamcs()
    assert "symbolic link" in flight.losses["yamcs"]
    assert elsewhere.read_text("utf-8") == "whole"
    assert flight.running == {}
    flight.terminal.close()


@pytest.mark.parametrize("url", [
    "127.0.0.1", "http://", "http://[", "http://127.0.0.1:99999/",
    "http://127.0.0.1:0/", "http://here:port/", "http://two words/"])
def test_sec13_what_is_no_url_is_refused(urv, url):
    """The gate ended with a traceback, and the station started: the archive
    then never answered."""
    for command in (("yamcs-gate", "--port", "0"), (
            "station", "--seconds", "0.1", "--port", "0",
            "--frames", "udp:127.0.0.1:0")):
        result = urv(*command, "--yamcs", url)
        assert (result.returncode, result.stderr) == (
            2, f'urv: --yamcs "{url}": not http://HOST:PORT or'
            " http://HOST:PORT/PATH\n")


# A flight's own Yamcs, started once.

LOOK = ("links/urv/frames", "instances/urv", "processors/urv/realtime",
        "mdb/urv/parameters", "archive/urv/events", "archive/urv/packets",
        "processors/urv/realtime/alarms", "storage/buckets/displays/objects",
        "storage/buckets/displays/objects/flight.opi", CLOCK,
        "processors/urv/realtime/parameters/URV/sequence", "user")


class Place:
    """Yamcs, through its gate or at its own port."""

    def __init__(self, url):
        self.url = url

    def ask(self, path, method="GET", body=None, **headers):
        """The status of the answer, and its text."""
        data = None if method == "GET" else json.dumps(body or {}).encode()
        request = urllib.request.Request(
            self.url + path, method=method, data=data,
            # As a form of a foreign page sends it.
            headers={"Content-Type": "text/plain"} | headers)
        try:
            with urllib.request.urlopen(request,
                                        timeout=PATIENCE_S) as answer:
                return answer.status, answer.read().decode("utf-8", "replace")
        except urllib.error.HTTPError as error:
            return error.code, error.read().decode("utf-8", "replace")

    def status_of_socket(self):
        """The status of an answer to a foreign page's WebSocket."""
        with pytest.raises(websocket.WebSocketBadStatusException) as error:
            websocket.create_connection(
                self.url.replace("http", "ws") + "/api/websocket",
                timeout=PATIENCE_S, origin="http://evil.example")
        return error.value.status_code


@pytest.fixture(scope="module")
def flight(tmp_path_factory):
    """A flight with a Yamcs that has frames, the gate, Yamcs's own port, and
    the path there."""
    with Ground(tmp_path_factory.mktemp("gate")) as flown:
        until(lambda: "live after" in flown.said(), "Yamcs", 5 * PATIENCE_S)
        flown.wait(lambda state: state["archive"]
                   and re.match("[1-9]", state["archive"]["text"]), "frames")
        text = (flown.folder / "etc" / "yamcs.yaml").read_text("utf-8")
        port = re.search(r" port: (\d+)", text)[1]
        path = re.search(r" contextPath: (/[0-9a-f]{32})\n", text)[1]
        yield (flown, Place(f"http://127.0.0.1:{flown.yamcs_port}"),
               Place(f"http://127.0.0.1:{port}"), path)


@needs_yamcs
def test_sec13_no_web_page_controls_a_flight_s_yamcs(flight):
    flown, gated, own, secret = flight
    # Its own port without the path: nothing is there.
    for path in ("/", "/api/user", "/yamcs/api/user", "/auth",
                 f"/{secret}/api/user", f"{secret[:-1]}/api/user"):
        assert own.ask(path)[0] == 404, path
    assert own.ask("/api/links/urv/frames:disable", "POST")[0] == 404
    assert own.status_of_socket() == 404

    # The gate: foreign pages and names get nothing, own ones everything.
    assert gated.status_of_socket() == 403
    for headers in ({"Host": "evil.example"},
                    {"Origin": "http://evil.example"}):
        assert gated.ask("/api/user", **headers)[0] == 403
        assert gated.ask("/api/links/urv/frames:disable", "POST",
                         **headers)[0] == 403
    answers = {path: gated.ask(f"/api/{path}") for path in LOOK}
    assert {path: status for path, (status, _) in answers.items()
            if status != 200} == {}, answers
    page = gated.ask("/")[1]
    assert '<base href="/">' in page
    assert secret[1:] not in page + "".join(
        text for _, text in answers.values())
    assert not json.loads(answers["user"][1])["superuser"]

    # A client that knows the path controls nothing either; the station's own
    # writes pass there alone.
    answers = {(method, path): own.ask(f"{secret}/api/{path}", method, body)
               for method, path, body in CONTROL}
    assert {asked: answer for asked, answer in answers.items()
            if answer[0] not in (403, 404)} == {}
    for method, path, body in WRITES:
        assert gated.ask(f"/api/{path}", method, body)[0] == 403
    assert not json.loads(
        gated.ask("/api/links/urv/frames")[1]).get("disabled")
    until(lambda: json.loads(gated.ask(f"/api/{CLOCK}")[1]).get("engValue"),
          "the clock, which the station sets")
    flown.wait(lambda state: not state["archive"]["lost"], "the archive")


@needs_yamcs
def test_sec13_yamcs_s_display_works_behind_the_gate(flight, browser):
    flown, gated, *_ = flight
    page = browser.new_page(viewport={"width": 1500, "height": 860})
    page.set_default_timeout(1000 * PATIENCE_S)
    updates, bad = [], []
    page.on("websocket", lambda socket: socket.on(
        "framereceived", lambda text: updates.append(text)
        if '"parameters"' in str(text) else None))
    page.on("response", lambda answer: bad.append(answer.url)
            if answer.status >= 400 else None)
    page.goto(next(word for word in flown.said().split()
                   if "flight.opi" in word))
    page.locator("canvas").first.wait_for()
    until(lambda: page.wait_for_timeout(100) or len(updates) > 20,
          "values of the display")
    assert bad == []
    # By a name that leads here, as a foreign page's name server can do it.
    page.goto(f"{gated.url.replace('127.0.0.1', 'evil.localhost')}/")
    assert "refused: Host is not this machine's" in page.content()
    page.close()

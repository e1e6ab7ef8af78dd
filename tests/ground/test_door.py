# SPDX-License-Identifier: Apache-2.0
"""SEC-11: strangers at the station's page hold no place of a pilot's, cannot
try tokens quickly, and get one line for bytes without sense."""

import contextlib
import http.client
import os
import socket
import time
from types import SimpleNamespace

import pytest
from station_rig import PATIENCE_S, Station, until

from urv import door, web
from urv.door import Door, Token, address_of

WORD = "no stranger's"
PILOT, STRANGER = "127.0.0.1", "127.0.0.2"


@pytest.fixture(scope="module")
def record(standard):
    return standard / "record.csv"


@pytest.fixture
def guarded(record, tmp_path):
    """A station that demands the token WORD."""
    with Station(record, tmp_path, "--listen", "0.0.0.0", "--token",
                 WORD) as station:
        yield station


def ask(station, path="/api/state", source=PILOT, **headers):
    """Status, head and body of an answer to a machine at that address."""
    client = http.client.HTTPConnection(
        "127.0.0.1", station.port, timeout=PATIENCE_S,
        source_address=(source, 0))
    with contextlib.closing(client):
        client.request("GET", path, headers={
            name.replace("_", "-"): value for name, value in headers.items()})
        answer = client.getresponse()
        return answer.status, answer.headers, answer.read().decode()


def session(station, source=PILOT):
    """The cookie of a browser that has opened the page's address."""
    status, head, _ = ask(station, station.url.partition(
        str(station.port))[2], source)
    assert status == 303
    return head["Set-Cookie"].partition(";")[0]


def connections(station, count, source):
    return [socket.create_connection(("127.0.0.1", station.port),
                                     timeout=PATIENCE_S,
                                     source_address=(source, 0))
            for _ in range(count)]


def open_ones(clients):
    """Those that the station has not shut."""
    found = []
    for client in clients:
        client.setblocking(False)
        try:
            client.recv(1)
        except BlockingIOError:
            found.append(client)
        except OSError:
            pass
    return found


# Places

def test_sec11_sixteen_idle_pages_do_not_keep_another_one_out(
        record, tmp_path):
    with Station(record, tmp_path) as station:
        holder = station.console()
        holder.take()
        holder.listen()
        idle = [station.console() for _ in range(web.MOST_PAGES - 1)]

        def opened():
            with contextlib.suppress(Exception):
                return station.console()

        pilot = until(opened, "a page", pause=0.5)
        # The holder of the sticks stays, however quiet.
        pilot.until(lambda state: state["holder"]
                    == holder.number, "a state")
        station.logged("silent, and another page opens")
        for page in (*idle, holder, pilot):
            page.close()


def test_sec11_pages_in_use_are_not_shut_for_another_one():
    pages = {number: web.Page(number, None) for number in range(1, 17)}
    station = web.Station(SimpleNamespace(
        sticks=SimpleNamespace(holder=None)))
    station.pages = pages
    for number, page in pages.items():
        page.heard = 100.0 + number / 10
    assert not station._drop_a_quiet_page(101.6)


def test_sec11_idle_connections_of_strangers_leave_the_pilot_room(guarded):
    shown = {"Cookie": session(guarded)}
    idle = []
    try:
        for last in range(2, 8):
            idle += connections(guarded, door.MOST_WAITING,
                                f"127.0.0.{last}")
        assert ask(guarded, **shown)[0] == 200
        assert len(open_ones(idle)) <= door.MOST_WAITING
        # They do not stay, either.
        until(lambda: not open_ones(idle), "all shut")
    finally:
        for client in idle:
            client.close()


def test_sec11_a_strangers_connections_shut_nobody_elses(guarded):
    """Up to the places of one address."""
    mine = connections(guarded, 1, PILOT)
    others = connections(guarded, door.MOST_OF_ADDRESS * 2, STRANGER)
    try:
        until(lambda: len(open_ones(others)) <= door.MOST_OF_ADDRESS,
              "some shut")
        mine[0].setblocking(True)
        mine[0].sendall(b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n")
        assert b"401" in mine[0].recv(100)
    finally:
        for client in (*mine, *others):
            client.close()


class Transport:
    is_shut = False

    def abort(self):
        self.is_shut = True


class Visitor:
    def __init__(self, address):
        self.address, self.transport = address, Transport()


def test_sec11_the_address_with_most_places_gives_one(event_loop_time):
    place = Door(None)
    pilot = Visitor("pilot")
    place.enters(pilot)
    strangers = [Visitor(f"stranger {number % 4}")
                 for number in range(4 * door.MOST_OF_ADDRESS)]
    for stranger in strangers:
        place.enters(stranger)
    assert not pilot.transport.is_shut
    assert sum(not each.transport.is_shut
               for each in strangers) == door.MOST_WAITING - 1
    # The oldest first.
    assert strangers[0].transport.is_shut
    assert not strangers[-1].transport.is_shut
    # One that is known takes no place of those who wait, and has more time.
    place.knows(pilot)
    place.look(event_loop_time + door.WAITS_S + 0.1)
    assert all(each.transport.is_shut for each in strangers)
    assert not pilot.transport.is_shut
    place.look(event_loop_time + door.PATIENCE_S + 0.1)
    assert pilot.transport.is_shut


@pytest.fixture
def event_loop_time(monkeypatch):
    """The time of a loop in which none passes."""
    monkeypatch.setattr(door.asyncio, "get_running_loop",
                        lambda: SimpleNamespace(time=lambda: 50.0))
    return 50.0


@pytest.mark.parametrize("host, address", [
    ("192.0.2.7", "192.0.2.7"), ("::ffff:192.0.2.7", "192.0.2.7"),
    ("2001:db8::1:2:3:4", "2001:db8::/64"), ("fe80::1%eth0", "fe80::/64"),
    (None, ""), ("no address", "")])
def test_sec11_an_ipv6_network_is_one_address(host, address):
    assert address_of(host) == address


# Tries

def test_sec11_tokens_cannot_be_tried_quickly(guarded):
    shown = {"Cookie": session(guarded, STRANGER)}
    began = time.monotonic()
    answers = [ask(guarded, f"/?token=wrong{number}", STRANGER)[0]
               for number in range(3 * door.BURST)]
    most = door.BURST + door.TRIES_A_SECOND * (time.monotonic() - began) + 1
    assert 401 in answers and answers.count(401) <= most
    assert set(answers) == {401, 429}

    def limited():
        """Tries come back with time: until none is left."""
        return ask(guarded, "/", STRANGER)[0] == 429

    until(limited, "no try left")
    # Not even the right one is looked at. A browser with a session stays in,
    # and others are not concerned.
    assert 429 in [ask(guarded, "/api/state", STRANGER,
                       Authorization=f"Bearer {WORD}")[0],
                   ask(guarded, "/", STRANGER)[0]]
    assert ask(guarded, source=STRANGER, **shown)[0] == 200
    assert ask(guarded, Authorization=f"Bearer {WORD}")[0] == 200


def test_sec11_tries_come_back_and_addresses_are_bounded():
    token = Token(WORD)
    for _ in range(door.BURST):
        assert token.may_try("a", 0.0)
        token.failed("a", 0.0)
    assert not token.may_try("a", 0.0)
    assert token.may_try("b", 0.0)
    assert not token.may_try("a", 0.9 / door.TRIES_A_SECOND)
    assert token.may_try("a", 1.0 / door.TRIES_A_SECOND)
    for number in range(3 * door.MOST_ADDRESSES):
        token.failed(str(number), 1.0)
    assert len(token._tries) == door.MOST_ADDRESSES


def test_sec11_a_browser_is_given_another_word_than_the_token(guarded):
    cookie = session(guarded)
    assert WORD not in cookie
    assert ask(guarded, Cookie=cookie)[0] == 200
    # The same after a start with the same token.
    assert cookie == f"{web.COOKIE}={Token(WORD).session}"


# Bytes without sense

BYTES = b"\xff\xfe\x80"
SENSELESS = {
    "path": b"GET /%b HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "query": b"GET /?token=%b HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "escapes": b"GET /?token=%%ff%%fe%b HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "cookie": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n"
              b"Cookie: urv_token=%b\r\n\r\n",
    "bearer": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n"
              b"Authorization: Bearer %b\r\n\r\n",
    "host": b"GET / HTTP/1.1\r\nHost: %b\r\n\r\n",
    "origin": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nOrigin: %b\r\n\r\n",
    "site": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n"
            b"Sec-Fetch-Site: %b\r\n\r\n",
    "header": b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n%b: 1\r\n\r\n",
    "method": b"%b / HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n",
    "version": b"GET / HTTP/%b\r\nHost: 127.0.0.1\r\n\r\n",
    "TLS": b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03%b\r\n\r\n"}


@pytest.mark.parametrize("place", SENSELESS)
def test_sec11_bytes_without_sense_get_one_line(guarded, place):
    # The rig checks that the station has written nothing to standard error.
    with socket.create_connection(("127.0.0.1", guarded.port)) as client:
        client.settimeout(PATIENCE_S)
        client.sendall(SENSELESS[place] % BYTES)
        answer = b"".join(iter(lambda: client.recv(1000), b""))
    head, _, body = answer.partition(b"\r\n\r\n")
    status = int(head.split()[1])
    assert status in (400, 401, 403, 404, 405), answer
    assert body.count(b"\n") == 1 and body.endswith(b"\n"), answer
    assert body[:-1].decode().isprintable()


@pytest.mark.parametrize("word", [
    b"\xff\xfe in a token", "schl\u00fcssel".encode(), b"a token\nof lines"])
def test_sec11_a_token_of_other_characters_is_refused(urv, word):
    result = urv("station", "--port", "0", "--frames", "udp:127.0.0.1:0",
                 env={**os.environb, b"URV_TOKEN": word})
    assert result.returncode == 2
    assert result.stderr == ("urv: --token: a word of printable ASCII"
                             " characters is needed\n")


def test_sec11_a_token_with_signs_opens_the_page(record, tmp_path):
    with Station(record, tmp_path, "--token", "a+b&c=d #%41/?\";") as station:
        path = station.url.partition(str(station.port))[2]
        status, head, _ = ask(station, path)
        assert status == 303
        assert ask(station, Cookie=head["Set-Cookie"].partition(";")[0])[
            0] == 200

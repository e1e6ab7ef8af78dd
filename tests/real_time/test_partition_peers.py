# SPDX-License-Identifier: Apache-2.0
"""LNK-2: the partitions beside another implementation of the other end."""

import socket
import time

from conftest import (
    COMMANDS, HOLDS_MS, SAFE_COMMANDS, SENSORS, SERVOS, TIME_LIMIT_S,
    assert_in_order, different_rows, flies_again, free_ports, in_turn, need,
    script, script_seconds, udp,
)
from peer import UPLINK, AircraftPeer, GroundPeer


def complete(found, expected):
    """Nothing but what is expected, in its order. Is it all, but for the
    first and the last?"""
    assert_in_order(in_turn(found), expected)
    return set(expected[2:-2]) <= set(found)


def commands_with_a_ground(start, write, hold_ms):
    sent = different_rows(16, len(COMMANDS), 3)
    measured = different_rows(16, len(SENSORS), 4)
    sensors = write("sensors.csv", script(SENSORS, measured, hold_ms))
    own, other = free_ports(2)
    run = start(
        "mcs", udp(own, other), "--sensors", sensors,
        "--seconds", script_seconds(measured, hold_ms),
    )
    blocks = [(*row, 0) for row in sent]
    with GroundPeer(other, own, blocks, hold_s=hold_ms / 1000) as ground:
        mcs = run.end()

    # The node may have been switched off in the midst of a message.
    need(ground.bad <= 1, mcs)
    up = complete(mcs.words("mcs.uplink", COMMANDS),
                  [(0,) * 13, SAFE_COMMANDS, *sent])
    down = complete([words[:-1] for words in ground.received],
                    [(0x800,) * 27, *measured])
    if not (up and down):
        return False, mcs
    need(mcs.words("pwm", SERVOS)[-1][7] == sent[-1][3], mcs)
    return True, mcs


def need_one_of(fly, start, write):
    """A complete flight, with one of the times for which words are held."""
    for hold_ms in HOLDS_MS:
        is_complete, flown = fly(start, write, hold_ms)
        if is_complete:
            return
    need(False, flown)


@flies_again
def test_lnk2_the_aircraft_answers_another_ground(start, write):
    need_one_of(commands_with_a_ground, start, write)


def downlinks_of_an_aircraft(start, write, hold_ms):
    moved = different_rows(16, len(COMMANDS), 5)
    measured = different_rows(16, len(SENSORS), 6)
    sticks = write("sticks.csv", script(COMMANDS, moved, hold_ms))
    own, other = free_ports(2)
    blocks = [(*row, 0) for row in measured]
    with AircraftPeer(other, own, blocks, hold_s=hold_ms / 1000) as aircraft:
        gsc = start(
            "gsc", udp(own, other), "--sticks", sticks,
            "--seconds", script_seconds(moved, hold_ms),
        ).end()

    need(aircraft.bad <= 1, gsc)
    neutral = (0x800,) * 5 + (0,) * 8
    down = complete(gsc.words("gsc.downlink", SENSORS),
                    [(0,) * 27, (0x800,) * 27, *measured])
    up = complete([words[:-1] for words in aircraft.received],
                  [SAFE_COMMANDS, neutral, *moved])
    return down and up, gsc


@flies_again
def test_lnk2_the_ground_commands_another_aircraft(start, write):
    need_one_of(downlinks_of_an_aircraft, start, write)


@flies_again
def test_lnk9_a_node_alone_waits_and_is_there_when_the_other_comes(start):
    """The ground calls, and nobody answers: it calls on, gives nothing up
    but blocks, and has the aircraft as soon as there is one."""
    own, other = free_ports(2)
    words = tuple(range(100, 127)) + (0,)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as deaf:
        deaf.bind(("127.0.0.1", other))
        deaf.settimeout(TIME_LIMIT_S)
        run = start("gsc", udp(own, other))
        heard = b""
        while heard.count(UPLINK) < 40:
            heard += deaf.recv(4096)
    alone_until = time.monotonic() * 1e6
    with AircraftPeer(other, own, [words]) as aircraft:
        aircraft.await_received(20)
        aircraft.await_answered(20)
    gsc = run.stop()

    # While it was alone every block was given up, after two attempts.
    rows = [row for row in gsc.rows if row["clock_us"] < alone_until]
    alone = rows[-1]
    given_up = alone["link.uplink_scrapped"]
    assert alone["link.uplink_sent"] >= 2 * given_up
    need(alone["link.uplink_sent"] >= 20
         and alone["link.uplink_sent"] - 2 * given_up <= 2
         and alone["link.gsc_resets"] >= alone["link.uplink_sent"] - 1, gsc)
    assert words[:-1] not in gsc.words("gsc.downlink", SENSORS)[:len(rows)]

    # And then the aircraft had them, and the ground its words.
    need(gsc.words("gsc.downlink", SENSORS)[-1] == words[:-1], gsc)

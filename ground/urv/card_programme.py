# SPDX-License-Identifier: Apache-2.0
"""A flight that runs test cards one after the other (FTI-7, D-97).

The scripts of a simulated pilot for bin/urv_sim: trimmed flight with hands off,
the card, rest, recovery by the control laws, and the next card. Each card is
chosen before its run, so that one that ended early delays no other.
"""

from __future__ import annotations

from typing import NamedTuple

from urv import cards

ORDERS_FROM_S, BETWEEN_S = 2.0, 0.2
TRIM_S = 4.0
"""Hands off before a card, with the law whose command it moves, else with no
law."""
BEYOND_S = 0.5
"""Switch 5 stays on for this time after the card."""
REST_S = 4.5
"""Hands off after a card: its motion decays."""
RECOVERY_S = 8.0
"""Wings level, altitude and airspeed by the laws."""

NEUTRAL, ON, OFF = 2_048, 4_095, 0
ATTITUDE, ALTITUDE, LEVEL, CARD = "switch2", "switch3", "switch4", "switch5"
COLUMNS = ("roll", "pitch", "yaw", "throttle", ATTITUDE, ALTITUDE, LEVEL, CARD)


class Programme(NamedTuple):
    """The texts of the files, and the flight's length."""

    sticks: str
    orders: str
    seconds: float


def of(deck: list[cards.Card]) -> Programme:
    """The programme of these cards, in their order."""
    orders = [card.order(_ms(ORDERS_FROM_S + place * BETWEEN_S))
              for place, card in enumerate(deck)]
    rows = [_row(0.0, *laws_of(deck[0]))]
    now = ORDERS_FROM_S + len(deck) * BETWEEN_S
    for place, card in enumerate(deck):
        laws = laws_of(card)
        following = laws_of(deck[min(place + 1, len(deck) - 1)])
        orders.append(cards.Card(slot=card.slot, kind="choose").order(
            _ms(now + 1.0)))
        now += TRIM_S
        rows.append(_row(now, CARD, *laws))
        now += card.seconds + BEYOND_S
        rows.append(_row(now, *laws))
        now += REST_S
        rows.append(_row(now, ALTITUDE, LEVEL))
        now += RECOVERY_S
        rows.append(_row(now, *following))
    return Programme(
        f"time_ms,{','.join(COLUMNS)}\n" + "".join(rows),
        "".join(f"{order}\n" for order in orders), round(now + 1.0, 2))


def laws_of(card: cards.Card) -> tuple[str, ...]:
    """The switches of the laws whose commands the card moves."""
    if card.place != "command":
        return ()
    return ((ALTITUDE,) if {"altitude", "airspeed"} & set(card.surfaces)
            else (ATTITUDE,))


def _ms(seconds: float) -> int:
    return round(seconds * 1_000)


def _row(seconds: float, *switches: str) -> str:
    words = (NEUTRAL if not each.startswith("switch")
             else ON if each in switches else OFF for each in COLUMNS)
    return f"{_ms(seconds)},{','.join(map(str, words))}\n"

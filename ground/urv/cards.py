# SPDX-License-Identifier: Apache-2.0
"""Test cards: their file, the aircraft's words, and their signals (FTI-7).

    for card in cards.read("cards.toml"):
        card.words()        the twelve words of its block after the kind
        card.signals()      degrees by surface and frame, as the aircraft adds

The file is TOML, a table [[card]] for each card: docs/flight-test.md.
"""

from __future__ import annotations

import math
import tomllib
from dataclasses import dataclass, field
from pathlib import Path

from urv import faults, input_files, packets

KIND = 0x500
FRAMES_PER_S = round(1 / packets.FRAME_S)
SLOTS = range(1, 9)
SURFACES = ("left_aileron", "right_aileron", "left_elevator",
            "right_elevator", "left_rudder", "right_rudder")
AXES = {"roll": SURFACES[:2], "pitch": SURFACES[2:4], "yaw": SURFACES[4:]}
PLACES = {
    "servo": dict(zip(SURFACES, range(6), strict=True)),
    "stick": {"roll": 0, "pitch": 2, "yaw": 4},
    "command": {"bank": 0, "pitch": 2, "altitude": 4, "airspeed": 5}}
"""The inputs that each place has, with their bits: URV.Test_Cards."""
PLACE_BITS = 6
DEGREES = {"aileron": 0.01, "elevator": 0.0125, "rudder": 0.0125}
"""Degrees of a word."""
UNITS = {"servo": dict.fromkeys(SURFACES, "deg"),
         "stick": dict.fromkeys(PLACES["stick"], "%"),
         "command": {"bank": "deg", "pitch": "deg", "altitude": "ft",
                     "airspeed": "kt"}}
SIZES = {"%": 100 / 2_048, "deg": 0.02, "ft": 0.5, "kt": 1 / 32}
"""The size of a word at the sticks and at the commands, by its unit."""
AMPLITUDES = {"%": "amplitude_percent", "deg": "amplitude_deg",
              "ft": "amplitude_ft", "kt": "amplitude_kt"}
KINDS = ("empty", "step", "doublet", "3-2-1-1", "linear sweep",
         "exponential sweep", "multisine", "choose")
PULSES = {"step": 1, "doublet": 2, "3-2-1-1": 7}
"""The number of pulses that a whole input is long."""

MOST_AMPLITUDE = 800
MOST_FREQUENCY = 1_000
MOST_BASE = 200
MOST_OCTAVES = 448
MOST_SIGNALS = 4
MOST_SINES = 12
NO_LIMIT = 63
FIELD = 4_095

RATES = (7_500, 7_500, 7_500, 7_500, 5_000, 5_000)
"""The rate limits of inputs by their bits, in words a second: URV.Law_Gains."""


def family(surface):
    return surface.split("_")[1]


@dataclass(frozen=True)
class Card:
    """A card in the words of its block; see URV.Test_Cards.Card_Item. The
    surfaces are sticks or commands at other places."""

    slot: int
    kind: str
    surfaces: tuple[str, ...] = ()
    is_single: bool = False
    amplitude: int = 0
    time: int = 0
    first: int = 0
    last: int = 0
    bank: int = NO_LIMIT
    pitch: int = NO_LIMIT
    alpha: int = NO_LIMIT
    load: int = NO_LIMIT
    slowest: int = 0
    fastest: int = FIELD
    lowest: int = 0
    place: str = "servo"
    name: str = field(default="", compare=False)

    @property
    def is_signal(self):
        return self.kind not in ("empty", "choose")

    def words(self):
        """The words of the block after its kind."""
        head = (self.slot * 256 + self.is_single * 16
                + KINDS.index(self.kind))
        card = (head, *(0,) * 10) if not self.is_signal else (
            head,
            sum(1 << PLACES[self.place][each] for each in self.surfaces)
            + ([*PLACES].index(self.place) << PLACE_BITS),
            self.amplitude, self.time, self.first, self.last,
            self.bank + 64 * self.pitch, self.alpha + 64 * self.load,
            self.slowest, self.fastest, self.lowest)
        weights = range(1, 2 * len(card), 2)
        return (*card, sum(map(lambda one, two: one * two, weights, card))
                % (FIELD + 1))

    def order(self, time_ms):
        """The line of an orders file."""
        return f"{time_ms} block {KIND:x} {' '.join(map(str, self.words()))}"

    @classmethod
    def of_words(cls, words):
        """The card of the first eleven words of its block; None if its slot
        is empty."""
        head, bits, amplitude, time, first, last, attitude, airflow, *rest = (
            words)
        kind = head % 16
        if not head // 256 or not 0 < kind < len(KINDS) - 1 or (
                bits >> PLACE_BITS >= len(PLACES)):
            return None
        place = [*PLACES][bits >> PLACE_BITS]
        return cls(head // 256, KINDS[kind],
                   tuple(each for each, bit in PLACES[place].items()
                         if bits >> bit & 1),
                   bool(head // 16 % 16), amplitude, time, first, last,
                   attitude % 64, attitude // 64, airflow % 64, airflow // 64,
                   *rest, place=place)

    @property
    def seconds(self):
        """Length of the whole input."""
        return self.length / FRAMES_PER_S

    def envelope(self):
        """Its limits as text, for people."""
        return ", ".join(text for text, is_set in (
            (f"bank {self.bank} deg", self.bank != NO_LIMIT),
            (f"pitch {self.pitch} deg", self.pitch != NO_LIMIT),
            (f"alpha {self.alpha} deg", self.alpha != NO_LIMIT),
            (f"load 1 +- {self.load / 10:g} g", self.load != NO_LIMIT),
            (f"airspeed from {self.slowest / 32:g} kt", self.slowest != 0),
            (f"airspeed to {self.fastest / 32:g} kt", self.fastest != FIELD),
            (f"altitude from {self.lowest / 2:g} ft", self.lowest != 0))
            if is_set) or "none"

    @property
    def frames(self):
        """Length of a pulse, or of the whole input."""
        return self.time * FRAMES_PER_S // 100

    @property
    def length(self):
        """Frames of the whole input."""
        return PULSES.get(self.kind, 1) * self.frames

    def signal_numbers(self):
        """The signal of each surface in a multisine, from 0."""
        if self.is_single:
            return {each: place for place, each in enumerate(self.surfaces)}
        pairs = [pair for pair in AXES.values()
                 if set(pair) & set(self.surfaces)]
        return {each: place for place, pair in enumerate(pairs)
                for each in pair if each in self.surfaces}

    def harmonics(self, surface):
        """The harmonics of a surface's signal."""
        numbers = self.signal_numbers()
        step = max(numbers.values()) + 1
        return [self.last // 16 + numbers[surface] + step * place
                for place in range(self.last % 16)]

    def words_added(self):
        """Words by surface and frame, until the input is back at 0."""
        # numpy takes time to load, and the station needs no signals.
        from urv import card_signals
        return card_signals.words_added(self)

    def unit(self, surface):
        """Unit of an input's amplitude."""
        return UNITS[self.place][surface]

    def rate(self, surface):
        """The rate limit of an input, in words a second."""
        return RATES[PLACES[self.place][surface]]

    def signals(self):
        """By surface and frame, in the unit of each."""
        return {each: values * (
                    DEGREES[family(each)] if self.place == "servo"
                    else SIZES[self.unit(each)])
                for each, values in self.words_added().items()}

    def frequencies(self):
        """By frame, in parts of 0.01 Hz."""
        from urv import card_signals
        return card_signals.frequencies(self)


#  The file

KEYS = {"slot", "name", "kind", "added_to", "moves", *AMPLITUDES.values(),
        "pulse_s", "length_s", "first_hz", "last_hz", "base_hz", "first_harmonic",
        "harmonics", "bank_deg", "pitch_deg", "alpha_deg", "load_g",
        "slowest_kt", "fastest_kt", "lowest_ft"}


def read(path: Path) -> list[Card]:
    """The cards of a file, in its order. Raises faults.Refused."""
    where = faults.quoted(path)[1:-1]
    try:
        with input_files.opened_typed(path) as file:
            text = file.read()
    except UnicodeDecodeError as fault:
        raise faults.Refused(f"{where}: no TOML: {fault}") from fault
    return of_text(text, where)


def of_text(text: str, where: str) -> list[Card]:
    """The cards of a file's text. Raises faults.Refused."""
    try:
        given = tomllib.loads(text)
    except RecursionError as fault:
        raise faults.Refused(f"{where}: nested too deeply") from fault
    except ValueError as fault:
        # A number of thousands of digits is no TOMLDecodeError.
        raise faults.Refused(f"{where}: no TOML: {fault}") from fault
    tables = given.pop("card", None)
    if given or not isinstance(tables, list) or not tables:
        raise faults.Refused(
            f"{where}: a card begins with the line [[card]]; there is nothing"
            " else")
    if len(tables) > len(SLOTS):
        raise faults.Refused(f"{where}: there may be {len(SLOTS)} cards")
    cards = [_Reader(f"{where}: card {place}", table, place).card()
             for place, table in enumerate(tables, 1)]
    slots = [card.slot for card in cards]
    for place, slot in enumerate(slots):
        if slot in slots[:place]:
            raise faults.Refused(
                f"{where}: card {place + 1}: slot {slot} is taken")
    return cards


class _Reader:
    """One table of the file."""

    def __init__(self, where, table, place):
        self.where = where
        self.table = table
        self.place = place
        if not isinstance(table, dict):
            raise faults.Refused(f"{where}: it is no table")
        for key in table:
            if key not in KEYS:
                raise faults.Refused(
                    f"{where}: unknown {faults.quoted(key)}; there are"
                    f" {', '.join(sorted(KEYS))}")

    def number(self, key, least, most, factor, default=None):
        """A number as a word: its value times the factor, rounded."""
        value = self.table.get(key, default)
        if value is default and default is not None:
            return default
        if isinstance(value, bool) or not isinstance(value, (int, float)) or (
                not least <= value <= most):
            raise faults.Refused(
                f"{self.where}: {key} is a number from {least:g} to"
                f" {most:g}")
        return round(value * factor)

    def surfaces(self):
        """The place of the inputs, the surfaces, sticks or commands that move,
        and whether each has its own signal."""
        place = self.table.get("added_to", "servo")
        if not isinstance(place, str) or place not in PLACES:
            raise faults.Refused(
                f"{self.where}: added_to is one of {', '.join(PLACES)}")
        moves = self.table.get("moves")
        names = (*AXES, *SURFACES) if place == "servo" else PLACES[place]
        if not isinstance(moves, list) or not moves or any(
                not isinstance(each, str) or each not in names
                for each in moves):
            raise faults.Refused(
                f"{self.where}: moves is a list of {', '.join(names)}"
                + ("" if place == "servo"
                   else f", for inputs that are added to a {place}"))
        if place != "servo":
            return place, tuple(
                each for each in PLACES[place] if each in moves), True
        are_axes = [each in AXES for each in moves]
        if any(are_axes) and not all(are_axes):
            raise faults.Refused(
                f"{self.where}: moves has axes or surfaces, not both")
        chosen = {each for move in moves for each in AXES.get(move, (move,))}
        return place, tuple(
            each for each in SURFACES if each in chosen), not any(are_axes)

    def amplitude(self, place, surfaces):
        """In words."""
        units = {UNITS[place][each] for each in surfaces}
        if len(units) > 1:
            raise faults.Refused(
                f"{self.where}: {', '.join(surfaces)} have different units; a"
                " card has one amplitude")
        unit = units.pop()
        for other, key in AMPLITUDES.items():
            if other != unit and key in self.table:
                raise faults.Refused(
                    f"{self.where}: {key} is not for {', '.join(surfaces)},"
                    f" {AMPLITUDES[unit]} is")
        if place == "servo":
            sizes = {DEGREES[family(each)] for each in surfaces}
            size = sizes.pop() if len(sizes) == 1 else 0.0125
        else:
            size = SIZES[unit]
        return self.number(AMPLITUDES[unit], size, MOST_AMPLITUDE * size,
                           1 / size)

    def card(self):
        kind = self.table.get("kind")
        kinds = KINDS[1:-1]
        if kind not in kinds:
            raise faults.Refused(
                f"{self.where}: kind is one of {', '.join(kinds)}")
        name = self.table.get("name", "")
        if not isinstance(name, str):
            raise faults.Refused(f"{self.where}: name is a text")
        place, surfaces, is_single = self.surfaces()
        is_sines = kind == "multisine"
        time, first, last = self.signal(kind)
        card = Card(
            slot=self.number("slot", 1, 8, 1, self.place),
            kind=kind, surfaces=surfaces, is_single=is_sines and is_single,
            amplitude=self.amplitude(place, surfaces),
            time=time, first=first, last=last,
            bank=self.number("bank_deg", 1, 62, 1, NO_LIMIT),
            pitch=self.number("pitch_deg", 1, 62, 1, NO_LIMIT),
            alpha=self.number("alpha_deg", 1, 62, 1, NO_LIMIT),
            load=self.number("load_g", 0.1, 6.2, 10, NO_LIMIT),
            slowest=self.number("slowest_kt", 0, 127.9, 32, 0),
            fastest=self.number("fastest_kt", 0, 127.9, 32, FIELD),
            lowest=self.number("lowest_ft", 0, 2_047, 2, 0),
            place=place, name=name)
        if card.slowest > card.fastest:
            raise faults.Refused(
                f"{self.where}: slowest_kt is above fastest_kt")
        if is_sines:
            self.check_sines(card)
        return card

    def signal(self, kind):
        """The words of time and frequencies."""
        if kind in PULSES:
            return self.number("pulse_s", 0.02, 40.95, 100), 0, 0
        time = self.number("length_s", 0.02, 40.95, 100)
        if kind == "multisine":
            first = self.number("first_harmonic", 1, 255, 1)
            count = self.number("harmonics", 1, MOST_SINES, 1)
            return (time, self.number("base_hz", 0.01, MOST_BASE / 100, 100),
                    first * 16 + count)
        first = self.number("first_hz", 0.1, MOST_FREQUENCY / 100, 100)
        last = self.number("last_hz", 0.1, MOST_FREQUENCY / 100, 100)
        if kind == "linear sweep":
            return time, first, last
        octaves = round(64 * math.log2(last / first))
        if not 1 <= octaves <= MOST_OCTAVES:
            raise faults.Refused(
                f"{self.where}: last_hz of an exponential sweep is above"
                " first_hz")
        return time, first, octaves

    def check_sines(self, card):
        signals = max(card.signal_numbers().values()) + 1
        if signals > MOST_SIGNALS:
            raise faults.Refused(
                f"{self.where}: a multisine moves at most {MOST_SIGNALS}"
                " axes or surfaces")
        highest = card.first * max(card.harmonics(card.surfaces[-1]))
        if highest > MOST_FREQUENCY:
            raise faults.Refused(
                f"{self.where}: its highest harmonic is"
                f" {highest / 100:g} Hz, not {MOST_FREQUENCY / 100:g} Hz or"
                " less")

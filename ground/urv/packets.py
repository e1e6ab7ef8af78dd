# SPDX-License-Identifier: Apache-2.0
"""The packets between the ground's node and the station (GND-1, GND-57).

docs/station-packets.md has their layouts. urv_gsc sends a frame packet to the
station each major frame; the station sends console packets and order packets
to urv_gsc. Any other datagram raises PacketError with the reason.
"""

from __future__ import annotations

import struct
from dataclasses import dataclass
from enum import IntEnum, IntFlag
from operator import add
from typing import ClassVar

from urv import items
from urv.tables import TABLES

FRAME_US = TABLES["frame_us"]
"""A major frame of the nodes."""
FRAME_S = FRAME_US / 1e6

VERSION = 1
"""The version of a console packet, and of a frame packet with a part of the
logs."""
WHOLE = 2
"""The version of a frame packet with the whole logs."""
FRAMED = 3
"""The version that also has the frame of the downlink."""
LATEST_US = 253_402_300_799_999_999
"""The largest time of a packet: the end of the year 9999."""
NEVER = 0xFFFF_FFFF
"""The age of a downlink before the first one."""

COLUMNS = tuple(
    column for column in items.COLUMNS
    if column.startswith(("console.", "gsc.")))
"""The words of a frame packet, with their names and order in the record."""

COMMANDS = tuple(item.name for item in items.of_group("console"))

FRAME_WORDS = tuple(TABLES["frame_words"])
"""The words of a downlink's frame: its number, the running card and its phase,
and servo words (FTI-12)."""
FRAME_NUMBERS = TABLES["frame_numbers"]
"""The number of a frame is modulo this."""
UNKNOWN_WORD = TABLES["unknown_word"]
"""A word of the frame that has not come."""

LINK_COUNTS = tuple(TABLES["link_counts"])
STATUS = tuple(TABLES["status"])
NODES = ("gsc", "mcs")
KINDS = tuple(TABLES["error_kinds"])
"""The kinds of errors, in the order of their rows."""

ROWS_PER_LOG = TABLES["log_rows"]
FIRST_ROWS = TABLES["log_rows_of_version_1"]
"""The rows of a log in version 1; the others come last."""
LAWS_ROW = TABLES["laws_row"]
CARDS_ROW = LAWS_ROW - 1
"""That of the test cards' status."""
"""A row of the aircraft's log: the status of its control laws."""

_FRAME_MAGIC = int.from_bytes(b"URVF")
_FRAME_HEAD = struct.Struct(">IHHIIQIHHI")
_COUNTS = struct.Struct(f">{len(LINK_COUNTS)}I")
_WORDS = struct.Struct(f">{len(COLUMNS)}H")
_ROW = struct.Struct(">IIIH")
_TAIL = struct.Struct(f">{len(STATUS)}HH")
_COUNTS_AT = _FRAME_HEAD.size
WORDS_AT = _COUNTS_AT + _COUNTS.size
LOGS_AT = WORDS_AT + _WORDS.size
ROW_LENGTH = _ROW.size
TAIL_AT = LOGS_AT + len(NODES) * FIRST_ROWS * ROW_LENGTH
MORE_AT = TAIL_AT + _TAIL.size
FRAME_AT = MORE_AT + len(NODES) * (ROWS_PER_LOG - FIRST_ROWS) * ROW_LENGTH
_DOWNLINK_FRAME = struct.Struct(f">{len(FRAME_WORDS)}H")
FRAME_LENGTH = FRAME_AT + _DOWNLINK_FRAME.size
LENGTHS = {VERSION: MORE_AT, WHOLE: FRAME_AT, FRAMED: FRAME_LENGTH}
"""The length of a frame packet of each version."""
if LENGTHS != {version: TABLES[f"length_of_version_{version}"]
               for version in LENGTHS}:
    raise AssertionError(f"packets have {LENGTHS} bytes here, others in the"
                         " nodes")


def row_at(node: str, row: int) -> int:
    """The place of the row of the node's log in the packet, from 1."""
    first, begin, rows = (
        (1, LOGS_AT, FIRST_ROWS) if row <= FIRST_ROWS else
        (FIRST_ROWS + 1, MORE_AT, ROWS_PER_LOG - FIRST_ROWS))
    return begin + (NODES.index(node) * rows + row - first) * ROW_LENGTH


_CONSOLE_MAGIC = int.from_bytes(b"URVC")
_CONSOLE = struct.Struct(f">IHHIIQ{len(COMMANDS)}HH")
CONSOLE_LENGTH = _CONSOLE.size


LARGEST_SERIAL = 0xFFF
"""The largest number of a configuration; the first is 1."""
CONFIGURATION = 0x400
"""The kind of block that an order packet requests."""
_ORDER_MAGIC = int.from_bytes(b"URVO")
_ORDER = struct.Struct(">IHHIIQ5H")
ORDER_LENGTH = _ORDER.size
CARD = 0x500
"""The same, for a test card."""
CARD_WORDS = 12
REQUEST = 0x700
"""The same, for rows of the flight recorder."""
_CARD = struct.Struct(f">IHHIIQ{1 + CARD_WORDS}H")
CARD_LENGTH = _CARD.size
_RECORDER_MAGIC = int.from_bytes(b"URVR")
RECORDER_KINDS = (0x700, 0x800)
RECORDER_WORDS = 27
_RECORDER = struct.Struct(f">IHHH{RECORDER_WORDS}H")
RECORDER_LENGTH = _RECORDER.size


class PacketError(ValueError):
    """These bytes are not such a packet, or such a packet cannot exist."""


class ConsoleState(IntEnum):
    """The source of the words at the converter."""

    NONE = 0
    LIVE = 1
    HELD = 2
    NEUTRAL = 3


class LinkState(IntEnum):
    """The state of the aircraft's node."""

    NEVER_HEARD = 0
    HEARD = 1
    LOST = 2


class Pilot(IntEnum):
    """The state of the simulated pilot."""

    NONE = 0
    HANDS_OFF = 1
    FLIES = 2


class ConsoleFlags(IntFlag):
    """The requests of a console packet."""

    PILOT_FLIES = 1


@dataclass(frozen=True)
class LogRow:
    """A row of a node's error log."""

    count: int = 0
    first_frame: int = 0
    last_frame: int = 0
    detail: int = 0


@dataclass(frozen=True)
class Event:
    """A kind of error that has occurred, with its row of the log."""

    node: str
    kind: str
    row: LogRow


@dataclass(frozen=True)
class FramePacket:
    """The contents of GSC CORE at the end of a major frame."""

    run: int
    sequence: int
    time_us: int
    downlink_age: int
    console_state: ConsoleState
    link_state: LinkState
    console_sequence: int
    counts: tuple[int, ...]
    words: tuple[int, ...]
    logs: tuple[tuple[LogRow, ...], ...]
    status: tuple[int, ...]
    pilot: Pilot
    version: int = WHOLE
    downlink_frame: tuple[int, ...] = (UNKNOWN_WORD,) * len(FRAME_WORDS)

    @property
    def frame_words(self) -> dict[str, int | None]:
        """The words of the downlink's frame by name, None without one."""
        return {name: None if word == UNKNOWN_WORD else word
                for name, word in zip(FRAME_WORDS, self.downlink_frame,
                                      strict=True)}

    @property
    def columns(self) -> dict[str, int]:
        """The words by their column of the record."""
        return dict(zip(COLUMNS, self.words, strict=True))

    @property
    def link(self) -> dict[str, int]:
        """The link counts by name."""
        return dict(zip(LINK_COUNTS, self.counts, strict=True))

    @property
    def core_status(self) -> dict[str, int]:
        """The words of CORE's status area by name."""
        return dict(zip(STATUS, self.status, strict=True))

    @property
    def is_fresh(self) -> bool:
        """True if the words of the downlink are of this frame."""
        return self.downlink_age == 0

    @property
    def events(self) -> list[Event]:
        """The errors so far, the ground's log first."""
        return [Event(node, kind, row)
                for node, log in zip(NODES, self.logs, strict=True)
                for kind, row in zip(KINDS, log)  # noqa: B905 - rows to spare
                if row.count > 0]

    def encode(self) -> bytes:
        """The datagram."""
        if (len(self.logs) != len(NODES)
                or any(len(log) != ROWS_PER_LOG for log in self.logs)):
            raise PacketError(
                f"frame packet: logs are {len(NODES)} of "
                f"{ROWS_PER_LOG} rows")
        length = LENGTHS[self.version]
        try:
            first, more = (
                [_ROW.pack(row.count, row.first_frame, row.last_frame,
                           row.detail)
                 for log in self.logs for row in log[rows]]
                for rows in (slice(FIRST_ROWS), slice(FIRST_ROWS, None)))
            return b"".join((
                _FRAME_HEAD.pack(
                    _FRAME_MAGIC, self.version, length, self.run,
                    self.sequence, self.time_us, self.downlink_age,
                    self.console_state, self.link_state,
                    self.console_sequence),
                _COUNTS.pack(*self.counts),
                _WORDS.pack(*self.words),
                *first,
                _TAIL.pack(*self.status, self.pilot),
                *more,
                _DOWNLINK_FRAME.pack(*self.downlink_frame)))[:length]
        except struct.error as error:
            raise PacketError(f"frame packet: {error}") from error

    @classmethod
    def decode(cls, data: bytes) -> FramePacket:
        """The packet in a datagram."""
        version = _check("frame packet", data, _FRAME_MAGIC, LENGTHS)
        (_, _, _, run, sequence, time_us, age, console_state, link_state,
         console_sequence) = _FRAME_HEAD.unpack_from(data)
        if time_us > LATEST_US:
            raise PacketError(
                f"frame packet: time is {time_us}, not 0 to {LATEST_US}")
        # Rows that version 1 lacks are zero, as without an occurrence.
        more = data[MORE_AT:FRAME_AT].ljust(FRAME_AT - MORE_AT, b"\0")
        *status, pilot = _TAIL.unpack_from(data, TAIL_AT)
        return cls(
            run=run,
            sequence=sequence,
            time_us=time_us,
            downlink_age=age,
            console_state=_member(ConsoleState, console_state),
            link_state=_member(LinkState, link_state),
            console_sequence=console_sequence,
            counts=_COUNTS.unpack_from(data, _COUNTS_AT),
            words=_WORDS.unpack_from(data, WORDS_AT),
            logs=tuple(map(add, _logs(data[LOGS_AT:TAIL_AT]), _logs(more))),
            status=tuple(status),
            pilot=_member(Pilot, pilot),
            version=version,
            **({"downlink_frame": _DOWNLINK_FRAME.unpack_from(data, FRAME_AT)}
               if version == FRAMED else {}))


def _logs(data: bytes) -> list[tuple[LogRow, ...]]:
    """The existing rows of each node's log."""
    rows = [LogRow(*values) for values in _ROW.iter_unpack(data)]
    each = len(rows) // len(NODES)
    return [tuple(rows[first:first + each])
            for first in range(0, len(rows), each)]


@dataclass(frozen=True)
class ConsolePacket:
    """The pilot's sticks and switches."""

    run: int
    sequence: int
    time_us: int
    words: tuple[int, ...]
    flags: ConsoleFlags = ConsoleFlags(0)

    @property
    def columns(self) -> dict[str, int]:
        """The words by their column of the record, the first ones of all."""
        return dict(zip(COLUMNS, self.words, strict=False))

    def encode(self) -> bytes:
        """The datagram."""
        self._check_words()
        try:
            return _CONSOLE.pack(
                _CONSOLE_MAGIC, VERSION, CONSOLE_LENGTH, self.run,
                self.sequence, self.time_us, *self.words, self.flags)
        except struct.error as error:
            raise PacketError(f"console packet: {error}") from error

    @classmethod
    def decode(cls, data: bytes) -> ConsolePacket:
        """The packet in a datagram."""
        _check("console packet", data, _CONSOLE_MAGIC,
               {VERSION: CONSOLE_LENGTH})
        (_, _, _, run, sequence, time_us, *words, flags) = (
            _CONSOLE.unpack(data))
        if flags & ~int(ConsoleFlags.PILOT_FLIES):
            raise PacketError(f"console packet: unknown flags {flags:04x}h")
        packet = cls(run, sequence, time_us, tuple(words),
                     ConsoleFlags(flags))
        packet._check_words()
        return packet

    def _check_words(self) -> None:
        if len(self.words) != len(COMMANDS):
            raise PacketError(
                f"console packet: {len(self.words)} words, not "
                f"{len(COMMANDS)}")
        for name, word in zip(COMMANDS, self.words, strict=True):
            if not 0 <= word <= items.LARGEST_WORD:
                raise PacketError(
                    f"console packet: {name} is {word}, not 0 to "
                    f"{items.LARGEST_WORD}")


@dataclass(frozen=True)
class OrderPacket:
    """A configuration ordered by the station. Times are in tenths of a
    second."""

    run: int
    sequence: int
    time_us: int
    serial: int
    table: int
    orbit: int
    end: int

    def encode(self) -> bytes:
        """The datagram."""
        self._check_items()
        try:
            return _ORDER.pack(
                _ORDER_MAGIC, VERSION, ORDER_LENGTH, self.run, self.sequence,
                self.time_us, CONFIGURATION, self.serial, self.table,
                self.orbit, self.end)
        except struct.error as error:
            raise PacketError(f"order packet: {error}") from error

    @classmethod
    def decode(cls, data: bytes) -> OrderPacket:
        """The packet in a datagram."""
        _check("order packet", data, _ORDER_MAGIC, {VERSION: ORDER_LENGTH})
        _, _, _, run, sequence, time_us, kind, *values = _ORDER.unpack(data)
        if kind != CONFIGURATION:
            raise PacketError(f"order packet: kind {kind:04x}h, not "
                              f"{CONFIGURATION:04x}h")
        packet = cls(run, sequence, time_us, *values)
        packet._check_items()
        return packet

    def _check_items(self) -> None:
        for name in ("serial", "table", "orbit", "end"):
            value, least = getattr(self, name), name == "serial"
            if not least <= value <= LARGEST_SERIAL:
                raise PacketError(
                    f"order packet: {name} is {value}, not {int(least)} to "
                    f"{LARGEST_SERIAL}")


@dataclass(frozen=True)
class CardPacket:
    """A test card ordered by the station: the words of its block after the
    kind."""

    KIND: ClassVar[int] = CARD

    run: int
    sequence: int
    time_us: int
    words: tuple[int, ...]

    def encode(self) -> bytes:
        """The datagram."""
        self._check_words()
        try:
            return _CARD.pack(
                _ORDER_MAGIC, VERSION, CARD_LENGTH, self.run, self.sequence,
                self.time_us, self.KIND, *self.words)
        except struct.error as error:
            raise PacketError(f"card packet: {error}") from error

    @classmethod
    def decode(cls, data: bytes) -> CardPacket:
        """The packet in a datagram."""
        _check("card packet", data, _ORDER_MAGIC, {VERSION: CARD_LENGTH})
        _, _, _, run, sequence, time_us, kind, *words = _CARD.unpack(data)
        if kind != cls.KIND:
            raise PacketError(f"card packet: kind {kind:04x}h, not"
                              f" {cls.KIND:04x}h")
        packet = cls(run, sequence, time_us, tuple(words))
        packet._check_words()
        return packet

    def _check_words(self) -> None:
        if len(self.words) != CARD_WORDS or not all(
                0 <= word <= LARGEST_SERIAL for word in self.words):
            raise PacketError(f"card packet: there are {CARD_WORDS} words, 0"
                              f" to {LARGEST_SERIAL}")


class RequestPacket(CardPacket):
    """A request for rows of the flight recorder, in the same layout."""

    KIND: ClassVar[int] = REQUEST


def decode_recorder(data: bytes) -> tuple[int, tuple[int, ...]]:
    """The kind and the words of a block of the flight recorder."""
    _check("recorder packet", data, _RECORDER_MAGIC,
           {VERSION: RECORDER_LENGTH})
    _, _, _, kind, *words = _RECORDER.unpack(data)
    if kind not in RECORDER_KINDS:
        raise PacketError(f"recorder packet: kind {kind:04x}h, not "
                          + " or ".join(f"{each:04x}h"
                                        for each in RECORDER_KINDS))
    return kind, tuple(words)


def _check(what: str, data: bytes, magic: int,
           lengths: dict[int, int]) -> int:
    """The version of a datagram of this kind; others are refused."""
    if len(data) not in lengths.values():
        raise PacketError(f"{what}: {len(data)} bytes, not "
                          + " or ".join(map(str, lengths.values())))
    found, version, told = struct.unpack_from(">IHH", data)
    if found != magic:
        raise PacketError(f"{what}: it begins with {found:08x}h, not "
                          f"{magic:08x}h")
    if version not in lengths:
        raise PacketError(f"{what}: version {version}, not "
                          + " or ".join(map(str, lengths)))
    if len(data) != lengths[version]:
        raise PacketError(f"{what}: {len(data)} bytes of version {version}, "
                          f"not {lengths[version]}")
    if told != len(data):
        raise PacketError(f"{what}: its length field is {told} bytes, "
                          f"not {len(data)}")
    return version


def _member(kind: type[IntEnum], value: int) -> IntEnum:
    try:
        return kind(value)
    except ValueError as error:
        raise PacketError(
            f"frame packet: {value} is not a {kind.__name__}") from error

# SPDX-License-Identifier: Apache-2.0
"""The status of the aircraft's control laws on the ground (GND-7).

    Laws.of(frame).mode             "bank by stick/altitude/airspeed"
    Laws.of(frame).failed           ("left_aileron",)

The laws have a row of the aircraft's log that is not an error's; it is sent in
turn with the log's other rows. docs/control-laws.md explains its words.
"""

from __future__ import annotations

from dataclasses import dataclass

from urv import items, packets
from urv.tables import TABLES

LATERAL, VERTICAL, POWER, LINK = (
    tuple(TABLES[name]) for name in ("lateral", "vertical", "power", "link"))
"""The flying modes, and the state of the link."""
ALONE = LINK[2:]
"""The link is lost, and the aircraft flies by itself."""

DISCONNECT = f"{items.SWITCHES[6].use} (switch 7)"

SHORT = {"damping": "damp", "bank by stick": "bank", "wings level": "level",
         "pitch by stick": "pitch", "altitude": "alt", "airspeed": "spd"}
"""Short forms for little room."""
DOES = {"holding": "wings level, altitude and airspeed held",
        "orbiting": "a turn to the right, altitude and airspeed held",
        "terminated": f"throttle idle, a glide; {DISCONNECT} off and on ends"
                      " it"}
"""The aircraft's actions while it is alone."""

SENSORS = tuple(
    item.name for item in items.of_buffer("downlink") if item.name != "error")
SURFACES = tuple(TABLES["surfaces"])
"""In the order of their bits, which is that of their servos."""
FAILING = (*SURFACES, "throttle")
"""The items whose failure the aircraft detects: the next bit is the
engine's."""

WORD_BITS = 16
AGE_FRAMES = TABLES["age_frames"]
"""The unit of a node's age, in frames."""
NIBBLE_BITS = 4


@dataclass(frozen=True)
class Laws:
    """The newest received status of the laws."""

    lateral: str
    vertical: str
    power: str
    link: str
    not_valid: tuple[str, ...]
    silent: int
    failed: tuple[str, ...]
    serial: int = 0
    """The number of the last accepted configuration; 0 when there was none."""
    table: int = 0
    """The table of gains in force."""
    age: int = 0
    """The age of the aircraft's node since its cold start, in AGE_FRAMES,
    modulo 65536."""

    @classmethod
    def of(cls, frame: packets.FramePacket) -> Laws | None:
        """None when nothing was received: the laws are off, or have not
        reported yet."""
        row = frame.logs[packets.NODES.index("mcs")][packets.LAWS_ROW - 1]
        if row == packets.LogRow():
            return None
        modes, low = divmod(row.count, 1 << WORD_BITS)
        high, silent = divmod(row.first_frame, 1 << WORD_BITS)
        failed, age = divmod(row.last_frame, 1 << WORD_BITS)
        lateral, vertical, power, link = (
            modes >> NIBBLE_BITS * place & 15 for place in range(4))
        return cls(
            name_of(LATERAL, lateral), name_of(VERTICAL, vertical),
            name_of(POWER, power), name_of(LINK, link),
            _set(SENSORS, low | high << WORD_BITS), silent,
            _set(FAILING, failed), *divmod(row.detail, 1 << NIBBLE_BITS),
            age)

    @property
    def mode(self) -> str:
        """The flying modes: lateral, vertical and power, without the direct
        ones."""
        return mode_name(self.lateral, self.vertical, self.power)

    @property
    def short(self) -> str:
        """The same with shorter words; the reaction to a lost link comes
        first."""
        if self.is_alone:
            return self.link.upper()
        return " ".join(SHORT.get(word, word)
                        for word in self.mode.split("/"))

    @property
    def is_alone(self) -> bool:
        """True if the aircraft flies without the ground."""
        return self.link in ALONE


def mode_name(lateral: str, vertical: str, power: str) -> str:
    """A name for the modes of the axes and the throttle."""
    axes = [lateral] if lateral == vertical else [lateral, vertical]
    return "/".join(axes + ([] if power == "direct" else [power]))


def name_of(names: tuple[str, ...], place: int) -> str:
    """The name at a place; an unknown one is a number."""
    return names[place] if place < len(names) else f"number {place}"


def _set(names: tuple[str, ...], bits: int) -> tuple[str, ...]:
    return tuple(name for bit, name in enumerate(names) if bits >> bit & 1)

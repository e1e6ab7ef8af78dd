# SPDX-License-Identifier: Apache-2.0
"""What the aircraft's control laws tell the ground (GND-7).

    Laws.of(frame).mode             "bank by stick/altitude/airspeed"
    Laws.of(frame).failed           ("left_aileron",)

They have a row of the aircraft's log that is not an error's; it comes down
round and round, as the log does. docs/control-laws.md says what its words
mean.
"""

from __future__ import annotations

from dataclasses import dataclass

from urv import items, packets
from urv.tables import TABLES

LATERAL, VERTICAL, POWER, LINK = (
    tuple(TABLES[name]) for name in ("lateral", "vertical", "power", "link"))
"""What flies, and the state of the link."""
ALONE = LINK[2:]
"""The link is lost, and the aircraft flies by itself."""

DISCONNECT = f"{items.SWITCHES[6].use} (switch 7)"

SHORT = {"damping": "damp", "bank by stick": "bank", "wings level": "level",
         "pitch by stick": "pitch", "altitude": "alt", "airspeed": "spd"}
"""As they stand where there is little room."""
DOES = {"holding": "wings level, altitude and airspeed held",
        "orbiting": "a turn to the right, altitude and airspeed held",
        "terminated": f"throttle idle, a glide; {DISCONNECT} off and on ends"
                      " it"}
"""What the aircraft does while it is alone."""

SENSORS = tuple(
    item.name for item in items.of_buffer("downlink") if item.name != "error")
SURFACES = tuple(TABLES["surfaces"])
"""In the order of their bits, which is that of their servos."""
FAILING = (*SURFACES, "throttle")
"""What the aircraft sees fail: the next bit is the engine's."""

WORD_BITS = 16
AGE_FRAMES = TABLES["age_frames"]
"""The unit of a node's age."""
NIBBLE_BITS = 4


@dataclass(frozen=True)
class Laws:
    """The newest that has come of them."""

    lateral: str
    vertical: str
    power: str
    link: str
    not_valid: tuple[str, ...]
    silent: int
    failed: tuple[str, ...]
    serial: int = 0
    """Of the configuration that was taken last; 0 when none was."""
    table: int = 0
    """The gains that it has set."""
    age: int = 0
    """Of the aircraft's node since its cold start, in AGE_FRAMES, modulo
    65536."""

    @classmethod
    def of(cls, frame: packets.FramePacket) -> Laws | None:
        """None when nothing has come: the laws are off, or do not know of
        anybody yet."""
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
        """What flies: lateral, vertical and power, but for what is direct."""
        return mode_name(self.lateral, self.vertical, self.power)

    @property
    def short(self) -> str:
        """The same with shorter words; what it does alone comes first."""
        if self.is_alone:
            return self.link.upper()
        return " ".join(SHORT.get(word, word)
                        for word in self.mode.split("/"))

    @property
    def is_alone(self) -> bool:
        """Nobody on the ground flies it."""
        return self.link in ALONE


def mode_name(lateral: str, vertical: str, power: str) -> str:
    """Of what flies the axes and the throttle."""
    axes = [lateral] if lateral == vertical else [lateral, vertical]
    return "/".join(axes + ([] if power == "direct" else [power]))


def name_of(names: tuple[str, ...], place: int) -> str:
    """One that this station does not know has its number."""
    return names[place] if place < len(names) else f"number {place}"


def _set(names: tuple[str, ...], bits: int) -> tuple[str, ...]:
    return tuple(name for bit, name in enumerate(names) if bits >> bit & 1)

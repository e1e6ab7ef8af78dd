# SPDX-License-Identifier: Apache-2.0
"""Reports about the programs of a flight: bin/urv ground makes them, prints
them and sends them to the station, a JSON object a line (GND-47)."""

from __future__ import annotations

import asyncio
import json
import re
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

from urv import input_files
from urv.alerts import CAUTION, WARNING

if TYPE_CHECKING:
    from urv.view import View


@dataclass(frozen=True)
class Report:
    """An alert of that key begins, or ends."""

    key: str
    level: str = CAUTION
    name: str = ""
    text: str = ""
    active: bool = True

    def line(self) -> str:
        """The report as a line of the station's standard input."""
        return json.dumps(asdict(self)) + "\n"

    @classmethod
    def of(cls, line: str) -> Report:
        """Raises ValueError for a line of another form."""
        said = input_files.parsed(line)
        if not isinstance(said, dict) or set(said) != set(
                cls.__dataclass_fields__):
            raise ValueError("not a report's fields")
        made = cls(**said)
        if (made.level not in (CAUTION, WARNING)
                or not isinstance(made.active, bool) or not all(
                    isinstance(each, str)
                    for each in (made.key, made.name, made.text))):
            raise ValueError("not a report's values")
        return made


# A node's messages on standard error: a pattern, and its alert.
BEGINS = (
    (r"plant has (died|diverged)", "plant", WARNING, "PLANT GONE"),
    (r"plant does not answer", "plant", WARNING, "PLANT SILENT"),
    (r"\d+ blocks? refused", "refused {}", WARNING, "{} REFUSES BLOCKS"),
    (r"peer lost", "peer {}", CAUTION, "{} HEARS NOTHING"),
    (r"--\w+: .* left out by", "slow {} {}", CAUTION, "{} {} SLOW"),
    (r"(--\w+|standard output).* (cannot be written|takes nothing):",
     "lost {} {}", CAUTION, "{} {} LOST"),
    (r"no real-time priorities", "priorities", CAUTION, "NO PRIORITIES"))
ENDS = (
    (r"plant in time again", ("plant",)),
    (r"peer heard", ("refused {}", "peer {}")))
ALONE = re.compile(r"warm reset|processor restart|internal fault")
"""Messages that are printed, and are no alert or have their own."""


def is_loss(report: Report) -> bool:
    """True if it is about an incomplete output (GND-53)."""
    return report.active and report.key.startswith(("lost ", "slow "))


def reports_of(node: str, said: str) -> list[Report]:
    """The alerts that a node's message begins or ends."""
    short = node.removeprefix("urv_")
    # The option of an output, for messages about one.
    output = re.split(r":| cannot", said)[0].strip("-")
    for pattern, key, level, name in BEGINS:
        if re.match(pattern, said):
            return [Report(key.format(short, output), level,
                           name.format(short.upper(), output.upper()),
                           f"{node}: {said}")]
    for pattern, keys in ENDS:
        if re.match(pattern, said):
            return [Report(key.format(short), active=False) for key in keys]
    return []


async def take(stream: Any, view: View) -> None:
    """Shows the reports on a station's standard input, up to its end."""
    reader = asyncio.StreamReader()
    try:
        await asyncio.get_running_loop().connect_read_pipe(
            lambda: asyncio.StreamReaderProtocol(reader), stream)
    except (OSError, ValueError) as error:
        view.note(CAUTION, "process", f"no reports: {error}")
        return
    line = b"\n"
    while line:
        try:
            # A line that is too long is a ValueError, too, and is skipped.
            line = await reader.readline()
            if line:
                view.report(Report.of(line.decode("utf-8", "replace")))
        except ValueError as error:
            view.note(CAUTION, "process", f"no report: {error}")

# SPDX-License-Identifier: Apache-2.0
"""The order of frame packets, whatever the clocks say (GND-46, D-37).

Within a run of the ground's node the sequence number orders them. A run that
has not been seen before follows the one that was: its clock may be earlier.
"""

from __future__ import annotations

from collections import deque
from dataclasses import dataclass, field

SILENT_S = 0.5
"""A run that has ended is taken up again when the present one has been silent
for so long."""
FORMER_RUNS = 64
"""So many runs that have ended are remembered."""
STRAYS = 25
"""Packets of a former run, after which another node is sending. Fewer have
been late on their way."""


@dataclass
class Runs:
    """Says of each packet whether it is new."""

    run: int | None = None
    sequence: int = -1
    missing: int = 0
    """Packets that have not come between the last two of one run."""
    strays: int = 0
    """Packets of former runs since the present one began."""
    _came: float = float("-inf")
    _former: deque[int] = field(
        default_factory=lambda: deque(maxlen=FORMER_RUNS))

    def take(self, run: int, sequence: int, now: float) -> bool:
        """Whether the packet is newer than all before. The first of a run
        is: then `began` is True until the next one."""
        self.missing = 0
        self.began = False
        if run == self.run:
            if sequence <= self.sequence:
                return False
            self.missing = sequence - self.sequence - 1
        elif run in self._former and now - self._came < SILENT_S:
            self.strays += 1
            return False
        else:
            self._begin(run)
        self.sequence = sequence
        self._came = now
        return True

    def _begin(self, run: int) -> None:
        if run in self._former:
            self._former.remove(run)
        if self.run is not None:
            self._former.append(self.run)
        self.run = run
        self.strays = 0
        self.began = True

    began: bool = False

    @property
    def has_rival(self) -> bool:
        """Another node sends to this port, too."""
        return self.strays >= STRAYS

# SPDX-License-Identifier: Apache-2.0
"""Words at the converters that show the time of their sample.

Every frame has its own: the first two words are the frame's number, the
others depend on it. A block that arrives shows its age, and a block that was
never sent is detected.
"""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from flight_numbers import COMMANDS as STICKS  # noqa: E402
from flight_numbers import NUMBERS, SENSORS  # noqa: E402, F401


def words(frame, count):
    # Not all zero, as memory is before anything has come.
    mixed = (frame + 1) * 2654435761
    return [frame + 1 & 0xFFF, frame + 1 >> 12] + [
        (mixed >> (place % 13)) * (2 * place + 1) & 0xFFF
        for place in range(2, count)]


def text(frame, count):
    return ",".join(map(str, words(frame, count)))


def write_script(path, names, frames, lag_ms):
    """New words as each of the node's frames begins."""
    with open(path, "w", encoding="ascii") as script:
        script.write(f"time_ms,{','.join(names)}\n")
        for frame in range(frames):
            script.write(f"{frame * NUMBERS.frame_us // 1000 + lag_ms},"
                         f"{text(frame, len(names))}\n")

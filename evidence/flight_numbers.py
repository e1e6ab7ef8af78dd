# SPDX-License-Identifier: Apache-2.0
"""The times and lengths of a flight, and the names of its words, as
`urv_sim numbers` and `urv_sim items` print them: a script that asks here need
not be changed with them (EVI-12).

    from flight_numbers import NUMBERS, SENSORS
    NUMBERS.frame_us

The program is bin/urv_sim, or the one the environment variable URV_SIM names.
docs/urv_sim.md says what each number is.
"""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

PROGRAM = Path(os.environ.get(
    "URV_SIM", Path(__file__).resolve().parent.parent / "bin" / "urv_sim"))


def printed(command):
    try:
        return subprocess.run([PROGRAM.resolve(), command], check=True,
                              capture_output=True, text=True).stdout
    except OSError as error:
        sys.exit(f"{PROGRAM}: {error.strerror}; `make fly` builds it")


def measured(buffer):
    """The words of a buffer that have a unit: all but those of bits."""
    return tuple(item["name"] for item in ITEMS
                 if item["buffer"] == buffer and item["unit"])


NUMBERS = SimpleNamespace(**json.loads(printed("numbers")))
ITEMS = list(csv.DictReader(printed("items").splitlines()))

FRAMES_PER_S = 1_000_000 // NUMBERS.frame_us
FRAME_MS = NUMBERS.frame_us // 1000

COMMANDS, SENSORS = measured("uplink"), measured("downlink")

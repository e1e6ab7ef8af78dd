#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""D-28: plants bugs in a copy of the telemetry board's code; the exploration
must find each. Exit status 1 when it does not find one."""

import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import tree_copy  # noqa: E402

TURNS = "src/telemetry/telemetry-turns.ads"
CHANGES = "src/telemetry/telemetry-turns-changes.adb"

# Name: file, text, the replacement, and the exploration's message with blocks
# of 2 bytes: the real lengths take ten times as long.
BUGS = {
    "the ground does not wait in its reset": (
        TURNS,
        "(if This.State = Idling then Idle_Time_On (This.Round_Trip)",
        "(if This.State = Idling then 1",
        "back in step: NEVER",
    ),
    "the aircraft waits longer than the ground ever does": (
        TURNS,
        "      else Dead_Space_On (This.Round_Trip))",
        "      elsif This.Role = Aircraft then 200 else Dead_Space)",
        "back in step: ",
    ),
    "the ground sends without limit": (
        CHANGES,
        "This.In_A_Row := This.In_A_Row + 1;",
        "null;",
        "back in step: NEVER",
    ),
}


def found(copy, file, text, instead, says):
    """True if the exploration of the copy reports this bug."""
    source = copy / file
    original = source.read_text("utf-8")
    if original.count(text) != 1:
        sys.exit(f"{file} has changed: renew its planted bug, {text!r}")
    try:
        source.write_text(original.replace(text, instead), "utf-8")
        # The optimiser takes more time than it saves.
        subprocess.run(
            ["gprbuild", "-q", "-p", "-m2", "-P",
             copy / "evidence/explore/urv_explore.gpr", "-XURV_Mode=host",
             "-cargs:Ada", "-O0"], check=True)
        explored = subprocess.run(
            [copy / "bin" / "urv_explore", "2", "2", "in-step"],
            capture_output=True, text=True, check=False)
    finally:
        source.write_text(original, "utf-8")
    return explored.returncode == 1 and says in explored.stdout


def main():
    is_good = True
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder)
        tree_copy.renew_copy(ROOT, copy)
        tree_copy.take_objects(ROOT, copy, ("host", "explore-host"))
        for name, bug in BUGS.items():
            is_found = found(copy, *bug)
            print(f"planted bug, {name}: {'found' if is_found else 'NOT FOUND'}",
                  flush=True)
            is_good = is_good and is_found
    sys.exit(0 if is_good else 1)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Static data of each node's flight software, as built for flight (EVI-17).

Adds up the data sections of every object file a node's top package needs,
itself included. Ada's run-time library is not counted: a target has its own.
Exit status: 0 within the limit; 1 above it, or not built.
"""

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
OBJECTS = ROOT / "obj" / "flight"
NODES = ("mcs", "gsc")
LIMIT = 64 * 1024

# Read-only data that the loader relocates is data on the host and not on a
# target without a loader; it is counted with the data.
KINDS = {
    "data": re.compile(r"\.(data|tdata)(\.|$)"),
    "bss": re.compile(r"\.(bss|tbss)(\.|$)"),
    "rodata": re.compile(r"\.rodata(\.|$)"),
}


def build(node):
    command = ["gprbuild", "-q", "-p", "-c", "-P", "urv.gpr"]
    command += ["-XURV_Mode=flight", f"{node}.adb"]
    if subprocess.run(command, cwd=ROOT, check=False).returncode != 0:
        sys.exit(f"size: {node} does not build")


def closure(node):
    """The node's library file and those of all it needs, from our sources."""
    found = set()
    waiting = [OBJECTS / f"{node}.ali"]
    while waiting:
        library = waiting.pop()
        if library not in found and library.exists():
            found.add(library)
            # A line "W name source library" names a unit withed; "Z" one
            # that is needed though not withed.
            for line in library.read_text(encoding="latin-1").splitlines():
                fields = line.split()
                if fields[:1] in (["W"], ["Z"]) and len(fields) >= 4:
                    waiting.append(OBJECTS / fields[3])
    return sorted(found)


def section_sizes(objects):
    """Bytes of each kind of data in the object files together."""
    command = ["size", "-A", *map(str, objects)]
    text = subprocess.run(
        command, capture_output=True, text=True, check=True
    ).stdout
    sizes = dict.fromkeys(KINDS, 0)
    for section, size in re.findall(r"^(\.\S+) +(\d+)", text, re.M):
        for kind, pattern in KINDS.items():
            if pattern.match(section):
                sizes[kind] += int(size)
    return sizes


def recorder_size(objects):
    """The bytes of the flight recorder's ring: as many as a target chooses,
    in its own urv-recorder_sizes.ads."""
    text = subprocess.run(
        ["nm", "-S", *map(str, objects)], capture_output=True, text=True,
        check=True).stdout
    return sum(int(size, 16) for size in re.findall(
        r"^\S+ (\S+) [bBdD] mcs__recorder$", text, re.M))


def main():
    too_big = False
    for node in NODES:
        build(node)
        objects = [path.with_suffix(".o") for path in closure(node)]
        sizes = section_sizes(objects)
        recorder = recorder_size(objects)
        static = sizes["data"] + sizes["bss"] - recorder
        print(
            f"{node}: {static} bytes of static data "
            f"({sizes['data']} data, {sizes['bss'] - recorder} bss) "
            f"of {LIMIT}, {recorder} of the flight recorder, "
            f"{sizes['rodata']} read-only, "
            f"{len(objects)} objects"
        )
        too_big = too_big or static >= LIMIT
    if too_big:
        print("size: static data is not below the limit")
    return 1 if too_big else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Lists the composite types that may be at odd addresses on the MC68000
(BRD-4), from the compiler's listings of representations.

    targets/alignments.py

The compiler copies an object of two bytes or more with words, at any address.
"""

import re
import sys

import emulated

COMPOSITE = re.compile(r"^for (\S+) use record|^for (\S+)'Component_Size",
                       re.MULTILINE)
ATTRIBUTE = re.compile(
    r"^for (\S+)'(Object_Size|Size|Alignment) use (.+?);", re.MULTILINE)


def odd_types(listing):
    """The names of the types in a listing that may be at odd addresses."""
    sizes, alignments = {}, {}
    for name, attribute, value in ATTRIBUTE.findall(listing):
        table = alignments if attribute == "Alignment" else sizes
        table.setdefault(name, value)
    names = {first or second for first, second in COMPOSITE.findall(listing)}
    return sorted(name for name in names
                  if alignments.get(name) == "1" and sizes.get(name) != "8")


def all_odd_types():
    files = sorted((emulated.MC68000_BOARD.images / "objects").glob("*.rep"))
    return {f"{path.name.removesuffix('.rep')} {name}"
            for path in files for name in odd_types(path.read_text("utf-8"))}


def main():
    folder = emulated.MC68000_BOARD.images / "objects"
    if not any(folder.glob("*.rep")):
        print("alignments.py: no listings to look at: make mc68000 makes them",
              file=sys.stderr)
        return 2
    found = sorted(all_odd_types())
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

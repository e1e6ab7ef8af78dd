#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fills a program up to the size of the ROM and puts its sums into the last
eight bytes (TST-1, BRD-3).

    targets/image_sum.py PROGRAM IMAGE ROM_SIZE big|little

The sums are those of URVOS.Image_Sums, over long words in the processor's order
of bytes.
"""

import array
import sys
from pathlib import Path

SUM_SIZE = 8
ONES = 0xFFFFFFFF

# x^32 modulo x^32 + x^7 + x^6 + x^2 + 1
X_32 = 0xC5


def times_x(value):
    return value << 1 & ONES ^ (X_32 if value >> 31 else 0)


def sums(longs):
    """Parity and remainder."""
    parity = remainder = ONES
    for each in longs:
        parity ^= each
        remainder = times_x(remainder) ^ each
    return parity, remainder


def divided(value):
    """Divided by x + 1, modulo the polynomial."""
    for places in (1, 2, 4, 8, 16):
        value ^= value << places & ONES
    return value ^ (0x43 if value >> 31 else 0)


def kept_longs(parity, remainder):
    """The two longs that make both sums 0."""
    first = divided(times_x(times_x(remainder)) ^ parity)
    return first, first ^ parity


def longs_of(data, order):
    found = array.array("I", data)
    if order != sys.byteorder:
        found.byteswap()
    return found


def image_of(program, size, order):
    """The program, filled up to this size of a ROM, with its sums."""
    if len(program) > size - SUM_SIZE:
        raise ValueError(f"the program has {len(program)} bytes: "
                         f"{size - SUM_SIZE} is the most")
    filled = program.ljust(size - SUM_SIZE, b"\xff")
    return filled + b"".join(
        each.to_bytes(4, order)
        for each in kept_longs(*sums(longs_of(filled, order))))


def main():
    if len(sys.argv) != 5 or sys.argv[4] not in ("big", "little"):
        sys.exit(__doc__)
    program, image = map(Path, sys.argv[1:3])
    image.write_bytes(
        image_of(program.read_bytes(), int(sys.argv[3]), sys.argv[4]))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Fills a program up to the size of the ROM and puts its sum into the last
four bytes (TST-1, BRD-3).

    targets/image_sum.py PROGRAM IMAGE ROM_SIZE

The sum is that of URVOS.Image_Sums: CRC-32C, low byte first.
"""

import sys
from pathlib import Path

SUM_SIZE = 4
POLYNOMIAL = 0x82F63B78     # 1EDC6F41h, low bit first


def table_entry(register):
    for _ in range(8):
        register = register >> 1 ^ (POLYNOMIAL if register & 1 else 0)
    return register


TABLE = [table_entry(byte) for byte in range(256)]


def crc(data):
    register = 0xFFFFFFFF
    for byte in data:
        register = register >> 8 ^ TABLE[(register ^ byte) & 255]
    return register ^ 0xFFFFFFFF


def image_of(program, size):
    """The program, filled up to this size of a ROM, with its sum."""
    if len(program) > size - SUM_SIZE:
        raise ValueError(f"the program has {len(program)} bytes: "
                         f"{size - SUM_SIZE} is the most")
    filled = program.ljust(size - SUM_SIZE, b"\xff")
    return filled + crc(filled).to_bytes(SUM_SIZE, "little")


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    program, image = map(Path, sys.argv[1:3])
    image.write_bytes(image_of(program.read_bytes(), int(sys.argv[3])))


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flies both nodes for 10 s on an emulated Cortex-M4, compares each frame with
the simulation, and prints the figures (BRD-1).

    targets/figures.py [SECONDS]

Exit status: 0 when all words are those of the simulation.
"""

import subprocess
import sys
import tempfile

import emulated

CYCLES_PER_TICK = 168_000 * emulated.TICK_MS


def sizes(node):
    """The bytes of a program: in ROM, and variables in RAM."""
    report = subprocess.run(
        ["arm-linux-gnueabihf-size", "-A", emulated.IMAGES / f"{node}.elf"],
        check=True, capture_output=True, text=True).stdout
    found = {name: int(size) for name, size, *_ in
             (line.split() for line in report.splitlines()
              if line.startswith("."))}
    rom = sum(found.get(name, 0) for name in (".vectors", ".text", ".data"))
    return rom, found.get(".data", 0) + found.get(".bss", 0)


def figures(node, run):
    rom, ram = sizes(node)
    worst = run.numbers["worst"]
    mean = run.numbers["mean"]
    instructions = 10 * mean / emulated.CYCLES_PER_INSTRUCTION
    return [
        ("program, bytes", f"{rom:,}"),
        ("variables, bytes", f"{ram:,}"),
        ("stack, bytes, most", f"{run.numbers['stack']:,}"),
        ("instructions a major frame", f"{instructions:,.0f}"),
        ("busy at 168 MHz, mean", f"{mean / CYCLES_PER_TICK:.1%}"),
        ("busiest minor frame", f"{worst / CYCLES_PER_TICK:.1%}"),
        ("overruns", str(run.numbers["overruns"])),
        ("blocks received", str(run.numbers["received"]))]


def main():
    seconds = float(sys.argv[1]) if len(sys.argv) > 1 else 10
    good = True
    for laws in (False, True):
        with tempfile.TemporaryDirectory() as folder:
            rows, runs = emulated.fly_both(folder, seconds, laws)
        different = list(emulated.differences(rows, runs))
        good = good and not different and all(
            run.has(f"{node.upper()} started") for node, run in runs.items())
        print(f"cortex_m: {seconds:g} s, laws {'on' if laws else 'off'}: "
              f"{len(rows)} frames, {len(different)} groups of words differ"
              " from the simulation's")
        for node, run in runs.items():
            for name, value in figures(node, run):
                print(f"  {node} {name:<28}{value:>10}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

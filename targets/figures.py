#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flies both nodes for 10 s on an emulated bare machine, with the laws off and
on and on a sealed link, compares each frame with the simulation, and prints the
figures (BRD-1).

    targets/figures.py cortex_m|mc68000 [SECONDS]
    targets/figures.py mc68000 SECONDS MHZ      at another clock than 250 MHz

Exit status: 0 when all words are those of the simulation.
"""

import subprocess
import sys
import tempfile

import emulated

CYCLES_PER_TICK = 168_000 * emulated.TICK_MS

# The time of the report's controller, in cycles.
CYCLES_PER_FRAME = 10_000 * emulated.FRAME_MS

# The vector of an interrupt.
CONVERTER = 64


def sizes(machine, node):
    """The bytes of a program: in ROM, and variables in RAM."""
    report = subprocess.run(
        [f"{machine.prefix}size", "-A", machine.images / f"{node}.elf"],
        check=True, capture_output=True, text=True).stdout
    found = {name: int(size) for name, size, *_ in
             (line.split() for line in report.splitlines()
              if line.startswith("."))}
    rom = sum(found.get(name, 0) for name in (".vectors", ".text", ".data"))
    return rom, found.get(".data", 0) + found.get(".bss", 0)


def figures(machine, node, run):
    rom, ram = sizes(machine, node)
    return [
        ("program, bytes", f"{rom:,}"),
        ("variables, bytes", f"{ram:,}"),
        ("stack, bytes, most", f"{run.numbers['stack']:,}"),
        *(cortex_m_times if machine is emulated.CORTEX_M
          else mc68000_times)(run.numbers),
        ("overruns", str(run.numbers["overruns"])),
        ("blocks received", str(run.numbers["received"]))]


def cortex_m_times(numbers):
    mean = numbers["mean"]
    instructions = 10 * mean / emulated.CYCLES_PER_INSTRUCTION
    return [
        ("instructions a major frame", f"{instructions:,.0f}"),
        ("busy at 168 MHz, mean", f"{mean / CYCLES_PER_TICK:.1%}"),
        ("busiest minor frame", f"{numbers['worst'] / CYCLES_PER_TICK:.1%}")]


def mc68000_times(numbers):
    """Cycles of the controller and of its telemetry board."""
    frames = numbers["characters"] / (
        1000 * emulated.FRAME_MS / emulated.CHARACTER_US)
    node = numbers["frame_mean"]
    converter = (numbers[f"int{CONVERTER}_mean"]
                 * numbers[f"int{CONVERTER}_count"] / frames)
    return [
        ("cycles a major frame, mean", f"{node:,.0f}"),
        ("  of these for the converter", f"{converter:,.0f}"),
        ("  of 10 MHz", f"{node / CYCLES_PER_FRAME:.0%}"),
        ("cycles a major frame, worst", f"{numbers['frame_worst']:,}"),
        ("worst minor frame", f"{numbers['tick_worst']:,}"),
        ("board, cycles a character", f"{numbers['board_character_mean']:,}"),
        ("  worst", f"{numbers['board_character_worst']:,}"),
        ("longest claim, controller", f"{numbers['claim_worst']:,}"),
        ("longest claim, board", f"{numbers['board_claim_worst']:,}"),
        ("test of a RAM cell", f"{numbers['ram_test_worst']:,}"),
        ("latest interrupt, clock", f"{numbers['late_clock_worst']:,}"),
        ("  converter", f"{numbers['late_converter_worst']:,}"),
        ("start, million cycles", f"{numbers['start'] / 1e6:.1f}"),
        ("flown at MHz", f"{numbers['mhz']}")]


def main():
    if len(sys.argv) < 2 or sys.argv[1] not in emulated.MACHINES:
        sys.exit(__doc__)
    machine = emulated.MACHINES[sys.argv[1]]
    try:
        seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 10
    except ValueError:
        sys.exit(__doc__)
    if not 0 < seconds <= emulated.MOST_SECONDS:
        sys.exit(f"figures.py: {seconds:g} s: a flight has up to"
                 f" {emulated.MOST_SECONDS} s")
    if len(sys.argv) > 3:
        if machine is not emulated.MC68000_BOARD or not sys.argv[3].isdigit():
            sys.exit(__doc__)
        machine.mhz = int(sys.argv[3])
    emulated.check_tools(machine)
    good = True
    for laws, sealed in ((False, False), (True, False), (True, True)):
        with tempfile.TemporaryDirectory() as folder:
            try:
                rows, runs = machine.fly_both(folder, seconds, laws, sealed)
            except emulated.Failed as error:
                sys.exit(f"figures.py: the emulator failed: {error}")
        different = list(emulated.differences(rows, runs))
        absent = list(emulated.missing(rows, runs))
        for frame, node in absent[:1]:
            print(f"figures.py: {node} has no row of frame {frame}, and of"
                  f" {len(absent) - 1} others", file=sys.stderr)
        good = good and not different and not absent and all(
            run.has(f"{node.upper()} started") for node, run in runs.items())
        print(f"{machine.name}: {seconds:g} s, laws {'on' if laws else 'off'}"
              f"{', sealed' if sealed else ''}:"
              f" {len(rows)} frames, {len(different)} groups of words differ"
              " from the simulation's")
        for node, run in runs.items():
            for name, value in figures(machine, node, run):
                print(f"  {node} {name:<28}{value:>10}")
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

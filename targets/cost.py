#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what the nodes cost on the bare machines, and compares it with the
committed baseline (BRD-5).

    targets/cost.py [--renew] [MACHINE ...]

A flight of 3 s with the laws on: on the MC68000 cycles by task, kernel and
interrupt, on the Cortex-M4 instructions of all; the deepest stack by the
compiler's call graph; sizes. A figure of more than 103 % of its baseline is an
error, unless it is 100 or less more. --renew writes the baseline, targets/cost.json.
Exit status: 0 when no figure is too large.
"""

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import emulated
import figures

BASELINE = emulated.ROOT / "targets" / "cost.json"
LIMIT = 1.03
LEAST = 100
SECONDS = 3
NODES = ("gsc", "mcs")

TASK = re.compile(r"^(?:mcs|gsc)__(\w+)__run_transaction$")
KERNEL = re.compile(
    r"^(?:mcs|gsc)__bare_metal__(?:serve|executive__run_step\w*)$")
INTERRUPTS = {"int64": "interrupt converter", "board_int65": "interrupt line",
              "int66": "interrupt clock", "claim": "claim of the controller",
              "board_claim": "claim of the telemetry board",
              "ram_test": "test of a cell in flight"}

GRAPH = re.compile(r'^(node|edge): \{(.*)\}$', re.MULTILINE)
FIELD = re.compile(r'(\w+): "((?:[^"\\]|\\.)*)"')
BYTES = re.compile(r"(\d+) bytes")


def places(machine, node):
    """Subprograms whose cycles are counted: address and name."""
    symbols = subprocess.run(
        [f"{machine.prefix}nm", machine.images / f"{node}.elf"],
        check=True, capture_output=True, text=True).stdout
    for line in symbols.splitlines():
        address, _, symbol = line.split()[-3:]
        if found := TASK.match(symbol):
            yield address, found[1].upper()
        elif KERNEL.match(symbol):
            yield address, "kernel"


def mc68000(machine, folder):
    for node in NODES:
        (folder / f"{node}.places").write_text("".join(
            f"{address} {name}\n" for address, name in places(machine, node)))
    _, runs = machine.fly_both(folder, SECONDS, laws=True)
    for node, run in runs.items():
        numbers = run.numbers
        yield f"{node} major frame, worst", numbers["frame_worst"]
        yield f"{node} minor frame, worst", numbers["tick_worst"]
        for place, name in INTERRUPTS.items():
            yield f"{node} {name}, mean", numbers[f"{place}_mean"]
            yield f"{node} {name}, worst", numbers[f"{place}_worst"]
        # The kernel has two subprograms: its worst is at most their sum.
        tasks = {}
        for line in run.text.splitlines():
            if line.startswith("place "):
                _, name, _, minor, _, worst, _, mean = line.split()
                minors = tasks.setdefault(name, {})
                before = minors.get(minor, (0, 0))
                minors[minor] = before[0] + int(worst), before[1] + int(mean)
        for name, minors in sorted(tasks.items()):
            yield (f"{node} {name}, worst in a minor frame",
                   max(worst for worst, _ in minors.values()))
            yield (f"{node} {name}, mean of a major frame",
                   sum(mean for _, mean in minors.values()))
        yield f"{node} start", numbers["start"]


def cortex_m(machine, folder):
    _, runs = machine.fly_both(folder, SECONDS, laws=True)
    for node, run in runs.items():
        for name, cycles in (("mean", 10 * run.numbers["mean"]),
                             ("busiest minor frame", run.numbers["worst"])):
            yield (f"{node} instructions, {name}",
                   round(cycles / emulated.CYCLES_PER_INSTRUCTION))


def call_graph(machine):
    """Stack bytes of each subprogram, and the subprograms that it calls."""
    sizes, calls = {}, {}
    for path in (machine.images / "objects").glob("*.ci"):
        for kind, text in GRAPH.findall(path.read_text("utf-8")):
            fields = dict(FIELD.findall(text))
            if kind == "node":
                used = BYTES.search(fields.get("label", ""))
                if used:
                    sizes[fields["title"]] = int(used[1])
            else:
                calls.setdefault(fields["sourcename"], set()).add(
                    fields["targetname"])
    return sizes, calls


def deepest(name, sizes, calls, known, above=()):
    """The most stack bytes of a subprogram with all that it calls: each call
    also pushes an address."""
    if name in above:
        raise ValueError(f"{name} calls itself")
    if name not in known:
        known[name] = sizes.get(name, 0) + max(
            (4 + deepest(each, sizes, calls, known, above + (name,))
             for each in calls.get(name, ())), default=0)
    return known[name]


def stacks(machine):
    sizes, calls = call_graph(machine)
    known = {}
    for name in sorted(sizes):
        node, _, task = name.partition("__")
        if node in NODES and TASK.match(name):
            yield (f"{node} stack of {task.partition('__')[0].upper()}",
                   deepest(name, sizes, calls, known))


def measured(machine):
    with tempfile.TemporaryDirectory() as folder:
        measure = mc68000 if machine.name == "mc68000" else cortex_m
        found = list(measure(machine, Path(folder)))
    found += stacks(machine)
    programs = NODES
    if machine.name == "mc68000":
        programs += ("telemetry_board",)
    for node in programs:
        rom, ram = figures.sizes(machine, node)
        found += [(f"{node} program, bytes", rom),
                  (f"{node} variables, bytes", ram)]
    return {f"{machine.name} {name}": value for name, value in found}


def too_large(found, baseline):
    """Each figure over its limit, and each without a baseline."""
    return [f"{name}: {value:,}, baseline {baseline.get(name, 'none')}"
            for name, value in found.items()
            if name not in baseline or value > max(
                LIMIT * baseline[name], baseline[name] + LEAST)]


def main():
    names = [name for name in sys.argv[1:] if name != "--renew"]
    if any(name not in emulated.MACHINES for name in names):
        sys.exit(__doc__)
    baseline = json.loads(BASELINE.read_text()) if BASELINE.exists() else {}
    found = {}
    for name in names or emulated.MACHINES:
        emulated.check_tools(emulated.MACHINES[name])
        try:
            found.update(measured(emulated.MACHINES[name]))
        except emulated.Failed as error:
            sys.exit(f"cost.py: the emulator failed: {error}")
    for name, value in found.items():
        print(f"{name:<56}{value:>12,}{baseline.get(name, 0):>12,}")
    if "--renew" in sys.argv:
        BASELINE.write_text(json.dumps(
            {**baseline, **found}, indent=1, sort_keys=True) + "\n")
        return 0
    errors = too_large(found, baseline)
    for line in errors:
        print(f"cost: over 103 %: {line}", file=sys.stderr)
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())

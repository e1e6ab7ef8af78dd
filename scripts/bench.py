#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures what URV costs beside what one would take instead.

    scripts/bench.py                    prints, and writes bench/results.json
    scripts/bench.py --before COMMIT    the simulation of then beside today's
    scripts/bench.py --renew            writes docs/evidence/performance.md too

Both sides run in turn, 15 times, on this machine: a ratio means the same on
any. Medians are compared; the spread is that of the middle half.
"""

import argparse
import json
import platform
import statistics
import subprocess
import sys
import tarfile
import tempfile
import time
from io import BytesIO
from pathlib import Path

from flight_numbers import FRAMES_PER_S

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "bench" / "results.json"
PAGE = ROOT / "docs" / "evidence" / "performance.md"

FLIGHT_S = 500
RUNS = 15

PEERS = {
    "mailbox 28": ("c_mutex 28", "c_atomics 28", "posix_mq 28", "pipe 28"),
    "mailbox 66": ("c_mutex 66", "c_atomics 66", "ada_queue 66",
                   "posix_mq 66", "pipe 66"),
    "mailbox 1024": ("c_mutex 1024", "c_atomics 1024", "posix_mq 1024",
                     "pipe 1024"),
    "decision 16": ("c_heap 16",),
    "checksum 56": ("c_table 56",),
    "codec 56": ("memcpy 56",),
}
"""What is measured in nanoseconds, each with what stands beside it."""

NAMES = {
    "mailbox": "SEND and RECV, {} bytes",
    "c_mutex": "C: memcpy behind a pthread mutex",
    "c_atomics": "C11: three buffers, an atomic exchange",
    "posix_mq": "`mq_send` and `mq_receive`",
    "pipe": "`write` and `read` of a pipe",
    "ada_queue": "Ada: Bounded_Synchronized_Queues",
    "decision": "scheduler: SLEEP, wake and choice, {} tasks",
    "c_heap": "C: two binary heaps",
    "checksum": "checksum of {} bytes",
    "c_table": "C: a table of 256 bytes",
    "codec": "28 words to {} bytes and back",
    "memcpy": "memcpy of them, once",
}


def name_of(what):
    kind, size = what.split()
    return NAMES[kind].format(size)


def lines_of(program):
    """What it prints: a number for each thing that it measures."""
    done = subprocess.run([program], capture_output=True, text=True,
                          check=True)
    return {" ".join(words[:2]): float(words[2])
            for words in map(str.split, done.stdout.splitlines())
            if words[0] != "#"}


def seconds_of(command):
    start = time.perf_counter()
    subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def build_before(commit, folder):
    """The simulation of that commit, built there."""
    packed = subprocess.run(["git", "-C", ROOT, "archive", commit],
                            capture_output=True, check=True).stdout
    with tarfile.open(fileobj=BytesIO(packed)) as archive:
        archive.extractall(folder, filter="data")
    subprocess.run(["gprbuild", "-q", "-p", "-P", "sim/urv_sim.gpr",
                    "-XURV_Mode=host"], cwd=folder, check=True)
    return Path(folder) / "bin" / "urv_sim"


def summary(values):
    """Median and the middle half."""
    low, middle, high = statistics.quantiles(values, n=4)
    return {"median": middle, "low": low, "high": high}


def measure(commit):
    flight = ["fly", "--plant", "bench", "--quiet", "--seconds", str(FLIGHT_S)]
    with tempfile.TemporaryDirectory(prefix="urv-bench-") as folder:
        workload, peers = Path(folder) / "workload", Path(folder) / "peers"
        for program, source in ((workload, "scripts/bench/workload.c"),
                                (peers, "bench/peers.c")):
            subprocess.run(["gcc", "-O2", "-o", program, ROOT / source,
                            "-lpthread", "-lrt"], check=True)
        whole = {"simulation": [ROOT / "bin" / "urv_sim", *flight],
                 "workload": [workload, str(FLIGHT_S * FRAMES_PER_S)]}
        if commit:
            whole["before"] = [build_before(commit, Path(folder) / "then"),
                               *flight]
        found = {}
        for run in range(RUNS):
            if sys.stdout.isatty():
                print(f"\rbench: run {run + 1} of {RUNS}", end="", flush=True)
            for program in (ROOT / "bin" / "urv_bench", peers):
                for what, cost in lines_of(program).items():
                    found.setdefault(what, []).append(cost)
            for what, command in whole.items():
                found.setdefault(what, []).append(seconds_of(command))
        if sys.stdout.isatty():
            print()
    return {what: summary(values) for what, values in found.items()}


def shown(cost):
    return (f"{cost['median']:.0f} ns" if cost["median"] > 1
            else f"{cost['median']:.3f} s")


def spread(cost):
    return f"{100 * (cost['high'] - cost['low']) / cost['median']:.0f} %"


def table(found, commit):
    rows = ["| what | takes | spread | times URV's |", "|---|---|---|---|"]
    for what, peers in PEERS.items():
        own = found[what]
        rows.append(
            f"| **{name_of(what)}** | {shown(own)} | {spread(own)} | 1 |")
        rows += [f"| {name_of(peer)} | {shown(found[peer])} |"
                 f" {spread(found[peer])} |"
                 f" {found[peer]['median'] / own['median']:.2f} |"
                 for peer in peers]
    own = found["simulation"]
    rows.append(f"| **simulation, {FLIGHT_S} s on the bench plant** |"
                f" {shown(own)} | {spread(own)} | 1 |")
    beside = {"workload": "C: the same data moved, checked and unpacked"}
    if commit:
        beside["before"] = f"the simulation at {commit}"
    rows += [f"| {text} | {shown(found[what])} | {spread(found[what])} |"
             f" {found[what]['median'] / own['median']:.2f} |"
             for what, text in beside.items()]
    return "\n".join(rows)


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--before", metavar="COMMIT")
    options.add_argument("--renew", action="store_true")
    chosen = options.parse_args()

    found = measure(chosen.before)
    simulation, workload = found["simulation"], found["workload"]
    RESULTS.write_text(json.dumps({
        "frames": FLIGHT_S * FRAMES_PER_S,
        "simulation_s": simulation["median"],
        "workload_s": workload["median"],
        "simulated_seconds_per_second": FLIGHT_S / simulation["median"],
        "simulation_to_workload": simulation["median"] / workload["median"],
        "machine": platform.processor() or platform.machine(),
        "measured": found,
    }, indent=1) + "\n", encoding="utf-8")
    text = table(found, chosen.before)
    print(text)
    print(f"{FLIGHT_S / simulation['median']:.0f} times real time")
    if chosen.renew:
        head = PAGE.read_text("utf-8").partition("| what |")[0]
        PAGE.write_text(head + text + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())

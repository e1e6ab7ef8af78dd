#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of URV and of the usual alternatives.

    evidence/bench.py                    prints, and writes evidence/bench/results.json
    evidence/bench.py --before COMMIT    the simulation of then beside today's
    evidence/bench.py --renew            writes docs/evidence/performance.md too
    evidence/bench.py --runs 2           for a look

All sides run in turn, 15 times, on this machine: a ratio means the same on
any. It is the median of each turn's; the spread is that of the middle half. Programs of
calls run on one processor, as an ordinary user.
"""

import argparse
import json
import os
import platform
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from flight_numbers import FRAMES_PER_S, NUMBERS

ROOT = Path(__file__).resolve().parent.parent
RESULTS = ROOT / "evidence" / "bench" / "results.json"
PAGE = ROOT / "docs" / "evidence" / "performance.md"
PYTHON = ROOT / ".venv" / "bin" / "python"
SIMULATION = ROOT / "bin" / "urv_sim"

FLIGHT_S = 500
JSBSIM_S = 180
RUNS = 15

TASKS = (2, 10, 16)
"""How many tasks the scheduler has, up to as many as it has TCBs."""

PEERS = {
    "mailbox 28": ("c_mutex 28", "c_atomics 28", "posix_mq 28", "pipe 28"),
    "mailbox 66": ("c_mutex 66", "c_atomics 66", "ada_queue 66",
                   "posix_mq 66", "pipe 66"),
    "mailbox 1024": ("c_mutex 1024", "c_atomics 1024", "posix_mq 1024",
                     "pipe 1024"),
    "semaphore 1": ("c_lock 1",),
    **{f"decision {tasks}": (f"c_heap {tasks}", f"cpp_queue {tasks}")
       for tasks in TASKS},
    **{f"exit {tasks}": () for tasks in TASKS},
    "switch 2": ("c_switch 2",),
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
    "semaphore": "P and V of a free semaphore",
    "c_lock": "C: a pthread mutex, locked and unlocked",
    "decision": "scheduler: SLEEP, wake and choice, {} tasks",
    "exit": "scheduler: SLEEP, choice, wake and EXIT, {} tasks",
    "c_heap": "C: two binary heaps",
    "cpp_queue": "C++: two `std::priority_queue`",
    "switch": "a switch between two Ravenscar tasks",
    "c_switch": "C: between two threads, by a condition variable",
    "checksum": "checksum of {} bytes",
    "c_table": "C: a table of 256 bytes",
    "codec": "28 words to {} bytes and back",
    "memcpy": "memcpy of them, once",
}

SPEEDS = {
    "simulation": f"**`bin/urv_sim`, {FLIGHT_S} s on the bench plant**",
    "two at once": "two such flights at once, each",
    "simulation then": "the same at {}",
    "jsbsim": f"**with JSBSim and its pilot, {JSBSIM_S} s, once it flies**",
    "jsbsim alone": "JSBSim alone, the same steps and properties",
    "jsbsim bare": "the steps alone",
    "jsbsim then": "with JSBSim at {}",
}
"""What is measured in times real time."""

OWN = {**{peer: what for what, peers in PEERS.items() for peer in peers},
       "two at once": "simulation", "simulation then": "simulation",
       "jsbsim alone": "jsbsim", "jsbsim bare": "jsbsim",
       "jsbsim then": "jsbsim"}
"""Beside which of ours a peer stands."""

SPANS = {
    "start": "a flight of one frame",
    "10 s": "a flight of 10 s", "100 s": "of 100 s", "1000 s": "of 1,000 s",
    "workload": f"C: the data of {FLIGHT_S} s moved, checked, unpacked",
    "whole": f"with JSBSim, {JSBSIM_S} s, from the start of the program",
    "whole then": "the same at {}",
}
"""What is measured in milliseconds."""


def name_of(what):
    kind, size = what.split()
    return NAMES[kind].format(size)


class Caller:
    """How programs of calls are run: on one processor, not as root."""

    def __init__(self):
        processor = max(os.sched_getaffinity(0))
        self.options = {
            "preexec_fn": lambda: os.sched_setaffinity(0, {processor})}
        if os.geteuid() == 0:
            self.options |= {"user": 65534, "group": 65534,
                             "extra_groups": []}

    def lines_of(self, program):
        """What it prints: a number for each thing that it measures."""
        done = subprocess.run([program], capture_output=True, text=True,
                              check=True, **self.options)
        return {" ".join(words[:2]): float(words[2])
                for words in map(str.split, done.stdout.splitlines())
                if words[0] != "#"}


def seconds_of(command):
    start = time.perf_counter()
    subprocess.run(command, cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
    return time.perf_counter() - start


def said_by(command, root=ROOT):
    """How many times real time it says that it flew, and how long the whole
    of it took."""
    began = time.perf_counter()
    done = subprocess.run(
        command, cwd=root, capture_output=True, text=True, check=True,
        env={**os.environ, "URV_PYTHON": str(PYTHON)})
    took = time.perf_counter() - began
    return float(re.search(r"([\d.]+) times real time",
                           done.stdout)[1]), took


def built(project, folder=ROOT, mode="host", **external):
    subprocess.run(["gprbuild", "-q", "-p", "-j0", "-P", project,
                    f"-XURV_Mode={mode}",
                    *[f"-X{name}={value}"
                      for name, value in external.items()]],
                   cwd=folder, check=True)


def build_before(commit, folder):
    """The simulation of that commit, built there."""
    packed = subprocess.run(["git", "-C", ROOT, "archive", commit],
                            capture_output=True, check=True).stdout
    folder.mkdir()
    subprocess.run(["tar", "-x", "-C", folder], input=packed, check=True)
    built("sim/urv_sim.gpr", folder)
    return folder / "bin" / "urv_sim"


def build_calls(folder):
    """Every program of calls, where anybody can run it."""
    built("evidence/bench/urv_bench.gpr", mode="flight")
    built("evidence/bench/queue/urv_bench_queue.gpr")
    found = [folder / name for name in ("urv_bench", "urv_bench_queue")]
    for path in found:
        shutil.copy(ROOT / "bin" / path.name, path)
    for compiler, name in (("gcc", "peers.c"), ("g++", "queues.cpp")):
        program = folder / name.partition(".")[0]
        subprocess.run([compiler, "-O2", "-o", program,
                        ROOT / "evidence" / "bench" / name,
                        "-lpthread", "-lrt"], check=True)
        found.append(program)
    return found


def latencies(folder):
    """From the console to the servos, ms, at every phase of the frames."""
    sticks = folder / "sticks.csv"
    rows = [f"{200 + 211 * turn},{2048 + 100 * (turn % 2)}"
            for turn in range(80)]
    sticks.write_text("time_ms,roll\n" + "\n".join(rows) + "\n", "utf-8")
    found = []
    for phase in range(NUMBERS.frame_ticks):
        summary = folder / "summary.json"
        seconds_of([SIMULATION, "fly", "--quiet", "--sticks", sticks,
                    "--phase", str(phase), "--summary", summary])
        latency = json.loads(summary.read_text("utf-8"))["latency_ms"]
        found += [latency["min"], latency["max"]]
    return min(found), max(found)


def fly(*options, program=SIMULATION):
    return [program, "fly", *options]


def bench(seconds, program=SIMULATION):
    return fly("--plant", "bench", "--quiet", "--seconds", str(seconds),
               program=program)


def jsbsim(program=SIMULATION):
    return fly("--plant", "jsbsim", "--pilot", "standard", "--seconds",
               str(JSBSIM_S), program=program)


def alone(*options):
    return [PYTHON, "evidence/bench/jsbsim_alone.py", str(JSBSIM_S), *options]


def two_at_once():
    """Times real time of each."""
    start = time.perf_counter()
    flights = [subprocess.Popen(bench(FLIGHT_S), cwd=ROOT,
                                stdout=subprocess.DEVNULL) for _ in range(2)]
    if any([flight.wait() for flight in flights]):
        raise ValueError("a flight failed")
    return FLIGHT_S / (time.perf_counter() - start)


def flights(then, workload):
    """Speeds and milliseconds of one run; who is compared follows at once."""
    found = {"simulation": FLIGHT_S / seconds_of(bench(FLIGHT_S))}
    if then:
        found["simulation then"] = FLIGHT_S / seconds_of(
            bench(FLIGHT_S, then))
    found["two at once"] = two_at_once()
    found["start"] = 1e3 * seconds_of(bench(1 / FRAMES_PER_S))
    found["workload"] = 1e3 * seconds_of(
        [workload, str(FLIGHT_S * FRAMES_PER_S)])
    for seconds in (10, 100, 1000):
        found[f"{seconds} s"] = 1e3 * seconds_of(bench(seconds))
    found["jsbsim alone"], _ = said_by(alone())
    found["jsbsim"], whole = said_by(jsbsim())
    found["whole"] = 1e3 * whole
    if then:
        found["jsbsim then"], whole = said_by(jsbsim(then))
        found["whole then"] = 1e3 * whole
    found["jsbsim bare"], _ = said_by(alone("--bare"))
    return found


def summary(values):
    """Median and the middle half."""
    low, middle, high = statistics.quantiles(values, n=4)
    return {"median": middle, "low": low, "high": high}


def beside(values, own):
    """The median of what part of ours each was in its turn: a machine that is
    slow for a while is so for both."""
    return statistics.median(
        value / ours for value, ours in zip(values, own, strict=True))


def measure(commit, runs):
    with tempfile.TemporaryDirectory(prefix="urv-bench-") as name:
        folder = Path(name)
        folder.chmod(0o755)
        print("bench: building", flush=True)
        programs = build_calls(folder)
        workload = folder / "workload"
        subprocess.run(["gcc", "-O2", "-o", workload,
                        ROOT / "evidence" / "bench" / "workload.c"],
                       check=True)
        then = build_before(commit, folder / "then") if commit else None
        caller = Caller()
        found = {}
        for run in range(runs):
            if sys.stdout.isatty():
                print(f"\rbench: run {run + 1} of {runs}", end="", flush=True)
            for program in programs:
                for what, cost in caller.lines_of(program).items():
                    found.setdefault(what, []).append(cost)
            for what, value in flights(then, workload).items():
                found.setdefault(what, []).append(value)
        if sys.stdout.isatty():
            print()
        bounds = latencies(folder)
    return {what: {**summary(values),
                   "beside": beside(values, found[OWN.get(what, what)])}
            for what, values in found.items()}, bounds


def spread(cost):
    return f"{100 * (cost['high'] - cost['low']) / cost['median']:.0f} %"


def of_calls(found):
    rows = ["| what | takes, ns | spread | times URV's |", "|---|---|---|---|"]
    for what, peers in PEERS.items():
        own = found[what]
        rows.append(f"| **{name_of(what)}** | {own['median']:.1f} |"
                    f" {spread(own)} | 1 |")
        rows += [f"| {name_of(peer)} | {found[peer]['median']:.1f} |"
                 f" {spread(found[peer])} |"
                 f" {found[peer]['beside']:.2f} |"
                 for peer in peers]
    return "\n".join(rows)


def of_flights(found, commit):
    rows = ["| what | times real time | spread | part of URV's |",
            "|---|---|---|---|"]
    for what, text in SPEEDS.items():
        if what in found:
            speed = found[what]
            rows.append(f"| {text.format(commit)} | {speed['median']:.0f} |"
                        f" {spread(speed)} | {speed['beside']:.2f} |")
    rows += ["", "| what | takes, ms | spread |", "|---|---|---|"]
    rows += [f"| {text.format(commit)} | {found[what]['median']:.1f} |"
             f" {spread(found[what])} |"
             for what, text in SPANS.items() if what in found]
    return "\n".join(rows)


def page(found, bounds, commit, runs):
    least, most = bounds
    return (f"{of_calls(found)}\n\nMedians of {runs} runs; of a ratio, that of"
            f" each run's own.\n\n"
            f"{of_flights(found, commit)}\n\n"
            f"From the console to the servos in the simulation, at every phase"
            f" of the frames: {least} to {most} ms.\n")


def renew(text):
    head = PAGE.read_text("utf-8").partition("| what |")[0]
    PAGE.write_text(head + text, encoding="utf-8")


def main():
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    options.add_argument("--before", metavar="COMMIT")
    options.add_argument("--renew", action="store_true")
    options.add_argument("--runs", type=int, default=RUNS, metavar="N")
    chosen = options.parse_args()

    began = time.monotonic()
    found, bounds = measure(chosen.before, chosen.runs)
    RESULTS.write_text(json.dumps({
        "frames": FLIGHT_S * FRAMES_PER_S,
        "simulated_seconds_per_second": found["simulation"]["median"],
        "console_to_servo_ms": bounds,
        "machine": platform.processor() or platform.machine(),
        "measured": found,
    }, indent=1) + "\n", encoding="utf-8")
    text = page(found, bounds, chosen.before, chosen.runs)
    print(text, end="")
    if chosen.renew:
        renew(text)
    print(f"bench: {time.monotonic() - began:.0f} s")
    return 0


if __name__ == "__main__":
    sys.exit(main())

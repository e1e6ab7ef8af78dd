#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the simulation's speed beside a fixed workload in C.

Both run on this machine one after the other, so that the ratio means the
same on any machine: how many times the simulation of a flight takes what
moving the same data does in plain C. Writes bench/results.json.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from flight_numbers import FRAMES_PER_S

ROOT = Path(__file__).resolve().parent.parent
WORKLOAD = ROOT / "scripts" / "bench" / "workload.c"
RESULTS = ROOT / "bench" / "results.json"

FLIGHT_S = 2_000
RUNS = 5


def best_time(command):
    """The shortest of some runs: what else the machine does only adds."""
    times = []
    for _ in range(RUNS):
        start = time.perf_counter()
        done = subprocess.run(
            command, cwd=ROOT, stdout=subprocess.DEVNULL, check=False
        )
        times.append(time.perf_counter() - start)
        if done.returncode != 0:
            sys.exit(f"bench: {command[0]} ended with {done.returncode}")
    return min(times)


def main():
    frames = FLIGHT_S * FRAMES_PER_S
    with tempfile.TemporaryDirectory(prefix="urv-bench-") as folder:
        program = Path(folder) / "workload"
        subprocess.run(
            ["gcc", "-O2", "-o", program, WORKLOAD], check=True
        )
        workload_s = best_time([program, str(frames)])
    flight = ["bin/urv_sim", "fly", "--plant", "bench", "--quiet"]
    simulation_s = best_time([*flight, "--seconds", str(FLIGHT_S)])

    results = {
        "frames": frames,
        "simulation_s": simulation_s,
        "workload_s": workload_s,
        "simulated_seconds_per_second": FLIGHT_S / simulation_s,
        "simulation_to_workload": simulation_s / workload_s,
    }
    RESULTS.parent.mkdir(exist_ok=True)
    RESULTS.write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")

    print(
        f"{FLIGHT_S} s of flight on the bench plant: {simulation_s:.3f} s, "
        f"{results['simulated_seconds_per_second']:.0f} times real time"
    )
    print(f"the same data moved in plain C: {workload_s:.3f} s")
    print(f"ratio: {results['simulation_to_workload']:.1f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""JSBSim alone: the aircraft settles, then flies so many seconds with what
its servos have. Prints how many times real time that was.

    scripts/bench/jsbsim_alone.py SECONDS
"""

import os
import sys
import time
from pathlib import Path

sys.path.insert(
    0, str(Path(__file__).resolve().parents[2] / "sim" / "jsbsim"))

import plant  # noqa: E402

TIMES = plant.Times(tick=2000, frame=10, scan=8, shown=10)


def main(seconds):
    # The simulation's own process has no other standard output.
    output = os.dup(1)
    os.dup2(2, 1)
    aircraft = plant.Aircraft((), (), (), (), TIMES)
    steps = round(seconds / (TIMES.step * TIMES.tick / 1e6))
    run = aircraft.fdm.run
    began = time.perf_counter()
    for _ in range(steps):
        run()
    took = time.perf_counter() - began
    os.write(output, f"{seconds / took:.1f} times real time\n".encode())


if __name__ == "__main__":
    main(float(sys.argv[1]))

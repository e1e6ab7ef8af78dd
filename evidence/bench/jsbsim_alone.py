#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""JSBSim alone: the aircraft settles, then flies so many seconds with what
its servos have, in the loop that one would write. For each major frame it sets
the servos, takes the same steps as the simulation does, and reads what the
simulation wants, each property once. Prints how many times real time that was.

    evidence/bench/jsbsim_alone.py SECONDS
    evidence/bench/jsbsim_alone.py SECONDS --bare    takes the steps only
"""

import os
import sys
import time
from pathlib import Path

sys.path.insert(
    0, str(Path(__file__).resolve().parents[2] / "sim" / "jsbsim"))

import plant  # noqa: E402

TIMES = plant.Times(tick=2000, frame=10, scan=8, shown=10)
WANTED = (plant.SENSORS, plant.TRUTH, plant.SHOWN)


def main(seconds, bare):
    # The simulation's own process has no other standard output.
    output = os.dup(1)
    os.dup2(2, 1)
    aircraft = plant.Aircraft((), (), (), (), TIMES)
    run = aircraft.fdm.run
    get_node = aircraft.tree.get_node
    wanted, commands = [], []
    if not bare:
        wanted = [get_node(path) for path in sorted(
            {path for table in WANTED for _, path, *_ in table.values()})]
        servos = [get_node(path) for _, path in plant.SERVOS.values()]
        commands = [(servo, servo.get_double_value()) for servo in servos]
    steps = TIMES.frame // TIMES.step
    frames = round(seconds / (TIMES.frame * TIMES.tick / 1e6))
    began = time.perf_counter()
    for _ in range(frames):
        for servo, command in commands:
            servo.set_double_value(command)
        for _ in range(steps):
            run()
        _ = [node.get_double_value() for node in wanted]
    took = time.perf_counter() - began
    os.write(output, f"{seconds / took:.1f} times real time\n".encode())


if __name__ == "__main__":
    main(float(sys.argv[1]), sys.argv[2:] == ["--bare"])

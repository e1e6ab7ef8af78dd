#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Changes the code in small ways; records which test or proof fails.

Each mutant of the flight software is built and given to the unit tests with
contracts executed. A mutant that passes with the object code of the original
is equivalent, and is set aside. The others go to the simulation's tests. Then
the mutants that are left go to the proof of the units that the change can
concern: of a body its own, of a specification all that depend on it. The first
failure is recorded.

Results are appended to a file as they come. A run goes on where the last one
stopped; a mutant is tried again when the file it changes has changed.

Exit status: 0 done; 1 the unchanged software does not pass its own tests, or
there is no mutant.
"""

import argparse
import json
import os
import queue
import signal
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

import fates  # noqa: E402
import mutants  # noqa: E402
from fates import PASSED  # noqa: E402
from flight_trials import FlightTrial  # noqa: E402
from whole_numbers import whole  # noqa: E402

SEED = 1991

# The share of a package that is tried, the least number, the most.
SAMPLE = (0.15, 4, 10)


def try_one(worker, stage, mutant, source):
    """The line of the results about a mutant."""
    begun = time.monotonic()
    fate, by = stage(worker, mutant)
    return {
        "name": mutant.name, "path": mutant.path,
        "line": mutant.line, "subprogram": mutant.subprogram,
        "operator": mutant.operator, "change": mutant.change[:300],
        "fate": fate, "by": by,
        "seconds": round(time.monotonic() - begun, 1), "source": source,
    }


def work(worker, stage, tasks, digests, progress):
    while True:
        try:
            group = tasks.get_nowait()
        except queue.Empty:
            worker.put(None)
            return
        for mutant in group:
            result = try_one(worker, stage, mutant, digests[mutant.path])
            with progress.lock, fates.RESULTS.open(
                    "a", encoding="utf-8") as file:
                file.write(json.dumps(result) + "\n")
            progress.step(mutant, result["fate"])


def run_stage(stage, wanted, digests, jobs):
    """Take some mutants through one stage. Exit status."""
    if not wanted:
        return 0
    groups = {}
    for mutant in wanted:
        groups.setdefault(mutant.path, []).append(mutant)
    tasks = queue.Queue()
    for path in sorted(groups, key=turn):
        tasks.put(groups[path])
    workers = [FlightTrial(n) for n in range(min(jobs, len(groups)))]

    def leave(*_):
        for worker in workers:
            worker.stop()
        print("mutation: stopped; it goes on from here next time")
        os._exit(130)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, leave)
    for worker in workers:
        problem = worker.prepare(stage, wanted)
        if problem:
            print(f"mutation: without any change: {problem}")
            return 1
    progress = fates.Progress(len(wanted))
    threads = [
        threading.Thread(
            target=work,
            args=(worker, stage, tasks, digests, progress),
        )
        for worker in workers
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return 0


def read_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--jobs", type=whole(1), default=1)
    parser.add_argument("--only", default="", metavar="TEXT",
                        help="only files whose path contains this")
    parser.add_argument("--again", metavar="FATE",
                        help="also mutants of this result, once more")
    parser.add_argument("--no-proof", action="store_true",
                        help="leave the proof for another run")
    parser.add_argument("--list", action="store_true",
                        help="list the mutants, try none")
    return parser.parse_args()


def turn(path):
    """Folder by folder of src."""
    return mutants.FOLDERS.index(path.split("/")[1]), path


def main():
    arguments = read_arguments()
    every = mutants.Code(fates.ROOT).mutants()
    digests = {path: fates.digest(path)
               for path in {mutant.path for mutant in every}}
    fates.RESULTS.parent.mkdir(exist_ok=True)
    before = fates.read(fates.RESULTS)
    picked = mutants.chosen(every, SEED, *SAMPLE, before)
    picked = [m for m in picked if arguments.only in m.path]
    if not picked:
        print(f"mutation: no mutant in a file whose path has {arguments.only}")
        return 1
    if arguments.list:
        for m in picked:
            print(f"{m.name} {m.path}:{m.line} {m.operator}")
        return 0
    untested = [
        m for m in picked if m.name not in before
        or before[m.name]["source"] != digests[m.path]
        or before[m.name]["fate"] == arguments.again]
    print(f"mutation: {len(every)} mutants, {len(picked)} chosen, "
          f"{len(picked) - len(untested)} tested before")
    status = run_stage(FlightTrial.test, untested, digests, arguments.jobs)
    if status != 0 or arguments.no_proof:
        return status
    now = fates.read(fates.RESULTS)
    unproved = [m for m in picked if now[m.name]["fate"] == PASSED]
    if unproved:
        print(f"mutation: {len(unproved)} pass the tests, go to the proof")
        return run_stage(FlightTrial.prove, unproved, digests, arguments.jobs)
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Searches random histories for a hold that is not held afterwards (EXT-8).

    evidence/laws/histories.py [--flights N] [--seed N] [--jobs N]
                              [--results FILE]
    evidence/laws/histories.py --again SEED [--folder FOLDER]

Sticks, modes, engine, surfaces and link do what they like for up to a minute;
then come 90 s of calm (urv.histories). evidence/safety/holds.py judges each
flight. Results are kept as they come: a search that is broken off goes on
where it stopped, unless bin/urv_sim, the aircraft or the judge has changed.
Exit status: 0 when every hold is held; 1 otherwise, a line for each.
--again flies one here, keeps its files and prints what is not held.
"""

import os
import sys

if __name__ == "__main__" and not sys.flags.isolated:
    # The processes that this one starts look for no module in the current
    # folder, either (SEC-10).
    os.execve(sys.executable, [sys.executable, "-I", "-B", *sys.argv], {
        name: value for name, value in os.environ.items()
        if not name.startswith("PYTHON")})

import argparse  # noqa: E402
import json  # noqa: E402
import subprocess  # noqa: E402
from pathlib import Path  # noqa: E402
from types import SimpleNamespace  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "ground"), str(ROOT / "evidence" / "safety")]

import holds  # noqa: E402
from urv import (  # noqa: E402
    cargo, faults, histories, monte_carlo, progress, whole_files, workers)

RESULTS = ROOT / "flight" / "histories.jsonl"


def known(path, program):
    """The results of this program that were kept, by seed."""
    found = {}
    if path.is_file():
        for line in path.read_text("utf-8").splitlines():
            try:
                result = json.loads(line)
            except ValueError:
                # A line that was not written to its end.
                continue
            # One that could not be flown is tried again.
            if result.get("program") == program and not result["fault"]:
                found[result["seed"]] = result
    return found


def search(given):
    sent = cargo.Cargo(cargo.packed(ROOT, monte_carlo.CARGO), cargo.fly)
    given.results.parent.mkdir(parents=True, exist_ok=True)
    seeds = range(given.seed, given.seed + given.flights)
    found = {seed: result for seed, result
             in known(given.results, sent.hash).items() if seed in seeds}
    if found:
        print(f"{len(found)} of {len(seeds)} histories were flown before")
    jobs = (monte_carlo.history_job(seed) for seed in seeds
            if seed not in found)
    try:
        with open(given.results, "a", encoding="utf-8",
                  opener=whole_files.no_link) as kept, \
                progress.bar("flying") as told:
            for job, answer in workers.done(sent, jobs, None, given.jobs):
                result = {"seed": job["seed"], "program": sent.hash,
                          "fault": answer.get("fault", ""),
                          **answer.get("holds", {})}
                kept.write(json.dumps(result) + "\n")
                kept.flush()
                found[job["seed"]] = result
                told(SimpleNamespace(size=len(seeds), position=len(found)))
    except KeyboardInterrupt:
        print(f"broken off after {len(found)} of {len(seeds)} histories; it"
              " goes on from here next time")
        return 130
    return report([found[seed] for seed in seeds])


def report(results):
    bad = 0
    judged, excepted, reasons, landed = {}, {}, set(), 0
    for result in results:
        for line in result.get("which", ()):
            print(f"seed {result['seed']}: {line}")
        if result["fault"]:
            print(f"seed {result['seed']}: not flown: {result['fault']}")
        bad += bool(result["fault"]) or bool(result["not_held"])
        landed += bool(result.get("landed"))
        for total, part in ((judged, "judged"), (excepted, "excepted")):
            for hold, windows in result.get(part, {}).items():
                total[hold] = total.get(hold, 0) + windows
        reasons |= set(result.get("reasons", ()))
    for hold in sorted({*judged, *excepted}):
        print(f"{hold}: {judged.get(hold, 0)} windows of"
              f" {holds.WINDOW_S} s judged, {excepted.get(hold, 0)} excepted")
    for reason in sorted(reasons):
        print(f"excepted: {reason}")
    print(f"{len(results)} histories, {landed} came to the ground, {bad} with"
          " a hold that is not held")
    return 1 if bad else 0


def fly_again(given):
    job = monte_carlo.history_job(given.again)
    folder = given.folder or ROOT / "flight" / f"history-{given.again}"
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in job["files"].items():
        with whole_files.replacing(folder / name) as path:
            path.write_text(text, encoding="utf-8")
    command = [str(ROOT / "bin" / "urv_sim"), "fly", *job["options"],
               "--quiet", "--record", "record.csv"]
    subprocess.run(command, cwd=folder, check=True,
                   stdin=subprocess.DEVNULL)
    findings = holds.check(folder / "record.csv", folder / "faults.txt")
    for line in findings.not_held:
        print(line)
    print(f"{folder}: {len(findings.not_held)} holds not held, judged"
          f" {findings.judged}, excepted {findings.excepted}"
          f" {findings.reasons}" + (", came to the ground"
                                    if findings.landed else ""))
    return 1 if findings.not_held else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--flights", type=int, default=2000, metavar="N",
                        help="how many histories (2000)")
    parser.add_argument("--seed", type=int, default=1, metavar="N",
                        help="seed of the first; the others follow (1)")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1,
                        metavar="N", help="flights at once")
    parser.add_argument("--results", type=Path, default=RESULTS,
                        metavar="FILE", help="where results are kept"
                        " (flight/histories.jsonl)")
    parser.add_argument("--again", type=int, metavar="SEED",
                        help="fly that one alone and keep its files")
    parser.add_argument("--folder", type=Path, metavar="FOLDER",
                        help="for the files of --again")
    given = parser.parse_args()
    try:
        return fly_again(given) if given.again is not None else search(given)
    except (faults.Refused, faults.Failed) as fault:
        print(f"histories: {fault}", file=sys.stderr)
        return fault.status
    except OSError as fault:
        print(f"histories: {fault.filename or given.results}:"
              f" {faults.reason(fault)}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())

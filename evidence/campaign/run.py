#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Disturbs the link and checks that it recovers.

  run.py tiny|short|full [--jobs N]
  run.py shard NAME          one shard, its result as one line of JSON
  run.py mix NUMBER FOLDER   leaves a random mix's files and record in the
                             folder, prints its options and its failures

With --format 2 every flight is sealed (docs/security.md). With --only GROUPS
only the shards of these groups are flown (cases.py).

Results are left in campaign/. Exit status: 0 when every check of every shard
held.
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
import concurrent.futures  # noqa: E402
import csv  # noqa: E402
import json  # noqa: E402
import math  # noqa: E402
import signal  # noqa: E402
import subprocess  # noqa: E402
import tempfile  # noqa: E402
import time  # noqa: E402
from pathlib import Path  # noqa: E402
from types import SimpleNamespace  # noqa: E402

sys.path.insert(0, str(Path(__file__).resolve().parent))

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "evidence" / "safety"), str(ROOT / "ground")]

import cases  # noqa: E402
import checker  # noqa: E402
import data  # noqa: E402
import mixes  # noqa: E402
import monitor  # noqa: E402
from flight_numbers import FRAMES_PER_S, NUMBERS  # noqa: E402
from whole_numbers import whole  # noqa: E402

PROGRAM = ROOT / "bin" / "urv_sim"
RESULTS = ROOT / "campaign"


def write_key(path):
    path.touch(mode=0o600)
    path.chmod(0o600)
    path.write_text(mixes.KEY, encoding="ascii")


def fly(folder, phase, seed, frames, faults, message_format=1):
    lag = phase * NUMBERS.tick_us // 1000
    data.write_script(folder / "sticks.csv", data.STICKS, frames, 0)
    data.write_script(folder / "sensors.csv", data.SENSORS, frames, lag)
    (folder / "faults.txt").write_text(faults, encoding="ascii")
    command = [PROGRAM, "fly", "--quiet", "--seconds", f"{frames / FRAMES_PER_S:.2f}",
               "--phase", phase, "--seed", seed,
               "--sticks", "sticks.csv", "--sensors", "sensors.csv",
               "--faults", "faults.txt",
               "--record", "record.csv", "--wire", "wire.csv",
               "--summary", "summary.json"]
    if message_format == 2:
        write_key(folder / "key")
        command += ["--format", 2, "--key", "key"]
    return subprocess.run(list(map(str, command)), cwd=folder, check=False,
                          capture_output=True, text=True)


# The names of a mix's files, by their option.
FILES = {"sticks": "sticks.csv", "sensors": "sensors.csv",
         "faults": "faults.txt", "orders": "orders.txt", "key": "key"}


def lines_of(case, first):
    for fault in case.faults:
        at_ms = (first * cases.FRAME_US + fault.at_us) / 1000
        yield " ".join(f"{at_ms:.3f} {fault.way} {fault.text}".split())


def by_theory(name, flight):
    """How many wrong blocks the checksum is expected to let through.

    It finds whatever spoils one character, and one lost or added is found
    by the count. Two or more spoilt ones with even numbers of wrong bits, or
    one lost and one added, it lets through 1 time in 256. Not all pairs and
    triples are of this kind, so there it is a bound.
    """
    group, *rest = name.split("/")
    if group == "many":
        return int(rest[2]) / 256
    if group == "soak":
        rate = float(rest[2])
        whole = (1 - rate) ** 9
        even = sum(math.comb(9, n) * rate**n * (1 - rate) ** (9 - n)
                   for n in (2, 4, 6, 8))
        sent = flight.link[-1]
        return sum(
            count * whole * ((whole + even) ** others - whole ** others
                             - others * even * whole ** (others - 1)) / 256
            for count, others in (
                (sent[0], NUMBERS.uplink_characters - 1),
                (sent[4], NUMBERS.downlink_characters - 1)))
    return 0.0


def findings_in(folder, *flown):
    """The safety monitor's findings in a flight of this folder. By default it
    was flown in the report's schedule, without drift or lock."""
    return monitor.check(folder / "record.csv", folder / "sticks.csv",
                         folder / "sensors.csv", folder / "faults.txt",
                         *flown)


def refused_in(folder):
    """How many blocks the nodes refused, by their error logs."""
    summary = json.loads((folder / "summary.json").read_text("utf-8"))
    return sum(count for event, count in summary["events"].items()
               if event.endswith(".block_refused"))


def fly_mix(mix, folder):
    """The command that flies it, and its result."""
    command = [str(PROGRAM), "fly", "--quiet", *mix.options]
    for option, text in mix.files.items():
        name = FILES[option]
        (folder / name).write_text(text, encoding="ascii")
        (folder / name).chmod(0o600)
        command += [f"--{option}", name]
    command += ["--record", "record.csv"]
    return command, subprocess.run(command, cwd=folder, check=False,
                                   capture_output=True, text=True)


def findings_in_mix(mix, folder):
    """The checksum lets wrong blocks through, the seal none."""
    findings = findings_in(folder, mix.schedule, mix.drift,
                           "--lock" in mix.options)
    return findings._replace(violations=findings.violations + [
        f"sealed, and yet: {what}" for what in findings.wrong_blocks
        if "key" in mix.files])


def run_mixes(name, message_format):
    """A shard of random mixes: only what the safety monitor says counts."""
    _, first, stop = name.split("/")
    result = new_result(name)
    with tempfile.TemporaryDirectory(prefix="urv-campaign-") as folder:
        folder = Path(folder)
        for number in range(int(first), int(stop)):
            result["cases"] += 1
            mix = mixes.of_number(number, message_format)
            _, flown = fly_mix(mix, folder)
            if flown.returncode != 0:
                result["failures"].append(
                    f"mix {number}: status {flown.returncode}:"
                    f" {flown.stderr.strip()}")
                continue
            findings = findings_in_mix(mix, folder)
            result["frames"] += findings.rows
            result["faults"] += len(
                (folder / "faults.txt").read_text().splitlines())
            result["wrong"] += len(findings.wrong_blocks)
            result["failures"] += [f"mix {number}: {what}"
                                   for what in findings.violations]
    return result


def show_mix(number, folder, message_format=1):
    folder.mkdir(parents=True, exist_ok=True)
    mix = mixes.of_number(number, message_format)
    command, flown = fly_mix(mix, folder)
    print(f"cd {folder}\n{' '.join(command)}", flush=True)
    if flown.returncode != 0:
        print(flown.stderr.strip())
        return 1
    findings = findings_in_mix(mix, folder)
    for line in (*findings.violations, *findings.wrong_blocks):
        print(line)
    print(f"mix {number}: {len(findings.violations)} violations,"
          f" {len(findings.wrong_blocks)} wrong blocks passed")
    return 1 if findings.violations else 0


def new_result(name):
    return {"shard": name, "cases": 0, "frames": 0, "faults": 0,
            "recovered_within": [0] * (checker.LONGEST + 1), "wrong": 0,
            "refused": 0, "came_twice": 0, "wrong_by_theory": 0.0,
            "failures": []}


def run_shard(name, message_format=1):
    group = name.split("/")[0]
    if group == "mix":
        return run_mixes(name, message_format)
    phase, seed, made = cases.of_shard(name)
    starts = [cases.LEAD]
    for case in made:
        starts.append(starts[-1] + case.frames)
    frames = starts[-1]
    result = new_result(name) | {
        "cases": len(made), "frames": frames,
        "faults": sum(fault.duration_us != 0
                      for case in made for fault in case.faults)}
    failures = result["failures"]

    with tempfile.TemporaryDirectory(prefix="urv-campaign-") as folder:
        folder = Path(folder)
        flown = fly(folder, phase, seed, frames, "".join(
            f"{line}\n" for case, first in zip(made, starts, strict=False)
            for line in lines_of(case, first)), message_format)
        if flown.returncode != 0:
            failures.append(f"{name}: status {flown.returncode}:"
                            f" {flown.stderr.strip()}")
            return result
        flight = checker.Flight(
            folder / "record.csv", folder / "wire.csv", frames,
            message_format, phase)
        refused = refused_in(folder)
        failures += [f"{name}: {what}"
                     for what in findings_in(folder).violations]

    # A board that starts again breaks its message off, so that the messages on
    # the wire cannot be separated and counted.
    failures += [f"{name}: {error}" for error in flight.errors]
    if group not in ("reset", "start"):
        failures += [f"{name}: {error}" for error in flight.wire_errors]
        result["came_twice"] = flight.came_twice
    result["refused"] = refused - result["came_twice"]
    if result["refused"] < 0 or (
            result["refused"] > 0 and group not in CHANCE):
        failures.append(f"{name}: {refused} blocks refused,"
                        f" {result['came_twice']} came twice")
    flight.learn_lags(cases.LEAD - 1)
    if any(not flight.is_calm(frame)
           for frame in range(cases.LEAD // 2, cases.LEAD)):
        failures.append(f"{name}: not calm before the first case")

    # In the order of the frames they were seen in.
    wrong = list(flight.wrong)
    result["wrong"] = len(wrong)
    result["wrong_by_theory"] = by_theory(name, flight)
    bound = checker.BOUNDS.get(group, checker.LINK_BOUND)
    for case, first, stop in zip(made, starts, starts[1:], strict=False):
        took = flight.recovery(case, first, stop)
        what = "; ".join(lines_of(case, first))
        if took is None or took > bound:
            failures.append(f"{name}: {what}: recovered after {took} frames")
        else:
            result["recovered_within"][took] += 1
        while wrong and wrong[0].frame < stop:
            block = wrong.pop(0)
            if len(case.faults) == 1 or message_format == 2:
                failures.append(f"{name}: {what}: wrong data {block}")
    return result


# The checksum may let a wrong block of these through.
CHANCE = ("many", "soak")


def too_many(count, expected):
    """More than chance explains, but for once in a million."""
    return count > expected + 5 * math.sqrt(expected) + 3


def report(results, size, seconds, message_format=1):
    groups = {}
    for result in results:
        parts = result["shard"].split("/")
        group = parts[0] + (f" ber {parts[3]}" if parts[0] == "soak" else "")
        total = groups.setdefault(group, {
            "shards": 0, "cases": 0, "faults": 0, "frames": 0,
            "recovered_within": [0] * (checker.LONGEST + 1), "wrong": 0,
            "refused": 0, "came_twice": 0, "wrong_by_theory": 0.0,
            "failures": []})
        total["shards"] += 1
        for name in ("cases", "faults", "frames", "wrong", "refused",
                     "came_twice", "wrong_by_theory", "failures"):
            total[name] += result[name]
        total["recovered_within"] = [
            a + b for a, b in zip(total["recovered_within"],
                                  result["recovered_within"], strict=True)]
    failures = []
    for group, total in groups.items():
        failures += total["failures"]
        # How often the checksum is put to the test in a mix nobody knows.
        passed = total["wrong"] + total["refused"]
        if group != "mix" and too_many(passed, total["wrong_by_theory"]):
            failures.append(f"{group}: {passed} wrong blocks, about"
                            f" {total['wrong_by_theory']:.1f} expected")

    columns = ["cases", "faults", "frames", "after 0",
               *map(str, range(1, checker.LONGEST)),
               f"{checker.LONGEST} frames", "wrong", "refused",
               "came twice", "by theory", "failures"]
    table = [["", *columns]]
    for group, total in groups.items():
        table.append([group, total["cases"], total["faults"],
                      total["frames"], *total["recovered_within"],
                      total["wrong"], total["refused"], total["came_twice"],
                      f"{total['wrong_by_theory']:.1f}",
                      len(total["failures"])])
    sums = [sum(float(row[n]) for row in table[1:])
            for n in range(1, len(columns) + 1)]
    table.append(["all"] + [
        f"{total:.{1 if name == 'by theory' else 0}f}"
        for name, total in zip(columns, sums, strict=True)])

    from urv import whole_files

    RESULTS.mkdir(exist_ok=True)
    with whole_files.replacing(RESULTS / "results.csv") as path, path.open(
            "w", newline="", encoding="utf-8") as out:
        csv.writer(out).writerows(table)
    with whole_files.replacing(RESULTS / "summary.json") as path:
        path.write_text(json.dumps(
            {"size": size, "format": message_format,
             "wall_seconds": round(seconds), "groups": groups,
             "failures": failures}, indent=1) + "\n", encoding="utf-8")

    widths = [max(len(str(row[n])) for row in table)
              for n in range(len(table[0]))]
    for row in table:
        print("  ".join(
            str(cell).ljust(width) if n == 0 else str(cell).rjust(width)
            for n, (cell, width) in enumerate(zip(row, widths, strict=True))))
    for failure in failures[:50]:
        print(f"FAILED {failure}")
    if len(failures) > 50:
        print(f"... and {len(failures) - 50} more, see campaign/summary.json")
    print(f"{size}: {table[-1][2]} faults, {len(failures)} failures,"
          f" {seconds:.0f} s")
    return 1 if failures else 0


def planned(size, only=None):
    """The names of the shards, of some groups only if so wanted."""
    return [name for name in cases.plan(size)
            if not only or name.split("/")[0] in only]


def is_shard(name):
    """True if it is the name of a shard, of any size."""
    group, *rest = name.split("/")
    try:
        if group == "mix":
            first, stop = map(int, rest)
            return 0 <= first < stop
        return bool(cases.of_shard(name)[2])
    except (ValueError, IndexError):
        return False


def result_of(name, message_format):
    """A shard's result; one that ends with an exception has failed."""
    try:
        return run_shard(name, message_format)
    except Exception as fault:  # noqa: BLE001 - whatever a shard meets
        return new_result(name) | {
            "failures": [f"{name}: no result: {fault!r}"]}


def run_campaign(size, jobs, message_format=1, only=None):
    from urv import progress

    names = planned(size, only)
    began = time.monotonic()
    results = {}
    with progress.bar("flying") as told, \
            concurrent.futures.ProcessPoolExecutor(jobs) as pool:
        wanted = [pool.submit(result_of, name, message_format)
                  for name in names]
        try:
            for done in concurrent.futures.as_completed(wanted):
                result = done.result()
                results[result["shard"]] = result
                told(SimpleNamespace(size=len(names), position=len(results)))
        except KeyboardInterrupt:
            pool.shutdown(wait=False, cancel_futures=True)
            return 130
    return report([results[name] for name in names], size,
                  time.monotonic() - began, message_format)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("size", choices=[*cases.SIZES, "shard", "mix"])
    parser.add_argument("name", nargs="?",
                        help="of the shard, or number of the mix")
    parser.add_argument("folder", nargs="?", type=Path, help="for the mix")
    parser.add_argument("--jobs", type=whole(1), default=os.cpu_count() or 1,
                        help="at once")
    parser.add_argument("--format", type=int, choices=(1, 2), default=1,
                        help="of the messages; 2 is sealed")
    parser.add_argument("--only", metavar="GROUPS",
                        help="of the shards, with commas between them")
    given = parser.parse_args()
    if (given.size in ("shard", "mix")) != (given.name is not None):
        parser.error("a shard, and only a shard, has a name; a mix a number")
    if (given.size == "mix") != (given.folder is not None):
        parser.error("a mix, and only a mix, has a folder")
    if given.size == "mix":
        if not given.name.isdecimal():
            parser.error(f"a mix's number is a whole one, not {given.name!r}")
        return show_mix(int(given.name), given.folder, given.format)
    if given.size == "shard":
        if not is_shard(given.name):
            parser.error(f"no such shard: {given.name}; one is calm/3/200")
        result = run_shard(given.name, given.format)
        print(json.dumps(result), flush=True)
        return 1 if result["failures"] else 0
    # A termination ends the workers, too, as Ctrl-C does.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    only = given.only.split(",") if given.only else None
    unknown = set(only or ()) - {
        name.split("/")[0] for name in cases.plan(given.size)}
    if unknown:
        parser.error(f"no such group: {', '.join(sorted(unknown))}")
    from urv import faults
    try:
        return run_campaign(given.size, given.jobs, given.format, only)
    except OSError as fault:
        print(f"{given.size}: {fault.filename or RESULTS}:"
              f" {faults.reason(fault)}", file=sys.stderr)
        return 1


if __name__ == "__main__":
    sys.exit(main())

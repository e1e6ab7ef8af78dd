#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Flies both real-time partitions over UDP, as an ordinary user, beside
cyclictest, and says how timely they were (EVI-9).

    evidence/timing.py --seconds 600 [--renew]

Prints, and with --renew writes into docs/evidence/timing.md: what each transaction
costs, the response time of each minor frame computed from that and measured,
how late the nodes' clocks ticked beside what cyclictest measured meanwhile,
frames lost, overruns, the latency from the console to the servos, and whether
the machine paused whenever something was late.

Started as root it runs the partitions as user and group 65534; only root may
run cyclictest and watch for pauses. Exit status 1 when something was late and
the machine had not paused.
"""

import argparse
import bisect
import csv
import json
import os
import random
import re
import shutil
import socket
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "scripts"))

import ada_source  # noqa: E402
from flight_numbers import NUMBERS  # noqa: E402
from machine_pauses import (  # noqa: E402
    Pauses, Watchers, SHORTEST_US)
from whole_numbers import whole  # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
DOCUMENT = ROOT / "docs" / "evidence" / "timing.md"
BEGIN, END = "<!-- make -C evidence timing -->\n", "<!-- end -->\n"

NOBODY = 65534
PERIOD_US = NUMBERS.tick_us
FRAME_US = NUMBERS.frame_us
PHASE = 3

# docs/design.md: from the scan, and a change waits a frame for its scan.
LATENCY_MS = (2 * PHASE + 44, 2 * PHASE + 64 + 0.2)

# A scan or a PWM task that is a little late is no pause yet.
LENIENCY_MS = 1

# After a disturbance the commands follow again within so much (docs/evidence/link.md).
RECOVERY_US = 3 * FRAME_US

LINK_ERRORS = {
    "mcs": ("link.uplink_bad", "link.downlink_scrapped", "link.mcs_resets"),
    "gsc": ("link.downlink_bad", "link.uplink_scrapped", "link.gsc_resets"),
}

# A change of the stick at a time of its own in the frame, seldom enough for
# each to come through.
CHANGE_US = 213_700



def offsets(node):
    """The minor frame of each task's release in the report's schedule."""
    code = ada_source.code_of(
        (ROOT / "src" / "nodes" / f"{node}.ads").read_text(encoding="utf-8"))
    return {name.lower(): int(offset) for name, offset in re.findall(
        r"\b(\w+) => \(Report => \((\d+)", code)}


def ordinary_user():
    """Options that make a command run as an ordinary user."""
    if os.getuid() != 0:
        return []
    who = [f"--reuid={NOBODY}", f"--regid={NOBODY}", "--clear-groups"]
    return ["setpriv", *who]


def free_ports():
    sockets = [
        socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2)
    ]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def write_sticks(path, seconds):
    """Changes of the roll stick, their times and words."""
    words = random.Random(1)
    changes, last = [], 0x800
    at_us = 1_000_000
    while at_us < (seconds - 1) * 1_000_000:
        word = last
        while word == last:
            word = words.randrange(0x1000)
        changes.append((at_us, word))
        last = word
        at_us += CHANGE_US
    lines = [f"{at / 1000:.3f},{word}" for at, word in changes]
    path.write_text("\n".join(["time_ms,roll", *lines]) + "\n", "utf-8")
    return changes


def cyclictest(seconds, result):
    """cyclictest with the nodes' period and policy, or None."""
    if not shutil.which("cyclictest") or os.getuid() != 0:
        return None
    return subprocess.Popen(
        ["cyclictest", "--quiet", "--threads=1", f"--interval={PERIOD_US}",
         "--policy=other", f"--duration={seconds}", "--histogram=50000",
         f"--json={result}"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )


def quantile(histogram, share):
    wanted = share * sum(histogram.values())
    passed = 0
    for value in sorted(histogram):
        passed += histogram[value]
        if passed >= wanted:
            return value
    return max(histogram)


def read_cyclictest(path):
    thread = json.loads(path.read_text("utf-8"))["thread"]["0"]
    histogram = {int(us): n for us, n in thread["histogram"].items()}
    return {
        "min": thread["min"], "median": quantile(histogram, 0.5),
        "p99": quantile(histogram, 0.99), "max": thread["max"],
    }


def fly(folder, seconds):
    """The changes of the stick, the summaries and records of one flight, what
    cyclictest measured and when the machine paused; None for what only root
    may find out."""
    for program in ("urv_mcs", "urv_gsc"):
        shutil.copy2(ROOT / "bin" / program, folder)
    sticks = folder / "sticks.csv"
    changes = write_sticks(sticks, seconds)
    folder.chmod(0o777)

    up, down = free_ports()
    runs = {}
    watchers = Watchers(seconds + 1) if os.getuid() == 0 else None
    test = cyclictest(seconds, folder / "cyclictest.json")
    for node, own, other, options in (
        ("mcs", up, down, ["--phase", str(PHASE)]),
        ("gsc", down, up, ["--phase", "0", "--sticks", sticks]),
    ):
        runs[node] = subprocess.Popen(
            [*ordinary_user(), folder / f"urv_{node}",
             "--link", f"udp:127.0.0.1:{own}:127.0.0.1:{other}",
             "--seconds", str(seconds), "--quiet",
             "--record", folder / f"{node}.csv",
             "--summary", folder / f"{node}.json", *options],
            cwd=folder,
        )
    for node, run in runs.items():
        if run.wait() != 0:
            sys.exit(f"timing: urv_{node} ended with {run.returncode}")
    if test:
        test.wait()

    summaries = {
        node: json.loads((folder / f"{node}.json").read_text("utf-8"))
        for node in runs
    }
    records = {}
    for node in runs:
        with (folder / f"{node}.csv").open(encoding="utf-8") as file:
            records[node] = [
                {name: int(value) for name, value in row.items()}
                for row in csv.DictReader(file)
            ]
    machine = None
    if test and test.returncode == 0:
        machine = read_cyclictest(folder / "cyclictest.json")
    pauses = watchers.result() if watchers else None
    return changes, summaries, records, machine, pauses


def ways_of(changes, summaries, records):
    """For each change of the stick: its time, and the time when the servos had
    it, or, if they never did, that of the next change."""
    began = summaries["gsc"]["switched_on_us"]
    rows = records["mcs"]
    times = [row["servos_us"] for row in rows]
    found = []
    for at_us, word in changes:
        made = began + at_us
        within = rows[bisect.bisect_right(times, made):
                      bisect.bisect_right(times, made + CHANGE_US)]
        found.append((made, next(
            (row["servos_us"] for row in within
             if row["pwm.left_aileron"] == word), made + CHANGE_US)))
    return found


def latency_ms(way):
    made, there = way
    return (there - made) / 1000


def is_in_bounds(way):
    least, most = LATENCY_MS
    return least - LENIENCY_MS <= latency_ms(way) <= most + LENIENCY_MS


def increases(rows, *columns):
    """Between which rows a count went up, and by how much."""
    for before, after in zip(rows, rows[1:]):
        more = sum(after[name] - before[name] for name in columns)
        if more > 0:
            yield before, after, more


def lost_rows(rows):
    for before, after in zip(rows, rows[1:]):
        missing = after["frame"] - before["frame"] - 1
        if missing > 0:
            yield before, after, missing


def deviations(ways, records):
    """Whatever was late, lost or disturbed: by its kind a list of how many,
    and from when until when something must have happened for it."""
    found = {
        "frames without a row": [], "overruns": [],
        "link errors": [], "changes not within the bounds": [],
    }
    for node, rows in records.items():
        for kind, places, before_us in (
            ("frames without a row", lost_rows(rows), 0),
            ("overruns", increases(rows, "overruns"), FRAME_US),
            ("link errors", increases(rows, *LINK_ERRORS[node]), FRAME_US),
        ):
            found[kind] += [
                (number, before["clock_us"] - before_us, after["clock_us"])
                for before, after, number in places
            ]
    found["changes not within the bounds"] = [
        (1, made - RECOVERY_US, there)
        for made, there in ways if not is_in_bounds((made, there))
    ]
    return found


def count_explained(places, pauses, later_us=0):
    return sum(
        number for number, begin, end in places
        if pauses.within(begin + later_us, end + later_us)
    )


def pause_table(found, pauses):
    rows = []
    for kind, places in found.items():
        number = sum(place[0] for place in places)
        rows.append([
            kind, number, count_explained(places, pauses),
            count_explained(places, pauses, later_us=1_000_000),
        ])
    return table(
        ["", "number", "with a pause", "with one exactly 1 s later"], rows
    )


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(
        "| " + " | ".join(map(str, line)) + " |" for line in lines
    ) + "\n"


def numbers(statistics):
    return [f"{statistics[name]:g}" for name in ("min", "median", "p99",
                                                 "max")]


def cost_table(summaries):
    rows = []
    for node, summary in summaries.items():
        for task, cost in summary["cost_us"].items():
            rows.append([node, task.removesuffix("_task"), *numbers(cost)])
    return table(["node", "task", "min", "median", "p99", "max"], rows)


def response_table(summaries):
    """The response time of a minor frame: the clock's lateness and all its
    tasks one after another, for nobody preempts anybody. The rest of the
    medians is the cost of a switch from task to task."""
    rows = []
    for node, summary in summaries.items():
        cost, response = summary["cost_us"], summary["response_us"]
        jitter = summary["release_jitter_us"]
        released = offsets(node)
        for minor in sorted(set(released[task] for task in cost)):
            tasks = [task for task in cost if released[task] == minor]
            last = response[tasks[-1]]
            row = [node, minor,
                   ", ".join(task.removesuffix("_task") for task in tasks)]
            for share in ("median", "p99", "max"):
                row.append(round(
                    jitter[share] + sum(cost[task][share] for task in tasks)
                ))
            row += [round(last[share]) for share in ("median", "p99", "max")]
            rows.append(row)
    return table(
        ["node", "minor frame", "tasks", "computed median", "p99", "worst",
         "measured median", "p99", "max"], rows,
    )


def lateness_table(summaries, machine):
    rows = [
        [f"clock of {node}", *numbers(summary["release_jitter_us"])]
        for node, summary in summaries.items()
    ]
    if machine:
        rows.append(["cyclictest", *numbers(machine)])
    return table(["", "min", "median", "p99", "max"], rows)


def flight_table(summaries, records, ways):
    mcs, gsc = records["mcs"], records["gsc"]
    frames = summaries["gsc"]["frames"]
    rows = [
        ["major frames", frames],
        ["without a row in the record, mcs and gsc",
         f"{summaries['mcs']['frames'] - 1 - len(mcs)} and "
         f"{frames - 1 - len(gsc)}"],
        ["overruns, mcs and gsc",
         f"{summaries['mcs']['overruns']} and "
         f"{summaries['gsc']['overruns']}"],
        ["uplinks sent, received, bad, scrapped",
         f"{gsc[-1]['link.uplink_sent']}, {mcs[-1]['link.uplink_received']}, "
         f"{mcs[-1]['link.uplink_bad']}, {gsc[-1]['link.uplink_scrapped']}"],
        ["downlinks sent, received, bad, scrapped",
         f"{mcs[-1]['link.downlink_sent']}, "
         f"{gsc[-1]['link.downlink_received']}, "
         f"{gsc[-1]['link.downlink_bad']}, "
         f"{mcs[-1]['link.downlink_scrapped']}"],
        ["dead space resets, mcs and gsc",
         f"{mcs[-1]['link.mcs_resets']} and {gsc[-1]['link.gsc_resets']}"],
    ]
    latencies = sorted(map(latency_ms, ways))
    if latencies:
        middle = latencies[len(latencies) // 2]
        nearly = latencies[len(latencies) * 99 // 100]
        rows.append([
            f"console to servos, ms, of {len(latencies)} changes",
            f"{latencies[0]:.1f} least, {middle:.1f} median, "
            f"{nearly:.1f} p99, {latencies[-1]:.1f} most",
        ])
        inside = sum(map(is_in_bounds, ways))
        rows.append([
            f"of them within {LATENCY_MS[0]} to {LATENCY_MS[1]} ms, "
            f"give or take {LENIENCY_MS}",
            f"{inside}",
        ])
    return table(["", ""], rows)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--seconds", type=whole(5), default=20)
    options.add_argument("--renew", action="store_true")
    chosen = options.parse_args()
    with tempfile.TemporaryDirectory(prefix="urv-timing-") as name:
        changes, summaries, records, machine, pauses = fly(
            Path(name), chosen.seconds
        )
    ways = ways_of(changes, summaries, records)

    text = (
        f"{chosen.seconds} s over UDP, {os.cpu_count()} processors, "
        f"load {os.getloadavg()[0]:.1f}. Times in us unless the text says ms.\n\n"
        "Duration of a transaction:\n\n" + cost_table(summaries)
        + "\nUntil the last task of a minor frame has ended, after its tick;"
        f" {PERIOD_US} are allowed:\n\n" + response_table(summaries)
        + "\nHow late the clocks ticked:\n\n"
        + lateness_table(summaries, machine)
        + "\nThe flight:\n\n" + flight_table(summaries, records, ways)
    )
    unexplained = 0
    if pauses is not None:
        found, known = deviations(ways, records), Pauses(pauses)
        text += (
            f"\nThe machine paused {len(pauses)} times for {SHORTEST_US} us or"
            f" more, {known.longest} at the most. Deviations:\n\n"
            + pause_table(found, known)
        )
        unexplained = sum(
            sum(place[0] for place in places)
            - count_explained(places, known)
            for places in found.values()
        )
    print(text)
    if machine is None:
        print("cyclictest did not run: it needs rt-tests, and root")
    if pauses is None:
        print("pauses of the machine were not recorded: that needs root")
    if unexplained:
        print(f"timing: {unexplained} of these without a pause of the machine")
    if chosen.renew:
        before, _, rest = DOCUMENT.read_text("utf-8").partition(BEGIN)
        _, _, after = rest.partition(END)
        DOCUMENT.write_text(before + BEGIN + text + END + after, "utf-8")
    return 1 if unexplained else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the proof hangs on a prover (EVI-6): each of them alone.

    scripts/provers.py [--renew] [--jobs N] [--minutes N] [UNIT ...]
        Proves src and proofs, or these units, without the sessions, in a
        copy: once with CVC4 only, once with Z3 only, 10 s a goal.

A goal may take as long as it takes in `make prove`, where a step is a step on
any machine; here time is limited, so the figures are of one machine. --renew
writes the result of those that are done into docs/evidence/provers.md.

A run of all takes an hour or more. With --minutes it ends after so many, and
goes on where it stopped when it is called again; of what has changed since
then it begins anew. A goal that was not found is tried again only when it has
changed, or without obj/provers: what a busy machine left stays left.
Exit status: 0 each proves every run-time check and 99.7 % of all; 1 not, or not
yet.
"""

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import NamedTuple

import proof_canaries
import proof_record

ROOT = Path(__file__).resolve().parent.parent
COPY = ROOT / "obj" / "provers"
PAGE = ROOT / "docs" / "evidence" / "provers.md"
BEGIN, END = "<!-- make independence -->\n", "<!-- end -->\n"

PROVERS = {"CVC4": "cvc4", "Z3": "z3"}
SWITCHES = ("--timeout=10", "--steps=0", "--counterexamples=off",
            "--report=fail")
LEAST_PERCENT = 99.7

RUN_TIME = {f"VC_{kind}" for kind in (
    "DIVISION_CHECK", "INDEX_CHECK", "OVERFLOW_CHECK", "FP_OVERFLOW_CHECK",
    "RANGE_CHECK", "LENGTH_CHECK", "DISCRIMINANT_CHECK", "TAG_CHECK",
    "PREDICATE_CHECK", "PREDICATE_CHECK_ON_DEFAULT_VALUE",
    "NULL_EXCLUSION", "RAISE", "UNCHECKED_CONVERSION")}


class Check(NamedTuple):
    unit: str
    line: int
    column: int
    subprogram: str
    kind: str


class Result(NamedTuple):
    """How many checks of each kind a prover had, and those it left, by how
    many instances."""

    kinds: Counter
    left: Counter


def project_for(prover, text):
    """The project with this prover only, and its sessions nowhere kept."""
    given = ", ".join(f'"{switch}"'
                      for switch in (f"--prover={prover}", *SWITCHES))
    package = ("package Prove is\n"
               f'      for Proof_Switches ("Ada") use ({given});\n'
               "   end Prove;")
    changed, number = re.subn(r"package Prove is.*?end Prove;", package, text,
                              flags=re.S)
    if number != 1:
        sys.exit("provers: urv.gpr has no package Prove")
    return changed


def prepare(prover):
    """The copy, with the sources as they are now: what hangs on none that has
    changed stays proved."""
    folder = COPY / prover
    wanted = {
        name: (ROOT / name).read_text(encoding="utf-8")
        for name in (*proof_record.sources(ROOT), proof_record.CONFIGURATION)}
    project = project_for(
        prover, (ROOT / proof_record.PROJECT).read_text(encoding="utf-8"))
    present = folder / proof_record.PROJECT
    if (not present.exists()
            or present.read_text(encoding="utf-8") != project):
        shutil.rmtree(folder, ignore_errors=True)
    for name, path in proof_record.sources(folder).items():
        if name not in wanted:
            path.unlink()
            unit = Path(name).with_suffix(".spark").name
            (folder / proof_record.RESULTS / unit).unlink(missing_ok=True)
    for name, text in {**wanted, proof_record.PROJECT: project}.items():
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
    return folder


def ended_in_time(command, folder, minutes):
    """What a command says, or nothing if it was ended with all it began."""
    with subprocess.Popen(
            command, cwd=folder, env=proof_canaries.ENVIRONMENT, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            start_new_session=True) as running:
        try:
            return running.communicate(timeout=minutes and 60 * minutes)[0]
        except subprocess.TimeoutExpired:
            os.killpg(running.pid, signal.SIGTERM)
            return None


def result_of(results, units):
    """From what GNATprove has to say of each unit."""
    result = Result(Counter(), Counter())
    for found in results:
        for check in [*found.get("flow", []), *found.get("proof", [])]:
            result.kinds[check["rule"]] += 1
            if check["severity"] != "info":
                result.left[Check(
                    units.get(check["file"], check["file"]), check["line"],
                    check["col"], check["entity"]["name"],
                    check["rule"])] += 1
    return result


def prove(prover, jobs, wanted, minutes=None):
    """The result, or nothing when the time was up before."""
    folder = prepare(prover)
    command = ["gnatprove", "-P", proof_record.PROJECT,
               "-XURV_Mode=flight", f"-j{jobs}", "-k"]
    if wanted:
        command += ["-u", *wanted]
    said = ended_in_time(command, folder, minutes)
    if said is None:
        return None
    asked = {Path(unit).stem for unit in wanted}
    files = [path for path in sorted(
        (folder / proof_record.RESULTS).glob("*.spark"))
        if not asked or path.stem in asked]
    if not files or " error: " in said:
        sys.exit(f"provers: {said}")
    units = {path.name: proof_record.unit_of(name)
             for name, path in proof_record.sources(folder).items()}
    return result_of(
        (json.loads(path.read_text(encoding="utf-8")) for path in files),
        units)


def share(all_of, left):
    return 100 * (all_of - left) / all_of if all_of else 100.0


def figures(result):
    """Checks and those proved, of all and of the run-time ones."""
    of_all = result.kinds.total()
    at_run_time = sum(result.kinds[kind] for kind in RUN_TIME)
    left_at_run_time = sum(number for check, number in result.left.items()
                           if check.kind in RUN_TIME)
    return of_all, result.left.total(), at_run_time, left_at_run_time


def is_well(result):
    of_all, left, _, left_at_run_time = figures(result)
    return left_at_run_time == 0 and share(of_all, left) >= LEAST_PERCENT


def shown_kind(kind):
    return kind.removeprefix("VC_").lower().replace("_", " ")


def tables(results):
    """What each proves, and what only one of them does."""
    lines = ["| alone | checks | proved | | run-time checks | proved |",
             "|---|--:|--:|--:|--:|--:|"]
    for name, result in results.items():
        of_all, left, at_run_time, left_then = figures(result)
        percent = int(100 * share(of_all, left)) / 100
        lines.append(f"| {name} | {of_all} | {of_all - left} | {percent} % |"
                     f" {at_run_time} | {at_run_time - left_then} |")
    lines += ["", f"| unit | line | of | check | {' | '.join(results)} |",
              "|---|--:|---|---|" + "---|" * len(results)]
    for check in sorted(set().union(*(r.left for r in results.values()))):
        cells = ["not" if check in result.left else "proved"
                 for result in results.values()]
        lines.append(
            f"| `{check.unit}` | {check.line} | `{check.subprogram}` |"
            f" {shown_kind(check.kind)} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def renew(text):
    page = PAGE.read_text(encoding="utf-8")
    before, _, rest = page.partition(BEGIN)
    _, _, after = rest.partition(END)
    PAGE.write_text(before + BEGIN + text + END + after, encoding="utf-8")


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    options.add_argument("--renew", action="store_true")
    options.add_argument("--jobs", type=int, default=2)
    options.add_argument("--minutes", type=float)
    options.add_argument("units", nargs="*", metavar="UNIT")
    chosen = options.parse_args()
    if chosen.renew and chosen.units:
        options.error("the page has the result of all units")
    if not shutil.which("gnatprove"):
        print("provers: gnatprove is not on the PATH, nothing proved")
        return 0
    results = {name: prove(prover, chosen.jobs, chosen.units, chosen.minutes)
               for name, prover in PROVERS.items()}
    late = [name for name, result in results.items() if result is None]
    done = {name: result for name, result in results.items() if result}
    text = tables(done) if done else ""
    for name in late:
        text += f"\n{name}: not yet run over everything.\n"
    print(text, end="")
    if chosen.renew and done:
        renew(text)
    if late:
        print(f"provers: {' and '.join(late)} not done in {chosen.minutes:g} "
              "minutes; the next run goes on from here")
        return 1
    return 0 if all(map(is_well, results.values())) else 1


if __name__ == "__main__":
    sys.exit(main())

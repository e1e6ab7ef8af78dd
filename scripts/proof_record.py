#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove the flight software, and keep the record of the proof (EVI-8).

  prove    runs GNATprove; when all is proved, renews proofs/record.json
  check    runs GNATprove too, and compares the result with the record
  sources  compares only the hash of the sources with the record's

Nothing is stored but the record: in a fresh clone GNATprove proves from
nothing. In the same tree it analyses again only the units that changed.

Proved means: no check unproved or justified, no pragma Assume, no error or
warning of the analysis, every source of src and proofs analysed as SPARK,
and no false claim of proofs/canaries proved.
Exit status: 0 yes; 1 no, with a line for each reason.
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
from collections import Counter
from hashlib import sha256
from pathlib import Path

import ada_source
import proof_canaries

ROOT = Path(__file__).resolve().parent.parent
RECORD = Path("proofs", "record.json")
PROJECT = "urv.gpr"
CONFIGURATION = "src/kernel/ravenscar.adc"
BUS = "devices-memory_bus.adb"
COMMAND = ["gnatprove", "-P", PROJECT, "-XURV_Mode=flight", "-j0", "-k",
           "--checks-as-errors", "--warnings=error"]
RESULTS = Path("obj", "flight", "gnatprove")

# GNATprove's own program for each unit is written in OCaml. It is faster when
# it collects its garbage late and has its memory in large pages.
ENVIRONMENT = {"OCAMLRUNPARAM": "o=1000000,i=16M",
               "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1"}


def sources(root):
    return sorted(ada_source.sources(root, "src", "proofs"))


def sources_hash(root):
    """One hash of every file that decides what is proved, and how."""
    files = [*sources(root), root / PROJECT, root / CONFIGURATION,
             *sorted((root / proof_canaries.FOLDER).glob("*.*"))]
    lines = (f"{sha256(path.read_bytes()).hexdigest()}  "
             f"{path.relative_to(root).as_posix()}\n" for path in files)
    return sha256("".join(lines).encode()).hexdigest()


def tool_versions():
    """Versions of GNATprove and of the tools that it calls."""
    text = subprocess.run(
        ["gnatprove", "--version"], capture_output=True, text=True, check=True
    ).stdout
    called = re.findall(
        r"^(?:.*/)?(Why3|[\w-]+(?=:)).*? (?i:version) (\S+)", text, re.M)
    return {"gnatprove": text.splitlines()[0].strip(), **dict(called)}


class Judgement:
    """Failures in the results of GNATprove, and the sums of its checks."""

    def __init__(self, root):
        self.paths = {path.name: path for path in sources(root)}
        self.failures = []
        self.checks = Counter()
        self.goals = Counter()
        units = {path.stem for path in self.paths.values()}
        analysed = set()
        for path in sorted((root / RESULTS).glob("*.spark")):
            # Results of removed units stay in the folder.
            if path.stem in units:
                found = json.loads(path.read_text(encoding="utf-8"))
                analysed |= self.read(found)
        self.failures += [f"{unit}: not analysed"
                          for unit in sorted(units - analysed)]

    def read(self, results):
        """Judge the results of one unit; return the units analysed."""
        analysed = set()
        for entity in results.get("spark", []):
            if entity["spark"] == "all":
                analysed |= {Path(at["file"]).stem for at in entity["sloc"]}
            elif not all(map(self.needs_no_body, entity["sloc"])):
                self.failures.append(f"{entity['name']}: not all in SPARK")
        for at in results.get("pragma_assume", []):
            self.failures.append(f"{at['file']}:{at['line']}: pragma Assume")
        for check in [*results.get("flow", []), *results.get("proof", [])]:
            place = "{file}:{line}:{col}: {rule}".format(**check)
            if "suppressed" in check:
                self.failures.append(f"{place} justified, not proved")
            elif check["severity"] != "info":
                self.failures.append(f"{place} {check['severity']}")
            self.checks[check["rule"]] += 1
            for prover, stats in check.get("stats", {}).items():
                self.goals[prover] += stats["count"]
        return analysed

    def needs_no_body(self, place):
        """A null procedure has no body to prove, nor has a cycle on the
        boards' bus, which is imported."""
        path = self.paths[place["file"]]
        lines = path.read_text(encoding="utf-8").splitlines()
        return ada_source.is_whole_declaration(
            "\n".join(lines[place["line"] - 1:]), imported=path.name == BUS)


def proof(root):
    """Run GNATprove over everything and judge its results."""
    environment = {**ENVIRONMENT, **os.environ}
    status = subprocess.run(
        COMMAND, cwd=root, env=environment, check=False).returncode
    judged = Judgement(root)
    if status != 0:
        judged.failures.append(f"gnatprove ended with {status}")
    if not judged.failures:
        judged.failures += proof_canaries.failures(root, environment)
    return judged


def record_of(root, judged):
    return {
        "command": COMMAND,
        "versions": tool_versions(),
        "sources": sources_hash(root),
        "checks": judged.checks.total(),
        "checks_by_kind": dict(sorted(judged.checks.items())),
        "goals_by_prover": dict(sorted(judged.goals.items())),
    }


def differences(root, command):
    """Reasons why the command fails."""
    renew = "renew the record with: make prove"
    record = {}
    if command != "prove":
        if not (root / RECORD).exists():
            return [f"{RECORD} is missing; {renew}"]
        record = json.loads((root / RECORD).read_text(encoding="utf-8"))
        if record["sources"] != sources_hash(root):
            return [f"the sources have changed since {RECORD}; {renew}"]
    if command == "sources":
        print("proof: the record is of these sources")
        return []
    if not shutil.which("gnatprove"):
        return ["gnatprove is not on the PATH"]
    judged = proof(root)
    if judged.failures:
        return judged.failures
    print(f"proof: {judged.checks.total()} checks, all proved")
    if command == "prove":
        (root / RECORD).write_text(
            json.dumps(record_of(root, judged), indent=1) + "\n",
            encoding="utf-8")
    elif record["checks_by_kind"] != judged.checks:
        return [f"other checks than in {RECORD}: {dict(judged.checks)}; "
                f"{renew}"]
    return []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=("prove", "check", "sources"))
    reasons = differences(ROOT, parser.parse_args().command)
    for reason in reasons:
        print(f"proof: {reason}")
    return 1 if reasons else 0


if __name__ == "__main__":
    sys.exit(main())

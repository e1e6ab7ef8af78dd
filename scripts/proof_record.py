#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prove the flight software, and keep the record of what was proved (EVI-8).

  prove    runs GNATprove; with everything proved, renews proofs/record.json
  sources  compares the hash of each source with the record's
  check    the same; where GNATprove is on the PATH, also proves everything
           anew in a copy, and compares the checks

Proved means: no check unproved or justified, no pragma Assume, no error or
warning of the analysis, every source of src and proofs analysed as SPARK,
and none of the false claims of proofs/canaries proved.
Exit status: 0 yes; 1 no, each reason on a line of its own.
"""

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter, defaultdict
from pathlib import Path

import ada_source
import proof_canaries
import proof_stamp
from proof_stamp import sha256

ROOT = Path(__file__).resolve().parent.parent
RECORD = ROOT / "proofs" / "record.json"
STAMP = ROOT / "obj" / "proved.sha256"
PROJECT = "urv.gpr"
BUS = "devices-memory_bus.ads"
CONFIGURATION = "ravenscar.adc"
FOLDERS = ("src", "proofs")
COMMAND = ["gnatprove", "-P", PROJECT, "-XURV_Mode=flight", "-j2"]
RESULTS = Path("obj", "flight", "gnatprove")

COMPLAINT = re.compile(r"^\S+:\d+:\d+: (error|warning|low|medium|high)\b")
ENTITY = re.compile(r"^  \S.* at \S+:\d+")
PROVED_ENTITY = re.compile(
    r".* flow analyzed \(0 errors, 0 checks, 0 warnings and "
    r"0 pragma Assume statements\) and proved \(\d+ checks\)$"
)
SKIPPED_ENTITY = re.compile(r"  \S+ at (\S+):(\d+) skipped;")


def sources(root):
    """Every Ada source of the proof, by its path in the repository."""
    paths = sorted(ada_source.sources(root, *FOLDERS))
    return {p.relative_to(root).as_posix(): p for p in paths}


def hashes(root):
    """The hash of every file that decides what is to be proved."""
    files = {**sources(root), CONFIGURATION: root / CONFIGURATION}
    return {name: sha256(path.read_bytes()) for name, path in files.items()}


def inputs(root):
    """Every file that decides what is to be proved, and how."""
    return [*sources(root).values(), root / CONFIGURATION, root / PROJECT]


def sessions(root):
    """Where GNATprove keeps who proved what."""
    return sorted(path for path in (root / "proofs").rglob("why3*")
                  if path.is_file())


def canary_hashes(root):
    """The hash of every file of the claims that must not be proved."""
    folder = proof_canaries.FOLDER
    return {
        path.relative_to(root).as_posix(): sha256(path.read_bytes())
        for path in sorted((root / folder).glob("*.*"))
    }


def unit_of(name):
    """A specification and its body are one unit: their path, less ending."""
    return Path(name).with_suffix("").as_posix()


def switches(root):
    """The switches of package Prove, which decide what can be proved: those
    of all units and those of single files."""
    text = (root / PROJECT).read_text(encoding="utf-8")
    package = re.search(r"package Prove is(.*?)end Prove;", text, re.S)[1]
    used = re.findall(
        r'for Proof_Switches \("(.*?)"\) use(.*?);', package, re.S)
    return {of: re.findall(r'"([^"]*)"', given) for of, given in used}


def tool_versions():
    """Versions of GNATprove and of what it calls, by tool."""
    text = subprocess.run(
        ["gnatprove", "--version"], capture_output=True, text=True, check=True
    ).stdout
    called = re.findall(
        r"^(?:.*/)?(Why3|[\w-]+(?=:)).*? (?i:version) (\S+)", text, re.M
    )
    return {"gnatprove": text.splitlines()[0].strip(), **dict(called)}


class Proof:
    """What one run of GNATprove over the whole project found."""

    def __init__(self, root, *more_switches):
        self.root = root
        self.path_by_file = {Path(name).name: name for name in sources(root)}
        self.unit_by_file = {
            file: unit_of(name) for file, name in self.path_by_file.items()
        }
        self.failures = []
        self.analysed = set()
        self.checks = defaultdict(Counter)
        self.provers = Counter()
        self.sessions = set()

        results = root / RESULTS
        command = [*COMMAND, *more_switches]
        self.stamp = proof_stamp.Stamp(
            results, command, lambda: inputs(root), lambda: sessions(root))
        complaints = []
        if self.stamp.held():
            print("proof: nothing has changed since it was proved here")
        else:
            # Old results of units that are gone would be read as well.
            shutil.rmtree(results, ignore_errors=True)
            complaints = self.run(root, command)
        if self.failures:
            return
        for path in sorted(results.glob("*.spark")):
            self.read(json.loads(path.read_text(encoding="utf-8")))
        for unit in sorted({*self.unit_by_file.values()} - self.analysed):
            self.failures.append(f"{unit}: nothing of it was analysed")
        # Whatever the results do not tell, the report or the output does.
        if not self.failures:
            self.read_report(results / "gnatprove.out")
            self.failures += complaints

    def run(self, root, command):
        """Run GNATprove, show what it says, return its complaints."""
        complaints = []
        how = {"cwd": root, "env": proof_canaries.ENVIRONMENT, "text": True,
               "stdout": subprocess.PIPE, "stderr": subprocess.STDOUT}
        with subprocess.Popen(command, **how) as process:
            for line in process.stdout:
                if ": info: " in line:
                    continue
                print(line, end="", flush=True)
                if COMPLAINT.match(line):
                    complaints.append(line.strip())
        if process.returncode != 0:
            self.failures.append(f"gnatprove ended with {process.returncode}")
        return complaints

    def read(self, results):
        """Take in the results of one unit."""
        for entity in results.get("spark", []):
            if entity["spark"] == "all":
                files = (place["file"] for place in entity["sloc"])
                self.analysed |= {self.unit_by_file.get(f) for f in files}
            elif not all(self.needs_no_body(at) for at in entity["sloc"]):
                self.failures.append(f"{entity['name']}: not all in SPARK")
        for place in results.get("pragma_assume", []):
            at = "{file}:{line}:{col}".format(**place)
            self.failures.append(f"{at}: pragma Assume")
        for part, how in (("flow", "flow"), ("proof", "prover")):
            for check in results.get(part, []):
                self.read_check(check, how)
        sessions = results.get("session_map", {}).values()
        self.sessions |= {Path(session).name for session in sessions}

    def needs_no_body(self, place):
        """Of a null procedure there is no body to prove, nor of a cycle on the
        boards' bus, which is imported."""
        path = self.root / self.path_by_file[place["file"]]
        text = path.read_text(encoding="utf-8").splitlines()
        return ada_source.is_whole_declaration(
            "\n".join(text[place["line"] - 1:]), imported=path.name == BUS)

    def read_check(self, check, how):
        place = "{file}:{line}:{col}: {rule}".format(**check)
        if "suppressed" in check:
            self.failures.append(f"{place} justified, not proved")
        elif check["severity"] != "info":
            self.failures.append(f"{place} {check['severity']}")
        else:
            self.checks[self.owner(check)][check["rule"], how] += 1
            for prover, stats in check.get("stats", {}).items():
                self.provers[prover] += stats["count"]

    def owner(self, check):
        """The unit whose text the check is of: a generic's own, whichever
        its instance; the instance's for a generic from elsewhere."""
        for place in [check, *check["entity"]["sloc"]]:
            if place["file"] in self.unit_by_file:
                return self.unit_by_file[place["file"]]
        return "elsewhere"

    def read_report(self, path):
        """Each entity's line must be one that says proved."""
        for line in path.read_text(encoding="utf-8").splitlines():
            if not ENTITY.match(line) or PROVED_ENTITY.match(line):
                continue
            skipped = SKIPPED_ENTITY.match(line)
            if skipped is None or not self.needs_no_body(
                    {"file": skipped[1], "line": int(skipped[2])}):
                self.failures.append(line.strip())

    def units(self):
        """By unit and kind of check: how many were discharged how."""
        units = {}
        for unit in sorted({*self.unit_by_file.values(), *self.checks}):
            kinds = units[unit] = {}
            for (rule, how), number in sorted(self.checks[unit].items()):
                kinds.setdefault(rule, {})[how] = number
        return units

    def total(self):
        return sum(sum(unit.values()) for unit in self.checks.values())


def write_record(proof):
    found = proof.units().items()
    units = {name: {"files": {}, "checks": of} for name, of in found}
    files = hashes(ROOT)
    configuration = {CONFIGURATION: files.pop(CONFIGURATION)}
    for name, value in files.items():
        units[unit_of(name)]["files"][name] = value
    record = {
        "command": COMMAND,
        "switches": switches(ROOT),
        "versions": tool_versions(),
        "checks": proof.total(),
        "goals_by_prover": dict(sorted(proof.provers.items())),
        "configuration": configuration,
        "canaries": canary_hashes(ROOT),
        "units": units,
    }
    RECORD.write_text(json.dumps(record, indent=1) + "\n", encoding="utf-8")


def tidy_sessions(proof):
    """Drop the sessions of what is there no more, and all back-ups."""
    for file in [*(ROOT / "proofs").rglob("why3*")]:
        if file.suffix == ".bak" or file.parent.name not in proof.sessions:
            file.unlink()
        if not any(file.parent.iterdir()):
            file.parent.rmdir()


def compare_sources(record):
    """Differences between the sources and those the record was made of."""
    recorded = {**record["configuration"], **record.get("canaries", {})}
    for unit in record["units"].values():
        recorded.update(unit["files"])
    present = {**hashes(ROOT), **canary_hashes(ROOT)}
    for name in sorted({*recorded, *present}):
        if name not in present:
            yield f"{name}: removed since it was proved"
        elif name not in recorded:
            yield f"{name}: added, not proved"
        elif recorded[name] != present[name]:
            yield f"{name}: changed since it was proved"
    if record["switches"] != switches(ROOT):
        yield f"{PROJECT}: not the proof switches of the record"


def compare_checks(record, proof):
    """Differences between the recorded checks and those of a new proof."""
    recorded = {unit: of["checks"] for unit, of in record["units"].items()}
    present = proof.units()
    for unit, now in present.items():
        if now != recorded.get(unit):
            yield f"{unit}: checks {now}, recorded {recorded.get(unit)}"


def canaries_alive(root):
    """Claims that were proved and must not be, or fail for other reasons."""
    failures = proof_canaries.failures(root, lambda: inputs(root))
    if not failures:
        number = len(proof_canaries.expected(root))
        print(f"proof: {number} false claims, none proved")
    return failures


def proof_anew():
    """A proof in a copy: each prover proves its goals of the sessions again.

    If that does not do, with other provers say, the sessions are dropped.
    The canaries have none.
    """
    with tempfile.TemporaryDirectory(prefix="urv-proof-") as folder:
        for name in FOLDERS:
            shutil.copytree(ROOT / name, Path(folder, name))
        for name in (PROJECT, CONFIGURATION):
            shutil.copy(ROOT / name, folder)
        proof = Proof(Path(folder), "--replay")
        if proof.failures:
            shutil.rmtree(Path(folder, "proofs", "sessions"), True)
            proof = Proof(Path(folder))
        if not proof.failures:
            proof.failures += canaries_alive(Path(folder))
        return proof


def prove():
    if not shutil.which("gnatprove"):
        return ["gnatprove is not on the PATH"]
    proof = Proof(ROOT)
    if not proof.failures:
        proof.failures += canaries_alive(ROOT)
    if not proof.failures:
        tidy_sessions(proof)
        write_record(proof)
        proof.stamp.write()
        print(f"proof: {proof.total()} checks, all proved")
    return proof.failures


def check(anew):
    if not RECORD.exists():
        return [f"{RECORD.relative_to(ROOT)} is missing"]
    record = json.loads(RECORD.read_text(encoding="utf-8"))
    differences = list(compare_sources(record))
    if differences:
        return differences + ["renew the record with: make prove"]
    print("proof: the record is of these sources")
    if not anew:
        return []
    if not shutil.which("gnatprove"):
        print("proof: gnatprove is not on the PATH, nothing proved anew")
        return []
    state = sha256(json.dumps([
        record, proof_stamp.hashes([*inputs(ROOT), *proof_stamp.tool_files()])
    ]).encode())
    if STAMP.exists() and STAMP.read_text(encoding="utf-8") == state:
        print("proof: already proved anew here, by the same tools")
        return []
    proof = proof_anew()
    failures = proof.failures or list(compare_checks(record, proof))
    if not failures:
        STAMP.parent.mkdir(exist_ok=True)
        STAMP.write_text(state, encoding="utf-8")
        print(f"proof: {proof.total()} checks, all proved anew")
    return failures


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=("prove", "check", "sources"))
    command = parser.parse_args().command

    failures = prove() if command == "prove" else check(command == "check")
    for failure in failures:
        print(f"proof: {failure}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: Apache-2.0
"""The results of the mutants: a line of a file for each (EVI-3).

A mutant is tried again when the code of the file that it changes is another;
comments and where the file lies do not matter.
"""

import hashlib
import json
import sys
import threading
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

import ada_source  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
RESULTS = ROOT / "mutation" / "results.jsonl"
JUDGED = ROOT / "evidence" / "mutation" / "equivalent.toml"

# The results of a mutant.
INVALID = "does not build"
EQUIVALENT = "same object code"
PASSED = "passes the tests"
SURVIVED = "survived"
KILLED = ("tests", "simulation", "proof")


def digest(path):
    """A digest of a source's code."""
    code = ada_source.code_of((ROOT / path).read_text(encoding="utf-8"))
    return hashlib.sha256(code.encode()).hexdigest()[:16]


def read(file):
    """By name, the last result of each mutant."""
    if not file.exists():
        return {}
    lines = file.read_text(encoding="utf-8").splitlines()
    return {result["name"]: result for result in map(json.loads, lines)}


class Progress:
    """A line for each mutant: its result, and how many are left."""

    def __init__(self, total):
        self.total = total
        self.done = 0
        self.alive = 0
        self.begun = time.monotonic()
        self.lock = threading.Lock()

    def step(self, mutant, fate):
        with self.lock:
            self.done += 1
            self.alive += fate in (PASSED, SURVIVED)
            seconds = time.monotonic() - self.begun
            left = seconds / self.done * (self.total - self.done)
            print(f"{self.done}/{self.total}, {self.alive} alive, "
                  f"{left / 60:.0f} min left; {Path(mutant.path).name}:"
                  f"{mutant.line} {fate}", flush=True)

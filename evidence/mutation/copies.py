# SPDX-License-Identifier: Apache-2.0
"""A copy of the repository in which one mutant at a time lives."""

import os
import re
import resource
import shutil
import signal
import subprocess

from fates import ROOT

WORKPLACE = ROOT / "obj" / "mutation"
COPIED = ("src", "proofs", "host", "sim", "tests", "real_time", "ground",
          "scripts", "evidence", "urv.gpr",
          "partitions.adc")

# The folders that mutants change.
CHANGING = ("src", "proofs")

# A mutant may have a condition that is always true. Debugging aids would cost
# building time.
RELAXED = [
    (r'Strict_Switches := \(.*?\);', 'Strict_Switches := ("-gnatws");'),
    (r'Debug_Switches  := \("-g"\);', 'Debug_Switches  := ("-g0");'),
]

# The limits of one program under test; without a change none needs half of it.
CPU_LIMIT_S = 60
MEMORY_LIMIT = 4 * 2 ** 30


def set_limits():
    """A mutant that goes on for ever is ended, however slow the machine."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY_LIMIT, MEMORY_LIMIT))
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_LIMIT_S, CPU_LIMIT_S))


def same(one, other):
    return other.exists() and one.read_bytes() == other.read_bytes()


class Copy:
    """Runs commands in it, one at a time."""

    def __init__(self, number):
        self.root = WORKPLACE / f"worker-{number}"
        self.original = WORKPLACE / f"worker-{number}-original"
        self.changed = None
        self.process = None

    def start(self, command, **more):
        """Start a command in a process group of its own."""
        self.process = subprocess.Popen(
            command, cwd=self.root, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, errors="replace",
            start_new_session=True, **more
        )
        return self.process

    def stop(self):
        """End what the worker is running, with all that it started."""
        if self.process and self.process.returncode is None:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass

    def run(self, command, limit, **more):
        """Run a command to its end; status None: it took too long."""
        process = self.start(command, **more)
        try:
            output, _ = process.communicate(timeout=limit)
        except subprocess.TimeoutExpired:
            self.stop()
            process.communicate()
            return None, ""
        return process.returncode, output

    def renew(self):
        """Make it what the repository is now."""
        for name in COPIED:
            source, target = ROOT / name, self.root / name
            if source.is_dir():
                self.synchronise(source, target)
            else:
                target.parent.mkdir(parents=True, exist_ok=True)
                if not same(source, target):
                    shutil.copy(source, target)
        for name in CHANGING:
            self.synchronise(ROOT / name, self.original / name)

    def edit(self, name, changes):
        """The repository's file with some changes, built again only if it
        differs."""
        text = (ROOT / name).read_text(encoding="utf-8")
        for old, new in changes:
            text, number = re.subn(old, new, text, flags=re.S)
            assert number == 1, f"{name}: {old}"
        project = self.root / name
        if not project.exists() or project.read_text("utf-8") != text:
            project.write_text(text, encoding="utf-8")

    def synchronise(self, source, target):
        """Copy what differs, remove what is gone; keep what is the same as
        old as it was, so that it is not built again."""
        wanted = {path.relative_to(source) for path in source.rglob("*")
                  if path.is_file() and "__pycache__" not in path.parts}
        if target.exists():
            for path in target.rglob("*"):
                if path.is_file() and path.relative_to(target) not in wanted:
                    path.unlink()
        for name in wanted:
            (target / name).parent.mkdir(parents=True, exist_ok=True)
            if not same(source / name, target / name):
                shutil.copy(source / name, target / name)

    def put(self, mutant):
        """Undo the last change, make this one."""
        if self.changed and (not mutant or mutant.path != self.changed):
            (self.root / self.changed).write_bytes(self.source(self.changed))
            self.changed = None
        if mutant:
            source = self.source(mutant.path)
            (self.root / mutant.path).write_bytes(mutant.applied(source))
            self.changed = mutant.path

    def source(self, path):
        """A file as it was when the worker began."""
        return (self.original / path).read_bytes()

# SPDX-License-Identifier: Apache-2.0
"""Whether results of GNATprove still hold (EVI-8).

They hold where nothing at all has changed on which they hang; then they are
read again instead of being made again. Otherwise they go, and everything is
analysed anew:

    stamp = Stamp(results, command, files)
    if not stamp.held():
        ...             the old results go, GNATprove makes new ones
    ...                 the results are read and judged
    stamp.write()       all is well: vouch for the results

A stamp is of the contents of the files, of GNATprove with its provers and
theories, of the compiler with its packages, of the command and the environment
that the tools heed; and of the results themselves.
"""

import hashlib
import json
import os
import shutil
import subprocess
from pathlib import Path

NAME = "holds.sha256"

# Variables that say which sources, projects and runtime are taken.
HEEDED = ("ADA_", "GPR_", "GNAT", "URV_")


def sha256(data):
    return hashlib.sha256(data).hexdigest()


def found(*names):
    """The files that these commands are."""
    return {Path(which).resolve() for name in names
            if (which := shutil.which(name))}


def files_below(folder):
    return {path for path in folder.rglob("*") if path.is_file()}


def prover_files():
    """GNATprove, what it calls and what it reads."""
    prefix = Path(shutil.which("gnatprove")).resolve().parents[1]
    return (found("gnatprove", "gnat2why")
            | files_below(prefix / "libexec" / "spark")
            | files_below(prefix / "share" / "spark"))


def compiler_files():
    """The compiler, which GNATprove takes its packages and its target from."""
    compiler = shutil.which("gcc")
    if compiler is None:
        return set()
    packages = subprocess.run(
        [compiler, "-print-file-name=adainclude"], capture_output=True,
        text=True, check=True).stdout.strip()
    return found("gcc", "gprbuild", "gnatls") | files_below(
        Path(packages).resolve())


def tool_files():
    return sorted(prover_files() | compiler_files())


def hashes(paths):
    return {str(path): sha256(path.read_bytes()) for path in paths}


class Stamp:
    """Vouches for the results in a folder, and for more that a run has left,
    its sessions. files and more are functions: there may be others when they
    are called again."""

    def __init__(self, results, command, files, more=list):
        self.results, self.command = results, command
        self.files, self.more = files, more
        self.path = results / NAME
        self.begun = self.inputs()

    def inputs(self):
        """What the results hang on."""
        return {
            "command": self.command,
            "environment": {name: value for name, value in os.environ.items()
                            if name.startswith(HEEDED)},
            "files": hashes([*self.files(), *tool_files()]),
        }

    def text(self):
        there = hashes([*self.results.glob("*.spark"),
                        *self.results.glob("gnatprove.out"), *self.more()])
        return sha256(json.dumps([self.begun, there],
                                 sort_keys=True).encode())

    def held(self):
        """Whether the results hold. The stamp goes in any case: who is
        interrupted from here on leaves none."""
        held = (self.path.is_file()
                and self.path.read_text(encoding="utf-8") == self.text())
        self.path.unlink(missing_ok=True)
        return held

    def write(self):
        """Not if something was changed meanwhile."""
        if self.inputs() == self.begun:
            self.path.write_text(self.text(), encoding="utf-8")

# SPDX-License-Identifier: Apache-2.0
"""The cargo of a worker, and its work (SIM-6, SEC-10).

A worker has Python and the packages of ground/campaign-requirements.txt and
sim/jsbsim/requirements.txt, and no part of this repository. The files are sent
as one archive with its hash. The code below is sent by value, so it imports no
other module of its package.
"""

import hashlib
import io
import json
import os
import subprocess
import sys
import tarfile
import tempfile
from pathlib import Path

# Much longer than any flight of a campaign.
TIME_LIMIT_S = 3600


def packed(root, names):
    """An archive of these files and folders, the same bytes for the same
    contents."""
    out = io.BytesIO()
    with tarfile.open(fileobj=out, mode="w:xz") as archive:
        for name in sorted(files_of(root, names)):
            member = tarfile.TarInfo(name)
            data = (root / name).read_bytes()
            member.size = len(data)
            member.mode = (root / name).stat().st_mode & 0o755
            archive.addfile(member, io.BytesIO(data))
    return out.getvalue()


def files_of(root, names):
    for name in names:
        path = root / name
        if path.is_dir():
            yield from (str(each.relative_to(root))
                        for each in path.rglob("*") if each.is_file()
                        and "__pycache__" not in each.parts)
        else:
            path.stat()
            yield name


def digest(data):
    return hashlib.sha256(data).hexdigest()


class Cargo:
    """The archive, its expected hash, and the work: a function of the unpacked
    folder and a job, whose result can be written as JSON."""

    def __init__(self, archive, work, program=None, modules=()):
        """A worker must be able to run the program of the cargo, and to import
        these modules."""
        self.program = program
        self.modules = modules
        self.archive = archive
        self.hash = digest(archive)
        self.work = work
        self.name = f"cargo-{self.hash}"
        self.folder = None

    def setup(self, worker):
        """Dask's worker calls this once, before its first job."""
        if digest(self.archive) != self.hash:
            raise RuntimeError("the cargo differs from the sent one")
        self.unpack(tempfile.mkdtemp(prefix="cargo-",
                                     dir=worker.local_directory))
        self.archive = b""
        self.must_do()

    def must_do(self):
        """Raises an error unless this worker has all that the work needs."""
        # Without -P it would search the folder where the worker was started.
        wanted = [([sys.executable, "-P", "-c", f"import {name}"],
                   f"the Python module {name}") for name in self.modules]
        if self.program:
            wanted.append(([str(self.folder / self.program), "--version"],
                           self.program))
        for command, name in wanted:
            try:
                ended = subprocess.run(
                    command, capture_output=True, text=True, check=False,
                    stdin=subprocess.DEVNULL, timeout=60)
                said = ended.stderr.strip().splitlines()[-1:]
                works = ended.returncode == 0
            except OSError as fault:
                works, said = False, [str(fault)]
            if not works:
                raise RuntimeError(
                    f"{name} does not run: {' '.join(said)[:200]}")

    def unpack(self, folder):
        self.folder = Path(folder)
        with tarfile.open(fileobj=io.BytesIO(self.archive)) as archive:
            for member in archive:
                path = self.folder / member.name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(archive.extractfile(member).read())
                path.chmod(member.mode)

    def do(self, job):
        return {"cargo": self.hash, **self.work(self.folder, job)}


def run_python(folder, job):
    """Run a script of the cargo; return the JSON that it prints, or the
    error."""
    result = subprocess.run(
        [sys.executable, *job["command"]], cwd=folder, text=True,
        capture_output=True, check=False, stdin=subprocess.DEVNULL,
        timeout=TIME_LIMIT_S)
    try:
        return {"said": json.loads(result.stdout)}
    except ValueError:
        return {"fault": result.stderr.strip()[-200:]
                or f"exit status {result.returncode}"}


def fly(folder, job):
    """Fly with these options and input files; return the summary and the holds
    of the control laws that failed, or the error."""
    with tempfile.TemporaryDirectory(dir=folder) as place:
        for name, text in job["files"].items():
            (Path(place) / name).write_text(text, encoding="utf-8")
        result = subprocess.run(
            [str(folder / "bin" / "urv_sim"), "fly", *job["options"],
             "--quiet", "--summary", "summary.json",
             "--record", "record.csv"],
            cwd=place, capture_output=True, text=True, check=False,
            stdin=subprocess.DEVNULL, timeout=TIME_LIMIT_S,
            env={**os.environ, "URV_PYTHON": sys.executable})
        if result.returncode != 0:
            return {"fault": result.stderr.strip()[-200:]
                    or f"exit status {result.returncode}"}
        judged = subprocess.run(
            [sys.executable, str(folder / "evidence/safety/holds.py"),
             "record.csv", "--faults", "faults.txt", "--json"],
            cwd=place, capture_output=True, text=True, check=False,
            stdin=subprocess.DEVNULL, timeout=TIME_LIMIT_S)
        if judged.returncode != 0:
            return {"fault": judged.stderr.strip()[-200:]
                    or f"exit status {judged.returncode} of holds.py"}
        text = (Path(place) / "summary.json").read_text("utf-8")
        return {"summary": json.loads(text),
                "holds": json.loads(judged.stdout)}

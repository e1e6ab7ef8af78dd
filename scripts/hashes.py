#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0

"""Write the hashes of the wheels into lists of Python packages (SEC-17).

    scripts/hashes.py sim/jsbsim/requirements.txt ...

For after a change of a version. Needs uv (PyPI) and a network. The hashes are
those of the wheels for Linux on x86-64 and ARM64 with glibc and Python 3.11 or
later: pip takes nothing else (scripts/setup.sh).
"""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

WHEEL = re.compile(
    r"-(?P<python>[^-]+)-(?P<abi>[^-]+)-(?P<system>[^-]+)\.whl$")
LEAST_PYTHON = 11


def is_ours(name):
    """True if a wheel is for a Python and a machine that is supported."""
    python, abi, system = WHEEL.search(name).group("python", "abi", "system")
    if system != "any" and not re.search(
            r"manylinux[^.]*_(x86_64|aarch64)", system):
        return False
    if abi.endswith("t") and abi.startswith("cp3"):
        return False
    return any(
        re.fullmatch(r"py3|py2\.py3", each)
        or (found := re.fullmatch(r"cp3(\d+)", each)) and (
            int(found[1]) >= LEAST_PYTHON or abi == "abi3")
        for each in [python, *python.split(".")])


def hashes(lines):
    """The hashes of each package, by name and version."""
    text = subprocess.run(
        ["uv", "pip", "compile", "--quiet", "--no-deps", "--universal",
         "--no-header", "--python-version", f"3.{LEAST_PYTHON}",
         "--format", "pylock.toml", "-"],
        input="\n".join(lines), capture_output=True, text=True,
        check=True).stdout
    return {plain(package["name"]): sorted(
        wheel["hashes"]["sha256"] for wheel in package.get("wheels", ())
        if is_ours(wheel.get("name") or wheel["url"].rpartition("/")[2]))
        for package in tomllib.loads(text)["packages"]}


def plain(name):
    return re.sub(r"[-_.]+", "-", name).lower()


def main():
    for name in sys.argv[1:]:
        path = Path(name)
        lines = [line.removesuffix("\\").rstrip()
                 for line in path.read_text("utf-8").splitlines()
                 if not line.lstrip().startswith("--hash")]
        found = hashes([line for line in lines if "==" in line])
        out = []
        for line in lines:
            known = (found[plain(line.partition("==")[0])]
                     if "==" in line and not line.startswith("#") else [])
            if "==" in line and not line.startswith("#") and not known:
                sys.exit(f"hashes: {name}: {line} has no wheel")
            out.append(" \\\n    ".join(
                [line, *(f"--hash=sha256:{each}" for each in known)]))
        path.write_text("\n".join(out) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: Apache-2.0
"""The programs that bin/urv starts, by absolute paths (SEC-10)."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

URV = (sys.executable, "-I", "-B",
       str(Path(__file__).resolve().parent / "__main__.py"))
"""bin/urv, without its shell script."""


def found(name: str) -> str | None:
    """The path of a program of that name, or None. Folders of the PATH that
    depend on the current folder are ignored."""
    folders = os.environ.get("PATH", os.defpath).split(os.pathsep)
    return shutil.which(name, path=os.pathsep.join(
        filter(os.path.isabs, folders)))

# SPDX-License-Identifier: Apache-2.0
"""A copy of the tree, in which a patch can be applied, built and tested: likely
changes (EVI-12) and planted mistakes (EVI-10)."""

import os
import re
import shutil
import subprocess

CHANGED = re.compile(r"^\+\+\+ b/(\S+)", re.M)


def git_apply(tree, patch, *options):
    """The objections of git; none when it applies. The tree may lie within
    another one's repository, which git must not look for."""
    surroundings = {**os.environ, "GIT_CEILING_DIRECTORIES": str(tree.parent)}
    done = subprocess.run(
        ["git", "apply", *options, str(patch)], cwd=tree, env=surroundings,
        capture_output=True, text=True, check=False)
    return (done.stderr.strip() or "git apply failed") \
        if done.returncode else ""


def renew_copy(root, copy):
    """The copy has what the tree has, with its times, so that little is built
    again. Likely changes are tried in one, too (EVI-12)."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others",
         "--exclude-standard"],
        cwd=root, capture_output=True, text=True, check=True).stdout
    names = {name for name in listed.split("\0")
             if name and (root / name).is_file()}
    for folder in ("obj", "bin"):
        (copy / folder).mkdir(parents=True, exist_ok=True)
    for path in list(copy.rglob("*")):
        name = path.relative_to(copy)
        if (name.parts[0] not in ("obj", "bin", ".venv") and path.is_file()
                and name.as_posix() not in names):
            path.unlink()
    for name in sorted(names):
        source, target = root / name, copy / name
        if (not target.exists()
                or target.read_bytes() != source.read_bytes()):
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(source, target)
    packages = copy / ".venv"
    if not packages.is_symlink():
        packages.symlink_to((root / ".venv").resolve())


def take_objects(root, copy, names):
    """A copy needs to build again only the sources that its change touches.
    The built files name the place of the configuration pragmas; a builder that
    misses them there builds everything again."""
    for name in names:
        built, objects = root / "obj" / name, copy / "obj" / name
        if built.is_dir() and not objects.exists():
            objects.mkdir(parents=True)
            for path in sorted(built.iterdir()):
                if path.suffix == ".ali":
                    text = path.read_text(encoding="utf-8")
                    (objects / path.name).write_text(
                        text.replace(f"{root}/", f"{copy}/"), encoding="utf-8")
                elif path.is_file():
                    shutil.copy(path, objects)

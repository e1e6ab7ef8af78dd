# SPDX-License-Identifier: Apache-2.0
"""Judges the canaries: claims that GNATprove must not prove (EVI-2).

A line of a source in proofs/canaries that ends in the name of a check is
where this check must fail:

    Post => Advanced (Now) > Now;  --  VC_POSTCONDITION

This check may be proved nowhere on its line, and no check may fail on a line
that does not name it: then it fails for another reason than its own.
"""

import json
import re
import subprocess
from pathlib import Path

FOLDER = Path("proofs", "canaries")
RESULTS = Path("obj", "canaries", "gnatprove")
COMMAND = ["gnatprove", "-P", f"{FOLDER}/canaries.gpr", "-XURV_Mode=flight",
           "--no-subprojects", "-j0"]

MARK = re.compile(r"--  ([A-Z]+(?:_[A-Z]+)*)$")


def sources(root):
    return sorted((root / FOLDER).glob("*.ad[sb]"))


def expected(root):
    """The place where each check must fail: file, line, check."""
    return {
        (path.name, number, mark[1])
        for path in sources(root)
        for number, line in enumerate(
            path.read_text(encoding="utf-8").splitlines(), 1)
        if (mark := MARK.search(line))
    }


def judge(wanted, checks):
    """The faults of the checks, a dictionary each, of GNATprove."""
    failed = set()
    held = set()
    for check in checks:
        place = check["file"], check["line"], check["rule"]
        passed = check["severity"] == "info" or "suppressed" in check
        (held if passed else failed).add(place)
    for place in sorted(wanted | failed):
        at = "{}:{}: {}".format(*place)
        if place not in wanted:
            yield f"{at} fails, and is no canary's own reason"
        elif place not in failed:
            how = "was proved" if place in held else "was not looked at"
            yield f"{at} of a canary {how}"


def not_analysed(names, results):
    """The units without any result."""
    seen = {
        Path(place["file"]).stem
        for result in results
        for entity in result.get("spark", []) if entity["spark"] == "all"
        for place in entity["sloc"]
    }
    for unit in sorted({Path(name).stem for name in names} - seen):
        yield f"{unit}: nothing of this canary was analysed"


def failures(root, environment):
    """Let GNATprove analyse the canaries; return those that do not fail."""
    done = subprocess.run(
        COMMAND, cwd=root, env=environment, stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT, text=True, check=False)
    names = [path.name for path in sources(root)]
    stems = {Path(name).stem for name in names}
    results = [
        json.loads(path.read_text(encoding="utf-8"))
        for path in sorted((root / RESULTS).glob("*.spark"))
        if path.stem in stems
    ]
    checks = [check for result in results for part in ("flow", "proof")
              for check in result.get(part, [])]
    wrong = [*not_analysed(names, results), *judge(expected(root), checks)]
    if done.returncode != 0:
        wrong.append(f"gnatprove ended with {done.returncode}")
    if wrong:
        print(done.stdout, end="")
    else:
        print(f"proof: {len(expected(root))} false claims, none proved")
    return wrong

# SPDX-License-Identifier: Apache-2.0
"""Judges the canaries: claims that GNATprove must not prove (EVI-2).

A line of a source in proofs/canaries that ends in the name of a check is
where this check must fail:

    Post => Advanced (Now) > Now;  --  VC_POSTCONDITION

That check may be proved nowhere on its line, and no check may fail on a line
that does not name it: then it fails for another reason than its own.
"""

import json
import os
import re
import subprocess
from pathlib import Path

import proof_stamp

FOLDER = Path("proofs", "canaries")
RESULTS = Path("obj", "canaries", "gnatprove")
COMMAND = ["gnatprove", "-P", f"{FOLDER}/canaries.gpr", "-XURV_Mode=flight",
           "--no-subprojects", "-j2"]

# What GNATprove calls for each subprogram is written in OCaml. It takes less
# time where it collects its garbage late and has its memory in large pages.
ENVIRONMENT = {"OCAMLRUNPARAM": "o=1000000,i=16M",
               "GLIBC_TUNABLES": "glibc.malloc.hugetlb=1", **os.environ}

MARK = re.compile(r"--  ([A-Z]+(?:_[A-Z]+)*)$")


def sources(root):
    return sorted((root / FOLDER).glob("*.ad[sb]"))


def expected(root):
    """Where which check must fail: file, line, check."""
    return {
        (path.name, number, mark[1])
        for path in sources(root)
        for number, line in enumerate(
            path.read_text(encoding="utf-8").splitlines(), 1
        )
        if (mark := MARK.search(line))
    }


def judge(wanted, checks):
    """What is wrong with the checks, a dictionary each, of GNATprove."""
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
    """Units of which GNATprove has analysed nothing."""
    seen = {
        place["file"]
        for result in results
        for entity in result.get("spark", []) if entity["spark"] == "all"
        for place in entity["sloc"]
    }
    units = {Path(name).stem for name in names}
    for unit in sorted(units - {Path(file).stem for file in seen}):
        yield f"{unit}: nothing of this canary was analysed"


def failures(root, inputs):
    """Let GNATprove look at the canaries; say which do not fail as they
    must. They are about the sources that inputs() has."""
    stamp = proof_stamp.Stamp(root / RESULTS, COMMAND, lambda: [
        *inputs(), *sorted((root / FOLDER).glob("*.*"))])
    said, status = "", 0
    if not stamp.held():
        # All is analysed anew. What provers did not find stays in the folders
        # beside, by goal and steps, and is not looked for again.
        for old in [*(root / RESULTS).glob("*.spark"),
                    *(root / RESULTS).glob("*.ali")]:
            old.unlink()
        done = subprocess.run(
            COMMAND, cwd=root, env=ENVIRONMENT, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, check=False)
        said, status = done.stdout, done.returncode
    results = [
        json.loads(path.read_text(encoding="utf-8"))
        for path in sorted((root / RESULTS).glob("*.spark"))
    ]
    checks = [
        check
        for result in results
        for part in ("flow", "proof") for check in result.get(part, [])
    ]
    names = [path.name for path in sources(root)]
    wrong = [*not_analysed(names, results), *judge(expected(root), checks)]
    if status != 0:
        wrong.append(f"gnatprove ended with {status}")
    if wrong:
        print(said, end="")
    else:
        stamp.write()
    return wrong

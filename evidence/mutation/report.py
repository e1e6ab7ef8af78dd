#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the table of the mutants' results into docs/evidence/mutation.md, and
checks that every survivor is judged, and nothing else is.

A survivor is judged in evidence/mutation/equivalent.toml: by its name and change,
with the reason why the changed software does the same.
Exit status: 0 all well; 1 not, each reason on a line of its own.
"""

import sys
import tomllib
from collections import Counter
from pathlib import Path

import fates
import mutants

DOCUMENT = fates.ROOT / "docs" / "evidence" / "mutation.md"
BEGIN = "<!-- table -->\n"
END = "<!-- end of table -->\n"

# The least score.
GOAL = 95.0

COLUMNS = ("mutants", *fates.KILLED, "survived", "equivalent", "score")


def judged(file):
    """The judgements of survivors, by name."""
    if not file.exists():
        return {}
    text = file.read_text(encoding="utf-8")
    return {one["name"]: one for one in tomllib.loads(text).get("mutant", [])}


def column_of(result, equivalent):
    """The table's column of a result; None if it does not build."""
    fate = result["fate"]
    if fate == fates.EQUIVALENT or result["name"] in equivalent:
        return "equivalent"
    if fate == fates.PASSED:
        # The proof, which may notice it, has yet to come.
        return fates.SURVIVED
    return None if fate == fates.INVALID else fate


def score(counts):
    killed = sum(counts[how] for how in fates.KILLED)
    total = killed + counts["survived"]
    return 100.0 * killed / total if total else 100.0


def cells(name, counts):
    """A row: of the mutants that build, how many met which fate."""
    columns = [name, str(sum(counts.values()))]
    columns += [str(counts[how] or "") for how in COLUMNS[1:-1]]
    share = int(score(counts) * 10) / 10
    columns.append(f"{share:.1f}%" if share < 100 else "100%")
    return "| " + " | ".join(columns) + " |"


def counted(results, equivalent):
    """By folder and package, how many met which fate."""
    packages = {}
    for result in results:
        column = column_of(result, equivalent)
        if column:
            path = Path(result["path"])
            folder = "/".join(path.parts[:-1][:2])
            of_package = packages.setdefault((folder, path.stem), Counter())
            of_package[column] += 1
    return packages


def table(results, equivalent):
    """By folder, and each package that has a survivor."""
    packages = counted(results, equivalent)
    lines = ["| " + " | ".join(("folder", *COLUMNS)) + " |",
             "|---|" + "--:|" * len(COLUMNS)]
    for folder in sorted({folder for folder, _ in packages}):
        of_folder = {name: counts for (at, name), counts in
                     sorted(packages.items()) if at == folder}
        lines += [cells(f"`{name}`", counts)
                  for name, counts in of_folder.items()
                  if counts["survived"]]
        lines.append(cells(f"**{folder}**",
                           sum(of_folder.values(), Counter())))
    total = sum(packages.values(), Counter())
    lines.append(cells("**all**", total))
    return "\n".join(lines) + "\n", total


def problems(results, judgements, total, goal):
    """Survivors without a judgement, judgements of no survivor, a low score."""
    survivors = {r["name"]: r for r in results
                 if r["fate"] in (fates.SURVIVED, fates.PASSED)}
    for name, one in judgements.items():
        if name not in survivors:
            yield f"{name}: judged, but is no survivor"
        elif one["change"] != survivors[name]["change"]:
            yield f"{name}: judged for another change"
        elif not one.get("reason", "").strip():
            yield f"{name}: judged without a reason"
    for name, result in survivors.items():
        if name not in judgements:
            yield ("{path}:{line}: {name} survives, not judged: {change}"
                   .format(**result))
    if score(total) < goal:
        yield f"the score is {score(total):.1f}%, less than {goal}%"


def main():
    every = fates.read(fates.RESULTS)
    if not every:
        print("mutation: no results: evidence/mutation/run.py makes them")
        return 1
    today = {mutant.name for mutant in mutants.Code(fates.ROOT).mutants()}
    results = [result for name, result in every.items() if name in today]
    judgements = judged(fates.JUDGED)
    text, total = table(results, set(judgements))
    head, _, rest = DOCUMENT.read_text(encoding="utf-8").partition(BEGIN)
    _, _, tail = rest.partition(END)
    DOCUMENT.write_text(head + BEGIN + text + END + tail, encoding="utf-8")
    found = list(problems(results, judgements, total, GOAL))
    for problem in found:
        print(f"mutation: {problem}")
    print(f"mutation: {sum(total.values())} mutants, "
          f"score {int(score(total) * 10) / 10}%")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

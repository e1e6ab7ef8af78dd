#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the mutants show: the tables of docs/evidence/mutation.md, their check.

  table   writes the tables into docs/evidence/mutation.md
  check   the same tables must be there; every survivor is judged, and nothing
          else is

A survivor is judged in tests/mutation, equivalent.toml or judges.toml: by its
name and change, with the reason why the changed software does the same. Of
what judges it may have `equivalent = false`: nobody notices it, for a reason.
Exit status: 0 all well; 1 not, each reason on a line of its own.
"""

import argparse
import sys
import tomllib
from collections import Counter
from pathlib import Path

import fates
from kinds import KINDS

ROOT = fates.ROOT
DOCUMENT = ROOT / "docs" / "evidence" / "mutation.md"
END = "<!-- end of table -->\n"

COLUMNS = ("mutants", *fates.KILLED, "survived", "equivalent", "score")


def judged(file):
    """The judgements of survivors, by name."""
    if not file.exists():
        return {}
    text = file.read_text(encoding="utf-8")
    return {one["name"]: one for one in tomllib.loads(text).get("mutant", [])}


def equivalent_of(judgements):
    return {name for name, one in judgements.items()
            if one.get("equivalent", True)}


def column_of(result, equivalent):
    """Where the table counts a result; nowhere if it does not build."""
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


def table(results, equivalent, by_package):
    """By folder; if wanted each package, too."""
    packages = counted(results, equivalent)
    lines = ["| " + " | ".join(("package", *COLUMNS)) + " |",
             "|---|" + "--:|" * len(COLUMNS)]
    for folder in sorted({folder for folder, _ in packages}):
        of_folder = {name: counts for (at, name), counts in
                     sorted(packages.items()) if at == folder}
        if by_package:
            lines += [cells(f"`{name}`", counts)
                      for name, counts in of_folder.items()]
        lines.append(cells(f"**{folder}**",
                           sum(of_folder.values(), Counter())))
    total = sum(packages.values(), Counter())
    lines.append(cells("**all**", total))
    return "\n".join(lines) + "\n", total


def list_of(judgements, results):
    """The judged survivors, each with its reason."""
    if not judgements:
        return ""
    lines = ["", "| survivor | change | same? | why |", "|---|---|---|---|"]
    for result in sorted(results, key=lambda r: (r["path"], r["line"])):
        one = judgements.get(result["name"])
        if one:
            change = one["change"].replace("|", "\\|")
            same = "yes" if one.get("equivalent", True) else "no"
            reason = " ".join(one["reason"].split())
            lines.append(f"| {one['place']} | `{change}` | {same} |"
                         f" {reason} |")
    return "\n".join(lines) + "\n"


def problems(results, judgements, total, goal):
    """Survivors nobody judged, judgements of none, a score too low."""
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


def current(results, kind):
    """The results of the mutants that the sources of today have."""
    names = {mutant.name for mutant in kind.every()}
    return [r for name, r in results.items() if name in names]


def show(kind, command):
    """Write or check the part of a kind; what is wrong."""
    results = current(fates.read(kind.results), kind)
    judgements = judged(kind.judged)
    flight = kind is KINDS["flight"]
    text, total = table(results, equivalent_of(judgements), flight)
    if not flight:
        text += list_of(judgements, results)
    begin = f"<!-- {kind.part} -->\n"
    head, _, rest = DOCUMENT.read_text(encoding="utf-8").partition(begin)
    there, _, tail = rest.partition(END)
    found = list(problems(results, judgements, total, kind.goal))
    if command == "table":
        DOCUMENT.write_text(head + begin + text + END + tail,
                            encoding="utf-8")
    elif there != text:
        found.append(f"docs/evidence/mutation.md: {kind.part}: not what these"
                     " results give")
    for problem in found:
        print(f"mutation: {problem}")
    print(f"mutation: {sum(total.values())} mutants, "
          f"score {int(score(total) * 10) / 10}%")
    return found


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=("table", "check"))
    command = parser.parse_args().command
    found = [show(kind, command) for kind in KINDS.values()]
    return 1 if any(found) else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every single claim of a contract, so that none goes away unnoticed (EVI-5).

  list    writes proofs/claims.txt
  check   the file must say what the contracts say

A claim is one conjunct of a postcondition or a predicate, one case of
Contract_Cases for each conjunct of its consequence, or a Global or Depends.
Exit status: 0 all there; 1 not, each difference on a line of its own.
"""

import argparse
import sys
from pathlib import Path

from ada_source import (
    code_of, descendants, parsed, sources, subprogram_name, text_of)

ROOT = Path(__file__).resolve().parent.parent
CLAIMS = ROOT / "proofs" / "claims.txt"
FOLDERS = ("src", "proofs")

# The aspects that claim something, and those that are logical formulas.
FORMULAS = {"Post", "Refined_Post", "Predicate", "Static_Predicate"}
WHOLE = {"Global", "Refined_Global", "Depends", "Initializes",
         "Subprogram_Variant"}


def conjuncts(node):
    """The parts of a formula that `and then` joins, brackets taken off."""
    parts = [c for c in node.children if c.type != "comment"]
    while len(parts) == 3 and parts[0].type == "(" and parts[2].type == ")":
        parts = [parts[1]]
    if len(parts) == 1 and parts[0].children:
        yield from conjuncts(parts[0])
        return
    if not any(part.type == "and" for part in parts):
        yield code_of(text_of(node))
        return
    group = []
    for part in [*parts, None]:
        if part is not None and part.type not in ("and", "then"):
            group.append(part)
        elif group:
            if len(group) == 1:
                yield from conjuncts(group[0])
            else:
                text = node.text[group[0].start_byte - node.start_byte:
                                 group[-1].end_byte - node.start_byte]
                yield code_of(text.decode())
            group = []


def claims_of(association):
    """What one aspect claims."""
    mark = text_of(association).split("=>")[0].strip()
    value = association.child_by_field_name("value")
    if value is None:
        value = association.children[-1]
    if mark in FORMULAS:
        for claim in conjuncts(value):
            yield mark, claim
    elif mark == "Contract_Cases":
        yield from cases(value)
    elif mark in WHOLE:
        yield mark, code_of(text_of(value))


def cases(value):
    """Of each case, its guard with each conjunct of its consequence."""
    for part in descendants(value):
        if part.type == "array_component_association":
            guard = code_of(text_of(part.children[0]))
            for claim in conjuncts(part.children[-1]):
                yield "Contract_Cases", f"{guard} => {claim}"


def owner(node):
    """What an aspect belongs to: its subprogram, type or package."""
    while node is not None:
        name = subprogram_name(node)
        if name:
            return name
        node = node.parent
    return ""


def claims(root):
    """Every claim: unit, what it is of, aspect, text."""
    found = []
    for path in sources(root, *FOLDERS):
        for node in descendants(parsed(path.read_bytes())):
            if node.type == "aspect_association":
                of = owner(node.parent.parent)
                found += [f"{path.stem} {of} {mark}: {claim}"
                          for mark, claim in claims_of(node)]
    return found


def differences(recorded, present):
    for claim in sorted({*recorded, *present}):
        less = recorded.count(claim) - present.count(claim)
        if less:
            yield f"{'gone' if less > 0 else 'new'}: {claim}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", choices=("list", "check"))
    command = parser.parse_args().command

    present = claims(ROOT)
    if command == "list":
        CLAIMS.write_text("\n".join(present) + "\n", encoding="utf-8")
        print(f"claims: {len(present)}")
        return 0
    recorded = CLAIMS.read_text(encoding="utf-8").splitlines()
    found = list(differences(recorded, present))
    for difference in found:
        print(f"claims: {difference}")
    if found:
        print("claims: if it is meant: scripts/claims.py list")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

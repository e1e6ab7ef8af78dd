#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether each public subprogram has a complete contract (EVI-7).

    scripts/contracts.py    says what is missing; exit status 1 if so

Of a subprogram in the visible part of a package of the kernel, the telemetry
board's software or the tasks:

  - It has Global.
  - A function is an expression, or reads nothing but a state, or its
    postcondition speaks of its result.
  - The postcondition of a procedure speaks of each parameter that it
    changes, and not only of the value that it had.

That the postconditions leave nothing open is proved: Theorems.Results must
therefore call each procedure of a package that is pure, but for one whose
postcondition is an equation for what it changes.

Nothing of the kind can be said of what tasks share: it may change before the
caller looks. Nor in a generic with formal subprograms: what they touch and
give is known for an instance only. GNATprove finds the Global of those by
itself, and that of the nodes, which are nothing but instances.
"""

import re
import sys
from collections import Counter
from pathlib import Path

from ada_source import (
    aspects, child_of_type, descendants, has_aspect, parsed, sources,
    specification_of, subprogram_name, text_of, without_comments)

ROOT = Path(__file__).resolve().parent.parent
FOLDERS = ("kernel", "telemetry", "formats", "tasks")
THEOREMS = "proofs/theorems-results.ads"
DECLARATIONS = {"subprogram_declaration", "expression_function_declaration"}


def changed_parameters(node):
    for part in descendants(specification_of(node)):
        if part.type == "parameter_specification":
            names, _, rest = without_comments(text_of(part)).partition(":")
            if re.match(r"\s*(in\s+)?out\b", rest):
                yield from (name.strip() for name in names.split(","))


def speaks_of(text, name):
    return re.search(rf"\b{re.escape(name)}\b(?!'Old)", text) is not None


def gaps_of(node, completed, shared):
    """What is missing of one subprogram."""
    name = subprogram_name(node)
    given = aspects(node)
    said = " ".join(given.get(mark, "")
                    for mark in ("Post", "Contract_Cases"))
    if "Global" not in given:
        yield f"{name} has no Global"
    touched = set(re.findall(r"\w+", given.get("Global", "")))
    if specification_of(node).type == "function_specification":
        if not (node.type == "expression_function_declaration"
                or name in completed or touched & shared
                or speaks_of(said, f"{name}'Result")):
            yield f"{name}'s postcondition does not speak of its result"
    elif not touched & shared:
        for parameter in changed_parameters(node):
            if not speaks_of(said, parameter):
                yield f"{name}'s postcondition does not speak of {parameter}"


def is_equation(node):
    """Its postcondition is X = ... for the one parameter X that it changes."""
    changed = list(changed_parameters(node))
    post = without_comments(aspects(node).get("Post", "")).strip()
    name, _, value = post.partition(" = ")
    return (changed == [name] and not speaks_of(value, name)
            and not re.search(r"\b(and|or|xor)\b", value))


def states_of(package):
    """The names of its abstract states."""
    given = aspects(package).get("Abstract_State", "")
    return set(re.findall(r"\w+", given)) - {"null"}


def parts(package):
    """The declarations of the visible and of the private part."""
    visible, private = [], []
    part = visible
    for node in package.children:
        if node.type == "private":
            part = private
        part.append(node)
    return visible, private


def objects_of(source):
    """The names of formal objects and of a package's own variables: what is
    shared in the wiring."""
    text = without_comments(source.decode("utf-8"))
    return set(re.findall(r"^   (\w+) *: *(?:in out )?(?!constant)[\w.]+;",
                          text, re.M))


def package_gaps(package, objects):
    visible, private = parts(package)
    completed = {subprogram_name(node) for node in private
                 if node.type == "expression_function_declaration"}
    for node in visible:
        if node.type in DECLARATIONS:
            yield from gaps_of(node, completed,
                               states_of(package) | objects)


def package_of(root):
    """The package of a specification, unless it has formal subprograms."""
    for unit in root.children:
        for node in unit.children:
            if node.type == "package_declaration":
                return node
            if node.type == "generic_package_declaration":
                formals = child_of_type(node, "generic_formal_part")
                if not any(part.type == "formal_subprogram_declaration"
                           for part in formals.children):
                    return child_of_type(node, "package_declaration")
    return None


def unit_gaps(source):
    """What is missing in a specification."""
    package = package_of(parsed(source))
    if package is not None:
        yield from package_gaps(package, objects_of(source))


def pure_procedures(root):
    """Those whose results the theorems are about, as Package.Name."""
    for path in specifications(root):
        package = package_of(parsed(path.read_bytes()))
        given = package and child_of_type(package, "aspect_specification")
        if not given or "Pure" not in text_of(given):
            continue
        for node in parts(package)[0]:
            if (node.type == "subprogram_declaration"
                    and not has_aspect(node, "Ghost")
                    and any(changed_parameters(node))
                    and not is_equation(node)):
                yield f"{path.stem}.{subprogram_name(node)}"


def specifications(root):
    return [path for folder in FOLDERS
            for path in sources(root, f"src/{folder}")
            if path.suffix == ".ads"]


def theorem_gaps(root):
    """The pure procedures that the theorems have nothing about."""
    told = Counter(re.findall(r"procedure Of_(\w+)",
                              (root / THEOREMS).read_text("utf-8")))
    there = Counter(name.partition(".")[2] for name in pure_procedures(root))
    for name, number in sorted(there.items()):
        if told[name] < number:
            yield (f"{THEOREMS}: {number} procedures {name}, "
                   f"{told[name]} Of_{name}")


def gaps(root):
    for path in specifications(root):
        for gap in unit_gaps(path.read_bytes()):
            yield f"{path.relative_to(root)}: {gap}"
    yield from theorem_gaps(root)


def main():
    found = list(gaps(ROOT))
    for gap in found:
        print(gap)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

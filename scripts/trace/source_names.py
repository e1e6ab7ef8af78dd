# SPDX-License-Identifier: Apache-2.0
"""The names in the sources: Ada units and their declarations, tests, and the
requirements that comments and tests' names speak of."""

import ast
import re
import sys
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from ada_source import (  # noqa: E402
    UNIT, declarations, end_of, sources, without_comments)

# A family of requirements, and so what looks like one of their names.
FAMILIES = ("FRM INI TST BUF KRN MBX SEM ADI AD COR TIN TOU MDI MDO GDI GDO"
            " PWM SET LNK SIM EXT FTI RTP BRD EVI SAF GND SEC"
            " D").split()
FAMILY = "|".join(FAMILIES)
IDENTIFIER = rf"(?<![\w-])(?:{FAMILY})-\d+\b"
RANGE = re.compile(rf"(?<![\w-])({FAMILY})-(\d+) to \1-(\d+)\b")
LEADING = re.compile(rf"(?:{IDENTIFIER}(?:, | and | to | )?)+")

# In a test's name in Python: test_lnk9_..., test_gdo1_mdo1_...
NAME_PART = re.compile(rf"({FAMILY})(\d+)$", re.I)


def requirements_in(text):
    """The requirements that a text names; "LNK-3 to LNK-5" is three."""
    text = re.sub(r"\n\s*--", " ", text)
    text = re.sub(r"\s+", " ", text)
    found = set(re.findall(IDENTIFIER, text))
    for family, first, last in RANGE.findall(text):
        found |= {f"{family}-{n}" for n in range(int(first), int(last) + 1)}
    return found


# --- Ada -------------------------------------------------------------------

@dataclass(eq=False)
class Unit:
    """A library unit: its files, the names it declares with their places,
    and the requirements its comments name."""

    name: str
    files: list = field(default_factory=list)
    places: dict = field(default_factory=dict)
    requirements: set = field(default_factory=set)
    is_empty: bool = True

    def places_of(self, declared):
        """The places of a name in it; '' is the unit itself."""
        return self.places.get(declared.lower(), [])


def read_units(root, folders):
    """The library units in these folders, by their name in lower case."""
    units = {}
    files = sources(root, *folders)
    for path in sorted(files, key=lambda path: path.suffix, reverse=True):
        text = path.read_text(encoding="utf-8")
        code = without_comments(text)
        heading = UNIT.search(code)
        if not heading:
            continue
        unit = units.setdefault(heading[1].lower(), Unit(heading[1]))
        file = path.relative_to(root).as_posix()
        unit.files.append(file)
        unit.requirements |= requirements_in(text)
        unit.places.setdefault("", []).append(
            (file, 1, text.count("\n")))
        for name, first, last in declarations(code):
            unit.is_empty = False
            unit.places.setdefault(name, []).append((file, first, last))
    return units


def unit_and_name(units, dotted):
    """The longest unit that a dotted name begins with, and the rest."""
    parts = dotted.split(".")
    for length in range(len(parts), 0, -1):
        unit = units.get(".".join(parts[:length]).lower())
        if unit:
            return unit, ".".join(parts[length:])
    return None, dotted


# --- tests -----------------------------------------------------------------

@dataclass
class Test:
    """One test: its name, where it is, the requirements it names."""

    name: str
    file: str
    lines: tuple
    requirements: set


ADDED = re.compile(r"\bAdd\s*\(\s*Suite\s*,\s*((?:\"[^\"]*\"\s*&?\s*)+),"
                   r"\s*(\w+)'Access\s*\)")
ANY_ADDED = re.compile(r"\bAdd\s*\(\s*Suite\b")


def unit_tests(path, file):
    """The tests that an AUnit package adds to its suite. One whose name
    cannot be read here names no requirement."""
    text = path.read_text(encoding="utf-8")
    code = without_comments(text)
    tests = []
    for match in ADDED.finditer(code):
        name = "".join(re.findall(r'"([^"]*)"', match[1]))
        body = re.search(rf"^ *procedure {match[2]} is\b", code, re.M)
        start = body.start() if body else match.start()
        start += len(code[start:]) - len(code[start:].lstrip())
        lines = (code.count("\n", 0, start) + 1,
                 code.count("\n", 0, end_of(code, start)) + 1)
        leading = LEADING.match(name)
        tests.append(Test(name, file, lines,
                          requirements_in(leading[0]) if leading else set()))
    unread = len(ANY_ADDED.findall(code)) - len(tests)
    tests += [Test("(not a plain name)", file, (1, 1), set())] * unread
    return tests


def named_in(function_name):
    """test_gdo1_mdo1_error_word names GDO-1 and MDO-1."""
    found = set()
    for part in function_name.split("_")[1:]:
        match = NAME_PART.match(part)
        if not match:
            break
        found.add(f"{match[1].upper()}-{match[2]}")
    return found


def simulation_tests(path, file):
    """The tests of a Python file. Each is of the requirements in its name
    and its docstring, and if there are none of those in the file's."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    of_file = requirements_in(ast.get_docstring(tree) or "")
    tests = []
    for node in ast.walk(tree):
        if not isinstance(node, ast.FunctionDef):
            continue
        if not node.name.startswith("test_"):
            continue
        own = named_in(node.name)
        own |= requirements_in(ast.get_docstring(node) or "")
        first = min([node.lineno, *(d.lineno for d in node.decorator_list)])
        tests.append(Test(node.name, file, (first, node.end_lineno),
                          own or of_file))
    return tests

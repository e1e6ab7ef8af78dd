# SPDX-License-Identifier: Apache-2.0
"""Small changes to Python, by the operators of cosmic-ray (EVI-3)."""

import hashlib
import os
import sys
from collections import Counter
from functools import cache
from pathlib import Path
from typing import NamedTuple

from cosmic_ray.ast import Visitor, get_ast
from cosmic_ray.mutating import mutate_code
from cosmic_ray.plugins import get_operator, operator_names

from mutants import Mutant

sys.path.insert(0, str(Path(__file__).resolve().parents[1]))

from ada_source import squeezed  # noqa: E402

# These need to be told what to change, or change nothing.
LEFT_OUT = {"core/VariableInserter", "core/VariableReplacer", "core/NoOp"}


@cache
def operators():
    return {name: get_operator(name)() for name in sorted(operator_names())
            if name not in LEFT_OUT}


class Place(NamedTuple):
    """Where a change can be made: the how manieth place of an operator."""

    name: str
    path: str
    operator: str
    by: str
    occurrence: int
    line: int


class Finder(Visitor):
    """Collects the places of a file. A place keeps its name as long as its
    line keeps its text."""

    def __init__(self, path, source):
        self.path = path
        self.lines = source.splitlines()
        self.number = Counter()
        self.seen = Counter()
        self.found = []
        self.walk(get_ast(source))

    def visit(self, node):
        for by, operator in operators().items():
            for (line, _), _ in operator.mutation_positions(node):
                self.add(by, line)
        return node

    def add(self, by, line):
        key = (Path(self.path).name, by, squeezed(self.lines[line - 1]))
        digest = hashlib.sha256(repr((*key, self.seen[key])).encode())
        # core/ReplaceBinaryOperator_Add_Sub is one of ReplaceBinaryOperator.
        operator = by.partition("/")[2].partition("_")[0]
        self.found.append(Place(digest.hexdigest()[:10], self.path, operator,
                                by, self.number[by], line))
        self.seen[key] += 1
        self.number[by] += 1


def places(path, source):
    return Finder(path, source).found


def function_at(source, line):
    """The function or class at the margin that a line is in."""
    for text in reversed(source.splitlines()[:line]):
        if text.startswith(("def ", "class ")):
            return text.split("(")[0].split()[1].rstrip(":")
        if text and not text.startswith((" ", ")", "#", '"')):
            return ""
    return ""


def mutant_at(place, source):
    """The change itself."""
    changed = mutate_code(source, operators()[place.by], place.occurrence)
    old, new = source.encode(), changed.encode()
    start = len(os.path.commonprefix([old, new]))
    same = len(os.path.commonprefix([old[start:][::-1], new[start:][::-1]]))
    end = len(old) - same
    # A line and its change tell more than two signs.
    first = old.rfind(b"\n", 0, start) + 1
    last = (old.find(b"\n", end - 1) if end > start and old[end - 1] == 10
            else old.find(b"\n", end))
    return Mutant(
        place.name, place.path, function_at(source, place.line),
        place.operator, first, last, old[first:last].decode(),
        new[first:len(new) - (len(old) - last)].decode(), place.line)

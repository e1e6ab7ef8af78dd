# SPDX-License-Identifier: Apache-2.0
"""Small changes to the code of the flight software (EVI-3, EVI-7).

Only code is changed: statements, and the expressions of functions that code
calls. Contracts, pragmas, ghosts, and functions that only contracts call are
evidence; they are left alone. Sources are parsed with tree-sitter-ada.

A mutant keeps its name as long as the statement or declaration that it changes
stays the same but for its contract, wherever the line or the file moves to.
"""

import hashlib
import sys
from collections import Counter
from dataclasses import dataclass
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "scripts"))

from ada_source import (  # noqa: E402
    SUBPROGRAMS, child_of_type, descendants, has_aspect, parsed, sources,
    squeezed, subprogram_name, text_of)

# The folder that is changed, and those that call it.
FLIGHT = "src"
CALLERS = ("sim", "host", "real_time")

# In the order in which they are tried.
FOLDERS = ("telemetry", "tasks", "nodes", "formats", "devices", "kernel",
           "laws", "seal")

# Tie the rest to Ada's tasks and clock. They are tried in real time only, by
# tests too slow to give each mutant to.
REAL_TIME_UNITS = {
    "urvos-real_time_nodes", "urvos-real_time_processors",
}

# No code of theirs is changed: contracts, proof aids, names of things.
NOT_CODE = {
    "aspect_specification", "pragma_g", "with_clause", "use_clause",
    "generic_instantiation", "comment", "formal_part",
}

RELATIONS = {
    "=": ("/=",), "/=": ("=",), "<": ("<=", ">="), "<=": ("<", ">"),
    ">": (">=", "<="), ">=": (">", "<"),
}
ADDING = {"+": ("-",), "-": ("+",)}
MULTIPLYING = {"*": ("/",), "/": ("*",), "mod": ("/",), "rem": ("/",)}
LOGICAL = {"and": ("or",), "or": ("and",), "xor": ("or",)}
ATTRIBUTES = {
    "First": ("Last",), "Last": ("First",), "Succ": ("Pred",),
    "Pred": ("Succ",), "Min": ("Max",), "Max": ("Min",),
}
SHIFTS = {"Shift_Left": "Shift_Right", "Shift_Right": "Shift_Left",
          "Rotate_Left": "Rotate_Right", "Rotate_Right": "Rotate_Left"}
BOOLEANS = {"True": "False", "False": "True"}


@dataclass(frozen=True)
class Mutant:
    """One change: the bytes from start to end become new."""

    name: str
    path: str
    subprogram: str
    operator: str
    start: int
    end: int
    old: str
    new: str
    line: int

    def applied(self, source):
        """The changed source, of as many lines as before."""
        new = self.new.encode()
        lost = source[self.start:self.end].count(b"\n") - new.count(b"\n")
        return source[:self.start] + new + b"\n" * lost + source[self.end:]

    @property
    def change(self):
        return f"{squeezed(self.old)} -> {squeezed(self.new)}"


class Code:
    """All sources of some folders, parsed, and what of them is only proof."""

    def __init__(self, root):
        self.root = root
        self.trees = {}
        for path in sorted(sources(root, FLIGHT, *CALLERS)):
            name = path.relative_to(root).as_posix()
            self.trees[name] = parsed(path.read_bytes())
        self.ghosts = {
            subprogram_name(node)
            for tree in self.trees.values() for node in descendants(tree)
            if node.type in SUBPROGRAMS and has_aspect(node, "Ghost")
        }
        self.proof_only = self.only_contracts_call()

    def only_contracts_call(self):
        """Functions that nothing calls but contracts, ghosts, and others of
        their kind."""
        functions = {
            subprogram_name(node)
            for path, tree in self.trees.items() if path.startswith("src/")
            for node in descendants(tree)
            if node.type == "expression_function_declaration"
        }
        unused = functions
        while True:
            used = set()
            for tree in self.trees.values():
                self.collect_used(tree, unused, used)
            if not unused & used:
                return unused
            unused = unused - used

    def collect_used(self, node, skipped, used):
        if node.type in ("aspect_specification", "pragma_g"):
            return
        if node.type in SUBPROGRAMS:
            name = subprogram_name(node)
            if name in self.ghosts or name in skipped:
                return
        if node.type == "identifier" and not self.declares(node):
            used.add(text_of(node))
        for child in node.children:
            self.collect_used(child, skipped, used)

    @staticmethod
    def declares(identifier):
        parent = identifier.parent
        return parent.type in (
            "function_specification", "component_choice_list",
        ) and parent.child_by_field_name("name") in (identifier, None)

    def enumerations(self):
        """For each literal of an enumeration type, another one."""
        other = {}
        for path, tree in self.trees.items():
            if path.split("/")[0] != FLIGHT:
                continue
            for node in descendants(tree):
                if node.type == "enumeration_type_definition":
                    names = [text_of(c) for c in node.children
                             if c.type == "identifier"]
                    for name, following in zip(names, names[1:] + names[:1]):
                        other.setdefault(name, following)
        return other

    def mutants(self):
        """Every mutant of every package, in the order of the sources."""
        literals = self.enumerations()
        found = []
        for path, tree in self.trees.items():
            if path.split("/")[0] == FLIGHT and (
                package_of(path) not in REAL_TIME_UNITS
            ):
                found += Finder(path, tree, self, literals).found
        return found


class Finder:
    """Goes through one source and collects its mutants."""

    def __init__(self, path, tree, code, literals):
        self.path = path
        self.code = code
        self.literals = literals
        self.found = []
        self.seen = Counter()
        self.visit(tree, [])

    def add(self, node, operator, new, where, old=None):
        old = text_of(node) if old is None else old
        row = node.start_point[0]
        subprogram = ".".join(where)
        context = squeezed(without_aspects(statement_of(node)))
        key = (Path(self.path).name, subprogram, operator, context, old, new)
        number = self.seen[key]
        self.seen[key] += 1
        digest = hashlib.sha256(repr((*key, number)).encode()).hexdigest()
        self.found.append(Mutant(
            digest[:10], self.path, subprogram, operator,
            node.start_byte, node.end_byte, old, new, row + 1,
        ))

    def calls_ghost(self, node):
        if node.type != "procedure_call_statement":
            return False
        name = text_of(node).split("(")[0].strip(" ;\n")
        return name.rsplit(".", 1)[-1] in self.code.ghosts

    def visit(self, node, where):
        if node.type in NOT_CODE:
            return
        if node.type in SUBPROGRAMS:
            name = subprogram_name(node)
            if name in self.code.ghosts or name in self.code.proof_only:
                return
            where = [*where, name]
        if has_aspect(node, "Ghost") or self.calls_ghost(node):
            return
        change = getattr(self, f"change_{node.type}", None)
        if change:
            change(node, where)
        for child in node.children:
            self.visit(child, where)

    # One procedure for each type of node that can be changed.

    def replace_token(self, node, table, operator, where):
        for new in table.get(text_of(node).lower(), ()):
            self.add(node, operator, new, where)

    def change_relational_operator(self, node, where):
        self.replace_token(node, RELATIONS, "relation", where)

    def change_binary_adding_operator(self, node, where):
        if text_of(node) != "&":
            self.replace_token(node, ADDING, "arithmetic", where)

    def change_multiplying_operator(self, node, where):
        self.replace_token(node, MULTIPLYING, "arithmetic", where)

    def change_expression(self, node, where):
        """and, or, xor: alone, or with then or else."""
        children = node.children
        for place, child in enumerate(children):
            if child.type not in LOGICAL:
                continue
            following = children[place + 1] if place + 1 < len(children) else 0
            if following and following.type in ("then", "else"):
                new = "or else" if child.type == "and" else "and then"
                self.add(Span(child, following), "logic", new, where)
            else:
                self.replace_token(child, LOGICAL, "logic", where)

    def change_factor_not(self, node, where):
        operand = text_of(node)[len("not"):].strip()
        self.add(node, "negation", f"({operand})", where)

    def change_relation_membership(self, node, where):
        text = text_of(node)
        if " not in " in text:
            new = text.replace(" not in ", " in ", 1)
        else:
            new = text.replace(" in ", " not in ", 1)
        if new != text:
            self.add(node, "negation", new, where)

    def change_numeric_literal(self, node, where):
        text = text_of(node)
        if "." in text:
            return
        digits = text.replace("_", "")
        if "#" in digits:
            base, mantissa = digits.split("#")[:2]
            value = int(mantissa, int(base))
            shown = "16#{:X}#".format
        else:
            value = int(digits)
            shown = str
        self.add(node, "constant", shown(value + 1), where)
        if value > 0:
            self.add(node, "constant", shown(value - 1), where)

    def negate(self, node, where):
        condition = node.child_by_field_name("condition")
        if condition is not None:
            self.add(condition, "condition", f"not ({text_of(condition)})",
                     where)

    change_elsif_statement_item = negate
    change_elsif_expression_item = negate

    def change_if_statement(self, node, where):
        self.negate(node, where)
        branches = [c for c in node.children
                    if c.type == "sequence_of_statements"]
        if child_of_type(node, "else") and len(branches) == 2:
            self.swap(*branches, where)

    def change_if_expression(self, node, where):
        self.negate(node, where)
        results = []
        for place, child in enumerate(node.children):
            if child.type in ("then", "else"):
                results.append(node.children[place + 1])
        if not child_of_type(node, "elsif_expression_item") and (
            len(results) == 2
        ):
            self.swap(*results, where)

    def swap(self, first, second, where):
        between = first.parent.text[
            first.end_byte - first.parent.start_byte:
            second.start_byte - first.parent.start_byte
        ].decode()
        span = Span(first, second)
        if text_of(first) != text_of(second):
            self.add(span, "branches",
                     text_of(second) + between + text_of(first), where)

    def delete(self, node, where):
        self.add(node, "deletion", "null;", where)

    change_assignment_statement = delete
    change_procedure_call_statement = delete

    def change_loop_parameter_specification(self, node, where):
        """One turn less, at the one end or the other."""
        parent = node.parent
        if parent.type != "iteration_scheme":
            return
        text = text_of(node)
        head, _, reach = text.partition(" in ")
        order = ""
        if reach.startswith("reverse "):
            order, reach = "reverse ", reach[len("reverse "):]
        if ".." in reach:
            low, _, high = reach.partition("..")
            low, high, kind = low.strip(), high.strip(), None
        elif "'Range" in reach:
            array = reach.split("'")[0]
            low, high, kind = f"{array}'First", f"{array}'Last", None
        else:
            kind = reach.strip()
            low, high = f"{kind}'First", f"{kind}'Last"
        if kind:
            later, earlier = f"{kind}'Succ ({low})", f"{kind}'Pred ({high})"
        else:
            later, earlier = f"{low} + 1", f"{high} - 1"
        for first, last in ((later, high), (low, earlier)):
            self.add(node, "range",
                     f"{head} in {order}{first} .. {last}", where)

    def change_attribute_designator(self, node, where):
        for new in ATTRIBUTES.get(text_of(node), ()):
            self.add(node, "attribute", new, where)

    def change_identifier(self, node, where):
        name = text_of(node)
        parent = node.parent
        if parent.type not in (
            "term", "expression", "function_call", "parameter_association",
            "discrete_choice", "membership_choice_list", "primary",
            "actual_parameter_part", "assignment_statement",
            "selected_component",
        ):
            return
        if parent.type in ("assignment_statement", "selected_component") and (
            node == parent.children[0]
        ):
            return
        if name in BOOLEANS:
            self.add(node, "literal", BOOLEANS[name], where)
        elif name in SHIFTS:
            self.add(node, "arithmetic", SHIFTS[name], where)
        elif name in self.literals and parent.type != "selected_component":
            self.add(node, "literal", self.literals[name], where)

    def change_record_delta_aggregate(self, node, where):
        """A component keeps its old value."""
        parts = child_of_type(node, "record_component_association_list")
        if parts is None:
            return
        text = text_of(parts)
        if text.count("=>") == 1:
            return
        names = [c for c in parts.children
                 if c.type == "component_choice_list"]
        for place, choice in enumerate(names):
            last = place + 1 == len(names)
            if last:
                before = parts.text[:choice.start_byte - parts.start_byte]
                kept = before.decode().rstrip().rstrip(",")
            else:
                following = names[place + 1]
                kept = (
                    parts.text[:choice.start_byte - parts.start_byte]
                    + parts.text[following.start_byte - parts.start_byte:]
                ).decode()
            self.add(parts, "component", kept, where)


class Span:
    """From the start of one node to the end of another, beside it."""

    type = "span"

    def __init__(self, first, last):
        self.parent = first.parent
        self.start_byte = first.start_byte
        self.end_byte = last.end_byte
        self.start_point = first.start_point
        base = self.parent.start_byte
        self.text = self.parent.text[
            self.start_byte - base:self.end_byte - base
        ]
        self.children = []


STATEMENTS = {
    "assignment_statement", "procedure_call_statement", "if_statement",
    "loop_statement", "case_statement", "simple_return_statement",
    "expression_function_declaration", "object_declaration",
    "number_declaration", "full_type_declaration", "subtype_declaration",
}


def statement_of(node):
    """The statement or declaration that a node is in."""
    while node.parent is not None and node.type not in STATEMENTS:
        node = node.parent
    return node


def without_aspects(node):
    """The text of a statement or declaration, but not its contract."""
    aspects = child_of_type(node, "aspect_specification")
    if aspects is None:
        return text_of(node)
    start, end = (place - node.start_byte
                  for place in (aspects.start_byte, aspects.end_byte))
    return node.text[:start].decode().rstrip() + node.text[end:].decode()


def package_of(path):
    return Path(path).stem


def ranked(mutants, seed):
    """In an order that a seed decides, one of each operator in turn."""
    def rank(mutant):
        return hashlib.sha256(f"{seed} {mutant.name}".encode()).digest()

    turns = Counter()
    order = []
    for mutant in sorted(mutants, key=rank):
        order.append((turns[mutant.operator], rank(mutant), mutant))
        turns[mutant.operator] += 1
    return [mutant for *_, mutant in sorted(order, key=lambda o: o[:2])]


def chosen(mutants, seed, share, least, most, tried=()):
    """A share of each package's mutants, within the least and the largest
    number. Those whose names are tried before stay chosen, whatever became of
    them."""
    by_package = {}
    for mutant in mutants:
        by_package.setdefault(package_of(mutant.path), []).append(mutant)
    picked = []
    for package in sorted(by_package):
        of_package = by_package[package]
        number = min(max(least, round(share * len(of_package))), most)
        order = ranked(of_package, seed)
        before = [mutant for mutant in order if mutant.name in tried]
        new = [mutant for mutant in order if mutant.name not in tried]
        picked += before + new[:max(0, number - len(before))]
    return picked

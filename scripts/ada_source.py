# SPDX-License-Identifier: Apache-2.0
"""Reads Ada, for the scripts: as text, or as a tree.

The tree is that of tree-sitter's grammar for Ada. It is loaded only for those
who parse: the proof's and the trace's scripts run with Python alone. The first
line of each source is its licence (EVI-13), and none of src is longer than one
reads (EVI-15).
"""

import re
from functools import cache

# A string may have two dashes, a character may be a quote.
COMMENT = re.compile(r"('\"'|\"[^\"\n]*\")|--[^\n]*")


def sources(root, *folders):
    """The Ada sources below these folders, but for the proof's canaries."""
    return [path for folder in folders
            for path in sorted((root / folder).rglob("*.ad[sb]"))
            if "canaries" not in path.relative_to(root).parts]


# --- text ------------------------------------------------------------------

DECLARATION = re.compile(
    r"^ *(?:overriding )?(?:"
    r"(?:with )?(?:procedure|function|package(?: body)?|type|subtype"
    r"|protected(?: type| body)?|task(?: type| body)?|entry) +"
    r"(?P<name>[\w.]+|\"[^\"]+\")"
    r"|(?P<object>\w+) *:(?!=) *"
    r"(?!in\b|out\b|not\b|aliased\b)[\w(])", re.M | re.I)
UNIT = re.compile(r"^(?:private )?package +(?:body +)?([\w.]+)", re.M | re.I)
WITHED = re.compile(r"^\s*(?:limited |private )*with ([\w.]+)", re.M)
# Brackets, a semicolon, or the `is` that begins a body.
TOKEN = re.compile(
    r"[();]|\bis\b(?!\s*(?:new|null|\(|abstract|separate|private|range|record"
    r"|mod|limited|array|access|tagged|digits|delta))")


def without_comments(text):
    """Lines stay where they are."""
    return COMMENT.sub(lambda found: found[1] or "", text)


def squeezed(text):
    return " ".join(text.split())


def code_of(text):
    """On one line, without comments."""
    return squeezed(without_comments(text))


def end_of(code, start):
    """The end of the declaration or body that begins at `start`: at its
    semicolon, for a body at the `end` of its indentation."""
    line_start = code.rfind("\n", 0, start) + 1
    indent = re.match(r" *", code[line_start:])[0]
    depth = 0
    place = start
    is_body = False
    for token in TOKEN.finditer(code, start):
        place = token.end()
        if token[0] == "(":
            depth += 1
        elif token[0] == ")":
            depth -= 1
        elif depth == 0 and token[0] == ";":
            break
        elif depth == 0:
            is_body = True
            break
    if is_body:
        ending = re.compile(rf"^{indent}end\b.*$", re.M).search(code, place)
        place = ending.end() if ending else place
    return place


def declarations(code):
    """Each name that a unit without comments declares, in lower case, with its
    first and last line."""
    heading = UNIT.search(code)
    for match in DECLARATION.finditer(code, heading.end()):
        start = match.start("name" if match["name"] else "object")
        yield ((match["name"] or match["object"]).lower(),
               code.count("\n", 0, start) + 1,
               code.count("\n", 0, end_of(code, start)) + 1)


def is_whole_declaration(text, imported):
    """A text begins with the declaration of a subprogram that is null or, if
    that may be, imported."""
    words, depth = "", 0
    for character in squeezed(without_comments(text)):
        depth += (character == "(") - (character == ")")
        if character == ";" and depth == 0:
            break
        words += character if depth == 0 else ""
    return (re.search(r"\bis null\b", words) is not None
            or imported and re.search(r"\bImport\b", words) is not None)


# --- tree ------------------------------------------------------------------

SUBPROGRAMS = {
    "subprogram_declaration", "subprogram_body",
    "expression_function_declaration", "null_procedure_declaration",
}


@cache
def parser():
    import tree_sitter
    import tree_sitter_ada
    return tree_sitter.Parser(
        tree_sitter.Language(tree_sitter_ada.language()))


def parsed(source):
    """The root of the tree of a source, given in bytes."""
    return parser().parse(source).root_node


def text_of(node):
    return node.text.decode()


def descendants(node):
    yield node
    for child in node.children:
        yield from descendants(child)


def child_of_type(node, *types):
    return next((c for c in node.children if c.type in types), None)


def aspects(node):
    """The aspects of a declaration: name and text, without comments."""
    specification = child_of_type(node, "aspect_specification")
    found = {}
    for part in descendants(specification) if specification else ():
        if part.type == "aspect_association":
            name, _, value = text_of(part).partition("=>")
            found.setdefault(name.strip(), without_comments(value))
    return found


def has_aspect(node, name):
    """True if a declaration has an aspect, a Ghost for example."""
    return name in aspects(node)


def specification_of(node):
    return child_of_type(
        node, "function_specification", "procedure_specification")


def subprogram_name(node):
    """The name a subprogram's declaration or body begins with."""
    part = specification_of(node) or node
    name = part.child_by_field_name("name")
    return text_of(name) if name else None

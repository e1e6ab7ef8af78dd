# SPDX-License-Identifier: Apache-2.0
"""The requirements, as docs/requirements.sdoc has them.

A reader for what that file uses of StrictDoc's format, so that the check
needs nothing installed. `make trace` has StrictDoc read the same file.
"""

import re
import textwrap
from dataclasses import dataclass

FILE = "docs/requirements.sdoc"

NODE = re.compile(r"^\[REQUIREMENT\]\n(.*?)(?=^\[|\Z)", re.M | re.S)
FIELD_ON_LINE = re.compile(
    r"^(?P<name>[A-Z]+): (?:>>>\n(?P<block>.*?)\n<<<|(?P<line>[^\n]*))\n",
    re.M | re.S)


@dataclass
class Requirement:
    """One requirement and what it is linked to, by name."""

    uid: str
    is_open: bool
    why_open: str
    code: list
    theorems: list
    tests: list


def names(text):
    """The names of a list with commas, on as many lines as it takes."""
    return text.replace(",", " ").split()


def parsed(text):
    """The requirements in the text of docs/requirements.sdoc, in order."""
    found = []
    for node in NODE.finditer(text):
        fields = {
            field["name"]: field["block"] or field["line"]
            for field in FIELD_ON_LINE.finditer(node[1])
        }
        found.append(Requirement(
            uid=fields["UID"],
            is_open=fields.get("STATUS") == "Open",
            why_open=fields.get("WHY", ""),
            code=names(fields.get("CODE", "")),
            theorems=names(fields.get("THEOREMS", "")),
            tests=names(fields.get("TESTS", "")),
        ))
    return found


def unread(text):
    """Lines of requirements that are no field, so that no link is lost."""
    left = []
    for node in NODE.finditer(text):
        left += FIELD_ON_LINE.sub("", node[1]).split("\n")
    return [line for line in left if line]


def with_links(text, links_of):
    """The same text with other links: `links_of` gives for a UID the names
    of each of the fields CODE, THEOREMS and TESTS. A field with these names
    already stays as it is written. A requirement that is Open and has tests is
    no longer Open, and needs no WHY."""

    def renewed(node):
        uid = re.search(r"^UID: (\S+)$", node[1], re.M)[1]
        links = links_of(uid)
        kept = "".join(
            field[0] for field in FIELD_ON_LINE.finditer(node[1])
            if field["name"] not in links
            and not (field["name"] in ("STATUS", "WHY") and links["TESTS"]))
        written = {field["name"]: field
                   for field in FIELD_ON_LINE.finditer(node[1])}
        fields = "".join(
            written[name][0] if has_names(written.get(name), wanted)
            else field_of((name, wanted)) for name, wanted in links.items())
        return f"[REQUIREMENT]\n{kept}{fields}\n"

    return NODE.sub(renewed, text)


def has_names(field, wanted):
    """True if a field of the file has these names, in any order."""
    return field is not None and sorted(names(
        field["block"] or field["line"])) == sorted(wanted)


def field_of(field):
    """A field as the file has it; nothing for one without names."""
    name, links = field
    if not links:
        return ""
    line = f"{name}: {', '.join(links)}\n"
    if len(line) <= 80:
        return line
    wrapped = textwrap.fill(", ".join(links), 79, break_long_words=False,
                            break_on_hyphens=False)
    return f"{name}: >>>\n{wrapped}\n<<<\n"


def with_relations(text, relations_of):
    """The same text with StrictDoc's relations to files.

    `relations_of` gives for a UID the role, file, first and last line of
    each.
    """

    def related(node):
        uid = re.search(r"^UID: (\S+)$", node[1], re.M)[1]
        relations = relations_of(uid)
        lines = ["RELATIONS:"] if relations else []
        for role, file, first, last in relations:
            lines += ["- TYPE: File", f"  ROLE: {role}", f"  PATH: {file}",
                      f"  LINE_RANGE: {first}, {last}"]
        return "\n".join([node[0].rstrip("\n"), *lines]) + "\n\n"

    return NODE.sub(related, text)

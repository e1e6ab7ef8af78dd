"""Every requirement has a test of its name, and no test names another."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
IDENTIFIER = re.compile(r"\b(?:FRM|INI|TST|BUF|KRN|MBX|SEM|ADI|AD|COR|TIN|TOU"
                        r"|MDI|MDO|GDI|GDO|PWM|SET|LNK|SIM|EXT|D)-\d+\b")

# Shown by the compiler and the proof alone, as their rows say.
SHOWN_OTHERWISE = {"SET-2", "MBX-5"}


def listed():
    """Identifiers of the table of requirements, and of all tables."""
    text = (ROOT / "docs" / "requirements.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| ([A-Z]+-\d+) \|", text, re.M)
    decisions = {row for row in rows if row.startswith("D-")}
    return set(rows) - decisions, decisions


def named_in_tests():
    names = ""
    for source in (ROOT / "tests" / "unit").glob("*.adb"):
        names += " ".join(re.findall(r'"([^"]*)"',
                                     source.read_text(encoding="utf-8")))
    for source in (ROOT / "tests" / "simulation").glob("test_*.py"):
        if source != Path(__file__):
            names += source.read_text(encoding="utf-8")
    return set(IDENTIFIER.findall(names))


def test_every_requirement_has_a_test():
    requirements, _ = listed()
    assert requirements - named_in_tests() - SHOWN_OTHERWISE == set()


def test_no_test_names_what_is_not_required():
    requirements, decisions = listed()
    assert named_in_tests() - requirements - decisions == set()

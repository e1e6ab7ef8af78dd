# SPDX-License-Identifier: Apache-2.0
"""A link from one page to another leads to something that is there (EVI-1)."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
PAGES = [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"),
         ROOT / "proofs" / "README.md"]
LINK = re.compile(r"\]\(([^)#]+)")


def links_to_nothing(page, text):
    return [link for link in LINK.findall(text)
            if not link.startswith("http")
            and not (page.parent / link).exists()]


@pytest.mark.parametrize(
    "page", PAGES, ids=[path.relative_to(ROOT).as_posix() for path in PAGES])
def test_links_lead_somewhere(page):
    assert links_to_nothing(page, page.read_text(encoding="utf-8")) == []


def test_a_link_to_nothing_is_found():
    page = ROOT / "docs" / "design.md"
    assert links_to_nothing(page, "[a](link.md#x), [b](gone.md)") == [
        "gone.md"]

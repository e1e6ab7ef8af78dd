# SPDX-License-Identifier: Apache-2.0
"""The pictures of README and docs/index.md (GND-33)."""

import re
import shutil
import struct
from pathlib import Path

import pytest
from conftest import ROOT

from urv import faults, pictures


def shown():
    """The pictures that the pages name."""
    return [f"docs/{name}" for page in ("README.md", "docs/index.md")
            for name in re.findall(r"\]\((?:docs/)?(pictures/\w+\.png)\)",
                                   (ROOT / page).read_text("utf-8"))]


def test_gnd33_the_pages_show_three_pictures_that_are_there():
    assert sorted(shown()) == [f"docs/pictures/{name}.png" for name in (
        "console", "report", "yamcs")]
    for name in shown():
        head = (ROOT / name).read_bytes()[:24]
        assert head[:8] == b"\x89PNG\r\n\x1a\n"
        width, height = struct.unpack(">II", head[16:24])
        assert width >= 1280 and height >= 800


def test_gnd33_without_chromium_it_says_so(monkeypatch, tmp_path):
    monkeypatch.setattr(shutil, "which", lambda _name, path=None: None)
    monkeypatch.delenv("URV_CHROMIUM", raising=False)
    with pytest.raises(faults.Refused, match="no Chromium"):
        pictures.pictures(Path(tmp_path / "made"))
    assert not (tmp_path / "made").exists()

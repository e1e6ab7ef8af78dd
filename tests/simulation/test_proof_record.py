"""EVI-8: what the proof takes for a subprogram that has no body to prove."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import proof_record  # noqa: E402

NULL = "procedure Refuse (Why : Word; How : Kind)\n  is null;\nprocedure Other;"
IMPORTED = "procedure Read (Data : out Byte)\nwith\n  Import,\n  Pre => True;"


@pytest.mark.parametrize(("text", "imported", "whole"), [
    (NULL, False, True),
    (IMPORTED, True, True),
    (IMPORTED, False, False),
    ("procedure Hide with SPARK_Mode => Off;\nprocedure Next is null;", True,
     False),
    ("procedure Work is  --  is null\nbegin\n  null;\nend Work;", True, False),
])
def test_only_what_is_null_or_on_the_bus_needs_no_body(
        text, imported, whole):
    lines = text.splitlines()
    assert proof_record.is_whole_declaration(lines, imported) is whole

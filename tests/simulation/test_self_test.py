# SPDX-License-Identifier: Apache-2.0
"""The self-test leaves out only memory that is not there."""

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# A type or a literal of floating or fixed point.
REAL = re.compile(r"\b(?:Long_|Short_)?Float\b|\bdigits\b|\bdelta\s+\d"
                  r"|\b\d[\d_]*\.\d", re.I)


def code(source):
    """The text without its comments and strings."""
    text = source.read_text(encoding="utf-8")
    return re.sub(r'"[^"\n]*"|--.*', "", text)


def test_tst_2_the_flight_software_has_no_floating_point():
    """TST-2: floating point is tested where it is used."""
    used = {
        str(source.relative_to(ROOT)): REAL.findall(code(source))
        for source in (ROOT / "src").rglob("*.ad?")
        if REAL.search(code(source))
    }
    assert used == {}

# SPDX-License-Identifier: Apache-2.0
"""EVI-5: no claim of a contract goes away unnoticed."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import claims  # noqa: E402

SPEC = """
package Shop with SPARK_Mode, Initializes => Till is

   subtype Even is Natural with Predicate => Even mod 2 = 0;

   procedure Sell (Item : in out Natural; Paid : out Boolean)
   with
     Global => (In_Out => Till),
     Pre    => Item > 0,
     Post   =>
       --  One less, and
       (Item = Item'Old - 1
        and then (Paid or else Item > 3))
       and then (if Paid then Item < 7 and then Item > 1)
       and then (for all I in 1 .. 3 => I < Item and then I > 0),
     Contract_Cases =>
       (Item > 5 => Paid and then Item > 4,
        others   => not Paid);

end Shop;
"""

CLAIMS = [
    "shop Shop Initializes: Till",
    "shop Shop Predicate: Even mod 2 = 0",
    "shop Sell Global: (In_Out => Till)",
    "shop Sell Post: Item = Item'Old - 1",
    "shop Sell Post: Paid or else Item > 3",
    "shop Sell Post: if Paid then Item < 7 and then Item > 1",
    "shop Sell Post: for all I in 1 .. 3 => I < Item and then I > 0",
    "shop Sell Contract_Cases: Item > 5 => Paid",
    "shop Sell Contract_Cases: Item > 5 => Item > 4",
    "shop Sell Contract_Cases: others => not Paid",
]


def claims_in(folder, text):
    (folder / "src").mkdir(exist_ok=True)
    (folder / "src" / "shop.ads").write_text(text, encoding="utf-8")
    return claims.claims(folder)


def test_each_part_of_a_contract_is_a_claim(tmp_path):
    found = claims_in(tmp_path, SPEC)
    assert [c.replace("shop Even", "shop Shop") for c in found] == CLAIMS


@pytest.mark.parametrize("part, gone", [
    ("\n        and then (Paid or else Item > 3)", CLAIMS[4]),
    ("\n       and then (if Paid then Item < 7 and then Item > 1)",
     CLAIMS[5]),
    (" and then Item > 4", CLAIMS[8]),
    (",\n        others   => not Paid", CLAIMS[9]),
    ("     Global => (In_Out => Till),\n", CLAIMS[2]),
])
def test_a_claim_that_is_removed_is_told(tmp_path, part, gone):
    before = claims_in(tmp_path, SPEC)
    after = claims_in(tmp_path, SPEC.replace(part, ""))
    told = list(claims.differences(before, after))
    assert told == [f"gone: {before[CLAIMS.index(gone)]}"]


def test_a_claim_made_twice_is_two(tmp_path):
    before = claims_in(tmp_path, SPEC + SPEC)
    after = claims_in(tmp_path, SPEC)
    assert len(list(claims.differences(before, after))) == len(CLAIMS)


def test_the_list_is_of_these_contracts():
    recorded = claims.CLAIMS.read_text(encoding="utf-8").splitlines()
    assert list(claims.differences(recorded, claims.claims(ROOT))) == []


@pytest.mark.parametrize("change, status, said", [
    (lambda lines: lines, 0, ""),
    (lambda lines: lines[1:], 1, "claims: new: "),
    (lambda lines: [*lines, "shop Sell Post: True"], 1,
     "claims: gone: shop Sell Post: True"),
    (lambda lines: [*lines, lines[0]], 1, "claims: gone: "),
])
def test_a_list_of_other_contracts_fails(
        tmp_path, monkeypatch, capsys, change, status, said):
    lines = claims.CLAIMS.read_text(encoding="utf-8").splitlines()
    changed = tmp_path / "claims.txt"
    changed.write_text("\n".join(change(lines)) + "\n", encoding="utf-8")
    monkeypatch.setattr(claims, "CLAIMS", changed)
    monkeypatch.setattr(sys, "argv", ["claims.py", "check"])
    assert claims.main() == status
    assert said in capsys.readouterr().out

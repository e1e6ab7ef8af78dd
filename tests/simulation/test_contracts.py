# SPDX-License-Identifier: Apache-2.0
"""EVI-7: each public subprogram has a complete contract, and one that has not
is found."""

import re
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "scripts"))

import contracts  # noqa: E402

SPEC = """
package Shop
  with SPARK_Mode, Abstract_State => (Till with Synchronous, External)
is

   type Basket is private;

   function Price (Item : Basket) return Natural
   with Global => null;

   function Doubled (Item : Natural) return Natural is (2 * Item)
   with Global => null;

   function Empty return Basket
   with
     Global => null,
     Post   => Price (Empty'Result) = 0;

   procedure Sell
     (Item    : in out Basket;
      By_Whom : Natural;
      Paid    : out Boolean)
   with
     Global => null,
     Post   => Price (Item) = 0 and then Paid = (Price (Item'Old) > 0);

   procedure Count (Coins : out Natural)
   with Global => (In_Out => Till);

private
   type Basket is new Natural;

   function Price (Item : Basket) return Natural is (Natural (Item));

   procedure Refund (Item : out Basket);
end Shop;
"""

# What is changed, and what must be found then.
PLANTED = {
    "no Global": (
        "(2 * Item)\n   with Global => null;", "(2 * Item);",
        "Doubled has no Global"),
    "a result that nothing is said of": (
        "Price (Empty'Result) = 0", "True",
        "Empty's postcondition does not speak of its result"),
    "a function without a body that is an expression": (
        "return Natural is (Natural (Item));", "return Natural;",
        "Price's postcondition does not speak of its result"),
    "a parameter that nothing is said of": (
        " and then Paid = (Price (Item'Old) > 0)", "",
        "Sell's postcondition does not speak of Paid"),
    "one of which only the old value is spoken": (
        "Price (Item) = 0 and then ", "",
        "Sell's postcondition does not speak of Item"),
    "what stands in a comment alone": (
        "Price (Item) = 0 and", "--  Item\n  1 = 1 and",
        "Sell's postcondition does not speak of Item"),
    "a state of its own that no task shares": (
        "(In_Out => Till)", "null",
        "Count's postcondition does not speak of Coins"),
}


def test_a_complete_contract_has_no_gap():
    assert list(contracts.unit_gaps(SPEC.encode())) == []


@pytest.mark.parametrize("what", PLANTED)
def test_a_planted_gap_is_found(what):
    text, instead, expected = PLANTED[what]
    assert text in SPEC
    changed = SPEC.replace(text, instead)
    assert list(contracts.unit_gaps(changed.encode())) == [expected]


def test_of_a_generic_with_formal_subprograms_nothing_is_asked():
    generic = "generic\n   with procedure Pay;\n"
    changed = SPEC.replace("(2 * Item)\n   with Global => null;", "(2 * Item);")
    text = changed.replace("\npackage", f"\n{generic}package")
    assert list(contracts.unit_gaps(text.encode())) == []


def theorem_gaps_where(root, change):
    """What is missing when change has been at the text of the theorems."""
    (root / "src").symlink_to(ROOT / "src")
    (root / "proofs").mkdir()
    text = (ROOT / contracts.THEOREMS).read_text(encoding="utf-8")
    (root / contracts.THEOREMS).write_text(change(text), encoding="utf-8")
    return list(contracts.theorem_gaps(root))


@pytest.mark.parametrize("name", ["Send", "Try_Claim"])
def test_a_procedure_without_its_theorem_is_found(tmp_path, name):
    assert theorem_gaps_where(tmp_path, lambda text: text.replace(
        f"procedure Of_{name}", f"procedure Of_Other_{name}")) == [
            f"{contracts.THEOREMS}: 1 procedures {name},"
            f" 0 Of_{name}"]


def test_of_each_procedure_of_a_name_there_is_a_theorem(tmp_path):
    one_of = re.compile(r"procedure Of_Take\b")
    number = len(one_of.findall(
        (ROOT / contracts.THEOREMS).read_text("utf-8")))
    assert number > 1
    assert theorem_gaps_where(tmp_path, lambda text: one_of.sub(
        "procedure Of_Other_Take", text, count=1)) == [
            f"{contracts.THEOREMS}: {number} procedures Take,"
            f" {number - 1} Of_Take"]


EQUATIONS = """
package Shop with Pure is
   procedure Sell (Item : in out Basket; Price : Natural)
   with Global => null, Post => {};
end Shop;
"""


@pytest.mark.parametrize("post, is_one", [
    ("Item = After_Sale (Item'Old, Price)", True),
    ("Item = After_Sale (Item'Old, Price) or else Price = 0", False),
    ("Item = Item", False), ("Item /= After_Sale (Item'Old, Price)", False),
    ("Count (Item) = Count (Item'Old) - 1", False), ("True", False)])
def test_an_equation_leaves_nothing_open(post, is_one):
    package = contracts.package_of(
        contracts.parsed(EQUATIONS.format(post).encode()))
    sale, = [node for node in contracts.parts(package)[0]
             if node.type in contracts.DECLARATIONS]
    assert contracts.is_equation(sale) is is_one


@pytest.mark.parametrize("gaps", [[], ["shop.ads: Sell has no Global"]])
def test_a_gap_fails(monkeypatch, capsys, gaps):
    monkeypatch.setattr(contracts, "gaps", lambda _: iter(gaps))
    assert contracts.main() == len(gaps)
    assert capsys.readouterr().out == "".join(f"{gap}\n" for gap in gaps)


def test_no_contract_has_a_gap():
    assert list(contracts.gaps(ROOT)) == []

# SPDX-License-Identifier: Apache-2.0
"""EVI-3, EVI-7: the mutants of a package, and the report of their results."""

import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "evidence" / "mutation"))

import fates  # noqa: E402
import flight_trials  # noqa: E402
import mutants  # noqa: E402
import report  # noqa: E402

SPEC = """
package Shop with Pure, SPARK_Mode is

   type State is (Open, Shut, Sold);
   type Stock is record
      Number : Natural := 0;
      Now    : State   := Open;
   end record
   with Predicate => Stock.Number < 7;

   function Is_Full (Item : Stock) return Boolean is
     (Item.Number >= 5 and then Item.Now = Open)
   with Post => Is_Full'Result = (Item.Number > 4);

   --  Only the contract below calls it.
   function Rest (Item : Stock) return Natural is (6 - Item.Number);

   procedure Lemma (Item : Stock)
   with Ghost, Global => null, Post => Rest (Item) > 2;

   procedure Sell (Item : in out Stock)
   with Pre => Rest (Item) < 6, Post => Item.Number = Item.Number'Old - 1;

end Shop;
"""

BODY = """
package body Shop with SPARK_Mode is

   procedure Lemma (Item : Stock) is
   begin
      pragma Assert (Item.Number > 3);
   end Lemma;

   procedure Sell (Item : in out Stock) is
   begin
      if not Is_Full (Item) then
         Item.Number :=
           Item.Number - 1;
      else
         Item := (Item with delta Now => Sold, Number => 0);
      end if;
      for I in State loop
         pragma Loop_Invariant (I >= State'First);
         Lemma (Item);
      end loop;
   end Sell;

end Shop;
"""


@pytest.fixture
def found(tmp_path):
    """Every mutant of a small package: where, operator, change."""
    folder = tmp_path / "src"
    folder.mkdir()
    (folder / "shop.ads").write_text(SPEC, encoding="utf-8")
    (folder / "shop.adb").write_text(BODY, encoding="utf-8")
    return mutants.Code(tmp_path).mutants()


def changes(found, operator):
    return {m.change for m in found if m.operator == operator}


def test_each_operator_changes_its_kind(found):
    assert changes(found, "relation") == {
        ">= -> >", ">= -> <", "= -> /=",
    }
    assert changes(found, "logic") == {"and then -> or else"}
    assert changes(found, "negation") == {
        "not Is_Full (Item) -> (Is_Full (Item))",
    }
    assert changes(found, "arithmetic") == {"- -> +"}
    assert "5 -> 6" in changes(found, "constant")
    assert "5 -> 4" in changes(found, "constant")
    assert changes(found, "condition") == {
        "not Is_Full (Item) -> not (not Is_Full (Item))",
    }
    assert "Item.Number := Item.Number - 1; -> null;" in changes(
        found, "deletion")
    assert changes(found, "range") == {
        "I in State -> I in State'Succ (State'First) .. State'Last",
        "I in State -> I in State'First .. State'Pred (State'Last)",
    }
    assert len(changes(found, "branches")) == 1
    assert changes(found, "component") == {
        "Now => Sold, Number => 0 -> Number => 0",
        "Now => Sold, Number => 0 -> Now => Sold",
    }
    assert "Sold -> Open" in changes(found, "literal")


def test_contracts_and_proof_aids_are_left_alone(found):
    for mutant in found:
        source = SPEC if mutant.path.endswith("ads") else BODY
        line = source.splitlines()[mutant.line - 1]
        for word in ("Post", "Pre", "Predicate", "pragma",
                     "6 - Item", "Lemma"):
            assert word not in line


def test_each_folder_of_src_has_its_turn_and_tests():
    folders = {path.name for path in (ROOT / "src").iterdir()}
    assert sorted(mutants.FOLDERS) == sorted(folders)
    for tests in flight_trials.FOLDER_TESTS.values():
        for name in tests:
            assert (ROOT / "tests/simulation" / name).exists()


# --- results, and what is said of them --------------------------------------

def result(name, fate, path="sim/one.adb"):
    return {"name": name, "fate": fate, "path": path, "line": 1,
            "change": f"{name} -> other"}


def test_evi3_a_table_counts_what_builds_by_fate():
    results = [result("a", "tests"), result("b", "tests"),
               result("c", fates.SURVIVED), result("d", fates.PASSED),
               result("e", fates.EQUIVALENT), result("f", fates.SURVIVED),
               result("g", fates.INVALID)]
    text, total = report.table(results, {"f"})
    assert total == {"tests": 2, "survived": 2, "equivalent": 2}
    assert report.score(total) == 50.0
    lines = text.splitlines()
    assert lines[1] == "|---|" + "--:|" * len(report.COLUMNS)
    assert lines[2] == "| `one` | 6 | 2 |  |  | 2 | 2 | 50.0% |"
    assert [line.split("|")[1].strip() for line in lines[2:]] == [
        "`one`", "**sim**", "**all**"]
    assert report.cells("x", {"tests": 2, "simulation": 0, "proof": 0,
                              "survived": 1, "equivalent": 0}).endswith(
        "| 66.6% |")


def test_evi3_a_survivor_is_judged_and_only_a_survivor():
    results = [result("a", "tests"), result("b", fates.SURVIVED)]
    total = {"tests": 1, "simulation": 0, "proof": 0, "survived": 1}
    one = {"name": "b", "change": "b -> other", "reason": "so"}
    assert list(report.problems(results, {"b": one}, total, 50)) == []
    for judgements, goal, said in (
            ({}, 50, "survives, not judged"),
            ({"b": one}, 51, "less than 51%"),
            ({"b": one, "a": one}, 50, "is no survivor"),
            ({"b": one | {"change": "c"}}, 50, "another change"),
            ({"b": one | {"reason": " "}}, 50, "without a reason")):
        found = list(report.problems(results, judgements, total, goal))
        assert len(found) == 1 and said in found[0]


def test_evi3_a_report_without_results_leaves_the_page(
        tmp_path, monkeypatch, capsys):
    page = tmp_path / "page.md"
    page.write_text("as it was")
    monkeypatch.setattr(fates, "RESULTS", tmp_path / "none.jsonl")
    monkeypatch.setattr(report, "DOCUMENT", page)
    assert report.main() == 1
    assert capsys.readouterr().out.startswith("mutation: no results: ")
    assert page.read_text() == "as it was"

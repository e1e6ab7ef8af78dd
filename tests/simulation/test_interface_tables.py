"""SET-2: what each task consumes and produces is what tables 1 to 10 of the
report say. tests/data/interface_tables.json has the tables.

A task is a generic package that sees nothing but its formal parameters. For
a variable of the table it has Receive_X or Send_X, in the node X_Variable's.
What is on another board has the formal that the data file names. A formal
beside the table has its reason there, a task beyond the tables too.
"""

import json
import re
from pathlib import Path

import pytest
from conftest import ROOT

DATA = json.loads(
    (ROOT / "tests/data/interface_tables.json").read_text(encoding="utf-8"))
TABLES = {table["unit"]: table for table in DATA["tables"]}
SOURCES = {path.name: path for path in (ROOT / "src").rglob("*.ad?")}
NODES = ("MCS", "GSC")

CONSUMED = "global variables consumed"
PRODUCED = "global variables produced"
OFF_BOARD = ("off-board variables consumed", "off-board variables produced")
OFF_BOARD_FORMALS = "formals of off-board variables"
BESIDE = "formals beside the table"


def code_of(unit):
    name = unit.lower().replace(".", "-") + ".ads"
    text = SOURCES[name].read_text(encoding="utf-8")
    return re.sub(r"--.*", "", text)


def formal_procedures(unit):
    """Names of the formal procedures of a generic package."""
    formals = re.search(r"^generic\b(.*?)^package\b", code_of(unit),
                        re.M | re.S)[1]
    return re.findall(r"\bwith\s+procedure\s+(\w+)", formals)


def instances(node):
    """For each generic unit that a node instantiates, the instance's name
    and its actual parameters."""
    found = {}
    for match in re.finditer(
            r"package\s+(\w+)\s+is\s+new\s+([\w.]+)\s*(?:\((.*?)\))?\s*;",
            code_of(node), re.S):
        actuals = dict(re.findall(r"(\w+)\s*=>\s*([\w.]+)", match[3] or ""))
        found.setdefault(match[2], []).append((match[1], actuals))
    return found


def by_table(table):
    """The formals that the table's variables stand for, and their actuals."""
    wanted = dict(table[OFF_BOARD_FORMALS])
    for formal, operation, variables in (
            ("Receive_", "Receive", table[CONSUMED]),
            ("Send_", "Send", table[PRODUCED])):
        for variable in variables:
            name = re.fullmatch(r"(\w+)_variable", variable)[1]
            name = name[0].upper() + name[1:]
            wanted[formal + name] = f"{name}_Variable.{operation}"
    return wanted


def test_ten_tables_are_there():
    assert [t["table"] for t in DATA["tables"]] == list(range(1, 11))
    for table in DATA["tables"]:
        has = any(table[kind] for kind in OFF_BOARD)
        assert has == bool(table[OFF_BOARD_FORMALS]), table["task"]


@pytest.mark.parametrize("unit", TABLES)
def test_a_task_sees_what_its_table_says(unit):
    wanted = set(by_table(TABLES[unit])) | set(TABLES[unit][BESIDE])
    assert set(formal_procedures(unit)) == wanted


@pytest.mark.parametrize("node, unit", [
    (node, unit) for unit, table in TABLES.items() for node in table["nodes"]
])
def test_a_node_connects_what_the_table_says(node, unit):
    [(name, actuals)] = instances(node)[unit]
    assert name == TABLES[unit]["task"]
    for formal, actual in by_table(TABLES[unit]).items():
        assert actuals[formal] == actual, formal


@pytest.mark.parametrize("node", NODES)
def test_set1_a_node_has_the_tasks_of_the_tables_and_no_others(node):
    in_node = {unit for unit in instances(node)
               if re.fullmatch(r"URV\.\w+_(Task|Handler)", unit)}
    in_tables = {unit for unit, table in TABLES.items()
                 if node in table["nodes"]}
    assert in_node - set(DATA["tasks beyond the tables"]) == in_tables


def test_each_task_has_a_table_or_a_reason():
    units = {"URV." + path.stem.removeprefix("urv-").lower()
             for path in map(Path, SOURCES) if path.suffix == ".ads"
             and re.search(r"^urv-.*_(task|handler)$", path.stem)}
    named = {*TABLES, *DATA["tasks beyond the tables"]}
    assert units == {"URV." + unit[4:].lower() for unit in named}
    assert all(DATA["tasks beyond the tables"].values())


@pytest.mark.parametrize("node", NODES)
def test_mbx1_each_variable_has_one_producer_and_one_consumer(node):
    all_instances = instances(node)
    ends = [actual for found in all_instances.values()
            for _, actuals in found for actual in actuals.values()]
    variables = [name for name, _ in all_instances["URVOS.Shared_Mailboxes"]]
    assert len(variables) > 5
    for variable in variables:
        assert ends.count(f"{variable}.Send") == 1, variable
        assert ends.count(f"{variable}.Receive") == 1, variable


@pytest.mark.parametrize("unit", TABLES)
def test_a_task_sees_no_state_but_through_its_formals(unit):
    name = unit.lower().replace(".", "-")
    text = "".join(SOURCES[name + ending].read_text(encoding="utf-8")
                   for ending in (".ads", ".adb"))
    units = re.findall(r"^with ([\w.]+);", text, re.M)
    assert "URV.Errors" in units
    for seen in units:
        spec = SOURCES[f"{seen.lower().replace('.', '-')}.ads"]
        declared = rf"^package {re.escape(seen)}\s+with\s[^;]*?\bPure\b"
        assert re.search(declared, spec.read_text("utf-8"), re.M), seen

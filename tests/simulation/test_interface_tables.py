# SPDX-License-Identifier: Apache-2.0
"""SET-2: what each task consumes and produces is what tables 1 to 10 of the
report say. tests/data/interface_tables.json has the tables.

A task is a generic package that sees nothing but its formal parameters: the
variables and boards of the table are formal objects, and its Global contract
names them. Here the calls of its body are read, with the node's actual objects
put in place of the formals, and the bodies of the node's own procedures that a
task is given. It calls Receive of what it consumes and Send of what it
produces; a call of a board or beside the table stands in the data file, with
its reason.
"""

import json
import re
from pathlib import Path

import pytest
from conftest import ROOT

DATA = json.loads(
    (ROOT / "tests/data/interface_tables.json").read_text(encoding="utf-8"))
TABLES = [(node, table) for table in DATA["tables"]
          for node in table["nodes"]]
UNITS = {table["unit"] for table in DATA["tables"]}
SOURCES = {path.name: path for path in (ROOT / "src").rglob("*.ad?")}
NODES = ("MCS", "GSC")

CONSUMED = "global variables consumed"
PRODUCED = "global variables produced"
OFF_BOARD = ("off-board variables consumed", "off-board variables produced")
OFF_BOARD_CALLS = "calls of off-board variables"
BESIDE = "calls beside the table"
INSTEAD = "another in its place"


def text_of(unit, ending=".ads"):
    return SOURCES[unit.lower().replace(".", "-") + ending].read_text("utf-8")


def code_of(unit, ending=".ads"):
    return re.sub(r"--.*", "", text_of(unit, ending))


def formals_of(unit):
    """The kinds of a generic package's formals by their names, in order."""
    part = re.search(r"^generic\b(.*?)^package\b", code_of(unit),
                     re.M | re.S)[1]
    formal = re.compile(r"\bwith\s+(procedure|function|package)\s+(\w+)"
                        r"|^\s*(type)\s+(\w+)"
                        r"|^\s*(\w+)\s*:\s*(in out\b)?", re.M)
    part = re.sub(r"\([^()]*\)", "", part)
    return {match[2] or match[4] or match[5]:
            match[1] or match[3] or match[6] or "in"
            for match in formal.finditer(part)}


def instances(node):
    """Each package that a node instantiates: its name, the generic unit, and
    the actuals by the formals' names."""
    found = []
    for name, unit, actuals in re.findall(
            r"package\s+(\w+)\s+is\s+new\s+(URV\.[\w.]+)\s*"
            r"(?:\(([^;]*)\))?\s*;", code_of(node), re.S):
        given = [actual.split("=>") for actual in actuals.split(",")]
        names = list(formals_of(unit))
        found.append((name, unit, {
            (pair[0] if len(pair) == 2 else names[place]).strip():
            pair[-1].strip() for place, pair in enumerate(given)}))
    return found


def body_of(node, procedure):
    """The body of one of the node's own procedures."""
    found = re.search(rf"^   procedure {procedure}\b.*?^   end {procedure};",
                      code_of(node, ".adb"), re.M | re.S)
    return found[0] if found else ""


def calls_of(node, unit, actuals):
    """A task's calls, as Object.Operation in the node."""
    kinds = formals_of(unit)
    calls = set()
    for object_, operation in re.findall(
            r"\b(\w+)\.(\w+)\b", code_of(unit, ".adb")):
        if kinds.get(object_) == "in out":
            calls.add(f"{actuals[object_]}.{operation}")
    for formal, kind in kinds.items():
        if kind == "procedure":
            actual = actuals[formal]
            if "." in actual:
                calls.add(actual)
            calls.update(
                f"{object_}.{operation}" for object_, operation in re.findall(
                    r"\b(\w+)\.(\w+) \(", body_of(node, actual)))
    return calls


def wanted_of(table):
    """The calls that a table asks for."""
    calls = {*table[OFF_BOARD_CALLS], *table[BESIDE]}
    for kind, operation in ((CONSUMED, "Receive"), (PRODUCED, "Send")):
        for variable in table[kind]:
            variable = table.get(INSTEAD, {}).get(
                variable, {"name": variable})["name"]
            name = re.fullmatch(r"(\w+)_variable", variable)[1]
            calls.add(f"{name[0].upper()}{name[1:]}_Variable.{operation}")
    return calls


def test_ten_tables_are_there():
    assert [t["table"] for t in DATA["tables"]] == list(range(1, 11))
    for table in DATA["tables"]:
        has = any(table[kind] for kind in OFF_BOARD)
        assert has == bool(table[OFF_BOARD_CALLS]), table["task"]


@pytest.mark.parametrize(
    "node, table", TABLES,
    ids=[f"{node}-{table['task']}" for node, table in TABLES])
def test_a_task_calls_what_its_table_says(node, table):
    [(unit, actuals)] = [(unit, actuals)
                         for name, unit, actuals in instances(node)
                         if name == table["task"]]
    assert unit == table["unit"]
    assert calls_of(node, unit, actuals) == wanted_of(table)


@pytest.mark.parametrize("node", NODES)
def test_set1_a_node_has_the_tasks_of_the_tables(node):
    """And no others, but those that another requirement asks for."""
    in_node = {name: unit for name, unit, _ in instances(node)
               if re.fullmatch(r"URV\.\w+_(Task|Handler)", unit)}
    assert {name for name, unit in in_node.items() if unit in UNITS} == {
        table["task"] for where, table in TABLES if where == node}


def test_each_task_has_a_table_or_a_requirement():
    units = {"urv." + path.stem.removeprefix("urv-")
             for path in map(Path, SOURCES) if path.suffix == ".ads"
             and re.search(r"^urv-.*_(task|handler)$", path.stem)}
    tables = {unit.lower() for unit in UNITS}
    assert units > tables
    known = set(re.findall(
        r"^UID: (\S+)$",
        (ROOT / "docs/requirements.sdoc").read_text("utf-8"), re.M))
    for unit in units - tables:
        head = text_of(unit).partition("\ngeneric\n")[0]
        assert known & set(re.findall(r"\b[A-Z]+-\d+\b", head)), unit


@pytest.mark.parametrize("node", NODES)
def test_set1_each_task_of_a_node_is_in_its_list_and_runs(node):
    """The compiler wants a row and a step for each name. Here each instance
    has a name, and each name its own instance's procedures."""
    tasks = {name: unit for name, unit, _ in instances(node)
             if unit.endswith("_Task")}
    listed = re.search(r"\btype Task_Name is\s*\(([^)]*)\)",
                       code_of(node))[1]
    assert {each.strip() for each in listed.split(",")} == {
        f"{name}_Task" for name in tasks}
    steps = set(re.findall(r"\bwhen (\w+) *=>\s*([\w.]+)(?: \(Now[^)]*\))?;",
                           body_of(node, "Run_Step")))
    assert steps - {("others", "null")} == {
        (f"{name}_Task", f"{name}.{procedure}")
        for name, unit in tasks.items()
        for procedure in ("Initialise", "Run_Transaction")
        if re.search(rf"\bprocedure {procedure}\b", code_of(unit))}


@pytest.mark.parametrize("node", NODES)
def test_mbx1_each_variable_has_one_producer_and_one_consumer(node):
    calls = [call for _, unit, actuals in instances(node)
             if re.search(r"_(Task|Handler)$", unit)
             for call in calls_of(node, unit, actuals)]
    variables = re.findall(r"^   (\w+_Variable)\s*:", code_of(node), re.M)
    assert len(variables) > 5
    for variable in variables:
        assert calls.count(f"{variable}.Send") == 1, variable
        assert calls.count(f"{variable}.Receive") == 1, variable


@pytest.mark.parametrize("unit", sorted(UNITS))
def test_a_task_sees_no_state_but_through_its_formals(unit):
    text = code_of(unit) + code_of(unit, ".adb")
    for seen in re.findall(r"^with ([\w.]+);", text, re.M):
        assert not re.search(r"^   \w+ *: *(?!constant)[\w.]+( :=.*)?;",
                             visible_part(seen), re.M), seen


def visible_part(unit):
    """A package's own declarations at its outermost level."""
    code = code_of(unit).partition("\nprivate\n")[0]
    return "" if re.search(r"^generic\b", code, re.M) else code

# SPDX-License-Identifier: Apache-2.0
"""The events of Theorems.Safety match the tasks' bodies: both call the same
decision functions, and receive and send the same variables in the same order.
A change of one side alone fails here."""

import re

import pytest
from conftest import ROOT

GROUND = "proofs/theorems-safety-ground_events.adb"
AIRCRAFT = "proofs/theorems-safety-aircraft_events.adb"

# Each task: the events' source, its procedures in the order of their calls,
# and the variables of the task that are not on the way of the commands.
TASKS = {
    "AD": (GROUND, ("Take_Last_Scan", "Follow_Scans", "Hand_On"), ()),
    "GDCOUT": (GROUND, ("Run_GDCOUT",), ("Uplink",)),
    "TELOUT": (GROUND, ("Run_TELOUT",), ()),
    "TELIN": (AIRCRAFT, ("Run_TELIN",), ()),
    "MDCIN": (AIRCRAFT, ("Run_MDCIN", "Pass_On"), ("Configuration",)),
    "LAW": (AIRCRAFT, ("Run_LAW",), ("Configuration", "Sensors")),
    "PWM": (AIRCRAFT, ("Run_PWM",), ()),
    "CORE": (AIRCRAFT, ("Run_CORE",), ("Downlink",)),
}

# Decision functions about a task's reports and its other receivers.
BESIDE = {
    "AD": set(),
    "GDCOUT": set(),
    "TELIN": {"Is_New", "Is_Missed", "Reason"},
    "MDCIN": {"Is_For_Laws", "Is_For_Recorder", "Is_Unknown",
              "Place_Out_Of_Range"},
    "LAW": set(),
    "PWM": set(),
    "CORE": set(),
}


def code_of(path):
    """A source without comments."""
    return re.sub(r"--.*", "", (ROOT / path).read_text("utf-8"))


def procedures(code):
    """The body of each procedure and function by its name."""
    found = {}
    for end in re.finditer(r"^   end (\w+);", code, re.M):
        head = [*re.finditer(rf"^   (?:procedure|function) {end[1]}\b",
                             code[:end.start()], re.M)]
        found[end[1]] = code[head[-1].start():end.start()]
    return found


def moves_of_task(task, beside):
    """The variables that the task's body receives and sends, in order."""
    if task == "AD":
        bodies = procedures(code_of("src/tasks/urv-ad_task.adb"))
        text = bodies["Take_Last_Scan"] + bodies["Discard_Late_Scan"] + (
            bodies["Follow_Scans"].replace(
                "Receiving.Receive_Step",
                "ADINT_Variable.Receive ADINT_Variable.Look")
            ) + bodies["Hand_On"]
    else:
        text = code_of(f"src/tasks/urv-{task.lower()}_task.adb")
    return [(variable, call) for variable, call in re.findall(
        r"\b(\w+)_Variable\.(Receive|Look|Send)\b", text)
        if variable not in beside]


def text_of_events(path, names):
    bodies = procedures(code_of(path))
    return "".join(bodies[name] for name in names)


@pytest.mark.parametrize("task", TASKS)
def test_d70_saf2_an_event_receives_and_sends_as_its_task_does(task):
    path, names, beside = TASKS[task]
    moves = [(variable, call) for call, variable in re.findall(
        r"\b(Receive|Look|Send)\s*\(Item\.(\w+)",
        text_of_events(path, names))]
    assert moves == moves_of_task(task, beside)


@pytest.mark.parametrize("task", BESIDE)
def test_d70_saf2_an_event_decides_with_its_tasks_functions(task):
    path, names, _ = TASKS[task]
    spec = code_of(f"src/tasks/urv-{task.lower()}_steps.ads")
    functions = set(re.findall(r"^   (?:function|procedure) (\w+)", spec, re.M))
    used = {name for name in functions if re.search(
        rf"\b{name}\b", code_of(f"src/tasks/urv-{task.lower()}_task.adb"))}
    assert BESIDE[task] <= used
    events = text_of_events(path, (*names, "Fly", "Words_Of")
                            if path == AIRCRAFT else names)
    assert [name for name in sorted(used - BESIDE[task])
            if not re.search(rf"\b{name}\b", events)] == []

# SPDX-License-Identifier: Apache-2.0
"""The two kinds of mutants: of the flight software, of what judges it."""

from pathlib import Path
from typing import Any, NamedTuple

import judge_trials
import mutants
from fates import ROOT
from flight_trials import FlightTrial


class Kind(NamedTuple):
    """Where the results stand; which share of a package is tried, how many at
    least and at most; what tries them; all there are; their order; the part
    of the page, and the least score."""

    results: Path
    judged: Path
    sample: tuple
    trial: Any
    every: Any
    turn: Any
    part: str
    goal: float


FOLDER = ROOT / "tests" / "mutation"


def flight_turn(path):
    """Folder by folder of src."""
    return mutants.FOLDERS.index(Path(path).parts[1]), path


KINDS = {
    "flight": Kind(
        FOLDER / "results.jsonl", FOLDER / "equivalent.toml",
        (0.15, 4, 10), FlightTrial,
        lambda: mutants.Code(ROOT).mutants(), flight_turn, "table", 95.0),
    "judges": Kind(
        FOLDER / "judges.jsonl", FOLDER / "judges.toml",
        (0.01, 1, 3), judge_trials.JudgeTrial,
        judge_trials.every_mutant, str, "judges", 90.0),
}

# SPDX-License-Identifier: Apache-2.0
"""docs/urv_sim.md says what bin/urv_sim takes, leaves and answers (SIM-1,
SIM-2), and its examples run. `urv_sim numbers` prints its table."""

import json
import os
import re
import subprocess
from itertools import pairwise

import pytest
from conftest import (
    COMMANDS,
    DOWNLINK_CHARACTERS,
    EXCHANGE,
    PROGRAM,
    ROOT,
    SENSORS,
    SERVOS,
    TIME_LIMIT_S,
    UPLINK_CHARACTERS,
    fly_in,
)
from test_flight import has_jsbsim

PAGE = (ROOT / "docs" / "urv_sim.md").read_text(encoding="utf-8")
BLOCKS = re.findall(r"^```(sh|console)\n(.*?)^```$", PAGE, re.M | re.S)
CODE = re.findall(r"`([^`\n]+)`", PAGE)
CELL = re.compile(r"(?<!\\)\|")


def rows(section):
    """The rows of a section's tables, cells without marks of code."""
    text = PAGE.partition(f"\n## {section}\n")[2].partition("\n## ")[0]
    return [[cell.strip().replace("\\|", "|") for cell in
             CELL.split(line)[1:-1]]
            for line in text.splitlines()
            if line.startswith("|") and not line.startswith("|---")]


def names_in(section):
    """Everything in code in the first column of its tables."""
    return [name for row in rows(section)
            for name in re.findall(r"`([^`]+)`", row[0])]


@pytest.fixture
def told(urv_sim):
    return urv_sim("help").stdout


# --- the page and the program ----------------------------------------------

def test_the_page_has_every_option_and_no_other(told):
    of_help = re.findall(r"^  (--[a-z-]+(?: [A-Z]+)?)", told, re.M)
    assert len(of_help) == 29
    assert names_in("Options of `fly`") == of_help
    on_page = {option for code in [*CODE, *(text for _, text in BLOCKS)]
               for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", code)}
    assert on_page - {"--option"} == \
        {option.split()[0] for option in of_help} | {"--version"}


def test_the_page_has_every_fault_and_no_other(told):
    listed = told.partition("\nfaults, one a line")[2].partition("\n\n")[0]
    of_help = re.findall(r"^  (TIME_MS .*)$", listed, re.M)
    assert len(of_help) == 17
    assert [form.strip("`") for form, *_ in rows("Faults")[1:]] == of_help


def test_the_page_has_every_condition_and_no_other(told):
    listed = told.partition("\nconditions, one a line")[2].partition("\n\n")
    of_help = [line.strip() for line in listed[0].splitlines()[1:]]
    assert len(of_help) == 8
    assert [form.strip("`") for form, *_ in rows("Conditions")[1:]] == of_help


def test_ext2_the_page_has_every_order_and_no_other(told):
    listed = told.partition("\norders, one a line")[2].partition("\n\n")[0]
    of_help = re.findall(r"^  (TIME_MS .*)$", listed, re.M)
    assert len(of_help) == 2
    assert [form.strip("`") for form, *_ in rows("Orders")[1:]] == of_help


def test_the_page_has_every_column_and_field(tmp_path):
    """The columns of every output, and of the input files."""
    (tmp_path / "faults.txt").write_text("17000 cut 60000\n")
    options = ["--faults", "faults.txt"]
    if has_jsbsim():
        options += ["--plant", "jsbsim", "--pilot", "standard",
                    "--laws", "off"]
    flight = fly_in(tmp_path, *options)
    (tmp_path / "laws").mkdir()
    lawful = fly_in(tmp_path / "laws", "--seconds", "1", "--laws", "on")

    groups = [name for name in names_in("Record") if name.endswith(".*")]
    for column in (*flight.record, *lawful.record):
        assert column in CODE or any(
            column.startswith(group[:-1]) for group in groups), column
    if has_jsbsim():
        truth = [name for name in flight.record if name.startswith("truth.")]
        assert [name for name in names_in("Record")
                if name.startswith("truth.") and name != "truth.*"] == truth

    summary = flight.summary
    fields = [*summary, *summary["link"], *summary["latency_ms"],
              *summary.get("flight_quality", ())]
    for name in fields:
        assert name in CODE, name
    if has_jsbsim():
        (tmp_path / "circuit").mkdir()
        other = fly_in(tmp_path / "circuit", "--plant", "jsbsim", "--pilot",
                       "circuit").summary
        assert "flight_quality" not in other
        assert {*names_in("Summary")} == {
            *summary, *summary["flight_quality"],
            "circuit", *other["circuit"],
            # Only of a flight in which one failed.
            "failed_surfaces"}

    assert names_in("Wire") == ["time_us", "direction", "byte"]
    event = next(iter(flight.events.values()))
    assert names_in("Events") == [*event]


@pytest.mark.parametrize("option", ["--sticks", "--sensors"])
def test_the_page_has_every_column_of_the_input(urv_sim, write, option):
    write("in.csv", "time_ms,oops\n0,1\n")
    said = urv_sim("fly", option, "in.csv").stderr
    names = said.partition("there are ")[2].strip().split(", ")
    assert len(names) in (14, 29)
    for name in names:
        assert name in CODE or re.fullmatch("switch[2-7]", name), name


def test_the_page_has_every_exit_status(told):
    statuses = {row[0] for row in rows("Exit status")[1:]}
    assert statuses == {"0", "1", "2", "130"}
    assert {*re.findall(r"\b\d+\b", told.partition("exit status:")[2]
                        .partition("\n\n")[0])} == statuses


# --- its examples ----------------------------------------------------------

@pytest.fixture
def shell(tmp_path):
    """Run a script in a folder that has the program where the page says."""
    (tmp_path / "bin").mkdir()
    (tmp_path / "bin" / "urv_sim").symlink_to(PROGRAM)

    def run(script, *options):
        return subprocess.run(
            ["bash", *options, "-c", script], cwd=tmp_path,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, timeout=TIME_LIMIT_S,
            check=False)

    return run


@pytest.mark.parametrize(
    "script", [text for kind, text in BLOCKS if kind == "sh"])
def test_each_example_runs(shell, script):
    if "jsbsim" in script and not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")
    assert "bin/urv_sim" in script
    result = shell(script, "-e", "-o", "pipefail")
    assert result.returncode == 0, result.stdout
    assert result.stdout


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="no /dev/full")
def test_each_answer_is_as_printed(shell):
    texts = [text for kind, text in BLOCKS if kind == "console"]
    assert texts
    for text in texts:
        lines = text.splitlines()
        starts = [place for place, line in enumerate(lines)
                  if line.startswith("$ ")]
        for start, end in pairwise([*starts, len(lines)]):
            result = shell(lines[start][2:])
            assert result.stdout.splitlines() == lines[start + 1:end]


def test_the_example_of_the_truth_cuts_out_time_and_truth(fly):
    if not has_jsbsim():
        pytest.skip("JSBSim is not installed: make fly installs it")
    place = int(re.search(r"cut -d, -f2,(\d+)-", PAGE)[1])
    record = fly("--plant", "jsbsim", "--seconds", "0.1").record
    assert [*record][place - 1] == "truth.altitude_ft"


# --- faults ----------------------------------------------------------------

EXAMPLES = [row[1].strip("`") for row in rows("Faults")[1:]]

# Counts in three seconds that would not be there without the fault; the harm
# to a memory is found in a start that follows.
SEEN = {
    "cut": {"gsc.telin_no_block": 25, "mcs.telin_no_block": 25},
    # 270 bits a block, 100 blocks and a quarter of them once more.
    "ber": {"mcs.link_block_bad": pytest.approx(28, abs=12)},
    "replay": {},
    "flip": {"gsc.link_block_bad": 1},
    "drop": {"gsc.link_block_bad": 1},
    "dup": {"mcs.link_block_bad": 1},
    "insert": {"gsc.link_block_bad": 1},
    "stall": {"gsc.link_block_not_taken": 1},
    "reset": {"mcs.processor_restart": 1},
    "rom": {"mcs.self_test_failed": 1},
    "ram": {"gsc.self_test_failed": 1},
    "halt": {},
    "bus_error": {"mcs.processor_restart": 1},
    "console": {"gsc.ad_no_scan": 75},
}
# For servos, which are not counted, the position of the aileron after three
# seconds.
PLACES = {"stuck": 1500, "float": 2048, "slow": pytest.approx(2450, abs=250)}
START = {"rom": "2000 mcs reset warm\n", "ram": "2000 gsc reset warm\n"}


def kind_of(example):
    words = example.replace(" surface left_aileron ", " ").split()
    return words[2] if words[1] in ("up", "down", "mcs", "gsc") else words[1]


@pytest.mark.parametrize("example", EXAMPLES)
def test_each_fault_of_the_page_is_seen(fly, write, example):
    kind = kind_of(example)
    write("faults.txt", example + "\n" + START.get(kind, ""))
    write("sticks.csv", "time_ms,roll\n0,2048\n2000,3000\n")
    flight = fly("--faults", "faults.txt", "--sticks", "sticks.csv",
                 "--seconds", "4")
    if kind in PLACES:
        assert flight.record["mcs.downlink.left_aileron"][125] == PLACES[kind]
    events = flight.summary["events"]
    for name, count in SEEN.get(kind, {}).items():
        assert events.get(name, 0) == count, events


def test_the_page_has_an_example_of_each_kind():
    assert [*map(kind_of, EXAMPLES)] == [*SEEN, *PLACES]


def test_no_table_is_cut_by_a_blank_line():
    """A row without a head before it is no row where the page is shown."""
    for page in sorted((ROOT / "docs").rglob("*.md")):
        lines = page.read_text("utf-8").splitlines()
        for number, line in enumerate(lines):
            begins = line.startswith("|") and (
                number == 0 or not lines[number - 1].startswith("|"))
            if begins:
                assert set(lines[number + 1]) <= set("|-: "), (
                    page, number + 1)


# --- the table of numbers ------------------------------------------------------

def numbers(urv_sim):
    result = urv_sim("numbers")
    assert (result.returncode, result.stderr) == (0, "")
    return json.loads(result.stdout)


def test_numbers_are_those_of_the_page(urv_sim):
    page = (ROOT / "docs" / "urv_sim.md").read_text(encoding="utf-8")
    rows = [[cell.strip(" `") for cell in line.strip("|").split("|")]
            for line in page.partition("## Numbers")[2].partition("\n## ")[0]
            .splitlines() if line.startswith("| `")]
    assert numbers(urv_sim) == {name: int(value) for name, value, _ in rows}


def test_numbers_fit_the_words(urv_sim):
    """The tests' knowledge of the buffers (BUF-1, BUF-2, D-5)."""
    said = numbers(urv_sim)
    assert said["uplink_words"] == len(COMMANDS) + 1
    assert said["downlink_words"] == len(SENSORS) + 1
    assert said["pwm_words"] == len(SERVOS)
    assert said["uplink_characters"] == UPLINK_CHARACTERS
    assert said["downlink_characters"] == DOWNLINK_CHARACTERS
    assert said["exchange_up_characters"] == EXCHANGE["up"]
    assert said["exchange_down_characters"] == EXCHANGE["down"]


def test_numbers_are_those_of_a_flight(urv_sim, fly):
    """How far apart rows are, and characters of one message."""
    said = numbers(urv_sim)
    flight = fly("--seconds", "1")
    times_ms = flight.record["time_ms"]
    assert {1000 * (after - before) for before, after in zip(
        times_ms, times_ms[1:], strict=False)} == {said["frame_us"]}
    assert min(after.time_us - before.time_us for before, after in zip(
        flight.wire, flight.wire[1:], strict=False)) == said["character_us"]
    assert said["frame_us"] == said["frame_ticks"] * said["tick_us"]

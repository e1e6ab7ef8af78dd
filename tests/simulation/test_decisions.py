# SPDX-License-Identifier: Apache-2.0
"""The decisions D-40 to D-49 state the differences between software and
report. Their statements about the sources are true: a change that makes a
decision untrue fails here, and then the decision is to be renewed."""

import re

from conftest import ROOT

NODES = ("src/nodes", "src/tasks", "real_time", "sim")


def text_of(path):
    """A source without comments."""
    return re.sub(r"--.*", "", (ROOT / path).read_text("utf-8"))


def sources(*folders):
    return [path.relative_to(ROOT) for folder in folders
            for path in sorted((ROOT / folder).rglob("*.ad[bs]"))]


def users(word, *folders):
    """The sources whose text has the word."""
    return [str(path) for path in sources(*folders)
            if re.search(rf"\b{word}\b", text_of(path), re.IGNORECASE)]


def test_d40_a_header_has_no_address_and_nobody_calls_start():
    tree = text_of("src/kernel/scheduling/urvos-task_trees.ads")
    header = re.search(r"type Task_Header is record(.*?)end record", tree,
                       re.DOTALL)[1]
    assert re.findall(r"^\s+(\w+)\s*:[^=]", header, re.M) == [
        "Id", "Start_Time", "Initial_Priority"]
    calls = text_of("src/kernel/scheduling/urvos-kernel_calls.ads")
    assert "start" not in calls.lower()


def test_d41_both_warm_starts_have_one_routine():
    routines = text_of("src/nodes/urv-start_routines.adb")
    given = dict(re.findall(r"(\w+)\s+=>\s+(\w+)", routines))
    assert given["Warm_Reset"] == given["Processor_Restart"]
    assert given["Cold_Start"] != given["Warm_Reset"]


def test_d42_nobody_reads_the_vector():
    assert users("Vector", "src", "real_time") == [
        "src/devices/devices-ad_board.ads"]


def test_d43_law_gets_whole_buffers():
    law = text_of("src/tasks/urv-law_task.ads")
    assert re.search(r"Commands_Variable\s*:\s*in out For_Uplink", law)
    assert re.search(r"Sensors_Variable\s*:\s*in out For_Downlink", law)


def test_d44_the_rom_under_test_is_made():
    assert "function New_Image" in text_of("host/host-memory_hardware.adb")


def test_d45_no_node_uses_semaphores_or_ends_a_task():
    for word in ("Semaphore_Calls", "Shared_Semaphores", "Terminate_Call",
                 "Misses"):
        assert users(word, *NODES) == [], word
        assert users(word, "examples"), word


def test_d46_a_node_has_one_to_four_processors_by_its_list():
    assert re.search(r"type Processor_Number is range 1 \.\. 4;",
                     text_of("src/kernel/scheduling/urvos-task_trees.ads"))
    # The lists alone say which tasks run where.
    for node in ("mcs", "gsc"):
        places = re.findall(r"_Task +=> \(Report => \(\d, (\d)\),"
                            r" +Fast => \(\d, (\d)\)\)",
                            text_of(f"src/nodes/{node}.ads"))
        for schedule in zip(*places, strict=True):
            assert set(schedule) == {"1", "2", "3", "4"}, (node, schedule)


def test_d48_the_laws_know_no_codes():
    # A configuration and a test card are kinds of messages.
    assert users("Type_Codes", "src/laws") == [
        "src/laws/urv-card_blocks.ads", "src/laws/urv-configurations.ads"]


def test_d49_only_the_table_of_items_knows_scales():
    assert users("Scaling", "src") == []


def test_d47_the_channels_codes_are_constants():
    codes = text_of("src/formats/urv-type_codes.ads")
    for name in ("Stick_Codes", "Sensor_Codes"):
        assert re.search(rf"function {name} return Channel_Codes is\s*\(\[for",
                         codes), name


def test_d48_the_page_about_porting_names_what_there_is():
    """Its files, and the operations that a board's code calls."""
    page = (ROOT / "docs/porting.md").read_text("utf-8")
    named = re.findall(r"`([^`\n]+)`", page)
    paths = [name for name in named
             if "/" in name and not set(name) & set(" <")
             and not name.startswith("bin/")]
    assert len(paths) > 40
    assert [path for path in paths if not list(ROOT.glob(path))] == []
    text = "".join(text_of(path) for path in sources("src"))
    for name in set(re.findall(r"\b(?:MCS|GSC)(?:\.\w+)+", " ".join(named))):
        for part in name.split(".")[1:]:
            assert re.search(rf"\b{part}\b", text), name

# SPDX-License-Identifier: Apache-2.0
"""SIM-1: what urv_sim says, where its outputs go, and how it ends: flown,
interrupted, or with nowhere left to write."""

import json
import os
import pathlib
import pty
import re
import resource
import select
import shutil
import signal
import subprocess
import sys
import time
import tomllib

import pytest
from conftest import (
    COMMANDS,
    FRAMES_PER_S,
    PROGRAM,
    ROOT,
    TIME_LIMIT_S,
    fly_in,
    run_program,
)
from test_flight import has_jsbsim
from test_input import ALL_OUTPUTS, OPTIONS

sys.path.insert(0, str(ROOT / "scripts"))
import tree_copy  # noqa: E402

OUTPUT_OPTIONS = ALL_OUTPUTS[::2]
FILE_OF = dict(zip(ALL_OUTPUTS[::2], ALL_OUTPUTS[1::2], strict=True))

NO_SPACE = "No space left on device"
BROKEN_PIPE = "Broken pipe"

needs_jsbsim = pytest.mark.skipif(
    not has_jsbsim(), reason="JSBSim is not installed: make fly installs it")
needs_full_device = pytest.mark.skipif(
    not os.path.exists("/dev/full"), reason="no /dev/full")


def without_speed(summary):
    return {name: value for name, value in summary.items() if name != "speed"}


# --- help and version ------------------------------------------------------

def test_version_is_that_of_alire_toml(urv_sim):
    crate = tomllib.loads((ROOT / "alire.toml").read_text(encoding="utf-8"))
    result = urv_sim("--version")
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == f"urv_sim {crate['version']}\n"


def test_help_is_given_whole_or_of_one_command(urv_sim):
    said = {words: urv_sim(*words.split()) for words in (
        "help", "--help", "-h", "help fly", "help items",
        "help numbers", "fly --help",
        "fly --seconds 5 -h")}
    for result in said.values():
        assert (result.returncode, result.stderr) == (0, "")
    text = {words: result.stdout for words, result in said.items()}
    assert text["help"] == text["--help"] == text["-h"]
    assert text["help fly"] == text["fly --help"] == text["fly --seconds 5 -h"]
    for part in ("help fly", "help items", "help numbers"):
        assert text[part] in text["help"] and text[part] != text["help"]
    for option in OPTIONS:
        assert re.search(rf"^  {option}\b", text["help fly"], re.M), option
    assert "--seconds" not in text["help items"]


# --- outputs to standard output --------------------------------------------

@pytest.mark.parametrize("option", OUTPUT_OPTIONS)
def test_an_output_to_standard_output_is_that_of_the_file(
        tmp_path, urv_sim, option):
    flight = fly_in(tmp_path, "--seconds", "1")
    result = urv_sim("fly", "--seconds", "1", option, "-")
    assert result.returncode == 0
    if option == "--summary":
        assert without_speed(json.loads(result.stdout)) == \
            without_speed(flight.summary)
    else:
        assert result.stdout == flight.path(FILE_OF[option]).read_text()
    # The summary for people goes elsewhere.
    assert result.stderr.startswith("flown     1.00 s, 50 frames, ")
    assert not (tmp_path / "-").exists()

    quiet = urv_sim("fly", "--seconds", "1", option, "-", "--quiet")
    assert (quiet.returncode, quiet.stderr) == (0, "")


def test_only_one_output_goes_to_standard_output(urv_sim):
    result = urv_sim("fly", "--record", "-", "--wire=-")
    assert (result.returncode, result.stdout) == (2, "")
    assert result.stderr == \
        "urv_sim: --wire and --record name the same file\n"


def test_a_file_may_have_the_name_of_standard_output(urv_sim, tmp_path):
    result = urv_sim("fly", "--seconds", "1", "--record", "./-", "--wire", "-")
    assert result.returncode == 0
    assert (tmp_path / "-").read_text().startswith("frame,time_ms,")
    assert result.stdout.startswith("time_us,direction,byte\n")


def test_what_is_printed_is_what_the_summary_says(fly, write):
    """Each number has its own value, so that none replaces another."""
    write("sticks.csv", "time_ms,roll\n" + "".join(
        f"{100 + 61.3 * n:.3f},{n + 1}\n" for n in range(120)))
    write("faults.txt", "1000 cut 95\n2000 up ber 0.004 3000\n"
          "2500 down ber 0.002 4000\n")
    flight = fly("--sticks", "sticks.csv", "--faults", "faults.txt",
                 "--seconds", "8")
    summary, link = flight.summary, flight.summary["link"]
    for names in (("uplink_bad", "uplink_scrapped", "downlink_bad",
                   "downlink_scrapped", "uplink_sent", "downlink_sent",
                   "uplink_received", "downlink_received"),
                  ("gsc_resets", "mcs_resets")):
        assert len({link[name] for name in names}) == len(names), link
    times = summary["latency_ms"]
    shown = [times[name] for name in ("min", "median", "p99", "max")]
    assert shown == sorted(set(shown))
    lines = flight.stdout.splitlines()
    for way in ("uplink", "downlink"):
        assert f"{way:10}" + ", ".join(
            f"{link[f'{way}_{what}']} {what}"
            for what in ("sent", "received", "bad", "scrapped")) in lines
    assert (f"resets    {link['gsc_resets']} of the ground's link,"
            f" {link['mcs_resets']} of the aircraft's") in lines
    assert ("latency   {:.3f} ms at least, {:.3f} median, {:.3f} p99,"
            " {:.3f} at most, of {} changes").format(
                *shown, times["measured"]) in lines
    assert (f"flown     8.00 s, 400 frames, at {summary['speed']:.1f}"
            " times real time") in lines


def test_the_speed_is_that_of_the_flight(fly):
    """The flight time in an interval, by a clock beside it, to the tenth: the
    program took a little more than the flight."""
    began = time.monotonic()
    flight = fly("--seconds", "2", "--pace", "realtime")
    took = time.monotonic() - began
    assert 1.98 / took - 0.05 <= flight.summary["speed"] <= 1.1


# The machine's date is set to another hour, half a second after the start.
CHANGED_DATE = """\
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <sys/time.h>
#include <time.h>

static long added(void)
{
   static struct timespec first;
   static int (*read)(clockid_t, struct timespec *);
   struct timespec now;
   if (!read)
      read = dlsym(RTLD_NEXT, "clock_gettime");
   read(CLOCK_MONOTONIC, &now);
   if (!first.tv_sec)
      first = now;
   return now.tv_sec - first.tv_sec + (now.tv_nsec - first.tv_nsec) / 1e9
      > 0.5 ? atol(getenv("ADDED_S")) : 0;
}

int clock_gettime(clockid_t which, struct timespec *now)
{
   int (*read)(clockid_t, struct timespec *) =
      dlsym(RTLD_NEXT, "clock_gettime");
   int result = read(which, now);
   if (which == CLOCK_REALTIME)
      now->tv_sec += added();
   return result;
}

int gettimeofday(struct timeval *now, void *zone)
{
   int (*read)(struct timeval *, void *) = dlsym(RTLD_NEXT, "gettimeofday");
   int result = read(now, zone);
   now->tv_sec += added();
   return result;
}
"""


@pytest.mark.parametrize("added_s", [3600, -3600])
def test_sim1_a_changed_date_changes_no_pace(tmp_path, monkeypatch, added_s):
    (tmp_path / "date.c").write_text(CHANGED_DATE)
    subprocess.run(
        ["gcc", "-shared", "-fPIC", "-o", "date.so", "date.c", "-ldl"],
        cwd=tmp_path, check=True, timeout=TIME_LIMIT_S)
    monkeypatch.setenv("LD_PRELOAD", str(tmp_path / "date.so"))
    monkeypatch.setenv("ADDED_S", str(added_s))
    began = time.monotonic()
    with subprocess.Popen(
            [PROGRAM, "fly", "--seconds", "2", "--pace", "realtime",
             "--quiet", "--summary", "summary.json"],
            cwd=tmp_path) as process:
        try:
            assert process.wait(60) == 0
        finally:
            process.kill()
    took = time.monotonic() - began
    assert took >= 1.9
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert 1.98 / took - 0.05 <= summary["speed"] <= 1.1


def test_numbers_of_the_summary_are_as_people_write_them(fly, write):
    write("sticks.csv", "time_ms,roll\n100.192,1\n300.2,2\n")
    flight = fly("--sticks", "sticks.csv", "--seconds", "1")
    text = flight.path("summary.json").read_text()
    # The console is sampled 20 ms apart: latencies are not round.
    assert '"min": 69.8,' in text and '"max": 69.808,' in text
    assert '"seconds": 1,' in text
    numbers = re.findall(r'": ([-+.\deE]+),?$', text, re.M)
    assert len(numbers) > 40
    for number in numbers:
        assert re.fullmatch(r"-?(0|[1-9]\d*)(\.\d*[1-9])?", number), number


# --- events of a clean start -----------------------------------------------

USUAL = "  (at every start, until the first message)"


def events_on_screen(result):
    lines = result.stdout.splitlines()
    assert "events" in lines
    return [line for line in lines[lines.index("events") + 1:]
            if line.startswith("  ")]


@pytest.mark.parametrize("phase", range(10))
def test_what_every_start_gives_is_explained(fly, phase):
    flight = fly("--seconds", "2", "--phase", phase)
    events = events_on_screen(flight)
    assert len(events) == len(flight.summary["events"]) > 0
    for event in events:
        assert event.endswith(USUAL), event


def test_what_a_fault_gives_is_not_explained_away(fly, write):
    # The first messages do not come when every start has them.
    write("faults.txt", "0 cut 100\n")
    flight = fly("--seconds", "2", "--faults", "faults.txt")
    counts = flight.summary["events"]
    for node in ("gsc", "mcs"):
        assert counts[f"{node}.no_input"] > 3
        assert f"  {node}.no_input {counts[f'{node}.no_input']}" in \
            events_on_screen(flight)
    assert USUAL not in flight.stdout


# --- progress --------------------------------------------------------------

# A bar appears after a second.
LONG_ENOUGH = ("fly", "--pace", "realtime", "--seconds", "1.6")
BAR = "[#"


def on_terminal(folder, *arguments, output_too=False):
    """The program's text on a terminal as its standard error."""
    ours, theirs = pty.openpty()
    with subprocess.Popen(
            [PROGRAM, *arguments], cwd=folder, stdin=subprocess.DEVNULL,
            stdout=theirs if output_too else subprocess.DEVNULL,
            stderr=theirs) as process:
        os.close(theirs)
        shown = b""
        end = time.monotonic() + TIME_LIMIT_S
        while time.monotonic() < end:
            if not select.select([ours], [], [], 1)[0]:
                continue
            try:
                shown += os.read(ours, 4096)
            except OSError:
                # All of the other end is closed.
                break
        os.close(ours)
        assert process.wait(TIME_LIMIT_S) == 0
    return shown.decode()


def test_a_long_flight_shows_a_bar_on_a_terminal_only(urv_sim, tmp_path):
    assert BAR in on_terminal(tmp_path, *LONG_ENOUGH)
    result = urv_sim(*LONG_ENOUGH)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout.startswith("flown     1.60 s, 80 frames, ")
    assert BAR not in result.stdout


def test_the_bar_can_be_switched_off(tmp_path):
    assert on_terminal(tmp_path, *LONG_ENOUGH, "--quiet") == ""


def test_no_bar_in_the_middle_of_an_output(tmp_path):
    shown = on_terminal(tmp_path, *LONG_ENOUGH, "--events", "-",
                        output_too=True)
    assert BAR not in shown
    assert shown.startswith('{"node":"gsc"')


# --- nowhere to write ------------------------------------------------------

def complaint(result):
    """The one line that a program that cannot write leaves."""
    assert result.returncode == 1, result
    assert result.stderr.count("\n") == 1, result.stderr
    return result.stderr.rstrip("\n")


def run_into(folder, output, *arguments, **more):
    """Run with this file as standard output."""
    return subprocess.run(
        [PROGRAM, *map(str, arguments)], cwd=folder, stdout=output,
        stderr=subprocess.PIPE, stdin=subprocess.DEVNULL, text=True,
        timeout=TIME_LIMIT_S, check=False, **more)


PRINTING = (["help"], ["help", "fly"], ["items"], ["numbers"],
            ["--version"],
            ["fly", "--seconds", "0.1"])


@needs_full_device
@pytest.mark.parametrize("arguments", PRINTING, ids=" ".join)
def test_standard_output_is_full(tmp_path, arguments):
    with open("/dev/full", "w") as full:
        result = run_into(tmp_path, full, *arguments)
    assert complaint(result) == \
        f"urv_sim: standard output cannot be written: {NO_SPACE}"


@pytest.mark.parametrize("arguments", PRINTING, ids=" ".join)
def test_nobody_reads_standard_output(tmp_path, arguments):
    ours, theirs = os.pipe()
    os.close(ours)
    with open(theirs, "w") as closed:
        result = run_into(tmp_path, closed, *arguments)
    assert complaint(result) == \
        f"urv_sim: standard output cannot be written: {BROKEN_PIPE}"


def test_standard_output_is_closed(tmp_path):
    result = run_into(tmp_path, None, "items",
                      preexec_fn=lambda: os.close(1))
    assert complaint(result) == \
        "urv_sim: standard output cannot be written: Bad file descriptor"


@needs_full_device
@pytest.mark.parametrize("option", OUTPUT_OPTIONS)
def test_sim8_a_full_disk_ends_no_flight(urv_sim, tmp_path, option):
    """It is reported once, the others are whole, and the status says it."""
    other = "--wire" if option == "--record" else "--record"
    result = urv_sim("fly", "--seconds", "30", option, "/dev/full",
                     other, "other", "--quiet",
                     *(() if option == "--summary" else ("--summary", "s")))
    assert complaint(result) == \
        f'urv_sim: {option}: "/dev/full" cannot be written: {NO_SPACE}'
    rows = (tmp_path / "other").read_text().splitlines()
    time = rows[-1].split(",")[0 if other == "--wire" else 1]
    assert int(time) > (29_900_000 if other == "--wire" else 29_900)
    if option != "--summary":
        summary = json.loads((tmp_path / "s").read_text())
        assert summary["seconds"] == 30
        assert summary["lost_outputs"] == [option]


def test_sim8_a_limit_of_the_file_s_size_ends_no_flight(tmp_path):
    limit = 50_000

    def be_limited():
        resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))

    result = run_into(tmp_path, subprocess.DEVNULL, "fly", "--seconds", "30",
                      "--record", "r", "--summary", "s",
                      preexec_fn=be_limited)
    assert result.returncode == 1
    assert result.stderr == (
        'urv_sim: --record: "r" cannot be written: File too large\n')
    assert (tmp_path / "r").stat().st_size == limit
    summary = json.loads((tmp_path / "s").read_text())
    assert (summary["seconds"], summary["lost_outputs"]) == (30, ["--record"])


def test_sim8_a_summary_without_a_loss_is_as_it_was(urv_sim, tmp_path):
    urv_sim("fly", "--seconds", "1", "--summary", "s")
    assert "lost_outputs" not in json.loads((tmp_path / "s").read_text())


@needs_jsbsim
def test_sim9_a_stopped_plant_is_reported_while_the_flight_waits(tmp_path):
    with subprocess.Popen(
            [PROGRAM, "fly", "--plant", "jsbsim", "--pace", "realtime",
             "--seconds", "1000", "--record", "r", "--quiet"],
            cwd=tmp_path, stderr=subprocess.PIPE, text=True) as process:
        limit = time.monotonic() + TIME_LIMIT_S
        while not ((tmp_path / "r").exists()
                   and (tmp_path / "r").read_text().count("\n") > 2):
            assert time.monotonic() < limit
            time.sleep(0.05)
        plant, = map(int, (pathlib.Path(
            f"/proc/{process.pid}/task/{process.pid}/children")
            .read_text("ascii").split()))
        os.kill(plant, signal.SIGSTOP)
        assert process.stderr.readline() == (
            "urv_sim: --plant jsbsim: JSBSim's process does not answer: the"
            " flight waits\n")
        os.kill(plant, signal.SIGCONT)
        assert process.stderr.readline() == (
            "urv_sim: --plant jsbsim: JSBSim's process answers again\n")
        process.send_signal(signal.SIGINT)
        assert process.wait(TIME_LIMIT_S) == 130


def test_who_reads_an_output_ends_early(tmp_path):
    """D-55: as other programs of a pipeline do."""
    with subprocess.Popen(
            [PROGRAM, "fly", "--seconds", "1000", "--wire", "-"],
            cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True) as process:
        assert process.stdout.readline() == "time_us,direction,byte\n"
        process.stdout.close()
        said = process.stderr.read()
        assert process.wait(TIME_LIMIT_S) == 1
    assert said == ("urv_sim: --wire: standard output cannot be written:"
                    f" {BROKEN_PIPE}\n")


# --- interrupted -----------------------------------------------------------

def heed_signals():
    """Whoever runs the tests may have them ignored."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)


def interrupted(folder, which, *options, times=1):
    """Fly, and send the signal to all that take part once the outputs are
    open."""
    outputs = [word for option, file in FILE_OF.items()
               for word in (option, folder / file)]
    with subprocess.Popen(
            [PROGRAM, "fly", "--seconds", "100000", *options, *outputs],
            cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, start_new_session=True,
            preexec_fn=heed_signals) as process:
        end = time.monotonic() + TIME_LIMIT_S
        while not (folder / "events.jsonl").exists():
            assert process.poll() is None, process.stderr.read()
            assert time.monotonic() < end
            time.sleep(0.01)
        time.sleep(0.2)
        for _ in range(times):
            os.killpg(process.pid, which)
        shown, said = process.communicate(timeout=TIME_LIMIT_S)
        assert process.returncode == 130, said
    found = re.fullmatch(r"urv_sim: interrupted at (\d+\.\d\d) s\n", said)
    assert found, said
    assert shown.startswith(f"flown     {found[1]} s, ")
    return found[1]


CUT_SHORT = [
    pytest.param(signal.SIGINT, ["--pace", "realtime"], 1, id="SIGINT"),
    pytest.param(signal.SIGTERM, ["--pace", "realtime"], 1, id="SIGTERM"),
    pytest.param(signal.SIGINT, [], 2, id="fast"),
    pytest.param(signal.SIGINT, ["--plant", "jsbsim"], 1, id="JSBSim",
                 marks=needs_jsbsim),
    pytest.param(signal.SIGTERM, ["--plant", "jsbsim", "--pilot", "level"], 2,
                 id="pilot", marks=needs_jsbsim),
]


@pytest.mark.parametrize("which, options, times", CUT_SHORT)
def test_an_interrupted_flight_is_one_of_that_length(
        tmp_path, which, options, times):
    """Every output is complete, to the last frame."""
    (tmp_path / "cut").mkdir()
    (tmp_path / "whole").mkdir()
    seconds = interrupted(tmp_path / "cut", which, *options, times=times)
    whole = fly_in(
        tmp_path / "whole", "--seconds", seconds,
        *(word for word in options if word not in ("--pace", "realtime")))
    for file in ("record.csv", "wire.csv", "events.jsonl"):
        assert (tmp_path / "cut" / file).read_bytes() == \
            whole.path(file).read_bytes(), file
    summary = json.loads((tmp_path / "cut" / "summary.json").read_text())
    assert summary["frames"] == round(float(seconds) * FRAMES_PER_S)
    assert without_speed(summary) == without_speed(whole.summary)


def test_an_ignored_signal_stays_ignored(tmp_path):
    """As after nohup, or in the background of a script."""
    def ignore():
        signal.signal(signal.SIGINT, signal.SIG_IGN)

    with subprocess.Popen(
            [PROGRAM, "fly", "--seconds", "1", "--pace", "realtime",
             "--record", "r.csv"], cwd=tmp_path, stdout=subprocess.DEVNULL,
            preexec_fn=ignore) as process:
        while not (tmp_path / "r.csv").exists():
            assert process.poll() is None
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        assert process.wait(TIME_LIMIT_S) == 0


@pytest.mark.parametrize("which", [signal.SIGINT, signal.SIGTERM])
def test_sim1_a_signal_ends_the_wait_for_a_pipe_s_reader(tmp_path, which):
    os.mkfifo(tmp_path / "pipe")
    with subprocess.Popen(
            [PROGRAM, "fly", "--seconds", "1", "--record", "pipe"],
            cwd=tmp_path, preexec_fn=heed_signals) as process:
        time.sleep(0.5)
        assert process.poll() is None
        process.send_signal(which)
        try:
            assert process.wait(60) == -which
        finally:
            process.kill()


@needs_jsbsim
@pytest.mark.parametrize("after_s", [0.02, 0.05, 0.1, 0.2])
def test_ctrl_c_before_the_flight_ends_it_without_a_word(tmp_path, after_s):
    """While JSBSim's process starts up, too."""
    with subprocess.Popen(
            [PROGRAM, "fly", "--plant", "jsbsim", "--seconds", "100000",
             "--pace", "realtime"],
            cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True, start_new_session=True,
            preexec_fn=heed_signals) as process:
        time.sleep(after_s)
        os.killpg(process.pid, signal.SIGINT)
        # To the end of both processes.
        _, said = process.communicate(timeout=TIME_LIMIT_S)
    assert process.returncode in (-signal.SIGINT, 130)
    assert "Traceback" not in said


# --- faults of the program -------------------------------------------------

DYING_PLANT = """\
#!/usr/bin/env python3
import socket, struct, sys
link = socket.socket(fileno=int(sys.argv[2]))
counts = {"servo": 0}
for line in link.makefile("r"):
    if line == "\\n":
        break
    kind = line.split(",")[0]
    if kind != "time":
        counts[kind] = counts.get(kind, 0) + 1
link.sendall(b"ready\\n")
commands = 8 * counts.pop("servo")
state = bytes(8 * sum(counts.values()))
link.sendall(state)
for frame in range(25):
    if not link.recv(commands, socket.MSG_WAITALL):
        break
    link.sendall(state)
"""


def test_the_plant_dies_in_flight(tmp_path, monkeypatch):
    plant = tmp_path / "plant"
    plant.write_text(DYING_PLANT)
    plant.chmod(0o755)
    monkeypatch.setenv("URV_PYTHON", str(plant))
    result = run_program(tmp_path, "fly", "--plant", "jsbsim",
                         "--seconds", "10", "--record", "record.csv")
    assert result.returncode == 1
    assert result.stderr == (
        "urv_sim: --plant jsbsim: JSBSim's process has ended\n")
    # It is told only once: what was flown till then stays.
    rows = (tmp_path / "record.csv").read_text().splitlines()
    assert len(rows) == 1 + 26


def test_an_internal_fault_ends_with_status_1(tmp_path):
    """Here: there is no memory left for a script of 400,000 rows."""
    (tmp_path / "sticks.csv").write_text(
        f"time_ms,{','.join(COMMANDS)}\n" + "".join(
            f"{row},{'1,' * 12}1\n" for row in range(400_000)))

    def starve():
        limit = 24 << 20
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))

    result = run_into(tmp_path, subprocess.PIPE, "fly", "--sticks",
                      "sticks.csv", preexec_fn=starve)
    assert result.returncode == 1, result
    assert result.stderr.startswith(
        "urv_sim: internal fault: raised STORAGE_ERROR")
    assert result.stdout == ""


# The place where an exception of a node's program comes out.
INTERRUPT = "         when Ground   => GSC_Time.Clock_Interrupt (Now);\n"
EXCEPTION = """\
         when Ground   =>
            if Now'Image = " 500" then
               raise Constraint_Error with "a mistake";
            end if;
            GSC_Time.Clock_Interrupt (Now);
"""


def test_a_node_that_fails_ends_with_status_1(tmp_path):
    """The ground's program raises what no fault has ordered. It restarts and
    flies on, and the program's user is told."""
    for name in ("src", "host", "sim", "proofs", "urv.gpr"):
        where = ROOT / name
        (shutil.copytree if where.is_dir() else shutil.copy2)(
            where, tmp_path / name)
    tree_copy.take_objects(ROOT, tmp_path, ("host", "host-host", "sim-host"))
    nodes = tmp_path / "sim" / "sim-nodes.adb"
    text = nodes.read_text(encoding="utf-8")
    assert text.count(INTERRUPT) == 1
    nodes.write_text(text.replace(INTERRUPT, EXCEPTION), encoding="utf-8")
    subprocess.run(
        ["gprbuild", "-q", "-p", "-P", "sim/urv_sim.gpr", "-XURV_Mode=host"],
        cwd=tmp_path, check=True)
    result = subprocess.run(
        [tmp_path / "bin" / "urv_sim", "fly", "--seconds", "3", "--summary",
         "summary.json"], cwd=tmp_path, capture_output=True, text=True,
        timeout=TIME_LIMIT_S, check=False)
    assert result.returncode == 1, result
    assert result.stderr.count("internal fault") == 1
    assert "GSC restarts its processor" in result.stderr
    assert "a mistake" in result.stderr
    summary = json.loads((tmp_path / "summary.json").read_text())
    assert summary["core_status"]["gsc"]["processor_restarts"] == 1
    assert summary["frames"] == 150

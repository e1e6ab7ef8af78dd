# SPDX-License-Identifier: Apache-2.0
"""RTP-2: what is wrong with a command line or a link is said before anything
runs.
"""

import ctypes
import json
import os
import re
import resource
import shutil
import socket
import subprocess
import tempfile
import tomllib
from pathlib import Path

import pytest

from conftest import (
    NO_PRIORITIES, PROGRAMS, ROOT, TIME_LIMIT_S, UNHEARD, free_ports,
    of_the_link, udp,
)

NODES = ("mcs", "gsc")


def run(node, *arguments):
    return subprocess.run(
        [PROGRAMS[node], *map(str, arguments)],
        capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False,
    )


def assert_refused(result, node, *parts):
    assert result.returncode == 2, result
    assert result.stdout == ""
    assert len(result.stderr.splitlines()) == 1, result.stderr
    for part in parts:
        assert part in result.stderr, result.stderr


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("link, what", [
    ("", "needs a value"),
    ("udp", "is neither"),
    ("udp:", "is neither"),
    ("tcp:1.2.3.4:5:6.7.8.9:10", "is neither"),
    ("udp:127.0.0.1:5000", "is not udp:HOST:PORT:PEER_HOST:PEER_PORT"),
    ("udp:127.0.0.1:5000:127.0.0.1:5001:1", "is not udp:HOST:PORT"),
    ("udp:127.0.0.1::127.0.0.1:5001", "is not udp:HOST:PORT"),
    ("udp:127.0.0.1:0:127.0.0.1:5001", "is not a port from 1 to 65535"),
    ("udp:127.0.0.1:65536:127.0.0.1:1", "is not a port from 1 to 65535"),
    ("udp:127.0.0.1:5000:127.0.0.1:x", "is not a port from 1 to 65535"),
    ("udp:127.0.0.1:5000:no-such.invalid:5001", "there is no host"),
    ("udp:192.0.2.1:5000:127.0.0.1:5001", "cannot be bound"),
    ("serial:/dev/no/such", "cannot be opened"),
    ("serial:/dev/null", "is not a serial device"),
    ("serial:/", "cannot be opened"),
    ("serial:", "is neither"),
])
def test_a_bad_link_is_refused(node, link, what):
    assert_refused(run(node, "--link", link), node, f"urv_{node}: ", what)


@pytest.mark.parametrize("node", NODES)
def test_a_port_in_use_is_refused(node):
    own, other = free_ports(2)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", own))
        result = run(node, "--link", udp(own, other))
    assert_refused(result, node, "cannot be bound", "in use")


def test_a_device_in_use_is_refused(start, terminals):
    link = f"serial:{terminals.devices[0]}"
    first = start("mcs", link)
    first.await_begin()
    result = run("gsc", "--link", link, "--seconds", "0.02")
    assert_refused(result, "gsc", "is in use by another program")
    first.stop()


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("options, what", [
    ((), "--link is missing"),
    (("--link",), "--link needs a value"),
    (("fly",), "unexpected argument"),
    (("--wings", "2"), "unknown option"),
    (("--seconds", "0"), "--seconds"),
    (("--seconds", "soon"), "--seconds"),
    (("--phase", "10"), "--phase"),
    (("--processors", "5"),
     "not a number of processors from 1 to 4"),
    (("--lock=on",), "takes no value"),
    (("--schedule", "slow"), "neither \"report\" nor \"fast\""),
    (("--quiet=1",), "takes no value"),
    (("--quiet", "--quiet"), "is given twice"),
])
def test_a_bad_option_is_refused(node, options, what):
    assert_refused(run(node, *options), node, what)


def options_of(node):
    """Those in the help."""
    return re.findall(r"^  (--[a-z-]+)", run(node, "--help").stdout, re.M)


@pytest.mark.parametrize("node", NODES)
def test_an_unknown_option_lists_the_options(node):
    assert_refused(run(node, "--wings", "2"), node,
                   "there are " + ", ".join(options_of(node)) + "\n")


@pytest.mark.parametrize("node, options", [
    ("mcs", ("--sticks", "--console", "--orders", "--packets", "--pilot", "--publish")),
    ("gsc", ("--sensors", "--plant", "--laws", "--orbit-after",
             "--terminate-after")),
])
def test_each_node_has_options_of_its_own(node, options):
    for option in options:
        assert_refused(run(node, option, "s"), node, "unknown option")


PLACE = "udp:127.0.0.1:6009"


@pytest.mark.parametrize("node, options, what", [
    ("gsc", ("--console", PLACE, "--sticks", "s"),
     "--sticks and --console do not go together"),
    ("gsc", ("--pilot", "level", "--sticks", "s"),
     "--pilot and --sticks do not go together"),
    ("gsc", ("--pilot", "ace"), "there are standard, level"),
    ("gsc", ("--console", "127.0.0.1:6009"), "is not udp:HOST:PORT"),
    ("gsc", ("--console", "udp:127.0.0.1"), "is not udp:HOST:PORT"),
    ("gsc", ("--console", "udp:127.0.0.1:x"), "is not a port from 1"),
    ("gsc", ("--console", PLACE + ":1"), "is not udp:HOST:PORT"),
    ("gsc", ("--console", "udp:no-such.invalid:1"), "there is no host"),
    ("gsc", ("--console", "udp:0.0.0.0:6009"), "is not a loopback"),
    ("gsc", ("--console", "udp:192.0.2.1:6009"), "is not a loopback"),
    ("gsc", ("--console", "udp:[::]:6009"), "is not a loopback"),
    ("gsc", ("--publish", "udp:127.0.0.1:0"), "is not a port from 1"),
    ("gsc", ("--publish", "serial:x"), "is not udp:HOST:PORT"),
    ("gsc", ("--publish", PLACE) * 9, "more than 8 times"),
    ("gsc", ("--packets", "4"), "neither 1, 2 nor 3"),
    ("mcs", ("--plant", "brick"), 'neither "bench" nor "jsbsim"'),
    ("mcs", ("--laws", "perhaps"), 'neither "on" nor "off"'),
    ("mcs", ("--orbit-after", "10"), "add --laws on"),
    ("mcs", ("--laws", "on", "--orbit-after", "61"), "from 1 to 60"),
    ("mcs", ("--laws", "on", "--terminate-after", "3"),
     "do not come after the 5 s"),
    ("mcs", ("--plant", "jsbsim", "--sensors", "s"),
     "--sensors and --plant jsbsim do not go together"),
])
def test_gnd3_gnd6_what_the_station_cannot_have_is_refused(
    node, options, what
):
    own, other = free_ports(2)
    assert_refused(run(node, "--link", udp(own, other), *options), node, what)


def test_gnd3_a_console_s_port_in_use_is_refused():
    own, other, port = free_ports(3)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind(("127.0.0.1", port))
        result = run("gsc", "--link", udp(own, other),
                     "--console", f"udp:127.0.0.1:{port}")
    assert_refused(result, "gsc", "--console", "in use")


def test_gnd6_a_plant_without_a_python_is_refused(monkeypatch):
    monkeypatch.setenv("URV_PYTHON", "/no/such/python")
    own, other = free_ports(2)
    assert_refused(
        run("mcs", "--link", udp(own, other), "--plant", "jsbsim"), "mcs",
        "--plant jsbsim: no Python at /no/such/python")


def test_the_page_and_the_help_have_the_same_options():
    page = (ROOT / "docs" / "real-time.md").read_text(encoding="utf-8")
    told = set(re.findall(r"^\| `(--[a-z-]+)", page, re.M))
    helped = {node: set(options_of(node)) for node in NODES}
    assert told == helped["gsc"] | helped["mcs"]
    assert helped["gsc"] - helped["mcs"] == {
        "--sticks", "--console", "--orders", "--packets", "--pilot",
        "--publish"}


@pytest.mark.parametrize("node, option", [
    ("mcs", "--sensors"), ("gsc", "--sticks"),
])
def test_a_bad_script_is_refused_at_its_line(node, option, tmp_path):
    script = tmp_path / "script.csv"
    script.write_text("time_ms,wings\n0,1\n", encoding="utf-8")
    own, other = free_ports(2)
    result = run(node, "--link", udp(own, other), option, script,
                 "--record", tmp_path / "record.csv")
    assert_refused(result, node, f"{script}:1: unknown column")
    assert not (tmp_path / "record.csv").exists()


@pytest.mark.parametrize("option", ["--record", "--summary", "--events"])
def test_an_output_that_cannot_be_written_is_refused(option, tmp_path):
    own, other = free_ports(2)
    result = run("mcs", "--link", udp(own, other),
                 option, tmp_path / "no" / "file")
    assert_refused(result, "mcs", option, "cannot be created")


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("before", [(), ("--quiet",)])
def test_rtp2_the_version_is_that_of_alire_toml(node, before):
    crate = tomllib.loads((ROOT / "alire.toml").read_text())
    result = run(node, *before, "--version")
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == f"urv_{node} {crate['version']}\n"


@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("word", ["help", "--help", "-h"])
def test_help_explains_the_options(node, word):
    result = run(node, word)
    assert result.returncode == 0
    for option in ("--link", "--seconds", "--record", "--summary"):
        assert option in result.stdout


@pytest.mark.parametrize("node", NODES)
def test_a_summary_is_printed_unless_quiet(node):
    own, other = free_ports(2)
    for quiet in ((), ("--quiet",)):
        result = run(node, "--link", udp(own, other), "--seconds", "0.2",
                     *quiet)
        assert result.returncode == UNHEARD
        assert (result.stdout == "") == bool(quiet)


def test_an_output_named_by_a_dash_is_standard_output():
    """The text for people then goes to standard error."""
    own, other = free_ports(2)
    result = run("gsc", "--link", udp(own, other), "--seconds", "0.2",
                 "--record", "-")
    assert result.returncode == UNHEARD
    assert result.stdout.startswith("frame,time_ms,")
    assert "\nrun  " not in result.stdout and "\nrun  " in result.stderr


def test_an_output_that_is_the_input_is_refused(tmp_path):
    script = tmp_path / "script.csv"
    script.write_text("time_ms,roll\n0,1\n", encoding="utf-8")
    own, other = free_ports(2)
    result = run("gsc", "--link", udp(own, other), "--sticks", script,
                 "--summary", script)
    assert_refused(result, "gsc", "--summary and --sticks name the same file")
    assert script.read_text("utf-8") == "time_ms,roll\n0,1\n"


needs_full_device = pytest.mark.skipif(
    not os.path.exists("/dev/full"), reason="no /dev/full")
NO_SPACE = "cannot be written: No space left on device"


@needs_full_device
@pytest.mark.parametrize("option", ["--record", "--summary", "--events"])
@pytest.mark.parametrize("node", NODES)
def test_a_full_disk_is_not_the_command_line_s_fault(node, option, tmp_path):
    """Exit status 1; what can be written elsewhere is there."""
    own, other = free_ports(2)
    another = "--summary" if option == "--record" else "--record"
    result = run(node, "--link", udp(own, other), "--seconds", "0.2",
                 "--quiet", option, "/dev/full", another, tmp_path / "other")
    assert (result.returncode, result.stdout) == (1, "")
    assert result.stderr == (
        f'urv_{node}: {option}: "/dev/full" {NO_SPACE}\n')
    if another == "--record":
        rows = (tmp_path / "other").read_text("utf-8").splitlines()
        assert int(rows[-1].partition(",")[0]) >= 9


@needs_full_device
@pytest.mark.parametrize("node", NODES)
@pytest.mark.parametrize("arguments", [("help",), ("--seconds", "0.1")])
def test_a_full_standard_output_is_said_in_a_line(node, arguments):
    own, other = free_ports(2)
    if arguments != ("help",):
        arguments = ("--link", udp(own, other), *arguments)
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = subprocess.run(
            [PROGRAMS[node], *arguments], stdout=full,
            stderr=subprocess.PIPE, text=True, timeout=TIME_LIMIT_S,
            check=False)
    assert result.returncode == 1
    assert result.stderr.splitlines()[-1] == (
        f"urv_{node}: standard output {NO_SPACE}")
    assert len(of_the_link(result.stderr)) <= 2


DROP_CAPABILITY, SYS_NICE = 24, 23
LIBC = ctypes.CDLL(None)


def leave_priorities():
    """Real-time priority, which a container's root may not use without the
    right."""
    resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0))
    assert LIBC.prctl(DROP_CAPABILITY, SYS_NICE, 0, 0, 0) == 0


@pytest.mark.skipif(os.geteuid() != 0, reason="others have no priorities")
@pytest.mark.parametrize("node", NODES)
def test_root_without_the_right_gets_a_message(node):
    """Its tasks would never begin, and nothing would be said."""
    result = subprocess.run(
        [PROGRAMS[node], "--link", udp(*free_ports(2)), "--seconds", "0.02"],
        capture_output=True, text=True, timeout=TIME_LIMIT_S, check=False,
        preexec_fn=leave_priorities)
    assert_refused(result, node, f"urv_{node}: root may not give threads",
                   "--cap-add=SYS_NICE")


NOBODY = 65_534


def run_as_nobody(node, **more):
    """A short run of another user, and its summary."""
    with tempfile.TemporaryDirectory() as folder:
        # The sources may be where nobody else may look.
        program = shutil.copy2(PROGRAMS[node], folder)
        os.chmod(folder, 0o777)
        result = subprocess.run(
            [program, "--link", udp(*free_ports(2)), "--seconds", "0.1",
             "--summary", "summary.json"],
            cwd=folder, capture_output=True, text=True, timeout=TIME_LIMIT_S,
            check=False, **more)
        assert result.returncode == UNHEARD, result
        return result, json.loads(
            Path(folder, "summary.json").read_text("utf-8"))


@pytest.mark.skipif(os.geteuid() != 0, reason="every test is this one")
@pytest.mark.parametrize("node", NODES)
def test_rtp8_another_user_flies_without_priorities_and_gets_a_warning(node):
    result, summary = run_as_nobody(
        node, user=NOBODY, group=NOBODY, extra_groups=[])
    # It takes longer where the machine has stopped it.
    assert re.match(r"run +\d+\.\d+ s, \d+ frames, ", result.stdout)
    [line] = [line for line in result.stderr.splitlines()
              if NO_PRIORITIES in line]
    assert line.endswith("sudo prlimit --pid $$ --rtprio=99")
    assert summary["real_time_priorities"] == 0


@pytest.mark.skipif(os.geteuid() != 0, reason="others have no priorities")
@pytest.mark.parametrize("node", NODES)
def test_rtp8_a_user_with_the_right_gets_no_warning(node):
    result, summary = run_as_nobody(node)
    assert NO_PRIORITIES not in result.stderr
    assert summary["real_time_priorities"] == 1


@pytest.mark.skipif(os.geteuid() != 0, reason="others have no priorities")
def test_setup_gives_the_same_message_before_tests_wait():
    result = subprocess.run(
        ["scripts/setup.sh", "test"], cwd=ROOT, capture_output=True,
        text=True, timeout=TIME_LIMIT_S, check=False,
        preexec_fn=leave_priorities)
    assert result.returncode == 1
    assert "root may not give threads real-time" in result.stderr

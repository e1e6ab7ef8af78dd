# SPDX-License-Identifier: Apache-2.0
"""RTP-2: a partition's reports of the other node, while it runs and at its
end; and the commands of docs/real-time.md, unchanged.
"""

import os
import re
import shutil
import signal
import subprocess
import time

import pytest

from conftest import (
    FOLDER, ROOT, STOOD_STILL, TIME_LIMIT_S, RanLate, flies_again, free_ports,
    need, of_the_link, udp, UNHEARD,
)
from peer import FRAME_S

DOCUMENT = ROOT / "docs" / "real-time.md"

LINK = re.compile(
    r"link +peer (?P<state>never heard|heard|lost), "
    r"(?P<sent>\d+) (?P<out>uplink|downlink)s? sent, "
    r"(?P<scrapped>\d+) scrapped, "
    r"(?P<received>\d+) (?P<into>uplink|downlink)s? received, "
    r"(?P<bad>\d+) bad, (?P<resets>\d+) resets?, (?P<refused>\d+) refused"
    r"(, round trip (?P<round_trip>\d+(\.\d)?) ms)?"
)


def seconds_of(line, what):
    """When it says that this was, if the line does."""
    found = re.fullmatch(rf"urv_...: {what} at (\d+(?:\.\d+)?) s.*", line)
    return float(found[1]) if found else None


@flies_again
def test_a_partition_says_when_the_other_is_heard_and_when_it_is_lost(start):
    ground_port, port = free_ports(2)
    gsc = start("gsc", udp(ground_port, port), "--phase", 0, quiet=False)
    listening = gsc.say_line()
    assert listening == f"urv_gsc: listening at {udp(ground_port, port)}"

    lines = []
    for _ in range(2):
        mcs = start("mcs", udp(port, ground_port), "--phase", 3)
        lines += [seconds_of(gsc.say_line(), "peer heard")]
        mcs.stop()
        lines += [seconds_of(gsc.say_line(), "peer lost")]
    gsc.send(signal.SIGINT)
    out, err = gsc.program.communicate(timeout=TIME_LIMIT_S)
    assert gsc.program.returncode == 0

    # On a late machine the other node is lost and heard in between, too.
    need(None not in lines and of_the_link(err) == [], gsc.outputs)
    assert lines == sorted(lines)

    # A second after the last good message, as its record has it.
    rows = gsc.outputs.rows
    received = [row["link.downlink_received"] for row in rows]
    last = rows[received.index(received[-1])]
    need(lines[3] == pytest.approx(
        (last["frame"] + 2) * FRAME_S + 1, abs=2.05 * FRAME_S), gsc.outputs)
    summary = gsc.outputs.summary
    assert summary["link"]["state"] == "lost"

    # And on the screen.
    run, link = out.splitlines()
    assert run.startswith(
        f"run       {summary['seconds']:g} s, {summary['frames']} frames, "
    )
    said = LINK.fullmatch(link)
    assert said, link
    assert said["state"] == "lost"
    assert (said["out"], said["into"]) == ("uplink", "downlink")
    for name, key in (("sent", "uplink_sent"), ("resets", "resets"),
                      ("scrapped", "uplink_scrapped"),
                      ("received", "downlink_received"),
                      ("bad", "downlink_bad"),
                      ("refused", "blocks_refused")):
        need(abs(int(said[name]) - summary["link"][key]) <= 1, gsc.outputs)


@flies_again
def test_the_summary_has_what_the_record_has_of_the_link(start_both):
    runs = start_both(mcs=("--seconds", 1.5), gsc=("--seconds", 1.54))
    mcs, gsc = (run.end() for run in runs)
    for node, out, into in ((mcs, "downlink", "uplink"),
                            (gsc, "uplink", "downlink")):
        link, row = node.summary["link"], node.rows[-1]
        need(link["state"] == "heard" and link[f"{into}_received"] > 0,
             mcs, gsc)
        for name in (f"{out}_sent", f"{out}_scrapped", f"{into}_received",
                     f"{into}_bad"):
            more = link[name] - row[f"link.{name}"]
            assert more >= 0, name
            need(more <= 2, mcs, gsc)
    need(mcs.summary["seconds"] == 1.5, mcs)
    need((gsc.summary["seconds"], gsc.summary["frames"]) == (1.54, 77), gsc)


@flies_again
def test_rtp7_a_partition_alone_reports_that_it_heard_no_peer(start):
    own, other = free_ports(2)
    run = start("mcs", udp(own, other), "--seconds", 0.3, quiet=False)
    out, err = run.program.communicate(timeout=TIME_LIMIT_S)
    assert run.program.returncode == UNHEARD
    assert of_the_link(err) == [f"urv_mcs: listening at {udp(own, other)}"]
    need(run.outputs.summary["frames"] == 15, run.outputs)
    assert out.splitlines() == [
        f"run       0.3 s, 15 frames, {run.outputs.summary['overruns']}"
        " overruns",
        "link      peer never heard, 0 downlinks sent, 0 scrapped,"
        " 0 uplinks received, 0 bad, 0 resets, 0 refused",
    ]


def commands_of_the_page():
    """The blocks of commands, one for each kind of link."""
    blocks = re.findall(r"(?:^    .*\n)+", DOCUMENT.read_text("utf-8"), re.M)
    return {
        kind: "".join(line[4:] for line in block.splitlines(True))
        for kind in ("udp", "serial")
        for block in blocks if f"--link {kind}:" in block
    }


@pytest.mark.parametrize("kind", ["udp", "serial"])
@flies_again
def test_the_commands_of_the_page_do_what_it_says(kind, tmp_path):
    """Unchanged, but for the numbers of the ports: others may run the same
    commands."""
    if kind == "serial" and not shutil.which("socat"):
        pytest.skip("socat is not installed")
    commands = commands_of_the_page()[kind]
    for named, port in zip(("6001", "6002"), free_ports(2)):
        commands = commands.replace(named, str(port))
    if not (tmp_path / "bin").exists():
        (tmp_path / "bin").symlink_to(FOLDER)
    group = subprocess.Popen(
        ["sh", "-eu", "-c", commands], cwd=tmp_path, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True,
    )
    try:
        out, err = group.communicate(timeout=TIME_LIMIT_S)
    finally:
        if group.poll() is None:
            os.killpg(group.pid, signal.SIGKILL)
            group.wait()
    assert group.returncode == 0, err
    for node in ("gsc", "mcs"):
        assert f"urv_{node}: peer heard at " in err
    well = (out.count("run       5 s, 250 frames, ") == 2
            and out.count("link      peer heard, ") == 2)
    if kind == "udp":
        rows = (tmp_path / "record.csv").read_text("utf-8").splitlines()
        assert len(rows) > 100
        place = rows[0].split(",").index("mcs.uplink.roll")
        well = well and rows[-1].split(",")[place] == "3000"
    if not well and (STOOD_STILL in err
                     or out.count(" frames, 0 overruns\n") < 2):
        raise RanLate
    assert well, out


def test_sim1_a_killed_partition_leaves_its_results(start):
    """kill -9: of the record at most a second is lost, and events and summary
    are there."""
    gsc = start("gsc", udp(*free_ports(2)), "--phase", 0, quiet=False)
    folder = gsc.outputs.folder
    deadline = time.monotonic() + TIME_LIMIT_S

    def rows():
        path = folder / "record.csv"
        return path.read_bytes().count(b"\n") - 1 if path.exists() else 0
    while rows() < 120:
        assert time.monotonic() < deadline
        time.sleep(0.05)
    gsc.program.kill()
    gsc.program.wait()
    summary = gsc.outputs.summary
    assert summary["unfinished"] == 1
    assert abs(rows() - summary["frames"]) <= 2 * round(1 / FRAME_S)
    assert gsc.outputs.events["no_input"]["node"] == "gsc"

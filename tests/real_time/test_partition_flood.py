# SPDX-License-Identifier: Apache-2.0
"""RTP-3: a flood from the peer's address. The accepted part depends on the
machine. Asserted is that nothing of it is obeyed and that afterwards the peer
is; needed is that the flood was one."""

import contextlib
import re
import subprocess
import sys

from conftest import ROOT, TIME_LIMIT_S, flies_again, need
from test_partition_input import BEFORE, YOUNG, UDPEnd, acted_upon, command

sys.path.insert(0, str(ROOT / "evidence"))

import floods  # noqa: E402

# One character each, as fast as the machine sends; then enough characters each
# that a machine of any speed sends more than a line brings.
DATAGRAMS = {1: 30_000, 100: 10_000}


@flies_again
def test_rtp3_after_a_flood_the_peer_is_heard(start):
    with contextlib.closing(UDPEnd()) as line:
        run = start("mcs", line.link)
        command(line, BEFORE)
        for length, datagrams in DATAGRAMS.items():
            for number in range(datagrams):
                line.write(bytes([number % 256]) * length)
        command(line, YOUNG)
        mcs = run.stop()
    link = mcs.summary["link"]
    need(link["bytes_discarded"] > 1_000, mcs)
    need(acted_upon(mcs, BEFORE) and acted_upon(mcs, YOUNG), mcs)


def test_rtp3_the_script_of_floods_flies_beside_each():
    """Three flights: beside nothing, beside a flood, and in one."""
    said = subprocess.run(
        [sys.executable, ROOT / "evidence" / "floods.py", "1"], text=True,
        capture_output=True, check=True, timeout=TIME_LIMIT_S).stdout
    rates = re.findall(r": (\d+) datagrams a second, (\d+) discarded, ticks "
                       r"late \{'min'", said)
    assert len(rates) == 3
    assert rates[0] == ("0", "0")
    assert int(rates[1][0]) > 0 and rates[1][1] == "0"
    rate, discarded = map(int, rates[2])
    assert discarded > 0 or 0 < rate < 30_000


def test_rtp3_each_flood_of_the_script_has_its_place(monkeypatch, capsys):
    """The node's own port is 7101, its peer's 7102."""
    flown = []
    monkeypatch.setattr(floods, "flown", lambda seconds, *places: (
        flown.append((seconds, *places)) or (
            {"link": {"bytes_discarded": 3}, "release_jitter_us": {}}, 7.0)))
    floods.main(2)
    assert flown == [(2,), (2, 7104, 7103), (2, 7102, 7101)]
    assert [line.partition(":")[0] for line in
            capsys.readouterr().out.splitlines()] == [
                "no flood", "beside it", "from its peer"]

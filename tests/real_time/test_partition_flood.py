# SPDX-License-Identifier: Apache-2.0
"""RTP-3: a flood from the peer's address. The accepted part depends on the
machine. Asserted is that nothing of it is obeyed and that afterwards the peer
is; needed is that the flood was one."""

import contextlib

from conftest import flies_again, need
from test_partition_input import BEFORE, YOUNG, UDPEnd, acted_upon, command

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

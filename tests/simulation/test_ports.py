# SPDX-License-Identifier: Apache-2.0
"""EVI-11: tests that run at once have ports of their own."""

import sys

from conftest import ROOT

sys.path.insert(0, str(ROOT / "tests"))

from ports import PLACES, free_ports  # noqa: E402


def test_no_port_is_given_twice_before_many_others():
    # A test takes some for each of its programs, which open them later.
    given = [free_ports(2)[0] for _ in range(len(PLACES) // 2)]
    assert len(set(given)) == len(given)

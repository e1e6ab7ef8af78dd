# SPDX-License-Identifier: Apache-2.0
"""A plugin of pytest: a line for each test, once, when it has ended (EVI-11).

    pytest -p test_lines -v

With pytest-xdist pytest shows each test twice, when it begins, too.
"""

import sys

import pytest
from _pytest.terminal import TerminalReporter


class Lines(TerminalReporter):
    """pytest's own, without the line of a test that begins."""

    def pytest_runtest_logstart(self, nodeid, location):
        pass


@pytest.hookimpl(trylast=True)
def pytest_configure(config):
    """Takes the place of pytest's, where there is one: a worker has none."""
    plugins = config.pluginmanager
    before = plugins.getplugin("terminalreporter")
    if before is not None:
        plugins.unregister(before)
        plugins.register(Lines(config, sys.stdout), "terminalreporter")

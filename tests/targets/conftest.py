# SPDX-License-Identifier: Apache-2.0
"""The programs in targets are modules of the tests."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "targets"))

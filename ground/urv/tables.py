# SPDX-License-Identifier: Apache-2.0
"""The lists that the ground shares with the flight software (GND-11).

    TABLES["error_kinds"][0]        "ad_no_scan"

tables.json is the output of `bin/urv_sim tables`, and a test compares the two.
"""

import json
from pathlib import Path

TABLE = Path(__file__).with_name("tables.json")
TABLES = json.loads(TABLE.read_text("utf-8"))

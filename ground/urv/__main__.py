# SPDX-License-Identifier: Apache-2.0
"""python -m urv, as bin/urv calls it."""

import sys

from urv.main import main

sys.exit(main())

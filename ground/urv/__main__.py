# SPDX-License-Identifier: Apache-2.0
"""python -m urv, as bin/urv calls it."""

import sys

try:
    from urv.main import main
except ModuleNotFoundError as fault:
    if (fault.name or "urv").split(".")[0] == "urv":
        raise
    # What every command needs.
    print(f"urv: the package {fault.name} is missing: scripts/setup.sh fly"
          " installs it", file=sys.stderr)
    sys.exit(1)

sys.exit(main())

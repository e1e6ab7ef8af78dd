# SPDX-License-Identifier: Apache-2.0
"""python -I -B .../urv/__main__.py, as bin/urv calls it.

Python's -I looks for modules in its own folders only, not in the current one.
This package's folder is added here. Started programs get none of Python's
environment variables, because PYTHONPATH may name the current folder (SEC-10).
"""

import os
import sys


def run():
    """Runs the command line; returns its exit status."""
    sys.path.insert(0, os.path.dirname(os.path.dirname(
        os.path.abspath(__file__))))
    for name in [name for name in os.environ if name.startswith("PYTHON")]:
        del os.environ[name]
    try:
        from urv.main import main
    except ModuleNotFoundError as fault:
        if (fault.name or "urv").split(".")[0] == "urv":
            raise
        # Every command needs this package.
        print(f"urv: the package {fault.name} is missing: scripts/setup.sh fly"
              " installs it", file=sys.stderr)
        return 1
    return main()


# A worker of bin/urv monte-carlo imports this file under another name.
if __name__ == "__main__":
    sys.exit(run())

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# bin/urv, a link to this: the ground station's commands, run by the Python of
# .venv. scripts/setup.sh makes both. Python's -I removes the current folder and
# PYTHONPATH from its search path of modules (SEC-10).

root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd) || exit 1
if [ ! -x "$root/.venv/bin/python" ]; then
   echo "urv: there is no .venv; scripts/setup.sh page makes it" >&2
   exit 1
fi
exec "$root/.venv/bin/python" -I -B "$root/ground/urv/__main__.py" "$@"

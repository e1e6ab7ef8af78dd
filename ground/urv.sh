#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# bin/urv, a link to this: the ground station's commands, run by the Python of
# .venv. scripts/setup.sh makes both.

root=$(cd "$(dirname "$(readlink -f "$0")")/.." && pwd) || exit 1
if [ ! -x "$root/.venv/bin/python" ]; then
   echo "urv: there is no .venv; scripts/setup.sh ground makes it" >&2
   exit 1
fi
PYTHONPATH=$root/ground${PYTHONPATH:+:$PYTHONPATH}
export PYTHONPATH
exec "$root/.venv/bin/python" -B -m urv "$@"

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Runs a command that says nothing for long, and says each 10 s that it goes on.
#
#   scripts/patiently.sh WHAT COMMAND [ARGUMENT ...]
#
# Exit status: the command's.

what=$1
shift

parent=$$
(
   seconds=0
   while sleep 10 </dev/null >/dev/null 2>&1 && kill -0 $parent 2>/dev/null; do
      seconds=$((seconds + 10))
      echo "$what: $seconds s so far"
   done
) &
ticker=$!
trap 'kill $ticker 2>/dev/null; exit 130' INT TERM

"$@"
status=$?
kill $ticker 2>/dev/null
exit $status

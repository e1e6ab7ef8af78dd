#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Fuzzes a telemetry board for some seconds, or until it has tried so many
# inputs.
#
#   scripts/fuzz.sh SECONDS [INPUTS]
#
# Inputs that were found go to obj/afl. Exit status 1 if one of them makes
# the board violate a contract or raise an exception, or hang.

set -eu
cd "$(dirname "$0")/.."

seconds=${1:?usage: scripts/fuzz.sh SECONDS [INPUTS]}
inputs=${2:-}
found=obj/afl/default

gprbuild -q -p -P fuzz/urv_fuzz.gpr -XURV_Fuzz=fuzz
rm -rf obj/afl
# A busy machine may let an input wait for seconds: that is no hang.
# The machine's core pattern and frequency governor are not ours to change.
AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 \
   AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 \
   AFL_HANG_TMOUT=20000 \
   afl-fuzz -V "$seconds" ${inputs:+-E "$inputs"} -t 5000 \
   -i fuzz/corpus -o obj/afl \
   -- bin/fuzz/urv_fuzz >obj/afl.log 2>&1 || { cat obj/afl.log; exit 1; }

figure ()
{
   sed -n "s/^$1 *: //p" "$found/fuzzer_stats"
}

crashes=$(figure saved_crashes)
hangs=$(figure saved_hangs)
echo "fuzz: $(figure execs_done) inputs, $(figure corpus_count) kept," \
     "$crashes crashes, $hangs hangs"
[ "$crashes" -eq 0 ] && [ "$hangs" -eq 0 ]

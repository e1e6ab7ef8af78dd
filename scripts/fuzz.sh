#!/bin/sh
# Fuzzes a telemetry board for some seconds.
#
#   scripts/fuzz.sh SECONDS
#
# Inputs that were found go to obj/afl. Exit status 1 if one of them makes
# the board violate a contract or raise an exception, or hang.

set -eu
cd "$(dirname "$0")/.."

seconds=${1:?usage: scripts/fuzz.sh SECONDS}
found=obj/afl/default

gprbuild -q -p -P fuzz/urv_fuzz.gpr -XURV_Fuzz=fuzz
rm -rf obj/afl
# The machine's core pattern and frequency governor are not ours to change.
AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 \
   AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 \
   afl-fuzz -V "$seconds" -t 1000 -i fuzz/corpus -o obj/afl \
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

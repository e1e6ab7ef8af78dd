#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Fuzzes a telemetry board, or the readers of key, fault, conditions, orders,
# sticks and sensors files (SEC-14), for some seconds or until it has tried a
# number of inputs; or the readers of bin/urv.
#
#   evidence/fuzz.sh SECONDS [INPUTS]
#   FUZZ=files evidence/fuzz.sh SECONDS [INPUTS]
#   FUZZ=readers evidence/fuzz.sh SECONDS
#
# Inputs that were found go to obj/afl; those of the readers are printed. Exit
# status 1 if one of them violates a contract, raises an exception that is no
# refusal, or hangs.

set -eu
cd "$(dirname "$0")/.."

seconds=${1:?usage: evidence/fuzz.sh SECONDS [INPUTS]}
inputs=${2:-}
found=obj/afl/default
for number in "$seconds" ${inputs:+"$inputs"}; do
   case $number in
      *[!0-9]* | 0*) echo "fuzz: not a number from 1 on: $number" >&2
                     exit 2 ;;
   esac
done

case ${FUZZ:-board} in
   board) program=urv_fuzz ;;
   files) program=urv_file_fuzz ;;
   readers)
          URV_FUZZ_SECONDS=$seconds exec .venv/bin/python -B -m pytest -q -s \
             -p no:cacheprovider --tb=short tests/ground/test_fuzz_readers.py ;;
   *)     echo "fuzz: FUZZ is board, files or readers, not $FUZZ" >&2
          exit 2 ;;
esac

gprbuild -q -p -P "evidence/fuzz/$program.gpr" -XURV_Fuzz=fuzz
rm -rf obj/afl obj/afl-inputs
python3 evidence/fuzz/inputs.py "${FUZZ:-board}" obj/afl-inputs
# A busy machine may let an input wait for seconds: that is no hang.
# The machine's core pattern and frequency governor are not ours to change.
AFL_NO_UI=1 AFL_SKIP_CPUFREQ=1 AFL_NO_AFFINITY=1 \
   AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 \
   AFL_HANG_TMOUT=20000 \
   afl-fuzz -V "$seconds" ${inputs:+-E "$inputs"} -t 5000 \
   -i obj/afl-inputs -o obj/afl \
   -- "bin/fuzz/$program" >obj/afl.log 2>&1 || { cat obj/afl.log; exit 1; }

figure ()
{
   sed -n "s/^$1 *: //p" "$found/fuzzer_stats"
}

crashes=$(figure saved_crashes)
hangs=$(figure saved_hangs)
echo "fuzz: $(figure execs_done) inputs, $(figure corpus_count) kept," \
     "$crashes crashes, $hangs hangs"
[ "$crashes" -eq 0 ] && [ "$hangs" -eq 0 ]

#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Builds the emulated boards of the MC68000, obj/targets/mc68000/board, from
# board.c, and obj/targets/mc68000/explore from explore.c (BRD-8), with the
# Musashi that scripts/setup.sh has fetched (D-84).

set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../../.."
archive=obj/musashi/machine68k-0.4.1.tar.gz
folder=obj/targets/mc68000

if [ ! -f "$archive" ]; then
   echo "build_board.sh: $archive is missing: scripts/setup.sh mc68000" >&2
   exit 1
fi
mkdir -p "$folder"
cd "$folder"
# One build at a time.
exec 8>board_lock
flock 8
explore=$here/../exploration/explore.c
if [ explore -nt "$here/board.c" ] && [ explore -nt "$explore" ] &&
   [ explore -nt "$here/configuration.h" ]
then
   exit 0
fi
rm -rf musashi
mkdir musashi
tar -xzf "../../musashi/${archive##*/}" -C musashi --strip-components=3 \
   machine68k-0.4.1/src/musashi
cd musashi
gcc -w -o m68kmake m68kmake.c
./m68kmake . m68k_in.c >m68kmake.log
options='-std=gnu11 -O2 -DMUSASHI_CNF="configuration.h"'
for source in m68kcpu.c m68kops.c softfloat/softfloat.c; do
   # shellcheck disable=SC2086 # a list of options
   gcc -w -c $options -I"$here" -I. -Isoftfloat "$source"
done
for program in board explore; do
   source=$here/board.c
   [ $program = board ] || source=$explore
   # shellcheck disable=SC2086
   gcc -Wall -Wextra -Werror $options -I"$here" -isystem . "$source" \
      m68kcpu.o m68kops.o softfloat.o -lm -o ../$program
done

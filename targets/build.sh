#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Builds a node's image for a bare machine (BRD-1).
#
#   targets/build.sh cortex_m|mc68000 mcs|gsc
#   targets/build.sh mc68000 telemetry_board|exploration
#
# The image is obj/targets/MACHINE/NODE.bin, with the program's sum in its last
# eight bytes. NODE.elf has the symbols.

set -eu
cd "$(dirname "$0")/.."
root=$PWD
if [ $# -ne 2 ]; then
   echo "usage: targets/build.sh MACHINE PROGRAM, as cortex_m mcs" >&2
   exit 2
fi
machine=$1
node=$2
listing=
small=
tasks=
board=
unlinked=

case $machine in
   cortex_m)
      prefix=arm-linux-gnueabihf-
      processor="-mthumb -mcpu=cortex-m4 -mfloat-abi=soft"
      switches="$processor -fno-pie -fno-pic"
      fast=-O3
      folders="targets/cortex_m targets/cortex_m/netduinoplus2
               targets/drivers/stm32_usart targets/drivers/stm32_watchdog
               targets/drivers/cortex_systick targets/drivers/stm32_pwm
               targets/drivers/stm32_adc"
      # For a real board (BRD-9): QEMU's converter reads nothing.
      unlinked="stm32_adc-conversions stm32_adc-registers"
      rom_size=114688
      order=little ;;
   mc68000)
      prefix=m68k-linux-gnu-
      processor="-m68000"
      # This compiler joins stores to odd addresses, which a 68000 traps. The
      # files .rep have the representation of the types (BRD-4).
      switches="$processor -fno-pie -fno-store-merging"
      # Blocks stay in their order: else their ends are copied, which is for
      # processors that predict branches.
      small=-fno-reorder-blocks
      tasks=-O3
      listing=-gnatR1s
      # Short loops over all task control blocks are unrolled: an index costs
      # more than the work.
      fast="-O3 -freorder-blocks --param max-completely-peeled-insns=200
            --param max-peel-branches=100"
      board="telemetry-boards-dual_ported telemetry_board_program"
      folders="targets/mc68000 targets/mc68000/musashi
               targets/drivers/mc68681"
      rom_size=163840
      order=big ;;
   *)
      echo "targets/build.sh: no machine: $machine; there are: cortex_m," \
           "mc68000" >&2
      exit 2 ;;
esac

for tool in gcc-12 gnatmake-12 gnatbind-12 ld; do
   if ! command -v "$prefix$tool" >/dev/null; then
      echo "targets/build.sh: missing: $prefix$tool:" \
           "scripts/setup.sh $machine installs it" >&2
      exit 1
   fi
done

# The telemetry board of the MC68000 is a processor of its own. Its operations
# are explored (BRD-8).
assembler=
case $machine-$node in
   *-mcs|*-gsc) ;;
   mc68000-telemetry_board)
      assembler=-Wa,--defsym,TELEMETRY_BOARD=1 ;;
   mc68000-exploration)
      folders="$folders targets/mc68000/exploration"
      assembler=-Wa,--defsym,TELEMETRY_BOARD=1,--defsym,UNTESTED=1 ;;
   *)
      echo "targets/build.sh: no program of $machine: $node; there are: mcs," \
           "gsc; and telemetry_board and exploration of mc68000" >&2
      exit 2 ;;
esac

folder=$root/obj/targets/$machine
mkdir -p "$folder/$node"
cd "$folder"
# One build at a time: the nodes share objects.
exec 9>lock
flock 9

# Rebuild the run-time system if the compiler, its switches or this system have
# changed.
stamp="$("${prefix}gcc-12" -v 2>&1 | tail -n 1) $switches
$(cat "$root/targets/runtime/"* "$root/targets/$machine/runtime/"* | cksum)"
if [ "$(cat runtime/stamp 2>/dev/null)" != "$stamp" ]; then
   # shellcheck disable=SC2086 # a list of switches
   "$root/targets/runtime/build_runtime.sh" "$machine" "$prefix" \
      "$folder/runtime" $switches
   echo "$stamp" >runtime/stamp
fi

# Relative to the folders objects and NODE: names of folders above the
# repository may have spaces.
up=../../../..
include=
for each in $folders targets targets/library targets/nodes $(cd "$root" &&
   find src -type d | sort)
do
   include="$include -aI$up/$each"
done

optimise="-O2 -gnatn -fcallgraph-info=su -ffunction-sections -fdata-sections"
optimise="$optimise -fno-tree-loop-distribute-patterns"
optimise="$optimise -fno-delete-null-pointer-checks $small"
march="-freorder-blocks -fno-ipa-cp -funroll-loops --param max-unroll-times=4"
language="-gnat2022 -gnatW8 -gnatwa -gnatwJ -gnatw.X -gnatw.V -gnatwe -gnatyg -gnatyM79 -g"

# Both nodes share the objects, which are made again with other switches.
stamp="$stamp $language $listing $optimise $fast $tasks $march $board
schedulers boards laws fields nodes"
if [ "$(cat objects/stamp 2>/dev/null)" != "$stamp" ]; then
   rm -rf objects
   mkdir objects
   echo "$stamp" >objects/stamp
fi
cd objects

# compile SWITCHES UNIT...: a unit's name, not its path: a machine may have a body
# of its own.
compile() {
   more=$1
   shift
   for unit; do
      # shellcheck disable=SC2086 # lists of switches
      "${prefix}gnatmake-12" -q -c -u --GCC="${prefix}gcc-12" \
         --RTS=../runtime $include "$unit.adb" \
         -cargs $language $listing $optimise $more $switches
   done
}

# The telemetry board's software runs at each character, the converter's board at
# each channel, and the scheduler's loops several times at each tick: they are
# built for speed, and so are loops over surfaces and recorded words.
compile "$fast" telemetry-boards telemetry-receivers telemetry-shared_boards \
   urvos-schedulers urvos-schedulers-calls urv-ad_boards urv-law_steps \
   urv-recorder_rows
# The fields of a chip's register are tested in place.
# shellcheck disable=SC2086 # lists of units
compile "$fast -fno-tree-sra" $board
# The node's unit has the instances of its tasks.
case $node in
   mcs|gsc) compile "$tasks" "$node" ;;
esac
# The march at power up: its data is in registers, and each turn of its loops has
# several cells.
compile "$march" power_up_tests
# shellcheck disable=SC2086
compile "" $unlinked
# shellcheck disable=SC2086
"${prefix}gnatmake-12" -q -c -j0 --GCC="${prefix}gcc-12" \
   --RTS=../runtime $include "${node}_image.adb" \
   -cargs $language $listing $optimise $switches
cd "../$node"
# shellcheck disable=SC2086
"${prefix}gnatbind-12" --RTS=../runtime -aO../objects $include \
   "${node}_image.ali" -O >objects.txt -o b__main.adb
# shellcheck disable=SC2086
"${prefix}gcc-12" -c --RTS=../runtime $optimise $switches -gnatws \
   -gnatWb -I../objects b__main.adb
for each in $folders; do
   for source in "$root/$each"/*.s; do
      [ -f "$source" ] || continue
      # shellcheck disable=SC2086
      "${prefix}gcc-12" -c $processor $assembler "$source" \
         -o "asm_$(basename "$source" .s).o"
   done
done
# shellcheck disable=SC2046 # a list of files without spaces
"${prefix}ld" --gc-sections -z noexecstack --no-warn-rwx-segments -Map=node.map \
   -T "$root/targets/$machine/image.ld" asm_*.o b__main.o \
   $(grep '\.o$' objects.txt | grep -v /adalib/) \
   ../runtime/adalib/libgnat.a -o "$node.elf"
"${prefix}objcopy" -O binary -j .vectors -j .text -j .data --gap-fill 0xff \
   "$node.elf" "$node.raw"
python3 "$root/targets/image_sum.py" "$node.raw" "$node.bin" \
   "$rom_size" "$order"
# Another process may read the present files: each is replaced as a whole.
mv -f "$node.elf" "$node.raw" "$node.bin" ..

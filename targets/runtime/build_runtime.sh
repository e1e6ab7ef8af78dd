#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Makes a small run-time system, without tasks and without an operating system,
# from the sources that come with the installed compiler (D-80).
#
#   targets/runtime/build_runtime.sh MACHINE PREFIX FOLDER SWITCH...
#
# PREFIX is the compiler's prefix, for example arm-linux-gnueabihf-.

set -eu
here=$(cd "$(dirname "$0")" && pwd)
machine=$(cd "$here/../$1/runtime" && pwd)
prefix=$2
compiler=${2}gcc-12
folder=$3
shift 3
sources=$("$compiler" -print-file-name=adainclude)

rm -rf "$folder"
mkdir -p "$folder/adainclude" "$folder/adalib"
cd "$folder/adainclude"
for unit in a-unccon.ads ada.ads interfac.ads s-unstyp.ads s-stoele.ads \
            s-stoele.adb s-maccod.ads
do
   cp "$sources/$unit" .
done

# The target's own package System, with other parameters.
{
   cat "$here/restrictions.adc"
   sed -e '/^pragma Restrictions/d' \
       -e 's/^\( *Configurable_Run_Time *: constant Boolean :=\).*/\1 True;/' \
       -e 's/^\( *Suppress_Standard_Library *: constant Boolean :=\).*/\1 True;/' \
       -e 's/^\( *Command_Line_Args *: constant Boolean :=\).*/\1 False;/' \
       -e 's/^\( *Exit_Status_Supported *: constant Boolean :=\).*/\1 False;/' \
       -e 's/^\( *ZCX_By_Default *: constant Boolean :=\).*/\1 False;/' \
       -e 's/^\( *Support_Atomic_Primitives *: constant Boolean :=\).*/\1 False;/' \
       "$sources/system.ads"
} >system.ads
cp "$here"/s-*.ad? "$machine"/s-*.ad? .

for unit in *.ads *.adb; do
   name=${unit%.ad?}
   case $unit in
      *.ads) [ ! -f "$name.adb" ] || continue ;;
   esac
   "$compiler" -c -gnatg -gnatws -gnatyN -fno-tree-loop-distribute-patterns \
      -O2 "$@" --RTS=.. -I. "$unit" -o "../adalib/$name.o"
   [ ! -f "$name.ali" ] || mv "$name.ali" ../adalib
done
cd ..
"${prefix}ar" rc adalib/libgnat.a adalib/*.o
chmod 444 adalib/*.ali

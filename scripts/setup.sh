#!/bin/sh
# SPDX-License-Identifier: Apache-2.0

# Installs what one target of the Makefile lacks, and nothing else (EVI-11).
# Nothing is fetched whose hash is not in this repository, but Debian's packages,
# which are signed, and Maven's own plug-ins (SEC-17).
#
#   scripts/setup.sh fly|ground|page|test|check|prove|size|campaign|
#                    explore|fuzz|trace|mutate|real_time|timing|coverage|
#                    independence|monte_carlo|margins|cortex_m|mc68000
#
# page is ground without Yamcs, and so without Java.
#
# With Python packages of ground/ it also makes bin/urv.
#
# On Debian 12 and 13 as root it installs packages; as anyone else it names the
# command that does. Elsewhere the tools must be there: alire.toml lists them.

set -eu
cd "$(dirname "$0")/.."

# Below are looked for English words of apt-get and pip.
export LC_ALL=C.UTF-8

target=${1:-}

# The number of this Debian, when packages are to come from it: alr exec has
# put its own compiler and libraries on the PATH.
debian=
if [ -z "${ALIRE:-}" ] && [ -r /etc/os-release ]; then
   debian=$(. /etc/os-release &&
            [ "${ID:-}" = debian ] && echo "${VERSION_ID:-}") || debian=
fi

# In bare: compilers and emulator of bare machines.
case $debian in
   12) build="gnat-12 gprbuild"
       aunit=libaunit22-dev
       gcov=gcc-12
       bare="gnat-12-arm-linux-gnueabihf qemu-system-arm"
       bare_68000="gnat-12-m68k-linux-gnu gcc" ;;
   13) bare='' bare_68000=''
       build="gnat-14 gprbuild"
       aunit=libaunit-dev
       gcov=gcc ;;
   *)  debian= build='' aunit='' gcov='' bare='' bare_68000='' ;;
esac

# The packages of `make ground` besides those of `make test`.
more="default-jre-headless maven"

case $target in
   fly)   packages="$build python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt
                        ground/report-requirements.txt" ;;
   ground | page)
          packages="$build openssl python3 python3-venv"
          [ "$target" = page ] || packages="$packages $more"
          requirements="sim/jsbsim/requirements.txt
                        ground/report-requirements.txt
                        ground/requirements.txt
                        ground/campaign-requirements.txt
                        ground/identify-requirements.txt" ;;
   monte_carlo)
          packages="$build openssl python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt
                        ground/report-requirements.txt
                        ground/requirements.txt
                        ground/campaign-requirements.txt" ;;
   test | check)
          packages="$build $aunit afl++ binutils gcc openssl python3
                    python3-venv socat"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt
                        scripts/trace/requirements.txt
                        ground/report-requirements.txt
                        ground/requirements.txt
                        ground/campaign-requirements.txt
                        ground/identify-requirements.txt"
          # The browser that looks at the station's page.
          [ "$target" = check ] ||
             packages="$packages chromium fonts-dejavu-core $bare $bare_68000"
          [ -z "$bare_68000" ] ||
             requirements="$requirements
                           targets/mc68000/musashi/requirements.txt" ;;
   mutate)
          packages="$build $aunit binutils git python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt" ;;
   coverage)
          packages="$build $aunit $gcov python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt" ;;
   independence)
          packages="$build $aunit python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt" ;;
   margins)
          packages="$build python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt
                        evidence/laws/requirements.txt" ;;
   campaign)
          packages="$build python3 python3-venv"
          requirements="ground/report-requirements.txt" ;;
   cortex_m)
          packages="$build $bare binutils python3"
          requirements="" ;;
   mc68000)
          packages="$build $bare_68000 binutils python3 python3-venv"
          requirements=targets/mc68000/musashi/requirements.txt ;;
   real_time)
          packages="$build"
          requirements="" ;;
   timing)
          packages="$build rt-tests python3"
          requirements="" ;;
   size)  packages="$build binutils python3"
          requirements="" ;;
   prove) packages="$build python3"
          requirements="" ;;
   explore) packages="$build python3"
          requirements="" ;;
   fuzz)  packages="$build gcc afl++"
          requirements="" ;;
   trace) packages="python3 python3-venv"
          requirements="scripts/trace/requirements.txt" ;;
   *)     targets=$(sed -n '/^#   scripts\/setup.sh /,/^#$/s/^# *//p' \
                         scripts/setup.sh | tr -d ' \n' | tr '|' ' ')
          echo "setup: ${target:+no such target: $target; }usage:" \
               "scripts/setup.sh TARGET, one of ${targets#scripts/setup.sh}" >&2
          exit 2 ;;
esac

# The packages of the list that are not installed.
missing_packages ()
{
   for package in "$@"; do
      case $(dpkg-query -W -f '${Status}' "$package" 2>/dev/null) in
         *" installed") ;;
         *) printf ' %s' "$package" ;;
      esac
   done
}

# A command's words go to a file: what apt-get and pip say is long, and its
# last lines are what helps when it fails.
log=$(mktemp)
trap 'rm -f "$log"' EXIT

# The messages of apt-get, pip and Python without a network.
unreachable='Could not resolve|Temporary failure|Name or service not known'
unreachable="$unreachable|[Nn]etwork is unreachable|No route to host"
unreachable="$unreachable|[Cc]onnection (refused|timed out)|Could not connect"
unreachable="$unreachable|NewConnectionError|ConnectTimeout"

# quietly WHAT COMMAND ...: its words go to the log; each 10 s a line says that
# it goes on.
quietly ()
{
   what=$1
   shift
   # shellcheck disable=SC2016 # for the shell that is started
   scripts/patiently.sh "$target: $what" \
      sh -c '"$@" >"$0" 2>&1 </dev/null' "$log" "$@"
}

# failed WHAT WANTED: ends, and says why.
failed ()
{
   if grep -E -q "$unreachable" "$log"; then
      echo "setup: no network: $1 reached nothing. Needed are: $2" >&2
   else
      tail -n 20 "$log" >&2
      echo "setup: $1 failed. Needed are: $2" >&2
   fi
   exit 1
}

install_packages ()
{
   missing=$(missing_packages "$@")
   missing=${missing# }
   [ -n "$missing" ] || return 0
   update="apt-get update"
   install="apt-get install -y --no-install-recommends $missing"
   if [ "$(id -u)" -ne 0 ]; then
      # Enough for fly, test, check and ground, so that root is asked once.
      if [ "$target" = test ]; then
         missing=$(missing_packages "$@" $more)
         install="apt-get install -y --no-install-recommends${missing}"
      fi
      echo "setup: packages are missing. Have this run as root, then try" \
           "again:" >&2
      echo "    $update && $install" >&2
      exit 1
   fi
   echo "$target: installing $missing"
   export DEBIAN_FRONTEND=noninteractive
   # apt-get update succeeds when it reached nothing.
   if ! quietly installing $update || ! grep -E -q '^(Get|Hit):' "$log"
   then
      failed "apt-get update" "$missing"
   fi
   if ! quietly installing $install; then
      failed "apt-get install" "$missing"
   fi
}

# Elsewhere than on Debian: are the commands there?
require_commands ()
{
   for command in "$@"; do
      if ! command -v "$command" >/dev/null 2>&1; then
         echo "setup: $command is missing. This is neither Debian 12 nor 13:" \
              "get Alire and Python 3, then: alr exec -- make $target" >&2
         exit 1
      fi
   done
}

# GNAT's run-time system gives threads of root priorities without looking
# whether it may: a program with tasks would wait for ever.
case $target in
   ground | page | test | real_time | timing | coverage | \
   independence)
      if [ "$(id -u)" -eq 0 ] && command -v chrt >/dev/null 2>&1 &&
         ! chrt -f 1 true 2>/dev/null; then
         echo "setup: root may not give threads real-time priorities here:" \
              "start the container with --cap-add=SYS_NICE, or be another" \
              "user" >&2
         exit 1
      fi ;;
esac

# First: Alire has a compiler of its own, so Debian's would be of no use.
if [ "$target" = prove ] && ! command -v gnatprove >/dev/null 2>&1; then
   echo "setup: gnatprove is not on the PATH. It is no Debian package; Alire" \
        "has it, crate gnatprove 12. Get Alire, https://alire.ada.dev, then:" \
        "cd proofs && alr exec -- make -C .. prove" >&2
   exit 1
fi

if [ -n "$debian" ]; then
   # shellcheck disable=SC2086 # a list of names
   install_packages $packages

   if [ "$target" = cortex_m ] && [ -z "$bare" ]; then
      echo "setup: make cortex_m needs arm-linux-gnueabihf-gcc-12 with GNAT:" \
           "Debian 12 has it, Debian $debian does not" >&2
      exit 1
   fi
   if [ "$target" = mc68000 ] && [ -z "$bare_68000" ]; then
      echo "setup: make mc68000 needs m68k-linux-gnu-gcc-12 with GNAT:" \
           "Debian 12 has it, Debian $debian does not" >&2
      exit 1
   fi

   # Root installs packages of Debian, and nothing else: what follows fetches
   # from PyPI and Maven, and is the work of whoever owns this tree.
   # Not where root has begun it, or the owner has no name here.
   owner=$(stat -c %U .)
   if [ "$(id -u)" -eq 0 ] && [ "$owner" != root ] &&
      [ "$owner" != UNKNOWN ] &&
      { [ ! -e .venv ] || [ "$(stat -c %U .venv)" = "$owner" ]; }
   then
      rm -f "$log"
      exec runuser -u "$owner" -- scripts/setup.sh "$target"
   fi
   python=/usr/bin/python3
else
   require_commands gprbuild gcc python3
   python=python3
fi

# The virtual environment: made again when its Python went away, filled
# again when a list of requirements changed. Each list is complete.
for list in $requirements; do
   if ! .venv/bin/python -c 'import pip' 2>/dev/null; then
      rm -rf .venv
      if ! quietly "making .venv" "$python" -m venv .venv; then
         failed "$python -m venv" "Python 3 with its module venv"
      fi
   fi
   done_list=.venv/$(echo "$list" | tr / -)
   if ! cmp -s "$list" "$done_list"; then
      echo "$target: installing into .venv: $(grep -c == "$list") packages" \
           "of $list"
      if ! quietly "installing into .venv" \
         .venv/bin/python -m pip install --quiet --retries 1 \
         --disable-pip-version-check --no-deps --require-hashes \
         --only-binary :all: -r "$list"
      then
         failed pip "the packages of $list"
      fi
      cp "$list" "$done_list"
   fi
done

case $requirements in
   *ground/*)
      mkdir -p bin
      ln -sf ../ground/urv.sh bin/urv ;;
esac

# The sources of Musashi, the emulator of the 68000 (D-84). pip looks into a
# source archive before it hands it over, with the tools of requirements.txt.
case $target in
   mc68000 | test)
      archive=targets/mc68000/musashi/archive.txt
      if [ -n "$bare_68000" ] &&
         ! cmp -s "$archive" obj/musashi/archive.txt
      then
         echo "$target: getting Musashi"
         mkdir -p obj/musashi
         if ! quietly "getting Musashi" \
            .venv/bin/python -m pip download --quiet --retries 1 \
            --disable-pip-version-check --no-deps --require-hashes \
            --no-build-isolation --no-binary :all: -d obj/musashi \
            -r "$archive"
         then
            failed pip "the archive of $archive"
         fi
         cp "$archive" obj/musashi/archive.txt
      fi ;;
esac

# Yamcs, with what it needs, when the list of it changed. The tests look at it
# where there are Java and Maven; only the station itself asks for them.
case $target in
   ground | test)
      jars=obj/yamcs
      if command -v mvn >/dev/null 2>&1 && command -v java >/dev/null 2>&1 &&
         ! cmp -s ground/yamcs/pom.xml "$jars/pom.xml"
      then
         echo "$target: getting Yamcs with Maven"
         rm -rf "$jars"
         # Its strict checksums are the server's own; SHA256SUMS has ours.
         if ! quietly "getting Yamcs" mvn -B -q --strict-checksums \
            -f ground/yamcs/pom.xml \
            dependency:copy-dependencies -DoutputDirectory="$PWD/$jars/lib"
         then
            failed Maven "Yamcs: ground/yamcs/pom.xml"
         fi
         if ! (cd "$jars/lib" && sha256sum --check --strict --quiet \
                 ../../../ground/yamcs/SHA256SUMS) >"$log" 2>&1 ||
            [ "$(find "$jars/lib" -name '*.jar' | wc -l)" -ne \
              "$(wc -l <ground/yamcs/SHA256SUMS)" ]
         then
            rm -rf "$jars"
            echo "the files are not those of ground/yamcs/SHA256SUMS" >>"$log"
            failed Maven "Yamcs: ground/yamcs/pom.xml"
         fi
         cp ground/yamcs/pom.xml "$jars/pom.xml"
      fi ;;
esac

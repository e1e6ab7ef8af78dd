#!/bin/sh
# Installs what one target of the Makefile lacks, and nothing else.
#
#   scripts/setup.sh fly|test|prove|size|bench|campaign|explore|fuzz|trace|
#                    mutate|real_time|timing|coverage|independence
#
# On Debian 12 as root it installs packages; as anyone else it names the
# command that does. Elsewhere the tools must be there: alire.toml lists them.

set -eu
cd "$(dirname "$0")/.."

target=${1:?usage: scripts/setup.sh TARGET}

build="gnat-12 gprbuild"
simulate="$build libgnatcoll21-dev"
case $target in
   fly)   packages="$simulate python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt" ;;
   test)  packages="$simulate libaunit22-dev afl++ binutils gcc python3
                    python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt
                        scripts/trace/requirements.txt" ;;
   mutate)
          packages="$simulate libaunit22-dev binutils python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt" ;;
   coverage)
          packages="$simulate libaunit22-dev gcc-12 python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt
                        scripts/coverage-requirements.txt" ;;
   independence)
          packages="$simulate libaunit22-dev python3 python3-venv"
          requirements="sim/jsbsim/requirements.txt tests/requirements.txt" ;;
   bench) packages="$simulate gcc python3"
          requirements="" ;;
   campaign)
          packages="$simulate parallel python3"
          requirements="" ;;
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
   explore) packages="$build"
          requirements="" ;;
   fuzz)  packages="$build gcc afl++"
          requirements="" ;;
   trace) packages="python3 python3-venv"
          requirements="scripts/trace/requirements.txt" ;;
   *)     echo "setup: no such target: $target" >&2
          exit 2 ;;
esac

is_debian_12 ()
{
   [ -r /etc/os-release ] &&
      (. /etc/os-release && [ "${ID:-}" = debian ] &&
         [ "${VERSION_ID:-}" = 12 ])
}

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

install_packages ()
{
   missing=$(missing_packages "$@")
   [ -n "$missing" ] || return 0
   if [ "$(id -u)" -ne 0 ]; then
      echo "setup: missing:$missing" >&2
      echo "setup: install with: sudo apt-get install$missing" >&2
      exit 1
   fi
   echo "setup: installing$missing"
   export DEBIAN_FRONTEND=noninteractive
   log=$(mktemp)
   # shellcheck disable=SC2086 # a list of names
   if ! { apt-get update && apt-get install -y --no-install-recommends \
          $missing; } >"$log" 2>&1 </dev/null
   then
      cat "$log" >&2
      rm -f "$log"
      echo "setup: apt-get failed" >&2
      exit 1
   fi
   rm -f "$log"
}

# Elsewhere than on Debian 12: are the commands there?
require_commands ()
{
   for command in "$@"; do
      if ! command -v "$command" >/dev/null 2>&1; then
         echo "setup: $command is missing. This is not Debian 12: get" \
              "Alire and Python 3, then: alr exec -- make $target" >&2
         exit 1
      fi
   done
}

# alr exec has put its own compiler and libraries on the PATH.
if is_debian_12 && [ -z "${ALIRE:-}" ]; then
   # shellcheck disable=SC2086 # a list of names
   install_packages $packages
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
      "$python" -m venv .venv
   fi
   done_list=.venv/$(echo "$list" | tr / -)
   if ! cmp -s "$list" "$done_list"; then
      echo "setup: installing $list"
      .venv/bin/python -m pip install --quiet \
         --disable-pip-version-check --no-deps -r "$list"
      cp "$list" "$done_list"
   fi
done

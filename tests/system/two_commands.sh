#!/usr/bin/env bash
# The shell half of demo.sh and test.sh, with stand-ins for apt, dpkg and sudo: what is installed,
# what is said where nothing can be.
# shellcheck disable=SC2016  # commands are expanded where they run
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
failures=0

check() { # check WHAT EXPECTED FOUND
  case $3 in
    *"$2"*) ;;
    *)
      printf 'FAILED %s\n  expected: %s\n  found: %s\n' "$1" "$2" "$3"
      failures=$((failures + 1))
      ;;
  esac
}

stand_in() { # stand_in COMMAND BODY: puts a command of that name first on the path
  mkdir -p "$folder/bin"
  printf '#!/bin/sh\n%s\n' "$2" >"$folder/bin/$1"
  chmod +x "$folder/bin/$1"
}

packages() { # packages COMMAND…: runs commands of tools/packages.sh with the stand-ins
  PATH="$folder/bin:$PATH" root=$root bash -c '. "$root/tools/packages.sh"; '"$1" 2>&1 || echo "exit $?"
}

for script in demo.sh test.sh .ci/run tools/packages.sh; do
  bash -n "$root/$script"
done

# The list.
check "sections are apart" "libeigen3-dev" "$(packages 'packages_of build')"
case $(packages 'packages_of build') in *gtest*) check "[build] without tests' packages" none gtest ;; esac
check "both sections" "libgtest-dev" "$(packages 'packages_of build test')"

# Nothing missing: apt is never called.
stand_in dpkg-query 'echo installed'
stand_in apt-get 'echo "apt-get $*"'
check "nothing to install" "done" "$(packages 'install_packages build; echo done')"
case $(packages 'install_packages build') in *apt-get*) check "apt is left alone" none apt-get ;; esac

# One missing, as root.
stand_in id 'echo 0'
stand_in dpkg-query 'case "$*" in *libfmt-dev*) exit 1 ;; esac; echo installed'
found=$(packages 'install_packages build')
check "updates first" "apt-get --quiet --yes" "$found"
check "installs what is missing" "install --no-install-recommends libfmt-dev" "$found"
case $found in *cmake*) check "installs nothing else" none cmake ;; esac

# apt fails.
stand_in apt-get 'exit 100'
found=$(packages 'install_packages build')
check "says what failed" "apt-get could not install: libfmt-dev" "$found"
check "exit code" "exit 3" "$found"

# Neither root nor sudo.
stand_in id 'echo 1000'
found=$(packages 'command() { [ "$2" != sudo ] && builtin command "$@"; }; install_packages build')
check "says what root must run" "apt-get install --no-install-recommends libfmt-dev" "$found"

# Another distribution.
found=$(packages 'command() { [ "$2" != apt-get ] && builtin command "$@"; }; install_packages build')
check "says that apt is missing" "this machine has no apt" "$found"
check "lists the packages" "libeigen3-dev" "$found"

# A full disk.
stand_in df 'echo header; echo "disk 100 98 2048 99% /"'
check "says how full the disk is" "has 2 MB left; building needs about 800 MB" \
  "$(packages 'need_space / 800 building')"

# Memory bounds the number of compilers; at least one runs.
stand_in awk 'echo 0'
check "at least one job" 1 "$(packages 'build_jobs')"

[ "$failures" -eq 0 ] || exit 1
echo "passed"

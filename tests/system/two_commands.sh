#!/usr/bin/env bash
# The shell half of demo.sh, test.sh and the bare machine that runs them, with stand-ins for apt, dpkg, sudo and
# others: what is installed, what is said where nothing can be, and that nothing is left.
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

bare_machine() { # bare_machine ARGUMENT…
  TMPDIR=$folder/temporary PATH="$folder/bin:$PATH" "$root/tools/bare_machine.sh" "$@" 2>&1 </dev/null ||
    echo "exit $?"
}

for script in demo.sh test.sh .ci/run tools/packages.sh tools/bare_machine.sh; do
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

# What Python files need is listed; the check sees what is not.
python=${LIMBER_PYTHON:-/usr/bin/python3}
check "packages.txt is whole" "lists what" "$("$python" "$root/tests/python/check_packages.py" 2>&1)"
mkdir -p "$folder/project/tests"
printf '[build]\n[benchmark]\npython3-yaml\n' >"$folder/project/packages.txt"
printf 'import os, yaml\nfrom colour import red\n' >"$folder/project/tests/test_it.py"
found=$("$python" "$root/tests/python/check_packages.py" "$folder/project" || echo "exit $?")
check "a module of no listed package" \
  "tests/test_it.py:1: 'yaml' is in python3-yaml, which packages.txt does not list in [build] or [test]" "$found"
check "an unknown module" "tests/test_it.py:2: 'colour' is in no package" "$found"
check "a check that fails" "exit 1" "$found"

# No bare machine: each with the code that is its own.
mkdir "$folder/temporary"
found=$(bare_machine)
check "what to give it" "usage: tools/bare_machine.sh COMMAND" "$found"
check "usage" "exit 125" "$found"
if ! PATH=/usr/bin:/bin command -v debootstrap >/dev/null; then
  found=$(PATH=/usr/bin:/bin bare_machine true)
  check "no debootstrap" "debootstrap is missing; as root, run: apt-get install debootstrap git" "$found"
  check "no debootstrap" "exit 125" "$found"
fi
for program in debootstrap git unshare setpriv; do stand_in $program 'exit 1'; done
found=$(bare_machine ./test.sh)
check "not root" "only root can make a machine: sudo tools/bare_machine.sh ./test.sh" "$found"
stand_in id 'echo 0'
found=$(bare_machine true)
check "no mounts" "does not permit mounts and chroot" "$found"
check "no mounts" "exit 125" "$found"
rm "$folder/bin/git" "$folder/bin/unshare" "$folder/bin/setpriv" "$folder/bin/id"

# What goes wrong inside, where machines can be made.
stand_in apt-get "echo \"'http://nowhere/debian/dists/bookworm/InRelease' x 0\""
stand_in debootstrap 'echo "no such mirror: $4"; exit 1'
if [ "$(id -u)" -eq 0 ] && command -v git >/dev/null && unshare --mount --pid --fork --mount-proc true 2>/dev/null; then
  found=$(bare_machine true)
  check "debootstrap's words" "no such mirror: http://nowhere/debian" "$found"
  check "whose sources" "what apt's sources name for bookworm: http://nowhere/debian" "$found"
  check "debootstrap fails" "exit 125" "$found"
  # Stopped while it works: nothing runs on, nothing is left.
  stand_in debootstrap "touch $folder/begun; exec sleep 987654"
  TMPDIR=$folder/temporary PATH="$folder/bin:$PATH" "$root/tools/bare_machine.sh" true 2>/dev/null &
  for _ in {1..200}; do [ ! -e "$folder/begun" ] || break; sleep 0.1; done
  kill -TERM $!
  code=0
  wait $! || code=$?
  check "stopped" "exit 143" "exit $code"
  check "nobody is left" "0 sleepers" "$(grep -lsa "[9]87654" /proc/[0-9]*/cmdline | wc -l) sleepers"
  check "nothing is left" "0 files" "$(find "$folder/temporary" -mindepth 1 | wc -l) files"
fi

# .ci/run hands on what the bare machine says, and falls back to this one only where there is none.
mkdir -p "$folder/project/.ci" "$folder/project/tools"
cp "$root/.ci/run" "$folder/project/.ci"
cp "$root/tools/packages.sh" "$folder/project/tools"
printf '#!/bin/sh\necho "here $*"\n' >"$folder/project/test.sh"
chmod +x "$folder/project/test.sh"
ci_run() { # ci_run CODE: with a bare machine that ends with it
  printf '#!/bin/sh\necho "bare $*"\nexit %s\n' "$1" >"$folder/project/tools/bare_machine.sh"
  chmod +x "$folder/project/tools/bare_machine.sh"
  "$folder/project/.ci/run" -L unit 2>&1 || echo "exit $?"
}
check "tests pass" "bare ./test.sh -L unit." "$(ci_run 0)."
check "tests fail" "bare ./test.sh -L unit
exit 8." "$(ci_run 8)."
check "no bare machine" "the tests run on this machine
here -L unit." "$(ci_run 125)."

# A full disk.
stand_in df 'echo header; echo "disk 100 98 2048 99% /"'
check "says how full the disk is" "has 2 MB left; building needs about 800 MB" \
  "$(packages 'need_space / 800 building')"

# Memory bounds the number of compilers; at least one runs.
stand_in awk 'echo 0'
check "at least one job" 1 "$(packages 'build_jobs')"

[ "$failures" -eq 0 ] || exit 1
echo "passed"

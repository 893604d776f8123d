#!/usr/bin/env bash
# Runs clang-tidy 14 over sources of the dev build: all, or those of the modules named.
#
#   tools/check_tidy.sh [MODULE…]
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
program=$(command -v clang-tidy-14 || command -v clang-tidy) || {
  echo "error: no clang-tidy; install the Debian package clang-tidy" >&2
  exit 3
}
[ -e build/dev/compile_commands.json ] || cmake --preset dev >/dev/null

folders=()
for module in "$@"; do
  folders+=("src/$module/*.cpp")
done
[ $# -gt 0 ] || folders=('src/*.cpp' 'apps/*.cpp')
git ls-files -z "${folders[@]}" |
  xargs -0 --max-args=1 --max-procs="$(nproc)" "$program" -p build/dev --quiet

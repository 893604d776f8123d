#!/usr/bin/env bash
# Checks that every C++ file is as clang-format 14 and .clang-format want it, and that no line of one
# is longer than 100 characters (comments and texts are wrapped by hand); --fix rewrites what can be.
# Last, that no source uses what clang 14 can't compile.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
program=$(command -v clang-format-14 || command -v clang-format) || {
  echo "error: no clang-format; install the Debian package clang-format" >&2
  exit 3
}
mode=(--dry-run --Werror)
[ "${1:-}" != --fix ] || mode=(-i)
git ls-files -z '*.cpp' '*.hpp' | xargs -0 "$program" "${mode[@]}"
# Characters, not bytes: names and units in comments are UTF-8.
if long=$(git ls-files -z '*.cpp' '*.hpp' | LC_ALL=C.UTF-8 xargs -0 grep -nHP '^.{101,}$'); then
  printf '%s\n' "$long" "error: lines of more than 100 characters: wrap them by hand" >&2
  exit 1
fi
if views=$(git ls-files -z 'src/*.cpp' 'src/*.hpp' 'fuzz/*.cpp' | xargs -0 grep -nH 'std::views'); then
  printf '%s\n' "$views" "error: clang 14, which builds the fuzz targets, has no std::views: write a loop" >&2
  exit 1
fi

#!/usr/bin/env bash
# Checks that every C++ file is as clang-format 14 and .clang-format want it; --fix rewrites them.
set -euo pipefail
cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.."
program=$(command -v clang-format-14 || command -v clang-format) || {
  echo "error: no clang-format; install the Debian package clang-format" >&2
  exit 3
}
mode=(--dry-run --Werror)
[ "${1:-}" != --fix ] || mode=(-i)
git ls-files -z '*.cpp' '*.hpp' | xargs -0 "$program" "${mode[@]}"

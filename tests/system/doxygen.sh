#!/usr/bin/env bash
# Doxygen reads every public header without a warning, and Doxyfile names the headers of every module.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
cd -- "$root"

program=${DOXYGEN:-$(command -v doxygen)} || {
  echo "doxygen is not installed (Debian: doxygen): headers were not checked"
  exit 77
}
for module in src/*/include/limber/*; do
  name=$(basename -- "$module")
  [ -d "src/$name/include/limber/$name" ] || continue
  ls "src/$name/include/limber/$name"/*.hpp >/dev/null 2>&1 || continue
  grep -q " src/$name/include" Doxyfile || {
    echo "Doxyfile does not name src/$name/include"
    exit 1
  }
done
{
  cat Doxyfile
  echo "OUTPUT_DIRECTORY = $folder"
} >"$folder/Doxyfile"
"$program" "$folder/Doxyfile"
[ -e "$folder/html/classlimber_1_1Planner.html" ] || {
  echo "no page of limber::Planner was written"
  exit 1
}
# The test would see a warning.
printf '#pragma once\n/// \\unheardof <preset>\nint unheard();\n' >"$folder/bad.hpp"
{
  cat Doxyfile
  echo "OUTPUT_DIRECTORY = $folder/bad"
  echo "INPUT = $folder/bad.hpp"
} >"$folder/Doxyfile"
if "$program" "$folder/Doxyfile" 2>/dev/null; then
  echo "a header with an unknown command passed"
  exit 1
fi
echo "passed"

#!/usr/bin/env bash
# limber installed into a fresh folder: its program finds its data there, and a project of a user's
# own (examples/cpp) builds and runs against it through find_package(limber).
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
prefix=$folder/prefix

cmake --install "$LIMBER_BUILD_DIR" --prefix "$prefix" >/dev/null
for file in bin/limber share/limber/arms/three_segment.yaml include/limber/common/version.hpp; do
  [ -e "$prefix/$file" ] || { echo "not installed: $file"; exit 1; }
done
cd -- "$folder" # away from the source tree: nothing there may be needed
"$prefix/bin/limber" --version

cp -r "$root/examples/cpp" "$folder/examples"
cmake -S "$folder/examples" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$folder/build"
export LIMBER_DATA_DIR=$prefix/share/limber
"$folder/build/01_reach_a_pose" 0.45 0.3 | tee reach.txt
grep -q ' -> ' reach.txt || { echo "no pressures were found"; exit 1; }
if "$folder/build/01_reach_a_pose" 5 5 >far.txt; then
  echo "a goal 5 m away was reached: $(cat far.txt)"
  exit 1
fi
"$folder/build/02_draw_the_arm" arm.svg 40 -40 40
python3 "$root/tests/python/describe_xml.py" arm.svg >described.txt
grep -q 'text: three_segment' described.txt
echo "passed"

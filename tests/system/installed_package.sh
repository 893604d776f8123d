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

# The Python module, where it was built.
if [ -d "$LIMBER_BUILD_DIR/python" ]; then
  PYTHONPATH=$prefix/lib/python3/dist-packages /usr/bin/python3 -c "
import limber
assert limber.__file__.startswith('$prefix'), limber.__file__
assert str(limber.data_folder()) == '$prefix/share/limber', limber.data_folder()"
fi

# Every header for users, alone and with nothing of the source tree.
(cd "$prefix/include" && find limber -name '*.hpp') | sed 's|.*|#include "&"|' >all.cpp
c++ -std=c++20 -fsyntax-only -I"$prefix/include" -I/usr/include/eigen3 all.cpp
[ "$(wc -l <all.cpp)" -le 90 ] || { echo "$(wc -l <all.cpp) public headers; at most 90"; exit 1; }

# From a recording to an executed plan, by the examples alone: a network of a few epochs will do.
LIMBER_DATA_DIR=$prefix/share/limber "$prefix/bin/limber" collect --arm three_segment \
  --schedule random --count 20 --episodes 2 --seed 4 --out train.h5 --quiet
"$folder/build/06_train_from_a_recording" train.h5 model.safetensors 3 | grep -q 'unseen runs'
"$folder/build/03_query_the_model" model.safetensors 60 | grep -q 'segment 0 at 60'
environment=$prefix/share/limber/environments/01_pillar.yaml
verdict=0
"$folder/build/04_plan_and_verify" model.safetensors "$environment" plan.json >plan.txt || verdict=$?
grep -q '^certified\|^no plan' plan.txt && [ "$verdict" -le 1 ]
if [ -e plan.json ]; then
  "$folder/build/05_execute" plan.json "$environment" | tee executed.txt || true
  grep -q '^done: ' executed.txt
fi
echo "passed"

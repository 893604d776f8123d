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
# The README's lines too, as a program.
{
  printf '#include "limber/planning/planner_factory.hpp"\nint main() {\n'
  sed -n '/^```cpp/,/^```/p' "$root/README.md" | grep -v '^```'
  printf '}\n'
} >"$folder/examples/readme.cpp"
echo 'limber_example(readme planning)' >>"$folder/examples/CMakeLists.txt"
cmake -S "$folder/examples" -B "$folder/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$prefix" >/dev/null
cmake --build "$folder/build"
export LIMBER_DATA_DIR=$prefix/share/limber
"$folder/build/09_reach_a_pose" 0.45 0.3 | tee reach.txt
grep -q ' -> ' reach.txt || { echo "no pressures were found"; exit 1; }
if "$folder/build/09_reach_a_pose" 5 5 >far.txt; then
  echo "a goal 5 m away was reached: $(cat far.txt)"
  exit 1
fi
"$folder/build/10_draw_the_arm" arm.svg 40 -40 40
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
[ "$(wc -l <all.cpp)" -le 80 ] || { echo "$(wc -l <all.cpp) public headers; at most 80"; exit 1; }

# From a recording to an executed plan, by the examples alone: a network of some epochs will do, and
# need not find plans that arrive.
run=$folder/build
"$run/02_record_and_train" train.h5 model.safetensors 90 | tee train.txt
grep -q 'epoch 90: loss' train.txt && grep -q 'unseen runs' train.txt
"$run/01_query_the_model" model.safetensors 60 | grep -q 'segment 0 at \(60\|59\)'
environment=$prefix/share/limber/environments/01_pillar.yaml
at_most_1() { "$@" || [ $? -eq 1 ]; }
at_most_1 "$run/03_plan_and_verify" model.safetensors "$environment" plan.json | tee plan.txt
grep -q '^certified\|^no plan' plan.txt
"$prefix/bin/limber" plan --model model.safetensors --environment 01_pillar --margin-m 0 \
  --goal-margin-m 0 --goal-margin-rad 0 --max-queries 100000 --out wrong.json --quiet
at_most_1 "$run/04_execute" wrong.json "$environment" model.safetensors | tee executed.txt
"$run/11_your_own_controller" wrong.json "$environment" | grep '^done: '
grep -q '^open loop: done' executed.txt && grep -q '^closed loop: \(done\|stopped\)' executed.txt
at_most_1 "$run/06_plug_in_a_planner" model.safetensors "$environment" own.json | tee own.txt
grep -q ', certified$\|^no plan' own.txt
# limber without OMPL says so, and how to get it.
if "$run/07_ompl" model.safetensors "$environment" >ompl.txt 2>&1; then
  grep -q '^ompl:RRT: ' ompl.txt
else
  grep -q 'libompl-dev' ompl.txt
fi
"$run/12_arm_in_space" space.h5 space.safetensors 9 | tee space.txt
grep -q '^after one frame: tip' space.txt
"$prefix/bin/limber" export train.h5 --csv logs --quiet
at_most_1 "$run/05_bring_your_own_arm" "$prefix/share/limber/arms/three_segment.yaml" \
  logs/mapping.yaml "$environment" own_arm.json 9 logs/episode_*.csv | tee own_arm.txt
grep -q '^own_arm.json: \|^no plan' own_arm.txt
mkdir out
cp model.safetensors out/
cp -r "$prefix/share/limber/arms" "$prefix/share/limber/environments" .
"$run/readme"
echo "passed"

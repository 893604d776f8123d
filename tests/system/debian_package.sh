#!/usr/bin/env bash
# The Debian packages limber, limber-dev and python3-limber: what each holds and depends on. Extracted
# into one root, the program runs, an example builds against them, and the module is imported.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT
fail() { echo "FAILED: $*"; exit 1; }

cpack --config "$LIMBER_BUILD_DIR/CPackConfig.cmake" -B "$folder" >"$folder/cpack.txt" 2>&1 || {
  cat "$folder/cpack.txt"
  exit 1
}
architecture=$(dpkg --print-architecture)
package() { echo "$folder/$1"_*_"$architecture.deb"; }
packages=(limber limber-dev)
[ ! -d "$LIMBER_BUILD_DIR/python" ] || packages+=(python3-limber)
[ "$(find "$folder" -maxdepth 1 -name '*.deb' | wc -l)" -eq "${#packages[@]}" ] ||
  fail "packages other than ${packages[*]}: $(ls "$folder")"

version=$(dpkg-deb --field "$(package limber)" Version)
# depends PACKAGE WORD…
depends() {
  local field word
  field=$(dpkg-deb --field "$(package "$1")" Depends)
  echo "$1 depends on: $field"
  for word in "${@:2}"; do
    [[ $field == *"$word"* ]] || fail "$1 does not depend on $word"
  done
}
depends limber libmujoco libhdf5 libtbb libyaml-cpp
depends limber-dev "limber (= $version)" libeigen3-dev libmujoco-dev libhdf5-dev libfmt-dev
[[ $(dpkg-deb --field "$(package limber)" Depends) != *-dev* ]] || fail "limber depends on headers"

# The program alone: no headers, no libraries to link with.
runtime=$folder/runtime
dpkg-deb --extract "$(package limber)" "$runtime"
for file in bin/limber share/limber/arms/three_segment.yaml share/limber/environments/01_pillar.yaml \
  share/doc/limber/LICENSE share/doc/limber/SECURITY.md share/man/man1/limber.1 share/man/man1/limber-plan.1 \
  share/bash-completion/completions/limber share/zsh/vendor-completions/_limber; do
  [ -e "$runtime/usr/$file" ] || fail "not in limber: usr/$file"
done
found=$(find "$runtime" -name '*.hpp' -o -name '*.a' -o -name '*.cmake' -o -name '*.py')
[ -z "$found" ] || fail "limber holds what is not of the program: $found"
cd -- "$folder" # away from the source tree: nothing there may be needed
runtime/usr/bin/limber collect --arm two_segment --schedule random --count 1 --out x.h5 --quiet
[ -s x.h5 ] || fail "nothing was collected"

for name in "${packages[@]}"; do
  dpkg-deb --extract "$(package "$name")" all
done
[ -e all/usr/include/limber/common/version.hpp ] || fail "no headers in limber-dev"
if grep -q '^CMAKE_BUILD_TYPE:.*=Release$' "$LIMBER_BUILD_DIR/CMakeCache.txt"; then # what users get
  /usr/bin/python3 "$root/tests/system/check_supply.py" all "$root/packages.txt" "$LIMBER_BUILD_DIR"
fi
cp -r "$root/examples/cpp" examples
cmake -S examples -B build -G Ninja -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$folder/all/usr" >cmake.txt || fail "$(cat cmake.txt)"
cmake --build build --target 09_reach_a_pose
grep -q "^limber_DIR:PATH=$folder/all/" build/CMakeCache.txt || fail "another limber was found"
LIMBER_DATA_DIR=$folder/all/usr/share/limber build/09_reach_a_pose 0.45 0.3 | grep ' -> '

# The Python module, where it was built.
if [ -d "$LIMBER_BUILD_DIR/python" ]; then
  depends python3-limber "limber (= $version)" python3-numpy 'python3 (<< '
  PYTHONPATH=$folder/all/usr/lib/python3/dist-packages /usr/bin/python3 -c "
import limber
assert limber.__file__.startswith('$folder'), limber.__file__
print(limber.load_arm(limber.data_folder() / 'arms' / 'three_segment.yaml'))"
fi
echo "passed"

#!/usr/bin/env bash
# The Debian package: what it holds, what it depends on, and that its program finds its own arms.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

cpack --config "$LIMBER_BUILD_DIR/CPackConfig.cmake" -B "$folder" >"$folder/cpack.txt" 2>&1 || {
  cat "$folder/cpack.txt"
  exit 1
}
package=$(echo "$folder"/limber_*_"$(dpkg --print-architecture)".deb)
dpkg-deb --field "$package" Package Version Depends
for library in libmujoco libhdf5 libtbb libyaml-cpp; do
  dpkg-deb --field "$package" Depends | grep -q "$library" || {
    echo "the package does not depend on $library"
    exit 1
  }
done

dpkg-deb --extract "$package" "$folder/root"
for file in usr/bin/limber usr/share/limber/arms/three_segment.yaml \
  usr/share/limber/environments/01_pillar.yaml usr/include/limber/common/version.hpp \
  usr/share/doc/limber/LICENSE; do
  [ -e "$folder/root/$file" ] || {
    echo "not in the package: $file"
    exit 1
  }
done
# The Python module, where it was built.
if [ -d "$LIMBER_BUILD_DIR/python" ]; then
  PYTHONPATH=$folder/root/usr/lib/python3/dist-packages /usr/bin/python3 -c "
import limber
assert limber.__file__.startswith('$folder'), limber.__file__
print(limber.load_arm(limber.data_folder() / 'arms' / 'three_segment.yaml'))"
fi
cd -- "$folder"
root/usr/bin/limber collect --arm two_segment --schedule random --count 1 --out x.h5 --quiet
[ -s x.h5 ]
echo "passed"

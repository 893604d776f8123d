#!/usr/bin/env bash
# The wheel: built by pip, installed in a fresh virtual environment, and asked for a plan. Its module is
# the one that is built already, and CMake is only seen to configure; with --build, from nothing but a
# copy of the source tree, as `pip wheel .` does it, which takes as long as a build.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
python=${LIMBER_PYTHON:-/usr/bin/python3}
if [ ! -d "$LIMBER_BUILD_DIR/python" ]; then
  echo "skipped: no Python module in $LIMBER_BUILD_DIR"
  exit 0
fi
folder=$(mktemp -d)
trap 'rm -rf -- "$folder"' EXIT

mkdir "$folder/source"
tar -C "$root" --exclude=./build --exclude=./.git --exclude=__pycache__ -c . | tar -C "$folder/source" -x
cd -- "$folder"
wheel() {
  "$python" -m pip wheel --no-build-isolation --no-deps --no-index --quiet --wheel-dir wheels ./source
}
if [ "${1-}" = --build ]; then
  (unset LIMBER_BUILD_DIR && wheel)
else
  # A cmake that configures, and only notes what is to be built.
  mkdir bin
  cat >bin/cmake <<SCRIPT
#!/bin/sh
echo "\$@" >>"$folder/asked.txt"
case "\$1" in --build) exit 1 ;; esac
exec "$(command -v cmake)" "\$@"
SCRIPT
  chmod +x bin/cmake
  if (unset LIMBER_BUILD_DIR && PATH=$folder/bin:$PATH wheel) >configured.txt 2>&1; then
    echo "a wheel was made of nothing"
    exit 1
  fi
  [ -e source/build/wheel/build.ninja ] || { cat configured.txt; exit 1; }
  grep -q -- '^--build .*--target limber_python$' asked.txt || { cat asked.txt; exit 1; }
  rm -rf source/build
  wheel
fi
"$python" -m venv --system-site-packages environment # NumPy is Debian's
environment/bin/pip install --no-index --no-deps --quiet wheels/limber-*.whl
unset PYTHONPATH
environment/bin/python - <<'PYTHON'
import limber
assert "/environment/" in limber.__file__, limber.__file__
assert limber.data_folder().parts[-2:] == ("limber", "data"), limber.data_folder()
arm = limber.load_arm(limber.data_folder() / "arms" / "two_segment.yaml")
environment = limber.Environment("free", [], limber.PoseGoal(x_m=0.38, y_m=0.1))
model = limber.MotionModel(limber.ForwardModel(arm))
result = limber.plan(arm, model, environment, limber.PlannerLimits(iterations=300))
assert result.plan, result.reason
print(limber.__version__, result)
PYTHON
echo "passed"

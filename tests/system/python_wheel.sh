#!/usr/bin/env bash
# The wheel: built by pip from the source tree and the libraries that are built already, installed in
# a fresh virtual environment, and asked for a plan.
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
for part in pyproject.toml setup.py CMakeLists.txt README.md LICENSE python arms environments; do
  cp -r "$root/$part" "$folder/source/"
done
cd -- "$folder"
"$python" -m pip wheel --no-build-isolation --no-deps --no-index --quiet --wheel-dir wheels ./source
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
result = limber.make_planner().plan(limber.PlanningProblem(arm, model, environment),
                                    limber.PlannerLimits(iterations=300), seed=1)
assert result.plan, result.reason
print(limber.__version__, result)
PYTHON
echo "passed"

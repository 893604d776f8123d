#!/bin/bash
# limber execute: a plan from `limber plan` run on the virtual arm; the run's files; what is refused.
. "$(dirname -- "$(readlink -f -- "$0")")/expect.sh"

cat >side.yaml <<'EOF'
schema: limber/environment/1
name: side
obstacles:
  - circle: {x_m: 0.62, y_m: 0.45, radius_m: 0.06}
start: rest
goal: {x_m: 0.45, y_m: -0.35, position_tolerance_m: 0.05}
EOF
sed 's/name: side/name: moved/; s/0.45, radius/0.40, radius/' side.yaml >moved.yaml
expect 0 "" plan --no-load --environment side.yaml --max-iterations 300 --out plan.json
expect 0 "plan for arm 'three_segment' in 'side'" inspect plan.json --arm three_segment

run=(execute --plan plan.json --environment side.yaml)
expect 1 "from the goal: " "${run[@]}" --out run.h5 --svg run.svg
grep -q "^</svg>" run.svg || fail "run.svg is not whole"
expect 0 "executed plan, environment 'side', model no_load" inspect run.h5 --arm three_segment
expect 1 '"status": "done"' "${run[@]}" --json --out again.h5
for key in collided min_clearance_cm distance_to_goal_cm replans frames; do
  grep -q "\"$key\": [^n]" output.txt || fail "no $key in $(cat output.txt)"
done
cmp run.h5 again.h5 || fail "the same plan gives two runs"

expect 2 "run.h5: exists already; --force replaces it" "${run[@]}" --out run.h5
expect 2 "plan.json: made for environment 'side'" execute --plan plan.json --environment moved.yaml
expect 2 "made for arm 'three_segment'" "${run[@]}" --arm two_segment
expect 2 "--driver hose: expected virtual" "${run[@]}" --driver hose
expect 2 "hold_s = -1; expected seconds from 0" "${run[@]}" --hold-s=-1
head -c 300 plan.json >cut.json
expect 2 "cut.json" execute --plan cut.json --environment side.yaml --out none.h5
expect 2 "side.yaml" execute --plan side.yaml --environment side.yaml --out none.h5
[ ! -e none.h5 ] || fail "a refused run wrote a recording"

#!/bin/bash
# limber characterize: its own bench test, a user's CSV, and what it refuses: exit codes, messages,
# and that nothing is left behind by a failure.
program=("$LIMBER_PROGRAM" characterize)
. "$(dirname -- "$(readlink -f -- "$0")")/expect.sh"

# The bench test finds what the arm file says, and writes the very same file.
expect 0 "arm written to arm.yaml" --arm two_segment --out arm.yaml --plot bench.svg
grep -q "^</svg>" bench.svg || fail "bench.svg is not whole"
grep -qF "# [C] braid friction" arm.yaml || fail "comments of the arm file are lost"
expect 0 "arm written to again.yaml" --arm arm.yaml --out again.yaml
cmp arm.yaml again.yaml || fail "characterising twice gives two arms"

# The arm file says the same already: its numbers stay. One without any is filled.
expect 0 '"kept": true' --arm two_segment --json
sed 's/strain_polynomial: \[.*\]/strain_polynomial: []/' arm.yaml >unfitted.yaml
expect 0 '"kept": false' --arm unfitted.yaml --json

# A user's data: a straight line of 0.2 % contraction a kPa.
{ echo "pressure_kpa,strain"; for p in 0 10 20 40 60 80 100; do
    echo "$p,$(awk "BEGIN {print -0.002 * $p}")"; done; } >line.csv
expect 0 '"refitted": false' --arm two_segment --csv line.csv --json
expect 0 "full strain 0.2000" --arm two_segment --csv line.csv --out line.yaml
expect 0 "full strain 0.2000" --arm line.yaml --csv line.csv

# An arm that was never characterised.
sed 's/strain_polynomial: \[.*\]/strain_polynomial: []/' arm.yaml >raw.yaml
expect 0 "full strain 0.2000" --arm raw.yaml --csv line.csv --out filled.yaml
cmp filled.yaml line.yaml || fail "an empty polynomial is not filled in place"

# Bad input: exit 2, one message, no file.
expect 2 "arm.yaml: exists already; --force replaces it" --arm two_segment --out arm.yaml
sed 's/,-/,/' line.csv >positive.csv
expect 2 "positive.csv: segment 0: the bench strain is positive" --arm two_segment \
  --csv positive.csv --out none.yaml
sed 's/40,/forty,/' line.csv >text.csv
expect 2 "text.csv:5:1: 'forty' found; expected a gauge pressure in kPa" --arm two_segment \
  --csv text.csv --out none.yaml
head -4 line.csv >short.csv
expect 2 "short.csv: segment 0: 3 bench points at 3 distinct pressures" --arm two_segment \
  --csv short.csv --out none.yaml
expect 2 "nowhere.csv" --arm two_segment --csv nowhere.csv --out none.yaml
sed 's/width_m: 0.0300/width_m: 3 cm/' arm.yaml >broken.yaml
expect 2 "segments[1].width_m: '3 cm' found; expected a length in metres" --arm broken.yaml \
  --out none.yaml
[ ! -e none.yaml ] || fail "a refused run wrote an arm"
expect 2 "no file can be made in /proc" --arm two_segment --csv line.csv --out /proc/nowhere/none.yaml

#!/bin/bash
# limber collect and limber inspect on what it wrote: the same file for any number of jobs, Ctrl-C
# and --resume, what is refused, and that nothing is left behind by a failure.
. "$(dirname -- "$(readlink -f -- "$0")")/expect.sh"

# All transitions of a two-segment arm, at most half a second each.
expect 0 "81 motions in 16 episodes" collect --arm two_segment --hold-s 0.5 --out all.h5
expect 0 "81 of 81 transitions covered (both ends reached), 81 commanded" inspect all.h5
expect 0 '"suspicions": []' inspect all.h5 --arm two_segment --json

# Random motions: any number of jobs gives the same bytes but for nothing.
random=(collect --arm two_segment --schedule random --count 6 --episodes 4 --seed 5 --hold-s 1
        --noise-m 0.001 --drop-rate 0.1 --latency-s 0.05)
expect 0 "24 motions in 4 episodes" "${random[@]}" --jobs 1 --out one.h5
expect 0 "24 motions in 4 episodes" "${random[@]}" --jobs 3 --out three.h5
cmp one.h5 three.h5 || fail "--jobs changed the recording"
expect 0 "not tracked" inspect one.h5
expect 0 "straight" collect --arm two_segment --schedule random --count 5 --approach straight \
  --hold-s 0.5 --hold-min-s 0 --out straight.h5 --json

# Ctrl-C leaves finished episodes; --resume goes on to the very same file.
long=(collect --arm two_segment --schedule random --count 100 --episodes 8 --hold-s 2 --jobs 2)
expect 0 "800 motions" "${long[@]}" --out whole.h5
"$LIMBER_PROGRAM" "${long[@]}" --out stopped.h5 >output.txt 2>&1 &
process=$!
for _ in $(seq 600); do
  [ -n "$(ls stopped.h5.parts/*.h5 2>/dev/null)" ] && break
  sleep 0.05
done
kill -INT $process
code=0
wait $process || code=$?
[ "$code" -eq 1 ] || fail "Ctrl-C exits with $code: $(cat output.txt)"
grep -q "stopped on request; [1-7] of 8 episodes are kept in stopped.h5.parts: .*--resume" \
  output.txt || fail "Ctrl-C does not say how to go on: $(cat output.txt)"
[ ! -e stopped.h5 ] || fail "a stopped collection wrote its file"
for part in stopped.h5.parts/*.h5; do expect 0 "1 episodes" inspect "$part"; done
expect 2 "left by a collection that did not finish; --resume goes on" "${long[@]}" --out stopped.h5
expect 2 "recorded with seed '1'; this run has '2'" "${long[@]}" --out stopped.h5 --resume --seed 2
expect 0 "800 motions" "${long[@]}" --out stopped.h5 --resume
cmp whole.h5 stopped.h5 || fail "--resume gives another recording"
[ ! -e stopped.h5.parts ] || fail "parts are left"
expect 0 "800 motions" "${long[@]}" --out stopped.h5 --resume

# Bad input: exit 2, one message, no file.
expect 2 "one.h5: exists already; --force replaces it" "${random[@]}" --out one.h5
expect 2 "'five_segment' has 5 segments, so 59049 ordered transitions, 49.2 h at 3 s each" \
  collect --arm five_segment --out none.h5
expect 2 "--count N is missing" collect --schedule random --out none.h5
expect 2 "--hold-s -1: expected seconds" collect --hold-s=-1 --out none.h5
expect 2 "--driver hose: expected virtual" collect --driver hose --out none.h5
expect 2 "--drop-rate: Value 2 not in range 0" collect --drop-rate 2 --out none.h5
expect 2 "--out is required" collect
expect 2 "--arm nowhere.yaml: no such file" collect --arm nowhere.yaml --out none.h5
head -c 5000 one.h5 >cut.h5
expect 2 "cut.h5: an HDF5 file that can't be opened: damaged or cut short" inspect cut.h5
expect 2 "has 2 segments; arm 'three_segment' has 3" inspect one.h5 --arm three_segment
echo "# notes" >notes.md
expect 2 "notes.md: not a limber file; expected a recording" inspect notes.md
printf 'schema: limber/arm/2\n' >later.yaml
expect 2 "later.yaml:1: schema: 'limber/arm/2' found" inspect later.yaml
[ ! -e none.h5 ] || fail "a refused run wrote a recording"
expect 2 "no file can be made in /proc" "${random[@]}" --out /proc/nowhere/none.h5

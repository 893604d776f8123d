#!/usr/bin/env bash
# libFuzzer on every target, one after another: what `ctest --preset soak -R fuzz_hours` runs.
#   fuzz/soak.sh [SECONDS [TARGET…]]       600 s of each by default: six hours
# What it finds lies in build/fuzz/found/TARGET, what it learns in build/fuzz/corpora/TARGET. It prints a
# row for each target, and ends with 1 where it found anything, with 77 where there is no clang.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
seconds=${1:-600}
shift || true
command -v clang++-14 >/dev/null || {
  echo "clang-14 is missing: apt-get install clang-14" >&2
  exit 77
}
cd -- "$root"
cmake --preset fuzz >&2
cmake --build --preset fuzz --target limber_fuzz limber_fuzz_replay >&2
replay=build/fuzz/bin/limber_fuzz_replay
[ "$#" -gt 0 ] || mapfile -t targets < <("$replay")
[ "$#" -eq 0 ] || targets=("$@")

code=0
printf '| target | executions | coverage | corpus | findings |\n|---|---|---|---|---|\n'
for target in "${targets[@]}"; do
  corpus=build/fuzz/corpora/$target
  found=build/fuzz/found/$target
  mkdir -p "$corpus" "$found"
  "$replay" "$target" --seeds "$corpus"
  folders=("$corpus")
  for own in "fuzz/corpus/$target" "fuzz/regressions/$target"; do
    [ ! -d "$own" ] || folders+=("$own")
  done
  # libhdf5 leaks where it refuses a file.
  ASAN_OPTIONS=detect_leaks=0 build/fuzz/bin/limber_fuzz "$target" -max_total_time="$seconds" -timeout=30 -max_len=8192 \
    -malloc_limit_mb=1000 -rss_limit_mb=3000 -dict=fuzz/words.dict -artifact_prefix="$found/" \
    "${folders[@]}" >"build/fuzz/$target.log" 2>&1 || code=1
  last=$(grep -E '^#[0-9]+' "build/fuzz/$target.log" | tail -n 1)
  printf '| %s | %s | %s | %s | %s |\n' "$target" "$(sed -E 's/^#([0-9]+).*/\1/' <<<"$last")" \
    "$(sed -E 's/.*cov: ([0-9]+).*/\1/' <<<"$last")" "$(sed -E 's/.*corp: ([^ ]+).*/\1/' <<<"$last")" \
    "$(find "$found" -type f | wc -l)"
done
exit "$code"

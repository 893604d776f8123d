# Sourced by the shell tests: works in a folder of its own, removed at the end, and gives `fail` and `expect`.
# `program` is what `expect` runs, an array: set it before for a verb; the plain program otherwise.
set -euo pipefail
[ -n "${program+x}" ] || program=("$LIMBER_PROGRAM")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"

fail() { echo "FAILED: $*"; exit 1; }

# expect <exit code> <text in the output> <arguments…>
expect() {
  local code=0 wanted=$1 text=$2
  shift 2
  "${program[@]}" "$@" >output.txt 2>&1 || code=$?
  [ "$code" -eq "$wanted" ] || fail "'$*' exits with $code, not $wanted: $(cat output.txt)"
  grep -qF -- "$text" output.txt || fail "'$*' does not say '$text': $(cat output.txt)"
}

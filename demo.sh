#!/usr/bin/env bash
# From a bare Debian 12 machine to a soft arm that reaches its goals: installs what is missing,
# builds limber, and runs `limber demo` with the arguments given here (./demo.sh --help).
# The report comes to out/report.html beside this script, or to the folder named by --out.
set -euo pipefail
root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=tools/packages.sh
. "$root/tools/packages.sh"

install_packages build
build release

out=(--out "$root/out")
for argument in "$@"; do
  case $argument in
    --out | --out=* | -h | --help) out=() ;;
  esac
done
exec "$root/build/release/bin/limber" demo ${out[@]+"${out[@]}"} "$@"

#!/usr/bin/env bash
# Installs what is missing, builds limber, and runs every test: C++, Python, examples, and the whole
# chain from end to end. Arguments go to ctest: ./test.sh -L unit, ./test.sh -R Chart. What takes hours
# is left out: ctest --preset soak.
set -euo pipefail
root=$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")
# shellcheck source=tools/packages.sh
. "$root/tools/packages.sh"

install_packages build test
# Unit tests run with assertions; the program that users run is the one that system tests run.
build release
build test -DLIMBER_SYSTEM_BUILD_DIR="$root/build/release"

# Page tests are skipped, by name, where npm's packages can't be had.
if command -v npm >/dev/null && [ -z "${LIMBER_SKIP_PACKAGES:-}" ]; then
  say "installing the packages of the studio's page"
  timeout 300 npm ci --prefix "$root/web" --no-audit --no-fund </dev/null >&2 || say "they can't be installed"
fi

say "testing"
cd -- "$root"
exec ctest --preset test --no-tests=error "$@"

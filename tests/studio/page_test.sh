#!/usr/bin/env bash
# page_test.sh logic|bundle|browser: tests of the studio's page. 77 says that something is missing.
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/../.." && pwd)
cd -- "$root/web"

missing() {
  printf 'skipped: %s\n' "$1"
  exit 77
}
command -v node >/dev/null || missing "node is missing"
[ -d node_modules/vite ] || missing "npm's packages are missing: npm ci in web/ installs them"

case $1 in
  logic) node node_modules/vitest/vitest.mjs run ;;
  bundle) # what is committed is what the sources make, to the byte
    out=$(mktemp -d)
    trap 'rm -rf -- "$out"' EXIT
    node node_modules/typescript/bin/tsc
    node node_modules/vite/bin/vite.js build --logLevel warn --outDir "$out" --emptyOutDir
    node node_modules/vite/bin/vite.js build --mode shapes --logLevel warn --outDir "$out"
    diff -r dist "$out"
    ;;
  browser)
    command -v chromium >/dev/null || missing "chromium is missing"
    timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage --dump-dom \
      'data:text/html,<p>it starts' 2>/dev/null </dev/null | grep -q "it starts" ||
      missing "chromium does not start here"
    node tests/browser.mjs
    node tests/browser_exports.mjs
    node tests/browser_arm.mjs
    node tests/browser_results.mjs
    node tests/browser_follow.mjs
    node tests/browser_report.mjs
    node tests/browser_shapes.mjs
    node tests/browser_axe.mjs
    ;;
  *) exit 2 ;;
esac

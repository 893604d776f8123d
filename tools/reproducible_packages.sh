#!/usr/bin/env bash
# Builds the Debian packages of HEAD twice, in two folders, without a compiler cache, in another time zone
# and language, with another number of jobs, and compares their bytes. Ends with 1 where a package differs,
# and keeps both then. The umask is Debian's: CPack takes the modes of folders from it.
# Usage: tools/reproducible_packages.sh [CMAKE_ARGUMENT…]
set -euo pipefail
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
folder=$(mktemp -d)
export CCACHE_DISABLE=1
umask 022
SOURCE_DATE_EPOCH=$(git -C "$root" log -1 --format=%ct)
export SOURCE_DATE_EPOCH

# make_packages FOLDER JOBS [CMAKE_ARGUMENT…]: DEB files in FOLDER/packages.
make_packages() {
  local where=$1 jobs=$2
  mkdir -p -- "$where/packages"
  git -C "$root" archive HEAD | tar -x -C "$where"
  (
    cd -- "$where"
    cmake --preset release "${@:3}"
    cmake --build --preset release --parallel "$jobs"
    cpack --config build/release/CPackConfig.cmake -B packages
  ) >"$where/log" 2>&1 || {
    tail -n 20 -- "$where/log"
    exit 3
  }
}

TZ=UTC LC_ALL=C make_packages "$folder/a" 1 "$@"
TZ=Asia/Tokyo LC_ALL=C.UTF-8 make_packages "$folder/another_name" 2 "$@"

different=0
for package in "$folder"/a/packages/*.deb; do
  name=$(basename -- "$package")
  sum=$(sha256sum <"$package")
  if cmp -- "$package" "$folder/another_name/packages/$name"; then
    echo "same: $name, $(stat --format=%s -- "$package") bytes, sha256 ${sum%% *}"
  else
    different=1
  fi
done
[ "$different" -eq 0 ] || {
  echo "kept: $folder"
  exit 1
}
rm -rf -- "$folder"

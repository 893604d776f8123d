# shellcheck shell=bash disable=SC2154
# Sourced by demo.sh and test.sh, which set `root` to the project's folder.

say() { printf '==> %s\n' "$*" >&2; }

fail() {
  printf 'error: %s\n' "$@" >&2
  exit 3
}

# packages_of SECTION…: the packages that packages.txt lists there for this machine, one a line.
packages_of() {
  local section architecture package condition
  architecture=$(dpkg --print-architecture 2>/dev/null || echo unknown)
  for section in "$@"; do
    sed -n "/^\[$section\]/,/^\[/p" "$root/packages.txt" | sed -e 's/#.*//' -e '/^\[/d' -e '/^ *$/d' |
      while read -r package condition; do
        case $condition in
          '' | "@$architecture") printf '%s\n' "$package" ;;
          '?'*) command -v "${condition#?}" >/dev/null || printf '%s\n' "$package" ;;
        esac
      done
  done
}

# missing_packages PACKAGE…: those that dpkg does not hold as installed.
missing_packages() {
  local package status
  for package in "$@"; do
    status=$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || printf '%s\n' "$package"
  done
}

# as_root COMMAND…: runs it as root, through sudo where we are somebody else.
as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif { : </dev/tty; } 2>/dev/null; then # sudo can ask for the password
    sudo "$@"
  else
    sudo --non-interactive "$@"
  fi
}

apt() {
  as_root env DEBIAN_FRONTEND=noninteractive NEEDRESTART_MODE=a LC_ALL=C \
    apt-get --quiet --yes --option DPkg::Lock::Timeout=300 \
    --option Dpkg::Options::=--force-confold "$@" </dev/null >&2
}

# need_space FOLDER MEGABYTES WHAT: stops with a clear message where the disk is too full.
need_space() {
  local free
  free=$(df -Pk -- "$1" | awk 'NR == 2 { print int($4 / 1024) }')
  [ "$free" -ge "$2" ] || fail "$1 has $free MB left; $3 needs about $2 MB"
}

# install_packages SECTION…: installs what is missing, and does nothing where nothing is.
install_packages() {
  local wanted missing
  wanted=$(packages_of "$@")
  if [ -n "${LIMBER_SKIP_PACKAGES:-}" ]; then
    return
  fi
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    fail "this machine has no apt, so its packages can't be checked or installed." \
      "limber is made for Debian 12 and needs what these packages hold:" \
      "$(printf '%s' "$wanted" | tr '\n' ' ')" \
      "Where all of it is there already, run again with LIMBER_SKIP_PACKAGES=1."
  fi
  # shellcheck disable=SC2086  # one word a package
  missing=$(missing_packages $wanted | tr '\n' ' ')
  if [ -z "$missing" ]; then
    return
  fi
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail "packages are missing, and only root can install them; there is no sudo. As root, run:" \
      "apt-get update && apt-get install --no-install-recommends $missing"
  fi
  need_space / 1000 "installing packages"
  say "installing $missing"
  apt update || say "apt-get update reported errors; trying with what it has"
  # shellcheck disable=SC2086
  apt install --no-install-recommends $missing || fail \
    "apt-get could not install: $missing" \
    "See its messages above: is the network up, does /etc/apt name a Debian 12 mirror, is the disk full?"
}

# build_jobs: one per core, fewer where memory is short (a compiler takes up to about 1.2 GB).
build_jobs() {
  local cores memory
  cores=$(nproc 2>/dev/null || echo 1)
  memory=$(awk '/^MemAvailable:/ { print int($2 / 1200000) }' /proc/meminfo 2>/dev/null || true)
  memory=${memory:-$cores}
  [ "$memory" -ge 1 ] || memory=1
  [ "$cores" -le "$memory" ] && echo "$cores" || echo "$memory"
}

# build PRESET [CMAKE_ARGUMENT…]: configures and builds; a build folder that was moved here, or left
# by other settings, is made again.
build() {
  local preset=$1
  shift
  need_space "$root" 800 "building"
  say "building (preset $preset, $(build_jobs) jobs)"
  (
    cd -- "$root" &&
      { cmake --preset "$preset" "$@" || cmake --preset "$preset" --fresh "$@"; } &&
      cmake --build "build/$preset" --parallel "$(build_jobs)"
  ) >&2 || fail "the build failed; the first error above says why"
}

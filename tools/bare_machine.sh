#!/usr/bin/env bash
# Makes a bare Debian 12 in a temporary folder, clones HEAD of this checkout into it, runs COMMAND there as
# root, and takes all of it down again: whatever COMMAND needs beyond Debian 12 itself shows. apt works
# inside as it does outside: the same sources, settings, keys and proxies.
#
# Everything is mounted in namespaces of its own: the mounts end with the last process of the machine, and
# whoever deletes the folder never sees them. When this script ends, for whatever reason, so does COMMAND.
set -Eeuo pipefail
trap 'exit 125' ERR # COMMAND's code is the only other one
umask 022
root=$(cd -- "$(dirname -- "$(readlink -f -- "${BASH_SOURCE[0]}")")/.." && pwd)
# shellcheck source=tools/packages.sh
. "$root/tools/packages.sh"
readonly kMegabytes=8000 # Debian with the tests' packages, and two builds
readonly kSeconds=900    # for 60 MB of Debian; wget would wait for hours where nobody answers

# The code that docker, env and chroot have for failures of their own: no command of limber's ends with it.
fail() {
  printf 'error: %s\n' "$@" >&2
  exit 125
}

# quietly COMMAND…: shows what it says only where it fails.
quietly() {
  "$@" >"$folder/log" 2>&1 </dev/null || {
    tail -n 20 "$folder/log" >&2
    return 1
  }
}

# What apt has for Debian 12 itself; others' sources may be among them.
mirrors() {
  apt-get update --print-uris | sed -n "s|^'\(https\?://.*\)/dists/bookworm/InRelease'.*|\1|p"
}

# install_debian: sets `machine` to the folder of a fresh Debian. Its signature tells which mirror is
# Debian's. debootstrap hears of a proxy by the environment only, apt by its settings too.
install_debian() {
  local mirror proxy=
  eval "$(apt-config shell proxy Acquire::http::Proxy)"
  [ "$proxy" != DIRECT ] || proxy=
  local -x http_proxy=${http_proxy:-$proxy} https_proxy=${https_proxy:-$proxy}
  for mirror in $(mirrors); do
    machine=$(mktemp -d -- "$folder/machine.XXXX")
    chmod 755 -- "$machine"
    say "making a bare Debian 12 in $machine"
    if quietly timeout $kSeconds debootstrap --variant=minbase bookworm "$machine" "$mirror"; then
      return
    fi
  done
  fail "debootstrap made no Debian 12 from what apt's sources name for bookworm: ${mirror:-nothing}"
}

# Hooks of apt call programs that a bare machine lacks; a machine for minutes needs no fsync.
settle_apt() {
  local certificates=/etc/ssl/certs/ca-certificates.crt
  rm -f -- "$machine/etc/apt/sources.list"
  cp -a -- /etc/apt/. "$machine/etc/apt/"
  cp -aL -- /usr/share/keyrings/. "$machine/usr/share/keyrings/"
  cp -L -- /etc/resolv.conf /etc/hosts "$machine/etc/"
  [ ! -e $certificates ] || install -D --mode=644 -- $certificates "$machine$certificates"
  echo force-unsafe-io >"$machine/etc/dpkg/dpkg.cfg.d/bare-machine"
  printf '#clear %s;\n' DPkg::Pre-Invoke DPkg::Post-Invoke DPkg::Pre-Install-Pkgs \
    APT::Update::Pre-Invoke APT::Update::Post-Invoke APT::Update::Post-Invoke-Success \
    >"$machine/etc/apt/apt.conf.d/zz-bare-machine"
}

# Also from a shallow checkout, a work tree, a detached HEAD, or files of another owner.
clone() {
  local changes
  # shellcheck disable=SC2046  # names of variables: this may run in a hook of git's
  unset $(git rev-parse --local-env-vars)
  printf '[safe]\n\tdirectory = *\n' >"$folder/gitconfig"
  export GIT_CONFIG_GLOBAL=$folder/gitconfig GIT_CONFIG_NOSYSTEM=1
  changes=$(git -C "$root" status --porcelain) || fail "$root is no checkout of git's"
  [ -z "$changes" ] || say "changes that are not committed stay outside"
  quietly git clone --no-local --depth 1 --template= -- "$root" "$machine/root/limber" ||
    fail "the checkout can't be cloned"
}

# The machine's folder becomes a mount itself: programs inside may change those of their root.
mount_devices() {
  mount --bind "$machine" "$machine" &&
    mount -t proc proc "$machine/proc" &&
    mount -t sysfs sys "$machine/sys" &&
    mount --bind /dev "$machine/dev" &&
    mount -t devpts -o newinstance,ptmxmode=0666,mode=0620,gid=5 devpts "$machine/dev/pts" &&
    mount -t tmpfs tmpfs "$machine/dev/shm"
}

# inside COMMAND…: process 1 of the machine, which collects every orphan and whose end ends them all.
inside() {
  local name passed=() code=0
  install_debian
  settle_apt
  clone
  mount_devices || fail "proc, sys and dev can't be mounted in the machine"
  for name in TERM CI {http,https,ftp,all,no}_proxy {HTTP,HTTPS,FTP,ALL,NO}_PROXY; do
    [ -z "${!name:-}" ] || passed+=("$name=${!name}")
  done
  run() {
    chroot "$machine" /usr/bin/env --ignore-environment HOME=/root "${passed[@]}" \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      sh -c 'cd /root/limber && exec "$@"' sh "$@"
  }
  quietly run apt-get --option APT::Update::Error-Mode=any update ||
    fail "apt can't read its sources in the machine"
  say "running $* on it"
  run "$@" || code=$?
  exit "$code"
}

# Ends what runs and deletes the folder; killed processes may still be writing into it for a moment.
# shellcheck disable=SC2317  # a trap calls it
take_down() {
  trap '' HUP INT TERM
  if [ -n "${process:-}" ]; then
    kill -KILL "$process" 2>/dev/null || true
    wait "$process" 2>/dev/null || true
  fi
  for _ in {1..100}; do
    ! rm -rf --one-file-system -- "$folder" 2>/dev/null || return 0
    sleep 0.1
  done
  say "$folder could not be deleted"
}

if [ -n "${LIMBER_BARE_FOLDER:-}" ] && [ $$ -eq 1 ]; then
  folder=$LIMBER_BARE_FOLDER
  inside "$@"
fi

case ${1:--h} in
  -*) fail "usage: tools/bare_machine.sh COMMAND [ARGUMENT…], as in tools/bare_machine.sh ./test.sh" ;;
esac
for program in debootstrap git apt-get unshare setpriv; do
  command -v "$program" >/dev/null || 
    fail "$program is missing; as root, run: apt-get install $(packages_of bare | paste -sd ' ')"
done
[ "$(id -u)" -eq 0 ] || fail "only root can make a machine: sudo tools/bare_machine.sh $*"
unshare --mount --pid --fork --mount-proc chroot / true 2>/dev/null ||
  fail "this machine does not permit mounts and chroot (a container has to be privileged)"

[ -e /dev/fd/0 ] || exec </dev/null
folder=$(mktemp -d)
trap take_down EXIT
trap 'exit 129' HUP
trap 'exit 130' INT
trap 'exit 143' TERM
need_space "$folder" $kMegabytes "a bare machine with both builds"
# In the background, as a shell hears signals only while it waits; with the defaults that this takes away.
LIMBER_BARE_FOLDER=$folder env --default-signal=INT,QUIT setpriv --pdeathsig KILL \
  unshare --mount --pid --fork --kill-child "${BASH_SOURCE[0]}" "$@" <&0 &
process=$!
code=0
wait "$process" || code=$?
process=
exit "$code"

#!/usr/bin/env bash
# toolchain/debian_root.sh RELEASE [STEP...]: tests this checkout's HEAD in a fresh root file system of a Debian
# release (bookworm, trixie), as on a newly installed machine. By default, runs all steps, in this order:
#
#   run       as root: the README's first command, which installs missing packages and builds
#   samples   as root: the checks of every sample, on the targets that they name
#   commands  as root: run and compare of every sample, and one minute of hunt
#   test      as root: Robosim's own tests, by `./robosim test`
#   pi        as root: the golden tests, cross-built for a Raspberry Pi with 64 and 32 bits, under qemu-user
#   user      as an ordinary user, with the packages installed: the commands of `run` and `test`
#
# Prints a table at the end: the versions, and the seconds and the last line of each step. Exits with status 1
# if a step fails. Requires root and mmdebstrap. Downloads only packages, from this machine's mirror. The root
# stays in build/roots/RELEASE, and its folder /var/log/robosim contains the log of each step.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/..
here=$(readlink -f "$here")
all=(run samples commands test pi user)
release=${1:-}
steps=("${@:2}")
((${#steps[@]})) || steps=("${all[@]}")
for step in "${steps[@]}"; do
  if [[ " ${all[*]} " != *" $step "* || ! $release =~ ^[a-z]+$ ]]; then
    printf 'usage: toolchain/debian_root.sh RELEASE [%s]...\n' "$(IFS='|'; echo "${all[*]}")" >&2
    exit 2
  fi
done
if ((EUID != 0)) || ! command -v mmdebstrap >/dev/null; then
  echo 'debian_root.sh: requires root and the package mmdebstrap' >&2
  exit 5
fi
root=$here/build/roots/$release
logs=$root/var/log/robosim

# Runs a command in the root. Mounts devices, /proc and /tmp only for this command. Changes the root of the
# mount namespace. A chroot would not suffice, because the kernel does not allow user namespaces in a chroot.
inside() {  # FOLDER COMMAND...
  unshare --mount --pid --fork --kill-child bash -euc '
    mount --bind "$0" "$0"
    cd "$0"
    mount --rbind /dev dev
    mount -t proc proc proc
    mount -t sysfs sysfs sys
    mount -t tmpfs tmpfs tmp
    [[ ! -e /etc/resolv.conf ]] || cat /etc/resolv.conf >etc/resolv.conf
    mkdir -p old
    pivot_root . old
    umount -l /old
    cd "$1"
    exec env -i HOME="$(dirname "$1")" PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
      LANG=C.UTF-8 TERM=dumb DPKG_FORCE=unsafe-io "${@:2}"' "$root" "$@" </dev/null
}

failed=0
table=
record() {  # NAME SECONDS STATUS LAST-LINE
  local verdict=ok
  (($3 == 0)) || verdict="FAILED ($3)" failed=1
  printf -v table '%s  %-14s %5d s  %-11s %s\n' "$table" "$1" "$2" "$verdict" "$4"
}

try() {  # NAME LINE-TO-SHOW FOLDER COMMAND...
  local status=0 begin=$SECONDS log=$logs/${1//[ ,]/-}.log
  echo "== $release: $1"
  inside "${@:3}" >"$log" 2>&1 || status=$?
  ((status == 0)) || tail -n 60 "$log"
  record "$1" $((SECONDS - begin)) "$status" "$(grep -E "$2" "$log" | tail -n 1)"
}

# Runs every sample, and compares it on host and AVR. Accepts every verdict: status 0, 1, or 4 if time is up.
# The host rejects samples that are only for a chip, so these run on the AVR.
each_sample='
  ran=0 compared=0 chip=0
  sample() {  # COMMAND... : succeeds if the status is a verdict, otherwise stores the output
    local output status=0
    output=$(./robosim "$@" 2>&1) || status=$?
    case $status in 0 | 1 | 4) return 0 ;; esac
    failed="robosim $*: status $status: $output"
    return 1
  }
  for folder in samples/*/; do
    if sample run "$folder"; then
      ran=$((ran + 1))
      sample compare "$folder" --target host,avr && compared=$((compared + 1)) || echo "$failed"
    elif sample run "$folder" --target avr; then
      chip=$((chip + 1))
    else
      echo "$failed"
    fi
  done
  echo "samples: $ran ran on the host, $compared of them on the AVR too; $chip ran on the AVR alone"
  ((ran == compared && ran + chip == $(ls -d samples/*/ | wc -l)))'

mirror() {
  apt-get indextargets --format '$(ORIGIN) $(REPO_URI)' 'Created-By: Packages' 'Component: main' 2>/dev/null |
    sed -n '/security/d; s/^Debian //p' | head -n 1
}

begin=$SECONDS
echo "== $release: a minimal root"
if mountpoint -q "$root"; then
  echo "debian_root.sh: $root is mounted: another run has not ended" >&2
  exit 5
fi
rm -rf "$root"
mkdir -p "$root"
from=$(mirror)
mmdebstrap --quiet --variant=minbase "$release" "$root" ${from:+"$from"}
mkdir -p "$logs"
git clone --quiet --no-hardlinks "$here" "$root/root/robosim"
record root $((SECONDS - begin)) 0 "$(git -C "$root/root/robosim" log -1 --format='%h %s')"

for step in "${steps[@]}"; do
  case $step in
    run) try run '^(reached|lost|stuck|robosim):' /root/robosim ./robosim run PidFollower --map oval ;;
    samples)
      try samples '^[0-9]+ of [0-9]+ sketches' /root/robosim bash -c './robosim test samples/*/'
      ;;
    commands)
      try 'run, compare' 'samples:' /root/robosim bash -c "$each_sample"
      try hunt 'runs, ' /root/robosim bash -c './robosim hunt PidFollower --minutes 1 || (($? == 1))'  # 1: bugs were found
      ;;
    test) try test '[0-9]+ passed' /root/robosim ./robosim test ;;
    pi)
      for preset in arm64/pi64-golden armhf/pi32-golden; do
        try "${preset#*/}" 'tests passed' /root/robosim bash -c "toolchain/packages.sh pi &&
          toolchain/pi_sysroot.sh ${preset%/*} &&
          CMAKE_BUILD_PARALLEL_LEVEL=$(nproc) cmake --workflow --preset ${preset#*/}"
      done
      ;;
    user)
      try packages '' /root/robosim toolchain/packages.sh host test avr stm32  # a user cannot install them
      inside / useradd --create-home robosim
      git clone --quiet --no-hardlinks "$here" "$root/home/robosim/robosim"
      inside / chown -R robosim: /home/robosim
      as=(setpriv --reuid robosim --regid robosim --init-groups)
      try 'user run' '^(reached|lost|stuck|robosim):' /home/robosim/robosim "${as[@]}" ./robosim run PidFollower --map oval
      try 'user test' '[0-9]+ passed' /home/robosim/robosim "${as[@]}" ./robosim test
      ;;
  esac
done

versions() {
  inside / bash -c '
    . /etc/os-release
    version() { "$@" --version 2>/dev/null | sed -nE "1s/.* ([0-9.]+[0-9])( .*)?$/\1/p"; }
    echo "$PRETTY_NAME: gcc $(gcc -dumpfullversion), as $(version as), avr-gcc $(avr-gcc -dumpversion), cmake $(version cmake)"'
}
printf '\n%s\n%s' "$(versions)" "$table"
exit "$failed"

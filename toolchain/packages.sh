#!/usr/bin/env bash
# toolchain/packages.sh GROUP...: installs the missing packages of these groups of packages.txt.
#
# With a terminal, prints the command and asks the user. As root without a terminal (CI, a container),
# installs at once. Otherwise prints the command and ends with status 5, which is also the status of a failed
# installation. If nothing is missing, prints nothing and needs no network. All output, also that of apt, goes
# to stderr.
set -euo pipefail

list=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/packages.txt

fail() {
  printf 'robosim: %s\n' "$@" >&2
  exit 5
}

packages_of() {  # GROUP...
  local line word group=
  while read -r line; do
    word=${line%%[ #]*}
    case $word in
      '') ;;
      '['*']') group=${word:1:-1} ;;
      *) [[ " $* " != *" $group "* ]] || printf '%s\n' "$word" ;;
    esac
  done <"$list"
}

missing_of() {  # PACKAGE...
  local package state installed=' '
  while read -r package state; do
    [[ $state != installed ]] || installed+="$package "
  done < <(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "$@" 2>/dev/null)
  for package; do
    [[ $installed == *" $package "* ]] || printf '%s\n' "$package"
  done
}

if ! command -v dpkg-query >/dev/null; then
  exit 0  # this is not a Debian system, so CMake and the build report what is missing
fi
mapfile -t wanted < <(packages_of "$@")
((${#wanted[@]})) || fail "no group '$*' in $list"
mapfile -t missing < <(missing_of "${wanted[@]}")
((${#missing[@]})) || exit 0

as_root=()
((EUID == 0)) || as_root=(sudo)
install=(apt-get install --no-install-recommends "${missing[@]}")
command="${as_root[*]:+${as_root[*]} }${install[*]}"
printf 'robosim: these packages are missing; this command installs them:\n\n  %s\n\n' "$command" >&2

if [[ -t 0 && -t 2 ]]; then
  ((EUID == 0)) || command -v sudo >/dev/null || fail 'there is no sudo here: run that command as root, then try again'
  read -r -p 'Install them now? [Y/n] ' answer || answer=no
  case $answer in
    '' | [Yy]*) ;;
    *) fail 'nothing was installed: run that command yourself, then try again' ;;
  esac
elif ((EUID != 0)); then
  fail 'cannot ask without a terminal: run that command yourself, then try again'
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive LC_ALL=C.UTF-8 'RES_OPTIONS=timeout:2 attempts:1' "$@" \
    -y -o Acquire::http::Timeout=8 -o Acquire::https::Timeout=8 -o DPkg::Lock::Timeout=60 </dev/null
}
no_packages() {
  fail "apt-get could not install these (is there a network?): ${missing[*]}"
}

# Ignores errors if at least one server answers, because the existing lists of the other servers may be new
# enough.
apt apt-get update -o Acquire::Retries=0 >"$log" 2>&1 || :
if ! grep -qE '^(Get|Hit):' "$log"; then
  tail -n 15 "$log" >&2
  no_packages
fi
# Finds packages that this release does not have, because apt reports only "unable to locate" for them.
available=" $(apt-cache policy "${missing[@]}" | sed -n '/^[^ ]/{s/:$//;h;d}; /Candidate: [^(]/{g;p}' | tr '\n' ' ')"
for package in "${missing[@]}"; do
  [[ $available == *" $package "* ]] || absent+=("$package")
done
if [[ -n ${absent-} ]]; then
  system=$(. /etc/os-release && echo "$PRETTY_NAME")
  fail "no package ${absent[0]} in $system: expected Debian 12 or 13, or Ubuntu 24.04 or later with universe \
(sudo add-apt-repository universe); elsewhere use a container of debian:13"
fi
if [[ -t 2 ]]; then
  apt "${install[@]}" -o Acquire::Retries=2 >&2 || no_packages
elif ! apt "${install[@]}" -o Acquire::Retries=2 >"$log" 2>&1; then
  tail -n 15 "$log" >&2
  no_packages
fi

#!/usr/bin/env bash
# toolchain/pi_sysroot.sh arm64|armhf [FOLDER]: unpacks that architecture's libraries that Robosim and its tests link (the
# [host], [test], [avr] and [stm32] groups of packages.txt, and what these depend on) into FOLDER,
# build/ARCHITECTURE-sysroot by default, for pi64.cmake and pi32.cmake.
# The system's own packages and lists stay as they are. About 60 MB are downloaded.
set -euo pipefail

architecture=${1:-}
if [[ $architecture != arm64 && $architecture != armhf ]]; then
  echo "usage: toolchain/pi_sysroot.sh arm64|armhf [FOLDER]" >&2
  exit 2
fi
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=${2:-$here/../build/$architecture-sysroot}
[[ ! $folder/complete -nt $here/packages.txt ]] || exit 0  # a package may have been added
rm -rf "$folder"
mkdir -p "$folder"/apt/{lists,archives}/partial
folder=$(readlink -f "$folder")
: >"$folder/apt/status"  # as if nothing were installed: everything that is needed comes along

apt=(apt-get -qq -o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o APT::Sandbox::User=root
  -o "Dir::State::status=$folder/apt/status" -o "Dir::State::lists=$folder/apt/lists"
  -o "Dir::Cache=$folder/apt" -o "Dir::Cache::archives=$folder/apt/archives"
  -o Acquire::Retries=1 -o Acquire::http::Timeout=8 -o Acquire::https::Timeout=8)
mapfile -t libraries < <(sed '/^\[ci\]/,/^\[avr\]/d' "$here/packages.txt" | sed -n 's/^\([a-z0-9+-]*-dev\)\b.*/\1/p')
"${apt[@]}" update || echo "pi_sysroot.sh: going on with the package lists that came" >&2
"${apt[@]}" -y --no-install-recommends --download-only install "${libraries[@]}" >/dev/null
for package in "$folder"/apt/archives/*.deb; do
  dpkg-deb --extract "$package" "$folder"
done
rm -r "$folder/apt"
# From Debian 13 on all is in /usr, and a package that is not unpacked here links /lib to it.
[[ -e $folder/lib ]] || ln -s usr/lib "$folder/lib"

# Links to an absolute path would leave the folder.
find "$folder" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfnr "$folder$(readlink "$link")" "$link"
done
touch "$folder/complete"

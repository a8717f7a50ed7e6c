#!/usr/bin/env bash
# toolchain/pi_sysroot.sh arm64|armhf [FOLDER]: downloads the libraries that Robosim and its tests link, about 60 MB,
# for this architecture. Unpacks them into FOLDER, where pi64.cmake and pi32.cmake find them. The libraries are those of
# the groups [host], [test], [avr] and [stm32] of packages.txt, with their dependencies. By default, FOLDER is
# build/ARCHITECTURE-sysroot. Does not change the system's own packages and lists.
set -euo pipefail

architecture=${1:-}
if [[ $architecture != arm64 && $architecture != armhf ]]; then
  echo "usage: toolchain/pi_sysroot.sh arm64|armhf [FOLDER]" >&2
  exit 2
fi
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=${2:-$here/../build/$architecture-sysroot}
[[ ! $folder/complete -nt $here/packages.txt ]] || exit 0  # the folder is up to date
rm -rf "$folder"
mkdir -p "$folder"/apt/{lists,archives}/partial
folder=$(readlink -f "$folder")
: >"$folder/apt/status"  # an empty system, so that all dependencies are downloaded

apt=(apt-get -qq -o "APT::Architecture=$architecture" -o "APT::Architectures=$architecture" -o APT::Sandbox::User=root
  -o "Dir::State::status=$folder/apt/status" -o "Dir::State::lists=$folder/apt/lists"
  -o "Dir::Cache=$folder/apt" -o "Dir::Cache::archives=$folder/apt/archives"
  -o Acquire::Retries=1 -o Acquire::http::Timeout=8 -o Acquire::https::Timeout=8)
mapfile -t libraries < <(sed '/^\[ci\]/,/^\[avr\]/d' "$here/packages.txt" | sed -n 's/^\([a-z0-9+-]*-dev\)\b.*/\1/p')
"${apt[@]}" update || echo "pi_sysroot.sh: continuing with the package lists that were downloaded" >&2
"${apt[@]}" -y --no-install-recommends --download-only install "${libraries[@]}" >/dev/null
for package in "$folder"/apt/archives/*.deb; do
  dpkg-deb --extract "$package" "$folder"
done
rm -r "$folder/apt"
# Since Debian 13, all libraries are in /usr. The package that links /lib to /usr/lib is not unpacked here.
[[ -e $folder/lib ]] || ln -s usr/lib "$folder/lib"

# Makes absolute links relative, because they would leave the folder.
find "$folder" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfnr "$folder$(readlink "$link")" "$link"
done
touch "$folder/complete"

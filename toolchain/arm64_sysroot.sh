#!/usr/bin/env bash
# toolchain/arm64_sysroot.sh [FOLDER]: unpacks the arm64 libraries that Robosim and its tests link (the groups host and
# test of packages.txt, and what these depend on) into FOLDER, build/arm64-sysroot by default, for aarch64.cmake.
# The system's own packages and lists stay as they are. About 40 MB are downloaded.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
folder=${1:-$here/../build/arm64-sysroot}
[[ ! -e $folder/complete ]] || exit 0
rm -rf "$folder"
mkdir -p "$folder"/apt/{lists,archives}/partial
folder=$(readlink -f "$folder")
: >"$folder/apt/status"  # as if nothing were installed: everything that is needed comes along

apt=(apt-get -qq -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o APT::Sandbox::User=root
  -o "Dir::State::status=$folder/apt/status" -o "Dir::State::lists=$folder/apt/lists"
  -o "Dir::Cache=$folder/apt" -o "Dir::Cache::archives=$folder/apt/archives"
  -o Acquire::Retries=1 -o Acquire::http::Timeout=8 -o Acquire::https::Timeout=8)
mapfile -t libraries < <(sed -n '/^\[host\]/,/^\[ci\]/s/^\([a-z0-9+-]*-dev\)\b.*/\1/p' "$here/packages.txt")
"${apt[@]}" update
"${apt[@]}" -y --no-install-recommends --download-only install "${libraries[@]}" >/dev/null
for package in "$folder"/apt/archives/*.deb; do
  dpkg-deb --extract "$package" "$folder"
done
rm -r "$folder/apt"

# What points to an absolute path would leave the folder.
find "$folder" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfnr "$folder$(readlink "$link")" "$link"
done
touch "$folder/complete"

#!/usr/bin/env bash
# tests/consumer/check.sh BUILD FOLDER: installs Robosim from the build folder BUILD below FOLDER. Then uses
# the installed Robosim as a user does: creates a project, runs its checks and its C++ test, and builds a
# project with every kind of test. Finally, requests a target whose package is missing.
set -euo pipefail

here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
build=$(readlink -f "$1")
rm -rf "$2"
mkdir -p "$2"
cd "$2"

cmake --install "$build" --prefix "$PWD/installed" >/dev/null
targets=host
for target in avr stm32; do
  [[ ! -x installed/libexec/robosim/robosim-$target ]] || targets+=";$target"
done

installed/bin/robosim new demo
(cd demo && ../installed/bin/robosim test)

# Builds this project and the created one together, so that the test harness is compiled once.
cmake -S "$here" -B build -G Ninja "-Drobosim_ROOT=$PWD/installed" "-DDEMO=$PWD/demo" "-DTARGETS=$targets"
cmake --build build
ctest --test-dir build --output-on-failure --no-tests=error

# With the sources instead of a package, CMake provides the same targets and functions. The sources are only
# configured here, not built.
cmake -S "$here" -B sources -G Ninja "-DROBOSIM_SOURCE=$here/../.." "-DDEMO=$PWD/demo" "-DTARGETS=$targets"

# A target without its package gives status 5 and the package's name.
rm -f installed/libexec/robosim/robosim-avr
status=0
installed/bin/robosim run ./demo --target avr 2>missing.txt || status=$?
cat missing.txt
[[ $status == 5 ]] && grep -q 'apt install robosim-avr' missing.txt

#!/usr/bin/env bash
# toolchain/chip_size.sh SIZE ELF NAME FLASH RAM: prints a program's use of flash and RAM, as Arduino does.
# SIZE is the tool, such as avr-size. Exits with status 1 if the program does not fit the chip.
set -euo pipefail

"$1" -A "$2" | awk -v name="$3" -v flash="$4" -v ram="$5" '
  $1 == ".text" || $1 == ".init_array" || $1 == ".ARM.exidx" || $1 == ".data" { code += $2 }
  $1 == ".data" || $1 == ".bss" || $1 == ".noinit" { data += $2 }
  END {
    printf "%s: Sketch uses %d bytes (%d%%) of program storage space. Maximum is %d bytes.\n", name, code,
           int(code * 100 / flash), flash
    printf "%s: Global variables use %d bytes (%d%%) of dynamic memory, leaving %d bytes for local variables. ", name,
           data, int(data * 100 / ram), ram - data
    printf "Maximum is %d bytes.\n", ram
    if (code > flash || data > ram) { print name ": does not fit the chip"; exit 1 }
  }'

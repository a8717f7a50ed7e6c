#!/usr/bin/env bash
# toolchain/join_inos.sh CTAGS OUT.cpp INO...: joins .ino files to a C++ source, as Arduino does. Adds
# Arduino.h at the top, and prototypes of all functions before the first function. Handles only plain
# functions without default arguments; `robosim build` handles all functions.
set -euo pipefail

ctags=$1 out=$2
shift 2
{
  echo '#include <Arduino.h>'
  for ino; do
    printf '#line 1 "%s"\n' "$ino"
    cat "$ino"
    echo
  done
} >"$out.joined"

# The fields of a ctags line are name, file and pattern, and then "key:value". A function with a scope is a
# member. A template does not need a prototype.
"$ctags" -u --language-force=c++ -f - --c++-kinds=f --fields=KSTtzns "$out.joined" | awk -F'\t' '
  { line = signature = type = scope = "" }
  {
    for (i = 4; i <= NF; ++i) {
      if ($i ~ /^line:/) line = substr($i, 6)
      if ($i ~ /^signature:/) signature = substr($i, 11)
      if ($i ~ /^returntype:/) type = substr($i, 12)
      if ($i ~ /^(class|struct|namespace|union):/) scope = $i
    }
    if (scope != "" || type == "") next
    if (!first || line < first) first = line
    if (type ~ /^template/ || signature ~ /=/) next
    prototypes = prototypes ($0 ~ /\/\^static /? "static " : "") type " " $1 signature ";\n"
  }
  END { printf "%d\n%s", first, prototypes }' >"$out.prototypes"

read -r first <"$out.prototypes"
awk -v first="$first" -v prototypes="$out.prototypes" '
  /^#line 1 / { file = $3; base = NR }
  NR == first {
    while ((getline text < prototypes) > 0) if (text !~ /^[0-9]+$/) print text
    printf "#line %d %s\n", NR - base, file
  }
  { print }' "$out.joined" >"$out.new"
rm "$out.joined" "$out.prototypes"
mv "$out.new" "$out"

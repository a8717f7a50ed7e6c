#!/usr/bin/env bash
# compare_all.sh ROBOSIM FOLDER [SEEDS [TIME]]: compares host, AVR and STM32 for every sketch of
# firmware/examples on every sample map. Runs each seed of SEEDS (default 1..20) for up to TIME (default 60s).
# Writes a line of JSON for each comparison to FOLDER/SKETCH-MAP. Fails if a difference is not due to chance.
# Takes hours. Skips comparisons that have results in FOLDER, so the script may be stopped and continued.
set -euo pipefail
(($# >= 2)) || { sed -n '2,4s/^# //p' "$0" >&2; exit 2; }
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/../..
robosim=$1
folder=$2
seeds=${3:-1..20}
time=${4:-60s}
mkdir -p "$folder"
status=0
for ((seed = ${seeds%%.*}; seed <= ${seeds##*.}; ++seed)); do
  for sketch in "$here"/firmware/examples/*/; do
    sketch=$(basename "$sketch")
    for map in "$here"/maps/*.map; do
      map=$(basename "$map" .map)
      file=$folder/$sketch-$map
      [[ ! -e $file.refused ]] || continue
      ! grep -qs "\"seed\":$seed," "$file" || continue
      end=0
      "$robosim" compare "$sketch" --map "$map" --seed "$seed" --for "$time" --json >"$file.new" 2>"$file.why" || end=$?
      if ((end <= 1)); then
        cat "$file.new" >>"$file"
      else
        mv "$file.why" "$file.refused"
        echo "$sketch on $map: $(tail -n 1 "$file.refused")"
      fi
      if ((end == 1)); then
        status=1
        echo "$sketch on $map, seed $seed: differ"
      fi
      rm -f "$file.new" "$file.why"
    done
  done
done
exit "$status"

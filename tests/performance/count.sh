#!/usr/bin/env bash
# count.sh performance|performance_table BUILD: counts the instructions of fixed pieces of work with
# valgrind's callgrind. Compares the counts with the table of docs/explanation/performance.md, or writes them
# into it. Fails if a count is more than 2 % above the table's count.
set -euo pipefail
here=$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")
page=$here/../../docs/explanation/performance.md
way=$1
build=$(readlink -f "$2")
# The length of paths changes the counts. So everything runs in this folder, whose name always has the same
# length.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tolerance=2  # per cent

# The table's counts are for code that g++ 12 compiled, and that partly uses AVX2. Counts of another
# compiler's code are not comparable.
if [[ $(uname -m) != x86_64 || $(g++ -dumpversion) != 12 ]] || ! grep -qw avx2 /proc/cpuinfo ||
  ! command -v valgrind >/dev/null; then
  echo 'not counted: the table requires g++ 12 on x86-64 with AVX2, and valgrind'
  exit 0
fi
# Clears the user's environment, whose size changes the stack. Turns off the sandbox, in which callgrind
# cannot write.
clean() { env -i PATH=/usr/bin:/bin HOME="$work" XDG_CACHE_HOME="$work/cache" TMPDIR="$work" ROBOSIM_SANDBOX=off "$@"; }

# Runs a command, and prints a line "PROGRAM INSTRUCTIONS" for each of its processes. The count of a forked
# process includes the instructions before the fork.
trace() {  # COMMAND...
  rm -f "$work"/out.*
  clean valgrind --tool=callgrind --trace-children=yes ${counted_from:+"--zero-before=$counted_from"} --callgrind-out-file="$work/out.%p" "$@" >"$work/stdout" 2>"$work/stderr" || {
    local status=$?
    ((status == 4)) || { tail -n 5 "$work/stderr" "$work/stdout" >&2; echo "$* ended with status $status" >&2; return 1; }
  }
  awk '/^cmd:/ { n = split($2, path, "/"); name = path[n] } /^(summary|totals):/ { print name, $2; nextfile }' "$work"/out.*
}
most() { awk -v name="$1" '$1 == name && $2 > most { most = $2 } END { printf "%.0f\n", most }'; }  # PROGRAM
each() {  # SHORT LONG NUMBER: the difference, divided by NUMBER
  awk -v short="$1" -v long="$2" -v number="$3" 'BEGIN { printf "%.0f\n", (long - short) / number }'
}

cmake --install "$build" --prefix "$work/installed" >/dev/null
cp -r "$here/../bench/sketches" "$work/sketches"
robosim() { echo "$work/installed/bin/robosim" "$@"; }
command_() { trace $(robosim "$@") | most robosim; }
run_for() {  # RUNNER TIME SKETCH OPTION...: counts the process that simulates
  trace $(robosim run "$3" --map oval --robot uno5 --goal none --for "$2" "${@:4}") | most "$1"
}
simulated() {  # RUNNER SKETCH OPTION...: counts per simulated millisecond, after the first 200 ms
  local sketch=$2 span=1000
  [[ $1 == robosim-host ]] || span=500
  [[ ! -d $work/sketches/$2 ]] || sketch=$work/sketches/$2
  clean $(robosim build "$sketch" --robot uno5 "${@:3}") >/dev/null 2>&1
  each "$(run_for "$1" 200ms "$sketch" "${@:3}")" "$(run_for "$1" $((200 + span))ms "$sketch" "${@:3}")" $span
}
recorded_for() {  # TIME: counts all processes
  trace $(robosim run PidFollower --map oval --robot uno5 --goal none --for "$1" --json \
    --record "$work/run.csv" --record "$work/run.vcd") | awk '{ sum += $2 } END { printf "%.0f\n", sum }'
}
work_of() {  # NAME FEW MANY
  each "$(trace "$build/tests/performance/robosim_workload" "$1" "$2" | most robosim_workload)" \
    "$(trace "$build/tests/performance/robosim_workload" "$1" "$3" | most robosim_workload)" $(($3 - $2))
}
# Counts all processes. A forked process inherits the runner's count. So counting restarts at
# SandboxProxy::enter().
swept() {  # SEEDS
  counted_from='robosim::runner::SandboxProxy::enter*' \
    trace $(robosim sweep PidFollower --map oval --robot uno5 --goal none --for 1ms --jobs 1 --seeds "1..$1") |
    awk '{ sum += $2 } END { printf "%.0f\n", sum }'
}

# Counts the instructions of all processes that run ROBOTS robots. Each robot follows a separate line on a map
# of 24,000 cells.
fleet_of() {  # ROBOTS
  { printf '+++\n+++\n'; for _ in {1..40}; do printf '%.0s_' {1..200}; echo; printf '%.0s.' {1..200}; echo; printf '%.0s_' {1..200}; echo; done; } >"$work/lines.map"
  { echo 'map = "lines.map"'; for ((i = 0; i < $1; ++i)); do printf '[[agent]]\nname = "R%d"\nsketch = "PidFollower"\nstart = "9,%d,E"\n' $i $((3 * i + 1)); done; } >"$work/fleet.toml"
  trace $(robosim run "$work/fleet.toml" --robot uno5 --goal none --for 1ms) |
    awk '$2 > most[$1] { most[$1] = $2 } END { for (name in most) sum += most[name]; printf "%.0f\n", sum }'
}

workload() {  # NAME, from the table's first column
  case $1 in
    '`robosim --help`') command_ --help ;;
    '`robosim map check city`') command_ map check city ;;
    '`robosim run`: the command') command_ run PidFollower --map oval --robot uno5 --goal none --for 1ms ;;
    '`robosim run`: the runner') run_for robosim-host 1ms PidFollower ;;
    'a run of a sweep') each "$(swept 2)" "$(swept 12)" 10 ;;
    'a further robot') each "$(fleet_of 8)" "$(fleet_of 40)" 32 ;;
    'host: PidFollower') simulated robosim-host PidFollower ;;
    'host: reads and drives') simulated robosim-host ReadsAndDrives ;;
    'host: polls `millis()`') simulated robosim-host PollsMillis ;;
    'host: polls a pin') simulated robosim-host PollsPin ;;
    'host: polls a flag') simulated robosim-host PollsFlag ;;
    'avr: PidFollower') simulated robosim-avr PidFollower --target avr ;;
    'avr: computes') simulated robosim-avr Computes --target avr ;;
    'avr: sleeps idle') simulated robosim-avr SleepsIdle --target avr ;;
    'recording: `.csv` and `.vcd`') each "$(recorded_for 200ms)" "$(recorded_for 2200ms)" 2000 ;;
    'a tick, sensors read in each') work_of ticks-1ms 200 1200 ;;
    'a tick, sensors read in each fifth') work_of ticks-5ms 200 2200 ;;
    'robots without firmware, one by one') work_of robots-5ms 200 700 ;;
    'robots without firmware, a batch') work_of batch-5ms 200 700 ;;
    'a move on cells') work_of moves 1000 101000 ;;
    'a move on cells, many at once') work_of many-moves 1000 101000 ;;
    'a scan on cells') work_of scans 1 3 ;;
    'a map'\''s row') work_of map-rows 1000 3000 ;;
    *) echo "docs/explanation/performance.md: there is no workload '$1'" >&2; return 1 ;;
  esac
}

clean $(robosim build PidFollower --robot uno5) >/dev/null 2>&1
worse=
exec 3<"$page"
written=
table=
while IFS= read -r line <&3; do
  if [[ $line == '<!-- table -->' ]]; then table=1; elif [[ $line == '<!-- end -->' ]]; then table=; fi
  if [[ -n $table && $line == '| '* && $line != '| what '* ]]; then
    IFS='|' read -r _ name of allowed first rest <<<"$line"
    name=${name# } name=${name% }
    allowed=${allowed//[ ,]/}
    counted=$(workload "$name") || exit 1
    change=$(awk -v new="$counted" -v old="$allowed" 'BEGIN { printf "%+.1f", 100 * (new / old - 1) }')
    printf '%-40s %12d %8s %%\n' "$name" "$counted" "$change"
    if awk -v change="$change" -v most="$tolerance" 'BEGIN { exit !(change > most) }'; then
      worse+="More than $tolerance % worse: $name took $allowed instructions and takes $counted."$'\n'
    fi
    line="| $name |$of| $(sed -E ':a; s/^([0-9]+)([0-9]{3})/\1,\2/; ta' <<<"$counted") |$first|"
  fi
  written+=$line$'\n'
done
if [[ $way == performance_table ]]; then
  printf '%s' "$written" >"$page"
  exit 0
fi
[[ -z $worse ]] || {
  echo "${worse}If this is intended: cmake --build build/ci --target performance_table rewrites docs/explanation/performance.md."
  exit 1
}

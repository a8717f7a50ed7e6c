#!/usr/bin/env bash
# toolchain/run_tests.sh PRESET [CTEST-ARGUMENTS]: runs the tests of a built preset. Prints a progress line,
# and each failed test with its output and the command to repeat it. Then prints the totals, and the reasons
# of skipped tests. Saves the complete output in build/PRESET/tests.log. With options about ctest's output,
# such as -V or -N, prints only ctest's own output. Exits with the status of ctest, or with 130 after Ctrl-C.
set -uo pipefail
cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." || exit

preset=$1
log=build/$preset/tests.log
ctest=(ctest --preset "$preset" -j "$(nproc)" "${@:2}")
again='./robosim test'
if [[ ${2-} == --browser ]]; then  # runs only the tests that every preset excludes
  ctest=(ctest --test-dir "build/$preset" -j "$(nproc)" --output-on-failure --no-tests=error -L '^browser$' "${@:3}")
  again='./robosim test --browser'
fi
[[ $preset == release ]] || again="ROBOSIM_PRESET=$preset $again"

for word in "${@:2}"; do
  case $word in
    -N | -Q | -V* | --extra-verbose | --help* | --print-labels | --quiet | --show-only* | --verbose | --version)
      exec "${ctest[@]}"
      ;;
  esac
done

# Reads ctest's lines "Start 5: NAME" and "3/8 Test #5: NAME ... Passed". Without a terminal, prints a line for each
# tenth of the tests.
show_progress() {
  local line name='' finished=0 of=0 failed=0 tenth=0 text
  while read -r line; do
    if [[ $line =~ ^([0-9]+)/([0-9]+)\ Test ]]; then
      finished=${BASH_REMATCH[1]} of=${BASH_REMATCH[2]}
      [[ $line != *'***'* || $line == *'***Skipped'* || $line == *'(Disabled)'* ]] || ((++failed))
    else
      name=${line#*: }
    fi
    ((of)) || continue
    text="  $finished of $of  ·  $failed failed"
    if [[ -t 1 ]]; then
      text="$text  ·  $name"
      printf '\r\e[K%s' "${text:0:${COLUMNS:-80}-1}"
    elif ((finished * 10 / of > tenth && finished < of)); then
      tenth=$((finished * 10 / of))
      echo "$text  ·  $SECONDS s"
    fi
  done
  [[ ! -t 1 ]] || printf '\r\e[K'
}

summary='
  # ctest prints the output of test N as "N: TEXT". Some lines are equal for every test.
  match($0, /^[0-9]+: /) {
    number = substr($0, 1, RLENGTH - 2)
    text = substr($0, RLENGTH + 1)
    if (after_skip[number]) reason[number] = text
    after_skip[number] = text ~ /: Skipped$/
    if (text !~ /^(Test command: |Working Directory: |Test timeout |Running main|Note: Google Test filter|\[[-=]+\])/)
      written[number] = written[number] text "\n"
  }
  # "3/8 Test #5: NAME ....***Failed  0.01 sec": the 3 is the expected count, unlike in the output of a failed test.
  /^ *[0-9]+\/[0-9]+ Test +#[0-9]+: .* sec *$/ && $1 + 0 == finished + 1 {
    number = $0; sub(/^[^#]*#/, "", number); sub(/:.*/, "", number)
    name = $0; sub(/^[^:]*: /, "", name); sub(/ ?\.\.\..*/, "", name)
    how = $0; sub(/.*\.\.\. */, "", how); gsub(/\*\*\*/, " ", how); gsub(/  +/, " ", how); sub(/^ /, "", how)
    finished++
    if (how ~ /^Passed/) {
      passed++
    } else if (how ~ /Skipped|\(Disabled\)/) {
      skipped++
      why = how ~ /Disabled/ ? "disabled" : reason[number] == "" ? "no reason given" : reason[number]
      if (!skips[why]++) whys[++reasons] = why
    } else {
      failed++
      print "FAILED  " name "  (" how ")\n" written[number] "repeat:  " again " -R \047^" name "$\047\n"
    }
    delete written[number]
  }
  END {
    if (!finished && !interrupted) exit 1
    if (interrupted) print "interrupted"
    print passed + 0 " passed, " failed + 0 " failed, " skipped + 0 " skipped, in " seconds " s"
    for (i = 1; i <= reasons; i++) print "  " skips[whys[i]] " skipped: " whys[i]
    if (failed > 1 && !interrupted) print "repeat all failed tests:  " again " --rerun-failed"
    print "complete output:  " log_file
    exit failed || interrupted ? 0 : status
  }'

shopt -s checkwinsize
(:) # sets COLUMNS
interrupted=0
trap 'interrupted=1' INT
SECONDS=0
setpriv --pdeathsig TERM "${ctest[@]}" -V 2>&1 | tee "$log" |
  grep --line-buffered -E '^ *(Start +[0-9]+: |[0-9]+/[0-9]+ Test )' | show_progress
status=${PIPESTATUS[0]}
trap - INT
((!interrupted)) || status=130
awk -v again="$again" -v interrupted="$interrupted" -v log_file="$log" -v seconds="$SECONDS" -v status="$status" \
  "$summary" "$log" || tail -n 40 "$log" >&2
exit "$status"

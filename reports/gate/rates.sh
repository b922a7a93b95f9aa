#!/usr/bin/env bash
# How often the gate is wrong: a build against itself, and against one that does every fiftieth sweep twice.
#   rates.sh --program SUPERSTEP [--repeating SUPERSTEP] [--same N] [--more N] [--load N] CASE...
# --repeating is the target superstep_repeating (cmake --build build/release --target superstep_repeating); --load starts so many processes that
# do nothing but keep a processor busy. Prints a table; exits with 1 where an unchanged build failed, or the other passed.
set -euo pipefail

program='' repeating='' same=20 more=10 load=0 cases=()
while (($# > 0)); do
  case $1 in
    --program) program=${2:?}; shift 2 ;;
    --repeating) repeating=${2:?}; shift 2 ;;
    --same) same=${2:?}; shift 2 ;;
    --more) more=${2:?}; shift 2 ;;
    --load) load=${2:?}; shift 2 ;;
    -*) echo "rates.sh: unknown option $1; its first lines say which there are" >&2; exit 2 ;;
    *) cases+=("$1"); shift ;;
  esac
done
if [[ -z $program || ${#cases[@]} -eq 0 ]]; then
  echo "rates.sh: give --program and at least one case" >&2
  exit 2
fi

folder=$(mktemp -d) hogs=()
finish() {
  if ((${#hogs[@]} > 0)); then kill "${hogs[@]}" 2>/dev/null || true; fi
  rm -rf "$folder"
}
trap finish EXIT
for ((k = 0; k < load; ++k)); do
  while :; do :; done &
  hogs+=($!)
done

measure() { # measure PROGRAM FOLDER
  "$1" bench "${cases[@]}" --repetitions "${SUPERSTEP_GATE_REPETITIONS:-7}" --instructions --quiet --out "$2" >/dev/null
}
judge() { # judge FOLDER NAME: the gate's findings as a line of JSON, whatever it says
  "$program" gate "$1" --baseline "$folder/base" --json >"$folder/verdict-$2.json" || (($? == 5 || $? == 6))
}

measure "$program" "$folder/base"
for ((k = 1; k <= same; ++k)); do
  measure "$program" "$folder/now"
  judge "$folder/now" "same-$k"
done
if [[ -n $repeating ]]; then
  for ((k = 1; k <= more; ++k)); do
    measure "$repeating" "$folder/now"
    judge "$folder/now" "more-$k"
  done
fi

python3 - "$folder" <<'PYTHON'
import glob, json, sys

def read(kind):
    return [json.load(open(name)) for name in sorted(glob.glob(f"{sys.argv[1]}/verdict-{kind}-*.json"))]

def count(reports, what):
    def failed(report):
        return any(f["verdict"] == "regressed" and (what in f["what"].lower() or what == "") for f in report["findings"])
    return sum(failed(report) for report in reports)

same, more = read("same"), read("more")
print("| build | comparisons | failed | by instructions | by time |\n|---|---|---|---|---|")
for name, reports in (("unchanged", same), ("every fiftieth sweep twice", more)):
    if reports:
        print(f"| {name} | {len(reports)} | {count(reports, '')} | {count(reports, 'instructions')} | {count(reports, 'cpu')} |")
sys.exit(count(same, "") > 0 or count(more, "instructions") < len(more))
PYTHON

#!/usr/bin/env bash
# The gate's script as continuous integration runs it: a build against itself, and against one that did less.
#   gate.sh PROGRAM SOURCE_FOLDER
set -euo pipefail
program=$1 source=$2
script=$source/reports/gate/ci/gate.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export SUPERSTEP_GATE_REPETITIONS=1
case_file=$folder/rod.toml
cat >"$case_file" <<'TOML'
t_end = 20
[network]
generator = "ladder"
size = 60
inlet = 1
[bench]
baseline = "forward-euler"
integrators = ["forward-euler", "rkc:rtol=1e-3"]
TOML

expect() { # expect CODE WHAT COMMAND...: its output is in $folder/said
  local code=$1 what=$2 status=0
  shift 2
  "$@" >"$folder/said" 2>&1 || status=$?
  if ((status != code)); then
    echo "$what: exit code $status instead of $code" >&2
    cat "$folder/said" >&2
    exit 1
  fi
}

expect 2 "nothing given" "$script"
expect 0 "a baseline" "$script" --program "$program" --baseline "$folder/base.json" --renew "$case_file"
if ! command -v valgrind >/dev/null; then
  echo "no Valgrind: counts are not tested"
  exit 77
fi
GITHUB_STEP_SUMMARY=$folder/summary.md expect 0 "the same build" \
  "$script" --program "$program" --baseline "$folder/base.json" "$case_file"
cmp "$folder/summary.md" "$folder/said"

# The recorded build needed 2 % fewer instructions.
python3 - "$folder/base.json" "$folder/less.json" "$folder/other.json" <<'PYTHON'
import json, sys
base = json.load(open(sys.argv[1]))
other = json.loads(json.dumps(base))
for row in base["cases"][0]["rows"]:
    row["instructions"] = int(row["instructions"] * 0.98)
json.dump(base, open(sys.argv[2], "w"))
other["machine"]["compiler"] = "another one"
json.dump(other, open(sys.argv[3], "w"))
PYTHON
expect 5 "a build that does more" "$script" --program "$program" --baseline "$folder/less.json" "$case_file"
grep -q 'instructions' "$folder/said"
expect 6 "another compiler" "$script" --program "$program" --baseline "$folder/other.json" "$case_file"
SUPERSTEP_GATE_STRICT=0 expect 0 "another compiler, not strict" \
  "$script" --program "$program" --baseline "$folder/other.json" "$case_file"

# How often the gate is wrong: here, whether its script still finds out.
expect 0 "rates" "$source/reports/gate/rates.sh" --program "$program" --same 1 --load 1 "$case_file"
grep -q '| unchanged | 1 | 0 |' "$folder/said"
expect 2 "rates of nothing" "$source/reports/gate/rates.sh" --program "$program"

#!/usr/bin/env bash
# Is this build as good as the recorded one? Measures cases, compares, and says so where people look.
#   gate.sh --program SUPERSTEP --baseline FILE [--renew] CASE...
# Instructions are counted where Valgrind is installed; a loaded machine does not change them. The verdict goes to
# stdout, and to $GITHUB_STEP_SUMMARY where that is set. Exit code: 0 as good, 5 regressed, 6 can not tell (which
# SUPERSTEP_GATE_STRICT=0 takes for good), others as of superstep. --renew writes the baseline instead of comparing.
set -euo pipefail

program=superstep baseline='' renew=0 cases=()
while (($# > 0)); do
  case $1 in
    --program) program=${2:?--program needs a value}; shift 2 ;;
    --baseline) baseline=${2:?--baseline needs a value}; shift 2 ;;
    --renew) renew=1; shift ;;
    -*) echo "gate.sh: unknown option $1; there are --program, --baseline and --renew" >&2; exit 2 ;;
    *) cases+=("$1"); shift ;;
  esac
done
if [[ -z $baseline || ${#cases[@]} -eq 0 ]]; then
  echo "gate.sh: give --baseline FILE and at least one case" >&2
  exit 2
fi

results=$(mktemp -d)
trap 'rm -rf "$results"' EXIT
counting=()
if command -v valgrind >/dev/null; then counting=(--instructions); fi
"$program" bench "${cases[@]}" --repetitions "${SUPERSTEP_GATE_REPETITIONS:-7}" --no-cache --quiet "${counting[@]}" \
  --out "$results" >"$results/table.txt"

if ((renew)); then
  mkdir -p "$(dirname "$baseline")"
  cp "$results/results.json" "$baseline"
  echo "baseline written: $baseline"
  exit 0
fi

status=0
"$program" gate "$results" --baseline "$baseline" >"$results/verdict.md" || status=$?
cat "$results/verdict.md"
if [[ -n ${GITHUB_STEP_SUMMARY:-} ]]; then cat "$results/verdict.md" >>"$GITHUB_STEP_SUMMARY"; fi
if ((status == 6)) && [[ ${SUPERSTEP_GATE_STRICT:-1} == 0 ]]; then status=0; fi
exit "$status"

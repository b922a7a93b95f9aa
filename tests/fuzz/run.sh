#!/usr/bin/env bash
# Fuzzes every reader for SECONDS each (default 300) in build/fuzz; needs clang. What they find stays in
# build/fuzz/found; make a plain test of it.
#   tests/fuzz/run.sh [--seed N] [SECONDS [READER...]]
# A seed makes a run the same again, up to how far it gets.
set -euo pipefail
source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seed=0  # another one each time
if [[ ${1:-} == --seed ]]; then seed=$2; shift 2; fi
seconds=${1:-300}
shift || true
readers=${*:-case network packing spec program results report checkpoint cache}
build=$source_folder/build/fuzz
cmake -S "$source_folder" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DCMAKE_UNITY_BUILD=ON -DSUPERSTEP_FUZZ=ON -DSUPERSTEP_TESTS=OFF -DSUPERSTEP_MICRO=OFF \
  >"$build.log" 2>&1 || { tail -20 "$build.log"; exit 1; }
targets=()
for reader in $readers; do
  targets+=("fuzz_$reader")
  case $reader in  # what makes its seeds
    case) targets+=(write_cases) ;;
    report | checkpoint | cache) targets+=(write_cases superstep) ;;
  esac
done
cmake --build "$build" --target "${targets[@]}"
"$source_folder/tests/fuzz/seeds.py" "$build/seeds" "$build/bin"
mkdir -p "$build/found"
failed=0
for reader in $readers; do
  mkdir -p "$build/corpus/$reader"
  log=$build/found/$reader.log
  ended=0
  "$build/bin/fuzz_$reader" -seed="$seed" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=20000 \
    -artifact_prefix="$build/found/$reader-" "$build/corpus/$reader" "$build/seeds/$reader" >"$log" 2>&1 || ended=$?
  echo "$reader: $(grep -E '^Done|ERROR|SUMMARY' "$log" | head -2 | tr '\n' ' ')"
  if ((ended)); then  # where it was, and what was read: the log stays behind on another machine
    failed=1
    grep -E '^ +#[0-9]+ .* in superstep::' "$log" | head -20 || true
    found=$(sed -n 's/.*Test unit written to //p' "$log" | head -1)
    if [[ -f $found ]]; then gzip -9 -c "$found" | base64; fi
  fi
done
exit $failed

#!/usr/bin/env bash
# Fuzzes every reader for SECONDS each (default 300) in build/fuzz; needs clang. What they find stays in
# build/fuzz/found; make a plain test of it.
#   tests/fuzz/run.sh [SECONDS [READER...]]
set -euo pipefail
source_folder=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
seconds=${1:-300}
shift || true
readers=${*:-case network packing spec program results report checkpoint cache}
build=$source_folder/build/fuzz
cmake -S "$source_folder" -B "$build" -G Ninja -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DCMAKE_BUILD_TYPE=RelWithDebInfo -DSUPERSTEP_FUZZ=ON -DSUPERSTEP_TESTS=OFF -DSUPERSTEP_MICRO=OFF >"$build.log" 2>&1 || { tail -20 "$build.log"; exit 1; }
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
  "$build/bin/fuzz_$reader" -max_total_time="$seconds" -timeout=20 -rss_limit_mb=4096 -max_len=20000 \
    -artifact_prefix="$build/found/$reader-" "$build/corpus/$reader" "$build/seeds/$reader" >"$log" 2>&1 || failed=1
  echo "$reader: $(grep -E '^Done|ERROR|SUMMARY' "$log" | head -2 | tr '\n' ' ')"
done
exit $failed

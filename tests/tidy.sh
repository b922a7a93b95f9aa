#!/usr/bin/env bash
# clang-tidy by the checked-in rules; a finding is an error.
#   tidy.sh [FILE...]   default: every source of the program
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
cd "$root"
files=("$@")
if ((${#files[@]} == 0)); then
  mapfile -t files < <(git ls-files 'lib/*.cpp' 'integrators/*.cpp' 'bench/*.cpp' 'reports/*.cpp')
fi
# Every source by itself, as clang compiles it.
cmake -S . -B build/tidy -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_EXPORT_COMPILE_COMMANDS=ON \
  -DSUPERSTEP_TESTS=OFF >/dev/null
printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -n 4 clang-tidy -p build/tidy --quiet --warnings-as-errors='*'

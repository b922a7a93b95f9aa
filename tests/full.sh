#!/usr/bin/env bash
# Everything that takes longer than continuous integration may: the suite under sanitizers, threads under theirs, the audit over hundreds of
# scenes, kills, failing calls, fuzzers, warnings as errors with every compiler that is installed, shellcheck where it is. Hours on two cores.
#   full.sh [SEEDS]   scenes of the audit (default 500)
set -euo pipefail
# shellcheck source=bench/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../bench/setup.sh"
seeds=${1:-500}

"$root/tests/run.sh"

cd "$root"
SUPERSTEP_SANITIZE=1 ./tests/run.sh

audit=build/release/bin/superstep_audit
for check in "" --reference --shift --spans --bounds "--bounds --class driven-linear"; do
  # shellcheck disable=SC2086
  "$audit" --seeds "1:$((seeds + 1))" --jobs "$(nproc)" --list-bad $check
done

tests/audit/packings/packings.py build/release/bin/superstep 1 "$((seeds + 1))" || [ $? -eq 77 ]

# Two hundred kills of each command, and every call of every command failing once.
tests/faults/kills.py build/release/bin/superstep 200
tests/faults/injections.py build/release/bin/superstep build/release/tests/superstep_inject.so 0
tests/parallel/killed.py build/release/bin/superstep build/release/tests/superstep_inject.so 100 || [ $? -eq 77 ]
if command -v clang++ >/dev/null; then tests/fuzz/run.sh 3600; fi

build_preset dev
if command -v clang++ >/dev/null; then
  cmake -S . -B build/clang -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DSUPERSTEP_WERROR=ON
  cmake --build build/clang --parallel "$(nproc)"
fi

# Threads: clang's OpenMP runtime tells the sanitizer by archer what waits for what; of g++'s the sanitizer sees nothing,
# and takes every barrier for a race. Races between threads of OpenMP, the ticking progress line and the watchdog are
# seen; those inside libraries that are not built here are not.
archer=/usr/lib/llvm-14/lib/libarcher.so
if command -v clang++ >/dev/null && [[ -e $archer ]]; then
  cmake -S . -B build/tsan -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DSUPERSTEP_SANITIZE=thread -DSUPERSTEP_MICRO=OFF -DSUPERSTEP_PYTHON=OFF
  cmake --build build/tsan --parallel "$(nproc)" --target superstep test_core test_rhs test_dynamics test_integrators
  export OMP_TOOL_LIBRARIES=$archer TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1"
  for one in core rhs dynamics; do OMP_NUM_THREADS=2 "build/tsan/bin/test_$one"; done
  OMP_NUM_THREADS=2 build/tsan/bin/test_integrators --gtest_filter='*ChainedMethod*'
  build/tsan/bin/superstep bench cases/lattice.toml --threads 2 --repetitions 1 --no-cache --time-limit 600 --out build/tsan/out
  unset OMP_TOOL_LIBRARIES TSAN_OPTIONS
fi
"$root/tests/toy/test.sh" "$root"

if command -v clang-tidy >/dev/null && command -v clang++ >/dev/null; then tests/tidy.sh; fi

if command -v shellcheck >/dev/null; then shellcheck -x bench/*.sh tests/*.sh tests/*/*.sh .ci/run; fi

#!/usr/bin/env bash
# Every test on a bare machine: sets it up, builds, runs, and asks the performance gate about the small cases.
# SUPERSTEP_SANITIZE=1 runs the tests under the address and undefined-behaviour sanitizers.
#
# Cold on two cores it may take 2400 s. What each stage may take of it; one that needs more moves work to full.sh:
#   packages 120, build 500, suite 650, gate and formats 60, where there is clang-tidy up to eight sources 100,
#   under sanitizers what is left of 2100 since the start, where there is clang fuzzers of the readers 250
set -euo pipefail
# shellcheck source=bench/setup.sh
source "$(dirname "${BASH_SOURCE[0]}")/../bench/setup.sh"

# Work and errors of the small cases must be those of the baseline; times block only when they are clearly
# worse: exit code 6, inconclusive, is no failure here.
gate() {
  local results status=0
  results=$(mktemp -d)
  # shellcheck disable=SC2064
  trap "rm -rf '$results'" RETURN
  build/release/bin/superstep bench cases/chain.toml cases/lattice.toml --repetitions 7 --no-cache --quiet \
    --out "$results" >"$results/table.txt"
  build/release/bin/superstep gate "$results" --baseline reports/baselines/small.json || status=$?
  if ((status == 6)); then status=0; fi
  return "$status"
}

# Sources as the checked-in configuration formats them, where the tool is.
check_format() {
  if ! command -v clang-format >/dev/null; then return; fi
  git -C "$root" ls-files '*.hpp' '*.cpp' | (cd "$root" && xargs clang-format --dry-run --Werror)
}

# Scripts, where the tool is.
check_scripts() {
  if ! command -v shellcheck >/dev/null; then return; fi
  (cd "$root" && git ls-files -z '*.sh' .ci/run | xargs -0 shellcheck -x)
}

# Some of what the last commit changed, by the checked-in rules, where the tool is; tests/full.sh looks at everything.
check_tidy() {
  local changed few=8
  if ! command -v clang-tidy >/dev/null || ! command -v clang++ >/dev/null; then return; fi
  mapfile -t changed < <(git -C "$root" diff --name-only --diff-filter=d HEAD~1 -- \
    'lib/*.cpp' 'integrators/*.cpp' 'bench/*.cpp' 'reports/*.cpp' 2>/dev/null | head -n "$few")
  if ((${#changed[@]} > 0)); then "$root/tests/tidy.sh" "${changed[@]}"; fi
}

# until_second SECOND COMMAND...: stops it, with 124, at that second of this script.
until_second() {
  local last=$1
  shift
  timeout "$((last > SECONDS ? last - SECONDS : 1))" "$@"
}

# run_sanitized ROOM: the program that tests it, in two shares side by side. Left out is what compares roundings of ROCK4,
# which are others where less is optimised.
run_sanitized() {
  local share status=0 ended
  for share in 0 1; do
    until_second 2100 env GTEST_TOTAL_SHARDS=2 GTEST_SHARD_INDEX=$share OMP_NUM_THREADS=1 \
      "build/asan/bin/test_$1" --gtest_brief=1 --gtest_filter='-StabilityLab.EveryMethodBehavesAsItsTheorySays' &
  done
  for share in 0 1; do
    ended=0
    wait -n || ended=$?
    if ((ended != 0 && (status == 0 || status == 124))); then status=$ended; fi
  done
  return "$status"
}

# Programs that test, under the address and undefined-behaviour sanitizers, the readers first: files come from
# strangers. As long as there is time: what a slow machine leaves out is said. Those of bench and integrators, and what
# they need, take as long again; tests/full.sh has them.
check_sanitized() {
  local groups=("core parallel packing contact network case results" "reports rhs" "dynamics lab")
  local group rooms room status
  cmake --preset asan -DSUPERSTEP_MICRO=OFF -DSUPERSTEP_PYTHON=OFF -DCMAKE_UNITY_BUILD=ON \
    -DCMAKE_CXX_FLAGS_RELWITHDEBINFO="-O1 -g1"
  for group in "${groups[@]}"; do
    read -ra rooms <<<"$group"
    status=0
    until_second 1900 cmake --build --preset asan --parallel "$(nproc)" --target "${rooms[@]/#/test_}" || status=$?
    for room in "${rooms[@]}"; do
      if ((status == 0)); then run_sanitized "$room" || status=$?; fi
    done
    if ((status == 124)); then
      echo "tests: no time was left under sanitizers for all of: $group, and what follows; tests/full.sh has it" >&2
      return 0
    fi
    if ((status != 0)); then return "$status"; fi
  done
}

# build_strictly PRESET: a warning of the compiler that this is written for is an error. Not by -Werror: another
# command line would compile anew what bench/run.sh has built.
build_strictly() {
  local log
  log=$(mktemp)
  # shellcheck disable=SC2064
  trap "rm -f '$log'" RETURN
  build_preset "$1" 2>&1 | tee "$log"
  if [[ $(g++ -dumpversion) == 12 ]] && grep -v '^ninja: ' "$log" | grep -q 'warning:'; then
    echo "tests: the build has warnings, see above" >&2
    return 1
  fi
}

preset=release
if [[ ${SUPERSTEP_SANITIZE:-0} == 1 ]]; then preset=asan; fi
install_missing_packages
install_optional_packages "the program runs on one machine alone" "${parallel_packages[@]}"
install_optional_packages "the Python module is left out" "${python_packages[@]}"
install_optional_packages "the format of sources is not checked" clang-format
check_format
install_optional_packages "scripts are not checked" shellcheck
check_scripts
install_optional_packages "results are not held against their JSON Schema" python3-jsonschema
install_optional_packages "tests of the report in a browser and of VTK files are skipped" chromium fonts-dejavu-core python3-vtk9
install_optional_packages "instructions are not counted" valgrind
install_optional_packages "bounds of errors are not held against sixty digits" libboost-dev
fetch_chart_library
fetch_node_modules tests/browser "tests of the report in a browser are skipped"
cd "$root"
build_strictly "$preset"
ctest --test-dir "build/$preset" --output-on-failure -j"$(nproc)"
if [[ $preset == release ]]; then
  gate
  check_tidy
  check_sanitized
  if command -v clang++ >/dev/null; then tests/fuzz/run.sh --seed 1 20 packing network; fi
fi

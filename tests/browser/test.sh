#!/usr/bin/env bash
# Makes reports of small cases, one with names that mean harm, and opens them in a browser.
#   test.sh PROGRAM SOURCE OUTPUT
# Exit code 77: there is no browser here, so nothing was tested.
set -euo pipefail
program=$1 source=$2 output=$3
browser=${CHROMIUM:-$(command -v chromium || true)}
skip() {
  echo "skipped: $1 (tests/run.sh installs it where it can)"
  exit 77
}
[[ -n $browser ]] || skip "there is no chromium"
command -v node >/dev/null || skip "there is no node"
[[ -d $source/tests/browser/node_modules/playwright-core ]] || skip "there is no playwright-core"
[[ -d $source/reports/web/node_modules/uplot ]] || skip "the report has no chart library"

rm -rf "$output"
mkdir -p "$output/cases/networks"
export SUPERSTEP_CACHE=$output/cache CHROMIUM=$browser

# A case with a title that would run if it were taken for markup, and a run that fails.
cp "$source"/cases/networks/chain_*.csv "$output/cases/networks/"
long=$(printf 'w%.0s' {1..200})
sed -e "s|^title = .*|title = '</script><script>window.hacked=1</script> \"quoted\" =cmd() ünïcode {{body}} $long'|" \
  -e 's|^source = .*|source = "Rojek \& Nisar 2026, section 9.1"|' \
  -e 's|^integrators = .*|integrators = ["sts:n=10,nu=1e-3", "sts:n=20,nu=1e-4", "forward-euler:step=2", "cvode:rtol=1e-6"]|' \
  "$source/cases/chain.toml" >"$output/cases/=cmd.toml"

cd "$output"
"$program" bench "cases/=cmd.toml" "$source/cases/lattice.toml" --repetitions 1 --out result --quiet >table.txt
"$program" bench "cases/=cmd.toml" --work-precision --out result --quiet >work_precision.txt
"$program" stability "cases/=cmd.toml" --quick --out result --quiet >stability.txt
"$program" run "$source/cases/lattice.toml" --out result/run --quiet
"$program" report result --quiet
node "$source/tests/browser/report_test.mjs" "$output/result/report.html" "$output"

#include "results/results_csv.hpp"

#include "results/schema/bench_fields.hpp"
#include "results/schema/record_csv.hpp"

namespace superstep {

std::string results_csv(std::span<const BenchCase> cases) {
  const auto columns = bench_columns(any_potential(cases));
  std::string out = csv_header(columns);
  for (const auto& one : cases)
    for (const auto& row : one.rows) out += csv_record(columns, row);
  return out;
}

}  // namespace superstep

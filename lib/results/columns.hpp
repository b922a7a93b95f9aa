#pragma once
/// The columns of results.csv: a contract. CSV, JSON and whatever comes later read them from here.

#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "results/results.hpp"

namespace superstep {

/// Content of one cell; monostate = empty.
using Cell = std::variant<std::monostate, std::string, std::uint64_t, double>;

struct Column {
  std::string name;
  std::function<Cell(const BenchRow&)> cell;
};

/// An error measure that exists once per field, under its name in results.csv and results.json.
struct ErrorMeasure {
  const char* name;
  Number FieldErrors::*value;
};
/// All of them in the order of the contract.
[[nodiscard]] std::span<const ErrorMeasure> error_measures() noexcept;

/// Columns in their order; `_potential` twins follow a group of error columns when any row has two fields.
[[nodiscard]] std::vector<Column> bench_columns(std::span<const BenchCase> cases);

}  // namespace superstep

#pragma once
/// Values of a case that may change in time: a number, a table, or a sampled profile in a file.

#include <cstdint>

#include "core/text/toml.hpp"
#include "network/graph.hpp"

namespace superstep {

/// A number, or a table of time that the graph keeps.
struct Amount {
  double value = 0;         ///< at t = 0
  std::int32_t table = -1;  ///< index into the graph's tables
};

/// Reads a number, `{ times, values }`, or `{ file, time, value }`, in which `time` and `value` name columns.
/// Beside a table may stand `scale`, which multiplies its values, and either `period`, after which it
/// repeats, or what holds `outside` its times: "clamp" (its end values), "zero", "error". Two equal
/// neighbouring times are a step.
///   t_end [s]  how far a repeated profile is written out
/// Throws InputError.
[[nodiscard]] Amount read_amount(const TomlValue& amount, double t_end, Graph& graph);

}  // namespace superstep

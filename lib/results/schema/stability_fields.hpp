#pragma once
/// The fields of stability.json; those of its tables are the columns of stability_*.csv.

#include "results/schema/record_field.hpp"
#include "results/study/stability_results.hpp"

namespace superstep {

/// A row of the table of frozen states: one method at one state.
struct FrozenRow {
  const FrozenState* state;
  const FrozenLimit* limit;
};

[[nodiscard]] std::vector<FrozenRow> frozen_rows(const StabilityResults& results);
/// Columns of the sweeps end with one for each method whose overshoot was looked at.
[[nodiscard]] RecordFields<SweepPoint> sweep_columns(const std::vector<SweepPoint>& sweeps);

template <>
const RecordFields<MethodStability>& fields_of<MethodStability>();
template <>
const RecordFields<StepEstimate>& fields_of<StepEstimate>();
template <>
const RecordFields<RoundingGrowth>& fields_of<RoundingGrowth>();
template <>
const RecordFields<SweepPoint>& fields_of<SweepPoint>();
template <>
const RecordFields<FrozenRow>& fields_of<FrozenRow>();
template <>
const RecordFields<Verdict>& fields_of<Verdict>();
template <>
const RecordFields<StabilityResults>& fields_of<StabilityResults>();

}  // namespace superstep

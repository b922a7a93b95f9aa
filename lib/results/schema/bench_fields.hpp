#pragma once
/// The fields of results.json; those of a row are the columns of results.csv: a contract.

#include "results/schema/record_field.hpp"

namespace superstep {

/// Columns of results.csv, in their order, which are the first keys of a row of results.json.
///   potential  with those of a second field, whose names end in `_potential`
[[nodiscard]] RecordFields<BenchRow> bench_columns(bool potential);
/// What a row or a run may have for a status.
[[nodiscard]] const std::vector<std::string>& statuses();
/// True when any row has two fields.
[[nodiscard]] bool any_potential(std::span<const BenchCase> cases);

template <>
const RecordFields<FieldErrors>& fields_of<FieldErrors>();
template <>
const RecordFields<SampledMeasure>& fields_of<SampledMeasure>();
template <>
const RecordFields<Timing>& fields_of<Timing>();
template <>
const RecordFields<ReferenceFacts>& fields_of<ReferenceFacts>();
template <>
const RecordFields<SkippedWork>& fields_of<SkippedWork>();
template <>
const RecordFields<BenchRow>& fields_of<BenchRow>();
template <>
const RecordFields<BenchCase>& fields_of<BenchCase>();
template <>
const RecordFields<BenchReport>& fields_of<BenchReport>();

}  // namespace superstep

#pragma once
/// The fields of run.json.

#include "results/schema/record_field.hpp"

namespace superstep {

template <>
const RecordFields<SteadyCurrent>& fields_of<SteadyCurrent>();
template <>
const RecordFields<MotionRecord>& fields_of<MotionRecord>();
template <>
const RecordFields<MotionRecord::Snapshot>& fields_of<MotionRecord::Snapshot>();
template <>
const RecordFields<MotionRecord::PhaseEnd>& fields_of<MotionRecord::PhaseEnd>();
template <>
const RecordFields<MotionRecord::Parts>& fields_of<MotionRecord::Parts>();
template <>
const RecordFields<RunRecord>& fields_of<RunRecord>();

}  // namespace superstep

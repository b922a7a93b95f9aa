#pragma once
/// The columns of press_table.csv: a contract.

#include "results/press/press_table.hpp"
#include "results/schema/record_field.hpp"

namespace superstep {

template <>
const RecordFields<PressTableRow>& fields_of<PressTableRow>();

}  // namespace superstep

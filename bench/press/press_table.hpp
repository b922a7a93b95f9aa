#pragma once
/// Springback over hold and densification: the trends of Zohdi (2014), figure 8, bed by bed.

#include <atomic>
#include <vector>

#include "bench/host/progress.hpp"
#include "case/press/press.hpp"
#include "results/press/press_table.hpp"

namespace superstep {

/// Every hold at every height for every seed of the case's [bench.press_table]. A bed is poured once for its
/// seed and pressed once for each height; each hold is cut out of the longest one. Ends early, with rows that
/// say so, when `stop` is set. Throws InputError where the case has no such table or no phase that holds, and
/// NumericalError where the pouring fails.
[[nodiscard]] std::vector<PressTableRow> press_table(const Press& one, const std::atomic<bool>* stop,
                                                     Progress& progress);

}  // namespace superstep

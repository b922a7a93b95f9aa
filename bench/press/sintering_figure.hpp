#pragma once
/// The run in one picture, as in figure 9 of Zohdi (2014).

#include <span>
#include <string>

#include "integrators/press/history.hpp"
#include "integrators/press/sintering_case.hpp"

namespace superstep {

/// SVG with two panels over time: volume fraction, and mean and highest temperature; phases are marked and
/// named. Needs at least one row.
[[nodiscard]] std::string history_svg(const dynamics::SinteringCase& one,
                                      std::span<const dynamics::HistoryRow> history);

}  // namespace superstep

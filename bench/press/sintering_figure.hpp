#pragma once
/// The run in one picture, as in figure 9 of Zohdi (2014).

#include <span>
#include <string>

#include "case/press/press.hpp"
#include "integrators/press/history.hpp"

namespace superstep {

/// SVG with two panels over time: volume fraction, and mean and highest temperature; phases are marked and
/// named. Needs at least one row.
[[nodiscard]] std::string history_svg(const Press& one, std::span<const dynamics::HistoryRow> history);

}  // namespace superstep

#pragma once
/// The report: one HTML file that needs nothing else.

#include <string>

#include "reports/html/report_input.hpp"

namespace superstep {

/// The whole page. Scripts only add to it: without them everything is there but zooming, sorting and
/// downloads.
[[nodiscard]] std::string report_html(const ReportInput& input);

}  // namespace superstep

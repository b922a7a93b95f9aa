#pragma once
/// report.html of a folder of results.

#include <string>

namespace superstep {

/// Reads the results in `folder` and writes `folder`/report.html; returns its path. Throws InputError and
/// OutputError.
std::string write_report(const std::string& folder);

/// After results were written: the report where it is wanted; else a word about one that is there and older.
void renew_report(const std::string& folder, bool wanted, bool quiet);

}  // namespace superstep

#pragma once
/// Where results go.

#include <string>

namespace superstep {

/// "reports/out/<name>" when the current folder has a folder reports/ (a checkout), else
/// "superstep-out/<name>".
[[nodiscard]] std::string default_output_folder(const std::string& name);

/// Creates the folder and makes sure that files can be made in it, before hours are spent on what goes there.
/// Throws OutputError.
void require_writable_folder(const std::string& folder);

/// Removes a result of an earlier run that this one does not replace: old numbers beside new ones mislead.
void remove_stale_file(const std::string& path) noexcept;

}  // namespace superstep

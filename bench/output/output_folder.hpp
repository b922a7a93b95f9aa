#pragma once
/// Where results go.

#include <string>
#include <utility>

namespace superstep {

/// "reports/out/<name>" when the current folder has a folder reports/ (a checkout), else
/// "superstep-out/<name>".
[[nodiscard]] std::string default_output_folder(const std::string& name);

/// Creates the folder and makes sure that files can be made in it, before hours are spent on what goes there.
/// Throws OutputError.
void require_writable_folder(const std::string& folder);

/// A folder that this process alone fills: results of two runs that overlap in one folder belong to neither.
class OutputFolder {
 public:
  /// Creates the folder, as above, and locks it until the object or the process ends. Throws OutputError,
  /// also while another process has it. Where the file system knows no locks there is none.
  explicit OutputFolder(const std::string& folder);
  ~OutputFolder();
  OutputFolder(OutputFolder&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}
  OutputFolder& operator=(OutputFolder&&) = delete;

 private:
  int descriptor_ = -1;
};

/// Removes a result of an earlier run that this one does not replace: old numbers beside new ones mislead.
void remove_stale_file(const std::string& path) noexcept;

}  // namespace superstep

#include "bench/output/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace superstep {

namespace fs = std::filesystem;

std::string default_output_folder(const std::string& name) {
  std::error_code error;
  return (fs::is_directory("reports", error) ? "reports/out/" : "superstep-out/") + name;
}

void require_writable_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) error.assign(errno, std::generic_category());
  if (error)
    throw OutputError(fmt::format("{}: results cannot be written there: {}; choose another folder with --out",
                                  folder, error.message()));
}

void remove_stale_file(const std::string& path) noexcept {
  std::error_code ignored;
  fs::remove(path, ignored);
}

}  // namespace superstep

#include "bench/output/snapshot_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "bench/output/output_folder.hpp"
#include "core/text/number.hpp"

namespace superstep {

namespace fs = std::filesystem;

namespace {

constexpr const char* snapshot_folder = "snapshots";

/// Its number, where the file is one that a run has named; the folder may hold what the user put there.
std::optional<std::size_t> number_of(const fs::path& file) {
  constexpr std::string_view head = "particles_";
  const std::string stem = file.stem().string();
  if (!stem.starts_with(head)) return std::nullopt;
  const auto number = parse_integer(std::string_view(stem).substr(head.size()));
  if (!number || *number < 0) return std::nullopt;
  const auto found = static_cast<std::size_t>(*number);
  if (fs::path(snapshot_name(found)).filename() != file.filename()) return std::nullopt;
  return found;
}

}  // namespace

std::string snapshot_name(std::size_t number) {
  return fmt::format("{}/particles_{:04}.csv", snapshot_folder, number);
}

void remove_snapshots(const std::string& folder, std::size_t first) noexcept {
  const fs::path place = fs::path(folder) / snapshot_folder;
  std::vector<fs::path> old;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(place, ignored))
    if (const auto number = number_of(entry.path()); number && *number >= first) old.push_back(entry.path());
  for (const auto& file : old) remove_stale_file(file.string());
  if (!old.empty()) fs::remove(place, ignored);  // unless the user has something there
}

}  // namespace superstep

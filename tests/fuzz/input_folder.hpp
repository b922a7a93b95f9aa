#pragma once
/// Several files in one input: what a case or a report reads lies in a folder.

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "input_file.hpp"

namespace superstep::fuzz {

/// A folder in memory with the files of an input. Each begins with a line "=== name"; what comes before the
/// first of these lines is the file `first`. One folder a process, emptied for each input.
class InputFolder {
 public:
  InputFolder(std::string_view bundle, const std::string& first) {
    static const Place place;
    path_ = place.path;
    for (const auto& old : std::filesystem::directory_iterator(path_)) std::filesystem::remove_all(old);
    std::string name = first;
    for (std::size_t files = 0; files < 16; ++files) {
      const auto end = bundle.find(divider);
      write(name, bundle.substr(0, end == bundle.npos ? end : end + 1));
      if (end == bundle.npos) break;
      bundle.remove_prefix(end + divider.size());
      const auto line = std::min(bundle.find('\n'), bundle.size());
      name = bundle.substr(0, line);
      bundle.remove_prefix(std::min(line + 1, bundle.size()));
    }
  }
  [[nodiscard]] const std::string& path() const noexcept { return path_; }

 private:
  static constexpr std::string_view divider = "\n=== ";

  /// Where memory is a folder, else where temporary files are.
  struct Place {
    Place() {
      namespace fs = std::filesystem;
      const fs::path memory = "/dev/shm";
      path = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
             ("superstep-fuzz-" + std::to_string(::getpid()));
      fs::create_directories(path);
    }
    ~Place() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
    std::string path;
  };

  /// Files inside the folder alone, under names that a person would give them.
  void write(const std::string& name, std::string_view text) const {
    const auto is_plain = [](unsigned char c) { return std::isalnum(c) || c == '.' || c == '_'; };
    if (name.empty() || name.size() > 40 || name[0] == '.' ||
        !std::all_of(name.begin(), name.end(), is_plain))
      return;
    std::ofstream(path_ + "/" + name, std::ios::binary) << text;
  }

  std::string path_;
};

}  // namespace superstep::fuzz

#include "case/inputs/named_file.hpp"

#include <filesystem>

namespace superstep {

std::string beside_case(const std::string& case_path, const std::string& file) {
  const std::filesystem::path path(file);
  return path.is_absolute() ? file : (std::filesystem::path(case_path).parent_path() / path).string();
}

std::string named_path(const TomlValue& file) {
  return beside_case(file.file(), file.string());
}

}  // namespace superstep

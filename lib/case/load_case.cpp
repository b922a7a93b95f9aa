#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "case/case.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "packing/read.hpp"

namespace superstep {

TomlTable parse_case(const std::string& path) {
  try {
    return TomlTable::parse_file(path);
  } catch (const InputError&) {
    if (!reads_as_packing(path)) throw;
    throw InputError(fmt::format(
        "{}: this is a packing; give the case that names it: a TOML file with [packing] file = {} (see "
        "cases/README.md)",
        path, superstep::quoted(std::filesystem::path(path).filename().string())));
  }
}

Case load_case(const std::string& path) {
  return load_case(parse_case(path));
}

Case load_case(TomlTable root) {
  if (root.find("dynamics")) return load_press(std::move(root));
  return load_scene(std::move(root));
}

const CaseHead& head_of(const Case& one) {
  return std::visit([](const CaseHead& head) -> const CaseHead& { return head; }, one);
}

}  // namespace superstep

#pragma once
/// Files that a key of a case names.

#include <string>

#include "core/error.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// `file` as named in the case at `case_path`: relative names start at the case's folder.
[[nodiscard]] std::string beside_case(const std::string& case_path, const std::string& file);
/// The file that a string of a case names.
[[nodiscard]] std::string named_path(const TomlValue& file);

/// What read(path) makes of the file that a string of a case names. A file that is missing, empty or none at
/// all is the key's fault: throws InputError "case.toml:3: key 'packing.file' names spheres.csv: no such
/// file; ...".
template <class Read>
auto read_named_file(const TomlValue& file, Read read) {
  const std::string path = named_path(file);
  try {
    return read(path);
  } catch (const FileError& error) {
    if (error.path() != path) throw;  // named by another key
    throw InputError(file.where() + " names " + error.what());
  }
}

}  // namespace superstep

#pragma once
/// JSON Schema (draft 2020-12, https://json-schema.org) of the JSON files that the program writes, made from
/// the lists of fields that also write and read them.

#include <string>
#include <vector>

namespace superstep {

struct JsonSchemaFile {
  std::string name;  ///< of the schema and, with ".schema.json" behind it, of its file
  std::string text;
};

[[nodiscard]] std::vector<JsonSchemaFile> json_schema_files();

}  // namespace superstep

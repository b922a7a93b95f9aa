/// The lists of fields against what users see of them: JSON Schema files and the page on files of results.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/text/text_file.hpp"
#include "results/schema/bench_fields.hpp"
#include "results/schema/json_schema.hpp"
#include "results/schema/run_fields.hpp"
#include "results/schema/stability_fields.hpp"

namespace superstep {
namespace {

const std::string reports_folder = std::string(SUPERSTEP_SOURCE_DIR) + "/reports";

TEST(JsonSchema, CommittedFilesAreWhatTheFieldsSay) {
  const bool renew = std::getenv("SUPERSTEP_RENEW_SCHEMAS") != nullptr;
  for (const auto& file : json_schema_files()) {
    const std::string path = reports_folder + "/schema/" + file.name + ".schema.json";
    if (renew) {
      std::filesystem::create_directories(reports_folder + "/schema");
      std::ofstream(path) << file.text;
    }
    EXPECT_EQ(read_text_file(path), file.text)
        << "renew it with SUPERSTEP_RENEW_SCHEMAS=1 build/release/bin/test_results";
  }
}

/// Names of all properties in a schema, objects within objects too.
void collect(const Json& schema, std::vector<std::string>& names) {
  if (const auto properties = schema.find("properties"); properties != schema.end())
    for (const auto& [name, property] : properties->items()) {
      names.push_back(name);
      collect(property, names);
    }
  if (const auto items = schema.find("items"); items != schema.end()) collect(*items, names);
}

TEST(JsonSchema, ThePageOnFilesOfResultsNamesEveryField) {
  const std::string page = read_text_file(reports_folder + "/schema.md");
  for (const auto& file : json_schema_files()) {
    std::vector<std::string> names;
    collect(Json::parse(file.text), names);
    ASSERT_GT(names.size(), 20u);
    for (const auto& name : names) {
      const std::string suffix = "_potential";
      const bool twin = name.size() > suffix.size() && name.ends_with(suffix);
      const std::string described = twin ? name.substr(0, name.size() - suffix.size()) : name;
      const auto at = page.find(described);
      EXPECT_NE(at, std::string::npos) << file.name << ": " << name;
    }
  }
}

/// Only what a person may want to know differs between one field and two.
TEST(BenchColumns, OfASecondFieldAreTheSameWithASuffix) {
  const auto one = bench_columns(false), two = bench_columns(true);
  std::size_t twins = 0;
  for (const auto& column : two) {
    const bool plain =
        std::any_of(one.begin(), one.end(), [&](const auto& c) { return c.name == column.name; });
    if (plain) continue;
    ++twins;
    ASSERT_TRUE(column.name.ends_with("_potential"));
    EXPECT_FALSE(column.always);
  }
  EXPECT_EQ(two.size(), one.size() + twins);
  EXPECT_EQ(twins, fields_of<FieldErrors>().size());
}

}  // namespace
}  // namespace superstep

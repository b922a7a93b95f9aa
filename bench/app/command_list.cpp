/// superstep list: what can be chosen by name.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "case/keys/case_keys.hpp"
#include "contact/neck.hpp"
#include "core/error.hpp"
#include "core/text/toml.hpp"
#include "integrators/registry.hpp"
#include "results/text/json_object.hpp"
#include "results/text/text_table.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

struct FoundCase {
  std::string file, title;
};

// Cases of the current folder; one that cannot be read is listed without a title, `info` says what is wrong
// with it.
std::vector<FoundCase> find_cases() {
  namespace fs = std::filesystem;
  std::vector<FoundCase> found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator("cases", error)) {
    if (entry.path().extension() != ".toml") continue;
    FoundCase one{.file = entry.path().string(), .title = {}};
    try {
      one.title = TomlTable::parse_file(one.file).string("title").value_or("");
    } catch (const InputError&) {
      one.title = "(unreadable)";
    }
    found.push_back(std::move(one));
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.file < b.file; });
  return found;
}

std::string integrator_text(const IntegratorEntry& entry, bool color) {
  std::string out = fmt::format("  {}  {}\n      {}\n", styled(entry.name, Style::bold, color), entry.summary,
                                entry.source);
  out += fmt::format("      several processes: {}{}\n", distributed_name(entry.distributed),
                     entry.gathered_where.empty() ? "" : "; gathered " + entry.gathered_where);
  for (const auto& key : entry.keys)
    out += fmt::format("      {:<9} {}{}\n                {}\n", key.name, key.range(),
                       key.fallback.empty() ? "" : "; default " + key.fallback, key.meaning);
  return out;
}

std::string list_text(const std::vector<FoundCase>& cases, bool color) {
  std::string out =
      styled("Integrators", Style::bold, color) + "  (SPEC = name or name:key=value,key=value)\n";
  for (const auto& entry : integrators()) out += integrator_text(entry, color);
  out += "\n" + styled("Neck laws", Style::bold, color) + "  ([contact] neck = \"...\")\n";
  for (const auto& law : neck_laws())
    out += fmt::format("  {:<18} {}  [{}]\n", law.name, law.formula, law.source);
  out += "\n" + styled("Cases", Style::bold, color) + "\n";
  for (const auto& one : cases) out += fmt::format("  {}  {}\n", one.file, one.title);
  if (cases.empty()) out += "  none: there is no folder cases/ here\n";
  return out;
}

Json key_json(const OptionKey& key) {
  return {{"name", key.name},
          {"range", key.range()},
          {"default", key.fallback},
          {"unit", key.unit},
          {"meaning", key.meaning}};
}

std::string list_json(const std::vector<FoundCase>& cases) {
  Json out = {{"schema", "superstep.list"},
              {"schema_version", 1},
              {"integrators", Json::array()},
              {"neck_laws", Json::array()},
              {"cases", Json::array()}};
  for (const auto& entry : integrators()) {
    Json keys = Json::array();
    for (const auto& key : entry.keys) keys.push_back(key_json(key));
    out["integrators"].push_back({{"name", entry.name},
                                  {"summary", entry.summary},
                                  {"source", entry.source},
                                  {"order", entry.order},
                                  {"adaptive", entry.adaptive},
                                  {"distributed", distributed_name(entry.distributed)},
                                  {"gathered_where", entry.gathered_where},
                                  {"keys", keys}});
  }
  for (const auto& law : neck_laws())
    out["neck_laws"].push_back({{"name", law.name},
                                {"formula", law.formula},
                                {"source", law.source},
                                {"parameters", law.parameters}});
  for (const auto& one : cases) out["cases"].push_back({{"file", one.file}, {"title", one.title}});
  return json_text(out);
}

std::string keys_text() {
  std::string out =
      "| key | cases | type | range | unit | default | meaning |\n|---|---|---|---|---|---|---|\n";
  for (const auto& key : case_keys())
    out +=
        fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", key.place, fmt::join(key.scene_names(), ", "),
                    key.type_text(), key.range_text(), key.unit, key.fallback, key.meaning);
  return out;
}

std::string keys_json() {
  const auto end = [](double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); };
  Json out = {{"schema", "superstep.keys"}, {"schema_version", 1}, {"keys", Json::array()}};
  for (const auto& key : case_keys())
    out["keys"].push_back({{"key", key.place},
                           {"cases", key.scene_names()},
                           {"type", key.type_text()},
                           {"min", end(key.min)},
                           {"min_open", key.min_open},
                           {"max", end(key.max)},
                           {"max_open", key.max_open},
                           {"words", key.words},
                           {"unit", key.unit},
                           {"default", key.fallback},
                           {"meaning", key.meaning}});
  return json_text(out);
}

Command list_from_line(const Arguments& values) {
  return ListCommand{common_options(values), values.keys};
}

}  // namespace

int execute(const ListCommand& command) {
  if (command.keys) {
    print_data(command.common.json ? keys_json() : keys_text());
    return 0;
  }
  const auto cases = find_cases();
  print_data(command.common.json ? list_json(cases) : list_text(cases, use_color(command.common.color)));
  return 0;
}

int execute(const ShowText& command) {
  print_data(command.text);
  return 0;
}

CommandEntry list_command() {
  return {.name = "list",
          .does = "integrators with their keys, neck laws and cases; the keys of case files",
          .examples = "  superstep list\n  superstep list --json\n  superstep list --keys --json",
          .positional = "",
          .positional_meaning = "",
          .options = {{"--keys", &Arguments::keys,
                       "the keys of case files instead: a table in Markdown, or --json", ""}},
          .make = list_from_line};
}

}  // namespace superstep

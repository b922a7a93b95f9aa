#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "case/case.hpp"
#include "case/corpus/corpus_tags.hpp"
#include "case/inputs/workable_times.hpp"
#include "core/error.hpp"
#include "core/text/options.hpp"
#include "core/text/text_file.hpp"
#include "network/files/recognise_network.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

void read_times(TomlTable& root, CaseHead& head) {
  head.t_end = root.positive("t_end", "s");
  if (const auto rule = unworkable_time("the end", head.t_end); !rule.empty())
    root.require("t_end", "s").reject(rule);
  head.output_times = {head.t_end};
  const auto times = root.find("output_times");
  if (!times) return;
  head.output_times = times->numbers();
  head.own_output_times = true;
  double previous = 0;
  for (const double t : head.output_times) {
    if (!(t > previous)) times->reject("the times must be > 0 and ascending [s]");
    if (const auto rule = unworkable_time("the output time", t); !rule.empty()) times->reject(rule);
    previous = t;
  }
  if (head.output_times.empty() || head.output_times.back() > head.t_end)
    times->reject(fmt::format("there must be at least one time, and none after t_end = {}", head.t_end));
  if (head.output_times.back() < head.t_end) head.output_times.push_back(head.t_end);
}

void read_bench(TomlTable& root, CaseHead& head) {
  auto bench = root.table("bench");
  if (!bench) return;
  if (const auto integrators = bench->find("integrators")) {
    head.bench.integrators = integrators->strings();
    if (const auto twice = repeated_spec(head.bench.integrators); !twice.empty())
      integrators->reject(
          fmt::format("{} stands twice; leave one of the two out", superstep::in_quotes(twice)));
    for (const auto& spec : head.bench.integrators) head.stated_specs.push_back({spec, integrators->where()});
  }
  if (const auto baseline = bench->find("baseline")) {
    head.bench.baseline = baseline->string();
    head.stated_specs.push_back({head.bench.baseline, baseline->where()});
  }
}

/// The key of [network] that such a file stands under; empty for other files.
std::string key_of_network(const std::string& path) {
  try {
    const auto network = recognise_network(path);
    return network ? network->key : "";
  } catch (const InputError&) {
    return {};
  }
}

}  // namespace

void read_head(TomlTable& root, CaseHead& head) {
  head.file = root.file();
  head.name = std::filesystem::path(head.file).stem().string();
  head.title = root.string("title").value_or(head.name);
  head.source = root.string("source").value_or("");
  read_times(root, head);
  read_bench(root, head);
  (void)read_corpus_tags(root);
}

TomlTable parse_case(const std::string& path) {
  try {
    return TomlTable::parse_file(path);
  } catch (const InputError&) {
    const std::string name = superstep::in_quotes(std::filesystem::path(path).filename().string());
    const auto complain = [&](const char* what, const std::string& key) {
      throw InputError(fmt::format(
          "{}: this is a {}; give the case that names it: a TOML file with {} = {} (see cases/README.md)",
          path, what, key, name));
    };
    if (reads_as_packing(path)) complain("packing", "[packing] file");
    if (const auto key = key_of_network(path); !key.empty()) complain("network", "[network] " + key);
    throw;
  }
}

Case load_case(const std::string& path) {
  return load_case(parse_case(path));
}

Case load_case(TomlTable root, const dynamics::Placed& placed) {
  if (root.find("dynamics")) return load_press(std::move(root), std::nullopt, placed);
  return load_scene(std::move(root));
}

const CaseHead& head_of(const Case& one) {
  return std::visit([](const CaseHead& head) -> const CaseHead& { return head; }, one);
}

}  // namespace superstep

#include "case/read_packing_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>
#include <unordered_map>

#include "contact/search.hpp"
#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/suggest.hpp"
#include "packing/generate.hpp"
#include "packing/pack_checks.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

/// Numbers > 0, at least one.
std::vector<double> positive_numbers(const TomlValue& value) {
  auto numbers = value.numbers();
  if (numbers.empty()) value.reject("it must hold at least one number");
  for (const double number : numbers)
    if (!(number > 0)) value.reject(fmt::format("it holds {}, and every number must be > 0", number));
  return numbers;
}

}  // namespace

SizeDistribution read_sizes(TomlTable table, double unit) {
  SizeDistribution sizes;
  const auto kind = table.require("distribution", "it must be lognormal, uniform or list");
  const std::string name = kind.string();
  if (name == "lognormal" || name == "uniform") {
    sizes.kind = name == "uniform" ? SizeDistribution::Kind::uniform : SizeDistribution::Kind::lognormal;
    sizes.min = unit * table.positive("min", "length");
    sizes.max = unit * table.positive("max", "length");
    if (name == "lognormal") {
      sizes.sigma = table.positive("sigma", "-");
      if (table.find("median")) sizes.median = unit * table.positive("median", "length");
    }
  } else if (name == "list") {
    sizes.kind = SizeDistribution::Kind::list;
    sizes.diameters = positive_numbers(table.require("diameters", "it lists the diameters"));
    for (auto& diameter : sizes.diameters) diameter *= unit;
    if (const auto weights = table.find("weights")) sizes.weights = positive_numbers(*weights);
  } else {
    kind.reject("it must be lognormal, uniform or list");
  }
  table.finish();
  return sizes;
}

namespace {

std::int64_t non_negative(TomlTable& table, const std::string& key, std::int64_t fallback) {
  const auto value = table.find(key);
  if (value && value->integer() < 0) value->reject("it must be >= 0");
  return value ? value->integer() : fallback;
}

Packing generate(TomlTable& table, const TomlValue& generator, double unit) {
  PackSettings settings;
  const std::string shape = generator.string();
  if (shape == "cylinder") {
    settings.container.shape = Container::Shape::cylinder;
    settings.container.diameter = unit * table.positive("diameter", "length");
  } else if (shape == "box") {
    settings.container.shape = Container::Shape::box;
    settings.container.width = unit * table.positive("width", "length");
    settings.container.depth = unit * table.positive("depth", "length");
  } else {
    generator.reject("the generator must be \"cylinder\" or \"box\"");
  }
  settings.container.height = unit * table.positive("height", "length");
  settings.relative_density = table.positive("relative_density", "-");
  constexpr double densest = 0.9;
  if (settings.relative_density > densest)
    table.find("relative_density")->reject(fmt::format("it must be at most {}", densest));
  settings.count = static_cast<std::size_t>(non_negative(table, "count", 0));
  if (settings.count > largest_packing)
    table.find("count")->reject(fmt::format("it must be at most {}", largest_packing));
  settings.seed = static_cast<std::uint64_t>(non_negative(table, "seed", 1));
  settings.sizes = read_sizes(table.require("sizes", "it is a table with a distribution").table(), unit);
  try {
    return generate_packing(settings);
  } catch (const UsageError& error) {
    throw InputError(fmt::format("{}: {}", generator.where(), error.what()));
  }
}

CaseContainer read_container(TomlTable table, double unit) {
  CaseContainer container;
  if (table.find("diameter")) {
    const double diameter = unit * table.positive("diameter", "length");
    container.cross_section = std::numbers::pi / 4 * diameter * diameter;
  } else {
    container.cross_section =
        unit * table.positive("width", "length") * unit * table.positive("depth", "length");
  }
  container.height = unit * table.positive("height", "length");
  table.finish();
  return container;
}

/// Neck radii of `i,j,radius` rows (ids of the packing, metres x unit) for contacts that the search found, or
/// on top.
void read_given_necks(const std::string& path, double unit, const Packing& packing, Contacts& contacts) {
  enum : std::size_t { i, j, radius };
  std::unordered_map<std::int64_t, std::int32_t> position;
  for (std::size_t k = 0; k < packing.size(); ++k)
    position.emplace(packing.id[k], static_cast<std::int32_t>(k));
  struct Neck {
    std::int32_t i, j;
    double radius;
    std::size_t line;
  };
  std::vector<Neck> necks;
  CsvReader rows(path, {"i", "j", "radius"});
  while (rows.next()) {
    const auto a = position.find(rows.integer(i)), b = position.find(rows.integer(j));
    if (a == position.end() || b == position.end())
      throw InputError(
          fmt::format("{}: contact {}-{} names an unknown id; both must be particles of the packing",
                      rows.where(), rows.integer(i), rows.integer(j)));
    if (a->second == b->second || !(rows.number(radius) > 0))
      throw InputError(
          fmt::format("{}: contact {}-{} with neck radius {}; it must join two particles and be > 0",
                      rows.where(), rows.integer(i), rows.integer(j), rows.number(radius)));
    necks.push_back({std::min(a->second, b->second), std::max(a->second, b->second),
                     unit * rows.number(radius), rows.line()});
  }
  std::sort(necks.begin(), necks.end(), [](const Neck& a, const Neck& b) {
    return std::tie(a.i, a.j, a.line) < std::tie(b.i, b.j, b.line);
  });
  contacts = {};
  for (std::size_t k = 0; k < necks.size(); ++k) {
    const auto& neck = necks[k];
    if (k > 0 && necks[k - 1].i == neck.i && necks[k - 1].j == neck.j)
      throw InputError(fmt::format("{}:{}: this contact stands already in line {}; keep one", path, neck.line,
                                   necks[k - 1].line));
    const auto a = static_cast<std::size_t>(neck.i), b = static_cast<std::size_t>(neck.j);
    contacts.i.push_back(neck.i);
    contacts.j.push_back(neck.j);
    contacts.overlap.push_back(packing.radius[a] + packing.radius[b] -
                               norm(packing.centre[a] - packing.centre[b]));
    contacts.neck_radius.push_back(neck.radius);
  }
}

/// `place` [text]: where the particles come from, for errors about them.
void read_contacts(TomlTable& table, const std::string& case_path, const std::string& place, double unit,
                   PackingScene& scene) {
  const auto neck = table.require("neck", "it names the neck law, e.g. \"volume-preserving\"");
  scene.neck = neck.string();
  if (scene.neck == "given") {
    const auto file = table.require("file", "with neck = \"given\" it names a CSV with i,j,radius");
    read_given_necks(beside_case(case_path, file.string()), unit, scene.packing, scene.contacts);
    return;
  }
  const NeckLaw* law = find_neck_law(scene.neck);
  if (!law) {
    std::vector<std::string> names = {"given"};
    for (const auto& known : neck_laws()) names.push_back(known.name);
    neck.reject("it must name a neck law" + suggestion(scene.neck, names));
  }
  NeckParameters parameters;
  if (const auto hardening = table.find("hardening")) {
    parameters.hardening = hardening->number();
    if (!(parameters.hardening >= 0.5 && parameters.hardening <= 1.45))
      hardening->reject("it must lie between 0.5 (linear hardening) and 1.45 (perfectly plastic)");
  }
  try {
    scene.contacts = find_contacts(scene.packing);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", place, error.what()));
  }
  scene.neck_report = apply_neck_law(scene.packing, *law, parameters, scene.contacts);
}

}  // namespace

/// A packing file that states its unit decides; a case that says otherwise contradicts it.
void adopt_stated_unit(const std::string& file, const std::optional<TomlValue>& of_case, double& unit) {
  const std::string stated = stated_length_unit(file);
  if (stated.empty()) return;
  const double own = length_unit(stated, file);
  if (of_case && own != unit)
    of_case->reject(fmt::format("{} states that its lengths are in {}; give that unit, or leave this key out",
                                file, stated));
  unit = own;
}

std::string beside_case(const std::string& case_path, const std::string& file) {
  const std::filesystem::path path(file);
  return path.is_absolute() ? file : (std::filesystem::path(case_path).parent_path() / path).string();
}

PackingInput read_packing_scene(TomlTable& root) {
  auto packing = root.table("packing");
  if (!packing)
    root.missing("packing", "[packing] is missing; name a packing file or a generator, or give a [network]");
  PackingInput input;
  const auto unit = packing->find("length_unit");
  if (unit) input.unit = length_unit(unit->string(), unit->where());
  const auto file = packing->find("file"), generator = packing->find("generator");
  if (!file && !generator) packing->missing("file", "give either 'file' or 'generator', one of them");
  if (file && generator)
    throw InputError(fmt::format("{}: give either 'file' or 'generator', one of them", packing->where()));
  if (file) adopt_stated_unit(beside_case(root.file(), file->string()), unit, input.unit);
  input.scene.length_unit = input.unit;
  if (auto container = packing->table("container"))
    input.scene.container = read_container(*container, input.unit);
  input.scene.packing = file ? read_packing(beside_case(root.file(), file->string()), input.unit)
                             : generate(*packing, *generator, input.unit);
  auto contact = root.table("contact");
  if (!contact) root.missing("contact", "[contact] is missing; it names the neck law");
  if (const auto law = contact->find("conductance")) {
    input.pipe = law->string() == "pipe";
    if (!input.pipe && law->string() != "series") law->reject("it must be \"series\" or \"pipe\"");
  }
  const std::string place = file ? beside_case(root.file(), file->string()) : generator->where();
  read_contacts(*contact, root.file(), place, input.unit, input.scene);
  return input;
}

}  // namespace superstep

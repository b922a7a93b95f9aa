#include "case/read_packing_scene.hpp"

#include <fmt/format.h>

#include <numbers>

#include "case/inputs/named_file.hpp"
#include "case/memory/memory_packing.hpp"
#include "case/packed/packing_options.hpp"
#include "case/packed/read_contacts.hpp"
#include "case/packed/read_lattice.hpp"
#include "core/error.hpp"
#include "packing/generate.hpp"
#include "packing/grid.hpp"
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
      if (sizes.sigma < narrowest_sigma || sizes.sigma > widest_sigma)
        table.require("sigma", "it is the standard deviation of ln(diameter)")
            .reject(fmt::format("it is {}; it must lie between {} and {}: narrower, all spheres are equal "
                                "(take distribution = \"uniform\"), wider, min and max are all there is",
                                sizes.sigma, narrowest_sigma, widest_sigma));
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

std::size_t sphere_count(TomlTable& table, std::int64_t fallback) {
  const auto count = static_cast<std::size_t>(non_negative(table, "count", fallback));
  if (count > largest_packing)
    table.find("count")->reject(fmt::format("it must be at most {}", largest_packing));
  return count;
}

Packing generate_grid(TomlTable& table, double unit) {
  constexpr std::size_t smallest = 8;
  GridSettings settings;
  for (const char* key : {"generator", "length_unit", "units", "periodic", "box", "count", "spacing",
                          "jitter", "seed", "sizes", "materials", "shares", "container"})
    (void)table.find(key);
  table.finish();  // a misspelt key is said first: without it others would not fit together
  settings.count = sphere_count(table, 0);
  if (settings.count < smallest)
    table.require("count", "a grid needs the number of its spheres")
        .reject(fmt::format("a grid has at least {} spheres", smallest));
  settings.spacing = unit * table.positive("spacing", "length");
  const auto jitter = table.find("jitter");
  if (jitter) settings.jitter = jitter->number();
  if (!(settings.jitter >= 0 && settings.jitter <= 0.5)) jitter->reject("it must lie between 0 and 0.5");
  settings.seed = static_cast<std::uint64_t>(non_negative(table, "seed", 1));
  const auto sizes = table.require("sizes", "it is a table with a distribution");
  const SizeDistribution read = read_sizes(sizes.table(), unit);
  if (read.kind != SizeDistribution::Kind::uniform || read.min > read.max)
    sizes.reject("a grid has sizes of distribution = \"uniform\", min no larger than max");
  settings.smallest = read.min;
  settings.largest = read.max;
  if (const auto names = table.find("materials")) {
    settings.materials = names->strings();
    if (settings.materials.empty()) names->reject("it must name at least one material");
  }
  if (const auto shares = table.find("shares")) {
    settings.shares = positive_numbers(*shares);
    if (settings.shares.size() != settings.materials.size())
      shares->reject("there must be as many shares as materials");
  }
  return grid_packing(settings);
}

Packing read_generator(TomlTable& table, const TomlValue& generator, double unit) {
  PackSettings settings;
  const std::string shape = generator.string();
  if (shape == "grid") return generate_grid(table, unit);
  if (shape == "lattice") {
    const Lattice lattice = read_lattice(table, unit);
    return lattice_layers(lattice, 0, lattice.cells[2]);
  }
  if (shape == "cylinder") {
    settings.container.shape = Container::Shape::cylinder;
    settings.container.diameter = unit * table.positive("diameter", "length");
  } else if (shape == "box") {
    settings.container.shape = Container::Shape::box;
    settings.container.width = unit * table.positive("width", "length");
    settings.container.depth = unit * table.positive("depth", "length");
  } else {
    generator.reject("the generator must be \"cylinder\", \"box\", \"grid\" or \"lattice\"");
  }
  settings.container.height = unit * table.positive("height", "length");
  settings.relative_density = table.positive("relative_density", "-");
  constexpr double densest = 0.9;
  if (settings.relative_density > densest)
    table.find("relative_density")->reject(fmt::format("it must be at most {}", densest));
  settings.count = sphere_count(table, 0);
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

}  // namespace

void read_contact_table(TomlTable& root, const std::string& place, PackingInput& input) {
  auto contact = root.table("contact");
  if (!contact) root.missing("contact", "[contact] is missing; it names the neck law");
  if (const auto law = contact->find("conductance")) {
    input.pipe = law->string() == "pipe";
    if (!input.pipe && law->string() != "series") law->reject("it must be \"series\" or \"pipe\"");
  }
  read_contacts(*contact, place, input.scene);
}

PackingInput read_packing_scene(TomlTable& root, const SphereArrays* spheres) {
  auto packing = root.table("packing");
  if (!packing)
    root.missing("packing", "[packing] is missing; name a packing file or a generator, or give a [network]");
  PackingInput input;
  const PackingOptions options = read_packing_options(*packing);
  const auto file = packing->find("file"), generator = packing->find("generator");
  if (spheres) {
    for (const auto* other : {&file, &generator})
      if (*other) (*other)->reject("the particles are in memory already; leave this key out");
    if (const auto order = packing->find("order"))
      order->reject("particles in memory keep their order; leave this key out");
  }
  if (!file && !generator && !spheres)
    packing->missing("file", "give either 'file' or 'generator', one of them");
  if (file && generator)
    throw InputError(fmt::format("{}: give either 'file' or 'generator', one of them", packing->where()));
  if (generator)
    for (const char* key : {"units", "periodic", "box", "format", "atom_style", "columns", "order"})
      if (const auto value = packing->find(key))
        value->reject("it says how a packing file is read, and the case has a generator; leave it out");
  input.unit = options.length_unit.value_or(1.0);
  input.scene.packing =
      spheres ? packing_of(*spheres, root.file(), options)
      : file  ? read_named_file(*file, [&](const auto& path) { return read_packing(path, options); })
              : read_generator(*packing, *generator, input.unit);
  if (file) input.unit = input.scene.packing.length_unit;
  input.scene.length_unit = input.unit;
  if (auto container = packing->table("container"))
    input.scene.container = read_container(*container, input.unit);
  const std::string place = spheres ? packing->where() : file ? named_path(*file) : generator->where();
  read_contact_table(root, place, input);
  return input;
}

}  // namespace superstep

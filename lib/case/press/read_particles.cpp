#include "case/press/read_particles.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>

#include "case/inputs/named_file.hpp"
#include "case/press/check_bonds.hpp"
#include "case/press/check_overlaps.hpp"
#include "case/press/read_kinematics.hpp"
#include "case/press/read_values.hpp"
#include "case/read_packing_scene.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "dynamics/random_addition.hpp"
#include "packing/pack_checks.hpp"
#include "packing/read.hpp"
#include "packing/relaxation/size_distribution.hpp"

namespace superstep::dynamics {
namespace {

struct OneParticle {
  Vec3 position, velocity;
  double radius = 0, temperature = 0;
  std::size_t material = 0;
};

/// Whom the readers add to.
struct Reading {
  const std::vector<PressMaterial>& materials;
  double initial;  ///< K
  ModelInput& input;

  void add(const OneParticle& particle, std::int64_t id) const {
    Particles& particles = input.particles;
    const PressMaterial& material = materials[particle.material];
    particles.id.push_back(id);
    particles.radius.push_back(particle.radius);
    particles.mass.push_back(material.density * 4.0 / 3.0 * std::numbers::pi * std::pow(particle.radius, 3));
    if (!material.name.empty()) {
      particles.material.push_back(static_cast<std::int32_t>(particle.material));
      particles.specific_heat.push_back(material.specific_heat);
      particles.conductivity.push_back(material.conductivity);
      if (material.electric_conductivity > 0)
        particles.electric_conductivity.push_back(material.electric_conductivity);
      particles.hardness.push_back(material.hardness);
    }
    input.state.position.push_back(particle.position);
    input.state.velocity.push_back(particle.velocity);
    input.state.temperature.push_back(particle.temperature);
    input.state.electric.push_back(0);
  }
  /// Number of the material of this name; `value` is where it stands.
  [[nodiscard]] std::optional<std::size_t> material(const std::string& name) const {
    for (std::size_t k = 0; k < materials.size(); ++k)
      if (materials[k].name == name) return k;
    return std::nullopt;
  }
  [[nodiscard]] bool several() const { return !materials.front().name.empty(); }
};

// Neighbours in space become neighbours in memory.
std::vector<std::size_t> order_by_bins(const std::vector<Vec3>& centres, Vec3 origin, double width) {
  const auto bin = [&](std::size_t i) {
    const Vec3 from = centres[i] - origin;
    return std::array<double, 3>{std::floor(from.z / width), std::floor(from.y / width),
                                 std::floor(from.x / width)};
  };
  std::vector<std::size_t> order(centres.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return bin(a) < bin(b); });
  return order;
}

/// Radii [m] of generated particles, largest first where they differ.
std::vector<double> radii_of(TomlTable& table, std::size_t count) {
  const auto sizes = table.find("sizes");
  if (!sizes) return std::vector<double>(count, table.positive("radius", "m"));
  if (const auto radius = table.find("radius")) radius->reject("sizes are given already; remove one of them");
  std::vector<double> radii;
  try {
    const SizeDistribution distribution = read_sizes(sizes->table(), 1);
    if (distribution.kind != SizeDistribution::Kind::list && !(distribution.min <= distribution.max))
      sizes->reject("min must not exceed max");
    radii = stratified_diameters(distribution, count);
  } catch (const UsageError& error) {
    throw InputError(fmt::format("{}: {}", sizes->where(), error.what()));
  }
  for (double& radius : radii) radius /= 2;
  std::sort(radii.begin(), radii.end(), std::greater<>());
  return radii;
}

/// Material of each of `count` particles by their shares, shuffled.
std::vector<std::size_t> shared_out(const std::vector<PressMaterial>& materials, std::size_t count,
                                    std::uint64_t seed, const TomlTable& table) {
  if (materials.front().name.empty()) return std::vector<std::size_t>(count, 0);
  double all = 0;
  for (const auto& material : materials) all += material.share;
  if (!(all > 0))
    throw InputError(fmt::format("{}: none of [[materials]] has a share of generated particles; give them",
                                 table.where()));
  std::vector<std::size_t> out;
  double sum = 0;
  for (std::size_t k = 0; k < materials.size(); ++k) {
    sum += materials[k].share;
    const auto until = static_cast<std::size_t>(std::lround(sum / all * static_cast<double>(count)));
    out.resize(until, k);
  }
  Random(seed + 1).shuffle(out);
  return out;
}

void generate(TomlTable& table, std::optional<std::uint64_t> other_seed, const Placed& placed,
              const Reading& reading) {
  const auto count = table.require("count", "give count and radius, a list of particles, or a file");
  if (count.integer() < 1) count.reject("there must be at least one particle");
  constexpr std::int64_t most = 100'000'000;
  if (count.integer() > most) count.reject(fmt::format("it must be at most {}", most));
  const auto radii = radii_of(table, static_cast<std::size_t>(count.integer()));
  const auto stated = table.find("seed");
  if (stated && stated->integer() < 0) stated->reject("it must be >= 0");
  const std::uint64_t seed = other_seed ? *other_seed
                             : stated   ? static_cast<std::uint64_t>(stated->integer())
                                        : 1;
  const auto material = shared_out(reading.materials, radii.size(), seed, table);
  std::vector<Vec3> centres;
  try {
    centres = random_addition(reading.input.model.box, radii, seed, placed);
  } catch (const NumericalError& error) {
    throw InputError(fmt::format("{}: {}", table.where(), error.what()));
  }
  for (const std::size_t k : order_by_bins(centres, reading.input.model.box.min, 2 * radii.front()))
    reading.add({centres[k], {}, radii[k], reading.initial, material[k]}, static_cast<std::int64_t>(k));
}

std::size_t material_named(const TomlValue& value, const Reading& reading) {
  if (!reading.several()) value.reject("the case has one [material]; remove it, or give [[materials]]");
  const auto found = reading.material(value.string());
  if (!found) value.reject("it must name one of [[materials]]");
  return *found;
}

void read_list(const TomlValue& list, const Reading& reading) {
  const auto entries = list.array();
  if (entries.empty()) list.reject("there must be at least one particle");
  for (const auto& entry : entries) {
    TomlTable table = entry.table();
    OneParticle particle;
    particle.position = point_from(table.require("position", "it is the centre [x, y, z] in m"));
    if (const auto velocity = table.find("velocity")) particle.velocity = point_from(*velocity);
    particle.radius = table.positive("radius", "m");
    particle.temperature = number_from(table, "temperature", 0, reading.initial, "K");
    if (const auto material = table.find("material"))
      particle.material = material_named(*material, reading);
    else if (reading.several())
      table.missing("material", "it names one of [[materials]]");
    table.finish();
    reading.add(particle, static_cast<std::int64_t>(reading.input.particles.size()));
  }
}

/// Number of each of the packing's materials in the case.
std::vector<std::size_t> materials_of(const TomlValue& file, const Packing& packing, const Reading& reading) {
  if (!reading.several())
    return std::vector<std::size_t>(std::max<std::size_t>(1, packing.material_names.size()), 0);
  if (packing.material_names.empty() && reading.materials.size() == 1) return {0};
  if (const auto all = reading.material(packing.single_type); packing.material_names.empty() && all)
    return {*all};
  if (packing.material_names.empty())
    file.reject(
        "it names no materials, and the case has [[materials]]; add a column, or give one [material]");
  std::vector<std::size_t> out;
  for (const auto& name : packing.material_names) {
    const auto found = reading.material(name);
    if (!found) file.reject(fmt::format("it has a material '{}', which is none of [[materials]]", name));
    out.push_back(*found);
  }
  return out;
}

/// A packing in any format, with velocities, temperatures and bonds where it or files beside it have them.
void read_file(TomlTable& table, const TomlValue& file, const Reading& reading) {
  PackingOptions options;
  options.place = file.where();
  options.periodic = "none";
  options.has_walls = true;
  if (const auto unit = table.find("length_unit")) {
    options.length_unit = length_unit(unit->string(), unit->where());
    options.place = unit->where();
  }
  const Packing packing =
      read_named_file(file, [&](const auto& path) { return read_packing(path, options); });
  reading.input.warnings = packing.warnings;
  if (!packing.frame.empty())
    reading.input.warnings.push_back(fmt::format("the packing is {} of its file", packing.frame));
  std::optional<double> unit;
  if (table.find("velocity_unit")) unit = table.positive("velocity_unit", "m/s");
  const Kinematics kinematics = read_kinematics(named_path(file), packing, unit);
  if (!kinematics.unused.empty())
    reading.input.warnings.push_back(fmt::format(
        "{}: a press makes no use of {} '{}'; particles have the density of the case and do not turn",
        packing.columns_place, kinematics.unused.size() == 1 ? "its column" : "its columns",
        fmt::join(kinematics.unused, "', '")));
  std::vector<Bond> bonds;
  if (const auto stored = table.find("bonds")) {
    if (!reading.input.model.bond.acts()) stored->reject("the case has no [dynamics.bond]; remove it");
    bonds = read_named_file(*stored, [&](const auto& path) { return read_bonds(path, packing); });
  }
  const Vec3 shift = table.find("shift") ? point_from(*table.find("shift")) : Vec3{};
  const auto material = materials_of(file, packing, reading);
  const double largest = *std::max_element(packing.radius.begin(), packing.radius.end());
  const auto order = order_by_bins(packing.centre, surface_bounds(packing).min, 2 * largest);
  std::vector<std::int32_t> place(order.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    const std::size_t k = order[n];
    place[k] = static_cast<std::int32_t>(n);
    reading.add(
        {packing.centre[k] + shift, kinematics.velocity.empty() ? Vec3{} : kinematics.velocity[k],
         packing.radius[k], kinematics.temperature.empty() ? reading.initial : kinematics.temperature[k],
         material[static_cast<std::size_t>(packing.material[k])]},
        packing.id[k]);
  }
  for (Bond& bond : bonds) {
    const auto a = place[static_cast<std::size_t>(bond.i)], b = place[static_cast<std::size_t>(bond.j)];
    bond.i = std::min(a, b);
    bond.j = std::max(a, b);
  }
  std::sort(bonds.begin(), bonds.end(), [](const Bond& a, const Bond& b) {
    return std::pair{a.i, a.j} < std::pair{b.i, b.j};
  });
  reading.input.state.bonds = std::move(bonds);
  if (const auto stored = table.find("bonds"))
    if (const auto torn = torn_bonds(reading.input, named_path(*stored)))
      reading.input.warnings.push_back(*torn);
}

}  // namespace

void read_particles(TomlTable table, const std::vector<PressMaterial>& materials, double initial,
                    std::optional<std::uint64_t> seed, const Placed& placed, ModelInput& input) {
  const Reading reading{materials, initial, input};
  for (const char* key : {"list", "file", "count", "radius", "sizes", "seed", "bonds", "shift", "length_unit",
                          "velocity_unit", "max_overlap"})
    (void)table.find(key);
  table.finish();  // a misspelt key is said first: what follows would only miss it
  const auto refuse = [&](std::initializer_list<const char*> keys, const char* given) {
    for (const char* key : keys)
      if (const auto value = table.find(key))
        value->reject(fmt::format("particles are given by {}; remove one of them", given));
  };
  const auto list = table.find("list"), file = table.find("file");
  if (file)
    refuse({"list", "count", "radius", "sizes", "seed"}, "file");
  else
    refuse({"bonds", "shift", "length_unit", "velocity_unit"}, "no file");
  if (list) refuse({"count", "radius", "sizes", "seed"}, "list");
  if (file)
    read_file(table, *file, reading);
  else if (list)
    read_list(*list, reading);
  else
    generate(table, seed, placed, reading);
  const auto largest = table.find("max_overlap");
  if (largest && !(largest->number() >= 0 && largest->number() < 1)) largest->reject("it must lie in [0, 1)");
  check_overlaps(input, largest ? std::optional(largest->number()) : std::nullopt, table.where());
}

}  // namespace superstep::dynamics

#include "case/press/read_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "case/press/read_values.hpp"
#include "core/error.hpp"
#include "dynamics/laws/contact_law.hpp"
#include "dynamics/random_addition.hpp"
#include "packing/near_pairs.hpp"

namespace superstep::dynamics {
namespace {

struct OneParticle {
  Vec3 position, velocity;
  double radius = 0, temperature = 0;
};

void add(const OneParticle& particle, std::int64_t id, double density, ModelInput& input) {
  input.particles.id.push_back(id);
  input.particles.radius.push_back(particle.radius);
  input.particles.mass.push_back(density * 4.0 / 3.0 * std::numbers::pi * std::pow(particle.radius, 3));
  input.state.position.push_back(particle.position);
  input.state.velocity.push_back(particle.velocity);
  input.state.temperature.push_back(particle.temperature);
  input.state.electric.push_back(0);
}

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

void generate(TomlTable& table, double density, double initial, ModelInput& input) {
  const auto count = table.require("count", "give count and radius, or a list of particles");
  if (count.integer() < 1) count.reject("there must be at least one particle");
  constexpr std::int64_t most = 100'000'000;
  if (count.integer() > most) count.reject(fmt::format("it must be at most {}", most));
  const double radius = table.positive("radius", "m");
  const auto seed = table.find("seed");
  if (seed && seed->integer() < 0) seed->reject("it must be >= 0");
  std::vector<Vec3> centres;
  try {
    centres = random_addition(input.model.box, static_cast<std::size_t>(count.integer()), radius,
                              seed ? static_cast<std::uint64_t>(seed->integer()) : 1);
  } catch (const NumericalError& error) {
    throw InputError(fmt::format("{}: {}", table.where(), error.what()));
  }
  for (const std::size_t k : order_by_bins(centres, input.model.box.min, 2 * radius))
    add({centres[k], {}, radius, initial}, static_cast<std::int64_t>(k), density, input);
}

void read_list(const TomlValue& list, double density, double initial, ModelInput& input) {
  const auto entries = list.array();
  if (entries.empty()) list.reject("there must be at least one particle");
  for (const auto& entry : entries) {
    TomlTable table = entry.table();
    OneParticle particle;
    particle.position = point_from(table.require("position", "it is the centre [x, y, z] in m"));
    if (const auto velocity = table.find("velocity")) particle.velocity = point_from(*velocity);
    particle.radius = table.positive("radius", "m");
    particle.temperature = number_from(table, "temperature", 0, initial, "K");
    table.finish();
    add(particle, static_cast<std::int64_t>(input.particles.size()), density, input);
  }
}

std::string where_is(const ModelInput& input, std::size_t i) {
  const Vec3& at = input.state.position[i];
  return fmt::format("particle {} at ({:.6g}, {:.6g}, {:.6g}) m", input.particles.id[i], at.x, at.y, at.z);
}

void check_start(const TomlTable& table, double largest, const ModelInput& input) {
  const auto& position = input.state.position;
  const auto& radius = input.particles.radius;
  const char* way_out = "move them apart, or allow it with max_overlap";
  for (const auto& [i, j] : near_pairs(position, radius)) {
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    const double strain = -pair_strain(norm(position[b] - position[a]), radius[a] + radius[b]);
    if (strain > largest)
      throw InputError(
          fmt::format("{}: {} and {} overlap by {:.4g} of the sum of their radii at the start; {}",
                      table.where(), where_is(input, a), where_is(input, b), strain, way_out));
  }
  std::vector<WallContact> walls;
  find_wall_contacts(input.model.box, input.model.box.max.z, position, radius, walls);
  for (const auto& contact : walls)
    if (-contact.strain > largest)
      throw InputError(fmt::format("{}: {} overlaps the {} wall by {:.4g} of its radius at the start; {}",
                                   table.where(), where_is(input, static_cast<std::size_t>(contact.particle)),
                                   wall_name(contact.wall), -contact.strain, way_out));
}

}  // namespace

void read_particles(TomlTable table, double density, double initial, ModelInput& input) {
  if (const auto list = table.find("list")) {
    for (const char* key : {"count", "radius", "seed"})
      if (const auto value = table.find(key))
        value->reject("particles are given by list; remove one of them");
    read_list(*list, density, initial, input);
  } else {
    generate(table, density, initial, input);
  }
  constexpr double rounding = 1e-9;  // particles that just touch do not overlap
  const auto largest = table.find("max_overlap");
  if (largest && !(largest->number() >= 0 && largest->number() < 1)) largest->reject("it must lie in [0, 1)");
  check_start(table, largest ? largest->number() : rounding, input);
}

}  // namespace superstep::dynamics

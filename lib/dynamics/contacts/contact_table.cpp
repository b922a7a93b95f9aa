#include "dynamics/contacts/contact_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/index.hpp"
#include "dynamics/contacts/vector_loops.hpp"

namespace superstep::dynamics {
namespace {

using Block = std::array<double, pairs_per_block>;

struct Place {
  const double *sum, *square, *difference;
  double *nx, *ny, *nz, *strain, *area, *flow;
};

/// From the vectors between the centres; the formulas of `pair_strain` and `pair_area`, without branches.
SUPERSTEP_CLONES void place_block(const Place& out, const double* x, const double* y, const double* z,
                                  std::size_t count) {
  SUPERSTEP_INDEPENDENT
  for (std::size_t k = 0; k < count; ++k) {
    const double squared = x[k] * x[k] + y[k] * y[k] + z[k] * z[k];
    const double distance = std::sqrt(squared), inverse = 1 / distance;
    const double sum = out.sum[k], strain = (distance - sum) / sum;
    const double plane = 0.5 * (distance - out.difference[k] * inverse);
    const double r_i = out.square[k], r_j = r_i + out.difference[k];
    double inside = r_i - plane * plane;
    inside = inside < 0 ? 0 : inside;
    inside = plane <= 0 ? r_i : inside;
    inside = plane >= distance ? r_j : inside;
    inside = strain < 0 ? inside : 0;
    const double area = std::numbers::pi * inside;
    out.nx[k] = inverse * x[k];
    out.ny[k] = inverse * y[k];
    out.nz[k] = inverse * z[k];
    out.strain[k] = strain;
    out.area[k] = area;
    out.flow[k] = area * inverse;
  }
}

}  // namespace

void ContactTable::resize(std::size_t pairs) {
  i.resize(pairs);
  j.resize(pairs);
  for (auto* values : {&radius_sum, &square, &square_difference, &reduced_mass, &hardness, &conductivity, &nx,
                       &ny, &nz, &strain, &area, &flow, &keep, &pull, &damping})
    values->resize(pairs);
}

void Incidence::build(const ContactTable& table, std::size_t particles) {
  begin.assign(particles + 1, 0);
  for (std::size_t k = 0; k < table.size(); ++k) {
    ++begin[at(table.i[k]) + 1];
    ++begin[at(table.j[k]) + 1];
  }
  for (std::size_t p = 0; p < particles; ++p) begin[p + 1] += begin[p];
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  entry.resize(2 * table.size());
  for (std::size_t k = 0; k < table.size(); ++k) {
    entry[next[at(table.i[k])]++] = static_cast<std::int32_t>(2 * k);
    entry[next[at(table.j[k])]++] = static_cast<std::int32_t>(2 * k + 1);
  }
}

void place_pairs(ContactTable& table, std::span<const Vec3> position, std::size_t first, std::size_t last) {
  Block x, y, z;
  for (std::size_t begin = first; begin < last; begin += pairs_per_block) {
    const std::size_t count = std::min(pairs_per_block, last - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const Vec3 between = position[at(table.j[begin + k])] - position[at(table.i[begin + k])];
      x[k] = between.x;
      y[k] = between.y;
      z[k] = between.z;
    }
    place_block(
        {&table.radius_sum[begin], &table.square[begin], &table.square_difference[begin], &table.nx[begin],
         &table.ny[begin], &table.nz[begin], &table.strain[begin], &table.area[begin], &table.flow[begin]},
        x.data(), y.data(), z.data(), count);
  }
}

}  // namespace superstep::dynamics

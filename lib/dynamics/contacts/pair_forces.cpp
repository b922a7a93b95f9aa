#include "dynamics/contacts/pair_forces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "dynamics/contacts/vector_loops.hpp"

namespace superstep::dynamics {
namespace {

using Block = std::array<double, pairs_per_block>;

/// Pointers to one block of the table, of what was gathered, and of the forces.
struct Pairs {
  const double *nx, *ny, *nz, *strain, *area, *sum, *mass, *hardness, *keep, *pull, *bond_damping;
  const double *vx, *vy, *vz, *temperature;
  const double* power;  // |E|^p where p is neither 1 nor 2
  double *x, *y, *z;
};

constexpr double larger(double a, double b) noexcept {
  return a < b ? b : a;
}

enum class Power : char { one, two, other };

/// `contact_force`, `normal_damping`, `damped_push` and `friction_direction` of the laws, and a bond's keep,
/// pull and damping, without branches: whoever does not touch has area 0 and feels nothing.
template <Power power>
[[gnu::always_inline]] inline void block(const ContactLaw& law, const Pairs& p, std::size_t count) noexcept {
  const double stiffness = law.stiffness, per_kelvin = 1 / law.softening.temperature,
               floor = law.softening.floor;
  const double damping = 2 * law.damping, slope = law.exponent + 1, friction = law.friction;
  const double slow = law.friction_speed * law.friction_speed;
#pragma GCC ivdep
  for (std::size_t k = 0; k < count; ++k) {
    const double overlap = larger(-p.strain[k], 0.0);
    const double strained = power == Power::two   ? overlap * overlap
                            : power == Power::one ? overlap
                                                  : p.power[k];
    const double soft = larger(stiffness * (1 - p.temperature[k] * per_kelvin), floor);
    const double push = soft * p.hardness[k] * strained * p.area[k];
    const double parting = p.vx[k] * p.nx[k] + p.vy[k] * p.ny[k] + p.vz[k] * p.nz[k];
    constexpr double tiny = 1e-300;  // 0/0 of a pair that just does not touch
    const double stiff = slope * push / (overlap * p.sum[k] + tiny);
    const double damped = larger(push - damping * std::sqrt(p.mass[k] * stiff) * parting, 0.0);
    const double sx = p.vx[k] - parting * p.nx[k], sy = p.vy[k] - parting * p.ny[k],
                 sz = p.vz[k] - parting * p.nz[k];
    const double slide = p.keep[k] * friction * push / std::sqrt(sx * sx + sy * sy + sz * sz + slow);
    const double along = p.pull[k] + p.bond_damping[k] * parting - p.keep[k] * damped;
    p.x[k] = along * p.nx[k] + slide * sx;
    p.y[k] = along * p.ny[k] + slide * sy;
    p.z[k] = along * p.nz[k] + slide * sz;
  }
}

SUPERSTEP_CLONES void block_of_one(const ContactLaw& law, const Pairs& p, std::size_t count) {
  block<Power::one>(law, p, count);
}
SUPERSTEP_CLONES void block_of_two(const ContactLaw& law, const Pairs& p, std::size_t count) {
  block<Power::two>(law, p, count);
}
SUPERSTEP_CLONES void block_of_other(const ContactLaw& law, const Pairs& p, std::size_t count) {
  block<Power::other>(law, p, count);
}

/// The pairs [first, last) into `room`.
void pair_forces(const ContactLaw& law, const ContactTable& table, std::span<const Vec3> velocity,
                 std::span<const double> temperature, std::size_t first, std::size_t last, PairForces& room) {
  Block vx, vy, vz, mean, power;
  for (std::size_t begin = first; begin < last; begin += pairs_per_block) {
    const std::size_t count = std::min(pairs_per_block, last - begin);
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t i = at(table.i[begin + k]), j = at(table.j[begin + k]);
      vx[k] = velocity[j].x - velocity[i].x;
      vy[k] = velocity[j].y - velocity[i].y;
      vz[k] = velocity[j].z - velocity[i].z;
      mean[k] = 0.5 * (temperature[i] + temperature[j]);
    }
    const Pairs pairs{&table.nx[begin],
                      &table.ny[begin],
                      &table.nz[begin],
                      &table.strain[begin],
                      &table.area[begin],
                      &table.radius_sum[begin],
                      &table.reduced_mass[begin],
                      &table.hardness[begin],
                      &table.keep[begin],
                      &table.pull[begin],
                      &table.damping[begin],
                      vx.data(),
                      vy.data(),
                      vz.data(),
                      mean.data(),
                      power.data(),
                      &room.x[begin],
                      &room.y[begin],
                      &room.z[begin]};
    if (law.exponent == 2) {
      block_of_two(law, pairs, count);
    } else if (law.exponent == 1) {
      block_of_one(law, pairs, count);
    } else {
      for (std::size_t k = 0; k < count; ++k)
        power[k] = std::pow(std::max(-table.strain[begin + k], 0.0), law.exponent);
      block_of_other(law, pairs, count);
    }
  }
}

void scatter(const ContactTable& table, const PairForces& room, std::size_t first, std::size_t last,
             std::span<Vec3> force) {
  for (std::size_t k = first; k < last; ++k) {
    const Vec3 pair{room.x[k], room.y[k], room.z[k]};
    Vec3 &on_i = force[at(table.i[k])], &on_j = force[at(table.j[k])];
    on_i = on_i + pair;
    on_j = on_j - pair;
  }
}

void gather(const Incidence& incidence, const PairForces& room, std::size_t first, std::size_t last,
            std::span<Vec3> force) {
  for (std::size_t p = first; p < last; ++p) {
    Vec3 sum = force[p];
    for (std::size_t e = incidence.begin[p]; e < incidence.begin[p + 1]; ++e) {
      const std::size_t k = at(incidence.entry[e] / 2);
      const Vec3 pair{room.x[k], room.y[k], room.z[k]};
      sum = incidence.entry[e] % 2 == 0 ? sum + pair : sum - pair;
    }
    force[p] = sum;
  }
}

}  // namespace

void add_pair_forces(const ContactLaw& law, const ContactTable& table, std::span<const Vec3> velocity,
                     std::span<const double> temperature, PairForces& room, std::span<Vec3> force,
                     const std::function<const Incidence&()>& incidence) {
  for (auto* values : {&room.x, &room.y, &room.z}) values->resize(table.size());
  if (threads_for(table.size() / 4) == 1) {
    for (std::size_t k = 0; k < table.size(); k += pairs_per_block) {
      const std::size_t last = std::min(k + pairs_per_block, table.size());
      pair_forces(law, table, velocity, temperature, k, last, room);
      scatter(table, room, k, last, force);
    }
    return;
  }
  const Incidence& pairs_of = incidence();
  for_ranges(table.size(), table.size() / 4, [&](std::size_t first, std::size_t last) {
    pair_forces(law, table, velocity, temperature, first, last, room);
  });
  for_ranges(force.size(), table.size() / 4,
             [&](std::size_t first, std::size_t last) { gather(pairs_of, room, first, last, force); });
}

}  // namespace superstep::dynamics

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

/// Pointers to one block of the table, and to what was gathered.
struct Pairs {
  const double *nx, *ny, *nz, *strain, *area, *sum, *mass, *hardness, *keep, *pull, *bond_damping;
  const double *vx, *vy, *vz, *temperature;
  const double* power;  // |E|^p
};

struct ForcesOut {
  double *x, *y, *z;
};

struct WholeOut {
  double *elastic, *dissipated, *slope, *resistance;
};

constexpr double larger(double a, double b) noexcept {
  return a < b ? b : a;
}

/// What all contacts share, as their formulas take it.
struct Shared {
  double stiffness, per_kelvin, floor, damping, slope, friction, slow, per_slow;

  explicit Shared(const ContactLaw& law) noexcept
      : stiffness(law.stiffness),
        per_kelvin(1 / law.softening.temperature),
        floor(law.softening.floor),
        damping(2 * law.damping),
        slope(law.exponent + 1),
        friction(law.friction),
        slow(law.friction_speed * law.friction_speed),
        per_slow(1 / law.friction_speed) {}
};

/// A contact between two particles as `contact_force`, `normal_damping`, `damped_push` and
/// `friction_direction` of the laws have it, without branches: whoever does not touch has area 0 and feels
/// nothing.
struct Contact {
  double push, stiff, damping, parting, damped;  // N, N/m, kg/s, m/s, N
  double sx, sy, sz, slide;                      // m/s; friction over it [kg/s]

  [[gnu::always_inline]] Contact(const Shared& law, const Pairs& p, std::size_t k) noexcept {
    const double overlap = larger(-p.strain[k], 0.0);
    const double soft = larger(law.stiffness * (1 - p.temperature[k] * law.per_kelvin), law.floor);
    push = soft * p.hardness[k] * p.power[k] * p.area[k];
    parting = p.vx[k] * p.nx[k] + p.vy[k] * p.ny[k] + p.vz[k] * p.nz[k];
    constexpr double tiny = 1e-300;  // 0/0 of a pair that just does not touch
    stiff = law.slope * push / (overlap * p.sum[k] + tiny);
    damping = law.damping * std::sqrt(p.mass[k] * stiff);
    damped = larger(push - damping * parting, 0.0);
    sx = p.vx[k] - parting * p.nx[k];
    sy = p.vy[k] - parting * p.ny[k];
    sz = p.vz[k] - parting * p.nz[k];
    slide = p.keep[k] * law.friction * push / std::sqrt(sx * sx + sy * sy + sz * sz + law.slow);
  }
};

SUPERSTEP_CLONES void forces_of(const ContactLaw& contact_law, const Pairs& p, const ForcesOut& out,
                                std::size_t count) {
  const Shared law(contact_law);
  SUPERSTEP_INDEPENDENT
  for (std::size_t k = 0; k < count; ++k) {
    const Contact c(law, p, k);
    const double along = p.pull[k] + p.bond_damping[k] * c.parting - p.keep[k] * c.damped;
    out.x[k] = along * p.nx[k] + c.slide * c.sx;
    out.y[k] = along * p.ny[k] + c.slide * c.sy;
    out.z[k] = along * p.nz[k] + c.slide * c.sz;
  }
}

/// Parting bodies do work against the pull and receive that of the repulsion.
SUPERSTEP_CLONES void whole_of(const ContactLaw& contact_law, const Pairs& p, const WholeOut& out,
                               std::size_t count) {
  const Shared law(contact_law);
  SUPERSTEP_INDEPENDENT
  for (std::size_t k = 0; k < count; ++k) {
    const Contact c(law, p, k);
    out.elastic[k] = (p.pull[k] - p.keep[k] * c.push) * c.parting;
    out.dissipated[k] = (p.keep[k] * (c.push - c.damped) + p.bond_damping[k] * c.parting) * c.parting +
                        c.slide * (c.sx * c.sx + c.sy * c.sy + c.sz * c.sz);
    out.slope[k] = c.stiff;
    out.resistance[k] = c.damping + law.friction * c.push * law.per_slow;
  }
}

/// |E|^p of overlapping pairs, 0 of others.
void strain_powers(const double* strain, double exponent, std::size_t count, double* out) {
  for (std::size_t k = 0; k < count; ++k) out[k] = larger(-strain[k], 0.0);
  if (exponent == 1) return;
  if (exponent == 2)
    for (std::size_t k = 0; k < count; ++k) out[k] *= out[k];
  else
    for (std::size_t k = 0; k < count; ++k) out[k] = std::pow(out[k], exponent);
}

/// The pairs [first, last) into `room`.
void pair_forces(const ContactLaw& law, const ContactTable& table, std::span<const Vec3> velocity,
                 std::span<const double> temperature, PairDetail detail, std::size_t first, std::size_t last,
                 PairForces& room) {
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
    strain_powers(&table.strain[begin], law.exponent, count, power.data());
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
                      power.data()};
    forces_of(law, pairs, {&room.x[begin], &room.y[begin], &room.z[begin]}, count);
    if (detail == PairDetail::whole)
      whole_of(law, pairs,
               {&room.elastic[begin], &room.dissipated[begin], &room.slope[begin], &room.resistance[begin]},
               count);
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
                     std::span<const double> temperature, PairDetail detail, PairForces& room,
                     std::span<Vec3> force, const std::function<const Incidence&()>& incidence) {
  for (auto* values : {&room.x, &room.y, &room.z}) values->resize(table.size());
  if (detail == PairDetail::whole)
    for (auto* values : {&room.elastic, &room.dissipated, &room.slope, &room.resistance})
      values->resize(table.size());
  if (threads_for(table.size() / 4) == 1) {
    for (std::size_t k = 0; k < table.size(); k += pairs_per_block) {
      const std::size_t last = std::min(k + pairs_per_block, table.size());
      pair_forces(law, table, velocity, temperature, detail, k, last, room);
      scatter(table, room, k, last, force);
    }
    return;
  }
  const Incidence& pairs_of = incidence();
  for_ranges(table.size(), table.size() / 4, [&](std::size_t first, std::size_t last) {
    pair_forces(law, table, velocity, temperature, detail, first, last, room);
  });
  for_ranges(force.size(), table.size() / 4,
             [&](std::size_t first, std::size_t last) { gather(pairs_of, room, first, last, force); });
}

}  // namespace superstep::dynamics

#include <gtest/gtest.h>

#include "dynamics/moving_network.hpp"
#include "dynamics/powers.hpp"
#include "press.hpp"

namespace superstep {
namespace {

using namespace test;

/// The force on one particle from all the others and the walls, straight from the equations, in O(n).
Vec3 obvious_force(const Model& model, const Cloud& cloud, std::size_t i, double upper_wall,
                   double wall_speed) {
  const auto& [particles, state] = cloud;
  const double r = particles.radius[i];
  Vec3 total{0, 0, -particles.mass[i] * model.gravity};
  total = total - (model.drag.coefficient * 6 * std::numbers::pi * r) *
                      (state.velocity[i] - model.drag.medium_velocity);
  const auto through = [&](const ContactLaw& law, Vec3 n, Vec3 relative, double e, double length, double area,
                           double temperature, double mass) {
    const double k =
        std::max(law.stiffness * (1 - temperature / law.softening.temperature), law.softening.floor);
    const double push = k * std::pow(e, law.exponent) * area;
    const double damping = 2 * law.damping * std::sqrt(mass * (law.exponent + 1) * push / (e * length));
    const double parting = dot(relative, n);
    total = total - std::max(push - damping * parting, 0.0) * n;
    const Vec3 slip = relative - parting * n;
    total =
        total +
        (law.friction * push / std::sqrt(dot(slip, slip) + law.friction_speed * law.friction_speed)) * slip;
  };
  for (std::size_t j = 0; j < particles.size(); ++j) {
    const Vec3 between = state.position[j] - state.position[i];
    const double d = norm(between), sum = r + particles.radius[j];
    if (j == i || d >= sum) continue;
    const double l = 0.5 * (d - (particles.radius[j] * particles.radius[j] - r * r) / d);
    // The plane of the circle may have passed a centre: then the smaller sphere's full cross-section counts.
    const double a2 = l < 0 ? r * r : d - l < 0 ? particles.radius[j] * particles.radius[j] : r * r - l * l;
    const double area = std::numbers::pi * a2, e = (sum - d) / sum;
    const double m_i = particles.mass[i], m_j = particles.mass[j];
    through(model.contact, (1 / d) * between, state.velocity[j] - state.velocity[i], e, sum, area,
            0.5 * (state.temperature[i] + state.temperature[j]), m_i * m_j / (m_i + m_j));
    if (e >= model.bond.threshold)
      total = total + (model.bond.stiffness * std::pow(e, model.bond.exponent) * area / d) * between;
  }
  const Vec3 at = state.position[i];
  const std::array<double, 6> distance = {at.x - model.box.min.x, model.box.max.x - at.x,
                                          at.y - model.box.min.y, model.box.max.y - at.y,
                                          at.z - model.box.min.z, upper_wall - at.z};
  const std::array<Vec3, 6> normal = {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, -1}, {0, 0, 1}}};
  for (std::size_t w = 0; w < 6; ++w) {
    if (distance[w] >= r) continue;
    const double e = (r - distance[w]) / r;
    const Vec3 wall_velocity = w == 5 ? Vec3{0, 0, wall_speed} : Vec3{};
    through(model.wall, normal[w], wall_velocity - state.velocity[i], e, r,
            std::numbers::pi * (r * r - distance[w] * distance[w]),
            0.5 * (state.temperature[i] + model.thermal.wall_temperature[w]), particles.mass[i]);
  }
  return total;
}

Model busy_model() {
  Model model = quiet_model(0.4);
  model.gravity = 9.81;
  model.drag = {0.1, {0.1, 0.2, 0.3}};
  model.contact = {1e7, 2, {500, 1e6}, 0.1, 0.05, 0.3};
  model.wall = {2e7, 1.5, {700, 2e6}, 0.2, 0.03, 0.2};
  model.bond = {.stiffness = 5e5, .exponent = 2, .threshold = 0.1, .rule = BondRule::overlap};
  for (std::size_t w = 0; w < wall_count; ++w)
    model.thermal.wall_temperature[w] = 300 + 100 * static_cast<double>(w);
  Phase phase = model.schedule.phases().front();
  phase.end = 1;
  phase.upper_wall = 0.3;
  model.schedule = Schedule({phase});
  return model;
}

TEST(Forces, AgreeWithTheEquationsTermByTerm) {
  const Model model = busy_model();
  Cloud cloud = random_cloud(150, 0.34, 3);  // every centre inside the walls
  cloud.state.time = 0.5;
  const Phase& phase = model.schedule.at(0.5);
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, phase);
  network.settle(cloud.state, phase);
  std::vector<Vec3> force(cloud.particles.size());
  const double on_wall = network.forces(cloud.state.velocity, cloud.state.temperature, force);
  double largest = 0;
  for (const Vec3& f : force) largest = std::max(largest, norm(f));
  ASSERT_GT(cloud.state.bonds.size(), 10U) << "bonds take part";
  ASSERT_GT(network.placement().walls.size(), 10U) << "walls take part";
  for (std::size_t i = 0; i < force.size(); ++i) {
    const Vec3 expected = obvious_force(model, cloud, i, 0.35, -0.1);
    EXPECT_LE(norm(force[i] - expected), 1e-12 * largest) << "rounding of some ten summands, particle " << i;
  }
  EXPECT_GT(on_wall, 0);
}

/// Sum of force times velocity, straight from the equations; the walls stand still.
double obvious_power(const Model& model, const Cloud& cloud, double upper_wall) {
  double sum = 0;
  for (std::size_t i = 0; i < cloud.particles.size(); ++i)
    sum += dot(obvious_force(model, cloud, i, upper_wall, 0), cloud.state.velocity[i]);
  return sum;
}

TEST(Forces, PowersAreThoseOfTheForces) {
  Model model = busy_model();
  Phase standing = model.schedule.phases().front();
  standing.upper_wall_begin = standing.upper_wall = 0.35;
  model.schedule = Schedule({standing});
  Cloud cloud = random_cloud(150, 0.34, 3);
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  network.settle(cloud.state, model.schedule.at(0));
  ASSERT_GT(cloud.state.bonds.size(), 10U) << "bonds take part";
  std::vector<Vec3> force(cloud.particles.size());
  (void)network.forces(cloud.state.velocity, cloud.state.temperature, force, PairDetail::whole);
  const Powers powers = powers_of(network, cloud.state.velocity, cloud.state.temperature);
  // What is left of the forces without weight, drag, damping and friction is elastic; the rest dissipates.
  Model bare = model;
  bare.gravity = 0;
  bare.drag = {};
  for (ContactLaw* law : {&bare.contact, &bare.wall}) law->friction = law->damping = 0;
  const double elastic = -obvious_power(bare, cloud, 0.35);
  const double dissipated = powers.weight - elastic - obvious_power(model, cloud, 0.35);
  const double rounding = 1e-11 * (std::abs(elastic) + dissipated);
  EXPECT_GT(dissipated, 0.01 * std::abs(elastic)) << "there is something to see";
  EXPECT_NEAR(powers.elastic, elastic, rounding);
  EXPECT_NEAR(powers.dissipated, dissipated, rounding);
  EXPECT_EQ(powers.wall, 0);
}

TEST(Forces, PairForcesCancelInTheSum) {
  Model model = busy_model();
  model.gravity = 0;
  model.drag = {};
  model.wall.stiffness = 0;
  model.wall.softening.floor = 0;
  Cloud cloud = random_cloud(100, 0.3, 5);
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  std::vector<Vec3> force(cloud.particles.size());
  (void)network.forces(cloud.state.velocity, cloud.state.temperature, force);
  Vec3 sum;
  double scale = 0;
  for (const Vec3& f : force) {
    sum = sum + f;
    scale += norm(f);
  }
  ASSERT_GT(scale, 1);
  EXPECT_LE(norm(sum), 1e-15 * scale * 10) << "rounding";
}

TEST(Forces, ExplicitLimitIsThatOfAPairWhereItIsExact) {
  // Two equal spheres: k = d force/d distance, reduced mass m/2, plain stepping stable up to 2/sqrt(2 k/m).
  // The bound takes k as (p+1) F/(|E| L), 1/(1 - e/2) times the true slope's leading term.
  Model model = quiet_model();
  Cloud cloud;
  const double e = 0.01, r = 0.075;
  cloud.add({-r * (1 - e), 0, 0});
  cloud.add({r * (1 - e), 0, 0});
  MovingNetwork network(model, cloud.particles);
  network.resume(cloud.state, model.schedule.at(0));
  std::vector<Vec3> force(2);
  (void)network.forces(cloud.state.velocity, cloud.state.temperature, force, PairDetail::whole);
  const double dx = 1e-9, step = 2 * r * e;
  const auto force_at = [&](double overlap) {
    const double strain = overlap / (2 * r);
    return 1e7 * strain * strain * pair_area(2 * r - overlap, r, r);
  };
  const double k = (force_at(step + dx) - force_at(step - dx)) / (2 * dx);
  const double exact = 2 / std::sqrt(2 * k / cloud.particles.mass[0]);
  EXPECT_NEAR(network.explicit_limit(cloud.state.temperature) / exact, 1, 0.01)
      << "curvature of the area, e/4";
}

}  // namespace
}  // namespace superstep

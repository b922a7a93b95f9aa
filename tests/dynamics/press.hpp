#pragma once
/// Small presses for tests, and slow obvious counterparts of what the library does fast.

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "integrators/press/motion.hpp"

namespace superstep::test {

using namespace superstep::dynamics;

/// A model with everything switched off: no weight, drag, friction, damping, bonds, current or conduction.
inline Model quiet_model(double half_width = 1.0) {
  Model model;
  model.box = {{-half_width, -half_width, -half_width}, {half_width, half_width, half_width}};
  model.gravity = 0;
  model.contact.stiffness = model.wall.stiffness = 1e7;
  model.thermal.specific_heat = 100;
  model.thermal.wall_temperature.fill(300);
  model.skin = 0.02;
  Phase phase;
  phase.name = "all";
  phase.end = 1e9;
  phase.upper_wall_begin = phase.upper_wall = half_width;
  model.schedule = Schedule({phase});
  return model;
}

struct Cloud {
  Particles particles;
  State state;

  void add(Vec3 position, Vec3 velocity = {}, double radius = 0.075, double temperature = 300) {
    particles.id.push_back(static_cast<std::int64_t>(particles.size()));
    particles.radius.push_back(radius);
    particles.mass.push_back(2000 * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
    state.position.push_back(position);
    state.velocity.push_back(velocity);
    state.temperature.push_back(temperature);
    state.electric.push_back(0);
  }
};

/// Overlapping spheres at random, moving at random, of unequal sizes and temperatures.
inline Cloud random_cloud(std::size_t count, double half_width, std::uint64_t seed, double speed = 1.0) {
  Random random(seed);
  Cloud cloud;
  const auto point = [&](double reach) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
    return Vec3{x, y, random.uniform(-reach, reach)};
  };
  for (std::size_t k = 0; k < count; ++k) {
    const Vec3 position = point(half_width), velocity = point(speed);
    const double radius = random.uniform(0.05, 0.1);
    cloud.add(position, velocity, radius, random.uniform(300, 900));
  }
  return cloud;
}

inline SteppingSettings fixed_step(double step, double phi = 0.5, double tolerance = 1e-12) {
  SteppingSettings settings;
  settings.phi = phi;
  settings.first_step = settings.largest_step = step;
  settings.tolerance_position = settings.tolerance_temperature = tolerance;
  settings.iterations = 60;
  return settings;
}

inline Vec3 momentum(const Particles& particles, const State& state) {
  Vec3 sum;
  for (std::size_t i = 0; i < state.size(); ++i) sum = sum + particles.mass[i] * state.velocity[i];
  return sum;
}

inline double kinetic_energy(const Particles& particles, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += 0.5 * particles.mass[i] * dot(state.velocity[i], state.velocity[i]);
  return sum;
}

/// Energy of a contact of two equal spheres without softening, p = 2: the integral of K e^2 pi R^2 (2 e -
/// e^2) over the approach 2 R e.
inline double contact_energy(double stiffness, double radius, double strain) {
  return 2 * radius * stiffness * std::numbers::pi * radius * radius *
         (2 * std::pow(strain, 4) / 4 - std::pow(strain, 5) / 5);
}

}  // namespace superstep::test

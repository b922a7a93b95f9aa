#include "packing/relaxation/relax.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace superstep {

Vec3 confined(const Container& container, Vec3 centre, double radius) noexcept {
  const auto between = [radius](double x, double low, double high) {
    return std::min(std::max(x, low + radius), high - radius);
  };
  const double z = between(centre.z, 0.0, container.height);
  if (container.shape == Container::Shape::box)
    return {between(centre.x, -0.5 * container.width, 0.5 * container.width),
            between(centre.y, -0.5 * container.depth, 0.5 * container.depth), z};
  const double off_axis = std::sqrt(centre.x * centre.x + centre.y * centre.y);
  const double room = 0.5 * container.diameter - radius;
  const double shrink = off_axis > room ? room / off_axis : 1.0;
  return {shrink * centre.x, shrink * centre.y, z};
}

SoftSpheres::SoftSpheres(const Container& container, const std::vector<Vec3>& centres,
                         std::vector<double> final_radii)
    : container_(container),
      sphere_(centres.size()),
      final_radius_(std::move(final_radii)),
      velocity_(centres.size()),
      push_(centres.size()) {
  for (std::size_t k = 0; k < centres.size(); ++k) sphere_[k] = {centres[k], final_radius_[k]};
}

void SoftSpheres::grow_to(double scale) {
  for (std::size_t k = 0; k < sphere_.size(); ++k) {
    auto& [centre, radius] = sphere_[k];
    radius = scale * final_radius_[k];
    centre = confined(container_, centre, radius);
    velocity_[k] = {};
  }
}

void SoftSpheres::set_adhesion(const Adhesion& adhesion) {
  adhesion_ = adhesion;
  listed_.clear();
}

std::vector<Vec3> SoftSpheres::centres() const {
  std::vector<Vec3> out;
  out.reserve(sphere_.size());
  for (const auto& sphere : sphere_) out.push_back(sphere.centre);
  return out;
}

/// A pair that is not listed cannot have come within reach while every sphere's growth and motion stay inside
/// its margin.
bool SoftSpheres::pairs_are_stale() const noexcept {
  if (listed_.empty()) return true;
  const double grown = 1.0 + 0.5 * adhesion_.range;
  for (std::size_t k = 0; k < sphere_.size(); ++k) {
    const double moved = norm(sphere_[k].centre - listed_[k].centre);
    if (moved + grown * (sphere_[k].radius - listed_[k].radius) > margin_ * listed_[k].radius) return true;
  }
  return false;
}

void SoftSpheres::list_pairs() {
  listed_ = sphere_;
  std::vector<Vec3> centres;
  std::vector<double> reach;
  for (const auto& [centre, radius] : sphere_) {
    centres.push_back(centre);
    reach.push_back((1.0 + 0.5 * adhesion_.range + margin_) * radius);
  }
  pairs_ = near_pairs(centres, reach);
}

/// Repulsion > 0 between two spheres, and how fast it rises with the overlap.
SoftSpheres::Contact SoftSpheres::contact(double radius_i, double radius_j, double distance) const noexcept {
  const double smaller = std::min(radius_i, radius_j), overlap = radius_i + radius_j - distance;
  const double effective = 2.0 * radius_i * radius_j / (radius_i + radius_j);
  const double stiffness = effective * effective;
  if (overlap < 0) {
    // The pull fades to zero across the gap: a jump would keep spheres rattling.
    const double fade = 1.0 + overlap / (adhesion_.range * smaller);
    return {-stiffness * adhesion_.overlap * smaller * fade, stiffness};
  }
  // Once the smaller sphere's centre enters the larger one, a steep barrier keeps it from being swallowed.
  constexpr double barrier = 1000.0;
  const double inside = std::max(0.0, overlap / smaller - 1.0), factor = 1.0 + barrier * inside * inside;
  const double slope = factor + 2.0 * barrier * inside * overlap / smaller;
  return {stiffness * (factor * overlap - adhesion_.overlap * smaller), stiffness * slope};
}

/// Fills push_; returns the sum of the contact forces.
double SoftSpheres::sum_contact_forces() {
  std::fill(push_.begin(), push_.end(), Push{});
  double total = 0;
  for (const auto [first, second] : pairs_) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    const double radius_i = sphere_[i].radius, radius_j = sphere_[j].radius;
    const Vec3 between = sphere_[i].centre - sphere_[j].centre;
    const double reach = radius_i + radius_j + adhesion_.range * std::min(radius_i, radius_j);
    const double squared = dot(between, between);
    if (squared >= reach * reach) continue;
    const double distance = std::sqrt(squared);
    const auto [force, slope] = contact(radius_i, radius_j, distance);
    const Vec3 along = distance > 0 ? (force / distance) * between : Vec3{0, 0, force};
    push_[i].force = push_[i].force + along;
    push_[j].force = push_[j].force - along;
    push_[i].slope += slope;
    push_[j].slope += slope;
    total += std::abs(force);
  }
  return total;
}

/// One heavy-ball step, each sphere scaled by the slope of its own forces; when the motion as a whole runs
/// uphill it stops first. Returns the sum of the net forces, the walls' reaction included.
double SoftSpheres::move() {
  constexpr double momentum = 0.9;      // below 1; 0.9 to 0.98 measured alike
  constexpr double longest_move = 0.2;  // radii per step: nobody jumps over a neighbour
  double power = 0;
  for (std::size_t k = 0; k < sphere_.size(); ++k) power += dot(push_[k].force, velocity_[k]);
  double unbalanced = 0;
  for (std::size_t k = 0; k < sphere_.size(); ++k) {
    auto& [centre, radius] = sphere_[k];
    const auto& [force, slope] = push_[k];
    if (slope == 0) {
      velocity_[k] = {};
      continue;
    }
    const Vec3 fall = (1.0 / slope) * force;
    unbalanced += slope * norm(confined(container_, centre + fall, radius) - centre);
    Vec3 shift = power < 0 ? fall : momentum * velocity_[k] + fall;
    const double length = norm(shift);
    if (length > longest_move * radius) shift = (longest_move * radius / length) * shift;
    const Vec3 next = confined(container_, centre + shift, radius);
    velocity_[k] = next - centre;
    centre = next;
  }
  return unbalanced;
}

std::size_t SoftSpheres::relax(std::size_t steps, double tolerance) {
  for (std::size_t step = 1; step <= steps; ++step) {
    if (pairs_are_stale()) list_pairs();
    const double contact_forces = sum_contact_forces();
    const double net_forces = move();
    imbalance_ = contact_forces > 0 ? net_forces / contact_forces : 0.0;
    if (imbalance_ <= tolerance) return step;
  }
  return steps;
}

}  // namespace superstep

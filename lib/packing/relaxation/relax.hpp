#pragma once
/// Soft spheres in a container with hard walls: grown, pushed apart and, where they touch, drawn together.

#include <cstddef>
#include <vector>

#include "packing/generate.hpp"
#include "packing/near_pairs.hpp"

namespace superstep {

/// Nearest point to `centre` at which a sphere of that radius lies inside the container.
[[nodiscard]] Vec3 confined(const Container& container, Vec3 centre, double radius) noexcept;

/// Attraction between spheres that touch or nearly do; lengths are fractions of the smaller radius.
struct Adhesion {
  double overlap = 0;  ///< at which two lone spheres come to rest; 0 = no attraction
  double range = 0;    ///< gap up to which they feel each other
};

/// Spheres that repel each other with the force k h at overlap h, k = r_eff^2: small spheres are the softer
/// ones, as in sintered samples. Of k = 1, r_eff and r_eff^2 the last came nearest to the published spectrum
/// and conductivity of the sample of Rojek & Nisar (2026). Forces are in arbitrary units: only their balance
/// counts.
class SoftSpheres {
 public:
  /// centres, final_radii [m]; `grow_to` scales the radii.
  SoftSpheres(const Container& container, const std::vector<Vec3>& centres, std::vector<double> final_radii);

  /// Sets every radius to scale * final radius and stops all motion.
  void grow_to(double scale);
  void set_adhesion(const Adhesion& adhesion);

  /// Up to `steps` relaxation steps; fewer when the forces balance: sum of net forces < tolerance * sum of
  /// contact forces. Returns the number of steps taken.
  std::size_t relax(std::size_t steps, double tolerance);

  [[nodiscard]] std::vector<Vec3> centres() const;
  /// Sum of net forces / sum of contact forces at the last step.
  [[nodiscard]] double imbalance() const noexcept { return imbalance_; }

 private:
  struct Sphere {
    Vec3 centre;
    double radius;
  };
  struct Push {
    Vec3 force;
    double slope;  // of the forces of all contacts with their overlaps, summed
  };

  struct Contact {
    double force, slope;
  };

  [[nodiscard]] Contact contact(double radius_i, double radius_j, double distance) const noexcept;
  [[nodiscard]] bool pairs_are_stale() const noexcept;
  void list_pairs();
  double sum_contact_forces();
  double move();

  Container container_;
  Adhesion adhesion_;
  std::vector<Sphere> sphere_, listed_;  // now, and when the pairs were listed
  std::vector<double> final_radius_;
  std::vector<Vec3> velocity_;  // per step
  std::vector<Push> push_;
  std::vector<NearPair> pairs_;
  double imbalance_ = 0;
  double margin_ = 0.6;  // of each radius; wider lists more pairs, narrower lists them more often
};

}  // namespace superstep

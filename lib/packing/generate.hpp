#pragma once
/// Seeded generator of dense polydisperse packings in a cylinder or a box.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "packing/packing.hpp"

namespace superstep {

/// Container standing on z = 0; the cylinder's axis is x = y = 0, the box is centred on it.
struct Container {
  enum class Shape { cylinder, box };
  Shape shape = Shape::cylinder;
  double diameter = 0;          ///< m, cylinder
  double width = 0, depth = 0;  ///< m, box (x and y)
  double height = 0;            ///< m
  [[nodiscard]] double volume() const noexcept;
  [[nodiscard]] double cross_section() const noexcept;
};

/// Of ln(diameter): narrower, all spheres are equal; wider, the cut-offs are all there is.
inline constexpr double narrowest_sigma = 1e-3, widest_sigma = 10;

/// Distribution of sphere diameters [m].
struct SizeDistribution {
  enum class Kind { lognormal, uniform, list };
  Kind kind = Kind::uniform;
  double median = 0, sigma = 0;  ///< lognormal: median diameter [m], standard deviation of ln(diameter)
  double min = 0,
         max = 0;  ///< m, cut-offs of lognormal (the extreme spheres are just these), ends of uniform
  std::vector<double> diameters, weights;  ///< list: diameters [m] and number fractions (equal when empty)
};

struct PackSettings {
  Container container;
  SizeDistribution sizes;
  double relative_density = 0.64;  ///< sum of sphere volumes / container volume that the packing ends with
  std::size_t count = 0;  ///< 0 = as many as density and sizes ask for; else a lognormal's median is fitted
  /// Overlap, as a fraction of the smaller radius, at which two lone spheres that nearly touch are bonded in
  /// the end. Without bonds (0) many small spheres of a dense packing touch nothing, or by a hair that ruins
  /// the time scales.
  double bond_overlap = 0.03;
  std::uint64_t seed = 1;
};

/// How the packing came out.
struct PackReport {
  double relative_density = 0;
  double largest_overlap = 0;  ///< of min(r_i, r_j)
  std::size_t relaxation_steps = 0;
  double imbalance = 0;  ///< net forces left / contact forces
};

/// Random start at low density, then growth to the target density with overlap relaxation at each step;
/// positions are reproducible for one seed, compiler and machine type (other compilers may round
/// differently).
///   progress  called now and then with the fraction done; returning false stops with NumericalError
/// Throws UsageError for settings that cannot be met (with the rule), NumericalError when relaxation fails.
[[nodiscard]] Packing generate_packing(const PackSettings& settings, PackReport* report = nullptr,
                                       const std::function<bool(double)>& progress = {});

}  // namespace superstep

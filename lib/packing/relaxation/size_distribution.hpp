#pragma once
/// Diameters that represent a size distribution without the noise of random draws.

#include <cstddef>
#include <vector>

#include "packing/generate.hpp"

namespace superstep {

/// The (k + 1/2)/n quantiles, k = 0 ... n-1, ascending [m]. A lognormal's first and last are exactly its
/// cut-offs.
[[nodiscard]] std::vector<double> stratified_diameters(const SizeDistribution& sizes, std::size_t n);

/// Sum of the volumes of spheres of these diameters [m^3].
[[nodiscard]] double volume_of_diameters(const std::vector<double>& diameters);

/// The number n >= 1 of stratified diameters whose volume comes closest to `volume` [m^3]. Throws UsageError
/// beyond `largest_count`.
[[nodiscard]] std::size_t count_for_volume(const SizeDistribution& sizes, double volume,
                                           std::size_t largest_count);

/// Median [m] of a lognormal, between its cut-offs, at which n stratified diameters have this volume [m^3].
/// Throws UsageError when no such median exists.
[[nodiscard]] double median_for_volume(SizeDistribution sizes, std::size_t n, double volume);

}  // namespace superstep

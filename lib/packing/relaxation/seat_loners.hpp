#pragma once
/// The last few spheres that touch nothing.

#include <vector>

#include "packing/generate.hpp"

namespace superstep {

/// Moves each sphere without contact straight towards the nearest sphere that has one, until the two overlap
/// by `overlap` [of the smaller radius]; only across gaps up to the lone sphere's diameter. Does nothing in a
/// loose packing, where more than one sphere in twenty is alone.
void seat_loners(const Container& container, double overlap, const std::vector<double>& radii,
                 std::vector<Vec3>& centres);

}  // namespace superstep

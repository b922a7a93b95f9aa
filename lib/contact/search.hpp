#pragma once
/// Neighbour search in O(n) time and memory, for any spread of radii.

#include "contact/contact.hpp"

namespace superstep {

/// All pairs with overlap > -gap (gap [m] >= 0: bonds that bridge a gap). `neck_radius` is left empty.
/// In a periodic cell contacts reach across its sides; with `own_images` they include those of spheres with
/// images of their own (i = j), which exchange nothing but carry a mean flux. Throws InputError when one
/// sphere swallows another (names the packing's file, both ids and the way out).
[[nodiscard]] Contacts find_contacts(const Packing& packing, double gap = 0.0, bool own_images = false);

}  // namespace superstep

#pragma once
/// A scene whose rows several processes share: the root reads and cuts it, everybody gets what it owns.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "case/scene.hpp"
#include "parallel/communicator.hpp"
#include "parallel/packed.hpp"

namespace superstep {

/// What one process has of a scene.
struct ScenePart {
  std::unique_ptr<Rhs> rhs;
  std::vector<double> initial;  ///< [own entries]
  double entries = 0;           ///< of its networks
  std::uint64_t scene = 0;      ///< identity of the whole right-hand side, on the root
};

/// Whether the scene's rows can be shared. Where not, one process has to do all.
[[nodiscard]] bool can_be_shared(const Scene& scene);

/// On the root: sends every other process its part, and builds the own one.
[[nodiscard]] ScenePart share_out(const Scene& scene);
/// Elsewhere: the part that the root has sent.
[[nodiscard]] ScenePart take_part(Unpacker& in);

/// The entry of a whole state among those that are here; -1 = it is elsewhere.
[[nodiscard]] std::ptrdiff_t own_entry(const Rhs& part, std::size_t entry);
/// The whole state on the root, nothing elsewhere. Collective.
[[nodiscard]] std::vector<double> whole_state(const Rhs& part, std::span<const double> state);

}  // namespace superstep

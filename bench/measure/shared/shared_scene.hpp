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
  std::shared_ptr<Rhs> rhs;
  std::span<const double> initial;   ///< [own entries]
  std::vector<double> kept_initial;  ///< where nobody else keeps them
  double entries = 0;                ///< of its networks
  std::uint64_t scene = 0;           ///< identity of the scene's right-hand side, on the root

  bool in_parts = false;              ///< nobody has the whole
  std::shared_ptr<Scene> scene_here;  ///< then, but for the root: what this process has
  std::vector<double> final_state;    ///< and the state at the end of the last run
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

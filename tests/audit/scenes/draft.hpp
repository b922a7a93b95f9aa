#pragma once
/// A random scene while it is being drawn: its fields get conductances first, then the run its length, then
/// the fields what drives them.

#include <vector>

#include "audit/scenes/random_scene.hpp"
#include "audit/scenes/wiring.hpp"

namespace superstep::audit {

struct Draft {
  Random random;
  SceneWishes wishes;
  StatedScene scene;
  Wiring wiring;
  double offset = 0;       ///< K, lowest temperature that is stated
  double scale = 1;        ///< K, range of the temperatures that are stated
  double source_rise = 0;  ///< K that sources may add; 0 = there are none
  double joule_rise = 0;   ///< K that Joule heat may add
  bool at_rest = true;     ///< uniform start
  bool constant = false;   ///< no tables of time
  bool linear = true;      ///< sources may cool
  std::size_t most_points = 300;
  std::vector<double> moments;  ///< s, times within pulses, worth an output

  explicit Draft(std::uint64_t seed) : random(seed) {}
  [[nodiscard]] bool chance(double probability) { return random.uniform() < probability; }
  [[nodiscard]] std::int32_t any_node() {
    return static_cast<std::int32_t>(random.below(static_cast<std::size_t>(wiring.nodes)));
  }
  /// A temperature between offset and offset + scale [K].
  [[nodiscard]] double level() { return offset + scale * random.uniform(); }
  /// Highest temperature that laws have to cope with [K]; weak conduction where a law falls makes rises
  /// larger.
  [[nodiscard]] double highest() const { return offset + scale + 5 * source_rise + 8 * joule_rise; }
};

/// A graph on the draft's wiring without any input: ids, capacities, conductances.
///   contrast  of the conductances;  spread  of the capacities
[[nodiscard]] Graph bare_graph(Draft& draft, double contrast, double spread);

/// Conductivities of up to three materials. Varying ones stay positive from offset to `highest()`.
[[nodiscard]] ConductionLaws random_laws(Draft& draft, bool vary);

/// Exchange with surroundings; ambients may follow tables only once the run has a length, so `draw_inputs`
/// comes back to them.
void add_convection(Draft& draft, Graph& graph);
void add_radiation(Draft& draft, Graph& graph);
/// Start, fixed values, ambients and sources of a field whose conductances stand. The values are temperatures
/// of the draft; a potential alone takes the same numbers.
void draw_inputs(Draft& draft, std::size_t fixed_nodes, FieldScene& field);

/// The electric field: conductances first ...
[[nodiscard]] FieldScene bare_electric(Draft& draft, const Graph& thermal, bool vary, bool steady);
/// ... then electrodes and currents, as strong as `joule_rise` asks for.
void draw_electric_inputs(Draft& draft, const Graph& thermal, FieldScene& electric);

/// A table of the graph that goes from base to peak; its number.
std::int32_t add_table(Draft& draft, double base, double peak, Graph& graph);

}  // namespace superstep::audit

#pragma once
/// A scene: everything that a case file says, ready to integrate.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "case/case_head.hpp"
#include "contact/contact.hpp"
#include "contact/neck.hpp"
#include "network/eliminate.hpp"
#include "network/network.hpp"
#include "packing/packing.hpp"
#include "rhs/nonlinear_rhs.hpp"
#include "rhs/rhs.hpp"

namespace superstep {

class OwnNodes;

/// A node whose history is recorded: an entry of the state, or a constant (fixed and idle nodes).
struct Probe {
  std::string label;  ///< "mid-height" or the id
  std::int64_t id = 0;
  std::int32_t node = 0;  ///< position in the graph
};

/// Something that the scene does not need and therefore does not do.
struct Skip {
  std::string what, because;
};

/// Container of the packing, when the case states it: for relative density and effective conductivity.
struct CaseContainer {
  double cross_section = 0;  ///< m^2
  double height = 0;         ///< m
};

/// The packing's side of a scene; absent for a network given directly.
struct PackingScene {
  Packing packing;
  double length_unit = 1;  ///< m, of the packing file and of selections
  Contacts contacts;
  std::string neck;
  NeckReport neck_report;
  std::optional<CaseContainer> container;
};

/// One field of the scene on the user's nodes.
struct FieldScene {
  std::string name;             ///< "temperature" or "potential"
  std::string unit;             ///< "K" or "V"
  Graph graph;                  ///< the user's nodes and edges
  bool in_order = false;        ///< rows stand in the order of the nodes
  bool steady = false;          ///< solved for, not stepped: no part of the state
  ConductionLaws laws;          ///< conductivities; without materials for a network given directly
  std::vector<NodeRole> roles;  ///< [nodes]
  std::vector<double> bare;     ///< [edges] conductance from particle contributions only, where it differs
  std::vector<std::int32_t> row_of_node;  ///< [nodes] row in the field's network, -1 for fixed and idle nodes
  std::ptrdiff_t view = -1;               ///< index among the right-hand side's fields; -1 = not in the state
  std::size_t components = 0;             ///< connected components of the graph as stated
  std::size_t idle_clusters = 0;          ///< components in which nothing can change
  std::size_t floating_clusters = 0;      ///< components without a fixed node that are integrated
  std::size_t adrift_clusters = 0;        ///< those of them that exchange nothing with an ambient
  std::vector<std::string> warnings;      ///< about its materials
  std::vector<AlgebraicNode> algebraic;   ///< nodes of capacity 0, which are no part of the state
  double low = 0, high = 0;               ///< range of initial and fixed values
  double origin = 0;                      ///< K or V: entries of the state are differences from it

  /// Conductances from particle contributions only [edges].
  [[nodiscard]] std::span<const double> bare_conductance() const noexcept {
    return bare.empty() ? graph.conductance : bare;
  }
  /// The range of initial and fixed values as entries of the state have it.
  [[nodiscard]] FieldRange range_of_state() const noexcept { return {low - origin, high - origin}; }
};

struct Scene : CaseHead {
  /// Where processes build a scene together: the nodes that are here. Then the graph holds the probed nodes
  /// alone, and the right-hand side and its initial state are those of this process.
  std::shared_ptr<OwnNodes> own_nodes;
  std::string content_hash;  ///< of the case and its data files; empty = nobody asked
  std::optional<PackingScene> packed;
  std::vector<FieldScene> fields;
  std::unique_ptr<Rhs> rhs;
  std::vector<double> initial;               ///< [rhs->size()] state at t = 0; see FieldScene::origin
  std::vector<double> steady_potential;      ///< [nodes] V, of a steady potential that nothing moves
  NonlinearRhs* moving_potential = nullptr;  ///< solves for a steady potential that follows the state
  double settle_tolerance = 0;  ///< of the potential's span: steady enough not to be stepped on; 0 = never
  std::vector<Probe> probes;
  std::map<std::string, double> published;  ///< figures of the source to print beside ours
  std::vector<std::string> warnings;
  std::vector<Skip> skips;

  [[nodiscard]] std::size_t nodes() const noexcept;
  [[nodiscard]] std::size_t edges() const noexcept;  ///< contacts, of one field
  /// True where nodes are spheres.
  [[nodiscard]] bool has_places() const noexcept;
  /// Values of one field at time t on all nodes in the user's order [nodes]: computed, fixed and idle ones.
  [[nodiscard]] std::vector<double> values_on_nodes(std::size_t field, double t,
                                                    std::span<const double> state) const;
  /// Entry of the state that belongs to a node, or -1 when its value is fixed or idle.
  [[nodiscard]] std::ptrdiff_t entry_of_node(std::size_t field, std::int32_t node) const;

 private:
  [[nodiscard]] std::vector<double> steady_values(std::size_t field, double t,
                                                  std::span<const double> state) const;
};

/// Reads a case file and everything that it names, and builds the scene. Throws InputError.
[[nodiscard]] Scene load_scene(const std::string& path);
/// The same of a file that is parsed already; `root` then knows which keys were asked for.
[[nodiscard]] Scene load_scene(TomlTable root);

}  // namespace superstep

#pragma once
/// Where the layers of a scene come from that nobody has as a whole.

#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "core/text/toml.hpp"
#include "packing/packing.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

/// Nodes are spheres, numbered layer by layer. Spheres that touch stand in one layer or in neighbouring ones.
class LayerSource {
 public:
  virtual ~LayerSource() = default;

  /// Collective, before anything but `sample` is asked for. Throws InputError, on all processes the same.
  virtual void share(Communicator& /*among*/) {}
  /// Collective: layers [first, last), which differ from process to process, can be asked for from now on,
  /// and those brought before no longer.
  virtual void bring(std::int64_t /*first*/, std::int64_t /*last*/, Communicator& /*among*/) {}
  /// Layers [first, last) that this process looks at while it is not known yet whose they will be. They are
  /// there until `release`.
  [[nodiscard]] virtual std::pair<std::int64_t, std::int64_t> first_share(
      const Communicator& among) const = 0;
  virtual void release() {}

  [[nodiscard]] virtual std::int64_t layers() const = 0;
  /// Nodes of the layers before this one, which may be the one behind the last.
  [[nodiscard]] virtual std::int64_t nodes_before(std::int64_t layer) const = 0;
  [[nodiscard]] std::int64_t nodes() const { return nodes_before(layers()); }
  [[nodiscard]] std::int64_t layer_of_node(std::int64_t node) const;

  /// Spheres of layers [first, last), which know what they are a part of.
  [[nodiscard]] virtual Packing packing(std::int64_t first, std::int64_t last) const = 0;
  /// A few spheres that are read as all are: of the smallest and of the largest size.
  [[nodiscard]] virtual Packing sample() const = 0;
  /// Least distance [m] of centres in layers [first, last) from `point`, or less than that.
  [[nodiscard]] virtual double distance(std::int64_t first, std::int64_t last, Vec3 point) const = 0;
  /// Collective: the node of an id; -1 = nobody has it.
  [[nodiscard]] virtual std::int64_t node_of_id(std::int64_t id, Communicator& among) const = 0;
  /// Contacts that a sphere has at most, or about.
  [[nodiscard]] virtual std::size_t usual_contacts() const = 0;
  /// Whether all spheres hang together.
  [[nodiscard]] virtual bool is_one_cluster() const = 0;
  [[nodiscard]] virtual double length_unit() const = 0;  ///< m
  /// Where the spheres are named, for errors about them.
  [[nodiscard]] virtual const std::string& place() const = 0;
};

/// Of a case whose [packing] is a lattice, or a table that can be read in parts and whose order is "layers";
/// null for others, with `why_not` where the case wants layers. Reads the table's head. Throws InputError.
[[nodiscard]] std::unique_ptr<LayerSource> find_layer_source(TomlTable& packing, std::string& why_not);

}  // namespace superstep

#pragma once
/// Which node has an id: each id has a process that knows.

#include <cstdint>
#include <string>
#include <vector>

#include "case/network/parts/shared_nodes.hpp"

namespace superstep {

class NodeDirectory {
 public:
  /// Collective. Throws InputError where an id stands twice, on all processes the same.
  ///   path  of the nodes, for that
  NodeDirectory(const SharedNodes& nodes, const std::string& path, Communicator& among);

  /// The process that knows an id.
  [[nodiscard]] std::size_t process(std::int64_t id) const noexcept {
    return static_cast<std::uint64_t>(id) % processes_;
  }
  /// There: the number of its node; -1 = nobody has it.
  [[nodiscard]] std::int64_t node_of(std::int64_t id) const noexcept;

 private:
  struct Entry {
    std::int64_t id, node;
  };
  std::uint64_t processes_;
  std::vector<Entry> entries_;  // by their ids
};

}  // namespace superstep

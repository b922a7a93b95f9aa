#pragma once
/// Nodes of a network that several processes share: each reads a part of their file, and then has consecutive
/// ones, those of its rows and the fixed ones between them.

#include <cstdint>
#include <span>
#include <vector>

#include "core/text/rows_in_parts.hpp"
#include "network/files/network_rows.hpp"
#include "parallel/all_to_all.hpp"
#include "parallel/communicator.hpp"

namespace superstep {

struct SharedNode {
  std::int64_t id = 0;
  std::int64_t row = -1;  ///< of all; -1 where it is fixed
  double capacity = 0, source = 0, initial = 0;
  double fixed_value = 0;
  [[nodiscard]] bool is_fixed() const noexcept { return row < 0; }
};

/// Nodes are numbered in the order of the file.
class SharedNodes {
 public:
  /// Collective. Throws InputError and NeedsOneReader, on all processes the same.
  SharedNodes(const RowsInParts& table, Communicator& among);

  [[nodiscard]] std::int64_t count() const noexcept { return count_; }  ///< of the whole network
  [[nodiscard]] const Partition& rows() const noexcept { return rows_; }
  [[nodiscard]] double low() const noexcept { return low_; }    ///< of what is fixed or begins
  [[nodiscard]] double high() const noexcept { return high_; }  ///< likewise
  /// Nodes that are here.
  [[nodiscard]] const IndexRange& here() const noexcept {
    return ranges_[static_cast<std::size_t>(rows_.rank())];
  }
  [[nodiscard]] const std::vector<SharedNode>& own() const noexcept { return own_; }
  /// The process that has a node.
  [[nodiscard]] std::size_t owner(std::int64_t node) const noexcept {
    return range_that_holds(ranges_, node);
  }

  /// Collective: nodes by their numbers, which ascend.
  [[nodiscard]] std::vector<SharedNode> ask(std::span<const std::int64_t> nodes, Communicator& among) const;
  /// Collective: the number of the node with an id; -1 = nobody has it.
  [[nodiscard]] std::int64_t node_of_id(std::int64_t id, Communicator& among) const;
  /// From now on nobody asks for nodes.
  void release() noexcept { std::vector<SharedNode>().swap(own_); }

 private:
  /// What a process has read.
  struct Part {
    std::vector<NodeRow> nodes;
    std::int64_t first_node = 0, first_row = 0;  // numbers among all
  };
  void measure(const Part& part, Communicator& among);
  void find_ranges(const Part& part, Communicator& among);
  void hand_out(Part part, Communicator& among);

  std::int64_t count_ = 0;
  Partition rows_;
  double low_ = 0, high_ = 0;
  std::vector<IndexRange> ranges_;  // nodes of each process
  std::vector<SharedNode> own_;
};

}  // namespace superstep

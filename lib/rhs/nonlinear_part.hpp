#pragma once
/// Cuts a coupled or nonlinear scene into the parts that processes own.
///
/// Each field is cut by its own rows. A process also knows the nodes that its rows touch in either field:
/// their values come through a halo of their own.

#include <optional>
#include <vector>

#include "network/part.hpp"
#include "rhs/nonlinear_rhs.hpp"

namespace superstep {

struct FieldPart {
  NetworkPart network;                      ///< nodes are numbered as they are here
  FieldInput input;                         ///< all of it but the network and the halo of nodes
  std::int64_t rows = 0;                    ///< of the whole field
  std::vector<std::int64_t> rows_of_nodes;  ///< global rows of others that nodes here are, ascending
};

struct NonlinearPart {
  FieldPart temperature;
  std::optional<FieldPart> potential;
  std::optional<Graph> joule;               ///< branches that heat own rows; ends and conductances only
  std::vector<std::int64_t> order_of_node;  ///< see NonlinearInput
};

/// The part of one of several processes. The potential must be stepped, not solved for.
[[nodiscard]] NonlinearPart part_of(const NonlinearInput& whole, int processes, int rank, std::size_t block);

void pack(const NonlinearPart& part, Packer& out);
void unpack(Unpacker& in, NonlinearPart& part);

/// The right-hand side of a part. Collective.
[[nodiscard]] std::unique_ptr<NonlinearRhs> make_rhs(NonlinearPart part, Communicator& among,
                                                     std::size_t block);

}  // namespace superstep

#pragma once
/// Cuts a network into the parts that processes own.

#include <vector>

#include "network/network.hpp"
#include "parallel/all_to_all.hpp"
#include "parallel/packed.hpp"
#include "parallel/partition.hpp"

namespace superstep {

struct NetworkPart {
  Network network;                 ///< own rows only; its halo is not there yet
  std::vector<std::int64_t> halo;  ///< global rows that its columns beyond the own ones are
};

/// Some rows of a network; its halo are rows of the same network.
[[nodiscard]] NetworkPart rows_of(const Network& network, const IndexRange& rows);

/// The part of the process that `partition` is seen from.
[[nodiscard]] NetworkPart part_of(const Network& whole, const Partition& partition);

/// As bytes for the process that will own it.
void pack(const NetworkPart& part, Packer& out);
void unpack(Unpacker& in, NetworkPart& part);

}  // namespace superstep

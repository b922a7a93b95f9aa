#pragma once
/// Rows of neighbouring processes as networks that can be joined with one's own.

#include <cstddef>
#include <span>

#include "network/part.hpp"

namespace superstep {

/// Gives a neighbour its rows and takes its own.
[[nodiscard]] NetworkPart swap_rows(Communicator& among, int neighbour, const NetworkPart& given);

/// A part of rows to be joined with others: those from `first` to `last` are taken, with their entries.
struct RowsOfPart {
  const Network* rows = nullptr;
  std::size_t place = 0;  ///< of its first row among the joined ones
  std::size_t first = 0, last = 0;
};
/// One network of so many rows of capacity 1: the parts in ascending order, and empty rows between them.
[[nodiscard]] Network joined_rows(std::span<const RowsOfPart> parts, std::size_t rows);

}  // namespace superstep

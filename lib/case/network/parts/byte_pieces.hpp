#pragma once
/// Which bytes of a table a process reads, piece by piece.

#include <algorithm>
#include <cstdint>

#include "core/text/rows_in_parts.hpp"
#include "parallel/communicator.hpp"
#include "parallel/partition.hpp"

namespace superstep {

/// Pieces of a share, none of them so large that it would matter beside what is made of its rows.
class BytePieces {
 public:
  BytePieces(const RowsInParts& table, const Communicator& among)
      : begin_(begin_of_share(table.bytes(), among.rank(), among.size())),
        end_(begin_of_share(table.bytes(), among.rank() + 1, among.size())) {}

  [[nodiscard]] int count() const noexcept { return static_cast<int>((end_ - begin_ + most - 1) / most); }
  /// Where a piece begins; those behind the last are empty.
  [[nodiscard]] std::uint64_t begin(int piece) const noexcept {
    return std::min(begin_ + static_cast<std::uint64_t>(piece) * most, end_);
  }

 private:
  static constexpr std::uint64_t most = std::uint64_t{1} << 22;
  std::uint64_t begin_, end_;
};

}  // namespace superstep

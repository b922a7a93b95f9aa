#pragma once
/// Which process has which rows: consecutive cuts of the global order, a whole number of blocks each.
///
/// Blocks are fixed by the scene alone. What is added up is added up within blocks and then exactly, so that
/// nothing depends on who has which of them.

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace superstep {

/// Rows of a block, a multiple of eight; 0 = as usual. Set before the first scene is built; sums may differ
/// in their last bits between one number and another below 1024.
[[nodiscard]] std::size_t block_rows() noexcept;
void set_block_rows(std::size_t rows) noexcept;
/// What a wish, 0 = none, comes to among so many rows of a field.
[[nodiscard]] std::size_t block_rows_among(std::int64_t rows, std::size_t wish = block_rows()) noexcept;

/// Terms that are added up as they come before they enter an exact sum; blocks hold whole chunks.
[[nodiscard]] std::size_t chunk_rows() noexcept;

/// Where the share of a process begins, of `whole` things that are handed out evenly; of the one behind the
/// last: `whole`.
template <class Integer>
[[nodiscard]] constexpr Integer begin_of_share(Integer whole, int process, int processes) noexcept {
  const auto rank = static_cast<Integer>(process), all = static_cast<Integer>(processes);
  return whole / all * rank + whole % all * rank / all;
}

class Partition {
 public:
  Partition() = default;
  ///   block  rows of one, 0 = as usual
  Partition(std::int64_t rows, int processes, int rank, std::size_t block) noexcept
      : rows_(rows),
        block_(static_cast<std::int64_t>(block_rows_among(rows, block))),
        processes_(processes),
        rank_(rank) {}

  [[nodiscard]] std::int64_t rows() const noexcept { return rows_; }
  [[nodiscard]] int processes() const noexcept { return processes_; }
  [[nodiscard]] int rank() const noexcept { return rank_; }
  [[nodiscard]] std::int64_t blocks() const noexcept { return (rows_ + block_ - 1) / block_; }
  /// First row of a process; of the one behind the last: the number of rows.
  [[nodiscard]] std::int64_t first(int process) const noexcept {
    return std::min(rows_, blocks() * process / processes_ * block_);
  }
  [[nodiscard]] std::int64_t begin() const noexcept { return first(rank_); }
  [[nodiscard]] std::int64_t end() const noexcept { return first(rank_ + 1); }
  [[nodiscard]] std::size_t owned() const noexcept { return static_cast<std::size_t>(end() - begin()); }
  [[nodiscard]] bool owns(std::int64_t row) const noexcept { return row >= begin() && row < end(); }
  /// The process that has a row.
  [[nodiscard]] int owner(std::int64_t row) const noexcept {
    int low = 0, high = processes_;  // first(low) <= row < first(high)
    while (high - low > 1) {
      const int middle = low + (high - low) / 2;
      (first(middle) <= row ? low : high) = middle;
    }
    return low;
  }

 private:
  std::int64_t rows_ = 0, block_ = 1;
  int processes_ = 1, rank_ = 0;
};

}  // namespace superstep

#include "parallel/partition.hpp"

#include <numeric>

namespace superstep {
namespace {

std::size_t wished = 0;
constexpr std::size_t largest_chunk = 1024;

}  // namespace

std::size_t block_rows() noexcept {
  return wished;
}

void set_block_rows(std::size_t rows) noexcept {
  wished = rows;
}

std::size_t block_rows_among(std::int64_t rows, std::size_t wish) noexcept {
  if (wish > 0) return wish;
  // Large enough for a preconditioner of blocks, small enough for even shares.
  constexpr std::int64_t usual = 32'768, enough_blocks = 16, small = usual / 4;
  return static_cast<std::size_t>(rows > usual && rows < usual * enough_blocks ? small : usual);
}

std::size_t chunk_rows() noexcept {
  return wished == 0 ? largest_chunk : wished <= largest_chunk ? wished : std::gcd(wished, largest_chunk);
}

}  // namespace superstep

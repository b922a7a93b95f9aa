#include "parallel/partition.hpp"

#include <numeric>

namespace superstep {
namespace {

// Small enough to share 1e6 rows out evenly among 16 processes, large enough for chained sweeps.
std::size_t rows_of_block = 32'768;
constexpr std::size_t largest_chunk = 1024;

}  // namespace

std::size_t block_rows() noexcept {
  return rows_of_block;
}

void set_block_rows(std::size_t rows) noexcept {
  rows_of_block = rows;
}

std::size_t chunk_rows() noexcept {
  return rows_of_block <= largest_chunk ? rows_of_block : std::gcd(rows_of_block, largest_chunk);
}

}  // namespace superstep

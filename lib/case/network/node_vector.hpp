#pragma once
/// One value for each node of a network, from a number or a file.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace superstep {

struct NodeVector {
  std::vector<double> value;  ///< [n]
  std::vector<char> given;    ///< [n] 0 where the file says nothing
  bool is_sparse = false;     ///< of the Matrix Market, where what is not said is 0
};

/// Reads a vector of the Matrix Market, a column of numbers (one line for each node; nan = nothing), or a
/// table of two columns, id and value. Throws InputError for ids that are nobody's and vectors of another
/// length.
[[nodiscard]] NodeVector read_node_vector(const std::string& path, std::span<const std::int64_t> id);

}  // namespace superstep

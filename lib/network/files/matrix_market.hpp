#pragma once
/// Matrices and vectors in the Matrix Market's exchange format.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace superstep {

struct MatrixMarket {
  struct Entry {
    std::int32_t row, column;  ///< from 0
    double value;
    std::size_t line;
  };
  std::size_t rows = 0, columns = 0;
  bool is_dense = false;      ///< "array": every entry stands there
  bool is_symmetric = false;  ///< one triangle stands for both
  std::vector<Entry> entries;
  std::string warning;  ///< about the end of the file; empty where there is nothing to say
};

/// True for a text that begins with the format's banner.
[[nodiscard]] bool is_matrix_market(const std::string& text) noexcept;

/// Reads a real or integer matrix, general or symmetric, coordinates or dense. Throws InputError with file,
/// line, value and rule for anything else, for positions outside the matrix and for a wrong number of
/// entries.
[[nodiscard]] MatrixMarket read_matrix_market(const std::string& path);

/// A symmetric matrix by the entries of its lower triangle (row >= column).
[[nodiscard]] std::string matrix_market_text(std::size_t size, std::span<const MatrixMarket::Entry> lower,
                                             const std::string& comment);
/// A dense vector.
[[nodiscard]] std::string matrix_market_text(std::span<const double> vector, const std::string& comment);

}  // namespace superstep

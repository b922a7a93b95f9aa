#pragma once
/// Sparse Cholesky factorization by CHOLMOD of a symmetric positive definite matrix whose pattern stays.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace superstep {

class CholmodFactor {
 public:
  /// Analyses the pattern: upper triangle by compressed columns, [n+1] and [nnz] with rows ascending. CHOLMOD
  /// chooses among its orderings (AMD, METIS) and between a supernodal and a simplicial factor by the work
  /// that it predicts. Throws NumericalError when memory runs out.
  CholmodFactor(std::span<const std::int64_t> column_begin, std::span<const std::int64_t> row);
  ~CholmodFactor();
  CholmodFactor(const CholmodFactor&) = delete;
  CholmodFactor& operator=(const CholmodFactor&) = delete;

  /// Values of the pattern's entries [nnz], to be written before `factorize`.
  [[nodiscard]] std::span<double> values() noexcept;
  /// False when the matrix is not positive definite; a singular one may pass. Throws std::bad_alloc when
  /// memory runs out.
  [[nodiscard]] bool factorize();
  /// x [n] for b [n], which may be the same vector. False when memory runs out.
  [[nodiscard]] bool solve(std::span<const double> b, std::span<double> x);

  /// Entries of the factor.
  [[nodiscard]] std::size_t fill() const noexcept;
  /// As in "supernodal, metis".
  [[nodiscard]] std::string method() const;

 private:
  struct Handles;
  std::unique_ptr<Handles> handles_;
};

}  // namespace superstep

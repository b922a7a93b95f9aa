#pragma once
/// What the micro benchmarks run on.

#include <Eigen/Sparse>
#include <vector>

#include "case/scene.hpp"
#include "core/aligned_array.hpp"
#include "network/network.hpp"
#include "packing/packing.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep::micro {

/// side^3 nodes of a cubic lattice with bonds to the six nearest and, at every fourth node, to one more on a
/// diagonal: 6 to 8 neighbours as in a packing. Nodes in random order, as a simulation leaves them.
[[nodiscard]] Graph lattice_graph(std::int32_t side);
/// The same as spheres that touch.
[[nodiscard]] Packing lattice_packing(std::int32_t side);
/// The thermal case of the source paper.
[[nodiscard]] const Scene& nial_thermal();

/// Compressed rows C^-1 K without its diagonal.
struct Rows {
  std::vector<std::int64_t> begin;
  std::vector<std::int32_t> column;
  std::vector<double> rate;

  [[nodiscard]] std::size_t size() const noexcept { return begin.size() - 1; }
  [[nodiscard]] std::size_t nonzeros() const noexcept { return column.size(); }
  [[nodiscard]] SweepRows view() const noexcept { return {begin, column, rate}; }
};
/// In the order that integrators use.
[[nodiscard]] Rows ordered_rows(const Network& network);
/// In the order of the file.
[[nodiscard]] Rows rows_in_file_order(const Graph& graph, const Network& network);
[[nodiscard]] SlicedRows sliced(const Rows& rows);
/// With its diagonal, 32-bit indices: what a user of Eigen would write.
using EigenMatrix = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int32_t>;
[[nodiscard]] EigenMatrix eigen_matrix(const Rows& rows);

/// a = b + s c over arrays far beyond the cache. Source: McCalpin (1995), STREAM.
class Triad {
 public:
  explicit Triad(std::size_t size = std::size_t{1} << 24);
  void run() noexcept;
  [[nodiscard]] double bytes() const noexcept { return 24.0 * static_cast<double>(size_); }

 private:
  std::size_t size_;
  AlignedArray<double> a_, b_, c_;
};

}  // namespace superstep::micro

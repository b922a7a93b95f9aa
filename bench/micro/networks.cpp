#include "bench/micro/networks.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include "core/parallel.hpp"

namespace superstep::micro {
namespace {

/// Position in the file of every lattice site.
std::vector<std::int32_t> random_order(std::size_t count) {
  std::vector<std::int32_t> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), std::mt19937_64(1));
  return order;
}

}  // namespace

Graph lattice_graph(std::int32_t side) {
  const std::int32_t layer = side * side, size = layer * side;
  const auto count = static_cast<std::size_t>(size);
  const auto place = random_order(count);
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> factor(0.5, 2.0);
  Graph graph;
  graph.id.resize(count);
  std::iota(graph.id.begin(), graph.id.end(), 0);
  graph.capacity.assign(count, 1.0);
  graph.source.assign(count, 0.0);
  graph.initial.assign(count, 300.0);
  graph.fixed_value.assign(count, 0.0);
  graph.is_fixed.assign(count, 0);
  for (std::int32_t site = 0; site < size; ++site) {
    const std::int32_t x = site % side, y = site / side % side, z = site / layer;
    const auto join = [&](bool there, std::int32_t other) {
      if (!there) return;
      graph.i.push_back(place[static_cast<std::size_t>(site)]);
      graph.j.push_back(place[static_cast<std::size_t>(other)]);
      graph.conductance.push_back(factor(random));
    };
    join(x + 1 < side, site + 1);
    join(y + 1 < side, site + side);
    join(z + 1 < side, site + layer);
    join(random() % 4 == 0 && x + 1 < side && y + 1 < side, site + 1 + side);
  }
  return graph;
}

Packing lattice_packing(std::int32_t side) {
  const std::int32_t layer = side * side, size = layer * side;
  const auto place = random_order(static_cast<std::size_t>(size));
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> jitter(-0.01, 0.01);
  Packing packing;
  packing.id.resize(static_cast<std::size_t>(size));
  std::iota(packing.id.begin(), packing.id.end(), 0);
  packing.centre.resize(packing.id.size());
  packing.radius.assign(packing.id.size(), 0.52);
  packing.material.assign(packing.id.size(), 0);
  for (std::int32_t site = 0; site < size; ++site)
    packing.centre[static_cast<std::size_t>(place[static_cast<std::size_t>(site)])] = {
        site % side + jitter(random), site / side % side + jitter(random), site / layer + jitter(random)};
  return packing;
}

const Scene& nial_thermal() {
  static const Scene scene = load_scene(SUPERSTEP_SOURCE_DIR "/cases/nial_thermal.toml");
  return scene;
}

Rows ordered_rows(const Network& network) {
  Rows rows{network.row_begin, network.column, network.conductance};
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (auto k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
      rows.rate[static_cast<std::size_t>(k)] /= network.capacity[i];
  return rows;
}

Rows rows_in_file_order(const Graph& graph, const Network& network) {
  std::vector<std::int32_t> rank(network.size());  // of a row among the free nodes of the file
  std::vector<std::int32_t> row_of_rank;
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (const auto row = network.row_of_node[node]; row >= 0) {
      rank[static_cast<std::size_t>(row)] = static_cast<std::int32_t>(row_of_rank.size());
      row_of_rank.push_back(row);
    }
  Rows rows{{0}, {}, {}};
  std::vector<std::pair<std::int32_t, double>> entries;
  for (const auto row : row_of_rank) {
    const auto i = static_cast<std::size_t>(row);
    entries.clear();
    for (auto k = static_cast<std::size_t>(network.row_begin[i]);
         k < static_cast<std::size_t>(network.row_begin[i + 1]); ++k)
      entries.emplace_back(rank[static_cast<std::size_t>(network.column[k])],
                           network.conductance[k] / network.capacity[i]);
    std::sort(entries.begin(), entries.end());
    for (const auto& [column, rate] : entries) {
      rows.column.push_back(column);
      rows.rate.push_back(rate);
    }
    rows.begin.push_back(static_cast<std::int64_t>(rows.column.size()));
  }
  return rows;
}

SlicedRows sliced(const Rows& rows) {
  SlicedRows out(rows.begin, rows.column);
  out.set_values(rows.begin, [&](std::size_t, std::size_t k) { return rows.rate[k]; });
  return out;
}

EigenMatrix eigen_matrix(const Rows& rows) {
  const auto n = static_cast<Eigen::Index>(rows.size());
  EigenMatrix matrix(n, n);
  matrix.reserve(static_cast<Eigen::Index>(rows.nonzeros() + rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    matrix.startVec(static_cast<Eigen::Index>(i));
    double diagonal = 0;
    for (auto k = rows.begin[i]; k < rows.begin[i + 1]; ++k)
      diagonal -= rows.rate[static_cast<std::size_t>(k)];
    bool placed = false;
    const auto put = [&](std::int32_t column, double value) {
      matrix.insertBack(static_cast<Eigen::Index>(i), column) = value;
    };
    for (auto k = static_cast<std::size_t>(rows.begin[i]); k < static_cast<std::size_t>(rows.begin[i + 1]);
         ++k) {
      if (!placed && rows.column[k] > static_cast<std::int32_t>(i)) {
        put(static_cast<std::int32_t>(i), diagonal);
        placed = true;
      }
      put(rows.column[k], rows.rate[k]);
    }
    if (!placed) put(static_cast<std::int32_t>(i), diagonal);
  }
  matrix.finalize();
  return matrix;
}

Triad::Triad(std::size_t size)
    : size_(size),
      a_(aligned_array<double>(size)),
      b_(aligned_array<double>(size)),
      c_(aligned_array<double>(size)) {
  for_each_entry(size, [&](std::size_t i) {
    a_[i] = 0;
    b_[i] = 1;
    c_[i] = 2;
  });
}

namespace {

/// As wide as the machine's registers: what the sweep is measured against must be as good as it gets.
__attribute__((target_clones("avx512f", "avx2", "default"))) void triad(double* __restrict__ a,
                                                                        const double* __restrict__ b,
                                                                        const double* __restrict__ c,
                                                                        std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) a[i] = b[i] + 0.5 * c[i];
}

}  // namespace

void Triad::run() noexcept {
  for_ranges(size_, size_, [&](std::size_t first, std::size_t last) {
    triad(a_.get() + first, b_.get() + first, c_.get() + first, last - first);
  });
}

}  // namespace superstep::micro

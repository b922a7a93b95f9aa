/// Cost per particle and sweep over network size, everything in turn within each round:
///   cost_per_particle CSV SVG [LARGEST_SIDE]     lattices of side^3 nodes, default up to 100^3
/// Besides the fused sweep chains of stages that pass over the network together, the reference kernel,
/// Eigen's product and update in the order of the network and in that of the file, and the STREAM triad;
/// sweep, chain and triad on all threads too, unless other programs keep the machine busy.

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "bench/micro/networks.hpp"
#include "core/atomic_file.hpp"
#include "core/stopwatch.hpp"
#include "rhs/kernels/field_operator.hpp"

namespace superstep::micro {
namespace {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// Pieces of work that take turns; seconds per call. Those on one thread by CPU time, which other programs on
/// the machine do not lengthen much; quotients between numbers of threads by wall time.
class Rounds {
 public:
  void add(std::string name, int threads, std::function<void()> work) {
    pieces_.push_back({std::move(name), threads, std::move(work), {}, {}, 1});
  }
  void run(int rounds, double seconds_per_turn) {
    for (auto& piece : pieces_) {
      turn(piece);
      const double seconds = piece.wall.back();
      piece.calls = std::clamp(static_cast<int>(seconds_per_turn / seconds), 1, 100'000);
      piece.wall.clear();
      piece.cpu.clear();
    }
    for (int round = 0; round < rounds; ++round)
      for (auto& piece : pieces_) turn(piece);
  }
  /// CPU time, median over rounds.
  [[nodiscard]] double seconds(const std::string& name) const { return median(find(name).cpu); }
  /// Median over rounds of the quotient of two pieces: noise that lasts longer than a round drops out.
  [[nodiscard]] double cpu_ratio(const std::string& over, const std::string& under) const {
    return median(quotients(find(over).cpu, find(under).cpu));
  }
  [[nodiscard]] double wall_ratio(const std::string& over, const std::string& under) const {
    return median(quotients(find(over).wall, find(under).wall));
  }
  /// How much better the first pair scales than the second: median of the quotients of each round.
  [[nodiscard]] double wall_ratio_over(const std::string& over, const std::string& under,
                                       const std::string& other_over, const std::string& other_under) const {
    return median(quotients(quotients(find(over).wall, find(under).wall),
                            quotients(find(other_over).wall, find(other_under).wall)));
  }

 private:
  struct Piece {
    std::string name;
    int threads;
    std::function<void()> work;
    std::vector<double> cpu, wall;
    int calls;
  };

  static void turn(Piece& piece) {
    omp_set_num_threads(piece.threads);
    piece.work();  // what the one before left in the cache is not ours
    const double wall = wall_seconds(), cpu = process_cpu_seconds();
    for (int k = 0; k < piece.calls; ++k) piece.work();
    piece.cpu.push_back((process_cpu_seconds() - cpu) / piece.calls);
    piece.wall.push_back((wall_seconds() - wall) / piece.calls);
  }
  static std::vector<double> quotients(const std::vector<double>& over, const std::vector<double>& under) {
    std::vector<double> out;
    for (std::size_t k = 0; k < over.size(); ++k) out.push_back(over[k] / under[k]);
    return out;
  }
  [[nodiscard]] const Piece& find(const std::string& name) const {
    return *std::find_if(pieces_.begin(), pieces_.end(), [&](const auto& p) { return p.name == name; });
  }
  std::vector<Piece> pieces_;
};

struct Point {
  std::string network;
  std::size_t particles, nonzeros, entries;
  double ns_per_particle, ns_per_nonzero, gb_per_s, triad_gb_per_s, triad_fraction;
  double eigen, eigen_file_order, reference;  ///< times as slow as the fused sweep
  std::size_t chain_depth;                    ///< stages that pass over the network together
  double chain_ns_per_nonzero;                ///< and stage
  int threads;
  // 0 = not measured
  double thread_speedup, chain_thread_speedup, triad_thread_speedup;
  double scaling_over_triad;  ///< of the sweep, over that of the triad in the same round
};

void eigen_stage(const EigenMatrix& matrix, const Stage& stage, double* out) {
  const auto n = matrix.rows();
  const Eigen::Map<const Eigen::VectorXd> y1(stage.y1, n), y2(stage.y2, n);
  Eigen::Map<Eigen::VectorXd> result(out, n);
  result.noalias() = matrix * y1;
  result = stage.a * y1 + stage.b * y2 + stage.d * result;
}

/// A chain of Chebyshev stages, as long as chains get.
class Chain {
 public:
  explicit Chain(const Network& network) : field_(network), u_(network.size(), 300.0), next_(u_) {
    for (std::size_t k = 0; k < stages_.size(); ++k) {
      stages_[k] = {.stage = {.y1 = u_.data(), .a = 2, .d = 1e-12, .y2 = next_.data(), .b = -1},
                    .out = next_.data()};
      std::swap(u_, next_);
    }
  }
  void run() { field_.chain(stages_, false, {}, nullptr); }
  [[nodiscard]] std::size_t depth() const { return field_.chain_depth(); }
  [[nodiscard]] static double length() { return static_cast<double>(longest_chain); }

 private:
  FieldOperator field_;
  std::vector<double> u_, next_;
  std::array<ChainedStage, longest_chain> stages_;
};

/// Threads that wait for one another show how busy the machine is, not how they scale, when others use it.
bool machine_is_quiet() {
  double load = 0;
  return getloadavg(&load, 1) == 1 && load < 1.3;  // this program itself counts as 1
}

Point measure(const std::string& name, const Graph& graph, const Network& network, Triad& triad) {
  const int all_threads = omp_get_num_procs();
  omp_set_num_threads(all_threads);
  const Rows rows = ordered_rows(network), shuffled = rows_in_file_order(graph, network);
  const SlicedRows sell = sliced(rows);
  const EigenMatrix eigen = eigen_matrix(rows), eigen_shuffled = eigen_matrix(shuffled);
  std::vector<double> y1(rows.size(), 300.0), y2(rows.size(), 301.0), out(rows.size());
  const Stage stage{.y1 = y1.data(), .a = 1.2, .d = 1e-12, .y2 = y2.data(), .b = -0.2};

  Chain chain(network);
  omp_set_num_threads(1);
  const std::size_t depth = chain.depth();
  Rounds rounds;
  rounds.add("sweep", 1, [&] { fused_sweep(sell, stage, out.data()); });
  rounds.add("triad", 1, [&] { triad.run(); });
  rounds.add("chain", 1, [&] { chain.run(); });
  rounds.add("eigen", 1, [&] { eigen_stage(eigen, stage, out.data()); });
  rounds.add("eigen, file order", 1, [&] { eigen_stage(eigen_shuffled, stage, out.data()); });
  rounds.add("reference", 1, [&] { reference_sweep(rows.view(), stage, out.data()); });
  rounds.run(15, 0.02);
  // Apart from the others: threads that wait for work burn CPU time for some milliseconds.
  const bool scaling = machine_is_quiet();
  Rounds teams;
  teams.add("sweep", 1, [&] { fused_sweep(sell, stage, out.data()); });
  teams.add("triad", 1, [&] { triad.run(); });
  teams.add("chain", 1, [&] { chain.run(); });
  teams.add("chain, all threads", all_threads, [&] { chain.run(); });
  teams.add("sweep, all threads", all_threads, [&] { fused_sweep(sell, stage, out.data()); });
  teams.add("triad, all threads", all_threads, [&] { triad.run(); });
  if (scaling) teams.run(15, 0.02);

  const double bytes = 12.0 * static_cast<double>(sell.entries()) + 24.0 * static_cast<double>(rows.size());
  const double sweep = rounds.seconds("sweep");
  Point point{
      .network = name,
      .particles = rows.size(),
      .nonzeros = rows.nonzeros(),
      .entries = sell.entries(),
      .ns_per_particle = 1e9 * sweep / static_cast<double>(rows.size()),
      .ns_per_nonzero = 1e9 * sweep / static_cast<double>(rows.nonzeros()),
      .gb_per_s = 1e-9 * bytes / sweep,
      .triad_gb_per_s = 1e-9 * triad.bytes() / rounds.seconds("triad"),
      .triad_fraction = rounds.cpu_ratio("triad", "sweep") * bytes / triad.bytes(),
      .eigen = rounds.cpu_ratio("eigen", "sweep"),
      .eigen_file_order = rounds.cpu_ratio("eigen, file order", "sweep"),
      .reference = rounds.cpu_ratio("reference", "sweep"),
      .chain_depth = depth,
      .chain_ns_per_nonzero =
          1e9 * rounds.seconds("chain") / Chain::length() / static_cast<double>(rows.nonzeros()),
      .threads = all_threads,
      .thread_speedup = scaling ? teams.wall_ratio("sweep", "sweep, all threads") : 0,
      .chain_thread_speedup = scaling ? teams.wall_ratio("chain", "chain, all threads") : 0,
      .triad_thread_speedup = scaling ? teams.wall_ratio("triad", "triad, all threads") : 0,
      .scaling_over_triad =
          scaling ? teams.wall_ratio_over("sweep", "sweep, all threads", "triad", "triad, all threads") : 0};
  return point;
}

std::string cell(double value) {
  return value > 0 ? fmt::format("{:.3g}", value) : "";
}

std::string csv(const std::vector<Point>& points) {
  std::string out =
      "network,particles,nonzeros,stored_entries,ns_per_particle,ns_per_nonzero,gb_per_s,triad_gb_per_s,"
      "triad_fraction,eigen_over_sweep,eigen_file_order_over_sweep,reference_over_sweep,chain_depth,"
      "chain_ns_per_nonzero,threads,thread_speedup,chain_thread_speedup,triad_thread_speedup,"
      "scaling_over_triad\n";
  for (const auto& p : points)
    out += fmt::format(
        "{},{},{},{},{:.4g},{:.4g},{:.4g},{:.4g},{:.3g},{:.3g},{:.3g},{:.3g},{},{:.4g},{},{},{},{},{}\n",
        p.network, p.particles, p.nonzeros, p.entries, p.ns_per_particle, p.ns_per_nonzero, p.gb_per_s,
        p.triad_gb_per_s, p.triad_fraction, p.eigen, p.eigen_file_order, p.reference, p.chain_depth,
        p.chain_ns_per_nonzero, p.threads, cell(p.thread_speedup), cell(p.chain_thread_speedup),
        cell(p.triad_thread_speedup), cell(p.scaling_over_triad));
  return out;
}

/// Nanoseconds per nonzero over particles, logarithmic both ways.
class Figure {
 public:
  Figure(double smallest, double largest) : low_(std::log10(smallest)), high_(std::log10(largest)) {}

  void curve(const std::string& label, const std::string& color,
             const std::vector<std::pair<double, double>>& points) {
    std::string line;
    for (const auto& [particles, ns] : points) {
      line += fmt::format("{:.1f},{:.1f} ", x(particles), y(ns));
      body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3\" fill=\"{}\"/>\n", x(particles), y(ns),
                           color);
    }
    body_ += fmt::format(
        "<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" fill=\"{}\">{}</text>\n",
        line, color, x(points.back().first) + 8, y(points.back().second) + 4, color, label);
  }

  [[nodiscard]] std::string text() const {
    std::string axes;
    for (int decade = static_cast<int>(std::ceil(low_)); decade <= static_cast<int>(high_); ++decade)
      axes += fmt::format(
          "<line x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"20\" y2=\"300\" stroke=\"#ddd\"/>"
          "<text x=\"{0:.1f}\" y=\"318\" text-anchor=\"middle\">1e{1}</text>\n",
          x(std::pow(10, decade)), decade);
    for (const double ns : {0.1, 0.2, 0.5, 1.0, 2.0, 5.0})
      axes += fmt::format(
          "<line x1=\"60\" x2=\"460\" y1=\"{0:.1f}\" y2=\"{0:.1f}\" stroke=\"#ddd\"/>"
          "<text x=\"54\" y=\"{1:.1f}\" text-anchor=\"end\">{2:g}</text>\n",
          y(ns), y(ns) + 4, ns);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 620 350\" font-family=\"sans-serif\" "
        "font-size=\"11\">\n<rect width=\"620\" height=\"350\" fill=\"white\"/>\n{}{}"
        "<text x=\"260\" y=\"340\" text-anchor=\"middle\">particles</text>\n"
        "<text x=\"60\" y=\"14\">CPU ns per nonzero and sweep, one thread</text>\n</svg>\n",
        axes, body_);
  }

 private:
  [[nodiscard]] double x(double particles) const {
    return 60 + 400 * (std::log10(particles) - low_) / (high_ - low_);
  }
  [[nodiscard]] static double y(double ns) { return 300 - 280 * (std::log10(ns) + 1) / std::log10(80.0); }

  double low_, high_;
  std::string body_;
};

std::string svg(const std::vector<Point>& points) {
  std::vector<std::pair<double, double>> sweep, chain, eigen, shuffled;
  for (const auto& p : points) {
    if (p.network != "lattice") continue;
    const auto n = static_cast<double>(p.particles);
    sweep.emplace_back(n, p.ns_per_nonzero);
    chain.emplace_back(n, p.chain_ns_per_nonzero);
    eigen.emplace_back(n, p.ns_per_nonzero * p.eigen);
    shuffled.emplace_back(n, p.ns_per_nonzero * p.eigen_file_order);
  }
  Figure figure(sweep.front().first * 0.9, sweep.back().first);
  figure.curve("stages together", "#93c", chain);
  figure.curve("fused sweep", "#0b6", sweep);
  figure.curve("Eigen", "#06b", eigen);
  figure.curve("Eigen, file order", "#b40", shuffled);
  return figure.text();
}

void show(const Point& p) {
  fmt::print(
      stderr,
      "{} {} particles: {:.3g} ns/nonzero, {:.3g} GB/s, {:.2g} of the triad; {} stages together {:.3g}\n",
      p.network, p.particles, p.ns_per_nonzero, p.gb_per_s, p.triad_fraction, p.chain_depth,
      p.chain_ns_per_nonzero);
}

int run(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: cost_per_particle CSV SVG [LARGEST_SIDE]\n");
    return 2;
  }
  const int largest = argc > 3 ? std::atoi(argv[3]) : 100;
  Triad triad;
  std::vector<Point> points;
  const auto& nial = nial_thermal();
  const auto& field = nial.fields.front();
  points.push_back(measure("nial_thermal", field.graph, build_network(field.graph, field.roles), triad));
  show(points.back());
  for (const int side : {22, 32, 46, 68, 100, 147, 215}) {
    if (side > largest) break;
    const Graph graph = lattice_graph(side);
    const Network network = build_network(graph, std::vector<NodeRole>(graph.nodes(), NodeRole::free));
    points.push_back(measure("lattice", graph, network, triad));
    show(points.back());
  }
  write_file_atomically(argv[1], csv(points));
  write_file_atomically(argv[2], svg(points));
  return 0;
}

}  // namespace
}  // namespace superstep::micro

int main(int argc, char** argv) {
  return superstep::micro::run(argc, argv);
}

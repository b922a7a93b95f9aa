#include "support/problem.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "integrators/registry.hpp"

namespace superstep::test {

Problem::Problem(Graph g) : graph(std::move(g)) {
  const auto roles = plain_roles(graph);
  Network network = build_network(graph, roles);
  for (const auto node : network.node_of_row)
    initial.push_back(graph.initial[static_cast<std::size_t>(node)]);
  rhs = std::make_unique<NetworkRhs>(std::move(network), "temperature", "K",
                                     min_pair_step(graph, roles, graph.conductance));
}

Plan Problem::plan(std::vector<double> output_times) const {
  FieldRange range{graph.initial[0], graph.initial[0]};
  for (std::size_t k = 0; k < graph.nodes(); ++k) {
    const double value = graph.is_fixed[k] ? graph.fixed_value[k] : graph.initial[k];
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges) {
      range.low = std::min(range.low, exchange.ambient);
      range.high = std::max(range.high, exchange.ambient);
    }
  for (const auto& table : graph.tables) {
    range.low = std::min(range.low, table.lowest());
    range.high = std::max(range.high, table.highest());
  }
  Plan plan;
  plan.output_times = std::move(output_times);
  plan.ranges = {range};
  return plan;
}

std::vector<double> Problem::dense_matrix() const {
  const auto& rows = rhs->network().row_of_node;
  const std::size_t n = rhs->size();
  std::vector<double> a(n * n, 0.0);
  const auto add = [&](std::int32_t from, std::int32_t to, double k) {
    const auto i = rows[static_cast<std::size_t>(from)], j = rows[static_cast<std::size_t>(to)];
    if (i < 0) return;
    const double scaled = k / graph.capacity[static_cast<std::size_t>(from)];
    a[static_cast<std::size_t>(i) * n + static_cast<std::size_t>(i)] += scaled;
    if (j >= 0) a[static_cast<std::size_t>(i) * n + static_cast<std::size_t>(j)] -= scaled;
  };
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    add(graph.i[k], graph.j[k], graph.conductance[k]);
    add(graph.j[k], graph.i[k], graph.conductance[k]);
  }
  return a;
}

std::vector<double> Problem::exact(double t) const {
  const auto n = static_cast<Eigen::Index>(rhs->size());
  const auto dense = dense_matrix();
  const auto& rows = rhs->network().row_of_node;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n), root(n);
  for (Eigen::Index i = 0; i < n; ++i) root(i) = std::sqrt(rhs->capacities()[static_cast<std::size_t>(i)]);
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (rows[node] >= 0) b(rows[node]) += graph.source[node] / graph.capacity[node];
  for (std::size_t k = 0; k < graph.edges(); ++k)
    for (const auto& [from, to] : {std::pair(graph.i[k], graph.j[k]), std::pair(graph.j[k], graph.i[k])}) {
      const auto free = static_cast<std::size_t>(from), other = static_cast<std::size_t>(to);
      if (rows[free] >= 0 && rows[other] < 0)
        b(rows[free]) += graph.conductance[k] / graph.capacity[free] * graph.fixed_value[other];
    }
  Eigen::MatrixXd s(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      s(i, j) = root(i) * dense[static_cast<std::size_t>(i * n + j)] / root(j);
  const Eigen::MatrixXd symmetric = 0.5 * (s + s.transpose());
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric);
  const Eigen::Map<const Eigen::VectorXd> y0(initial.data(), n);
  Eigen::VectorXd modes = solver.eigenvectors().transpose() * root.cwiseProduct(y0);
  const Eigen::VectorXd drive = solver.eigenvectors().transpose() * root.cwiseProduct(b);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double lambda = std::max(0.0, solver.eigenvalues()(k)), z = lambda * t;
    const double phi = z > 1e-12 ? -std::expm1(-z) / lambda : t;
    modes(k) = std::exp(-z) * modes(k) + phi * drive(k);
  }
  const Eigen::VectorXd y = (solver.eigenvectors() * modes).cwiseQuotient(root);
  return {y.data(), y.data() + n};
}

std::vector<double> Problem::by_id(const std::vector<double>& state) const {
  std::map<std::int64_t, double> values;
  const auto& nodes = rhs->network().node_of_row;
  for (std::size_t row = 0; row < nodes.size(); ++row)
    values[graph.id[static_cast<std::size_t>(nodes[row])]] = state[row];
  std::vector<double> out;
  for (const auto& [id, value] : values) out.push_back(value);
  return out;
}

Run run(const std::string& spec, Problem& problem, std::vector<double> output_times) {
  Run result;
  result.history = ProbeHistory(1);
  Plan plan = problem.plan(output_times);
  plan.track_inflow = true;
  plan.probes = {0};
  plan.history = &result.history;
  const auto before = problem.rhs->counters();
  const auto integrator = make_integrator(spec);
  integrator->prepare(*problem.rhs, plan);
  integrator->start(0, problem.initial);
  for (const double t : output_times) {
    result.outcome = integrator->advance(t);
    if (!result.outcome.ok()) break;
    result.states.emplace_back(integrator->state().begin(), integrator->state().end());
  }
  result.statistics = integrator->statistics();
  result.sweeps = problem.rhs->counters().sweeps - before.sweeps;
  result.jacobians = problem.rhs->counters().jacobians - before.jacobians;
  return result;
}

double rms_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

double max_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    const double difference = std::abs(a[k] - b[k]);
    if (!(difference <= largest)) largest = difference;
  }
  return largest;
}

}  // namespace superstep::test

#pragma once
/// Linear scenes by eigenvectors in the arithmetic of `Real`: see dense_network.hpp.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "audit/oracle/dense_network.hpp"
#include "audit/oracle/graph_parts.hpp"
#include "audit/oracle/oracle.hpp"
#include "audit/oracle/pieces.hpp"
#include "core/index.hpp"

namespace superstep::audit {

/// Straight line in extended precision.
template <class Real>
struct LongLine {
  Real value = 0, slope = 0;
  void add(Real factor, const Line& line, Real base) {
    value += factor * (static_cast<Real>(line.value) - base);
    slope += factor * static_cast<Real>(line.slope);
  }
};

/// What holds a free node from outside: a fixed neighbour or an ambient.
template <class Real>
struct Exit {
  std::size_t node;  ///< within the part
  Real conductance;
  double value;  ///< where table is -1
  std::int32_t table;
};

/// Free nodes that are connected with each other, with their modes.
template <class Real>
struct Part {
  std::vector<std::size_t> nodes;  ///< positions in the graph
  std::vector<Real> capacity, source;
  std::vector<Exit<Real>> exits;
  std::vector<std::pair<std::size_t, std::int32_t>> tabled;  ///< sources: node within the part, table
  NetworkFactor<Real> factor;
  Modes<Real> modes;
  std::vector<Real> z;  ///< state in the modes, less what the exits would hold it at
  // On the present piece: u = held + held_slope tau + C^-1/2 V z(tau).
  std::vector<Real> held, held_slope, start, push, push_slope;
};

inline Line value_line(const Graph& graph, double value, std::int32_t table, double t0, double t1) {
  return table < 0 ? Line{value, 0} : line_of(graph.tables[at(table)], t0, t1);
}

template <class Real>
Part<Real> build_part(const Graph& graph, const std::vector<std::int32_t>& part_of, std::int32_t number,
                      const std::vector<Real>& source) {
  std::vector<std::size_t> nodes, local(graph.nodes(), 0);
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (part_of[node] == number) {
      local[node] = nodes.size();
      nodes.push_back(node);
    }
  const std::size_t n = nodes.size();
  std::vector<Real> weight(n * n, 0), outward(n, 0), capacity;
  std::vector<Exit<Real>> exits;
  const auto mine = [&](std::size_t node) { return part_of[node] == number; };
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const auto i = at(graph.i[e]), j = at(graph.j[e]);
    if (!(graph.conductance[e] > 0) || (!mine(i) && !mine(j))) continue;
    if (mine(i) && mine(j)) {
      weight[local[i] * n + local[j]] += graph.conductance[e];
      weight[local[j] * n + local[i]] += graph.conductance[e];
      continue;
    }
    const auto inside = mine(i) ? i : j, fixed = mine(i) ? j : i;
    exits.push_back({local[inside], graph.conductance[e], graph.fixed_value[fixed],
                     graph.fixed_table.empty() ? -1 : graph.fixed_table[fixed]});
  }
  for (const auto& exchange : graph.convection)
    if (mine(at(exchange.node)))
      exits.push_back({local[at(exchange.node)], exchange.coefficient, exchange.ambient, exchange.table});
  for (const auto& exit : exits) outward[exit.node] += exit.conductance;
  std::vector<Real> own_source;
  for (const auto node : nodes) {
    capacity.push_back(graph.capacity[node]);
    own_source.push_back(source[node]);
  }
  std::vector<std::pair<std::size_t, std::int32_t>> tabled;
  for (const auto& entry : graph.tabled_sources)
    if (mine(at(entry.node))) tabled.emplace_back(local[at(entry.node)], entry.table);
  NetworkFactor<Real> factor(std::move(weight), std::move(outward), capacity);
  Modes<Real> modes = find_modes(factor, capacity);
  return {std::move(nodes),
          std::move(capacity),
          std::move(own_source),
          std::move(exits),
          std::move(tabled),
          std::move(factor),
          std::move(modes),
          {},
          {},
          {},
          {},
          {},
          {}};
}

/// V^T C^1/2 x.
template <class Real>
std::vector<Real> into_modes(const Part<Real>& part, const std::vector<Real>& x) {
  using std::sqrt;
  const std::size_t n = part.nodes.size();
  std::vector<Real> z(n, 0);
  for (std::size_t m = 0; m < n; ++m)
    for (std::size_t k = 0; k < n; ++k) z[m] += part.modes.vector[m * n + k] * sqrt(part.capacity[k]) * x[k];
  return z;
}

/// Values of the part's nodes, relative to the base, `since` the piece began.
template <class Real>
std::vector<Real> values_of(const Part<Real>& part, double since) {
  using std::sqrt;
  const std::size_t n = part.nodes.size();
  std::vector<Real> u(n, 0);
  for (std::size_t m = 0; m < n; ++m) {
    const Real tau = since;
    const auto p = phi(Real(part.modes.rate[m] * tau));
    const Real z = p.decay * part.start[m] + tau * (p.one * part.push[m] + tau * p.two * part.push_slope[m]);
    for (std::size_t k = 0; k < n; ++k) u[k] += part.modes.vector[m * n + k] * z;
  }
  for (std::size_t k = 0; k < n; ++k)
    u[k] = u[k] / sqrt(part.capacity[k]) + part.held[k] + part.held_slope[k] * static_cast<Real>(since);
  return u;
}

/// Inputs of the piece from t0 to t1, entered with the values u. What the exits alone would hold the nodes at
/// moves along a line, "held"; the rest is driven by sources and by that line's slope. Every term stays of
/// the size of values or rises, so that nothing cancels.
template <class Real>
void enter_piece(const Graph& graph, double t0, double t1, Real base, const std::vector<Real>& u,
                 Part<Real>& part) {
  const std::size_t n = part.nodes.size();
  std::vector<LongLine<Real>> load(n), heat(n);
  for (const auto& exit : part.exits)
    load[exit.node].add(exit.conductance, value_line(graph, exit.value, exit.table, t0, t1), base);
  for (std::size_t k = 0; k < n; ++k) heat[k].value = part.source[k];
  for (const auto& [node, table] : part.tabled)
    heat[node].add(1, line_of(graph.tables[at(table)], t0, t1), 0);
  std::vector<Real> values(n), slopes(n);
  for (std::size_t k = 0; k < n; ++k) {
    values[k] = load[k].value;
    slopes[k] = load[k].slope;
  }
  const bool drained = !part.exits.empty();
  part.held = drained ? part.factor.solve(values) : std::vector<Real>(n, 0);
  part.held_slope = drained ? part.factor.solve(slopes) : std::vector<Real>(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    values[k] = heat[k].value / part.capacity[k] - part.held_slope[k];
    slopes[k] = heat[k].slope / part.capacity[k];
  }
  part.push = into_modes(part, values);
  part.push_slope = into_modes(part, slopes);
  for (std::size_t k = 0; k < n; ++k) values[k] = u[k] - part.held[k];
  part.start = into_modes(part, values);
}

/// Fractions of a piece at which extremes are looked for.
inline std::vector<double> sampling(std::size_t pieces) {
  std::vector<double> parts;
  for (double part = 1e-8; part<0.05; part *= pieces> 30 ? 100 : 4) parts.push_back(part);
  const int even = pieces > 30 ? 4 : 20;
  for (int k = 1; k <= even; ++k) parts.push_back(static_cast<double>(k) / even);
  return parts;
}

template <class Real>
class FieldSolution {
 public:
  FieldSolution(const StatedScene& scene, const FieldScene& field, const std::vector<Real>& source)
      : scene_(scene), graph_(field.graph), base_(field.graph.initial[0]) {
    truth_.name = field.name;
    std::int32_t count = 0;
    const auto part_of = parts_of_nodes(graph_, count);
    for (std::int32_t k = 0; k < count; ++k) parts_.push_back(build_part<Real>(graph_, part_of, k, source));
    truth_.low = truth_.high = graph_.is_fixed[0] ? fixed_line(0, 0, scene.t_end).value : graph_.initial[0];
  }

  FieldTruth solve(const std::vector<double>& times) {
    std::vector<std::vector<Real>> u;
    for (const auto& part : parts_) {
      u.emplace_back();
      for (const auto node : part.nodes) {
        u.back().push_back(static_cast<Real>(graph_.initial[node]) - base_);
        see(graph_.initial[node]);
      }
    }
    const auto samples = sampling(times.size());
    std::size_t output = 0;
    for (std::size_t k = 0; k + 1 < times.size(); ++k) {
      const double t0 = times[k], t1 = times[k + 1];
      for (std::size_t p = 0; p < parts_.size(); ++p) enter_piece(graph_, t0, t1, base_, u[p], parts_[p]);
      for (const double part : samples) see_all(part * (t1 - t0));
      see_fixed(t0, t1);
      const bool last = k + 2 == times.size();
      for (; output < scene_.output_times.size(); ++output) {
        const double t = scene_.output_times[output];
        if (!(last || t < t1)) break;
        truth_.values.push_back(values_at(t0, t, t1));
      }
      for (std::size_t p = 0; p < parts_.size(); ++p) u[p] = values_of(parts_[p], t1 - t0);
    }
    truth_.error = 1e-13 * truth_.span() + std::numeric_limits<double>::epsilon() * truth_.size();
    return truth_;
  }

 private:
  [[nodiscard]] Line fixed_line(std::size_t node, double t0, double t1) const {
    return value_line(graph_, graph_.fixed_value[node],
                      graph_.fixed_table.empty() ? -1 : graph_.fixed_table[node], t0, t1);
  }
  void see(double value) {
    truth_.low = std::min(truth_.low, value);
    truth_.high = std::max(truth_.high, value);
  }
  void see_all(double since) {
    for (const auto& part : parts_)
      for (const Real& value : values_of(part, since)) see(static_cast<double>(value + base_));
  }
  void see_fixed(double t0, double t1) {
    for (std::size_t node = 0; node < graph_.nodes(); ++node) {
      if (!graph_.is_fixed[node]) continue;
      const Line line = fixed_line(node, t0, t1);
      see(line.value);
      see(line.at(t1 - t0));
    }
  }
  [[nodiscard]] std::vector<double> values_at(double t0, double t, double t1) const {
    std::vector<double> values(graph_.nodes());
    for (std::size_t node = 0; node < values.size(); ++node)
      if (graph_.is_fixed[node]) values[node] = fixed_line(node, t0, t1).at(t - t0);
    for (const auto& part : parts_) {
      const auto u = values_of(part, t - t0);
      for (std::size_t k = 0; k < u.size(); ++k) values[part.nodes[k]] = static_cast<double>(u[k] + base_);
    }
    return values;
  }

  const StatedScene& scene_;
  const Graph& graph_;
  Real base_;
  std::vector<Part<Real>> parts_;
  FieldTruth truth_;
};

template <class Real>
std::vector<Real> constant_sources(const Graph& graph) {
  return {graph.source.begin(), graph.source.end()};
}

/// Potentials that constant electrodes and currents hold [nodes]; nodes without a way to an electrode keep
/// their initial value.
template <class Real>
std::vector<Real> steady_values(const Graph& graph) {
  std::vector<Real> v(graph.initial.begin(), graph.initial.end());
  for (std::size_t node = 0; node < v.size(); ++node)
    if (graph.is_fixed[node]) v[node] = graph.fixed_value[node];
  std::int32_t count = 0;
  const auto part_of = parts_of_nodes(graph, count);
  for (std::int32_t k = 0; k < count; ++k) {
    const Part<Real> part = build_part<Real>(graph, part_of, k, constant_sources<Real>(graph));
    if (part.exits.empty()) continue;
    std::vector<Real> load = part.source;
    for (const auto& exit : part.exits) load[exit.node] += exit.conductance * static_cast<Real>(exit.value);
    const auto solved = part.factor.solve(load);
    for (std::size_t i = 0; i < solved.size(); ++i) v[part.nodes[i]] = solved[i];
  }
  return v;
}

/// Joule heat split by resistance: physics of the branch in series with its two ends.
template <class Real>
void add_joule_heat(const FieldScene& electric, const std::vector<Real>& v, std::vector<Real>& source) {
  const Graph& graph = electric.graph;
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const auto i = at(graph.i[e]), j = at(graph.j[e]);
    const Real heat = graph.conductance[e] * (v[j] - v[i]) * (v[j] - v[i]);
    const Real a = electric.laws.of_node(graph.i[e]).value, b = electric.laws.of_node(graph.j[e]).value;
    source[i] += heat * b / (a + b);
    source[j] += heat * a / (a + b);
  }
}

template <class Real>
FieldTruth constant_field(const StatedScene& scene, const FieldScene& field,
                          const std::vector<Real>& values) {
  FieldTruth truth;
  truth.name = field.name;
  std::vector<double> doubles;
  for (const Real& value : values) doubles.push_back(static_cast<double>(value));
  truth.values.assign(scene.output_times.size(), doubles);
  const auto [low, high] = std::minmax_element(doubles.begin(), doubles.end());
  truth.low = *low;
  truth.high = *high;
  truth.error = 1e-13 * truth.span();
  return truth;
}

template <class Real>
Truth linear_solution(const StatedScene& scene) {
  Truth truth;
  truth.exact = true;
  const auto times = knots(scene);
  truth.steps = times.size() - 1;
  std::vector<Real> joule;
  for (const auto& field : scene.fields) {
    auto source = constant_sources<Real>(field.graph);
    if (field.steady) {
      const auto v = steady_values<Real>(field.graph);
      if (scene.coupling.joule_heat) {
        joule.assign(v.size(), 0);
        add_joule_heat(field, v, joule);
      }
      truth.fields.push_back(constant_field(scene, field, v));
      continue;
    }
    for (std::size_t node = 0; node < joule.size(); ++node) source[node] += joule[node];
    truth.fields.push_back(FieldSolution<Real>(scene, field, source).solve(times));
  }
  return truth;
}

}  // namespace superstep::audit

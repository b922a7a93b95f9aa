#include "audit/oracle/physics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/index.hpp"

namespace superstep::audit {
namespace {

using Kind = ConductivityLaw::Kind;

/// Mixture of the conductivities a and b of a branch's ends, and a's share of its Joule heat: the part of the
/// resistance that lies on a's side, 1/a of 1/a + 1/b.
struct Mix {
  double mean, mean_a, mean_b, share, share_a, share_b;
};
Mix mix(ConductanceMean kind, double a, double b) {
  const double sum = a + b;
  Mix out{};
  if (kind == ConductanceMean::harmonic) {
    out.mean = 2 * a * b / sum;
    out.mean_a = 2 * (b / sum) * (b / sum);
    out.mean_b = 2 * (a / sum) * (a / sum);
  } else {
    out.mean = sum / 2;
    out.mean_a = out.mean_b = 0.5;
  }
  out.share = b / sum;
  out.share_a = -b / (sum * sum);
  out.share_b = a / (sum * sum);
  return out;
}

/// Number of a table's points that are <= T.
std::size_t interval_of(const ConductivityLaw& law, double temperature) {
  std::size_t k = 0;
  while (k < law.temperatures.size() && law.temperatures[k] <= temperature) ++k;
  return k;
}

struct ValueAndSlope {
  double value, slope;
};
ValueAndSlope evaluate_law(const ConductivityLaw& law, std::size_t interval, double temperature) {
  switch (law.kind) {
    case Kind::constant:
      return {law.value, 0};
    case Kind::linear: {
      const double factor = 1 + law.coefficient * (temperature - law.reference);
      return {law.value * factor, law.value * law.coefficient};
    }
    case Kind::table: {
      if (interval == 0) return {law.values.front(), 0};
      if (interval == law.temperatures.size()) return {law.values.back(), 0};
      const double slope = (law.values[interval] - law.values[interval - 1]) /
                           (law.temperatures[interval] - law.temperatures[interval - 1]);
      return {law.values[interval - 1] + slope * (temperature - law.temperatures[interval - 1]), slope};
    }
    case Kind::sigmoid: {
      const double e = std::exp(-law.steepness * (temperature - law.reference)), s = 1 / (1 + e);
      const double bend = e > 1e150 ? 0 : e * s * s;
      return {law.value * (1 + law.amplitude * s), law.value * law.amplitude * law.steepness * bend};
    }
  }
  return {law.value, 0};
}

}  // namespace

Physics::Physics(const StatedScene& scene) : scene_(scene) {
  std::vector<double> mass;
  for (const auto& field : scene.fields) {
    Part part;
    part.stated = &field;
    part.base = field.graph.initial[0];
    part.varies = std::any_of(field.laws.of_material.begin(), field.laws.of_material.end(),
                              [](const auto& law) { return law.varies(); });
    number_entries(part);
    for (std::size_t node = 0; node < field.graph.nodes(); ++node)
      if (part.entry[node] >= 0) mass.push_back(field.steady ? 0 : field.graph.capacity[node]);
    if (field.name == "temperature") thermal_ = static_cast<std::ptrdiff_t>(parts_.size());
    parts_.push_back(std::move(part));
  }
  mass_ = Eigen::Map<const Eigen::VectorXd>(mass.data(), static_cast<Eigen::Index>(mass.size()));
}

/// Steady fields: only nodes that are joined to a fixed one have an equation; the others keep their value.
void Physics::number_entries(Part& part) {
  const Graph& graph = part.stated->graph;
  std::vector<char> reached(graph.is_fixed.begin(), graph.is_fixed.end());
  for (bool grown = true; grown;) {
    grown = false;
    for (std::size_t e = 0; e < graph.edges(); ++e) {
      auto &a = reached[at(graph.i[e])], &b = reached[at(graph.j[e])];
      if (graph.conductance[e] > 0 && a != b) {
        a = b = 1;
        grown = true;
      }
    }
  }
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    const bool free = !graph.is_fixed[node] && (!part.stated->steady || reached[node]);
    part.entry.push_back(free ? static_cast<Eigen::Index>(field_of_.size()) : -1);
    if (free) field_of_.push_back(parts_.size());
  }
  part.known.resize(graph.nodes());
  part.source.resize(graph.nodes());
  part.interval.assign(graph.nodes(), 0);
  part.u.resize(graph.nodes());
  part.kappa.resize(graph.nodes());
  part.slope.resize(graph.nodes());
}

Eigen::VectorXd Physics::initial() const {
  Eigen::VectorXd y(size());
  for (const auto& part : parts_)
    for (std::size_t node = 0; node < part.entry.size(); ++node)
      if (part.entry[node] >= 0) y(part.entry[node]) = part.stated->graph.initial[node] - part.base;
  return y;
}

void Physics::enter(double t0, double t1) {
  for (auto& part : parts_) {
    const Graph& graph = part.stated->graph;
    const auto line = [&](double value, std::int32_t table) {
      return table < 0 ? Line{value, 0} : line_of(graph.tables[at(table)], t0, t1);
    };
    for (std::size_t node = 0; node < graph.nodes(); ++node) {
      part.source[node] = {graph.source[node], 0};
      part.known[node] =
          !graph.is_fixed[node]
              ? Line{graph.initial[node], 0}
              : line(graph.fixed_value[node], graph.fixed_table.empty() ? -1 : graph.fixed_table[node]);
      part.known[node].value -= part.base;
    }
    for (const auto& source : graph.tabled_sources) {
      const Line extra = line_of(graph.tables[at(source.table)], t0, t1);
      part.source[at(source.node)].value += extra.value;
      part.source[at(source.node)].slope += extra.slope;
    }
    part.convection.clear();
    part.radiation.clear();
    for (const auto& exchange : graph.convection)
      part.convection.push_back(line(exchange.ambient, exchange.table));
    for (const auto& exchange : graph.radiation)
      part.radiation.push_back(line(exchange.ambient, exchange.table));
  }
  if (thermal_ < 0) return;
  // Fixed temperatures cross no corner inside a piece: the middle tells the interval.
  const Part& thermal = parts_[static_cast<std::size_t>(thermal_)];
  for (auto& part : parts_)
    for (std::size_t node = 0; part.varies && node < part.entry.size(); ++node)
      if (thermal.entry[node] < 0)
        part.interval[node] = interval_of(part.stated->laws.of_node(static_cast<std::int32_t>(node)),
                                          thermal.base + thermal.known[node].at(0.5 * (t1 - t0)));
}

double Physics::temperature(std::size_t node) const {
  const Part& thermal = parts_[static_cast<std::size_t>(thermal_)];
  return thermal.base + thermal.u[node];
}

Eigen::Index Physics::temperature_entry(std::size_t node) const {
  return parts_[static_cast<std::size_t>(thermal_)].entry[node];
}

void Physics::set_values(double since, const Eigen::VectorXd& y) {
  for (auto& part : parts_)
    for (std::size_t node = 0; node < part.entry.size(); ++node)
      part.u[node] = part.entry[node] >= 0 ? y(part.entry[node]) : part.known[node].at(since);
}

void Physics::set_conductivity(Part& part) {
  if (part.stated->laws.of_material.empty()) return;
  for (std::size_t node = 0; node < part.kappa.size(); ++node) {
    const auto& law = part.stated->laws.of_node(static_cast<std::int32_t>(node));
    const auto now = evaluate_law(law, part.interval[node], part.varies ? temperature(node) : 0);
    part.kappa[node] = now.value;
    part.slope[node] = now.slope;
  }
}

void Physics::conduct(Part& part, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian) {
  const Graph& graph = part.stated->graph;
  const auto& laws = part.stated->laws;
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const auto i = at(graph.i[e]), j = at(graph.j[e]);
    const double difference = part.u[j] - part.u[i];
    double conductance = graph.conductance[e], by_i = 0, by_j = 0;  // derivatives by the two temperatures
    if (part.varies) {
      const double reference =
          mix(laws.mean, laws.of_node(graph.i[e]).value, laws.of_node(graph.j[e]).value).mean;
      const Mix now = mix(laws.mean, part.kappa[i], part.kappa[j]);
      by_i = conductance / reference * now.mean_a * part.slope[i];
      by_j = conductance / reference * now.mean_b * part.slope[j];
      conductance *= now.mean / reference;
    }
    const double flow = conductance * difference;  // into i
    const auto row_i = part.entry[i], row_j = part.entry[j];
    if (row_i >= 0) f(row_i) += flow;
    if (row_j >= 0) f(row_j) -= flow;
    if (!jacobian) continue;
    const auto add = [&](Eigen::Index column, double slope) {
      if (column < 0) return;
      if (row_i >= 0) (*jacobian)(row_i, column) += slope;
      if (row_j >= 0) (*jacobian)(row_j, column) -= slope;
    };
    add(row_i, -conductance);
    add(row_j, conductance);
    if (!part.varies) continue;
    add(temperature_entry(i), by_i * difference);
    add(temperature_entry(j), by_j * difference);
  }
}

void Physics::exchange(Part& part, double since, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian) {
  const Graph& graph = part.stated->graph;
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (part.entry[node] >= 0) f(part.entry[node]) += part.source[node].at(since);
  for (std::size_t k = 0; k < graph.convection.size(); ++k) {
    const auto row = part.entry[at(graph.convection[k].node)];
    if (row < 0) continue;
    const Line& ambient = part.convection[k];
    f(row) += graph.convection[k].coefficient *
              ((ambient.value - part.base) + ambient.slope * since - part.u[at(graph.convection[k].node)]);
    if (jacobian) (*jacobian)(row, row) -= graph.convection[k].coefficient;
  }
  for (std::size_t k = 0; k < graph.radiation.size(); ++k) {
    const auto node = at(graph.radiation[k].node);
    const auto row = part.entry[node];
    if (row < 0) continue;
    const double ambient = part.radiation[k].at(since), own = part.base + part.u[node];
    const double difference =
        (part.radiation[k].value - part.base) + part.radiation[k].slope * since - part.u[node];
    const double coefficient = graph.radiation[k].coefficient;
    f(row) += coefficient * difference * (ambient + own) * (ambient * ambient + own * own);
    if (jacobian) (*jacobian)(row, row) -= 4 * coefficient * own * own * own;
  }
}

void Physics::heat(const Part& electric, Part& thermal, Eigen::VectorXd& f, Eigen::MatrixXd* jacobian) {
  const Graph& graph = electric.stated->graph;
  const auto& laws = electric.stated->laws;
  for (std::size_t e = 0; e < graph.edges(); ++e) {
    const double reference =
        mix(laws.mean, laws.of_node(graph.i[e]).value, laws.of_node(graph.j[e]).value).mean;
    const double geometry = graph.conductance[e] / reference;
    for (const bool swapped : {false, true}) {
      const auto own = at(swapped ? graph.j[e] : graph.i[e]), other = at(swapped ? graph.i[e] : graph.j[e]);
      const auto row = thermal.entry[own];
      if (row < 0) continue;
      const double dv = electric.u[other] - electric.u[own];
      const Mix now = mix(laws.mean, electric.kappa[own], electric.kappa[other]);
      f(row) += geometry * now.mean * now.share * dv * dv;
      if (!jacobian) continue;
      const double by_v = 2 * geometry * now.mean * now.share * dv;
      if (electric.entry[other] >= 0) (*jacobian)(row, electric.entry[other]) += by_v;
      if (electric.entry[own] >= 0) (*jacobian)(row, electric.entry[own]) -= by_v;
      if (!electric.varies) continue;
      const double power = geometry * dv * dv;
      (*jacobian)(row, row) +=
          power * (now.mean_a * now.share + now.mean * now.share_a) * electric.slope[own];
      const auto column = thermal.entry[other];
      if (column >= 0)
        (*jacobian)(row, column) +=
            power * (now.mean_b * now.share + now.mean * now.share_b) * electric.slope[other];
    }
  }
}

void Physics::evaluate(double since, const Eigen::VectorXd& y, Eigen::VectorXd& f,
                       Eigen::MatrixXd* jacobian) {
  f.setZero(size());
  if (jacobian) jacobian->setZero(size(), size());
  set_values(since, y);
  for (auto& part : parts_) {
    set_conductivity(part);
    conduct(part, f, jacobian);
    exchange(part, since, f, jacobian);
  }
  if (!scene_.coupling.joule_heat || parts_.size() < 2) return;
  heat(parts_[0], parts_[1], f, jacobian);
}

void Physics::make_consistent(double since, Eigen::VectorXd& y) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < size(); ++k)
    if (mass_(k) == 0) rows.push_back(k);
  if (rows.empty()) return;
  Eigen::VectorXd f;
  Eigen::MatrixXd jacobian;
  for (int pass = 0; pass < 2; ++pass) {  // linear in the potentials: the second pass polishes
    evaluate(since, y, f, &jacobian);
    const Eigen::VectorXd correction = jacobian(rows, rows).partialPivLu().solve(f(rows));
    for (std::size_t k = 0; k < rows.size(); ++k) y(rows[k]) -= correction(static_cast<Eigen::Index>(k));
  }
}

std::vector<double> Physics::values(std::size_t field, double since, const Eigen::VectorXd& y) const {
  const Part& part = parts_[field];
  std::vector<double> out;
  for (std::size_t node = 0; node < part.entry.size(); ++node)
    out.push_back(part.base + (part.entry[node] >= 0 ? y(part.entry[node]) : part.known[node].at(since)));
  return out;
}

void Physics::choose_intervals(const Eigen::VectorXd& y) {
  if (thermal_ < 0) return;
  const Part& thermal = parts_[static_cast<std::size_t>(thermal_)];
  for (auto& part : parts_)
    for (std::size_t node = 0; part.varies && node < part.entry.size(); ++node)
      if (thermal.entry[node] >= 0)
        part.interval[node] = interval_of(part.stated->laws.of_node(static_cast<std::int32_t>(node)),
                                          thermal.base + y(thermal.entry[node]));
}

std::vector<Corner> Physics::corners() const {
  std::vector<Corner> out;
  if (thermal_ < 0) return out;
  const Part& thermal = parts_[static_cast<std::size_t>(thermal_)];
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t field = 0; field < parts_.size(); ++field) {
    const Part& part = parts_[field];
    for (std::size_t node = 0; part.varies && node < part.entry.size(); ++node) {
      const auto& points = part.stated->laws.of_node(static_cast<std::int32_t>(node)).temperatures;
      if (points.empty() || thermal.entry[node] < 0) continue;
      const auto k = part.interval[node];
      out.push_back({thermal.entry[node], k == 0 ? -infinity : points[k - 1] - thermal.base,
                     k == points.size() ? infinity : points[k] - thermal.base, field, node});
    }
  }
  return out;
}

void Physics::pass(const Corner& corner, bool upward) {
  auto& interval = parts_[corner.field].interval[corner.node];
  upward ? ++interval : --interval;
}

}  // namespace superstep::audit

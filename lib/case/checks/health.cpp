#include "case/checks/health.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "case/checks/effective.hpp"
#include "core/error.hpp"
#include "network/spd_solver.hpp"
#include "rhs/lanczos.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

constexpr std::size_t largest_factorization =
    300'000;  // nodes; beyond, the fill of a 3-D packing takes gigabytes

/// Value below which the part `q` of the sample lies; reorders the sample.
double quantile(std::vector<double>& sample, double q) {
  if (sample.empty()) return 0;
  const auto k = static_cast<std::ptrdiff_t>(q * static_cast<double>(sample.size() - 1));
  std::nth_element(sample.begin(), sample.begin() + k, sample.end());
  return sample[static_cast<std::size_t>(k)];
}

PackingHealth assess_packing(const PackingScene& packed) {
  const auto& packing = packed.packing;
  const auto& contacts = packed.contacts;
  PackingHealth health;
  health.particles = packing.size();
  health.contacts = contacts.size();
  const auto [smallest, largest] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  health.diameter_min = 2 * *smallest;
  health.diameter_max = 2 * *largest;
  if (packed.container)
    health.relative_density =
        sphere_volume(packing) / (packed.container->cross_section * packed.container->height);
  std::vector<double> overlap;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const double radius = std::min(packing.radius[static_cast<std::size_t>(contacts.i[k])],
                                   packing.radius[static_cast<std::size_t>(contacts.j[k])]);
    overlap.push_back(contacts.overlap[k] / radius);
  }
  health.overlap_median = quantile(overlap, 0.5);
  health.overlap_95 = quantile(overlap, 0.95);
  health.overlap_max = quantile(overlap, 1.0);
  health.saturated = packed.neck_report.saturated;
  health.limited = packed.neck_report.limited;
  return health;
}

/// Median of K_ij / (pi kappa R_min) with the harmonic mean of the two conductivities.
double lumping_ratio(const Packing& packing, const FieldAtState& state) {
  std::vector<double> ratio;
  const auto& graph = state.graph;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const auto i = static_cast<std::size_t>(graph.i[k]), j = static_cast<std::size_t>(graph.j[k]);
    const double kappa_i = state.conductivity[i], kappa_j = state.conductivity[j];
    const double kappa = 2 * kappa_i * kappa_j / (kappa_i + kappa_j);
    const double radius = std::min(packing.radius[i], packing.radius[j]);
    ratio.push_back(graph.conductance[k] / (std::numbers::pi * kappa * radius));
  }
  return quantile(ratio, 0.5);
}

/// Drops what counts nothing: eliminated nodes have given their edges to their neighbours.
void leave_out(const std::vector<AlgebraicNode>& eliminated, std::vector<std::size_t>& degree) {
  constexpr auto none = static_cast<std::size_t>(-1);
  for (const auto& gone : eliminated) degree[static_cast<std::size_t>(gone.node)] = none;
  std::erase(degree, none);
}

void count_nodes(const FieldScene& field, const Graph& graph, FieldHealth& health) {
  std::vector<std::size_t> degree(graph.nodes(), 0);
  bool first = true;
  for (std::size_t k = 0; k < graph.edges(); ++k) {
    const double conductance = graph.conductance[k];
    if (!(conductance > 0)) continue;
    ++health.edges;
    ++degree[static_cast<std::size_t>(graph.i[k])];
    ++degree[static_cast<std::size_t>(graph.j[k])];
    health.conductance_min = first ? conductance : std::min(health.conductance_min, conductance);
    health.conductance_max = first ? conductance : std::max(health.conductance_max, conductance);
    first = false;
  }
  health.nodes = graph.nodes();
  health.eliminated = field.algebraic.size();
  for (const auto role : field.roles)
    ++(role == NodeRole::free ? health.free : role == NodeRole::fixed ? health.fixed : health.idle);
  health.idle -= health.eliminated;  // they have that role, as they are no part of the state
  health.components = field.components;
  health.floating = field.floating_clusters;
  health.idle_clusters = field.idle_clusters;
  leave_out(field.algebraic, degree);
  health.isolated = static_cast<std::size_t>(std::count(degree.begin(), degree.end(), std::size_t{0}));
  health.coordination_mean = 2 * static_cast<double>(health.edges) / static_cast<double>(degree.size());
  const auto [least, most] = std::minmax_element(degree.begin(), degree.end());
  health.coordination_min = *least;
  health.coordination_max = *most;
}

/// Smallest eigenvalue of C^-1 K by Lanczos on its inverse.
void find_lambda_min(const Network& network, FieldHealth& health) {
  if (network.size() > largest_factorization) {
    health.lambda_min_note = "not computed: the network is too large to factorize here";
    return;
  }
  if (!every_component_is_held(network)) {
    health.lambda_min = 0;
    health.lambda_min_note = "a cluster without a fixed node floats";
    return;
  }
  try {
    const SpdSolver solver(network);
    std::vector<double> load(network.size());
    const auto inverse = [&](std::span<const double> v, std::span<double> out) {
      for (std::size_t i = 0; i < load.size(); ++i) load[i] = network.capacity[i] * v[i];
      const auto x = solver.solve(load);
      std::copy(x.begin(), x.end(), out.begin());
    };
    constexpr LanczosLimits limits{.tolerance = 1e-6, .fewest = 5, .most = 60};
    health.lambda_min = 1 / largest_eigenvalue(inverse, network.capacity, limits).largest;
  } catch (const NumericalError& error) {
    health.lambda_min_note = error.what();
  }
}

/// Radiation as it acts on small changes: 4 c T^3 for each c (T^4 - ambient^4).
void linearise_radiation(std::span<const double> temperature, Graph& graph) {
  for (const auto& [node, coefficient, ambient, table] : graph.radiation) {
    const double t = temperature[static_cast<std::size_t>(node)];
    graph.convection.push_back({node, 4 * coefficient * t * t * t, ambient, table});
  }
  graph.radiation.clear();
}

void assess_stiffness(const Scene& scene, std::size_t f, FieldAtState state, FieldHealth& health) {
  const auto& field = scene.fields[f];
  health.pair_step_bare = min_pair_step(state.graph, field.roles, state.bare);
  health.pair_step_full = min_pair_step(state.graph, field.roles, state.graph.conductance);
  if (!state.graph.radiation.empty())
    linearise_radiation(scene.values_on_nodes(f, 0, scene.initial), state.graph);
  const Network network = build_network(state.graph, field.roles);
  const SpectralBounds bounds = spectral_bounds(network);
  health.edge_bound = bounds.edge;
  health.gershgorin = bounds.gershgorin;
  if (!scene.rhs->traits().constant_blocks)
    health.jacobian_bound = scene.rhs->spectral_bound(0, scene.initial);
  find_lambda_min(network, health);
  NetworkRhs rhs(network, field.name, field.unit, health.pair_step_bare);
  const auto estimate = estimate_spectral_radius(rhs, {.tolerance = 1e-5, .fewest = 20, .most = 400});
  health.lambda_max = estimate.largest;
  health.lambda_max_residual = estimate.residual;
}

FieldHealth assess_field(const Scene& scene, std::size_t f) {
  const auto& field = scene.fields[f];
  FieldAtState state = field_at_start(scene, field);
  FieldHealth health;
  health.name = field.name;
  health.unit = field.unit;
  health.steady = field.steady;
  health.temperatures = state.temperatures;
  count_nodes(field, state.graph, health);
  if (scene.packed) health.lumping_median = lumping_ratio(scene.packed->packing, state);
  const auto effective = effective_conductivity(scene, state);
  health.effective_conductivity = effective.value;
  health.effective_periodic = effective.periodic;
  health.effective_note = effective.note;
  health.effective_basis = effective.basis + (effective.advice.empty() ? "" : "; " + effective.advice);
  health.effective_length = effective.length;
  health.effective_area = effective.area;
  health.electrodes = electrode_facts(field, state);
  if (!field.steady) assess_stiffness(scene, f, std::move(state), health);
  return health;
}

}  // namespace

double FieldHealth::certified_step() const noexcept {
  return 2 / jacobian_bound.value_or(std::min(edge_bound, gershgorin));
}

NetworkHealth assess_network(const Scene& scene) {
  NetworkHealth health;
  if (scene.packed) health.packing = assess_packing(*scene.packed);
  for (std::size_t f = 0; f < scene.fields.size(); ++f) health.fields.push_back(assess_field(scene, f));
  return health;
}

}  // namespace superstep

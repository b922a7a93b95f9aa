#include "integrators/detail/exponential/exponential_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "integrators/detail/cost_models.hpp"
#include "integrators/detail/krylov/lanczos_space.hpp"

namespace superstep {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double tightest = 1e-11;  // that the small problems of Krylov spaces are solved to

/// Every piece of the inputs takes an expansion of its own.
double sweeps_of_chebyshev(const ExponentialWork& work) {
  const double decades = std::log(1 / work.rtol);
  const double sweeps = costs::chebyshev_terms * std::sqrt(work.t_rho * work.pieces * decades) +
                        work.pieces * (decades + 4) + costs::chebyshev_radius;
  return work.one_field ? sweeps : costs::chebyshev_one_way * sweeps;
}

double sweeps_of_lanczos(const ExponentialWork& work) {
  const double decades = std::log(1 / work.rtol);
  const double wanted =
      std::sqrt(work.t_rho) * (costs::lanczos_vectors + costs::lanczos_vectors_of_digit * decades) +
      costs::lanczos_few;
  const double vectors = std::min(wanted, work.unknowns + 1);  // then the space is whole
  const auto storage = LanczosSpace::storage_for(work.rtol / (1 + work.shapes));
  const double room = work.memory / (static_cast<double>(storage) * std::max(1.0, work.unknowns));
  constexpr double fewest = 40;  // a basis begun anew after fewer is no better than an expansion
  // Its products round by epsilons of rho each, and that acts for the whole time.
  constexpr double roundings = 30 * std::numeric_limits<double>::epsilon();
  if (work.rtol < tightest || room < std::min(fewest, vectors) || roundings * work.t_rho > work.rtol)
    return never;
  const double bases = std::max(1.0, vectors / room), spaces = 1 + work.shapes;
  constexpr double margin = 1.5;  // spaces of driven scenes cannot begin anew
  if (work.shapes > 0 && margin * spaces * vectors > room) return never;
  const double small = (costs::lanczos_vector + costs::lanczos_pair * vectors) / costs::sweep(work.unknowns);
  return (costs::lanczos_product + small) * spaces * vectors * std::sqrt(bases);
}

/// Analysis and factorization once, a factorization more and its own solves for every two decades of output
/// times; dimensions are those that every spectrum needs.
double sweeps_of_shift_invert(const ExponentialWork& work) {
  const double factor_bytes = 16 * std::pow(work.unknowns, 4.0 / 3.0);
  if (work.rtol < tightest || factor_bytes > work.memory) return never;
  const double size = work.unknowns / costs::usual_size, digits = std::log10(1 / work.rtol);
  const double poles = std::max(1.0, std::ceil(work.output_decades / 2));
  const double decades_of_a_pole = std::min(2.0, work.output_decades);
  const double solves = (2 + 2.5 * digits) * (1 + 0.4 * decades_of_a_pole);
  return costs::invert_analysis +
         poles * (costs::invert_factor * size + solves * costs::invert_solve * std::cbrt(size));
}

using Named = std::array<std::pair<const char*, double>, 3>;
Named sorted(const ExponentialCosts& costs) {
  Named list{
      {{"lanczos", costs.lanczos}, {"chebyshev", costs.chebyshev}, {"shift-invert", costs.shift_invert}}};
  std::stable_sort(list.begin(), list.end(),
                   [](const auto& a, const auto& b) { return a.second < b.second; });
  return list;
}

}  // namespace

ExponentialWork work_of_exponential(Rhs& rhs, const Task& task, double rtol, double memory) {
  const std::vector<double> zero(rhs.size(), 0.0);
  const double time = task.t_end - task.t_begin;
  const auto& outputs = task.plan->output_times;
  const auto first = std::upper_bound(outputs.begin(), outputs.end(), task.t_begin);
  const double shortest = first == outputs.end() ? time : *first - task.t_begin;
  return {.t_rho = time * rhs.spectral_bound(task.t_begin, zero),
          .rtol = rtol,
          .unknowns = static_cast<double>(rhs.reduction().total()),
          .output_decades = shortest > 0 && time > shortest ? std::log10(time / shortest) : 0,
          .memory = memory,
          .one_field = rhs.traits().linear,
          .pieces = static_cast<double>(task.propagations),
          .shapes = rhs.traits().linear ? static_cast<double>(rhs.input_shapes().size()) : 0};
}

ExponentialCosts exponential_costs(const ExponentialWork& work) {
  ExponentialCosts costs{.chebyshev = sweeps_of_chebyshev(work), .lanczos = never, .shift_invert = never};
  if (!work.one_field) return costs;
  costs.lanczos = sweeps_of_lanczos(work);
  if (work.shapes == 0) costs.shift_invert = sweeps_of_shift_invert(work);
  return costs;
}

std::string ExponentialCosts::cheapest() const {
  return sorted(*this)[0].first;
}

double ExponentialCosts::least() const {
  return sorted(*this)[0].second;
}

std::string ExponentialCosts::reason() const {
  const Named list = sorted(*this);
  std::string out =
      fmt::format("{}, because it costs the work of about {:.0f} sweeps", list[0].first, list[0].second);
  for (std::size_t k = 1; k < list.size(); ++k) {
    const char* joint = k == 1 ? ";" : ",";
    if (list[k].second == never)
      out += fmt::format("{} {} is not for this scene or tolerance", joint, list[k].first);
    else
      out += fmt::format("{} {} would cost {:.0f}", joint, list[k].first, list[k].second);
  }
  return out;
}

}  // namespace superstep

#include "integrators/costs/models.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "integrators/costs/fitted_constants.hpp"
#include "integrators/detail/krylov/lanczos_space.hpp"

namespace superstep {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr double usual_size = 16'538;  // unknowns that constants refer to: the cylinder of the source paper
constexpr double tightest = 1e-11;     // that the small problems of Krylov spaces are solved to

/// f at one state [s].
double f_seconds(const Work& work, const CostConstants& c) {
  const std::array sweeps = {1.0, c.one_way_sweeps, c.nonlinear_sweeps, c.coupled_sweeps};
  const double solve = work.steady ? c.steady_solve * std::pow(work.unknowns / 1000, 2) : 0;
  return sweeps[static_cast<std::size_t>(work.physics)] * sweep_seconds(work, c) + solve;
}

double reach(const Work& work, const CostConstants& c) {
  return work.t_rho * (work.physics == Physics::coupled ? c.coupled_radius : 1);
}

/// Every piece of the inputs takes an expansion of its own.
double chebyshev_seconds(const Work& work, double rtol, const CostConstants& c) {
  const double digits = std::log(1 / rtol);
  const double terms = c.chebyshev_terms * std::sqrt(work.t_rho * work.pieces * digits) +
                       work.pieces * (digits + 4) + c.chebyshev_radius;
  return terms * f_seconds(work, c) * (work.physics == Physics::linear ? 1 : c.chebyshev_one_way);
}

/// Of one space.
double lanczos_vectors(const Work& work, double rtol, const CostConstants& c) {
  constexpr double few = 8;
  const double wanted =
      std::sqrt(work.t_rho) * (c.lanczos_vectors + c.lanczos_digit * std::log(1 / rtol)) + few;
  return std::min(wanted, work.unknowns + 1);  // then the space is whole
}

double lanczos_seconds(const Work& work, double rtol, const CostConstants& c) {
  const double vectors = lanczos_vectors(work, rtol, c);
  const auto storage = LanczosSpace::storage_for(rtol / (1 + work.shapes));
  const double room = work.memory / (static_cast<double>(storage) * std::max(1.0, work.unknowns));
  constexpr double fewest = 40;  // a basis begun anew after fewer is no better than an expansion
  // Its products round by epsilons of rho each, and that acts for the whole time.
  constexpr double roundings = 30 * std::numeric_limits<double>::epsilon();
  if (rtol < tightest || room < std::min(fewest, vectors) || roundings * work.t_rho > rtol) return never;
  const double bases = std::max(1.0, vectors / room), spaces = 1 + work.shapes;
  constexpr double margin = 1.5;  // spaces of driven scenes cannot begin anew
  if (work.shapes > 0 && margin * spaces * vectors > room) return never;
  const double vector =
      sweep_seconds(work, c) + c.lanczos_row * work.unknowns + c.lanczos_vector + c.lanczos_pair * vectors;
  return vector * spaces * vectors * std::sqrt(bases);
}

/// Analysis and factorization once, a factorization more and its own solves for every two decades of output
/// times; dimensions are those that every spectrum needs.
double invert_seconds(const Work& work, double rtol, const CostConstants& c) {
  const double factor_bytes = 16 * std::pow(work.unknowns, 4.0 / 3.0);
  if (rtol < tightest || factor_bytes > work.memory || work.shapes > 0) return never;
  const double size = work.unknowns / usual_size, digits = std::log10(1 / rtol);
  const double poles = std::max(1.0, std::ceil(work.output_decades / 2));
  const double decades_of_a_pole = std::min(2.0, work.output_decades);
  const double solves = (2 + 2.5 * digits) * (1 + 0.4 * decades_of_a_pole);
  return c.invert_call + sweep_seconds(work, c) *
                             (c.invert_analysis +
                              poles * (c.invert_factor * size + solves * c.invert_solve * std::cbrt(size)));
}

/// ROCK4, also across the pieces of its inputs.
double rock_seconds(const Work& work, double rtol, const CostConstants& c) {
  const double steps = c.rock_steps * std::pow(1e4 * rtol, -c.rock_growth) + c.rock_piece * (work.pieces - 1);
  const double stages = c.rock_finish * steps + std::sqrt(steps * reach(work, c) / c.rock_interval);
  const bool searches = work.physics == Physics::linear || work.physics == Physics::one_way;
  return stages * f_seconds(work, c) + steps * c.rock_step +
         (searches ? c.chebyshev_radius * sweep_seconds(work, c) : 0);
}

/// Krylov spaces of the Jacobian, in which no steady potential is solved for; f at three states a step.
double exprb_seconds(const Work& work, double rtol, const CostConstants& c) {
  constexpr double first = 4;  // to find the length of the others
  const double growth = work.steady ? c.exprb_steady_growth : c.exprb_growth;
  const double steps =
      first + c.exprb_steps * std::pow(1e4 * rtol, -growth) + c.exprb_piece * (work.pieces - 1);
  const double vectors = c.exprb_few * steps + c.exprb_vectors * std::sqrt(steps * reach(work, c));
  return vectors * (c.exprb_product * sweep_seconds(work, c) + c.exprb_vector) +
         3 * steps * f_seconds(work, c);
}

/// BDF: steps times the work of a step.
double bdf_seconds(Family family, const Work& work, double rtol, const CostConstants& c) {
  const double steps =
      c.bdf_steps * std::pow(rtol, -c.bdf_growth) * (1 + c.bdf_decades * std::log10(1 + reach(work, c))) +
      c.bdf_piece * (work.pieces - 1);
  constexpr double evaluations = 1.3;  // of f a step
  const double size = work.unknowns / usual_size;
  const double sweeps = family == Family::cvode_klu   ? c.bdf_direct * std::pow(size, 2.0 / 3.0)
                        : family == Family::cvode_pcg ? c.bdf_pcg * std::pow(size, 0.43)
                                                      : c.bdf_gmres * std::pow(size, 0.43);
  return steps * (sweeps * sweep_seconds(work, c) + evaluations * f_seconds(work, c) + c.bdf_step);
}

/// Part of the tolerance that a family is given, so that its error stays below twice all of it in 99 random
/// scenes of a hundred: what the worst of them err by (reports/records/audit.md). BDF begins anew at knots,
/// and steps over bends.
double part_of_tolerance(Family family, const Work& work) {
  switch (family) {
    case Family::lanczos:
    case Family::chebyshev:
    case Family::shift_invert:
      // In one field `exponential` takes whichever basis costs least at that tolerance: any of them may be
      // it. Lanczos errs by up to 1.9 of its own where two materials make the error fall in steps.
      return work.physics == Physics::linear ? 0.5 : 1;
    case Family::exprb:
      return 0.4;
    case Family::rock:
      return 0.5;
    case Family::cvode_pcg:
    case Family::cvode_gmres:
    case Family::cvode_klu:
      return work.pieces > 1 || !work.smooth ? 0.15 : 0.4;
    default:
      return 1;
  }
}

/// Steps of exprb do not become longer beyond this: a looser one is not cheaper.
double loosest(Family family) {
  return family == Family::exprb ? 1e-3 : 0.5;
}

/// What a factorization fills in hangs on how a network lies in space, of which nothing is known before: of
/// two that should cost alike the other one is taken.
double caution(Family family) {
  return family == Family::shift_invert ? 1.3 : 1;
}

}  // namespace

std::string family_spec(Family family, Physics physics) {
  switch (family) {
    case Family::euler:
      return "forward-euler";
    case Family::chebyshev:
      return physics == Physics::linear ? "exponential:basis=chebyshev" : "exponential";
    case Family::lanczos:
      return "exponential:basis=lanczos";
    case Family::shift_invert:
      return "exponential:basis=shift-invert";
    case Family::rock:
      return "rock";
    case Family::exprb:
      return "exprb";
    case Family::cvode_pcg:
      return "cvode:linsol=pcg";
    case Family::cvode_gmres:
      return "cvode:linsol=gmres";
    case Family::cvode_klu:
      return "cvode:linsol=klu";
  }
  return "";
}

double sweep_seconds(const Work& work, const CostConstants& constants) noexcept {
  return constants.sweep_row * work.unknowns + constants.sweep_nonzero * work.nonzeros + constants.sweep_call;
}

double predicted_seconds(Family family, const Work& work, double rtol, const CostConstants& constants) {
  switch (family) {
    case Family::euler:
      return f_seconds(work, constants);
    case Family::chebyshev:
      return chebyshev_seconds(work, rtol, constants);
    case Family::lanczos:
      return lanczos_seconds(work, rtol, constants);
    case Family::shift_invert:
      return invert_seconds(work, rtol, constants);
    case Family::rock:
      return rock_seconds(work, rtol, constants);
    case Family::exprb:
      return exprb_seconds(work, rtol, constants);
    default:
      return bdf_seconds(family, work, rtol, constants);
  }
}

double predicted_products(const Work& work, double rtol, const CostConstants& constants) {
  return (1 + work.shapes) * lanczos_vectors(work, rtol, constants);
}

double cautious_seconds(Family family, const Work& work, double rtol, const CostConstants& constants) {
  return caution(family) * predicted_seconds(family, work, rtol, constants);
}

std::vector<Candidate> candidates(const Work& work, double rtol, const CostConstants& constants) {
  std::vector<Family> families;
  switch (work.physics) {
    case Physics::linear:  // nothing explicit is faster where the exponential is exact in one field
      families = {Family::chebyshev, Family::lanczos, Family::shift_invert, Family::cvode_pcg,
                  Family::cvode_klu};
      if (work.hidden) families = {Family::chebyshev, Family::cvode_pcg, Family::cvode_klu};
      break;
    case Physics::one_way:  // exprb knows a potential to a part of its whole span, its heat less well
      families = {Family::chebyshev, Family::rock, Family::cvode_gmres};
      break;
    default:
      families = {Family::rock, Family::exprb, Family::cvode_gmres};
  }
  if (!work.smooth) std::erase(families, Family::rock);  // its many stages look past a bend
  std::vector<Candidate> out;
  for (const Family family : families) {
    const double own = std::clamp(rtol * part_of_tolerance(family, work), 1e-14, loosest(family));
    out.push_back({family, own, cautious_seconds(family, work, own, constants)});
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Candidate& a, const Candidate& b) { return a.seconds < b.seconds; });
  return out;
}

const CostConstants& fitted_constants() noexcept {
  static constexpr CostConstants constants = fitted::constants();
  return constants;
}

}  // namespace superstep

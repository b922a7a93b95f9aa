#include "bench/harness/corpus/cost_fit.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/median.hpp"
#include "core/text/number.hpp"
#include "core/text/options.hpp"

namespace superstep {
namespace {

constexpr double huber = 0.3;  // of a logarithm: larger differences count in proportion
constexpr double prior_pull =
    0.1;  // a factor of e away from the constant without measurements counts so much
constexpr std::size_t fewest_steps = 200;  // of Euler: its first ones are cold

std::optional<Family> family_of_row(const CorpusRow& row, Physics physics, double& rtol) {
  std::string rest = row.integrator;
  for (const auto& [key, value] : parse_spec(row.spec).settings)
    if (key == "rtol")
      rtol = parse_number(value).value_or(0);
    else
      rest += (rest == row.integrator ? ":" : ",") + key + "=" + value;
  if (rest == "forward-euler:fraction=1" && row.steps >= fewest_steps) return Family::euler;
  if (!(rtol > 0)) return std::nullopt;
  for (const Candidate& one : candidates({.physics = physics, .unknowns = 1, .t_rho = 1}, rtol, {}))
    if (rest == family_spec(one.family, physics)) return one.family;
  if (rest == "rock") return Family::rock;
  if (rest == "exprb" && physics != Physics::linear) return Family::exprb;
  return std::nullopt;
}

/// Where a run takes less than 2 ms nobody minds which method it was: such points count less.
double importance(const CostPoint& point) {
  constexpr double minded = 2e-3;
  return std::clamp(std::sqrt(point.seconds / minded), 0.2, 1.0);
}

/// log(predicted / measured), over all points, each by its importance: times, and then what Lanczos counts,
/// without which many vectors that cost little could stand for few that cost much.
Eigen::VectorXd residuals(std::span<const CostPoint> points, const CostConstants& constants) {
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::VectorXd out = Eigen::VectorXd::Zero(2 * n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto& p = points[static_cast<std::size_t>(k)];
    const double predicted = predicted_seconds(p.family, p.work, p.rtol, constants);
    if (!std::isfinite(predicted)) continue;
    out[k] = importance(p) * std::log(predicted / p.seconds);
    if (p.family == Family::lanczos && p.row->sweeps > 0)
      out[n + k] = importance(p) * std::log(predicted_products(p.work, p.rtol, constants) /
                                            static_cast<double>(p.row->sweeps));
  }
  return out;
}

CostConstants at_logarithms(const Eigen::VectorXd& logs) {
  CostConstants out;
  Eigen::Index k = 0;
  for (const auto& one : cost_constants()) out.*one.value = std::exp(logs[k++]);
  return out;
}

Eigen::VectorXd logarithms(const CostConstants& constants) {
  const auto list = cost_constants();
  Eigen::VectorXd out(static_cast<Eigen::Index>(list.size()));
  Eigen::Index k = 0;
  for (const auto& one : list) out[k++] = std::log(constants.*one.value);
  return out;
}

/// Huber's weights: 1 near 0, falling as 1/|r| beyond.
Eigen::VectorXd weights_of(const Eigen::VectorXd& r) {
  return r.unaryExpr([](double x) { return std::abs(x) <= huber ? 1.0 : huber / std::abs(x); });
}

double loss(const Eigen::VectorXd& r, const Eigen::VectorXd& from_prior) {
  double sum = prior_pull * prior_pull * from_prior.squaredNorm();
  for (const double x : r) sum += std::abs(x) <= huber ? x * x : 2 * huber * std::abs(x) - huber * huber;
  return sum;
}

}  // namespace

Work work_of(const CorpusRow& row) {
  constexpr std::string_view steady = "-steady";
  std::string name = row.physics;
  const bool is_steady = name.ends_with(steady);
  if (is_steady) name.resize(name.size() - steady.size());
  return {.physics = physics_of(name),
          .steady = is_steady,
          .unknowns = static_cast<double>(row.unknowns),
          .nonzeros = static_cast<double>(row.nonzeros),
          .t_rho = row.stiffness,
          .pieces = row.pieces,
          .shapes = row.shapes,
          .output_decades = row.output_decades};
}

std::vector<CostPoint> cost_points(std::span<const CorpusRow> rows) {
  std::vector<CostPoint> out;
  for (const auto& row : rows) {
    if (!row.ok() || !row.cpu || !(*row.cpu > 0) || row.threads != 1 || row.physics.empty()) continue;
    const Work work = work_of(row);
    double rtol = 0;
    const auto family = family_of_row(row, work.physics, rtol);
    if (!family) continue;
    const double runs = *family == Family::euler ? static_cast<double>(row.steps) : 1;
    out.push_back({&row, *family, work, rtol, *row.cpu / runs});
  }
  return out;
}

/// Source: Levenberg and Marquardt's damped least squares over the logarithms of the constants, so that none
/// becomes negative, with weights after Huber (1964), doi:10.1214/aoms/1177703732.
CostConstants fit_costs(std::span<const CostPoint> points) {
  const Eigen::VectorXd prior = logarithms({});
  Eigen::VectorXd logs = prior;
  Eigen::VectorXd r = residuals(points, at_logarithms(logs));
  double best = loss(r, logs - prior), damping = 1e-2;
  constexpr int rounds = 200;
  constexpr double difference = 1e-4, enough = 1e-9, hopeless = 1e8;
  for (int round = 0; round < rounds && damping < hopeless; ++round) {
    Eigen::MatrixXd slope(r.size(), logs.size());
    for (Eigen::Index k = 0; k < logs.size(); ++k) {
      Eigen::VectorXd moved = logs;
      moved[k] += difference;
      slope.col(k) = (residuals(points, at_logarithms(moved)) - r) / difference;
    }
    const Eigen::VectorXd weights = weights_of(r);
    Eigen::MatrixXd normal = slope.transpose() * weights.asDiagonal() * slope;
    normal.diagonal().array() += prior_pull * prior_pull;
    const Eigen::VectorXd downhill = -(slope.transpose() * (weights.array() * r.array()).matrix() +
                                       prior_pull * prior_pull * (logs - prior));
    bool improved = false;
    while (!improved && damping < hopeless) {
      Eigen::MatrixXd damped = normal;
      damped.diagonal() *= 1 + damping;
      const Eigen::VectorXd trial = logs + damped.ldlt().solve(downhill);
      const Eigen::VectorXd now = residuals(points, at_logarithms(trial));
      const double value = loss(now, trial - prior);
      improved = value < best;
      damping *= improved ? 0.3 : 4;
      if (!improved) continue;
      const bool settled = best - value < enough * best;
      logs = trial, r = now, best = value;
      if (settled) return at_logarithms(logs);
    }
  }
  return at_logarithms(logs);
}

std::vector<FitQuality> fit_quality(std::span<const CostPoint> points, const CostConstants& constants) {
  std::vector<FitQuality> out;
  for (int f = 0; f <= static_cast<int>(Family::cvode_klu); ++f) {
    std::vector<double> off;
    for (const auto& p : points) {
      if (static_cast<int>(p.family) != f) continue;
      const double predicted = predicted_seconds(p.family, p.work, p.rtol, constants);
      if (std::isfinite(predicted)) off.push_back(std::abs(std::log(predicted / p.seconds)));
    }
    if (off.empty()) continue;
    out.push_back({static_cast<Family>(f), off.size(), std::exp(median_of(off)),
                   std::exp(*std::max_element(off.begin(), off.end()))});
  }
  return out;
}

}  // namespace superstep

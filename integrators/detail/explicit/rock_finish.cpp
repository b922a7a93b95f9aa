#include "integrators/detail/explicit/rock_finish.hpp"

#include <Eigen/LU>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace superstep {
namespace {

using Weights = ElementaryWeights;

/// 1/gamma of the eight trees.
constexpr Weights exact = {1, 1.0 / 2, 1.0 / 3, 1.0 / 6, 1.0 / 4, 1.0 / 8, 1.0 / 12, 1.0 / 24};

/// Weights of h F(Y) from those of Y: each tree's is the product over its branches.
Weights of_derivative(const Weights& y) {
  const double square = y[0] * y[0];
  return {1, y[0], square, y[1], square * y[0], y[0] * y[1], y[2], y[3]};
}

void add(Weights& sum, double factor, const Weights& term) {
  for (std::size_t t = 0; t < sum.size(); ++t) sum[t] += factor * term[t];
}

/// Weights of the recurrence's result.
Weights recurrence_weights(const ThreeTermScheme& scheme) {
  Weights before{}, now{};
  add(now, scheme.mt[1], of_derivative({}));
  for (std::size_t j = 2; j <= static_cast<std::size_t>(scheme.recurrence_stages()); ++j) {
    Weights next{};
    add(next, scheme.m[j], now);
    add(next, scheme.n[j], before);
    add(next, scheme.mt[j], of_derivative(now));
    before = std::exchange(now, next);
  }
  return now;
}

/// Weights of the four stages' derivatives.
std::array<Weights, 4> slope_weights(const FinishingProcedure& f, const Weights& start) {
  std::array<Weights, 4> slopes;
  for (std::size_t i = 0; i < 4; ++i) {
    Weights stage = start;
    for (std::size_t j = 0; j < i; ++j) add(stage, f.a[i - 1][j], slopes[j]);
    slopes[i] = of_derivative(stage);
  }
  return slopes;
}

/// Solves sum_i x_i row_k(i) = right_k for four x.
template <class Row>
std::array<double, 4> solve_four(Row row, const std::array<double, 4>& right) {
  Eigen::Matrix4d matrix;
  Eigen::Vector4d r;
  for (int k = 0; k < 4; ++k) {
    for (int i = 0; i < 4; ++i) matrix(k, i) = row(k, static_cast<std::size_t>(i));
    r[k] = right[static_cast<std::size_t>(k)];
  }
  const Eigen::Vector4d x = matrix.fullPivLu().solve(r);
  return {x[0], x[1], x[2], x[3]};
}

/// Solves {x + y = sum, p x + q y = moment}.
std::pair<double, double> solve_two(double sum, double moment, double p, double q) {
  const double y = (moment - p * sum) / (q - p);
  return {sum - y, y};
}

/// The procedure that meets all conditions but the last for nodes c_2, c_3, c_4 (relative to the recurrence's
/// end), and by how much it misses the last, that of the chain of four.
struct Attempt {
  FinishingProcedure finish;
  double missing = 0;
};

Attempt attempt(const Weights& start, const std::array<double, 4>& c) {
  Attempt out;
  auto& a = out.finish.a;
  auto& b = out.finish.b;
  std::array<double, 4> node, chain;  // weights of t and [t] in each stage
  for (std::size_t i = 0; i < 4; ++i) node[i] = start[0] + c[i];
  // Trees t, [t], [t,t], [t,t,t]: the quadrature.
  b = solve_four([&](int k, std::size_t i) { return std::pow(node[i], k); },
                 {exact[0] - start[0], exact[1] - start[1], exact[2] - start[2], exact[4] - start[4]});
  // Trees [[t]] and [t,[t]]: the chains of stages 3 and 4.
  a[0][0] = c[1];
  chain[0] = start[1];
  chain[1] = start[1] + c[1] * node[0];
  double sum = exact[3] - start[3], moment = exact[5] - start[5];
  for (std::size_t i = 0; i < 2; ++i) {
    sum -= b[i] * chain[i];
    moment -= b[i] * node[i] * chain[i];
  }
  const auto [third, fourth] = solve_two(sum, moment, node[2], node[3]);
  chain[2] = third / b[2];
  chain[3] = fourth / b[3];
  a[1][1] = (chain[2] - start[1] - c[2] * node[0]) / c[1];
  a[1][0] = c[2] - a[1][1];
  // Tree [[t,t]]: what it leaves for stage 4, whose row then follows with its chain.
  const auto square = [&](std::size_t i) { return node[i] * node[i]; };
  double bushes = exact[6] - start[6] - (b[0] + b[1] + b[2] + b[3]) * start[2];
  bushes -= b[1] * c[1] * square(0) + b[2] * (a[1][0] * square(0) + a[1][1] * square(1));
  const double slope = chain[3] - start[1] - c[3] * node[0];
  const double curvature = bushes / b[3] - c[3] * square(0);
  // a_42 c_2 + a_43 c_3 = slope; the squares rise by c_i (node_i + node_1).
  const auto [second, last] = solve_two(slope, curvature, node[1] + node[0], node[2] + node[0]);
  a[2][1] = second / c[1];
  a[2][2] = last / c[2];
  a[2][0] = c[3] - a[2][1] - a[2][2];
  // Tree [[[t]]].
  double result = start[7];
  const auto slopes = slope_weights(out.finish, start);
  for (std::size_t i = 0; i < 4; ++i) result += b[i] * slopes[i][7];
  out.missing = result - exact[7];
  return out;
}

/// The embedded result of order three starts from y_n and uses the four slopes alone: its part of the stiff
/// modes stays as small as theirs, while the end's derivative would multiply them, and roundings, by h rho.
void set_error_estimate(FinishingProcedure& f, const Weights& start) {
  // Leading coefficient of the estimate on the chain of four, so that it is of the size of a fifth of z^4/24.
  constexpr double leading = 0.2 / 24;
  const auto slopes = slope_weights(f, start);
  f.embedded = solve_four([&](int k, std::size_t i) { return slopes[i][static_cast<std::size_t>(k)]; },
                          {exact[0], exact[1], exact[2], exact[3]});
  double chain = exact[7];
  for (std::size_t i = 0; i < 4; ++i) chain -= f.embedded[i] * slopes[i][7];
  f.estimate_scale = leading / std::abs(chain);
}

}  // namespace

void set_rock_finish(ThreeTermScheme& scheme) {
  // Nodes as parts of the way from the recurrence's end to the step's end; of the choices that keep all
  // coefficients below two these have nearly the smallest error of fifth order.
  constexpr double second_part = 0.35, third_part = 0.55;
  const auto stages = static_cast<std::size_t>(scheme.stages);
  const auto recurrence = static_cast<std::size_t>(scheme.recurrence_stages());
  const Weights start = recurrence_weights(scheme);
  const double way = 1 - start[0];
  const auto with_fourth = [&](double part) {
    return attempt(start, {0, second_part * way, third_part * way, part * way});
  };
  // The fourth node by the secant method: it is 1 for a classical method of four stages.
  double before = 1.02, now = 1.05;
  Attempt tried_before = with_fourth(before), tried = with_fourth(now);
  for (int step = 0; step < 30 && std::abs(tried.missing) > 1e-15 && now != before; ++step) {
    const double change = tried.missing * (now - before) / (tried.missing - tried_before.missing);
    if (!std::isfinite(change)) break;
    before = std::exchange(now, now - change);
    tried_before = std::exchange(tried, with_fourth(now));
  }
  if (!(std::abs(tried.missing) < 1e-12))
    throw std::logic_error("no finishing procedure of order four found for this number of stages");
  scheme.finish = tried.finish;
  set_error_estimate(*scheme.finish, start);
  set_stage_times(scheme);
  scheme.c[recurrence + 1] = start[0] + second_part * way;
  scheme.c[recurrence + 2] = start[0] + third_part * way;
  scheme.c[recurrence + 3] = start[0] + now * way;
  scheme.c[stages] = 1;
}

ElementaryWeights elementary_weights(const ThreeTermScheme& scheme) {
  Weights out = recurrence_weights(scheme);
  if (!scheme.finish) return out;
  const auto slopes = slope_weights(*scheme.finish, out);
  for (std::size_t i = 0; i < 4; ++i) add(out, scheme.finish->b[i], slopes[i]);
  return out;
}

}  // namespace superstep

#include "integrators/schemes/stabilised_schemes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/index.hpp"

namespace superstep {
namespace {

constexpr double rkc1_damping = 0.05;
constexpr double rkc2_damping = 2.0 / 13.0;

void clear_scheme(int stages, double beta, ThreeTermScheme& scheme) {
  scheme.stages = stages;
  scheme.beta = beta;
  scheme.uses_first_derivative = scheme.keeps_first_stage = true;
  scheme.finish.reset();
  for (auto* v : {&scheme.m, &scheme.n, &scheme.mt, &scheme.gt, &scheme.c}) v->assign(at(stages) + 1, 0.0);
}

/// T_j(w0) and its first two derivatives, free of cancellation near w0 = 1.
struct Chebyshev {
  explicit Chebyshev(double damping_over_s2)
      : d(damping_over_s2), square(d * (2 + d)), theta(std::asinh(std::sqrt(square))) {}
  [[nodiscard]] double w0() const noexcept { return 1 + d; }
  [[nodiscard]] double value(int j) const noexcept { return std::cosh(j * theta); }
  [[nodiscard]] double first(int j) const noexcept { return j * std::sinh(j * theta) / std::sinh(theta); }
  double d, square, theta;
};

double rkc1_beta(int s) {
  const Chebyshev t(rkc1_damping / (static_cast<double>(s) * s));
  return (1 + t.w0()) * t.first(s) / t.value(s);
}

void rkc1_scheme(int s, ThreeTermScheme& scheme) {
  first_order_chebyshev(s, rkc1_damping / (static_cast<double>(s) * s), scheme);
}

/// T''_s by the closed form, which is accurate here: s theta stays near sqrt(2 damping).
double rkc2_second(const Chebyshev& t, int s) {
  return (s * static_cast<double>(s) * t.value(s) - t.w0() * t.first(s)) / t.square;
}

double rkc2_beta(int s) {
  const Chebyshev t(rkc2_damping / (static_cast<double>(s) * s));
  return (t.w0() + 1) * rkc2_second(t, s) / t.first(s);
}

void rkc2_scheme(int s, ThreeTermScheme& scheme) {
  const Chebyshev t(rkc2_damping / (static_cast<double>(s) * s));
  const double w0 = t.w0(), w1 = t.first(s) / rkc2_second(t, s);
  clear_scheme(s, rkc2_beta(s), scheme);
  // b_0 = b_1 = b_2 = T''_2 / (T'_2)^2 with T''_2 = 4, T'_2 = 4 w0
  double b_two = 1 / (4 * w0 * w0), b_one = b_two, second_one = 4,
         second_two = 0;  // at j-2, j-1; T'' at j, j-1
  scheme.mt[1] = b_one * w1;
  for (int j = 2; j <= s; ++j) {
    if (j > 2) second_two = std::exchange(second_one, 4 * t.first(j - 1) + 2 * w0 * second_one - second_two);
    const double first = t.first(j), b = second_one / (first * first);
    const auto k = at(j);
    scheme.m[k] = 2 * b * w0 / b_one;
    scheme.n[k] = -b / b_two;
    scheme.mt[k] = 2 * b * w1 / b_one;
    scheme.gt[k] = -(1 - b_one * t.value(j - 1)) * scheme.mt[k];
    b_two = std::exchange(b_one, b);
  }
  set_stage_times(scheme);
}

double rkl1_beta(int s) {
  return static_cast<double>(s) * s + s;
}

void rkl1_scheme(int s, ThreeTermScheme& scheme) {
  clear_scheme(s, rkl1_beta(s), scheme);
  scheme.uses_first_derivative = scheme.keeps_first_stage = false;
  const double w1 = 2 / rkl1_beta(s);
  scheme.mt[1] = w1;
  for (std::size_t j = 2; j <= at(s); ++j) {
    const auto k = static_cast<double>(j);
    scheme.m[j] = (2 * k - 1) / k;
    scheme.n[j] = (1 - k) / k;
    scheme.mt[j] = scheme.m[j] * w1;
  }
  set_stage_times(scheme);
}

double rkl2_beta(int s) {
  return (static_cast<double>(s) * s + s - 2) / 2;
}

void rkl2_scheme(int s, ThreeTermScheme& scheme) {
  clear_scheme(s, rkl2_beta(s), scheme);
  const double w1 = 2 / rkl2_beta(s);
  const auto b = [](std::size_t j) {
    const auto k = static_cast<double>(j);
    return j < 2 ? 1.0 / 3.0 : (k * k + k - 2) / (2 * k * (k + 1));
  };
  scheme.mt[1] = b(1) * w1;
  for (std::size_t j = 2; j <= at(s); ++j) {
    const auto k = static_cast<double>(j);
    scheme.m[j] = (2 * k - 1) / k * b(j) / b(j - 1);
    scheme.n[j] = -(k - 1) / k * b(j) / b(j - 2);
    scheme.mt[j] = scheme.m[j] * w1;
    scheme.gt[j] = -(1 - b(j - 1)) * scheme.mt[j];
  }
  set_stage_times(scheme);
}

double rkg2_beta(int s) {
  return (s + 4.0) * (s - 1.0) / 3;
}

void rkg2_scheme(int s, ThreeTermScheme& scheme) {
  clear_scheme(s, rkg2_beta(s), scheme);
  const double w1 = 2 / rkg2_beta(s);
  const auto b = [](std::size_t j) {
    const auto k = static_cast<double>(j);
    return j == 0 ? 1.0 : j == 1 ? 1.0 / 3.0 : 4 * (k - 1) * (k + 4) / (3 * k * (k + 1) * (k + 2) * (k + 3));
  };
  scheme.mt[1] = w1;
  for (std::size_t j = 2; j <= at(s); ++j) {
    const auto k = static_cast<double>(j);
    scheme.m[j] = (2 * k + 1) / k * b(j) / b(j - 1);
    scheme.n[j] = -(k + 1) / k * b(j) / b(j - 2);
    scheme.mt[j] = scheme.m[j] * w1;
    scheme.gt[j] = -scheme.mt[j] * (1 - k * (k + 1) * b(j - 1) / 2);
  }
  set_stage_times(scheme);
}

}  // namespace

int StabilisedFamily::stages_for(double z) const {
  // beta grows like s^2: start below, then step up to the first that holds.
  int s = fewest_stages;
  const double growth = beta(1001) / (1001.0 * 1001.0);
  constexpr double countless = 1e9;  // more than any step may have; an int has no room for what else z asks
  const double wanted = std::sqrt(z / growth);
  if (!(wanted < countless)) return static_cast<int>(countless) + 1;
  const int guess = static_cast<int>(wanted) - 3;
  if (guess > s) s += (guess - s) / stage_step * stage_step;
  while (beta(s) < z) s += stage_step;
  return s;
}

ThreeTermScheme StabilisedFamily::scheme(int stages) const {
  ThreeTermScheme out;
  build(stages, out);
  return out;
}

int StabilisedFamily::stages_within_rounding(double rtol) const {
  constexpr double unit_roundoff = std::numeric_limits<double>::epsilon() / 2;
  constexpr double loosest = 1e-5;  // sums over many neighbours round more often than once
  const double limit =
      std::pow(std::min(rtol, loosest) / (10 * unit_roundoff * rounding_factor), 1.0 / rounding_power);
  return std::clamp(static_cast<int>(std::min<double>(limit, most_stages)), fewest_stages + 2, most_stages);
}

const StabilisedFamily& rkc1_family() {
  static const StabilisedFamily family{"rkc1", 1, 1, 1, rkc1_beta, rkc1_scheme};
  return family;
}
const StabilisedFamily& rkc2_family() {
  static const StabilisedFamily family{"rkc2", 2, 2, 1, rkc2_beta, rkc2_scheme};
  return family;
}
const StabilisedFamily& rkl1_family() {
  static const StabilisedFamily family{"rkl1", 1, 1, 1, rkl1_beta, rkl1_scheme};
  return family;
}
const StabilisedFamily& rkl2_family() {
  static const StabilisedFamily family{"rkl2", 2, 3, 2, rkl2_beta, rkl2_scheme};
  return family;
}
const StabilisedFamily& rkg2_family() {
  static const StabilisedFamily family{"rkg2", 2, 3, 2, rkg2_beta, rkg2_scheme};
  return family;
}

namespace {

/// Result of the finishing procedure for y' = z y from the recurrence's result `first`; `times_z` multiplies
/// a value by z.
template <class Value, class TimesZ>
Value finished(const FinishingProcedure& f, const Value& first, TimesZ times_z) {
  std::array<Value, 4> slope;
  Value out = first;
  for (std::size_t i = 0; i < 4; ++i) {
    Value stage = first;
    for (std::size_t j = 0; j < i; ++j) stage = stage + f.a[i - 1][j] * slope[j];
    slope[i] = times_z(stage);
    out = out + f.b[i] * slope[i];
  }
  return out;
}

/// Truncated power series in z.
struct Series {
  std::array<double, 6> term{};
  friend Series operator+(Series a, const Series& b) {
    for (std::size_t k = 0; k < a.term.size(); ++k) a.term[k] += b.term[k];
    return a;
  }
  friend Series operator*(double factor, Series a) {
    for (double& t : a.term) t *= factor;
    return a;
  }
  [[nodiscard]] Series times_z() const {
    Series out;
    for (std::size_t k = 1; k < term.size(); ++k) out.term[k] = term[k - 1];
    return out;
  }
};

}  // namespace

double stability_polynomial(const ThreeTermScheme& scheme, double z) {
  double before = 1, now = 1 + scheme.mt[1] * z;
  for (std::size_t j = 2; j <= at(scheme.recurrence_stages()); ++j) {
    const double next = 1 - scheme.m[j] - scheme.n[j] + (scheme.m[j] + scheme.mt[j] * z) * now +
                        scheme.n[j] * before + scheme.gt[j] * z;
    before = std::exchange(now, next);
  }
  return scheme.finish ? finished(*scheme.finish, now, [z](double y) { return z * y; }) : now;
}

double taylor_coefficient(const ThreeTermScheme& scheme, int k) {
  Series before{{1}}, now{{1, scheme.mt[1]}};
  for (std::size_t j = 2; j <= at(scheme.recurrence_stages()); ++j) {
    const Series constant{{1 - scheme.m[j] - scheme.n[j], scheme.gt[j]}};
    Series next = constant + scheme.m[j] * now + scheme.n[j] * before + scheme.mt[j] * now.times_z();
    before = std::exchange(now, next);
  }
  if (scheme.finish) now = finished(*scheme.finish, now, [](const Series& y) { return y.times_z(); });
  return now.term[at(k)];
}

}  // namespace superstep

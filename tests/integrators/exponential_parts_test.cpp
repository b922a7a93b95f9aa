/// The parts of the exponential: Bessel coefficients, responses of a tridiagonal matrix, the bound of a
/// residual, of polynomial and of rational spaces, moments of inputs.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numeric>
#include <random>

#include "integrators/detail/exponential/chebyshev_exponential.hpp"
#include "integrators/detail/exponential/duhamel_coefficients.hpp"
#include "integrators/detail/krylov/rational_projection.hpp"
#include "integrators/detail/krylov/residual_bound.hpp"
#include "integrators/detail/krylov/tridiagonal_response.hpp"

namespace superstep {
namespace {

TEST(ExponentialCoefficients, AreScaledBesselFunctions) {
  for (const double z : {1e-3, 0.5, 5.0, 80.0, 600.0}) {
    const auto c = exponential_series(z, 1e-16).c;
    for (std::size_t k = 0; k < c.size(); ++k) {
      const double expected = (k == 0 ? 1 : 2) * std::cyl_bessel_i(static_cast<double>(k), z) * std::exp(-z);
      EXPECT_NEAR(c[k], expected, 1e-13) << z << ' ' << k;
    }
  }
}

/// A state that deviates from a uniform one by `size`, in one mode.
TEST(ExponentialCoefficients, ReproduceTheExponentialUpToWhatTheyLeaveOut) {
  for (const double size : {1.0, 0.02, 1e-7})
    for (const double z : {0.1, 3.0, 1e3, 1e5})
      for (const double tolerance : {1e-2, 1e-6, 1e-12}) {
        const auto series = exponential_series(z, tolerance, {.deviation = size});
        EXPECT_LE(series.left_out, tolerance);
        EXPECT_NEAR(std::accumulate(series.c.begin(), series.c.end(), 0.0), 1, 1e-12);
        for (double x = 1; x > -1;
             x -= 0.003 + 0.01 * (1 - x)) {  // errors are largest where modes decay slowly
          double sum = 0;
          const double angle = std::acos(x);
          for (std::size_t k = 0; k < series.c.size(); ++k)
            sum += series.c[k] * std::cos(static_cast<double>(k) * angle);
          EXPECT_NEAR(size * sum, size * std::exp(-z * (1 - x)), series.left_out + 1e-13 * size)
              << size << ' ' << z << ' ' << tolerance << ' ' << x;
        }
      }
}

TEST(TridiagonalResponse, SolvesASmallSystem) {
  const double alpha[] = {2.0, 3.0}, beta[] = {0.5};
  const double times[] = {0.7};
  const auto response = tridiagonal_responses(alpha, beta, times).front();
  // y' = e_1 - T y by many small Runge-Kutta steps
  double a = 0, b = 0, sum = 0;
  constexpr int steps = 20'000;
  const double h = 0.7 / steps;
  for (int k = 0; k < steps; ++k) {
    const auto da = [](double p, double q) { return 1 - 2 * p - 0.5 * q; };
    const auto db = [](double p, double q) { return -0.5 * p - 3 * q; };
    const double ma = a + h / 2 * da(a, b), mb = b + h / 2 * db(a, b);
    a += h * da(ma, mb);
    b += h * db(ma, mb);
    sum += h * ma;  // by midpoints, of order two
  }
  EXPECT_NEAR(response.value[0], a, 1e-9);
  EXPECT_NEAR(response.value[1], b, 1e-9);
  EXPECT_NEAR(response.integral[0], sum, 1e-9);
}

/// With T = diag(l) the answers are known: (1 - exp(-l t))/l, and its integral (t - value)/l.
TEST(TridiagonalResponse, IsExactForAllTimesAndRates) {
  std::vector<double> alpha, times;
  for (double rate = 0; rate < 1e14; rate = rate == 0 ? 1e-6 : 10 * rate) alpha.push_back(rate);
  for (double t = 1e-9; t < 1e3; t *= 3) times.push_back(t);
  const std::vector<double> beta(alpha.size() - 1, 0.0);
  for (std::size_t first = 0; first < alpha.size(); ++first) {  // e_1 is the only entry that moves
    std::swap(alpha[0], alpha[first]);
    const auto responses = tridiagonal_responses(alpha, beta, times);
    for (std::size_t k = 0; k < times.size(); ++k) {
      const double t = times[k], rate = alpha[0];
      const double value = rate > 0 ? -std::expm1(-rate * t) / rate : t, x = rate * t;
      const double integral =
          x < 1e-3 ? t * t / 2 * (1 - x / 3 * (1 - x / 4 * (1 - x / 5))) : (t - value) / rate;
      EXPECT_NEAR(responses[k].value[0], value, response_error * t) << rate << ' ' << t;
      EXPECT_NEAR(responses[k].integral[0], integral, 1e-12 * integral + response_error * t * t / 2)
          << rate << ' ' << t;
      EXPECT_EQ(responses[k].value[1], 0);
    }
    std::swap(alpha[0], alpha[first]);
  }
}

/// y' + l y = t: the answer is (t - (1 - exp(-l t))/l)/l. Just after a kink as long after it.
TEST(TridiagonalResponse, FollowsARampForAllTimesAndRates) {
  for (double rate = 1e-6; rate < 1e12; rate *= 10)
    for (double t = 1e-9; t < 1e3; t *= 7) {
      const double alpha[] = {rate}, x = rate * t;
      double exact = 0, term = t * t / 2;  // by its series where the closed form cancels
      for (int k = 3; k < 40; ++k) exact += term, term *= -x / k;
      if (x > 1) exact = (t + std::expm1(-x) / rate) / rate;
      // A constant that began eight times as long ago shares the contour.
      const TridiagonalInput inputs[] = {{.since = t, .jump = 0, .kink = 1},
                                         {.since = 7.9 * t, .jump = 0, .kink = 0}};
      EXPECT_NEAR(tridiagonal_response(alpha, {}, inputs).value[0], exact, response_error * t * t / 2)
          << rate << ' ' << t;
    }
}

TEST(ResidualBound, BoundsTheIntegralWithoutBeingFarOff) {
  // The matrix of a rod: alpha = 2, beta = 1, from the first entry on; few rows for long times and many for
  // short ones.
  for (const std::size_t rows : {2, 5, 20, 80})
    for (const double t : {0.5, 5.0, 50.0, 500.0}) {
      ResidualBound bound(t);
      for (std::size_t j = 0; j < rows; ++j) bound.add_row(2, 1);
      const std::vector<double> alpha(rows, 2.0), beta(rows - 1, 1.0);
      const double times[] = {t};
      const double exact = std::abs(tridiagonal_responses(alpha, beta, times).front().integral.back());
      const double found = std::exp(bound.log_integral(t));
      if (exact < 1e-10) continue;  // known to rounding only
      EXPECT_GE(found, 0.999 * exact) << rows << ' ' << t;
      EXPECT_LT(found, 30 * exact) << rows << ' '
                                   << t;  // a Chernoff bound: within the root of the row number
    }
}

TEST(TridiagonalResponse, AddsUpWhatAnInputDoes) {
  const double alpha[] = {2.0, 3.0, 1.0}, beta[] = {0.5, 0.25};
  // q jumps to 1 at t = 0, rises by 2 a second from 0.5 on, falls to 0.2 at 0.9 and stays; looked at
  // from 1.2.
  const TridiagonalInput inputs[] = {{.since = 0.3, .jump = 0.2 - 1.8, .kink = -2},
                                     {.since = 0.7, .jump = 0, .kink = 2},
                                     {.since = 1.2, .jump = 1}};
  const auto response = tridiagonal_response(alpha, beta, inputs);
  double y[3] = {}, sum[3] = {};
  constexpr int steps = 120'000;
  const double h = 1.2 / steps;
  for (int k = 0; k < steps; ++k) {
    const double t = (k + 0.5) * h, q = t < 0.5 ? 1 : t < 0.9 ? 1 + 2 * (t - 0.5) : 0.2;
    const auto rate = [&](const double* v, int j) {
      return (j == 0 ? q : 0) - alpha[j] * v[j] - (j > 0 ? beta[j - 1] * v[j - 1] : 0) -
             (j < 2 ? beta[j] * v[j + 1] : 0);
    };
    double middle[3];
    for (int j = 0; j < 3; ++j) middle[j] = y[j] + h / 2 * rate(y, j);
    double next[3];
    for (int j = 0; j < 3; ++j) next[j] = y[j] + h * rate(middle, j);
    for (int j = 0; j < 3; ++j) sum[j] += h * middle[j], y[j] = next[j];
  }
  for (std::size_t j = 0; j < 3; ++j) {
    EXPECT_NEAR(response.value[j], y[j], 1e-8) << j;
    EXPECT_NEAR(response.integral[j], sum[j], 1e-8) << j;
  }
}

TEST(DuhamelCoefficients, MomentsHaveTheirClosedForms) {
  for (const double mu : {0.0, 1e-6, 0.3, 5.0, 400.0, 1e6}) {
    const auto moments = exponential_moments(mu, 2);
    const double zeroth = mu > 0 ? -std::expm1(-mu) / mu : 1;
    EXPECT_NEAR(moments[0], zeroth, 1e-14 * zeroth + 1e-15) << mu;
    if (mu < 0.1) continue;  // the closed form of the first one cancels there
    // integral of (1 - 2 w) exp(-mu w) = zeroth - 2 (1 - (1 + mu) exp(-mu))/mu^2
    EXPECT_NEAR(moments[1], zeroth - 2 * (1 - (1 + mu) * std::exp(-mu)) / (mu * mu), 1e-13) << mu;
  }
}

/// A diagonal A, whose functions are plain; rates over twelve decades, one of them 0 as in a closed network.
class RationalSpace {
 public:
  explicit RationalSpace(double pole) : pole_(pole), projection_(pole) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> decades(-4, 8), entry(-1, 1);
    rate_(0) = 0;
    for (Eigen::Index k = 1; k < size; ++k) rate_(k) = std::pow(10, decades(random));
    basis_.emplace_back(size);
    for (double& x : basis_.front()) x = entry(random);
    basis_.front().normalize();
  }
  /// Returns the length of what the new image has outside the space before.
  double add_vector(double wrong = 0) {
    Vector image = basis_.back().array() / (1 + pole_ * rate_.array());
    image(size / 2) += wrong;
    std::vector<double> products(basis_.size(), 0.0);
    for (int round = 0; round < 2; ++round)
      for (std::size_t j = 0; j < basis_.size(); ++j) {
        const double part = basis_[j].dot(image);
        products[j] += part;
        image -= part * basis_[j];
      }
    projection_.add_vector(products);
    basis_.push_back(image.normalized());
    return image.norm();
  }
  [[nodiscard]] double error_at(double t) const {
    const auto value = projection_.response(t).value;
    Vector sum = Vector::Zero(size);
    for (std::size_t j = 0; j < value.size(); ++j) sum += value[j] * basis_[j];
    for (Eigen::Index k = 0; k < size; ++k) {
      const double once = rate_(k) > 0 ? -std::expm1(-t * rate_(k)) / rate_(k) : t;
      sum(k) -= (once / pole_ - std::expm1(-t * rate_(k))) * basis_.front()(k);
    }
    return sum.norm();
  }
  [[nodiscard]] RationalError bound_at(double t) const { return projection_.error(t); }

 private:
  static constexpr Eigen::Index size = 60;
  using Vector = Eigen::VectorXd;
  double pole_;
  Vector rate_{size};
  std::vector<Vector> basis_;
  RationalProjection projection_;
};

TEST(RationalError, IsABoundAndNotAMuchLargerOne) {
  constexpr double pole = 0.1;
  RationalSpace space(pole);
  for (int m = 1; m <= 24; ++m) {
    const double beyond = space.add_vector();
    if (m < 3) continue;
    for (const double t : {0.1, 0.5, 1.0, 3.0, 10.0}) {
      const double error = space.error_at(t), bound = beyond * space.bound_at(t).next;
      const double rounding = 1e-13 * t / pole;
      EXPECT_LE(error, bound + rounding) << m << ' ' << t;
      EXPECT_LE(bound, 20 * (error + rounding)) << m << ' ' << t;
    }
  }
}

TEST(RationalError, CountsWrongImages) {
  constexpr double wrong = 1e-6;
  RationalSpace space(0.1);
  bool needed = false;
  for (int m = 1; m <= 24; ++m) {
    const double beyond = space.add_vector(wrong);
    for (const double t : {0.1, 1.0, 10.0}) {
      const auto [next, images] = space.bound_at(t);
      const double error = space.error_at(t);
      EXPECT_LE(error, beyond * next + std::sqrt(m) * wrong * images) << m << ' ' << t;
      needed = needed || error > beyond * next;
    }
  }
  EXPECT_TRUE(needed);
}

}  // namespace
}  // namespace superstep

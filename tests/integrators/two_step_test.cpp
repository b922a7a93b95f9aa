/// Two-step Runge-Kutta-Chebyshev: conditions of order, and stability.

#include <gtest/gtest.h>

#include <cmath>

#include "integrators/schemes/stabilised_schemes.hpp"
#include "integrators/schemes/two_step_chebyshev.hpp"

namespace superstep {
namespace {

struct Built {
  TwoStepChebyshev coefficients;
  ThreeTermScheme scheme;
};

Built built(int stages, double ratio) {
  Built out{two_step_chebyshev(stages, ratio), {}};
  two_step_recurrence(stages, out.coefficients, out.scheme);
  return out;
}

TEST(TwoStepChebyshev, MeetsTheConditionsOfOrderTwoForAnyStepsAndStages) {
  for (const int stages : {2, 3, 7, 40, 600})
    for (const double ratio : {0.01, 0.5, 1.0, 1.7, 3.0}) {
      const auto [coefficients, scheme] = built(stages, ratio);
      const double nu = coefficients.before;
      double factorial = 1, past = 1;
      for (int k = 0; k <= 3; ++k) {
        const double made = nu * past / factorial + (1 - nu) * taylor_coefficient(scheme, k);
        const double left = k < 3 ? 0 : two_step_error(coefficients, scheme, ratio) * (1 + nu * ratio);
        EXPECT_NEAR(made + left, 1 / factorial, 1e-11) << stages << ' ' << ratio << ' ' << k;
        factorial *= k + 1;
        past *= -ratio;
      }
      EXPECT_NEAR(scheme.c.back(), coefficients.reach, 1e-9 * coefficients.reach) << "inputs are taken there";
    }
}

/// zeta^2 = (1 - nu) R(-z) zeta + nu.
TEST(TwoStepChebyshev, DampsAllOfItsInterval) {
  for (const int stages : {2, 3, 7, 40, 200})
    for (const double ratio : {0.01, 0.5, 1.0, 3.0}) {
      const auto [coefficients, scheme] = built(stages, ratio);
      EXPECT_NEAR(scheme.beta / coefficients.beta, 1, 1e-9);
      const auto largest = [&](double z) {
        const double b = 0.5 * (1 - coefficients.before) * stability_polynomial(scheme, -z);
        return std::abs(b) + std::sqrt(b * b + coefficients.before);
      };
      for (int k = 1; k <= 1000; ++k)
        EXPECT_LT(largest(coefficients.beta * k / 1000), 1) << stages << ' ' << ratio << ' ' << k;
      EXPECT_GT(largest(1.2 * coefficients.beta), 1) << stages << ' ' << ratio;
    }
}

TEST(TwoStepChebyshev, ReachesAlmostTwiceAsFarAsRkc) {
  for (const int stages : {2, 5, 20, 200})
    EXPECT_GT(two_step_chebyshev(stages, 1).beta, 1.65 * rkc2_family().beta(stages)) << stages;
  for (const double z : {0.1, 3.0, 100.0, 1e6}) {
    const int stages = two_step_stages(z, 1);
    EXPECT_GE(two_step_chebyshev(stages, 1).beta, z);
    if (stages > fewest_two_step_stages) {
      EXPECT_LT(two_step_chebyshev(stages - 1, 1).beta, z);
    }
  }
}

}  // namespace
}  // namespace superstep

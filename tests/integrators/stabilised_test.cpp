/// Stabilised families against closed forms of their polynomials, for every stage count up to 200.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "integrators/schemes/stabilised_schemes.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using Real = long double;

constexpr int most_stages = 200;

/// Value and first two derivatives of an orthogonal polynomial of degree s.
struct Jet {
  Real value, first, second;
};

/// Differentiates p_j = (a_j x) p_{j-1} - b_j p_{j-2}, p_0 = 1, p_1 = p1 x, twice along the way.
template <class A, class B>
Jet three_term_jet(int s, Real x, Real p1, A a, B b) {
  Jet before{1, 0, 0}, now{p1 * x, p1, 0};
  if (s == 0) return before;
  for (int j = 2; j <= s; ++j) {
    const Real aj = a(j), bj = b(j);
    const Jet next{aj * x * now.value - bj * before.value,
                   aj * (now.value + x * now.first) - bj * before.first,
                   aj * (2 * now.first + x * now.second) - bj * before.second};
    before = std::exchange(now, next);
  }
  return now;
}

Jet chebyshev(int s, Real x) {
  return three_term_jet(
      s, x, 1, [](int) { return Real{2}; }, [](int) { return Real{1}; });
}

Jet legendre(int s, Real x) {
  return three_term_jet(
      s, x, 1, [](int j) { return Real(2 * j - 1) / Real(j); }, [](int j) { return Real(j - 1) / Real(j); });
}

/// Gegenbauer polynomial with index 3/2: j C_j = (2j + 1) x C_{j-1} - (j + 1) C_{j-2}, C_1 = 3x.
Jet gegenbauer(int s, Real x) {
  return three_term_jet(
      s, x, 3, [](int j) { return Real(2 * j + 1) / Real(j); }, [](int j) { return Real(j + 1) / Real(j); });
}

using Polynomial = Jet (*)(int, Real);

/// P(w0 + w1 z)/P(w0) with w1 = P/P' at w0, so that R'(0) = 1.
Real first_order(Polynomial p, int s, Real w0, Real z) {
  const Jet at = p(s, w0);
  return p(s, w0 + at.value / at.first * z).value / at.value;
}

/// a + b P(w0 + w1 z) with R(0) = R'(0) = R''(0) = 1: b w1 P' = 1 and b w1^2 P'' = 1.
Real second_order(Polynomial p, int s, Real w0, Real z) {
  const Jet at = p(s, w0);
  const Real w1 = at.first / at.second, b = at.second / (at.first * at.first);
  return 1 + b * (p(s, w0 + w1 * z).value - at.value);
}

Real rkc2_w0(int s) {
  return 1 + 2.0L / 13 / (Real(s) * Real(s));
}
Real rkc1_w0(int s) {
  return 1 + 0.05L / (Real(s) * Real(s));
}

struct FamilyCase {
  const char* name;
  const StabilisedFamily& (*family)();
  Real (*closed_form)(int s, Real z);  ///< null: rock_test.cpp has its product form
};

const FamilyCase families[] = {
    {"rkc1", rkc1_family, [](int s, Real z) { return first_order(chebyshev, s, rkc1_w0(s), z); }},
    {"rkc2", rkc2_family, [](int s, Real z) { return second_order(chebyshev, s, rkc2_w0(s), z); }},
    {"rkl1", rkl1_family, [](int s, Real z) { return first_order(legendre, s, 1, z); }},
    {"rkl2", rkl2_family, [](int s, Real z) { return second_order(legendre, s, 1, z); }},
    {"rkg2", rkg2_family, [](int s, Real z) { return second_order(gegenbauer, s, 1, z); }},
    {"rock2", rock2_family, nullptr},
    {"rock4", rock4_family, nullptr},
};

std::vector<int> stage_counts(const StabilisedFamily& family) {
  std::vector<int> counts;
  const int last = std::min(most_stages, family.most_stages);
  for (int s = std::max(2, family.fewest_stages); s <= last; s += family.stage_step) counts.push_back(s);
  return counts;
}

/// |R| at distance z down the negative axis.
double growth(const ThreeTermScheme& scheme, double z) {
  return std::abs(stability_polynomial(scheme, -z));
}

/// First z >= beta with |R| > 1, to 1e-9 of beta.
double numerical_limit(const ThreeTermScheme& scheme) {
  constexpr double above_one = 1 + 1e-9;  // values of 1 at beta itself come with rounding
  const double pace = 1e-3 * scheme.beta;
  double high = scheme.beta;
  while (growth(scheme, high) <= above_one && high < 2 * scheme.beta) high += pace;
  double low = std::max(scheme.beta, high - pace);
  while (high - low > 1e-9 * scheme.beta) {
    const double middle = 0.5 * (low + high);
    (growth(scheme, middle) > above_one ? high : low) = middle;
  }
  return high;
}

class EveryFamily : public ::testing::TestWithParam<FamilyCase> {
 protected:
  [[nodiscard]] const StabilisedFamily& family() const { return GetParam().family(); }
};

INSTANTIATE_TEST_SUITE_P(Families, EveryFamily, ::testing::ValuesIn(families),
                         [](const auto& one) { return std::string(one.param.name); });

TEST_P(EveryFamily, CountsStagesThatNoStepMayHave) {
  for (const double z : {1e12, 1e20, 1e40, 1e300})
    EXPECT_GT(family().stages_for(z), family().most_stages) << z;
}

TEST_P(EveryFamily, IsStableUpToBeta) {
  for (const int s : stage_counts(family())) {
    const ThreeTermScheme scheme = family().scheme(s);
    const int points = 20 * s;  // some twenty on each ripple
    double worst = 0;
    for (int k = 0; k <= points; ++k)
      worst = std::max(worst, growth(scheme, 0.999 * scheme.beta * k / points));
    EXPECT_LE(worst, 1 + 1e-10) << s;
  }
}

TEST_P(EveryFamily, GrowsJustBeyondItsLimit) {
  for (const int s : stage_counts(family())) {
    const ThreeTermScheme scheme = family().scheme(s);
    const double limit = numerical_limit(scheme);
    EXPECT_GT(growth(scheme, 1.001 * limit), 1) << s;
    EXPECT_GE(limit, scheme.beta) << s;
    EXPECT_LE(limit, 1.2 * scheme.beta) << s;
  }
}

TEST_P(EveryFamily, MeetsItsOrderConditions) {
  for (const int s : stage_counts(family())) {
    const ThreeTermScheme scheme = family().scheme(s);
    EXPECT_NEAR(taylor_coefficient(scheme, 0), 1, 1e-12) << s;
    EXPECT_NEAR(taylor_coefficient(scheme, 1), 1, 1e-11) << s;
    if (family().order >= 2) {
      EXPECT_NEAR(taylor_coefficient(scheme, 2), 0.5, 1e-10) << s;
      if (family().order == 4) {
        EXPECT_NEAR(taylor_coefficient(scheme, 3), 1.0 / 6, 1e-10) << s;
        EXPECT_NEAR(taylor_coefficient(scheme, 4), 1.0 / 24, 1e-10) << s;
      }
    } else {
      EXPECT_LT(taylor_coefficient(scheme, 2), 0.5) << s;
    }
    EXPECT_NEAR(scheme.c[static_cast<std::size_t>(s)], 1, 1e-11) << s;
  }
}

TEST_P(EveryFamily, IsItsClosedForm) {
  if (!GetParam().closed_form) GTEST_SKIP() << "its polynomial has no closed form";
  for (const int s : stage_counts(family())) {
    const ThreeTermScheme scheme = family().scheme(s);
    // One rounding of z alone moves R by z |R'| epsilon <= 2 s^2 epsilon; s stages and their coefficients add
    // theirs. 5e-13 at 10 stages, 1.4e-10 at 200.
    const double tolerance = 1e-13 + 16.0 * s * s * std::numeric_limits<double>::epsilon();
    const int points = 97;  // a prime: no sampling of the ripples in step
    for (int k = 0; k <= points; ++k) {
      const double z = -scheme.beta * k / points;
      const auto closed = static_cast<double>(GetParam().closed_form(s, z));
      EXPECT_NEAR(stability_polynomial(scheme, z), closed, tolerance) << s << ' ' << z;
    }
  }
}

TEST_P(EveryFamily, TakesTheFewestStagesThatHold) {
  const auto& f = family();
  for (double z = 0.1; z < 3e4; z *= 1.013) {
    const int s = f.stages_for(z);
    EXPECT_GE(f.beta(s), z);
    EXPECT_EQ((s - f.fewest_stages) % f.stage_step, 0) << z;
    EXPECT_GE(s, f.fewest_stages) << z;
    if (s > f.fewest_stages) {
      EXPECT_LT(f.beta(s - f.stage_step), z);
    }
  }
  for (const int s : stage_counts(f)) EXPECT_EQ(f.stages_for(f.beta(s)), s);  // the limit itself still holds
}

TEST(Rkc2, HasItsExactLimits) {
  const std::pair<int, double> exact[] = {{2, 1.9630},  {3, 5.2304},   {5, 15.685},
                                          {10, 64.688}, {50, 1632.80}, {200, 26134.6}};
  for (const auto& [s, beta] : exact) EXPECT_NEAR(rkc2_family().beta(s) / beta, 1, 5e-5) << s;
}

TEST(Rkc2, TwoStagesAreNotEnoughAtTwoAndAHalf) {
  // ceil(sqrt(1.54 z)) says 2 here; R(-2.5) of two stages grows.
  EXPECT_EQ(rkc2_family().stages_for(2.5), 3);
  EXPECT_GT(growth(rkc2_family().scheme(2), 2.5), 1);
  EXPECT_LT(growth(rkc2_family().scheme(3), 2.5), 1);
}

struct OrderCase {
  std::string spec;  ///< with {} for the step
  int order;
  double largest_step;
};

class Order : public ::testing::TestWithParam<OrderCase> {};

std::vector<OrderCase> order_cases() {
  // With as many stages as stability asks for: the count falls while the step is halved.
  std::vector<OrderCase> cases = {
      {"rkc:step={}", 2, 0.05},
      {"rkc:order=1,step={}", 1, 0.02},
      {"rkl:step={}", 2, 0.05},
      {"rkl:order=1,step={}", 1, 0.02},
      {"rkg:step={}", 2, 0.05},
      {"rock:step={}", 4, 0.2},
      {"trapezoidal:step={}", 2, 0.05},
      {"trapezoidal:solver=pcg,step={}", 2, 0.05},
      {"trapezoidal:phi=0.6,step={}", 1, 0.02},
      {"trapezoidal:phi=1,step={}", 1, 0.02},
  };
  for (const int stages : {2, 3, 4, 5, 8, 13}) {
    cases.push_back({fmt::format("rkc:stages={},step={{}}", stages), 2, 0.02});
    cases.push_back({fmt::format("rkc:order=1,stages={},step={{}}", stages), 1, 0.02});
    cases.push_back({fmt::format("rkl:order=1,stages={},step={{}}", stages), 1, 0.02});
  }
  for (const int stages : {5, 6, 8, 13})
    cases.push_back({fmt::format("rock:stages={},step={{}}", stages), 4, 0.1});
  for (const int stages : {3, 5, 9, 13}) {
    cases.push_back({fmt::format("rkl:stages={},step={{}}", stages), 2, 0.02});
    cases.push_back({fmt::format("rkg:stages={},step={{}}", stages), 2, 0.02});
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(StepHalving, Order, ::testing::ValuesIn(order_cases()), [](const auto& one) {
  std::string name = one.param.spec;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST_P(Order, IsReachedWhenTheStepIsHalved) {
  test::Problem problem(test::random_graph({.nodes = 25, .seed = 7, .contrast = 4, .sources = true}));
  constexpr double t_end = 0.4;
  const auto exact = problem.exact(t_end);
  std::vector<double> errors;
  for (int level = 0; level < 5; ++level) {
    const double step = GetParam().largest_step / (1 << level);
    const auto result = test::run(fmt::format(fmt::runtime(GetParam().spec), step), problem, {t_end});
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    errors.push_back(test::rms_difference(result.states.back(), exact));
  }
  ASSERT_GT(errors.back(), 1e3 * std::numeric_limits<double>::epsilon());  // below, the slope is noise
  EXPECT_NEAR(std::log2(errors[3] / errors[4]), GetParam().order, 0.15);
}

}  // namespace
}  // namespace superstep

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "integrators/detail/krylov/arnoldi_kernels.hpp"
#include "integrators/detail/krylov/lanczos_kernels.hpp"
#include "integrators/detail/krylov/lanczos_space.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

/// Numbers without any pattern in [-1, 1).
std::vector<double> numbers(std::size_t n, std::uint64_t seed) {
  std::vector<double> out(n);
  for (double& x : out) {
    seed = seed * 6364136223846793005U + 1442695040888963407U;
    x = static_cast<double>(seed >> 11) * 0x1p-52 - 1;
  }
  return out;
}

template <class Kept>
class LanczosKernels : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(LanczosKernels, Precisions);

constexpr std::size_t first = 3, last = 94;  // neither begins nor ends with a whole vector register

TYPED_TEST(LanczosKernels, DoWhatTheRecurrenceSays) {
  const auto v = numbers(100, 1), w = numbers(100, 2), c = numbers(100, 3);
  for (const auto& kernel : lanczos_kernels<TypeParam>()) {
    std::vector<TypeParam> kept(100, 7);
    auto next = w;
    const LanczosPass pass{.next = next.data(), .now = v.data(), .capacity = c.data()};
    const double projected = kernel.keep_and_project(pass, 0.25, kept.data(), first, last);
    const double square = kernel.subtract(pass, 0.5, first, last);
    double expected_projected = 0, expected_square = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      const bool inside = i >= first && i < last;
      EXPECT_EQ(kept[i], inside ? static_cast<TypeParam>(0.25 * v[i]) : TypeParam(7)) << kernel.name;
      const double left = inside ? w[i] - 0.5 * v[i] : w[i];
      EXPECT_NEAR(next[i], left, 1e-15) << kernel.name;
      if (inside) expected_projected += c[i] * w[i] * v[i], expected_square += c[i] * left * left;
    }
    constexpr double roundings = 1e-14;  // of a hundred terms of size 1
    EXPECT_NEAR(projected, expected_projected, roundings) << kernel.name;
    EXPECT_NEAR(square, expected_square, roundings) << kernel.name;
  }
}

TYPED_TEST(LanczosKernels, AddFourVectors) {
  std::vector<std::vector<TypeParam>> vector;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const auto values = numbers(100, 4 + k);
    vector.emplace_back(values.begin(), values.end());
  }
  const TypeParam* vectors[] = {vector[0].data(), vector[1].data(), vector[2].data(), vector[3].data()};
  const double factor[] = {1, -2, 3, 0.5};
  const auto before = numbers(100, 9);
  for (const auto& kernel : lanczos_kernels<TypeParam>()) {
    auto sum = before;
    kernel.add_four(vectors, factor, sum.data(), first, last);
    for (std::size_t i = 0; i < 100; ++i) {
      double expected = before[i];
      for (std::size_t k = 0; k < 4 && i >= first && i < last; ++k) expected += factor[k] * vector[k][i];
      EXPECT_NEAR(sum[i], expected, 1e-14) << kernel.name;  // roundings of terms of size 1
    }
  }
}

TYPED_TEST(LanczosKernels, WideOnesAgreeBitByBit) {
  const auto kernels = lanczos_kernels<TypeParam>();
  if (kernels.size() < 3) GTEST_SKIP() << "this machine has no two of them";
  const auto v = numbers(100, 1), w = numbers(100, 2), c = numbers(100, 3);
  double projected[2], square[2];
  std::vector<double> next[2];
  for (std::size_t k = 0; k < 2; ++k) {
    std::vector<TypeParam> kept(100);
    next[k] = w;
    const LanczosPass pass{.next = next[k].data(), .now = v.data(), .capacity = c.data()};
    projected[k] = kernels[k].keep_and_project(pass, 0.3, kept.data(), first, last);
    square[k] = kernels[k].subtract(pass, 0.7, first, last);
  }
  EXPECT_EQ(projected[0], projected[1]);
  EXPECT_EQ(square[0], square[1]);
  EXPECT_EQ(next[0], next[1]);
}

TEST(ArnoldiKernels, AddAndProject) {
  const auto v = numbers(100, 1), w = numbers(100, 2), d = numbers(100, 3), other = numbers(100, 4);
  for (const auto& kernel : arnoldi_kernels())
    for (const bool with_itself : {false, true})
      for (const bool diagonal : {false, true}) {
        auto sum = w;
        const double* with = with_itself ? sum.data() : other.data();
        const double projected = diagonal
                                     ? kernel.add_diagonal(sum.data(), d.data(), v.data(), with, first, last)
                                     : kernel.subtract(sum.data(), 0.4, v.data(), with, first, last);
        double expected = 0;
        for (std::size_t i = 0; i < 100; ++i) {
          const bool inside = i >= first && i < last;
          const double value = inside ? w[i] + (diagonal ? d[i] : -0.4) * v[i] : w[i];
          EXPECT_NEAR(sum[i], value, 1e-15) << kernel.name;
          if (inside) expected += value * (with_itself ? value : other[i]);
        }
        EXPECT_NEAR(projected, expected, 1e-13) << kernel.name;  // roundings of a sum of size 40
      }
}

/// Sums of vectors that are kept in single precision are off by their roundings, and by no more.
TEST(LanczosSpace, SinglePrecisionRoundsWhatIsKeptAndNothingElse) {
  test::Problem problem(test::random_graph({.nodes = 200, .seed = 7, .contrast = 1e4, .fixed = 2}));
  Rhs& rhs = *problem.rhs;
  const std::size_t n = rhs.size();
  constexpr std::size_t vectors = 30;
  std::vector<double> sums[2], off[2];
  double rounding = 0;
  for (const auto storage : {LanczosSpace::Storage::single, LanczosSpace::Storage::full}) {
    LanczosSpace::Recent recent;
    LanczosSpace space(rhs, storage, recent);
    space.open(1.0, false, [&](std::span<double> start) { rhs(0, problem.initial, start); });
    ASSERT_EQ(space.grow(1.0, 0.0, 1.0, {}, vectors, nullptr), LanczosSpace::Growth::full);
    const bool single = storage == LanczosSpace::Storage::single;
    auto& sum = sums[single ? 0 : 1];
    sum.assign(n, 0.0);
    const std::vector<double> ones(vectors, 1.0);
    const std::span<double> states[] = {sum};
    space.add_to(states, {ones});
    EXPECT_NEAR(space.entry(3, ones), sum[3], 1e-14 * std::sqrt(vectors) * std::abs(sum[3]) + 1e-14);
    off[single ? 0 : 1].assign(space.alpha().begin(), space.alpha().end());
    if (single) rounding = space.rounding();
  }
  EXPECT_EQ(off[0], off[1]) << "the recurrence runs in double precision";
  double square = 0;
  for (std::size_t i = 0; i < n; ++i)
    square += rhs.capacities()[i] * (sums[0][i] - sums[1][i]) * (sums[0][i] - sums[1][i]);
  EXPECT_LE(std::sqrt(square), rounding * vectors);  // each has length 1
  EXPECT_GE(std::sqrt(square), 0.01 * rounding * std::sqrt(vectors)) << "it is not single precision at all";
}

}  // namespace
}  // namespace superstep

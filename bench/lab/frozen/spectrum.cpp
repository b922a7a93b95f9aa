#include "bench/lab/frozen/spectrum.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/lab/mode.hpp"
#include "bench/lab/perturbation.hpp"
#include "rhs/lanczos.hpp"

namespace superstep {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::MatrixXd;

// A pair with a smaller imaginary part than this part of the radius stays inside the stability regions of
// the methods looked at, which are that wide everywhere.
constexpr double nearly_real = 1e-4;
constexpr double nothing = 1e-9;  // part of the radius: what rounding makes of an eigenvalue 0
constexpr double slow = 1e-6;     // part of the radius: rounding turns a double one by the root of that

/// What of a set of eigenvalues matters.
struct Extremes {
  std::size_t limiting = 0;  ///< its number
  double radius = 0, imaginary = 0, rising = 0;
};

Extremes extremes_of(const std::vector<Complex>& values) {
  Extremes out;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& value : values) out.radius = std::max(out.radius, std::abs(value));
  for (std::size_t k = 0; k < values.size(); ++k) {
    out.rising = std::max(out.rising, values[k].real());
    if (std::abs(values[k]) <= slow * out.radius) continue;
    out.imaginary = std::max(out.imaginary, std::abs(values[k].imag()));
    if (const double limit = euler_limit(values[k]); limit < shortest) {
      shortest = limit;
      out.limiting = k;
    }
  }
  return out;
}

void take_extremes(const std::vector<Complex>& values, const FrozenJacobian& frozen, Spectrum& out) {
  const Extremes found = extremes_of(values);
  out.limiting = values[found.limiting];
  out.euler_limit = euler_limit(out.limiting);
  out.kind = found.imaginary > nearly_real * found.radius ? Spectrum::Kind::complex : Spectrum::Kind::real;
  if (!frozen.decays && found.rising > nothing * found.radius) out.rising = found.rising;
}

/// Residual of an eigenpair whose shape is real.
double residual_of(FrozenRhs& rhs, const std::vector<double>& shape, double eigenvalue) {
  std::vector<double> image(shape.size());
  rhs.linear_stage({.y1 = shape.data(), .a = -eigenvalue, .d = 1}, image);
  return std::sqrt(capacity_product(rhs, image, image));
}

/// Scales rows against columns by powers of two until they are as large, which keeps eigenvalues and spares
/// them the rounding of far larger entries. Source: Osborne (1960), doi:10.1145/321043.321048.
std::vector<double> balance(Matrix& a) {
  const auto n = a.rows();
  std::vector<double> scale(static_cast<std::size_t>(n), 1.0);
  constexpr int most_passes = 50;
  bool moved = true;
  for (int pass = 0; pass < most_passes && moved; ++pass) {
    moved = false;
    for (Eigen::Index i = 0; i < n; ++i) {
      const double own = std::abs(a(i, i));
      const double column = a.col(i).lpNorm<1>() - own, row = a.row(i).lpNorm<1>() - own;
      if (!(column > 0) || !(row > 0)) continue;
      const double factor = std::exp2(std::round(0.5 * std::log2(row / column)));
      if (column * factor + row / factor >= 0.95 * (column + row)) continue;
      scale[static_cast<std::size_t>(i)] *= factor;
      a.col(i) *= factor;
      a.row(i) /= factor;
      moved = true;
    }
  }
  return scale;
}

Spectrum all_eigenvalues(FrozenRhs& rhs) {
  const auto& frozen = rhs.frozen();
  const auto n = static_cast<Eigen::Index>(rhs.size());
  Matrix a = Matrix::Zero(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (auto k = frozen.pattern.column_begin[static_cast<std::size_t>(j)];
         k < frozen.pattern.column_begin[static_cast<std::size_t>(j) + 1]; ++k)
      a(frozen.pattern.row[static_cast<std::size_t>(k)], j) = frozen.values[static_cast<std::size_t>(k)];
  const auto scale = balance(a);
  const Eigen::EigenSolver<Matrix> solver(a);
  std::vector<Complex> values(solver.eigenvalues().data(), solver.eigenvalues().data() + n);

  Spectrum out;
  out.found_by = "all eigenvalues";
  take_extremes(values, frozen, out);
  const Eigen::MatrixXcd vectors = solver.eigenvectors();  // computed anew at every call
  const Extremes found = extremes_of(values);
  const auto shape_of = [&](std::size_t mode, const auto& part) {
    std::vector<double> shape(rhs.size());
    for (std::size_t i = 0; i < shape.size(); ++i)
      shape[i] = scale[i] * part(vectors(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(mode)));
    return shape;
  };
  const auto real = [](Complex entry) { return entry.real(); };
  const auto imaginary = [](Complex entry) { return entry.imag(); };
  out.shape = shape_of(found.limiting, real);
  normalise(rhs, out.shape);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const bool counts = values[k].real() < 0 && std::abs(values[k]) > slow * found.radius;
    if (!counts || values[k].imag() < 0) continue;  // one of each pair
    out.modes.push_back({.real = shape_of(k, real), .imaginary = {}});
    if (values[k].imag() > 0) out.modes.back().imaginary = shape_of(k, imaginary);
  }
  if (out.limiting.imag() == 0) out.residual = residual_of(rhs, out.shape, out.limiting.real());
  return out;
}

/// Orthonormal basis of the Krylov space of `start`, the matrix of J in it, and how far it leads out of it.
struct Arnoldi {
  std::vector<std::vector<double>> basis;
  Matrix projected;
  double next = 0;
};

Arnoldi arnoldi_space(FrozenRhs& rhs, std::vector<double> v, std::size_t most) {
  const std::size_t size = std::min(most, v.size());
  Arnoldi space;
  space.projected = Matrix::Zero(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  std::vector<double> w(v.size());
  normalise(rhs, v);
  while (true) {
    space.basis.push_back(v);
    const auto k = static_cast<Eigen::Index>(space.basis.size()) - 1;
    rhs.linear_stage({.y1 = v.data(), .a = 0, .d = 1}, w);
    for (int pass = 0; pass < 2; ++pass)  // twice is enough
      for (Eigen::Index j = 0; j <= k; ++j) {
        const auto& b = space.basis[static_cast<std::size_t>(j)];
        const double part = capacity_product(rhs, b, w);
        space.projected(j, k) += part;
        for (std::size_t i = 0; i < w.size(); ++i) w[i] -= part * b[i];
      }
    space.next = std::sqrt(capacity_product(rhs, w, w));
    const bool exhausted = !(space.next > 1e-14 * std::abs(space.projected(k, k)));
    if (exhausted) space.next = 0;
    if (exhausted || space.basis.size() == size) {
      space.projected = Matrix(space.projected.topLeftCorner(k + 1, k + 1));
      return space;
    }
    space.projected(k + 1, k) = space.next;
    v = w;
    normalise(rhs, v);
  }
}

Spectrum by_arnoldi(FrozenRhs& rhs) {
  constexpr std::size_t basis_size = 60;
  constexpr int most_restarts = 40;
  constexpr double wanted = 1e-6, trusted = 1e-3;  // residuals, of the radius
  constexpr double sure_of_rising = 0.01;          // of the rate itself
  Spectrum out;
  out.found_by = "Arnoldi";
  out.shape = white_perturbation(rhs);
  for (int restart = 0; restart < most_restarts; ++restart) {
    const Arnoldi space = arnoldi_space(rhs, out.shape, basis_size);
    const auto m = space.projected.rows();
    const Eigen::EigenSolver<Matrix> solver(space.projected);
    const Eigen::MatrixXcd vectors = solver.eigenvectors();  // computed anew at every call
    std::vector<Complex> values(solver.eigenvalues().data(), solver.eigenvalues().data() + m);
    const auto residual = [&](std::size_t k) {
      return space.next * std::abs(vectors(m - 1, static_cast<Eigen::Index>(k)));
    };
    const Extremes found = extremes_of(values);
    const auto wanted_column = static_cast<Eigen::Index>(found.limiting);
    const double error = residual(found.limiting);
    std::vector<Complex> trustworthy = {values[found.limiting]};
    for (std::size_t k = 0; k < values.size(); ++k)
      if (k != found.limiting && residual(k) <= trusted * found.radius) trustworthy.push_back(values[k]);
    out.rising = 0;
    take_extremes(trustworthy, rhs.frozen(), out);
    const auto highest = static_cast<std::size_t>(
        std::max_element(values.begin(), values.end(),
                         [](const Complex& a, const Complex& b) { return a.real() < b.real(); }) -
        values.begin());
    out.rising_is_known = rhs.frozen().decays || (out.rising > 0 && out.rising == values[highest].real() &&
                                                  residual(highest) <= sure_of_rising * out.rising);
    out.residual = error;
    std::fill(out.shape.begin(), out.shape.end(), 0.0);
    for (Eigen::Index j = 0; j < m; ++j) {
      const double part = vectors(j, wanted_column).real();
      const auto& b = space.basis[static_cast<std::size_t>(j)];
      for (std::size_t i = 0; i < out.shape.size(); ++i) out.shape[i] += part * b[i];
    }
    normalise(rhs, out.shape);
    if (error <= wanted * found.radius) break;
  }
  return out;
}

Spectrum by_lanczos(FrozenRhs& rhs) {
  Spectrum out;
  out.found_by = "Lanczos";
  StiffestMode mode = stiffest_mode(rhs);
  out.limiting = -mode.rate;
  out.residual = mode.residual;
  out.shape = std::move(mode.shape);
  out.euler_limit = euler_limit(out.limiting);
  if (rhs.frozen().decays) return out;
  const auto apply = [&](std::span<const double> v, std::span<double> product) {
    rhs.linear_stage({.y1 = v.data(), .a = 0, .d = 1}, product);
  };
  const double highest = largest_eigenvalue(apply, rhs.capacities()).largest;
  if (highest > nothing * mode.rate) out.rising = highest;
  return out;
}

}  // namespace

double euler_limit(std::complex<double> eigenvalue) noexcept {
  const double decay = -eigenvalue.real();
  return decay > 0 ? 2 * decay / std::norm(eigenvalue) : std::numeric_limits<double>::infinity();
}

Spectrum spectrum_of(FrozenRhs& rhs) {
  if (rhs.traits().symmetric) return by_lanczos(rhs);
  return rhs.size() <= most_for_all_eigenvalues ? all_eigenvalues(rhs) : by_arnoldi(rhs);
}

}  // namespace superstep

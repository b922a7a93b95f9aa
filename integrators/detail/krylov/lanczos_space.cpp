#include "integrators/detail/krylov/lanczos_space.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/krylov/tridiagonal_response.hpp"

namespace superstep {
namespace {

constexpr std::size_t stretch_of_entries = 1024;  // stays in the first cache while vectors are added up
// Bound over estimate at most: in uneven networks the recurrence looks regular long before it is, and
// estimates were seen that were ten times too small where the bound was two hundred times too large.
constexpr double most_trusted = 20;

}  // namespace

void LanczosSpace::clear(double longest, bool inflow) {
  norm_.clear();
  alpha_.clear();
  inflow_.clear();
  bound_ = ResidualBound(longest);
  tracks_inflow_ = inflow;
}

double LanczosSpace::norm_of(std::span<const double> v) const {
  return std::sqrt(rhs_->reduction().sum(
      [c = rhs_->capacities().data(), x = v.data()](std::size_t i) { return c[i] * x[i] * x[i]; }));
}

/// v_{j+1} from v_j and v_{j-1}, each times its norm, so that scaling them costs no pass.
void LanczosSpace::add_vector() {
  const std::size_t j = alpha_.size();
  const std::span<double> next = basis_.at(j + 1);
  const double* now = basis_[j];
  const double* capacity = rhs_->capacities().data();
  Stage stage{.y1 = now, .a = 0, .d = -1 / norm_[j]};
  if (j > 0) stage.y2 = basis_[j - 1], stage.b = -norm_[j] / norm_[j - 1];
  rhs_->linear_stage(stage, next);
  const double product = rhs_->reduction().sum(
      [w = next.data(), v = now, capacity](std::size_t i) { return capacity[i] * w[i] * v[i]; });
  alpha_.push_back(product / norm_[j]);
  const double square =
      rhs_->reduction().sum([w = next.data(), v = now, capacity, part = alpha_[j] / norm_[j]](std::size_t i) {
        w[i] -= part * v[i];
        return capacity[i] * w[i] * w[i];
      });
  bound_.add_row(alpha_[j], norm_[j]);
  norm_.push_back(std::sqrt(square));
  if (tracks_inflow_) inflow_.push_back(rhs_->linear_inflow({now, next.size()}) / norm_[j]);
}

double LanczosSpace::bound_at(double elapsed, double largest) const {
  if (dimension() == 0) return length() * elapsed * largest;  // nothing is done yet
  const double residual = norm_.front() * norm_.back();
  return residual > 0 ? largest * std::exp(std::log(residual) + bound_.log_integral(elapsed)) : 0;
}

double LanczosSpace::estimate_at(double elapsed, const Input& input) const {
  constexpr double safety = 3;
  const double bound = bound_at(elapsed, input.largest);
  const auto more = continued();
  if (!more) return bound;
  const std::size_t m = dimension();
  const double time[] = {elapsed};
  const auto now = tridiagonal_responses(alpha(), beta().first(m - 1), time).front().value;
  const auto later = tridiagonal_responses(more->alpha, more->beta, time).front().value;
  double square = 0;
  for (std::size_t j = 0; j < later.size(); ++j) {
    const double change = later[j] - (j < m ? now[j] : 0.0);
    square += change * change;
  }
  return std::clamp(safety * length() * std::sqrt(square) * input.variation, bound / most_trusted, bound);
}

LanczosSpace::Growth LanczosSpace::grow(double elapsed, double allowed, const Input& input, std::size_t most,
                                        const std::atomic<bool>* stop) {
  double looseness = most_trusted;  // bound over estimate, as last seen
  while (!is_whole()) {
    const double bound = bound_at(elapsed, input.largest);
    if (bound <= allowed) break;
    if (bound <= looseness * allowed) {
      const double estimate = estimate_at(elapsed, input);
      if (estimate <= allowed) break;
      // The next look is where both will have fallen enough; soon, where the bound stood for the estimate.
      const double soon = 0.5 * bound / allowed;
      looseness = estimate < bound ? std::min(bound / estimate, soon) : soon;
    }
    if (dimension() == most) return Growth::full;
    if (stop && stop->load()) return Growth::stopped;
    add_vector();
  }
  return Growth::covers;
}

std::optional<LanczosSpace::Continued> LanczosSpace::continued() const {
  constexpr double regular = 4;
  const std::size_t m = dimension(), half = m / 2;
  const std::span<const double> diagonal = alpha(), off = beta();
  const auto within = [&](std::span<const double> part) {
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    return *high <= regular * *low;
  };
  if (half == 0 || !within(diagonal.subspan(half)) || !within(off.subspan(half))) return std::nullopt;
  Continued more{{diagonal.begin(), diagonal.end()}, {off.begin(), off.end()}};
  for (std::size_t j = m; j-- > half;) {
    more.alpha.push_back(diagonal[j]);
    if (j > half) more.beta.push_back(off[j - 1]);
  }
  return more;
}

void LanczosSpace::add_to(std::span<const std::span<double>> states,
                          std::vector<std::vector<double>> factors) const {
  const std::size_t n = rhs_->size(), m = dimension();
  if (m == 0) return;
  for (auto& of_state : factors) {
    for (std::size_t j = 0; j < of_state.size(); ++j) of_state[j] /= norm_[j];
    of_state.resize((of_state.size() + 3) / 4 * 4, 0.0);  // vectors are added four at a time
  }
  for_ranges((n + stretch_of_entries - 1) / stretch_of_entries, n, [&](std::size_t from, std::size_t to) {
    for (std::size_t part = from; part < to; ++part) {
      const std::size_t first = part * stretch_of_entries, last = std::min(first + stretch_of_entries, n);
      for (std::size_t j = 0; j < m; j += 4) {
        const auto vector = [&](std::size_t k) { return basis_[std::min(j + k, m - 1)]; };
        const double *v0 = vector(0), *v1 = vector(1), *v2 = vector(2), *v3 = vector(3);
        for (std::size_t k = 0; k < states.size(); ++k) {
          if (states[k].empty() || j >= factors[k].size()) continue;
          const double c0 = factors[k][j], c1 = factors[k][j + 1];
          const double c2 = factors[k][j + 2], c3 = factors[k][j + 3];
          double* state = states[k].data();
          for (std::size_t i = first; i < last; ++i)
            state[i] += (c0 * v0[i] + c1 * v1[i]) + (c2 * v2[i] + c3 * v3[i]);
        }
      }
    }
  });
}

double LanczosSpace::entry(std::size_t i, std::span<const double> factors) const {
  double sum = 0;
  for (std::size_t j = 0; j < factors.size(); ++j) sum += factors[j] / norm_[j] * basis_[j][i];
  return sum;
}

}  // namespace superstep

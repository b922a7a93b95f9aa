#include "integrators/detail/krylov/lanczos_space.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "integrators/detail/krylov/lanczos_kernels.hpp"
#include "integrators/detail/krylov/tridiagonal_response.hpp"

namespace superstep {
namespace {

constexpr std::size_t stretch_of_entries = 1024;  // stays in the first cache while vectors are added up
// Bound over estimate at most: in uneven networks the recurrence looks regular long before it is, and
// estimates were seen that were ten times too small where the bound was two hundred times too large.
constexpr double most_trusted = 15;

}  // namespace

LanczosSpace::LanczosSpace(Rhs& rhs, Storage storage, Recent& recent) : rhs_(&rhs), recent_(&recent) {
  if (storage == Storage::single)
    basis_.emplace<VectorStore<float>>(rhs.size());
  else
    basis_.emplace<VectorStore<double>>(rhs.size());
  for (auto& vector : recent) vector.resize(rhs.size());
  const auto& reduction = rhs.reduction();
  const double total = reduction.sum([c = rhs.capacities().data()](std::size_t i) { return c[i]; });
  scale_ = total > 0 ? std::sqrt(total / static_cast<double>(reduction.total())) : 1;
}

double LanczosSpace::rounding() const noexcept {
  return std::holds_alternative<VectorStore<float>>(basis_) ? std::numeric_limits<float>::epsilon() / 2
                                                            : std::numeric_limits<double>::epsilon() / 2;
}

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

/// v_{j+1} from v_j and v_{j-1}, each times its norm, so that scaling them costs no pass; v_j is kept on the
/// way.
void LanczosSpace::add_vector() {
  const std::size_t j = alpha_.size();
  const std::span<double> next = recent(j + 1);
  const double* now = recent(j).data();
  Stage stage{.y1 = now, .a = 0, .d = -1 / norm_[j]};
  if (j > 0) stage.y2 = recent(j - 1).data(), stage.b = -norm_[j] / norm_[j - 1];
  rhs_->linear_stage(stage, next);
  const LanczosPass pass{.next = next.data(), .now = now, .capacity = rhs_->capacities().data()};
  std::visit(
      [&]<class T>(VectorStore<T>& basis) {
        const auto& kernel = lanczos_kernels<T>().front();
        const auto& reduction = rhs_->reduction();
        T* const kept = basis.at(j).data();
        const double unit = scale_ / norm_[j];
        alpha_.push_back(reduction.sum_of_ranges([&](std::size_t first, std::size_t last) {
          return kernel.keep_and_project(pass, unit, kept, first, last);
        }) / norm_[j]);
        const double part = alpha_[j] / norm_[j];
        norm_.push_back(std::sqrt(reduction.sum_of_ranges(
            [&](std::size_t first, std::size_t last) { return kernel.subtract(pass, part, first, last); })));
      },
      basis_);
  bound_.add_row(alpha_[j], norm_[j]);
  if (tracks_inflow_) inflow_.push_back(rhs_->linear_inflow({now, next.size()}) / norm_[j]);
}

double LanczosSpace::rms_over_norm(double largest) const {
  double most = 0;
  for (std::size_t j = dimension(), k = 0; k < 2 && k <= j; ++k) {
    if (norm_[j - k] == 0) continue;
    const double square =
        rhs_->reduction().sum([v = recent(j - k).data()](std::size_t i) { return v[i] * v[i]; });
    most = std::max(most, std::sqrt(square / static_cast<double>(rhs_->reduction().total())) / norm_[j - k]);
  }
  return std::min(most, largest);
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

LanczosSpace::Growth LanczosSpace::grow(double elapsed, double allowed, double largest_rms,
                                        const Input& input, std::size_t most, const std::atomic<bool>* stop) {
  constexpr std::size_t now_and_then = 8;  // vectors
  double looseness = most_trusted;         // bound over estimate, as last seen, both as norms
  double typical = largest_rms;
  while (!is_whole()) {
    const double bound = bound_at(elapsed, input.largest);
    if (bound * largest_rms <= allowed) break;
    if (dimension() % now_and_then == 0) typical = rms_over_norm(largest_rms);
    if (bound * typical <= looseness * allowed) {
      typical = rms_over_norm(largest_rms);
      const double estimate = estimate_at(elapsed, input);
      if (estimate * typical <= allowed) break;
      // The next look is where both will have fallen enough; soon, where the bound stood for the estimate.
      const double soon = 0.5 * bound * typical / allowed;
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
  constexpr std::size_t fewest = 16;  // from which anything can be told
  const std::size_t m = dimension(), half = m / 2;
  const std::span<const double> diagonal = alpha(), off = beta();
  const auto within = [&](std::span<const double> part) {
    const auto [low, high] = std::minmax_element(part.begin(), part.end());
    return *high <= regular * *low;
  };
  if (half < fewest || !within(diagonal.subspan(half)) || !within(off.subspan(half))) return std::nullopt;
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
    for (double& factor : of_state) factor /= scale_;
    of_state.resize((of_state.size() + 3) / 4 * 4, 0.0);  // vectors are added four at a time
  }
  const auto add = [&]<class T>(const VectorStore<T>& basis) {
    const auto& kernel = lanczos_kernels<T>().front();
    for_ranges((n + stretch_of_entries - 1) / stretch_of_entries, n, [&](std::size_t from, std::size_t to) {
      for (std::size_t part = from; part < to; ++part) {
        const std::size_t first = part * stretch_of_entries, last = std::min(first + stretch_of_entries, n);
        for (std::size_t j = 0; j < m; j += 4) {
          const T* vectors[4];
          for (std::size_t k = 0; k < 4; ++k) vectors[k] = basis[std::min(j + k, m - 1)];
          for (std::size_t k = 0; k < states.size(); ++k)
            if (!states[k].empty() && j < factors[k].size())
              kernel.add_four(vectors, &factors[k][j], states[k].data(), first, last);
        }
      }
    });
  };
  std::visit(add, basis_);
}

double LanczosSpace::entry(std::size_t i, std::span<const double> factors) const {
  const auto add = [&](const auto& basis) {
    double sum = 0;
    for (std::size_t j = 0; j < factors.size(); ++j) sum += factors[j] * basis[j][i];
    return sum / scale_;
  };
  return std::visit(add, basis_);
}

}  // namespace superstep

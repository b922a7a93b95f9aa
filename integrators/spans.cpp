#include "integrators/spans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

constexpr double enough = 0.05;  // relative change of a span that ends the pilot runs
// Span that a pilot run refers to over the one that it finds, at most, where it need not be repeated: its
// error is then some two per cent of what it finds.
constexpr double fine = 2;
constexpr int most_runs = 8;

/// Of all processes that share the state.
void share(const Rhs& rhs, std::vector<FieldRange>& ranges) {
  for (auto& range : ranges)
    range = {rhs.reduction().smallest(range.low), rhs.reduction().largest(range.high)};
}

std::vector<FieldRange> starting_ranges(const Rhs& rhs, const Plan& plan, std::span<const double> y) {
  std::vector<FieldRange> ranges = plan.ranges;
  const auto fields = rhs.fields();
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
      ranges[f].take(y[i]);
  share(rhs, ranges);
  return ranges;
}

/// Nothing can leave the range, and its ends are there: they are initial and fixed values.
bool range_is_attained(const FieldFacts& facts, const FieldRange& range) {
  if (facts.has_sources) return false;
  return facts.ambient.empty() || (facts.ambient.low >= range.low && facts.ambient.high <= range.high);
}

/// Some pieces of the inputs: all where they are few, else the first and those with the strongest beginnings.
std::vector<std::pair<double, double>> some_pieces(const Rhs& rhs, double begin, double end) {
  constexpr std::size_t most = 64;
  struct Piece {
    double begin = 0, end = 0, jump = 0, kink = 0;  ///< s; what its beginning changes, see Breakpoint
    [[nodiscard]] double strength() const { return jump + kink * (end - begin); }
  };
  std::vector<Piece> pieces{{.begin = begin}};
  for (const auto& point : rhs.facts().breakpoints) {
    if (!(point.t > begin && point.t < end)) continue;
    pieces.back().end = point.t;
    pieces.push_back({.begin = point.t,
                      .jump = *std::max_element(point.jump.begin(), point.jump.end()),
                      .kink = *std::max_element(point.kink.begin(), point.kink.end())});
  }
  pieces.back().end = end;
  if (pieces.size() > most) {
    std::stable_sort(pieces.begin() + 1, pieces.end(),
                     [](const Piece& a, const Piece& b) { return a.strength() > b.strength(); });
    pieces.resize(most);
  }
  std::vector<std::pair<double, double>> bounds;
  for (const auto& piece : pieces) bounds.emplace_back(piece.begin, piece.end);
  return bounds;
}

/// What the rates of the initial state would do if they went on: a first guess, if a rough one.
std::vector<double> guess(Rhs& rhs, const Plan& plan, double t, std::span<const double> y) {
  const auto fields = rhs.fields();
  std::vector<double> rate(rhs.size()), rise(fields.size(), 0.0);
  for (const auto& [begin, end] : some_pieces(rhs, t, plan.output_times.back())) {
    if (!rhs.facts().breakpoints.empty()) rhs.enter(begin, end);
    for (const double at : {begin, end}) {
      rhs(at, y, rate);
      for (std::size_t f = 0; f < fields.size(); ++f) {
        const auto& field = fields[f];
        const Reduction of_field(std::array{field.count}, field.total(), rhs.reduction().among());
        const double sum = of_field.sum([&](std::size_t k) {
          const double r = rate[field.offset + k * field.stride];
          return r * r;
        });
        const double rms = std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, field.total())));
        if (std::isfinite(rms)) rise[f] += 0.5 * (end - begin) * rms;
      }
    }
  }
  rhs.leave();
  return rise;
}

/// Explicit where that is little work, else implicit; where laws or two fields make a direct solver slow, by
/// Krylov spaces. Fixed by the scene alone.
std::string pilot_method(Rhs& rhs, const Plan& plan, double t, std::span<const double> y) {
  constexpr double little = 1e6, much = 1e8;  // t rho: some thousand sweeps, some ten thousand
  constexpr std::size_t few = 2000;           // unknowns that a direct solver takes in its stride
  const double t_rho = (plan.output_times.back() - t) * rhs.spectral_bound(t, y);
  if (t_rho < little) return "rkc:rtol=1e-2";
  if (rhs.traits().linear || rhs.reduction().total() < few) return "cvode:rtol=1e-2";
  return t_rho < much ? "exprb:rtol=1e-2" : "cvode:linsol=gmres,rtol=1e-2";
}

/// For another try after a run that failed since a field went far beyond what was guessed of it, as a
/// temperature does that is heated by a potential still to come: a thousand times what was seen. False where
/// none did.
bool make_coarser(std::vector<double>& spans, const std::vector<bool>& known,
                  const std::vector<FieldRange>& seen) {
  constexpr double beyond = 10, more = 1e3;
  bool changed = false;
  for (std::size_t f = 0; f < spans.size(); ++f) {
    if (known[f] || !std::isfinite(seen[f].span()) || !(seen[f].span() > beyond * spans[f])) continue;
    spans[f] = more * seen[f].span();
    changed = true;
  }
  return changed;
}

/// For another try after a run that failed: a hundredth of each span, though not less than what was seen on
/// the way. False when that changes nothing.
bool make_finer(std::vector<double>& spans, const std::vector<FieldRange>& seen) {
  constexpr double part = 0.01;
  bool changed = false;
  for (std::size_t f = 0; f < spans.size(); ++f) {
    const double on_the_way = std::isfinite(seen[f].span()) ? std::min(seen[f].span(), spans[f]) : 0;
    const double next = std::max(part * spans[f], on_the_way);
    changed = changed || next < (1 - enough) * spans[f];
    spans[f] = next;
  }
  return changed;
}

}  // namespace

Spans find_spans(Rhs& rhs, const Plan& plan, double t, std::span<const double> y) {
  const auto declared = starting_ranges(rhs, plan, y);
  const auto& facts = rhs.facts().fields;
  Spans out;
  std::vector<bool> known;
  for (std::size_t f = 0; f < declared.size(); ++f) {
    out.spans.push_back(declared[f].span());
    known.push_back(range_is_attained(facts[f], declared[f]));
    out.pilot = out.pilot || !known[f];
  }
  out.how = "initial and fixed values span it";
  if (!out.pilot || rhs.reduction().total() == 0) return out;

  const auto rise = guess(rhs, plan, t, y);
  std::vector<double> spans = out.spans;
  for (std::size_t f = 0; f < spans.size(); ++f)
    if (!known[f]) spans[f] = std::max(spans[f], rise[f]);
  const std::string method = pilot_method(rhs, plan, t, y);
  out.how = fmt::format("a pilot run by {} found it", method);
  for (int run = 1; run <= most_runs; ++run) {
    if (std::all_of(spans.begin(), spans.end(), [](double s) { return s == 0; })) break;  // nothing moves
    std::vector<FieldRange> found = declared;
    Plan pilot{.t_begin = t,
               .output_times = {plan.output_times.back()},
               .ranges = plan.ranges,
               .spans = spans,
               .probes = {},
               .settle_tolerance = plan.settle_tolerance,
               .extremes = &found,
               .stop = plan.stop};
    Integrator integrator(make_method(method));
    Outcome outcome;
    try {
      integrator.prepare(rhs, pilot);
      integrator.start(t, y);
      outcome = integrator.advance(plan.output_times.back());
    } catch (const NeedsWhole&) {
      throw;
    } catch (const Error& error) {
      if (error.code() != ExitCode::numerical) throw;  // no fault of the method
      outcome = {Status::failed, error.what()};
    } catch (const std::exception& error) {
      outcome = {Status::failed, error.what()};
    }
    share(rhs, found);
    double change = 0, coarse = 0;
    for (std::size_t f = 0; f < spans.size(); ++f) {
      const double seen = found[f].span();
      if (!std::isfinite(seen)) {
        outcome = {Status::failed, "values grew beyond all bounds"};
        continue;
      }
      // A run that was too coarse to see anything move says how fine the next one has to be.
      const double next = seen > 1e-2 * spans[f] ? seen : std::max(seen, 1e-3 * spans[f]);
      change = std::max(change, spans[f] > 0 ? std::abs(next / spans[f] - 1) : 0.0);
      coarse = std::max(coarse, next > 0 ? spans[f] / next : 0.0);
      if (outcome.ok()) spans[f] = next;
    }
    if (outcome.status == Status::interrupted) break;
    if (!outcome.ok()) {  // too coarse, perhaps: errors beyond a law, growth that is none
      const bool outgrown = outcome.status == Status::failed && make_coarser(spans, known, found);
      const bool last = run == most_runs || !(outgrown || make_finer(spans, found));
      if (!last) continue;
      out.how += fmt::format("; it ended early: {}", outcome.reason);
      break;
    }
    if (change <= enough || coarse <= fine) break;
  }
  out.spans = spans;
  return out;
}

}  // namespace superstep

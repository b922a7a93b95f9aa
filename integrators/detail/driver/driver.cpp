#include "integrators/detail/driver/driver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "integrators/spans.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

/// Restores the whole function of time when the driver hands control back.
class OnPieces {
 public:
  explicit OnPieces(Rhs& rhs) : rhs_(rhs) {}
  ~OnPieces() { rhs_.leave(); }
  OnPieces(const OnPieces&) = delete;
  OnPieces& operator=(const OnPieces&) = delete;

 private:
  Rhs& rhs_;
};

/// What a settled potential leaves behind stays well below the tolerance of the method.
constexpr double settling_part_of_tolerance = 0.1;
/// So does what f is wrong by where a part of it is found approximately.
constexpr double rhs_part_of_tolerance = 0.01;

}  // namespace

void Driver::prepare(Rhs& rhs, const Plan& plan) {
  whole_ = &rhs;
  plan_ = plan;
  guard_.prepare(rhs, plan);
  recorder_.prepare(plan);
  ends_.reserve(longest_chain);
  spans_are_known_ = !plan_.spans.empty();
  if (plan_.spans.empty())  // until `start` finds them: those of the declared ranges
    for (const auto& range : plan.ranges) plan_.spans.push_back(range.span() > 0 ? range.span() : 1);
  prepare_settling();
  rhs.ask_accuracy(rhs_part_of_tolerance * method_->rtol());
  prepare_method(rhs);
}

void Driver::prepare_settling() {
  const double tolerance = plan_.settle_tolerance > 0 ? std::max(plan_.settle_tolerance,
                                                                 settling_part_of_tolerance * method_->rtol())
                                                      : 0;
  settling_.prepare(*whole_, tolerance, plan_.spans.front(), plan_.spans.back(), plan_.output_times.back());
}

void Driver::prepare_method(Rhs& rhs) {
  rhs_ = &rhs;
  plan_.probes.clear();  // entries of the whole state: those of the rest are recorded here
  if (rhs_ == whole_) plan_.probes = recorder_.entries();
  task_ = {.t_begin = plan_.t_begin,
           .t_end = plan_.output_times.back(),
           .allowed = allowed_errors(rhs),
           .spans = {plan_.spans.end() - static_cast<std::ptrdiff_t>(rhs.fields().size()), plan_.spans.end()},
           .plan = &plan_};
  for (std::size_t f = 0, all = plan_.spans.size(), own = rhs.fields().size(); f < own; ++f) {
    const double largest = plan_.ranges[all - own + f].magnitude() + task_.spans[f];
    if (task_.allowed[f] > 0)
      task_.rounding =
          std::max(task_.rounding, std::numeric_limits<double>::epsilon() * largest / task_.allowed[f]);
  }
  const auto& points = rhs.facts().breakpoints;
  task_.propagations = 1 + static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](auto& p) {
                         return p.t > task_.t_begin && p.t < task_.t_end;
                       }));
  method_->prepare(rhs, task_);
  stepper_ = method_->one_step();
  propagator_ = method_->propagator();
  for (auto* v : {&state_, &next_}) v->resize(rhs.size());
  if (!stepper_) return;
  controller_ = StepController(stepper_->order());
  const bool controlled = stepper_->pace() == OneStepMethod::Pace::error;
  for (auto* v : {&slope_, &turned_}) v->resize(controlled ? rhs.size() : 0);
}

std::vector<double> Driver::allowed_errors(const Rhs& rhs) const {
  constexpr double roundings = 100;
  std::vector<double> allowed;
  const std::size_t first = plan_.spans.size() - rhs.fields().size();
  for (std::size_t f = first; f < plan_.spans.size(); ++f) {
    const double largest = plan_.ranges[f].magnitude() + plan_.spans[f];
    const double floor = roundings * std::numeric_limits<double>::epsilon() * largest;
    allowed.push_back(plan_.spans[f] > 0 ? std::max(method_->rtol() * plan_.spans[f], floor) : 0);
  }
  return allowed;
}

Driver::~Driver() {
  unsettle();
}

/// The driving field is stepped again.
void Driver::unsettle() {
  if (!settled_at_) return;
  settling_.coupling()->drive({});
  settled_at_.reset();
}

void Driver::start(double t, std::span<const double> y) {
  if (settled_at_) {
    unsettle();
    prepare_method(*whole_);
  }
  t_ = t;
  find_spans_once(t, y);
  state_.assign(y.begin(), y.end());
  counted_ = statistics_ = {};
  sweeps_before_ = whole_->counters().sweeps;
  lawless_ = 0;
  method_->reset_counts();
  settling_.restart();
  budget_.restart(task_.propagations);
  const OnPieces pieces(*whole_);
  begin_run_of(*whole_);
  update_statistics();
}

/// Where nobody said beforehand what tolerances refer to.
void Driver::find_spans_once(double t, std::span<const double> y) {
  if (spans_are_known_ || !(method_->rtol() > 0)) return;
  plan_.spans = find_spans(*whole_, plan_, t, y).spans;
  spans_are_known_ = true;
  prepare_settling();
  prepare_method(*whole_);
}

void Driver::update_statistics() {
  statistics_ = counted_;
  method_->add_counts(statistics_);
  if (settled_at_) statistics_.error_bound = statistics_.rounding_bound = 0;  // of the rest alone
}

void Driver::begin_run_of(Rhs& rhs) {
  const auto& points = rhs.facts().breakpoints;
  next_breakpoint_ = static_cast<std::size_t>(
      std::upper_bound(points.begin(), points.end(), t_, [](double t, const auto& p) { return t < p.t; }) -
      points.begin());
  if (propagator_ && propagator_->takes_breakpoints()) next_breakpoint_ = points.size();
  enter_piece(false);
}

double Driver::piece_end() const noexcept {
  const auto& points = rhs_->facts().breakpoints;
  const double end = std::max(task_.t_end, t_);
  return next_breakpoint_ < points.size() ? std::min(points[next_breakpoint_].t, end) : end;
}

/// Makes f what it is on the present piece.
void Driver::take_piece_of_inputs() {
  const auto& points = rhs_->facts().breakpoints;
  if (points.empty() || (propagator_ && propagator_->takes_breakpoints())) return;
  const double beyond_all = piece_begin_ + std::max(1.0, std::abs(piece_begin_));
  rhs_->enter(piece_begin_, next_breakpoint_ < points.size() ? points[next_breakpoint_].t : beyond_all);
}

/// The piece that begins at `t_`.
void Driver::enter_piece(bool smooth) {
  piece_begin_ = t_;
  take_piece_of_inputs();
  lattice_ = {};
  cap_ = std::numeric_limits<double>::infinity();
  if (!smooth) {
    step_ = 0;
    controller_.restart();
  }
  if (stepper_) return stepper_->restart(t_, state_, smooth);
  list_instants();
  const auto& points = rhs_->facts().breakpoints;
  const double smooth_until =
      next_breakpoint_ < points.size() ? points[next_breakpoint_].t : std::numeric_limits<double>::infinity();
  propagator_->begin(t_, smooth_until, state_, instants_, smooth);
}

/// Whether what changes at a breakpoint is lost within what a step may err by.
bool Driver::goes_on_smoothly(const Breakpoint& point) const {
  constexpr double insignificant = 0.1;
  const double share = stepper_ ? stepper_->share() : 1e-3;
  const double h = stepper_ ? step_ : point.t - piece_begin_;
  for (std::size_t f = 0; f < task_.allowed.size(); ++f) {
    const double change = point.jump[f] * h + point.kink[f] * h * h / 2;
    if (!(change <= insignificant * share * task_.allowed[f])) return false;
  }
  return true;
}

Outcome Driver::advance(double t_out) {
  const OnPieces pieces(*whole_);
  take_piece_of_inputs();
  while (t_ < t_out) {
    if (next_breakpoint_ < rhs_->facts().breakpoints.size() &&
        t_ == rhs_->facts().breakpoints[next_breakpoint_].t) {
      const bool smooth = goes_on_smoothly(rhs_->facts().breakpoints[next_breakpoint_]);
      if (!smooth) ++counted_.landings;
      ++next_breakpoint_;
      enter_piece(smooth);
    }
    const double target = std::min(t_out, piece_end());
    Outcome outcome = stepper_ ? step_to(target) : propagate_to(target);
    update_statistics();
    if (!outcome.ok()) return outcome;
  }
  if (!plan_.full_states && propagator_) return {};
  complete_state();
  return look_at(state_);
}

/// Behind the settled field stands what is still stepped.
void Driver::complete_state() {
  if (settled_at_)
    std::copy(state_.begin(), state_.end(), full_.end() - static_cast<std::ptrdiff_t>(state_.size()));
}

std::span<const double> Driver::state() const noexcept {
  return settled_at_ ? full_ : state_;
}

/// A temperature may lie beyond the range of a law by as much as it may be wrong [K].
double Driver::law_slack() const noexcept {
  return task_.allowed.empty() ? 0 : task_.allowed.back();  // the temperature is the last field
}

Outcome Driver::look_at(std::span<const double> y) {
  since_look_ = 0;
  if (auto violation = rhs_->law_violation(y, law_slack()))
    return {Status::failed, fmt::format("at t = {:.6g} s: {}", t_, *violation)};
  return guard_.check(t_, y, *rhs_);
}

Outcome Driver::may_go_on() {
  constexpr std::uint64_t most_steps = 1'000'000'000'000;
  guard_.agree(*rhs_);
  if (t_ < task_.t_end && guard_.stop_requested()) return interrupted_at(t_);  // at its end it is done
  if (counted_.steps > most_steps)
    return {
        Status::failed,
        fmt::format("more than {:.0g} steps by t = {:.6g} s; loosen the tolerance, or take another method",
                    static_cast<double>(most_steps), t_)};
  const std::uint64_t sweeps = whole_->counters().sweeps - sweeps_before_;
  if (plan_.most_sweeps > 0 && sweeps > plan_.most_sweeps)
    return {Status::timeout, fmt::format("at t = {:.6g} s it has swept {} times over the network, and {} are "
                                         "allowed; allow more work, or take another method",
                                         t_, sweeps, plan_.most_sweeps)};
  return {};
}

/// Takes the present state into the extremes that somebody asked for.
void Driver::note_extremes() {
  if (!plan_.extremes) return;
  const auto fields = rhs_->fields();
  const std::size_t settled = plan_.extremes->size() - fields.size();
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
      (*plan_.extremes)[settled + f].take(state_[i]);
}

void Driver::publish() {
  if (plan_.reached) plan_.reached->store(t_, std::memory_order_relaxed);
}

/// Goes on with the driven half alone where the driving one is steady.
void Driver::settle_if_steady() {
  if (settled_at_ || !settling_.is_steady(t_, state_)) return;
  OneWayCoupling& coupling = *settling_.coupling();
  const std::size_t driver = coupling.driver().size();
  full_ = state_;
  driven_rate_.resize(coupling.driven().size());
  coupling.rate(t_, settling_.final_state(), driven_rate_);
  coupling.drive(driven_rate_);
  settled_at_ = t_;
  whole_->leave();
  method_->add_counts(counted_);
  method_->reset_counts();
  const StateVector rest(state_.begin() + static_cast<std::ptrdiff_t>(driver), state_.end());
  prepare_method(coupling.driven());
  std::copy(rest.begin(), rest.end(), state_.begin());
  begin_run_of(coupling.driven());
}

}  // namespace superstep

#include "reports/gate/gate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/text/quantity.hpp"

namespace superstep {
namespace {

std::string text_of(const RatioInterval& ratio) {
  return fmt::format("x {:.3f} ({:.3f} to {:.3f})", ratio.estimate, ratio.low, ratio.high);
}

class Judge {
 public:
  Judge(const ResultsFile& now, const ResultsFile& baseline,
        const std::function<bool(const std::string&)>& is_adaptive, const GateLimits& limits)
      : now_(now), baseline_(baseline), is_adaptive_(is_adaptive), limits_(limits) {}

  GateReport run() {
    report_.results = now_.path;
    report_.baseline = baseline_.path;
    same_build_ = now_.flags == baseline_.flags && now_.threads == baseline_.threads;
    same_machine_ = same_build_ && now_.processor == baseline_.processor;
    if (!same_machine_)
      report_.notes.push_back(fmt::format(
          "CPU times{} are not judged: processor, flags or threads differ ('{}', '{}', {} against "
          "'{}', '{}', {}).",
          same_build_ ? "" : " and memory", now_.processor, now_.flags, now_.threads, baseline_.processor,
          baseline_.flags, baseline_.threads));
    for (const auto* file : {&now_, &baseline_}) {
      if (file->interrupted)
        report_.notes.push_back(
            fmt::format("'{}' was interrupted: what had been measured by then is judged.", file->path));
      if (!file->has_samples()) {
        measured_ = false;
        report_.notes.push_back(
            fmt::format("Nothing was measured: no method in '{}' was timed.", file->path));
      }
    }
    for (const auto& before : baseline_.cases) judge_case(before);
    for (const auto& one : now_.cases)
      if (!baseline_.find(one.name))
        report_.notes.push_back(fmt::format("Case {} is not in the baseline.", one.name));
    conclude();
    return std::move(report_);
  }

 private:
  void judge_case(const MeasuredCase& before) {
    case_ = before.name;
    const MeasuredCase* now = now_.find_same(before, baseline_.path);
    if (!now) {
      spec_ = "";
      return add("case", "measured", "not measured", GateVerdict::inconclusive);
    }
    for (const auto& row : before.rows) judge_row(before, row, *now);
    for (const auto& row : now->rows)
      if (!before.find(row.spec))
        report_.notes.push_back(fmt::format("{} on {} is not in the baseline.", row.spec, case_));
  }

  void judge_row(const MeasuredCase& case_before, const MeasuredRow& before, const MeasuredCase& case_now) {
    spec_ = before.spec;
    const MeasuredRow* now = case_now.find(before.spec);
    if (!now) return not_measured_.push_back(fmt::format("{} on {}", spec_, case_));
    if (before.status != now->status)
      return add("status", before.status, now->status,
                 now->status == "ok" ? GateVerdict::better : GateVerdict::regressed);
    ++report_.passed;
    if (before.status != "ok" && before.status != "inaccurate") return;  // it did not come to its end
    for (const char* counter : counter_columns) judge_counter(counter, before, *now);
    for (const std::string field : {"", "_potential"}) {
      for (const char* error : error_columns)
        judge_error(error + field, "reference_error" + field, before, *now);
      judge_balance("balance" + field, before, *now);
      judge_overshoot("overshoot" + field, "span" + field, before, *now);
    }
    const bool counted = judge_instructions(before, *now);
    const auto of = [](const MeasuredRow& row) { return row.number("processes").value_or(1); };
    if (of(before) != of(*now))
      return add("CPU and memory", quantity(static_cast<std::size_t>(of(before)), "process"),
                 quantity(static_cast<std::size_t>(of(*now)), "process"), GateVerdict::not_judged);
    if (same_build_) judge_memory(before, *now);
    if (same_machine_) judge_time(case_before, before, case_now, *now, counted);
  }

  void judge_counter(const std::string& what, const MeasuredRow& before, const MeasuredRow& now) {
    const auto a = before.number(what), b = now.number(what);
    if (!a) return;
    const double tolerance = is_adaptive_(before.integrator)
                                 ? std::max(limits_.adaptive_counters * *a, limits_.adaptive_counts)
                                 : 0;
    const GateVerdict verdict = !b || *b > *a + tolerance ? GateVerdict::regressed
                                : *b < *a - tolerance     ? GateVerdict::better
                                                          : GateVerdict::passed;
    add(what, shown(a), shown(b), verdict);
  }

  void judge_error(const std::string& what, const std::string& bar, const MeasuredRow& before,
                   const MeasuredRow& now) {
    const auto a = before.number(what), b = now.number(what);
    if (!a) return;
    // What the reference itself may be wrong by says nothing about the method. Where the new reference is
    // known less well than the recorded one was, an error that only its own bar excuses cannot be told.
    const double bar_before = before.number(bar).value_or(0), bar_now = now.number(bar).value_or(0);
    const double slack = std::max(bar_before, bar_now);
    const auto exceeds = [&](double allowed) { return !b || !(*b <= *a * (1 + limits_.errors) + allowed); };
    const bool better = b && *a > *b * (1 + limits_.errors) + slack;
    add(what, shown(a), shown(b),
        exceeds(slack)        ? GateVerdict::regressed
        : exceeds(bar_before) ? GateVerdict::inconclusive
        : better              ? GateVerdict::better
                              : GateVerdict::passed);
  }

  void judge_balance(const std::string& what, const MeasuredRow& before, const MeasuredRow& now) {
    const auto a = before.number(what), b = now.number(what);
    if (!a) return;
    const bool worse = !b || !(std::abs(*b) <= std::abs(*a) * (1 + limits_.errors) + limits_.balance);
    add(what, shown(a), shown(b), worse ? GateVerdict::regressed : GateVerdict::passed);
  }

  void judge_overshoot(const std::string& what, const std::string& span, const MeasuredRow& before,
                       const MeasuredRow& now) {
    const auto scale = before.number(span);
    if (!scale) return;
    const double slack = limits_.overshoot * *scale;
    judge_larger(what, before, now,
                 [&](double one, double other) { return one > other * (1 + limits_.errors) + slack; });
  }

  void judge_memory(const MeasuredRow& before, const MeasuredRow& now) {
    judge_larger("peak_memory_mb", before, now, [&](double one, double other) {
      return one > other * (1 + limits_.memory) && one > other + limits_.memory_mb;
    });
  }

  /// Larger is worse; where one of the files has no value nothing is said.
  ///   exceeds  of two values: the first one is larger by more than is tolerated
  template <class Exceeds>
  void judge_larger(const std::string& what, const MeasuredRow& before, const MeasuredRow& now,
                    const Exceeds& exceeds) {
    const auto a = before.number(what), b = now.number(what);
    if (!a || !b) return;
    add(what, shown(a), shown(b),
        exceeds(*b, *a)   ? GateVerdict::regressed
        : exceeds(*a, *b) ? GateVerdict::better
                          : GateVerdict::passed);
  }

  /// True when counts say whether the row has become slower: a time that cannot tell is then no matter.
  bool judge_instructions(const MeasuredRow& before, const MeasuredRow& now) {
    const std::string what = "instructions";
    const auto a = before.number(what), b = now.number(what);
    if (!a) return false;
    if (!b) return add(what, shown(a), shown(b), GateVerdict::inconclusive), false;
    if (now_.counted_by != baseline_.counted_by)
      return add(what, baseline_.counted_by, now_.counted_by, GateVerdict::inconclusive), false;
    const double change = *b / *a - 1;
    const std::string text = fmt::format("{} ({:+.2f} %)", shown(b), 100 * change);
    add(what, shown(a), text,
        change > limits_.instructions    ? GateVerdict::regressed
        : change < -limits_.instructions ? GateVerdict::better
                                         : GateVerdict::passed);
    counted_ = true;
    return true;
  }

  void judge_time(const MeasuredCase& case_before, const MeasuredRow& before, const MeasuredCase& case_now,
                  const MeasuredRow& now, bool counted) {
    const GateVerdict untold = counted ? GateVerdict::not_judged : GateVerdict::inconclusive;
    const std::string what = before.spec == case_before.baseline ? "CPU in yardsticks" : "CPU to baseline";
    if (case_before.baseline != case_now.baseline)
      return add(what, "to " + case_before.baseline, "to " + case_now.baseline, untold);
    const auto a = relative_timings(case_before, before), b = relative_timings(case_now, now);
    if (const auto doubt = doubt_about(a, b, limits_.timing)) return add_doubt(what, a, b, *doubt, untold);
    const auto ratio = slowdown(b, a);
    const double slower = limits_.timing.slower;
    const bool sure = ratio.below(limits_.unsure) && ratio.estimate <= slower;
    const GateVerdict verdict = ratio.above(slower)       ? GateVerdict::regressed
                                : !sure                   ? untold
                                : ratio.below(1 / slower) ? GateVerdict::better
                                                          : GateVerdict::passed;
    add(what, "x 1", text_of(ratio), verdict);
  }

  void add_doubt(const std::string& what, const PairedTimings& before, const PairedTimings& now,
                 const TimingDoubt& doubt, GateVerdict untold) {
    using enum TimingDoubt::Kind;
    if (doubt.kind == too_few_rounds) {
      // The recorded build was timed long enough, and this one would have been.
      const bool cut_off = now_.interrupted && before.rounds() >= limits_.timing.rounds;
      add(what, quantity(before.rounds(), "round"), quantity(now.rounds(), "round"),
          cut_off ? untold : GateVerdict::not_judged);
    } else if (doubt.kind == too_short) {
      add(what, "", fmt::format("{:.2g} s is too short to judge", doubt.shortest), GateVerdict::not_judged);
    } else {
      const std::string itself = "A/A " + text_of(doubt.itself);
      add(what, doubt.of == &before ? itself : "", doubt.of == &now ? itself : "", untold);
    }
  }

  static std::string shown(const std::optional<double>& value) {
    return value ? fmt::format("{:.6g}", *value) : "not measured";
  }

  void add(std::string what, std::string before, std::string now, GateVerdict verdict) {
    if (verdict == GateVerdict::passed)
      ++report_.passed;
    else
      report_.findings.push_back({case_, spec_, std::move(what), std::move(before), std::move(now), verdict});
  }

  void conclude() {
    if (!not_measured_.empty())
      report_.notes.push_back(
          fmt::format("Not measured here, so that nobody can tell: {}.", fmt::join(not_measured_, ", ")));
    const auto any = [&](GateVerdict verdict) {
      return std::any_of(report_.findings.begin(), report_.findings.end(),
                         [&](const auto& finding) { return finding.verdict == verdict; });
    };
    report_.verdict = any(GateVerdict::regressed) ? GateVerdict::regressed
                      : any(GateVerdict::inconclusive) || !not_measured_.empty() || report_.passed == 0 ||
                              !(measured_ || counted_)
                          ? GateVerdict::inconclusive
                          : GateVerdict::passed;
    if (any(GateVerdict::better))
      report_.notes.emplace_back("Something got better: renew the baseline, so that it stays so.");
    std::stable_sort(report_.findings.begin(), report_.findings.end(),
                     [](const auto& a, const auto& b) { return a.verdict > b.verdict; });
  }

  const ResultsFile &now_, &baseline_;
  const std::function<bool(const std::string&)>& is_adaptive_;
  const GateLimits& limits_;
  bool same_build_ = false, same_machine_ = false, measured_ = true, counted_ = false;
  std::string case_, spec_;
  std::vector<std::string> not_measured_;  // methods of the baseline
  GateReport report_;
};

}  // namespace

GateReport judge(const ResultsFile& now, const ResultsFile& baseline,
                 const std::function<bool(const std::string&)>& is_adaptive, const GateLimits& limits) {
  return Judge(now, baseline, is_adaptive, limits).run();
}

}  // namespace superstep

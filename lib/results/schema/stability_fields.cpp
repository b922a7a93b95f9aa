#include "results/schema/stability_fields.hpp"

namespace superstep {

template <>
const RecordFields<MethodStability>& fields_of<MethodStability>() {
  using M = MethodStability;
  static const RecordFields<M> fields{
      field("method", &M::family),
      field("parameters", &M::parameters),
      field("order", &M::order, "in which STS carries out its substeps"),
      field("spec", &M::spec, "as it was run"),
      field("stages", &M::stages, "sweeps in a step"),
      field("step_s", &M::step, "s"),
      field("z_stiff", &M::z_stiff, "step times lambda_max"),
      field("beta", &M::beta, "declared end of stability in z; null = stable everywhere"),
      field("limit", &M::limit, "z at which |R| first exceeds 1, found numerically"),
      field("max_response", &M::largest, "max |R| over [0, z_stiff]"),
      field("damping", &M::damping, "max |R| over the stiffer half of [0, z_stiff]"),
      field("stiff_theory", &M::stiff, "R at z_stiff"),
      field("stiff_measured", &M::stiff_measured, "the same from the stiffest mode of the network"),
      field("difference", &M::difference, "worst |measured - R| over steps up to step_s"),
      field("tolerance", &M::tolerance, "that difference may have"),
      field("growth_measured", &M::growth, "factor per step of a white perturbation"),
      field("beyond_theory", &M::beyond, "|R| at a step that is too long"),
      field("beyond_measured", &M::beyond_measured, "growth per step of a white perturbation there"),
      field("agrees", &M::agrees, "measured = theory"),
  };
  return fields;
}

template <>
const RecordFields<StepEstimate>& fields_of<StepEstimate>() {
  static const RecordFields<StepEstimate> fields{
      field("estimate", &StepEstimate::name),
      field("step_s", &StepEstimate::step, "s"),
      field("alpha", &StepEstimate::alpha, "of the pairwise step without interface"),
      field("of_limit", &StepEstimate::of_limit, "over the limit found by bisection"),
      derived<StepEstimate>(
          "stable", [](const StepEstimate& e) { return std::string(stable_word(e.tendency)); },
          "yes, no or can not be told apart (growth within 1e-4 of 1)"),
      field("note", &StepEstimate::note),
      field("growth", &StepEstimate::growth, "measured factor per step"),
  };
  return fields;
}

template <>
const RecordFields<RoundingGrowth>& fields_of<RoundingGrowth>() {
  using R = RoundingGrowth;
  static const RecordFields<R> fields{
      field("n", &R::n),
      field("nu", &R::nu),
      field("order", &R::order),
      field("internal_amplification", &R::amplification, "what can become of one rounding"),
      field("superstep_rounding_eps", &R::superstep_error, "in units of machine epsilon"),
      field("run_rounding_spans", &R::rounding_error, "in spans of the field"),
      field("run_error_spans", &R::end_error, "in spans of the field"),
      field("right", &R::right, "rounding stays far below the span"),
  };
  return fields;
}

template <>
const RecordFields<SweepPoint>& fields_of<SweepPoint>() {
  using P = SweepPoint;
  static const RecordFields<P> fields{
      field("sweep", &P::sweep, "contrast, size ratio or nu"),
      field("contrast", &P::contrast, "largest over smallest conductance law constant"),
      field("size_ratio", &P::size_ratio, "largest over smallest radius"),
      field("nu", &P::nu),
      field("n", &P::n),
      field("nodes", &P::nodes),
      field("networks", &P::networks),
      field("edge_over_true", &P::edge_ratio, "certified edge bound over the true spectral radius"),
      field("gershgorin_over_true", &P::gershgorin_ratio),
      field("bound_over_true", &P::bound_ratio, "the smaller of both"),
      field("alpha_star", &P::alpha, "smallest true critical step over the pairwise step"),
  };
  return fields;
}

RecordFields<SweepPoint> sweep_columns(const std::vector<SweepPoint>& sweeps) {
  auto columns = fields_of<SweepPoint>();
  if (sweeps.empty()) return columns;
  for (std::size_t k = 0; k < sweeps.front().overshoots.size(); ++k)
    columns.push_back(
        derived<SweepPoint>("overshoot_" + sweeps.front().overshoots[k].method,
                            [k](const SweepPoint& point) { return point.overshoots[k].spans; }));
  return columns;
}

std::vector<FrozenRow> frozen_rows(const StabilityResults& results) {
  std::vector<FrozenRow> rows;
  for (const auto& state : results.states)
    for (const auto& limit : state.limits) rows.push_back({&state, &limit});
  return rows;
}

template <>
const RecordFields<FrozenRow>& fields_of<FrozenRow>() {
  using Row = const FrozenRow&;
  const auto text = [](const char* word) { return std::string(word); };
  static const RecordFields<FrozenRow> fields{
      derived<FrozenRow>(
          "part_of_run", [](Row r) { return r.state->part; }, "of t_end"),
      derived<FrozenRow>(
          "time_s", [](Row r) { return r.state->time; }, "s"),
      derived<FrozenRow>("unknowns", [](Row r) { return r.state->unknowns; }),
      derived<FrozenRow>(
          "spectrum", [](Row r) { return r.state->spectrum; }, "symmetric, real or complex"),
      derived<FrozenRow>("eigenvalues_by", [](Row r) { return r.state->found_by; }),
      derived<FrozenRow>(
          "lambda_max", [](Row r) { return r.state->lambda_max; },
          "1/s; modulus of the eigenvalue that limits forward Euler"),
      derived<FrozenRow>(
          "lambda_imaginary", [](Row r) { return r.state->lambda_imaginary; }, "1/s"),
      derived<FrozenRow>(
          "lambda_residual", [](Row r) { return r.state->lambda_residual; }, "1/s"),
      derived<FrozenRow>(
          "rising_rate", [](Row r) { return r.state->rising; },
          "1/s; of a perturbation that grows by itself, 0 = none, null = not known"),
      derived<FrozenRow>(
          "certified_bound", [](Row r) { return r.state->certified_bound; }, "1/s; of the spectral radius"),
      derived<FrozenRow>("method", [](Row r) { return r.limit->family; }),
      derived<FrozenRow>("parameters", [](Row r) { return r.limit->parameters; }),
      derived<FrozenRow>(
          "spec", [](Row r) { return r.limit->spec; }, "at the measured limit"),
      derived<FrozenRow>(
          "limit_predicted_s", [](Row r) { return r.limit->predicted; }, "s; from eigenvalues"),
      derived<FrozenRow>(
          "limit_measured_s", [](Row r) { return r.limit->measured; }, "s; longest step without growth"),
      derived<FrozenRow>("predicted_over_measured",
                         [](Row r) {
                           const auto& limit = *r.limit;
                           return limit.predicted ? Number(*limit.predicted / limit.measured) : Number();
                         }),
      derived<FrozenRow>(
          "growth_at_predicted", [](Row r) { return r.limit->growth_at_predicted; },
          "measured factor per step"),
      derived<FrozenRow>(
          "verdict", [text](Row r) { return text(verdict_name(r.limit->verdict)); },
          "agrees (within 2 %), differs or no prediction"),
  };
  return fields;
}

template <>
const RecordFields<Verdict>& fields_of<Verdict>() {
  static const RecordFields<Verdict> fields{
      field("method", &Verdict::method),
      derived<Verdict>(
          "grade", [](const Verdict& v) { return std::string(grade_name(v.grade)); },
          "safe, careful or unsafe"),
      field("text", &Verdict::text),
  };
  return fields;
}

template <>
const RecordFields<StabilityResults>& fields_of<StabilityResults>() {
  using S = StabilityResults;
  auto sweeps = field("sweeps", &S::sweeps, "random networks of one kind each");
  sweeps.write = [](const S& results) {
    Json rows = Json::array();
    const auto columns = sweep_columns(results.sweeps);
    for (const auto& point : results.sweeps) rows.push_back(write_record(columns, point));
    return rows;
  };
  static const RecordFields<S> fields{
      field("case", &S::case_name),
      field("title", &S::title),
      field("quick", &S::quick),
      field("linear", &S::linear, "modes are the same at all times"),
      field("unknowns", &S::unknowns),
      field("lambda_max", &S::lambda_max, "1/s; the largest among the states"),
      field("lambda_max_residual", &S::lambda_residual, "1/s"),
      derived<S>(
          "limit_by_bisection", [](const S& s) { return s.critical_step.limit; },
          "s; null when nothing limits the step"),
      derived<S>("lanczos_over_bisection", [](const S& s) { return s.critical_step.lanczos_ratio; }),
      field("methods", &S::methods, "stability functions, in theory and measured"),
      derived<S>(
          "critical_step", [](const S& s) { return s.critical_step.estimates; },
          "estimates of forward Euler's critical step"),
      field("rounding", &S::rounding, "STS with one order of its substeps each"),
      sweeps,
      derived<S>("states", frozen_rows, "methods at states of a run at which the scene was frozen"),
      field("notes", &S::notes, "on states that were left out"),
      field("verdicts", &S::verdicts),
  };
  return fields;
}

}  // namespace superstep

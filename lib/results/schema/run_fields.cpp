#include "results/schema/run_fields.hpp"

#include "results/schema/bench_fields.hpp"

namespace superstep {

template <>
const RecordFields<SteadyCurrent>& fields_of<SteadyCurrent>() {
  static const RecordFields<SteadyCurrent> fields{
      field("voltage_v", &SteadyCurrent::voltage, "V"),
      field("current_in_a", &SteadyCurrent::current_in, "A"),
      field("current_out_a", &SteadyCurrent::current_out, "A"),
      field("resistance_ohm", &SteadyCurrent::resistance,
            "Ohm; null when no current flows, or where sources feed one in between the electrodes"),
      field("joule_heat_w", &SteadyCurrent::joule_heat, "W"),
  };
  return fields;
}

template <>
const RecordFields<MotionRecord::Snapshot>& fields_of<MotionRecord::Snapshot>() {
  using Snapshot = MotionRecord::Snapshot;
  static const RecordFields<Snapshot> fields{
      field("file", &Snapshot::file, "in the same folder"),
      field("time", &Snapshot::time, "s"),
      field("upper_wall", &Snapshot::upper_wall, "m; its height"),
  };
  return fields;
}

template <>
const RecordFields<MotionRecord::PhaseEnd>& fields_of<MotionRecord::PhaseEnd>() {
  using End = MotionRecord::PhaseEnd;
  static const RecordFields<End> fields{
      field("phase", &End::phase),
      field("time", &End::time, "s"),
      field("volume_fraction", &End::volume_fraction),
      field("mean_temperature", &End::mean_temperature, "K"),
      field("max_temperature", &End::max_temperature, "K"),
      field("wall_force", &End::wall_force, "N; on the upper wall"),
      field("bonds", &End::bonds, "bonded pairs"),
      field("contacts", &End::contacts, "pairs that touch"),
  };
  return fields;
}

template <>
const RecordFields<MotionRecord::Parts>& fields_of<MotionRecord::Parts>() {
  using Parts = MotionRecord::Parts;
  static const RecordFields<Parts> fields{field("contacts", &Parts::contacts),
                                          field("forces", &Parts::forces), field("heat", &Parts::heat),
                                          field("current", &Parts::current), field("rest", &Parts::rest)};
  return fields;
}

template <>
const RecordFields<MotionRecord>& fields_of<MotionRecord>() {
  static const RecordFields<MotionRecord> fields{
      group<MotionRecord>("box", {field("min", &MotionRecord::box_min), field("max", &MotionRecord::box_max)},
                          "m; corners at the start"),
      field("snapshots", &MotionRecord::snapshots, "final.csv comes last where no snapshot was taken then"),
      field("phase_ends", &MotionRecord::phase_ends),
      field("iterations", &MotionRecord::iterations, "of the fixed point, rejected attempts included"),
      field("neighbour_lists", &MotionRecord::neighbour_lists, "how often one was built"),
      field("cpu_parts_s", &MotionRecord::cpu_parts, "s"),
  };
  return fields;
}

template <>
const RecordFields<RunRecord>& fields_of<RunRecord>() {
  static const RecordFields<RunRecord> fields = [] {
    RecordFields<RunRecord> all{
        field("version", &RunRecord::version, "of the program"),
        field("revision", &RunRecord::revision, "of the program"),
        field("case", &RunRecord::case_name, "stem of the case file"),
        field("title", &RunRecord::title),
        field("source", &RunRecord::source),
        field("integrator", &RunRecord::integrator, "SPEC before the colon"),
        field("params", &RunRecord::params, "SPEC behind the colon"),
        field("choice", &RunRecord::choice, "what the method chose by itself and why"),
        group<RunRecord>("outcome", {one_of(field("status", &RunRecord::status), statuses()),
                                     field("reason", &RunRecord::reason),
                                     amount("t_reached", &RunRecord::t_reached, "s")}),
        amount("t_end", &RunRecord::t_end, "s"),
        field("nodes", &RunRecord::nodes),
        field("contacts", &RunRecord::contacts),
        field("unknowns", &RunRecord::unknowns),
        field("threads", &RunRecord::threads),
        field("processes", &RunRecord::processes, "that took part; CPU times are their sums"),
        field("distributed", &RunRecord::distributed,
              "exact: the result of one process, bit by bit; gathered: one did it for all; empty: there was "
              "one"),
        group<RunRecord>("communication",
                         {field("reductions", &RunRecord::reductions, "sums and maxima over all processes"),
                          field("halo_messages", &RunRecord::halo_messages, "of all processes"),
                          field("halo_bytes", &RunRecord::halo_bytes, "of all processes"),
                          amount("imbalance", &RunRecord::imbalance,
                                 "most entries of the network that a process has, over their mean")}),
        group<RunRecord>(
            "counts", {field("steps", &RunRecord::steps), field("rejected", &RunRecord::rejected),
                       field("rhs", &RunRecord::rhs, "sweeps"), field("jacobians", &RunRecord::jacobians),
                       field("factorizations", &RunRecord::factorizations),
                       field("solves", &RunRecord::solves), field("max_stages", &RunRecord::max_stages),
                       field("potential_solves", &RunRecord::potential_solves),
                       derived<RunRecord>("skips", [](const RunRecord& run) { return run.skips.size(); })}),
        field("potential_settled_at_s", &RunRecord::settled_at,
              "s; since when the potential was steady and no longer stepped"),
        field("electrodes", &RunRecord::electrodes),
        amount("cpu_setup_s", &RunRecord::cpu_setup, "s"),
        amount("cpu_prepare_s", &RunRecord::cpu_prepare, "s"),
        amount("cpu_stepping_s", &RunRecord::cpu_stepping, "s"),
        amount("cpu_pilot_s", &RunRecord::cpu_pilot, "s"),
        amount("cpu_verify_s", &RunRecord::cpu_verify, "s"),
        field("verified_by", &RunRecord::verified_by, "SPEC that --verify ran as well; empty = it did not"),
        amount("delivered", &RunRecord::delivered, "error over the tolerance asked for, as far as verified"),
        amount("error_bound", &RunRecord::error_bound,
               "the method's own bound of its error over the span; null = it has none"),
        amount("rounding_bound", &RunRecord::rounding_bound,
               "the part of error_bound that is rounding, by a model"),
        amount("spans", &RunRecord::spans, "K or V, one a field"),
        amount("wall_stepping_s", &RunRecord::wall_stepping, "s"),
        amount("peak_memory_mb", &RunRecord::peak_memory_mb, "1e6 bytes"),
        field("files", &RunRecord::files, "what was written beside it"),
        field("skips", &RunRecord::skips, "work that the scene does not need"),
        field("warnings", &RunRecord::warnings),
        field("machine", &RunRecord::machine, "facts by name"),
        field("libraries", &RunRecord::libraries, "facts by name"),
    };
    auto motion = field("motion", &RunRecord::motion, "of moving particles");
    motion.always = false;
    all.push_back(motion);
    return all;
  }();
  return fields;
}

}  // namespace superstep

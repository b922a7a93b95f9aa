#include "results/schema/corpus_fields.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/options.hpp"
#include "results/schema/bench_fields.hpp"

namespace superstep {
namespace {

RecordField<CorpusRow> params_field() {
  auto out = field("params", &CorpusRow::params, "SPEC behind the colon");
  out.read = [](CorpusRow& row, const JsonObject& json) {
    row.params = json.text("params");
    row.spec = row.integrator + (row.params.empty() ? "" : ":" + row.params);
    try {
      (void)parse_spec(row.spec);
    } catch (const UsageError& error) {  // nobody typed it: it is the file that has to be mended
      json.reject(row.params.empty() ? "integrator" : "params", error.what());
    }
  };
  return out;
}

/// A list in one cell: numbers with blanks between.
RecordField<CorpusRow> samples_field() {
  return {
      "samples_s",
      "s; CPU times of the rounds, blanks between; a round's is the least of some runs where they are short",
      json_value::schema<std::string>(),
      [](const CorpusRow& row) { return Json(fmt::format("{}", fmt::join(row.samples, " "))); },
      [](CorpusRow& row, const JsonObject& json) {
        const std::string text = json.text("samples_s");
        row.samples.clear();
        for (std::size_t begin = 0; begin < text.size();) {
          const std::size_t end = std::min(text.find(' ', begin), text.size());
          const auto number = parse_number(std::string_view(text).substr(begin, end - begin));
          if (!number || !(*number >= 0)) json.reject("samples_s", "it must hold numbers >= 0");
          row.samples.push_back(*number);
          begin = end + 1;
        }
      }};
}

RecordField<CorpusRow> physics_field() {
  auto out =
      field("physics", &CorpusRow::physics,
            "linear, one-way, nonlinear or coupled; -steady behind it where a potential is solved for");
  out.read = [](CorpusRow& row, const JsonObject& json) {
    static constexpr std::array known = {"",
                                         "linear",
                                         "one-way",
                                         "nonlinear",
                                         "coupled",
                                         "linear-steady",
                                         "one-way-steady",
                                         "nonlinear-steady",
                                         "coupled-steady"};
    row.physics = json.text("physics");
    if (std::find(known.begin(), known.end(), row.physics) == known.end())
      json.reject("physics",
                  "it must be linear, one-way, nonlinear or coupled, or one of these with -steady");
  };
  return out;
}

}  // namespace

template <>
const RecordFields<CorpusRow>& fields_of<CorpusRow>() {
  static const RecordFields<CorpusRow> fields = {
      field("scene", &CorpusRow::scene, "stem of the case file"),
      field("set", &CorpusRow::set, "smallest set that holds it"),
      field("class", &CorpusRow::scene_class, "what the scene is about"),
      field("kind", &CorpusRow::kind, "of its network"),
      field("unknowns", &CorpusRow::unknowns, "entries of the state"),
      amount("stiffness", &CorpusRow::stiffness, "t_end times the spectral radius at the start"),
      amount("contrast", &CorpusRow::contrast,
             "largest over smallest rate of exchange, as the case states it"),
      field("integrator", &CorpusRow::integrator, "SPEC before the colon"),
      params_field(),
      one_of(field("status", &CorpusRow::status, "as in results.csv"), statuses()),
      field("reason", &CorpusRow::reason, "why it is not ok"),
      amount("cpu_s", &CorpusRow::cpu, "s; CPU time of preparing and stepping, median of the samples"),
      amount("cpu_prepare_s", &CorpusRow::cpu_prepare, "s; of that before the first step"),
      samples_field(),
      field("memory_mb", &CorpusRow::memory, "MB that the run added to the memory in use"),
      amount("error", &CorpusRow::error,
             "rms error over the span of the field, worst of the fields and output times"),
      field("sweeps", &CorpusRow::sweeps, "passes over the network"),
      field("steps", &CorpusRow::steps, "accepted steps"),
      field("reference", &CorpusRow::reference, "SPEC that errors are measured against"),
      amount("reference_error", &CorpusRow::reference_error, "its error bar over the span"),
      field("threads", &CorpusRow::threads, "threads that were allowed"),
      amount("time_limit_s", &CorpusRow::time_limit, "s; CPU time that a run was allowed"),
      field("choice", &CorpusRow::choice, "what the method chose by itself"),
      field("processor", &CorpusRow::processor, "that it was measured on"),
      field("revision", &CorpusRow::revision, "of the program"),
      field("key", &CorpusRow::key, "names scene, build and machine"),
      physics_field(),
      amount("pieces", &CorpusRow::pieces, "between the breakpoints of its inputs"),
      amount("shapes", &CorpusRow::shapes, "of the inputs that change in time"),
      amount("output_decades", &CorpusRow::output_decades, "between the first output and the last"),
      field("nonzeros", &CorpusRow::nonzeros, "of the fields' matrices off their diagonals"),
  };
  return fields;
}

}  // namespace superstep

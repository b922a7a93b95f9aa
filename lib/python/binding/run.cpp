#include "python/binding/run.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/harness/verification.hpp"
#include "bench/measure/run_one.hpp"
#include "case/inputs/workable_times.hpp"
#include "core/error.hpp"
#include "python/binding/arrays.hpp"
#include "python/binding/bound_scene.hpp"
#include "python/binding/interruptible.hpp"

namespace superstep::python {
namespace {

using Memory = std::shared_ptr<std::vector<double>>;

void require_times(const std::vector<double>& times) {
  if (times.empty()) throw InputError("output_times is empty; at least one is needed");
  double previous = 0;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (!std::isfinite(times[k]) || !(times[k] > previous))
      throw InputError(fmt::format("output_times[{}] is {}; the times must be finite, > 0 and ascending [s]",
                                   k, times[k]));
    if (const auto rule = unworkable_time(fmt::format("output_times[{}],", k), times[k]); !rule.empty())
      throw InputError(rule);
    previous = times[k];
  }
}

/// Repeated tables are written out, and ranges known, up to the end of the scene.
void require_known_inputs(const Scene& scene, double t_end) {
  if (t_end <= scene.t_end) return;
  for (const auto& field : scene.fields)
    if (!field.graph.tables.empty())
      throw InputError(fmt::format(
          "{}: the run is to end at {} s, and its inputs change in time and are known until t_end "
          "= {} s; build the scene with a later t_end",
          scene.file, t_end, scene.t_end));
}

py::dict statistics_of(const RunResult& run) {
  const Statistics& counted = run.statistics;
  py::dict out;
  out["sweeps"] = run.sweeps;
  out["steps"] = counted.steps;
  out["rejected"] = counted.rejected;
  out["jacobians"] = run.jacobians;
  out["factorizations"] = counted.factorizations;
  out["solves"] = counted.solves;
  out["potential_solves"] = run.potential_solves;
  out["max_stages"] = counted.max_stages;
  out["cpu_prepare_s"] = run.cpu_prepare;
  out["cpu_stepping_s"] = run.cpu_stepping;
  out["wall_stepping_s"] = run.wall_stepping;
  out["cpu_pilot_s"] = run.cpu_pilot;
  out["error_bound"] = error_bound_of(run);
  out["rounding_bound"] = rounding_bound_of(run);
  out["settled_at"] = run.settled_at;
  return out;
}

/// Rows of states, one an output time, filled by the run and looked at by Python.
class Rows {
 public:
  Rows(std::size_t times, std::size_t unknowns)
      : width_(unknowns), memory_(std::make_shared<std::vector<double>>(times * unknowns)) {}

  [[nodiscard]] double* row(std::size_t k) noexcept { return memory_->data() + k * width_; }
  [[nodiscard]] py::array_t<double> row_view(std::size_t k) {
    return read_only(row(k), {static_cast<py::ssize_t>(width_)}, memory_);
  }
  /// The first rows as one array, which owns the memory from now on.
  [[nodiscard]] py::array_t<double> first(std::size_t rows) {
    return py::array_t<double>({static_cast<py::ssize_t>(rows), static_cast<py::ssize_t>(width_)},
                               memory_->data(), keeper(memory_));
  }

 private:
  std::size_t width_;
  Memory memory_;
};

py::dict run(BoundScene& bound, const std::string& method, std::optional<double> rtol,
             std::vector<double> times, const py::object& on_output, int threads, double time_limit) {
  MethodSpec spec(method);
  if (rtol) spec = spec.with_tolerance(*rtol);
  require_times(times);
  if (threads < 1) throw InputError(fmt::format("threads is {}; it must be >= 1", threads));
  BoundScene::Use use(bound);
  require_known_inputs(use.scene(), times.back());
  use.set_output_times(times);

  Rows rows(times.size(), bound.unknowns().size());
  std::size_t reached = 0;
  Interruptible work;
  RunRequest request{.stop = &work.stop(), .limits = {.seconds = time_limit}, .watches_range = true};
  request.observe = [&](std::size_t k, double t, std::span<const double> state) {
    bound.unknowns().to_user(state, rows.row(k));
    reached = k + 1;
    if (!on_output.is_none()) work.in_interpreter([&, k, t] { on_output(t, rows.row_view(k)); });
  };
  RunResult result;
  work.run(threads, [&] { result = run_one(use.scene(), spec, request); });
  if (result.outcome.ok()) judge_range(use.scene(), result, result.outcome);

  times.resize(reached);
  py::dict out;
  out["method"] = spec.text();
  out["status"] = status_name(result.outcome.status);
  out["reason"] = result.outcome.reason;
  out["choice"] = result.choice;
  out["t_reached"] = result.t_reached;
  out["spans"] = result.spans;
  out["times"] = hand_over(std::move(times));
  out["states"] = rows.first(reached);
  out["statistics"] = statistics_of(result);
  return out;
}

}  // namespace

void add_run(py::module_& module) {
  module.def("run", &run, py::arg("scene"), py::arg("method"), py::arg("rtol"), py::arg("times"),
             py::arg("on_output"), py::arg("threads"), py::arg("time_limit"));
}

}  // namespace superstep::python

#include "python/binding/benchmark.hpp"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <limits>
#include <string>
#include <vector>

#include "bench/app/loaded_case.hpp"
#include "bench/harness/harness.hpp"
#include "core/error.hpp"
#include "python/binding/arrays.hpp"
#include "python/binding/bound_scene.hpp"
#include "python/binding/interruptible.hpp"
#include "reports/html/published.hpp"
#include "results/schema/bench_fields.hpp"

namespace superstep::python {
namespace {

using Column = RecordField<BenchRow>;

py::list texts(const Column& column, const std::vector<BenchRow>& rows) {
  py::list out;
  for (const auto& row : rows) {
    const Json value = column.write(row);
    out.append(value.is_string() ? py::object(py::str(value.get<std::string>())) : py::object(py::none()));
  }
  return out;
}

py::object numbers(const Column& column, const std::vector<BenchRow>& rows) {
  std::vector<double> values;
  std::vector<std::int64_t> counts;
  for (const auto& row : rows) {
    const Json value = column.write(row);
    if (value.is_number_integer()) counts.push_back(value.get<std::int64_t>());
    values.push_back(value.is_number() ? value.get<double>() : std::numeric_limits<double>::quiet_NaN());
  }
  if (counts.size() == rows.size()) return hand_over(std::move(counts));  // nothing is missing
  return hand_over(std::move(values));
}

py::dict columns(const BenchCase& one) {
  py::dict out;
  for (const auto& column : bench_columns(any_potential({&one, 1}))) {
    const bool is_text = column.schema.at("type") == "string";
    out[py::str(column.name)] = is_text ? py::object(texts(column, one.rows)) : numbers(column, one.rows);
  }
  return out;
}

py::tuple bench(BoundScene& bound, const std::vector<std::string>& methods, const std::string& reference,
                int repetitions, bool cache, int threads, double time_limit) {
  check_specs(methods);
  if (!reference.empty() && reference != "none") check_specs({reference});
  if (repetitions < 1) throw InputError(fmt::format("repetitions is {}; it must be >= 1", repetitions));
  if (threads < 1) throw InputError(fmt::format("threads is {}; it must be >= 1", threads));
  if (!(time_limit >= 0))
    throw InputError(fmt::format("time_limit is {}; it must be seconds, or 0 for none", time_limit));
  const BoundScene::Use use(bound);
  Scene& scene = use.scene();
  prepare_for_bench(scene, bound.root());
  if (!bound.is_of_files()) scene.content_hash.clear();  // it says nothing about what is in memory
  Interruptible work;
  HarnessOptions options;
  options.integrators = methods;
  options.reference = reference;
  options.use_cache = cache;
  options.repetitions = repetitions;
  options.threads = threads;
  options.sampled = published_measure(scene.source);
  options.limits.seconds = time_limit;
  options.stop = &work.stop();
  Progress silent(false);
  BenchCase one;
  work.run(threads, [&] { one = bench_case(scene, bound.cpu_setup(), options, silent); });
  return py::make_tuple(columns(one), one.warnings);
}

}  // namespace

void add_bench(py::module_& module) {
  module.def("bench", &bench, py::arg("scene"), py::arg("methods"), py::arg("reference"),
             py::arg("repetitions"), py::arg("cache"), py::arg("threads"), py::arg("time_limit"));
}

}  // namespace superstep::python

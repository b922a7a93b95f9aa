#include "python/binding/bound_scene.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "bench/app/loaded_case.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/text/quantity.hpp"

namespace superstep::python {
namespace {

Scene load(TomlTable root, const CaseData& data) {
  if (root.find("dynamics"))
    throw InputError(
        fmt::format("{}: its particles move ([dynamics]); the Python module takes networks that stay as they "
                    "are: run it by the program",
                    root.file()));
  Scene scene = load_scene(std::move(root), data);
  check_specs_of(scene);
  return scene;
}

}  // namespace

BoundScene::BoundScene(TomlTable root, const CaseData& data)
    : root_(std::move(root)),
      cpu_setup_(-process_cpu_seconds()),
      scene_(load(root_, data)),
      is_of_files_(!data.spheres && !data.network),
      unknowns_(scene_) {
  cpu_setup_ += process_cpu_seconds();
}

std::vector<double> BoundScene::state_of(std::span<const double> y) const {
  if (y.size() != unknowns_.size())
    throw InputError(fmt::format("y has {}, and the scene {}", quantity(y.size(), "value"),
                                 quantity(unknowns_.size(), "unknown")));
  std::vector<double> state(y.size());
  unknowns_.to_state(y, state);
  return state;
}

void BoundScene::rhs(double t, std::span<const double> y, double* rates) {
  const Use use(*this);
  const auto state = state_of(y);
  std::vector<double> rate(state.size());
  scene_.rhs->ask_accuracy(0);  // as the scene states, whatever a run before had asked for
  (*scene_.rhs)(time_of_inputs(t), state, rate);
  unknowns_.rates_to_user(rate, rates);
}

const Unknowns::Pattern& BoundScene::jacobian_pattern() {
  const Use use(*this);
  if (!pattern_) pattern_ = unknowns_.pattern(scene_.rhs->pattern());
  return *pattern_;
}

void BoundScene::jacobian(double t, std::span<const double> y, double* values) {
  const auto& pattern = jacobian_pattern();
  const Use use(*this);
  const auto state = state_of(y);
  std::vector<double> own(pattern.source.size());
  scene_.rhs->ask_accuracy(0);
  scene_.rhs->jacobian(time_of_inputs(t), state, own);
  for (std::size_t k = 0; k < own.size(); ++k) values[k] = own[pattern.source[k]];
}

std::vector<double> BoundScene::values_on_nodes(std::size_t field, double t, std::span<const double> y) {
  std::optional<Use> use;
  if (scene_.fields[field].steady) use.emplace(*this);  // it is solved for
  return scene_.values_on_nodes(field, time_of_inputs(t), state_of(y));
}

BoundScene::Use::Use(BoundScene& bound) : bound_(bound) {
  if (bound_.used_.exchange(true))
    throw std::runtime_error(
        "the scene is being used: one run, or one call of rhs or jacobian, at a time; build another one for "
        "what is to go on beside it");
  t_end_ = bound.scene_.t_end;
  output_times_ = bound.scene_.output_times;
  content_hash_ = bound.scene_.content_hash;
}

BoundScene::Use::~Use() {
  bound_.scene_.t_end = t_end_;
  bound_.scene_.output_times = std::move(output_times_);
  bound_.scene_.content_hash = std::move(content_hash_);
  bound_.used_.store(false);
}

void BoundScene::Use::set_output_times(std::vector<double> times) {
  bound_.scene_.t_end = times.back();
  bound_.scene_.output_times = std::move(times);
}

}  // namespace superstep::python

#include "bench/harness/observations.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "bench/measure/metrics.hpp"
#include "bench/measure/run_one.hpp"
#include "results/thinning.hpp"

namespace superstep {
namespace {

constexpr std::size_t most_instants = 400;  // a chart is some 800 pixels wide
constexpr std::size_t most_spheres = 4000;  // of one picture
constexpr std::size_t most_frames = 5;      // besides the initial state

/// Where the reference is how far from its value at the end: what decides which instants are the transient.
std::size_t transient_of(const ProbeCurve& curve, const ProbeHistory& reference, std::size_t slot,
                         double origin, double t_end) {
  const double last = reference.at(t_end, slot);
  double largest = 0;
  for (std::size_t k = 0; k < reference.size() && reference.time(k) <= t_end; ++k)
    largest = std::max(largest, std::abs(reference.value(k, slot) - last));
  std::vector<double> distance;
  for (const double expected : curve.reference) distance.push_back(std::abs(expected - origin - last));
  return transient_length(distance, largest);
}

double plane_of(const Packing& packing) {
  const Bounds bounds = surface_bounds(packing);
  return 0.5 * (bounds.min.y + bounds.max.y);
}

std::vector<std::size_t> cut_spheres(const Packing& packing, double plane) {
  std::vector<std::size_t> cut;
  for (std::size_t i = 0; i < packing.size(); ++i)
    if (std::abs(packing.centre[i].y - plane) < packing.radius[i]) cut.push_back(i);
  return cut;
}

}  // namespace

std::vector<ProbeCurve> probe_curves(const Scene& scene, const ProbeSet& probes, const std::string& spec,
                                     const ProbeHistory& run, const Reference* reference) {
  std::vector<ProbeCurve> curves;
  std::size_t inside = 0;  // a method with dense output may step past the end
  while (inside < run.size() && run.time(inside) <= scene.t_end) ++inside;
  for (const auto& column : probes.columns()) {
    if (column.slot < 0 || inside == 0) continue;
    const auto slot = static_cast<std::size_t>(column.slot);
    const std::string& unit = scene_field(scene, column.field).unit;
    ProbeCurve curve{.spec = spec,
                     .field = column.field,
                     .unit = unit,
                     .probe = column.name.substr(column.field.size() + 1)};
    for (const std::size_t k : evenly_thinned(inside, most_instants)) {
      curve.time.push_back(run.time(k));
      curve.value.push_back(run.value(k, slot) + column.origin);
      if (reference) curve.reference.push_back(reference->history.at(run.time(k), slot) + column.origin);
    }
    if (reference)
      curve.transient = transient_of(curve, reference->history, slot, column.origin, scene.t_end);
    curves.push_back(std::move(curve));
  }
  return curves;
}

SliceRecorder::SliceRecorder(const Scene& scene) : scene_(scene) {
  const Packing& packing = scene.packed->packing;
  const double plane = plane_of(packing);
  const auto cut = cut_spheres(packing, plane);
  slice_.cut = cut.size();
  for (const std::size_t k : randomly_thinned(cut.size(), most_spheres)) {
    const std::size_t i = cut[k];
    particles_.push_back(i);
    const Vec3& centre = packing.centre[i];
    slice_.spheres.push_back({packing.id[i], centre.x, centre.z, centre.y - plane, packing.radius[i]});
  }
  outputs_ = evenly_thinned(scene.output_times.size(), most_frames);
  add_frames(0.0, scene.initial);
}

void SliceRecorder::observe(std::size_t output, double t, std::span<const double> state) {
  if (std::find(outputs_.begin(), outputs_.end(), output) != outputs_.end()) add_frames(t, state);
}

void SliceRecorder::add_frames(double t, std::span<const double> state) {
  for (std::size_t f = 0; f < scene_.fields.size(); ++f) {
    const auto values = scene_.values_on_nodes(f, t, state);
    Slice::Frame frame{.field = scene_.fields[f].name, .unit = scene_.fields[f].unit, .time = t};
    for (const std::size_t i : particles_) frame.value.push_back(values[i]);
    slice_.frames.push_back(std::move(frame));
  }
}

Slice SliceRecorder::take(const std::string& source) {
  slice_.source = source;
  std::stable_sort(slice_.frames.begin(), slice_.frames.end(),
                   [](const auto& a, const auto& b) { return a.field < b.field; });
  return std::move(slice_);
}

Slice slice_of(const Scene& scene, const Reference& reference) {
  SliceRecorder recorder(scene);
  for (std::size_t k = 0; k < reference.states.size(); ++k)
    recorder.observe(k, scene.output_times[k], reference.states[k]);
  return recorder.take(reference.spec);
}

}  // namespace superstep

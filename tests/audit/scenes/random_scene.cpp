#include "audit/scenes/random_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/scenes/calibration.hpp"
#include "audit/scenes/draft.hpp"
#include "audit/scenes/excursion.hpp"

namespace superstep::audit {
namespace {

// Those of a case file that says nothing about them.
constexpr double settle_tolerance = 1e-9, resolve_change = 1e-6;

std::string draw_kind(Draft& draft) {
  static const std::vector<std::pair<const char*, double>> shares = {
      {"linear-constant", 0.2}, {"driven-linear", 0.25}, {"radiation-convection", 0.14}, {"kappa-T", 0.12},
      {"one-way", 0.11},        {"two-way", 0.09},       {"steady-potential", 0.09}};
  double draw = draft.random.uniform();
  if (!draft.wishes.kind.empty()) return draft.wishes.kind;
  for (const auto& [kind, share] : shares)
    if ((draw -= share) < 0) return kind;
  return shares.front().first;
}

/// Small ones are common, so that thousands of scenes take minutes.
std::int32_t draw_size(Draft& draft, bool coupled) {
  const double most = static_cast<double>(coupled ? std::min<std::size_t>(30, draft.wishes.most_nodes)
                                                  : draft.wishes.most_nodes);
  return static_cast<std::int32_t>(std::lround(log_uniform(draft.random, 3, std::max(4.0, most))));
}

void draw_scales(Draft& draft, bool kelvin, bool warm) {
  static const double offsets[] = {0, 300, 1000};
  static const double scales[] = {1e-3, 0.1, 1, 10, 100};
  draft.offset = offsets[draft.random.below(3)];
  draft.scale = scales[draft.random.below(5)] * draft.random.uniform(0.5, 2);
  if (kelvin) draft.scale = log_uniform(draft.random, 30, 1500);
  if (warm) draft.scale = log_uniform(draft.random, 10, 500);
  draft.at_rest = draft.chance(0.6);
}

/// Times of output: the end, within pulses, and others from early to late.
void draw_outputs(Draft& draft) {
  const double t_end = draft.scene.t_end;
  auto& times = draft.scene.output_times;
  const std::size_t count = 1 + draft.random.below(6);
  times.push_back(t_end);
  draft.random.shuffle(draft.moments);
  for (std::size_t k = 0; k < draft.moments.size() && times.size() < std::max<std::size_t>(2, count); ++k)
    if (k < 2 && draft.moments[k] < t_end) times.push_back(draft.moments[k]);
  while (times.size() < count) {
    const bool early = draft.chance(0.4);
    const double part = early ? log_uniform(draft.random, 1e-5, 1) : draft.random.uniform(0.01, 1);
    times.push_back(t_end * part);
  }
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

double draw_t_lambda(Draft& draft, bool linear) {
  const bool very_stiff = draft.chance(0.1);
  return linear && very_stiff ? log_uniform(draft.random, 1e6, 1e9) : log_uniform(draft.random, 1, 1e6);
}

void draw_single(Draft& draft) {
  const std::string& kind = draft.scene.kind;
  const bool law = kind == "kappa-T",
             radiation = kind == "radiation-convection" || (law && draft.chance(0.1));
  draft.linear = !law && !radiation;
  draft.constant = kind == "linear-constant" || (!draft.linear && draft.chance(0.4));
  if (!draft.linear) draft.most_points = draft.chance(0.1) ? 150 : 25;
  draw_scales(draft, radiation, law);
  if (draft.chance(0.4)) draft.source_rise = draft.scale * log_uniform(draft.random, 0.1, 2);
  FieldScene field;
  const bool potential = draft.linear && draft.chance(0.1);
  field.name = potential ? "potential" : "temperature";
  field.unit = potential ? "V" : "K";
  if (law) field.laws = random_laws(draft, true);
  field.graph = bare_graph(draft, log_uniform(draft.random, 1, 1e8), log_uniform(draft.random, 1, 1e4));
  field.bare = field.graph.conductance;
  if (!potential && draft.chance(radiation ? 0.6 : 0.25)) add_convection(draft, field.graph);
  if (radiation) add_radiation(draft, field.graph);
  draft.scene.t_lambda = draw_t_lambda(draft, draft.linear);
  draft.scene.t_end = draft.scene.t_lambda / radius_bound(field.graph, draft.offset + draft.scale);
  const auto free_at_least = static_cast<std::size_t>(draft.wiring.nodes) - 2;
  draw_inputs(draft, std::min<std::size_t>(draft.random.below(5), free_at_least), field);
  draft.scene.fields.push_back(std::move(field));
}

/// The potential's capacities are an algorithmic choice: it may be faster or slower than the heat.
void set_electric_pace(Draft& draft, double thermal_radius, Graph& electric) {
  const double room = 1e6 / draft.scene.t_lambda;
  const double pace = std::min(room, log_uniform(draft.random, 1e-2, 1e2));
  const double factor = radius_bound(electric, 0) / (pace * thermal_radius);
  for (auto& capacity : electric.capacity) capacity *= factor;
}

void draw_pair(Draft& draft) {
  const std::string& kind = draft.scene.kind;
  const bool steady = kind == "steady-potential", two_way = kind == "two-way";
  const bool electric_law = two_way || (steady && draft.chance(0.5));
  const bool thermal_law = (two_way || steady) && draft.chance(0.4);
  draft.linear = false;
  draft.constant = draft.chance(0.4);
  draft.most_points = draft.chance(0.1) ? 150 : 25;
  draw_scales(draft, false, electric_law || thermal_law);
  const bool heats = two_way || draft.scene.seed % 7 != 0;  // else the fields leave each other alone
  draft.at_rest = draft.chance(0.8) && heats;
  draft.joule_rise = draft.scale * log_uniform(draft.random, 0.1, 2);
  if (draft.chance(0.15)) draft.source_rise = draft.scale * log_uniform(draft.random, 0.1, 1);

  FieldScene thermal;
  thermal.name = "temperature";
  thermal.unit = "K";
  thermal.laws = random_laws(draft, thermal_law);
  thermal.graph = bare_graph(draft, log_uniform(draft.random, 1, 1e4), log_uniform(draft.random, 1, 1e2));
  thermal.bare = thermal.graph.conductance;
  if (draft.chance(0.4)) add_convection(draft, thermal.graph);
  FieldScene electric = bare_electric(draft, thermal.graph, electric_law, steady);
  const double radius = radius_bound(thermal.graph, 0);
  draft.scene.t_lambda = draw_t_lambda(draft, false);
  draft.scene.t_end = draft.scene.t_lambda / radius;
  set_electric_pace(draft, radius, electric.graph);
  const auto free_at_least = static_cast<std::size_t>(draft.wiring.nodes) - 2;
  draw_inputs(draft, std::min<std::size_t>(draft.random.below(3), free_at_least), thermal);
  draw_electric_inputs(draft, thermal.graph, electric);
  draft.scene.coupling = {
      .joule_heat = heats, .settle_tolerance = settle_tolerance, .resolve_change = resolve_change};
  draft.scene.fields.push_back(std::move(electric));
  draft.scene.fields.push_back(std::move(thermal));
}

}  // namespace

const std::vector<std::string>& scene_kinds() {
  static const std::vector<std::string> kinds = {"linear-constant", "driven-linear", "radiation-convection",
                                                 "kappa-T",         "one-way",       "two-way",
                                                 "steady-potential"};
  return kinds;
}

StatedScene state_scene(std::uint64_t seed, const SceneWishes& wishes) {
  Draft draft(seed);
  draft.wishes = wishes;
  draft.scene.seed = seed;
  draft.scene.kind = draw_kind(draft);
  const auto& kind = draft.scene.kind;
  const bool pair = kind == "one-way" || kind == "two-way" || kind == "steady-potential";
  const auto size = draw_size(draft, pair);
  draft.wiring = random_wiring(draft.random, size);
  draft.scene.shape = draft.wiring.shape;
  pair ? draw_pair(draft) : draw_single(draft);
  draw_outputs(draft);
  return std::move(draft.scene);
}

bool may_be_shifted(const StatedScene& scene) {
  return std::all_of(scene.fields.begin(), scene.fields.end(), [](const FieldScene& field) {
    return field.graph.radiation.empty() &&
           std::none_of(field.laws.of_material.begin(), field.laws.of_material.end(),
                        [](const auto& law) { return law.varies(); });
  });
}

StatedScene shifted(StatedScene scene, double by) {
  for (auto& field : scene.fields) {
    if (scene.fields.size() > 1 && field.name != "temperature") continue;
    Graph& graph = field.graph;
    std::vector<char> is_value(graph.tables.size(), 1);  // and not a source
    for (const auto& source : graph.tabled_sources) is_value[static_cast<std::size_t>(source.table)] = 0;
    for (auto& value : graph.initial) value += by;
    for (auto& value : graph.fixed_value) value += by;
    for (auto& exchange : graph.convection) exchange.ambient += by;
    for (std::size_t k = 0; k < graph.tables.size(); ++k)
      if (is_value[k])
        for (auto& value : graph.tables[k].value) value += by;
  }
  return scene;
}

Scene build_scene(const StatedScene& stated) {
  Scene scene;
  scene.file = scene.name = fmt::format("scene-{}", stated.seed);
  scene.t_end = stated.t_end;
  scene.output_times = stated.output_times;
  scene.fields = stated.fields;
  build_rhs(scene.file, stated.coupling, scene);
  return scene;
}

Scene random_scene(std::uint64_t seed, const SceneWishes& wishes) {
  return build_scene(state_scene(seed, wishes));
}

}  // namespace superstep::audit

#include "reports/text/health_report.hpp"

#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "core/text/quantity.hpp"
#include "results/text/json_numbers.hpp"

namespace superstep {
namespace {

/// A figure that the source of a case may publish, with ours.
struct Figure {
  const char* key;
  const char* label;
  const char* unit;
  std::optional<double> ours;
};

std::vector<Figure> published_figures(const NetworkHealth& health) {
  const auto& field = health.fields.front();
  std::vector<Figure> figures;
  const auto particles =
      health.packing ? std::optional<double>(static_cast<double>(health.packing->particles)) : std::nullopt;
  figures.push_back({"particles", "particles", "", particles});
  figures.push_back({"relative_density", "relative density", "",
                     health.packing ? health.packing->relative_density : std::nullopt});
  figures.push_back({"effective_conductivity", "effective conductivity",
                     field.name == "temperature" ? "W/(m K)" : "S/m", field.effective_conductivity});
  if (field.steady) return figures;
  figures.push_back({"lambda_max", "lambda_max", "1/s", field.lambda_max});
  figures.push_back({"lambda_min", "lambda_min", "1/s", field.lambda_min});
  figures.push_back({"pair_step", "min pair step without interface", "s", field.pair_step_bare});
  figures.push_back({"critical_step", "true critical step 2/lambda_max", "s", field.critical_step()});
  figures.push_back(
      {"alpha_star", "alpha* = true / pair step", "", field.critical_step() / field.pair_step_bare});
  return figures;
}

class Text {
 public:
  void heading(std::string_view title) { out_ += fmt::format("{}{}\n", out_.empty() ? "" : "\n", title); }
  template <class... Values>
  void row(std::string_view label, fmt::format_string<Values...> format, Values&&... values) {
    out_ += fmt::format("  {:<34} {}\n", label, fmt::format(format, std::forward<Values>(values)...));
  }
  void line(std::string_view text) { out_ += fmt::format("  {}\n", text); }
  [[nodiscard]] std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

void write_packing(Text& text, const Scene& scene, const PackingHealth& packing) {
  text.heading("Packing");
  text.row("particles", "{}", packing.particles);
  if (const auto& frame = scene.packed->packing.frame; !frame.empty()) text.row("of its file", "{}", frame);
  text.row("contacts", "{}", packing.contacts);
  text.row("diameters", "{:.4g} to {:.4g} m", packing.diameter_min, packing.diameter_max);
  if (packing.relative_density) text.row("relative density", "{:.4f}", *packing.relative_density);
  text.row("overlap / smaller radius", "median {:.3f}, 95 % below {:.3f}, largest {:.3f}",
           packing.overlap_median, packing.overlap_95, packing.overlap_max);
  text.row("neck law", "{} ({} saturated, {} limited to the smaller radius)", scene.packed->neck,
           packing.saturated, packing.limited);
}

void write_network(Text& text, const FieldHealth& field) {
  text.heading(fmt::format("Network ({})", field.name));
  text.row("nodes", "{} ({} free, {} fixed, {} idle{})", field.nodes, field.free, field.fixed, field.idle,
           field.eliminated > 0 ? fmt::format(", {} eliminated", field.eliminated) : "");
  if (!field.temperatures.empty())
    text.row("conductivities", "those of the temperatures at the start, {}", field.temperatures);
  text.row("edges", "{}, conductance {:.3g} to {:.3g} {}", field.edges, field.conductance_min,
           field.conductance_max, field.name == "temperature" ? "W/K" : "S");
  text.row("coordination", "mean {:.2f}, {} to {}", field.coordination_mean, field.coordination_min,
           field.coordination_max);
  text.row("components", "{} ({} floating, {} idle, {})", field.components, field.floating,
           field.idle_clusters, quantity(field.isolated, "isolated node"));
  if (field.lumping_median)
    text.row("lumping ratio K/(pi kappa R_min)", "median {:.3f}{}", *field.lumping_median,
             *field.lumping_median > 0.1 ? " (not small: one temperature per particle is coarse)" : "");
  if (field.effective_conductivity)
    text.row("effective conductivity", "{:.4g} {}{}", *field.effective_conductivity,
             field.name == "temperature" ? "W/(m K)" : "S/m",
             field.effective_note.empty() ? "" : " (" + field.effective_note + ")");
  else
    text.row("effective conductivity", "none: {}", field.effective_note);
  if (!field.effective_basis.empty()) text.row("", "{}", field.effective_basis);
  if (field.effective_periodic)
    text.row("under a mean gradient", "{:.4g} {} over the periodic cell", *field.effective_periodic,
             field.name == "temperature" ? "W/(m K)" : "S/m");
  if (!field.electrodes) return;
  const auto& electrodes = *field.electrodes;
  text.row("electrodes", "{:.4g} V, {:.6g} A in, {:.6g} A out", electrodes.voltage, electrodes.current_in,
           electrodes.current_out);
  if (electrodes.resistance) {
    text.row("resistance", "{:.6g} Ohm", *electrodes.resistance);
    text.row("Joule heat of the steady current", "{:.6g} W (V I = {:.6g} W)", electrodes.joule_heat,
             electrodes.voltage * electrodes.current_in);
  } else {
    text.row("resistance", "none: sources feed a current in between the electrodes");
    text.row("Joule heat of the steady current", "{:.6g} W", electrodes.joule_heat);
  }
}

void write_spectrum(Text& text, const FieldHealth& field) {
  text.heading(fmt::format("Stiffness and critical steps ({})", field.name));
  if (!(field.lambda_max > 0))
    return text.row("lambda_max", "0 1/s: nothing conducts, and nothing limits a step");
  text.row("lambda_max (Lanczos)", "{:.5g} 1/s, residual {:.1e}", field.lambda_max,
           field.lambda_max_residual);
  if (field.lambda_min) {
    text.row("lambda_min", "{:.5g} 1/s{}", *field.lambda_min,
             field.lambda_min_note.empty() ? "" : " (" + field.lambda_min_note + ")");
    if (*field.lambda_min > 0)
      text.row("lambda_min / lambda_max", "{:.3e}; STS asks for 0 < nu below it (eq. 25)",
               *field.lambda_min / field.lambda_max);
    else
      text.row("lambda_min / lambda_max",
               "0, where eq. 25 of STS has no room for nu; any nu keeps what floats");
  } else {
    text.row("lambda_min", "{}", field.lambda_min_note);
  }
  const double truth = field.critical_step();
  const auto step = [&](std::string_view label, double value, std::string_view note) {
    text.row(label, "{:.5g} s = {:.3f} of the true limit{}", value, value / truth, note);
  };
  if (field.jacobian_bound) {
    text.row("critical step 2/lambda_max", "{:.5g} s, of the conductances at the start ({})", truth,
             field.temperatures.empty() ? "those of this field are constant" : field.temperatures);
    step("certified at the start", field.certified_step(), ", of the Jacobian with the slopes of the laws");
    step("edge bound", 2 / field.edge_bound, ", of the conductances at the start");
    step("Gershgorin", 2 / field.gershgorin, ", of the conductances at the start");
  } else {
    text.row("true critical step 2/lambda_max", "{:.5g} s", truth);
    step("certified: edge bound", 2 / field.edge_bound, "");
    step("certified: Gershgorin", 2 / field.gershgorin, "");
  }
  step("pairwise without interface", field.pair_step_bare, ", not a bound (alpha refers to it)");
  step("pairwise with interface", field.pair_step_full, ", not a bound");
  const double alpha = truth / field.pair_step_bare;
  text.row("alpha* = true / pairwise", "{:.3f}{}", alpha,
           alpha < 0.3 ? "  WARNING: the published alpha = 0.3 is unstable here" : "");
}

void write_published(Text& text, const Scene& scene, const NetworkHealth& health) {
  if (scene.published.empty()) return;
  text.heading("Beside the source");
  text.line(fmt::format("{:<34} {:>12} {:>12} {:>9}", "", "published", "ours", "ours/publ."));
  for (const auto& figure : published_figures(health)) {
    const auto published = scene.published.find(figure.key);
    if (published == scene.published.end()) continue;
    const std::string label =
        figure.unit[0] ? fmt::format("{} [{}]", figure.label, figure.unit) : figure.label;
    const std::string ours = figure.ours ? fmt::format("{:.5g}", *figure.ours) : "-";
    const std::string ratio = figure.ours ? fmt::format("{:.3f}", *figure.ours / published->second) : "-";
    text.line(fmt::format("{:<34} {:>12.5g} {:>12} {:>9}", label, published->second, ours, ratio));
  }
}

nlohmann::json electrodes_json(const ElectrodeFacts& facts) {
  return {{"voltage_v", facts.voltage},
          {"current_in_a", facts.current_in},
          {"current_out_a", facts.current_out},
          {"resistance_ohm", optional_number(facts.resistance)},
          {"joule_heat_w", facts.joule_heat}};
}

nlohmann::json stiffness_json(const FieldHealth& field) {
  return {{"lambda_max", field.lambda_max},
          {"lambda_max_residual", field.lambda_max_residual},
          {"lambda_min", optional_number(field.lambda_min)},
          {"critical_step", finite_or_null(field.critical_step())},
          {"edge_bound", field.edge_bound},
          {"gershgorin_bound", field.gershgorin},
          {"jacobian_bound", optional_number(field.jacobian_bound)},
          {"certified_step", finite_or_null(field.certified_step())},
          {"pair_step_without_interface", finite_or_null(field.pair_step_bare)},
          {"pair_step_with_interface", finite_or_null(field.pair_step_full)}};
}

nlohmann::json field_json(const FieldHealth& field) {
  nlohmann::json json = {
      {"field", field.name},
      {"unit", field.unit},
      {"conductivities_at",
       field.temperatures.empty() ? nlohmann::json(nullptr) : nlohmann::json(field.temperatures)},
      {"nodes", field.nodes},
      {"edges", field.edges},
      {"free", field.free},
      {"fixed", field.fixed},
      {"idle", field.idle},
      {"eliminated", field.eliminated},
      {"components", field.components},
      {"floating_clusters", field.floating},
      {"idle_clusters", field.idle_clusters},
      {"isolated", field.isolated},
      {"coordination",
       {{"mean", field.coordination_mean}, {"min", field.coordination_min}, {"max", field.coordination_max}}},
      {"conductance", {{"min", field.conductance_min}, {"max", field.conductance_max}}},
      {"lumping_median", optional_number(field.lumping_median)},
      {"effective_conductivity", optional_number(field.effective_conductivity)},
      {"effective_conductivity_periodic", optional_number(field.effective_periodic)},
      {"effective_length_m", positive_or_null(field.effective_length)},
      {"effective_cross_section_m2", positive_or_null(field.effective_area)},
      {"electrodes", field.electrodes ? electrodes_json(*field.electrodes) : nlohmann::json(nullptr)}};
  if (!field.steady) json.update(stiffness_json(field));
  return json;
}

}  // namespace

std::string health_text(const Scene& scene, const NetworkHealth& health) {
  Text text;
  text.heading(scene.title);
  if (!scene.source.empty()) text.line("source: " + scene.source);
  text.line(fmt::format("t_end = {:g} s, {}, {}", scene.t_end,
                        quantity(scene.output_times.size(), "output time"),
                        quantity(scene.probes.size(), "probe")));
  if (health.packing) write_packing(text, scene, *health.packing);
  for (const auto& field : health.fields) {
    write_network(text, field);
    if (!field.steady) write_spectrum(text, field);
  }
  write_published(text, scene, health);
  if (!scene.skips.empty()) text.heading("Skipped");
  for (const auto& skip : scene.skips)
    text.line(fmt::format("skipped: {} because {}", skip.what, skip.because));
  if (!scene.warnings.empty()) text.heading("Warnings");
  for (const auto& warning : scene.warnings) text.line(warning);
  return text.take();
}

std::string health_json(const Scene& scene, const NetworkHealth& health) {
  nlohmann::json json = {{"schema", "superstep.health"},
                         {"schema_version", 1},
                         {"case", scene.name},
                         {"title", scene.title},
                         {"t_end", scene.t_end}};
  if (health.packing) {
    const auto& packing = *health.packing;
    json["packing"] = {
        {"particles", packing.particles},
        {"contacts", packing.contacts},
        {"diameter_min", packing.diameter_min},
        {"diameter_max", packing.diameter_max},
        {"relative_density", optional_number(packing.relative_density)},
        {"overlap",
         {{"median", packing.overlap_median}, {"p95", packing.overlap_95}, {"max", packing.overlap_max}}},
        {"necks_saturated", packing.saturated},
        {"necks_limited", packing.limited}};
  }
  for (const auto& field : health.fields) json["fields"].push_back(field_json(field));
  for (const auto& figure : published_figures(health)) {
    const auto published = scene.published.find(figure.key);
    if (published != scene.published.end())
      json["published"][figure.key] = {{"published", published->second},
                                       {"ours", optional_number(figure.ours)}};
  }
  json["skipped"] = nlohmann::json::array();
  for (const auto& skip : scene.skips)
    json["skipped"].push_back({{"what", skip.what}, {"because", skip.because}});
  json["warnings"] = scene.warnings;
  return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace superstep

/// superstep pack: generate a packing.

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bench/app/cli/cli_values.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "bench/app/commands.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/host/progress.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "packing/pack_checks.hpp"
#include "packing/read.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

std::string report_text(std::size_t particles, const PackReport& report) {
  return fmt::format(
      "particles        {}\n"
      "relative density {:.6g}\n"
      "largest overlap  {:.3g} of the smaller radius\n"
      "relaxation steps {}\n",
      particles, report.relative_density, report.largest_overlap, report.relaxation_steps);
}

std::string report_json(std::size_t particles, const PackReport& report) {
  const nlohmann::ordered_json out = {{"schema", "superstep.pack"},
                                      {"schema_version", 1},
                                      {"particles", particles},
                                      {"relative_density", report.relative_density},
                                      {"largest_overlap", report.largest_overlap},
                                      {"relaxation_steps", report.relaxation_steps}};
  return json_text(out);
}

Container container_of(const Arguments& values, double unit) {
  const std::string shape = values.container.empty() ? "cylinder" : values.container;
  const auto length = [&](const char* option, const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("pack: {} is missing for a {}", option, shape));
    return unit * parse_positive_option(option, text);
  };
  Container container;
  container.height = length("--height", values.height);
  if (shape == "cylinder") {
    if (!values.width.empty() || !values.depth.empty())
      throw UsageError("pack: --width and --depth belong to a box; a cylinder has --diameter");
    container.diameter = length("--diameter", values.diameter);
  } else if (shape == "box") {
    if (!values.diameter.empty())
      throw UsageError("pack: --diameter belongs to a cylinder; a box has --width, --depth");
    container.shape = Container::Shape::box;
    container.width = length("--width", values.width);
    container.depth = length("--depth", values.depth);
  } else {
    const std::vector<std::string> shapes = {"cylinder", "box"};
    throw UsageError(
        fmt::format("--container {} is not valid{}", superstep::in_quotes(shape), suggestion(shape, shapes)));
  }
  return container;
}

/// The largest cube of at most so many spheres.
Lattice lattice_of(const Arguments& values, double unit) {
  const GivenOption foreign[] = {{!values.container.empty(), "--container"},
                                 {!values.sizes.empty(), "--sizes"},
                                 {!values.count.empty(), "--count"},
                                 {!values.width.empty(), "--width"},
                                 {!values.depth.empty(), "--depth"},
                                 {!values.height.empty(), "--height"},
                                 {!values.relative_density.empty(), "--relative-density"},
                                 {!values.seed.empty(), "--seed"}};
  refuse_given("pack", foreign,
               "belongs to a container that is filled; a lattice has --spacing and --diameter");
  const double count = parse_positive_option("--lattice", values.lattice);
  if (!(count >= 1) || count > static_cast<double>(largest_packing))
    throw UsageError(fmt::format("--lattice {} is not valid: it must lie between 1 and {}",
                                 superstep::in_quotes(values.lattice), largest_packing));
  const auto most = static_cast<std::int64_t>(count);
  std::int64_t side = 1;
  while ((side + 1) * (side + 1) * (side + 1) <= most) ++side;
  for (const auto& [option, text] : {std::pair("--spacing", values.spacing), {"--diameter", values.diameter}})
    if (text.empty()) throw UsageError(fmt::format("pack: {} is missing for a lattice", option));
  const Lattice lattice{.cells = {side, side, side},
                        .spacing = unit * parse_positive_option("--spacing", values.spacing),
                        .diameter = unit * parse_positive_option("--diameter", values.diameter)};
  if (const auto rule = broken_rule(lattice); !rule.empty())
    throw UsageError(
        fmt::format("--diameter {} is not valid; {}", superstep::in_quotes(values.diameter), rule));
  return lattice;
}

Command pack_from_line(const Arguments& values) {
  PackCommand command{
      .common = common_options(values), .settings = {}, .lattice = std::nullopt, .file = values.file};
  if (command.file.empty()) throw UsageError("pack: -o FILE is missing; see superstep pack --help");
  if (!values.lattice.empty()) {
    command.lattice = lattice_of(values, parse_length_unit(values.length_unit));
    return command;
  }
  if (!values.spacing.empty()) throw UsageError("pack: --spacing belongs to --lattice");
  if (values.sizes.empty()) throw UsageError("pack: --sizes is missing; see superstep pack --help");
  const double unit = parse_length_unit(values.length_unit);
  PackSettings& settings = command.settings;
  settings.container = container_of(values, unit);
  settings.sizes = parse_sizes(values.sizes, unit);
  if (!values.relative_density.empty())
    settings.relative_density = parse_positive_option("--relative-density", values.relative_density);
  if (!values.count.empty())
    settings.count = static_cast<std::size_t>(parse_integer_option("--count", values.count, 1, unlimited));
  if (!values.seed.empty())
    settings.seed = static_cast<std::uint64_t>(parse_integer_option("--seed", values.seed, 0, unlimited));
  return command;
}

/// Written layer by layer: only one of them is there at a time.
void write_lattice(const std::string& file, const Lattice& lattice, Progress& progress) {
  write_file_atomically(file, [&](const PieceWriter& write) {
    for (std::int64_t layer = 0; layer < lattice.cells[2]; ++layer) {
      if (stop_flag()) throw NumericalError("it was interrupted");
      const Packing packing = lattice_layers(lattice, layer, layer + 1);
      if (layer == 0) write(packing_csv_head(packing));
      write(packing_csv_rows(packing));
      progress.reached(static_cast<double>(layer + 1) / static_cast<double>(lattice.cells[2]));
    }
  });
}

/// What the generator of containers says of a packing, of a lattice.
PackReport report_of(const Lattice& lattice) {
  const double radius = 0.5 * lattice.diameter, cell = lattice.spacing * lattice.spacing * lattice.spacing;
  PackReport report;
  report.relative_density = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius / cell;
  if (lattice.size() > 1) report.largest_overlap = std::max(0.0, lattice.diameter - lattice.spacing) / radius;
  return report;
}

int say(const PackCommand& command, std::size_t particles, const PackReport& report) {
  print_data(command.common.json ? report_json(particles, report) : report_text(particles, report));
  if (report.relative_density > 1 && !command.common.quiet)
    warn({fmt::format(
        "the relative density is {:.3g}: the spheres overlap so much that their volumes exceed the "
        "space that they fill",
        report.relative_density)});
  if (!command.common.quiet) note(fmt::format("packing in {}", command.file));
  return 0;
}

int pack_lattice(const PackCommand& command, Progress& progress) {
  write_lattice(command.file, *command.lattice, progress);
  progress.end();
  return say(command, static_cast<std::size_t>(command.lattice->size()), report_of(*command.lattice));
}

int pack_container(const PackCommand& command, Progress& progress) {
  PackReport report;
  const Packing packing = generate_packing(command.settings, &report, [&](double fraction) {
    progress.reached(fraction);
    return !stop_flag();
  });
  progress.end();
  write_file_atomically(command.file, packing_csv(packing));
  return say(command, packing.size(), report);
}

}  // namespace

int execute(const PackCommand& command) {
  catch_interrupts();
  Progress progress(!command.common.quiet && stderr_is_terminal());
  progress.begin("packing", 1.0);
  try {
    return command.lattice ? pack_lattice(command, progress) : pack_container(command, progress);
  } catch (const NumericalError&) {
    progress.end();
    if (stop_flag()) return interrupted_exit_code();
    throw;
  }
}

CommandEntry pack_command() {
  return {
      .name = "pack",
      .does = "generate a packing of spheres",
      .examples =
          "  superstep pack --container cylinder --diameter 123.6 --height 166 --length-unit um "
          "--relative-density 0.784 \\\n"
          "      --count 17515 --sizes lognormal:median=4,sigma=0.5,min=1.5,max=20 --seed 1 -o packing.csv\n"
          "  superstep pack --container box --width 1 --depth 1 --height 1 --length-unit mm "
          "--relative-density "
          "0.6 \\\n"
          "      --sizes uniform:min=0.08,max=0.12 -o packing.csv\n"
          "  superstep pack --lattice 1e6 --spacing 1 --diameter 1.02 --length-unit mm -o lattice.csv",
      .positional = "",
      .positional_meaning = "",
      .options =
          {{"--container", &Arguments::container, "cylinder or box (default cylinder)", "SHAPE"},
           {"--lattice", &Arguments::lattice,
            "instead: the largest cube of at most N spheres on a cubic lattice", "N"},
           {"--spacing", &Arguments::spacing, "of the lattice", "L"},
           {"--diameter", &Arguments::diameter, "of the cylinder, or of the lattice's spheres", "L"},
           {"--width", &Arguments::width, "of the box, x", "L"},
           {"--depth", &Arguments::depth, "of the box, y", "L"},
           {"--height", &Arguments::height, "of the container, z", "L"},
           {"--count", &Arguments::count,
            "number of spheres, for lognormal sizes, whose median it fits; default: as many as density "
            "and sizes ask for",
            "N"},
           {"--relative-density", &Arguments::relative_density,
            "sphere volume over container volume (default 0.64)", "X"},
           {"--sizes", &Arguments::sizes,
            "diameters: lognormal:median=,sigma=,min=,max= | uniform:min=,max= | list:d1,d2,...; equal "
            "and listed ones are scaled a little, until the density is met",
            "SIZES"},
           {"--seed", &Arguments::seed, "same seed, same packing (default 1)", "N"},
           {"--length-unit", &Arguments::length_unit,
            "of the lengths given here: m, cm, mm, um, nm (default m)", "UNIT"},
           {"-o,--output", &Arguments::file, "packing file to write (CSV in metres, which it states)",
            "FILE"}},
      .make = pack_from_line};
}

}  // namespace superstep

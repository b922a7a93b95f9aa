/// superstep pack: generate a packing.

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/app/commands.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/host/progress.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

std::string report_text(const Packing& packing, const PackReport& report) {
  return fmt::format(
      "particles        {}\n"
      "relative density {:.6g}\n"
      "largest overlap  {:.3g} of the smaller radius\n"
      "relaxation steps {}\n",
      packing.size(), report.relative_density, report.largest_overlap, report.relaxation_steps);
}

std::string report_json(const Packing& packing, const PackReport& report) {
  const nlohmann::ordered_json out = {{"schema", "superstep.pack"},
                                      {"schema_version", 1},
                                      {"particles", packing.size()},
                                      {"relative_density", report.relative_density},
                                      {"largest_overlap", report.largest_overlap},
                                      {"relaxation_steps", report.relaxation_steps}};
  return out.dump(2) + "\n";
}

}  // namespace

int execute(const PackCommand& command) {
  const bool quiet = command.common.quiet;
  catch_interrupts();
  Progress progress(!quiet && stderr_is_terminal());
  progress.begin("packing", 1.0);
  PackReport report;
  const auto watch = [&](double fraction) {
    progress.reached(fraction);
    return !stop_flag();
  };
  Packing packing;
  try {
    packing = generate_packing(command.settings, &report, watch);
  } catch (const NumericalError&) {
    progress.end();
    if (stop_flag()) return interrupted_exit_code;
    throw;
  }
  progress.end();
  write_file_atomically(command.file, packing_csv(packing));
  print_data(command.common.json ? report_json(packing, report) : report_text(packing, report));
  if (!quiet) note(fmt::format("packing in {}", command.file));
  return 0;
}

}  // namespace superstep

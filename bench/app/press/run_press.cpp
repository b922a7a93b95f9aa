/// superstep run: a press with moving particles.

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>

#include "bench/app/cli/command_entry.hpp"
#include "bench/app/press/export_packing.hpp"
#include "bench/app/press/press_commands.hpp"
#include "bench/app/press/sintering_files.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/host/progress.hpp"
#include "bench/host/watchdog.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/output/run_files.hpp"
#include "bench/output/snapshot_files.hpp"
#include "bench/output/vtk_frames.hpp"
#include "bench/press/sintering_figure.hpp"
#include "bench/press/sintering_vtk.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "integrators/method_spec.hpp"
#include "integrators/press/checkpoint.hpp"
#include "integrators/press/model_description.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

using dynamics::Motion;

/// The case with what the command line changes about it. "staggered" = the phi rule inside the iteration.
Press with_integrator(Press one, const RunCommand& command, const std::string& spec) {
  auto& stepping = one.stepping;
  if (spec == "staggered")
    stepping.thermal_integrator.clear();
  else if (!spec.empty())
    stepping.thermal_integrator = spec;
  if (!command.tolerance) return one;
  if (stepping.thermal_integrator.empty())
    stepping.tolerance_position = stepping.tolerance_temperature = *command.tolerance;
  else
    stepping.thermal_integrator =
        MethodSpec(stepping.thermal_integrator).with_tolerance(*command.tolerance).text();
  return one;
}

/// Starts the motion, or goes on from a checkpoint of the same particles.
void begin(const Press& one, const RunCommand& command, Motion& motion) {
  if (command.restart.empty()) return motion.start(one.state);
  dynamics::Checkpoint stored = dynamics::read_checkpoint(command.restart);
  if (stored.particles != one.particles || stored.state.size() != one.particles.size())
    throw InputError(fmt::format("{}: holds other particles than {}; restart with the case that wrote it",
                                 command.restart, one.file));
  dynamics::require_same_model(stored, one.model, command.restart, one.file);
  if (!(stored.state.time < one.t_end))
    throw InputError(
        fmt::format("{}: it is at {} s, and {} ends at t_end = {} s: nothing is left to run; raise "
                    "t_end to go further",
                    command.restart, stored.state.time, one.file, one.t_end));
  motion.resume(std::move(stored.state), stored.next_step, std::move(stored.history));
}

/// Writes DIR/checkpoint.bin whenever the given simulated time has passed.
class Checkpoints {
 public:
  Checkpoints(std::string file, std::optional<double> interval)
      : file_(std::move(file)), interval_(interval) {}

  void step_done(const Press& one, const Motion& motion) {
    if (!interval_) return;
    const double due = std::floor(motion.state().time / *interval_);
    if (due > written_) write(one, motion);
    written_ = std::max(written_, due);
  }
  void started_at(double t) {
    if (interval_) written_ = std::floor(t / *interval_);
  }
  void write(const Press& one, const Motion& motion) const {
    write_file_atomically(file_, dynamics::checkpoint_image(
                                     {one.particles, motion.state(), motion.next_step(), motion.history(),
                                      dynamics::model_description(one.model, motion.state().time)}));
  }
  [[nodiscard]] bool wanted() const noexcept { return interval_.has_value(); }

 private:
  std::string file_;
  std::optional<double> interval_;
  double written_ = 0;
};

/// Files of particles at the output times.
class Snapshots {
 public:
  /// A restart goes on with the series that it finds, from the time `begin` [s]; any other run begins them
  /// anew.
  Snapshots(const Press& one, const RunCommand& command, const std::string& folder, double begin)
      : one_(one), folder_(folder) {
    const bool anew = command.restart.empty();
    begin_run_files(folder);
    remove_stale_file(folder + "/probes.csv");  // of a network that does not move
    const auto past = std::upper_bound(one.output_times.begin(), one.output_times.end(), begin);
    remove_snapshots(folder, anew ? 0 : static_cast<std::size_t>(past - one.output_times.begin()));
    if (!anew) earlier_ = static_cast<std::size_t>(past - one.output_times.begin());
    owed_ = earlier_ > 0 && *(past - 1) == begin && !is_there(earlier_ - 1);
    if (command.vtk && anew) {
      vtk_.emplace(folder);
    } else if (command.vtk) {  // frames of the instant itself stay, too, but for one whose snapshot is owed
      vtk_.emplace(folder, owed_ ? begin : std::nextafter(begin, std::numeric_limits<double>::infinity()));
      goes_on_ = has_vtk_series(folder) && !owed_;
    } else if (anew) {
      remove_vtk_series(folder);
    } else if (!command.common.quiet && has_vtk_series(folder)) {
      note(fmt::format("{}/vtk holds the fields of an earlier run; give --vtk to go on with them", folder));
    }
  }
  /// What a run begins with: the snapshots that are kept, the first frame where there is none, and what an
  /// end between a checkpoint and the files of the same instant has left out.
  void begin(const Motion& motion, SinteringResult& result) {
    for (std::size_t k = 0; k < earlier_; ++k)
      if (is_there(k)) list(k, one_.output_times[k], result);
    if (!goes_on_) add_frame(motion);
    if (owed_) write(earlier_ - 1, motion, result);
  }
  /// For ParaView, where the motion is now.
  void add_frame(const Motion& motion) {
    if (vtk_)
      vtk_->add(sintering_particles(one_, motion.state()),
                sintering_contacts(one_, motion.network(), motion.state()));
  }
  void write(std::size_t number, const Motion& motion, SinteringResult& result) const {
    write_file_atomically(folder_ + "/" + snapshot_name(number), particles_csv(one_, motion.state()));
    list(number, motion.state().time, result);
  }
  /// The last state reached, in final.csv, belongs to the series unless it is there already.
  void finish(const Motion& motion, SinteringResult& result) const {
    const double t = motion.state().time;
    if (result.snapshots.empty() || result.snapshots.back().time != t)
      result.snapshots.push_back({"final.csv", t, one_.model.schedule.at(t).wall_height(t)});
    if (!vtk_) return;
    for (auto& name : vtk_->finish()) result.files.push_back(std::move(name));
  }

 private:
  [[nodiscard]] bool is_there(std::size_t number) const {
    std::error_code ignored;
    return std::filesystem::is_regular_file(folder_ + "/" + snapshot_name(number), ignored);
  }
  void list(std::size_t number, double t, SinteringResult& result) const {
    result.files.push_back(snapshot_name(number));
    result.snapshots.push_back({snapshot_name(number), t, one_.model.schedule.at(t).wall_height(t)});
  }

  const Press& one_;
  std::string folder_;
  std::optional<VtkFrames> vtk_;
  std::size_t earlier_ = 0;  // snapshots of before a restart
  bool goes_on_ = false;     // with frames of before it
  bool owed_ = false;        // the last of them, which is of the instant of the restart
};

/// Phases whose electrified walls found nobody to carry their current.
void warn_without_path(const Motion& motion, const dynamics::Model& model,
                       std::vector<std::string>& warnings) {
  const auto& phase = model.schedule.phases()[static_cast<std::size_t>(motion.history().back().phase)];
  if (model.electric.model == dynamics::CurrentModel::none || !(phase.lower || phase.upper)) return;
  if (motion.state().time < phase.end || motion.connected_in_step() > 0) return;
  warnings.push_back(fmt::format(
      "at the end of phase '{}' (t = {:.4g} s) no particle has a path to an electrified wall: none "
      "carries current",
      phase.name, phase.end));
}

SinteringResult integrate(const Press& one, const RunCommand& command, const std::string& folder,
                          Motion& motion, Progress& progress) {
  SinteringResult result;
  result.warnings = one.warnings;
  Checkpoints checkpoints(folder + "/checkpoint.bin", command.checkpoint);
  std::atomic<double> reached{0};  // outlives the thread that looks at it
  Watchdog dog(command.limits.seconds, &stop_flag());
  motion.stop = dog.flag();
  const double cpu = process_cpu_seconds(), wall = wall_seconds();
  begin(one, command, motion);
  Snapshots snapshots(one, command, folder,
                      motion.state().time);  // after a bad checkpoint nothing is touched
  checkpoints.started_at(motion.state().time);
  snapshots.begin(motion, result);
  if (command.limits.say)
    dog.look_after(Watchdog::first_look, [&, from = motion.state().time](double seconds) {
      const double part = std::max(0.0, reached.load() - from) / (one.t_end - from);
      const std::string text = forecast_text(one.name, part, seconds, command.limits.seconds, "");
      if (!text.empty()) command.limits.say(text);
    });
  motion.after_step = [&] {
    progress.reached(motion.state().time);
    reached = motion.state().time;
    warn_without_path(motion, one.model, result.warnings);
    checkpoints.step_done(one, motion);
  };
  for (std::size_t k = 0; k < one.output_times.size() && result.outcome.ok(); ++k) {
    if (one.output_times[k] <= motion.state().time) continue;
    result.outcome = motion.advance(one.output_times[k]);
    if (!result.outcome.ok()) continue;
    snapshots.add_frame(motion);
    if (one.output_times.size() > 1) snapshots.write(k, motion, result);
  }
  motion.stop = &stop_flag();
  if (result.outcome.status == Status::interrupted && dog.time_is_up())
    result.outcome = {Status::timeout,
                      fmt::format("not done after {:g} s of wall time: {}; go on with --restart",
                                  command.limits.seconds, result.outcome.reason)};
  result.cpu_stepping = process_cpu_seconds() - cpu;
  result.wall_stepping = wall_seconds() - wall;
  snapshots.finish(motion, result);
  const Status ended = result.outcome.status;
  if (checkpoints.wanted() || ended == Status::interrupted || ended == Status::timeout) {
    checkpoints.write(one, motion);
    result.files.emplace_back("checkpoint.bin");
  }
  return result;
}

int exit_code_of(const Outcome& outcome) {
  return static_cast<int>(outcome.ok() ? ExitCode::ok : ExitCode::numerical);
}

/// One run into one folder.
int run_into(const Press& one, const RunCommand& command, double cpu_setup, const std::string& folder) {
  const OutputFolder locked(folder);
  const bool quiet = command.common.quiet;
  Progress progress(!quiet && stderr_is_terminal());
  Motion motion(one.model, one.particles, one.stepping);
  progress.begin(one.name, one.t_end);
  SinteringResult result = integrate(one, command, folder, motion, progress);
  progress.end();
  result.cpu_setup = cpu_setup;
  // Whatever happened, what was reached is kept: the state and history of the last accepted step.
  write_file_atomically(folder + "/history.csv", history_csv(one, motion.history()));
  write_file_atomically(folder + "/history.svg", history_svg(one, motion.history()));
  write_file_atomically(folder + "/final.csv", particles_csv(one, motion.state()));
  for (const char* name : {"history.csv", "history.svg", "final.csv", "run.json"})
    result.files.emplace_back(name);
  if (!command.export_packing.empty() && result.outcome.ok())
    for (const auto& name :
         export_packing(command.export_packing, one, motion.network(), motion.state(), quiet))
      if (!quiet) note("packing in " + name);
  const std::string json = sintering_json(one, motion, result, command.common.threads);
  write_file_atomically(folder + "/run.json", json);
  if (!quiet) warn(result.warnings);
  if (command.common.json)
    print_data(json);
  else if (!quiet || !result.outcome.ok())
    print_data(sintering_summary(one, motion, result, folder));
  return exit_code_of(result.outcome);
}

}  // namespace

void check_specs_of_press(const std::vector<std::string>& specs) {
  require_distinct_specs(specs);
  for (const auto& spec : specs)
    if (spec != "staggered") (void)MethodSpec(spec);
}

int run_press(const RunCommand& command, const Press& press, double cpu_setup) {
  const GivenOption still[] = {{command.limits.sweeps > 0, "--max-work"}, {command.verify, "--verify"}};
  refuse_for_moving("run", still, press.file);
  if (!command.export_packing.empty() && command.integrators.size() > 1)
    throw UsageError("run: --export-packing takes one run; give one --integrator");
  std::error_code ignored;  // what is not there yet is another file
  if (std::filesystem::equivalent(command.export_packing, press.file, ignored))
    throw UsageError(
        fmt::format("run: --export-packing {} is the case itself; name another file", press.file));
  catch_interrupts();
  const std::string out = command.out.empty() ? default_output_folder(press.name) : command.out;
  const auto specs = command.integrators.empty() ? std::vector<std::string>{""} : command.integrators;
  int code = 0;
  for (const auto& spec : specs) {
    if (stop_flag()) break;
    const std::string folder = specs.size() == 1 ? out : out + "/" + folder_name(spec);
    code = std::max(code, run_into(with_integrator(press, command, spec), command, cpu_setup, folder));
  }
  return stop_flag() ? interrupted_exit_code() : code;
}

}  // namespace superstep

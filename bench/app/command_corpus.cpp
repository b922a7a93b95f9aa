/// superstep bench --corpus: every method on every scene of a corpus, and what that says about methods.

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <utility>

#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/app/report_file.hpp"
#include "bench/harness/corpus/corpus_files.hpp"
#include "bench/host/interrupt.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "results/corpus/corpus_tables.hpp"

namespace superstep {
namespace {

/// Rows of the scenes that are done, of the one that is on, and of those that are still to come.
class CorpusFileWriter {
 public:
  explicit CorpusFileWriter(std::string file) : file_(std::move(file)) {
    std::error_code none;
    if (std::filesystem::is_regular_file(file_, none)) known_ = read_corpus_csv(file_);
  }

  /// Measured before, of this scene.
  [[nodiscard]] std::vector<CorpusRow> known(const std::string& scene) const {
    std::vector<CorpusRow> out;
    std::copy_if(known_.begin(), known_.end(), std::back_inserter(out),
                 [&](const CorpusRow& row) { return row.scene == scene; });
    return out;
  }
  void write(const std::vector<CorpusRow>& rows) const {
    auto all = done_;
    all.insert(all.end(), rows.begin(), rows.end());
    std::map<std::string, std::vector<CorpusRow>> now;  // of each scene
    for (const auto& row : all) now[row.scene].push_back(row);
    for (const auto& row : known_) {
      const auto found = now.find(row.scene);
      const bool replaced =
          found != now.end() && std::any_of(found->second.begin(), found->second.end(),
                                            [&](const CorpusRow& one) { return replaces(one, row); });
      if (!replaced) all.push_back(row);
    }
    write_file_atomically(file_, corpus_csv(all));
  }
  void done(std::vector<CorpusRow> rows) {
    write(rows);
    done_.insert(done_.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
  }
  [[nodiscard]] const std::vector<CorpusRow>& rows() const noexcept { return done_; }

 private:
  /// Of rows of one scene. Another state of the scene, of the build or of the machine leaves nothing of what
  /// was known. In the same one a method replaces itself, so that those that nobody asked for this time stay;
  /// whether there is a reference concerns all.
  static bool replaces(const CorpusRow& now, const CorpusRow& before) {
    const bool about_reference = (now.integrator == "reference") != (before.integrator == "reference");
    return now.key != before.key || now.spec == before.spec || about_reference;
  }

  std::string file_;
  std::vector<CorpusRow> known_, done_;
};

std::string name_of(const std::string& set_or_folder) {
  std::string name = std::filesystem::path(set_or_folder).lexically_normal().stem().string();
  return "corpus-" + (name.empty() || name == "." ? "own" : name);
}

std::string scene_name(const CorpusFile& file) {
  return std::filesystem::path(file.path).stem().string();
}

/// Wrong input is said before hours are spent.
void check_all(const std::vector<CorpusFile>& files) {
  for (const auto& file : files) {
    const LoadedCase one = load_bench_case(file.path);
    (void)scene_of(one.content, "--corpus");
  }
}

double time_limit_of(const CorpusCommand& command) {
  if (command.options.limits.seconds > 0) return command.options.limits.seconds;
  if (command.corpus == "quick") return 1;
  return command.corpus == "standard" ? 20 : 300;
}

void say_scene(const CorpusCommand& command, std::size_t k, std::size_t n,
               const std::vector<CorpusRow>& rows) {
  if (command.common.quiet) return;
  const auto ok = std::count_if(rows.begin(), rows.end(), [](const auto& row) { return row.ok(); });
  note(fmt::format("{} of {}: {}: {} of {} ended well", k, n, rows.front().scene, ok,
                   quantity(rows.size(), "point")));
}

void print_tables(const CorpusCommand& command, const std::vector<CorpusRow>& rows) {
  if (command.markdown) {
    print_data(corpus_headline(rows) + "\n");
    for (const auto& table : corpus_tables(rows)) print_data("\n" + markdown_text(table));
    return;
  }
  print_data(corpus_headline(rows) + "\n");
  for (const auto& table : corpus_tables(rows))
    print_data("\n" + terminal_text(table, use_color(command.common.color)));
}

}  // namespace

int execute(const CorpusCommand& command) {
  (void)corpus_specs(command.options.integrators);
  check_specs(command.options.integrators);
  const auto files = corpus_files(command.corpus);
  check_all(files);
  const std::string folder =
      command.out.empty() ? default_output_folder(name_of(command.corpus)) : command.out;
  const OutputFolder locked(folder);
  CorpusFileWriter file(folder + "/corpus.csv");
  Progress progress(!command.common.quiet && stderr_is_terminal());
  CorpusOptions options = command.options;
  options.threads = command.common.threads;
  options.stop = &stop_flag();
  options.limits.seconds = time_limit_of(command);
  options.limits.of_cpu = true;
  catch_interrupts();

  for (std::size_t k = 0; k < files.size() && !stop_flag(); ++k) {
    const std::string name = scene_name(files[k]);
    const LoadedCase one = load_bench_case(files[k].path);
    auto rows = sweep_scene(
        std::get<Scene>(one.content), files[k].tags, options, file.known(name),
        [&](const std::vector<CorpusRow>& so_far) { file.write(so_far); }, progress);
    if (rows.empty()) continue;
    say_scene(command, k + 1, files.size(), rows);
    file.done(std::move(rows));
  }
  print_tables(command, file.rows());
  if (!command.common.quiet) note("points in " + folder + "/corpus.csv");
  renew_report(folder, command.report, command.common.quiet);
  if (stop_flag()) return interrupted_exit_code();
  const bool measured =
      std::any_of(file.rows().begin(), file.rows().end(), [](const auto& row) { return row.ok(); });
  return static_cast<int>(measured ? ExitCode::ok : ExitCode::inconclusive);
}

}  // namespace superstep

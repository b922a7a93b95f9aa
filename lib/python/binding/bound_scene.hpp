#pragma once
/// A scene as Python holds it.

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "case/memory/case_data.hpp"
#include "core/text/toml.hpp"
#include "python/binding/unknowns.hpp"

namespace superstep::python {

/// What a right-hand side keeps while it is used (pieces of inputs, counters) is one user's at a time.
class BoundScene {
 public:
  /// Throws InputError, also for particles that move.
  ///   data  what the case has in memory; must live while the scene is built
  BoundScene(TomlTable root, const CaseData& data);

  [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
  [[nodiscard]] const Unknowns& unknowns() const noexcept { return unknowns_; }
  [[nodiscard]] const TomlTable& root() const noexcept { return root_; }
  /// The case file and the files that it names say it all.
  [[nodiscard]] bool is_of_files() const noexcept { return is_of_files_; }
  [[nodiscard]] double cpu_setup() const noexcept { return cpu_setup_; }  ///< s

  /// f(t, y) and values of the Jacobian on `jacobian_pattern`, among the user's unknowns. Beyond t_end inputs
  /// hold the values that they have there: solvers look a little further than they go.
  void rhs(double t, std::span<const double> y, double* rates);
  void jacobian(double t, std::span<const double> y, double* values);
  [[nodiscard]] const Unknowns::Pattern& jacobian_pattern();
  /// Values of a field on all nodes at the user's unknowns; one that is steady is solved for.
  [[nodiscard]] std::vector<double> values_on_nodes(std::size_t field, double t, std::span<const double> y);

  /// Exclusive use of the scene, perhaps with other output times, until it goes out of scope.
  class Use {
   public:
    /// Throws std::runtime_error when somebody uses the scene already.
    explicit Use(BoundScene& bound);
    ~Use();
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;
    [[nodiscard]] Scene& scene() const noexcept { return bound_.scene_; }
    /// Ascending, > 0 [s]; the last is the end.
    void set_output_times(std::vector<double> times);

   private:
    BoundScene& bound_;
    double t_end_ = 0;
    std::vector<double> output_times_;
    std::string content_hash_;
  };

 private:
  [[nodiscard]] std::vector<double> state_of(std::span<const double> y) const;
  /// When inputs are taken: those that repeat are written out up to t_end alone.
  [[nodiscard]] double time_of_inputs(double t) const noexcept { return std::min(t, scene_.t_end); }

  TomlTable root_;
  double cpu_setup_;
  Scene scene_;
  bool is_of_files_;
  Unknowns unknowns_;
  std::atomic<bool> used_{false};
  std::optional<Unknowns::Pattern> pattern_;
};

}  // namespace superstep::python

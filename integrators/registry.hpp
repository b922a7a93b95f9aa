#pragma once
/// The table of integrators: the program, the conformance tests and the reports read it, so a method that
/// stands here is known everywhere.

#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/text/options.hpp"
#include "integrators/driver.hpp"
#include "integrators/schemes/stability_model.hpp"

namespace superstep {

/// How several processes run a method, see lib/parallel.
enum class Distributed : char {
  exact,     ///< together, with the result of one process bit by bit
  gathered,  ///< one does it for all, up to a size: it forms a matrix of the whole network
};
[[nodiscard]] const char* distributed_name(Distributed distributed) noexcept;

/// One line of the registry.
struct IntegratorEntry {
  std::string name;
  std::string summary;    ///< one line
  std::string source;     ///< paper, equation, DOI
  std::string colour;     ///< "#rrggbb" in charts; empty = a spare one
  int order = 1;          ///< classical order in time; 0 = exact up to the requested tolerance
  bool adaptive = false;  ///< takes rtol and controls its own step by default
  Distributed distributed = Distributed::gathered;
  std::string gathered_where = {};  ///< of an exact one: which of its choices one process does alone
  std::vector<OptionKey> keys;
  /// Specs that the conformance suite runs besides the bare name.
  std::vector<std::string> examples;
  /// SPECs that stand for the method in a benchmark that names none; empty = one at a tolerance of 1e-3, or
  /// the name.
  std::vector<std::string> representatives = {};
  /// SPECs of the work-precision sweep, from loose to tight; a point that is known to be unstable may stand
  /// there.
  std::vector<std::string> ladder;
  /// What the stability laboratory compares the method with; empty = it has nothing to measure.
  StabilityTheory stability = {};
  std::function<std::unique_ptr<Method>(const Options&)> make;
};

/// `spec` with ",rtol=" or ":rtol=" 1e-first, ..., 1e-last appended: the usual ladder of an adaptive method.
[[nodiscard]] std::vector<std::string> rtol_ladder(const std::string& spec, int first, int last,
                                                   int stride = 1);
/// Several ladders one after the other.
[[nodiscard]] std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> ladders);

/// SPECs of a benchmark over every family.
[[nodiscard]] std::vector<std::string> representatives();

/// Every integrator, in the order of `superstep list`.
[[nodiscard]] std::span<const IntegratorEntry> integrators();

/// Entry of that name. Throws UsageError with the nearest name.
[[nodiscard]] const IntegratorEntry& find_integrator(const std::string& name);

/// Checks a SPEC completely and builds the method. Throws UsageError.
[[nodiscard]] std::unique_ptr<Method> make_method(const std::string& spec);
/// The same under the driver: what runs.
[[nodiscard]] std::unique_ptr<Integrator> make_integrator(const std::string& spec);

}  // namespace superstep

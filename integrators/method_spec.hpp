#pragma once
/// A SPEC as a value: an integrator and its settings, read and checked once.

#include <memory>
#include <string>

#include "core/text/options.hpp"
#include "integrators/registry.hpp"

namespace superstep {

class MethodSpec {
 public:
  /// Reads `name:key=value,...` and checks all of it. Throws UsageError. Texts convert by themselves:
  /// wherever a method is asked for, its SPEC can be written.
  MethodSpec(const std::string& text);  // NOLINT(google-explicit-constructor)
  MethodSpec(const char* text) : MethodSpec(std::string(text)) {}

  [[nodiscard]] const std::string& text() const noexcept { return options_.spec().text; }
  [[nodiscard]] const std::string& name() const noexcept { return entry_->name; }
  /// What stands behind the colon; may be empty.
  [[nodiscard]] std::string parameters() const { return options_.spec().parameters(); }
  /// Error that its steps keep to, relative to the span; 0 = its steps are fixed.
  [[nodiscard]] double rtol() const noexcept { return rtol_; }
  /// The method, new and unprepared.
  [[nodiscard]] std::unique_ptr<Method> make() const { return entry_->make(options_); }

  /// The same with another tolerance. Throws UsageError when the method has none, or when `rtol` is out of
  /// range.
  [[nodiscard]] MethodSpec with_tolerance(double rtol) const;
  /// Smallest tolerance that `with_tolerance` takes; 0 = the method has none.
  [[nodiscard]] double tightest_tolerance() const noexcept;

 private:
  const IntegratorEntry* entry_;
  Options options_;
  double rtol_;
};

/// A SPEC as a folder name: letters, digits and "-._=" stay, runs of anything else become one '_'.
[[nodiscard]] std::string folder_name(const std::string& spec);

}  // namespace superstep

#pragma once
/// The files of a time series for ParaView and the list that holds them together.

#include <limits>
#include <string>
#include <vector>

#include "bench/output/vtk_poly_data.hpp"

namespace superstep {

/// Writes `folder`/vtk/particles_0000.vtp, contacts_0000.vtp, ... and two .pvd files that hold them together.
/// File names come from here alone, so that no name of the user can do harm.
class VtkFrames {
 public:
  /// Removes the series of an earlier run, or goes on with it: frames before the time `from` [s] stay. Throws
  /// OutputError.
  explicit VtkFrames(const std::string& folder, double from = -std::numeric_limits<double>::infinity());
  /// One more instant, that of `particles`: both may have any number of points and lines.
  void add(const VtkPolyData& particles, const VtkPolyData& contacts);
  /// Writes the .pvd files; returns their names relative to `folder`.
  [[nodiscard]] std::vector<std::string> finish() const;

 private:
  std::string folder_;
  std::vector<VtkFrame> particles_, contacts_;
};

/// Removes the series that an earlier run left in `folder`, and nothing else.
void remove_vtk_series(const std::string& folder) noexcept;
/// True when an earlier run left one.
[[nodiscard]] bool has_vtk_series(const std::string& folder) noexcept;

}  // namespace superstep

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
  /// One more instant [s] of a scene in layers, which all processes have written: see below.
  void add_shared(double t);
  /// Writes the .pvd files; returns their names relative to `folder`.
  [[nodiscard]] std::vector<std::string> finish() const;

 private:
  std::string folder_;
  std::vector<VtkFrame> particles_, contacts_;
};

/// What one of several processes has of frame `number`: `folder`/vtk/particles_0000_p0001.vtp and the like.
/// Throws OutputError.
void write_vtk_piece(const std::string& folder, std::size_t number, int rank, const VtkPolyData& particles,
                     const VtkPolyData& contacts);
/// The files that hold the pieces of a frame together, once all are there: particles_0000.pvtp and the like.
/// Throws OutputError.
///   particles, contacts  one piece of each, for the names of its arrays
void join_vtk_pieces(const std::string& folder, std::size_t number, int processes,
                     const VtkPolyData& particles, const VtkPolyData& contacts);

/// Removes the series that an earlier run left in `folder`, and nothing else.
void remove_vtk_series(const std::string& folder) noexcept;
/// True when an earlier run left one.
[[nodiscard]] bool has_vtk_series(const std::string& folder) noexcept;

}  // namespace superstep

#pragma once
/// Particles and contacts of a run over time, for ParaView.

#include <span>
#include <string>
#include <vector>

#include "bench/output/vtk_frames.hpp"
#include "case/scene.hpp"

namespace superstep {

/// The files of VtkFrames with the fields of a scene. Array names come from here alone.
///
///   particles  points with id, radius [m] and one array per field
///   contacts   lines with overlap [m], neck_radius [m] and, per field, conductance_<field> [W/K or S] and
///              flux_<field> [W or A], positive from the first end to the second
///
/// Of a scene that nobody has as a whole it makes the lists alone, of what write_layered_frame writes during
/// the run.
class VtkSeries {
 public:
  /// The scene must outlive the series. Removes the series of an earlier run and writes the initial state.
  /// Throws InputError when the scene has no packing, and OutputError.
  VtkSeries(const Scene& scene, const std::string& folder);
  /// One more instant [s].
  void add(double t, std::span<const double> state);
  /// Where write_layered_frame has to write; empty = nowhere.
  [[nodiscard]] std::string folder_of_pieces() const;
  /// Writes the .pvd files; returns their names relative to `folder`.
  [[nodiscard]] std::vector<std::string> finish() const { return frames_.finish(); }

 private:
  [[nodiscard]] VtkPolyData particles(double t, std::span<const double> state) const;
  [[nodiscard]] VtkPolyData contacts(double t, std::span<const double> state) const;

  const Scene& scene_;
  std::string folder_;
  VtkFrames frames_;
};

/// Throws InputError when a scene has no particles that could be drawn.
void require_packing(const Scene& scene, const std::string& option);

}  // namespace superstep

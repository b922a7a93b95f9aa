#pragma once
/// Particles and contacts of a run over time, for ParaView.

#include <span>
#include <string>
#include <vector>

#include "reports/vtk_poly_data.hpp"
#include "scene/scene.hpp"

namespace superstep {

/// Writes `folder`/vtk/particles_0000.vtp, contacts_0000.vtp, ... and two .pvd files that hold them together.
/// File and array names come from here alone, so that no name of the user can do harm.
///
///   particles  points with id, radius [m] and one array per field
///   contacts   lines with overlap [m], neck_radius [m] and, per field, conductance_<field> [W/K or S] and
///              flux_<field> [W or A], positive from the first end to the second
class VtkSeries {
 public:
  /// The scene must outlive the series. Removes the series of an earlier run and writes the initial state.
  /// Throws InputError when the scene has no packing, and OutputError.
  VtkSeries(const Scene& scene, const std::string& folder);
  /// One more instant [s].
  void add(double t, std::span<const double> state);
  /// Writes the .pvd files; returns their names relative to `folder`.
  std::vector<std::string> finish() const;

 private:
  void write_particles(double t, std::span<const double> state, const std::string& file) const;
  void write_contacts(double t, std::span<const double> state, const std::string& file) const;

  const Scene& scene_;
  std::string folder_;
  std::vector<VtkFrame> particles_, contacts_;
};

/// Removes the series that an earlier run left in `folder`, and nothing else.
void remove_vtk_series(const std::string& folder) noexcept;

/// Throws InputError when a scene has no particles that could be drawn.
void require_packing(const Scene& scene, const std::string& option);

}  // namespace superstep

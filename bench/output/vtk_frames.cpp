#include "bench/output/vtk_frames.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"

namespace superstep {

namespace fs = std::filesystem;

// Only files that a series has: the folder may hold what the user put there.
void remove_vtk_series(const std::string& folder) noexcept {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder + "/vtk", ignored)) {
    const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
    const bool ours = name.starts_with("particles") || name.starts_with("contacts");
    if (ours && (extension == ".vtp" || extension == ".pvd")) remove_stale_file(entry.path().string());
  }
}

VtkFrames::VtkFrames(const std::string& folder) : folder_(folder) {
  require_writable_folder(folder_ + "/vtk");
  remove_vtk_series(folder_);
}

void VtkFrames::add(const VtkPolyData& particles, const VtkPolyData& contacts) {
  const auto write = [&](const char* kind, const VtkPolyData& data, std::vector<VtkFrame>& frames) {
    const std::string name = fmt::format("{}_{:04}.vtp", kind, frames.size());
    write_file_atomically(folder_ + "/vtk/" + name, vtp_text(data));
    frames.push_back({particles.time, name});
  };
  write("particles", particles, particles_);
  write("contacts", contacts, contacts_);
}

std::vector<std::string> VtkFrames::finish() const {
  write_file_atomically(folder_ + "/vtk/particles.pvd", pvd_text(particles_));
  write_file_atomically(folder_ + "/vtk/contacts.pvd", pvd_text(contacts_));
  return {"vtk/particles.pvd", "vtk/contacts.pvd"};
}

}  // namespace superstep

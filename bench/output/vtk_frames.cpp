#include "bench/output/vtk_frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <set>

#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/text/number.hpp"

namespace superstep {

namespace fs = std::filesystem;

namespace {

std::string frame_name(const char* kind, std::size_t number) {
  return fmt::format("{}_{:04}.vtp", kind, number);
}

std::string shared_frame_name(const char* kind, std::size_t number) {
  return fmt::format("{}_{:04}.pvtp", kind, number);
}

std::string piece_name(const char* kind, std::size_t number, int rank) {
  return fmt::format("{}_{:04}_p{:04}.vtp", kind, number, rank);
}

/// Only names that a series has: the folder may hold what the user put there.
bool is_ours(const fs::path& file) {
  const std::string name = file.filename().string(), extension = file.extension().string();
  const bool ours = name.starts_with("particles") || name.starts_with("contacts");
  return ours && (extension == ".vtp" || extension == ".pvtp" || extension == ".pvd");
}

/// The instant of a frame that `vtp_text` wrote; nothing when it is none.
std::optional<double> time_of(const std::string& file) {
  constexpr std::streamsize longest_head = 1000;
  constexpr std::string_view before = "format=\"ascii\">", after = "</DataArray>";
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return std::nullopt;
  std::string head(longest_head, '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(head.data(), longest_head);
  head.resize(static_cast<std::size_t>(stream.gcount()));
  const auto begin = head.find(before), end = head.find(after);
  if (begin == std::string::npos || end == std::string::npos || end < begin + before.size())
    return std::nullopt;
  return parse_number(std::string_view(head).substr(begin + before.size(), end - begin - before.size()));
}

/// The frames of a series in a folder before a time, as far as none is missing.
std::vector<VtkFrame> frames_before(const std::string& folder, const char* kind, double from) {
  std::vector<VtkFrame> frames;
  for (;;) {
    const std::string name = frame_name(kind, frames.size());
    const auto time = time_of(fmt::format("{}/{}", folder, name));
    if (!time || !(*time < from)) return frames;
    frames.push_back({*time, name});
  }
}

/// Files that name others first: they must not name what is gone.
void remove_series(const std::string& folder, const std::set<std::string>& kept) {
  std::vector<fs::path> ours;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_ours(entry.path()) && !kept.contains(entry.path().filename().string()))
      ours.push_back(entry.path());
  for (const char* extension : {".pvd", ".pvtp", ".vtp"})
    for (const auto& file : ours)
      if (file.extension() == extension) remove_stale_file(file.string());
}

}  // namespace

void remove_vtk_series(const std::string& folder) noexcept {
  remove_series(folder + "/vtk", {});
}

bool has_vtk_series(const std::string& folder) noexcept {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder + "/vtk", ignored))
    if (is_ours(entry.path())) return true;
  return false;
}

VtkFrames::VtkFrames(const std::string& folder, double from) : folder_(folder) {
  const std::string place = folder_ + "/vtk";
  require_writable_folder(place);
  particles_ = frames_before(place, "particles", from);
  contacts_ = frames_before(place, "contacts", from);
  const std::size_t both = std::min(particles_.size(), contacts_.size());
  std::set<std::string> kept;
  for (auto* frames : {&particles_, &contacts_}) {
    frames->resize(both);
    for (const auto& frame : *frames) kept.insert(frame.file);
  }
  remove_series(place, kept);
}

void VtkFrames::add(const VtkPolyData& particles, const VtkPolyData& contacts) {
  const auto write = [&](const char* kind, const VtkPolyData& data, std::vector<VtkFrame>& frames) {
    const std::string name = frame_name(kind, frames.size());
    write_file_atomically(folder_ + "/vtk/" + name, vtp_text(data));
    frames.push_back({particles.time, name});
  };
  write("particles", particles, particles_);
  write("contacts", contacts, contacts_);
}

void VtkFrames::add_shared(double t) {
  particles_.push_back({t, shared_frame_name("particles", particles_.size())});
  contacts_.push_back({t, shared_frame_name("contacts", contacts_.size())});
}

void write_vtk_piece(const std::string& folder, std::size_t number, int rank, const VtkPolyData& particles,
                     const VtkPolyData& contacts) {
  const auto write = [&](const char* kind, const VtkPolyData& data) {
    write_file_atomically(folder + "/vtk/" + piece_name(kind, number, rank), vtp_text(data));
  };
  write("particles", particles);
  write("contacts", contacts);
}

void join_vtk_pieces(const std::string& folder, std::size_t number, int processes,
                     const VtkPolyData& particles, const VtkPolyData& contacts) {
  const auto write = [&](const char* kind, const VtkPolyData& data) {
    std::vector<std::string> pieces;
    for (int rank = 0; rank < processes; ++rank) pieces.push_back(piece_name(kind, number, rank));
    write_file_atomically(folder + "/vtk/" + shared_frame_name(kind, number), pvtp_text(data, pieces));
  };
  write("particles", particles);
  write("contacts", contacts);
}

std::vector<std::string> VtkFrames::finish() const {
  write_file_atomically(folder_ + "/vtk/particles.pvd", pvd_text(particles_));
  write_file_atomically(folder_ + "/vtk/contacts.pvd", pvd_text(contacts_));
  return {"vtk/particles.pvd", "vtk/contacts.pvd"};
}

}  // namespace superstep

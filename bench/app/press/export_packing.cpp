#include "bench/app/press/export_packing.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "bench/host/terminal.hpp"
#include "bench/output/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/text/append.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

using dynamics::State;

Packing packing_of(const Press& one, const State& state) {
  Packing packing;
  packing.id = one.particles.id;
  packing.centre = state.position;
  packing.radius = one.particles.radius;
  packing.material = one.particles.material;
  packing.material.resize(packing.size(), 0);
  packing.material_names = one.model.material_names;
  packing.attributes = {{"vx", {}}, {"vy", {}}, {"vz", {}}, {"temperature", state.temperature}};
  for (const Vec3& v : state.velocity) {
    packing.attributes[0].value.push_back(v.x);
    packing.attributes[1].value.push_back(v.y);
    packing.attributes[2].value.push_back(v.z);
  }
  return packing;
}

/// Bonds of an earlier export would be taken for those of this one. Only a file that begins as ours do.
void forget_bonds(const std::string& file, const std::string& head, bool quiet) {
  std::ifstream stream(file, std::ios::binary);
  std::string begin(head.size(), '\0');
  if (!stream.read(begin.data(), static_cast<std::streamsize>(begin.size())) || begin != head) return;
  stream.close();
  remove_stale_file(file);
  if (quiet) return;
  note(fmt::format("removed {}: it holds the bonds of an earlier export, and this case has none", file));
}

}  // namespace

std::vector<std::string> export_packing(const std::string& file, const Press& one,
                                        const dynamics::MovingNetwork& network, const State& state,
                                        bool quiet) {
  const auto& id = one.particles.id;
  const auto id_of = [&](std::int32_t k) { return id[static_cast<std::size_t>(k)]; };
  const std::filesystem::path path(file);
  const std::string stem = (path.parent_path() / path.stem()).string();
  std::vector<std::string> written;
  const auto write = [&](const std::string& name, const std::string& text) {
    write_file_atomically(name, text);
    written.push_back(name);
  };
  write(file, packing_csv(packing_of(one, state)));
  std::string necks = "# length_unit = \"m\"\ni,j,radius\n", bonds = "i,j,overlap,growth\n";
  for (const auto& contact : network.contacts().points())
    if (contact.area > 0)
      append(necks, "{},{},{}\n", id_of(contact.i), id_of(contact.j),
             std::sqrt(contact.area / std::numbers::pi));
  write(stem + ".necks.csv", necks);
  if (!one.model.bond.acts()) {
    forget_bonds(stem + ".bonds.csv", bonds, quiet);
    return written;
  }
  for (const auto& bond : state.bonds)
    append(bonds, "{},{},{},{}\n", id_of(bond.i), id_of(bond.j), bond.overlap, bond.growth);
  write(stem + ".bonds.csv", bonds);
  return written;
}

}  // namespace superstep

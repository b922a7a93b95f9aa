#include "case/layers/lattice_source.hpp"

#include <algorithm>
#include <utility>

#include "case/packed/packing_options.hpp"
#include "case/packed/read_lattice.hpp"
#include "packing/lattice.hpp"

namespace superstep {
namespace {

class LatticeSource final : public LayerSource {
 public:
  LatticeSource(const Lattice& lattice, double unit, std::string place)
      : lattice_(lattice), unit_(unit), place_(std::move(place)) {}

  std::pair<std::int64_t, std::int64_t> first_share(const Communicator& among) const override {
    return {begin_of_share(layers(), among.rank(), among.size()),
            begin_of_share(layers(), among.rank() + 1, among.size())};
  }
  std::int64_t layers() const override { return lattice_.cells[2]; }
  std::int64_t nodes_before(std::int64_t layer) const override { return layer * lattice_.layer(); }
  Packing packing(std::int64_t first, std::int64_t last) const override {
    return lattice_layers(lattice_, first, last);
  }
  Packing sample() const override { return packing(0, 1); }
  double distance(std::int64_t first, std::int64_t last, Vec3 point) const override {
    const double low = lattice_.spacing * static_cast<double>(first);
    const double high = lattice_.spacing * static_cast<double>(last - 1);
    return std::max({0.0, low - point.z, point.z - high});
  }
  std::int64_t node_of_id(std::int64_t id, Communicator& /*among*/) const override {
    return id >= 0 && id < nodes() ? id : -1;
  }
  /// Neighbours within one diameter.
  std::size_t usual_contacts() const override {
    const double reach = lattice_.diameter / lattice_.spacing, squared = reach * reach;
    std::size_t count = 0;
    for (int k = 0; k < 27; ++k) {
      const int x = k % 3 - 1, y = k / 3 % 3 - 1, z = k / 9 - 1, distance = x * x + y * y + z * z;
      if (distance > 0 && distance < squared) ++count;
    }
    return count;
  }
  bool is_one_cluster() const override { return true; }
  double length_unit() const override { return unit_; }
  const std::string& place() const override { return place_; }

 private:
  Lattice lattice_;
  double unit_;
  std::string place_;
};

}  // namespace

std::unique_ptr<LayerSource> find_lattice_source(TomlTable& packing) {
  const auto generator = packing.find("generator");
  if (!generator || generator->string() != "lattice" || packing.find("file")) return nullptr;
  for (const char* other : {"units", "format", "atom_style", "columns", "order"})
    if (packing.find(other)) return nullptr;
  const double unit = read_packing_options(packing).length_unit.value_or(1.0);
  const Lattice lattice = read_lattice(packing, unit);
  const bool touch = lattice.diameter > lattice.spacing && lattice.diameter < 2 * lattice.spacing;
  if (!touch) return nullptr;
  return std::make_unique<LatticeSource>(lattice, unit, generator->where());
}

}  // namespace superstep

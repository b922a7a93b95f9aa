#include "case/layers/table_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "case/inputs/named_file.hpp"
#include "case/packed/packing_options.hpp"
#include "case/parts/agreed.hpp"
#include "core/index.hpp"
#include "packing/parts/layers.hpp"
#include "packing/parts/table_part.hpp"
#include "parallel/all_to_all.hpp"

namespace superstep {
namespace {

struct Sphere {
  std::int64_t id = 0;
  Vec3 centre;
  double radius = 0;
};

/// Spheres of consecutive layers, in the order of their places.
struct Stretch {
  IndexRange layers;
  std::vector<Sphere> spheres;
};

class TableSource final : public LayerSource {
 public:
  TableSource(TableInParts table, std::string place) : table_(std::move(table)), place_(std::move(place)) {}

  void share(Communicator& among) override;
  void bring(std::int64_t first, std::int64_t last, Communicator& among) override;
  std::pair<std::int64_t, std::int64_t> first_share(const Communicator& among) const override {
    return {begin_of_layers(among.rank(), among.size()), begin_of_layers(among.rank() + 1, among.size())};
  }
  void release() override { read_ = {}; }

  std::int64_t layers() const override { return static_cast<std::int64_t>(before_.size()) - 1; }
  std::int64_t nodes_before(std::int64_t layer) const override { return before_[at(layer)]; }
  Packing packing(std::int64_t first, std::int64_t last) const override;
  Packing sample() const override;
  double distance(std::int64_t first, std::int64_t last, Vec3 point) const override {
    return grid_.distance(first, last, point);
  }
  std::int64_t node_of_id(std::int64_t id, Communicator& among) const override;
  std::size_t usual_contacts() const override { return 8; }
  bool is_one_cluster() const override { return false; }
  double length_unit() const override { return table_.length_unit(); }
  const std::string& place() const override { return place_; }

 private:
  [[nodiscard]] std::vector<Sphere> read_part(Communicator& among) const;
  void measure(const std::vector<Sphere>& spheres, Communicator& among);
  void count_spheres(const std::vector<Sphere>& spheres, Communicator& among);
  void require_unique_ids(const std::vector<Sphere>& spheres, Communicator& among) const;
  void require_distinct_centres() const;
  /// Where the layers begin that a process looks at first: with about as many spheres as those of others.
  [[nodiscard]] std::int64_t begin_of_layers(int rank, int size) const;
  /// Those of `layers`, all of which are in the stretch.
  [[nodiscard]] std::span<const Sphere> spheres_of(IndexRange layers, const Stretch& stretch) const;
  void describe(Packing& packing) const;

  TableInParts table_;
  std::string place_;
  PackingLayers grid_;
  Bounds surfaces_;
  double smallest_ = 1, largest_ = 1, mean_diameter_ = 2;  // m
  std::vector<std::int64_t> before_{0, 0};
  Stretch read_, brought_;
};

std::vector<Sphere> TableSource::read_part(Communicator& among) const {
  std::vector<Sphere> spheres;
  agreed(among, [&] {
    const Packing part = table_.read(begin_of_share(table_.bytes(), among.rank(), among.size()),
                                     begin_of_share(table_.bytes(), among.rank() + 1, among.size()));
    for (std::size_t k = 0; k < part.size(); ++k)
      spheres.push_back({part.id[k], part.centre[k], part.radius[k]});
  });
  if (!table_.has_ids()) {
    const auto before = static_cast<std::int64_t>(among.sum_before(spheres.size()));
    for (auto& sphere : spheres) sphere.id += before;
  }
  return spheres;
}

/// What selections and layers need to know of all spheres.
void TableSource::measure(const std::vector<Sphere>& spheres, Communicator& among) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Bounds centres{{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}}, surfaces = centres;
  double smallest = infinity, largest = 0;
  ExactSum sum;
  for (const auto& [id, centre, r] : spheres) {
    centres.take(centre, centre);
    surfaces.take(centre - Vec3{r, r, r}, centre + Vec3{r, r, r});
    smallest = std::min(smallest, r);
    largest = std::max(largest, r);
    sum.add(r);
  }
  const auto of_all = [&](const Bounds& box) {
    return Bounds{{among.min(box.min.x), among.min(box.min.y), among.min(box.min.z)},
                  {among.max(box.max.x), among.max(box.max.y), among.max(box.max.z)}};
  };
  centres = of_all(centres);
  surfaces_ = of_all(surfaces);
  smallest_ = among.min(smallest);
  largest_ = among.max(largest);
  const auto count = among.sum(spheres.size());
  if (count == 0)
    throw InputError(fmt::format("{}: has a header but no particles; at least one is needed", table_.path()));
  mean_diameter_ = mean_diameter(among.sum(sum), count);
  grid_ = PackingLayers(centres, largest_, static_cast<std::int64_t>(count));
}

void TableSource::count_spheres(const std::vector<Sphere>& spheres, Communicator& among) {
  std::vector<double> here(at(grid_.count()), 0.0);
  for (const auto& sphere : spheres) ++here[at(grid_.place_of(sphere.centre, sphere.id).layer)];
  const std::vector<double> all = everywhere(here, among);
  before_.assign(1, 0);
  for (std::size_t layer = 0; layer < here.size(); ++layer) {
    double count = 0;
    for (std::size_t k = layer; k < all.size(); k += here.size()) count += all[k];
    before_.push_back(before_.back() + static_cast<std::int64_t>(count));
  }
}

std::int64_t TableSource::begin_of_layers(int rank, int size) const {
  if (rank == size) return layers();
  return std::lower_bound(before_.begin(), before_.end(), begin_of_share(nodes(), rank, size)) -
         before_.begin();
}

std::span<const Sphere> TableSource::spheres_of(IndexRange layers, const Stretch& stretch) const {
  const std::int64_t before = before_[at(stretch.layers.begin)];
  return std::span(stretch.spheres)
      .subspan(at(before_[at(layers.begin)] - before),
               at(before_[at(layers.end)] - before_[at(layers.begin)]));
}

/// Each id has a process that sees all of its rows.
void TableSource::require_unique_ids(const std::vector<Sphere>& spheres, Communicator& among) const {
  const auto processes = static_cast<std::uint64_t>(among.size());
  std::vector<std::vector<std::int64_t>> to(processes);
  for (const auto& sphere : spheres)
    to[static_cast<std::uint64_t>(sphere.id) % processes].push_back(sphere.id);
  auto ids = all_to_all(std::move(to), among);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  agreed(among, [&] {
    if (twice != ids.end())
      throw InputError(
          fmt::format("{}: id {} stands twice; ids must be unique; renumber or remove one of the two",
                      table_.path(), *twice));
  });
}

void TableSource::require_distinct_centres() const {
  std::vector<std::array<double, 3>> centres;
  centres.reserve(read_.spheres.size());
  for (const auto& [id, c, r] : read_.spheres) centres.push_back({c.x, c.y, c.z});
  std::sort(centres.begin(), centres.end());
  if (const auto twice = std::adjacent_find(centres.begin(), centres.end()); twice != centres.end())
    throw InputError(
        fmt::format("{}: two spheres have the centre ({}, {}, {}) m; centres must differ; remove "
                    "one of the two, or write the file with more digits",
                    table_.path(), (*twice)[0], (*twice)[1], (*twice)[2]));
}

void TableSource::share(Communicator& among) {
  std::vector<Sphere> spheres = read_part(among);
  measure(spheres, among);
  count_spheres(spheres, among);
  if (table_.has_ids()) require_unique_ids(spheres, among);
  std::vector<std::int64_t> begins;
  for (int rank = 0; rank < among.size(); ++rank) begins.push_back(begin_of_layers(rank, among.size()));
  std::vector<std::vector<Sphere>> to(at(among.size()));
  for (const auto& sphere : spheres) {
    const std::int64_t layer = grid_.place_of(sphere.centre, sphere.id).layer;
    const auto behind = std::upper_bound(begins.begin(), begins.end(), layer);
    to[at(behind - begins.begin() - 1)].push_back(sphere);
  }
  std::vector<Sphere>().swap(spheres);
  std::tie(read_.layers.begin, read_.layers.end) = first_share(among);
  read_.spheres = all_to_all(std::move(to), among);
  const auto place = [&](const Sphere& sphere) { return grid_.place_of(sphere.centre, sphere.id); };
  std::sort(read_.spheres.begin(), read_.spheres.end(),
            [&](const Sphere& a, const Sphere& b) { return place(a) < place(b); });
  agreed(among, [&] { require_distinct_centres(); });
}

void TableSource::bring(std::int64_t first, std::int64_t last, Communicator& among) {
  std::vector<std::vector<Sphere>> to;
  for (const IndexRange& wish : everywhere(IndexRange{first, last}, among)) {
    const IndexRange layers = read_.layers.overlap(wish);
    const auto spheres = layers.empty() ? std::span<const Sphere>() : spheres_of(layers, read_);
    to.emplace_back(spheres.begin(), spheres.end());
  }
  brought_ = {{first, last}, all_to_all(std::move(to), among)};
}

void TableSource::describe(Packing& packing) const {
  packing.material.assign(packing.size(), 0);
  packing.place = table_.path();
  packing.length_unit = table_.length_unit();
  packing.in_order = true;
  packing.mean_diameter = mean_diameter_;
  packing.part_of = PackingPart{surfaces_, nodes(), false};
}

Packing TableSource::packing(std::int64_t first, std::int64_t last) const {
  const IndexRange layers{first, last};
  const bool is_brought = first >= brought_.layers.begin && last <= brought_.layers.end;
  Packing packing;
  for (const auto& [id, centre, radius] : spheres_of(layers, is_brought ? brought_ : read_)) {
    packing.id.push_back(id);
    packing.centre.push_back(centre);
    packing.radius.push_back(radius);
  }
  describe(packing);
  return packing;
}

Packing TableSource::sample() const {
  Packing packing;
  packing.id = {0, 1};
  packing.centre = {{0, 0, 0}, {4 * largest_, 0, 0}};
  packing.radius = {smallest_, largest_};
  describe(packing);
  return packing;
}

std::int64_t TableSource::node_of_id(std::int64_t id, Communicator& among) const {
  const auto found = std::find_if(read_.spheres.begin(), read_.spheres.end(),
                                  [&](const Sphere& sphere) { return sphere.id == id; });
  const bool here = found != read_.spheres.end();
  return static_cast<std::int64_t>(among.max(
      here ? static_cast<double>(before_[at(read_.layers.begin)] + (found - read_.spheres.begin())) : -1.0));
}

}  // namespace

std::unique_ptr<LayerSource> find_table_source(TomlTable& packing, std::string& why_not) {
  const auto file = packing.find("file");
  const PackingOptions options = read_packing_options(packing);
  if (!file || !options.in_layers) return nullptr;
  auto table = read_named_file(
      *file, [&](const std::string& path) { return TableInParts::open(path, options, why_not); });
  if (!table) return nullptr;
  return std::make_unique<TableSource>(std::move(*table), named_path(*file));
}

}  // namespace superstep

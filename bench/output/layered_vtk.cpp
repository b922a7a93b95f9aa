#include "bench/output/layered_vtk.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "bench/measure/run_one.hpp"
#include "bench/measure/shared/failure_of.hpp"
#include "bench/output/vtk_frames.hpp"
#include "case/layers/layered_scene.hpp"
#include "case/layers/values_beyond.hpp"
#include "core/index.hpp"
#include "parallel/communicator.hpp"

namespace superstep {
namespace {

/// What a process draws: its nodes, and behind them those of others that their contacts reach.
struct Piece {
  std::vector<Vec3> centre;
  std::vector<std::int64_t> id;
  std::vector<double> radius, value;  // own nodes, as `id`; centres of the others follow
  std::vector<std::pair<std::int64_t, std::int64_t>> lines;  // nodes
  std::vector<double> overlap, neck_radius, conductance;
};

void take_nodes(const ReadLayers& read, const LayeredNodes& nodes, std::int64_t end, double origin,
                std::span<const double> state, std::size_t& row, Piece& piece) {
  const Packing& packing = read.packed.packing;
  const Graph& graph = read.field.graph;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const std::int64_t node = read.first_node + static_cast<std::int64_t>(k);
    if (node < nodes.begin || node >= std::min(end, nodes.end)) continue;
    piece.id.push_back(packing.id[k]);
    piece.centre.push_back(packing.centre[k]);
    piece.radius.push_back(packing.radius[k]);
    piece.value.push_back(graph.is_fixed[k] ? graph.fixed_value[k] : state[row++] + origin);
  }
}

/// A contact is its first sphere's.
void take_contacts(const ReadLayers& read, const LayeredNodes& nodes, std::int64_t end, Piece& piece) {
  const Contacts& contacts = read.packed.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const std::int64_t i = contacts.i[c] + read.first_node, j = contacts.j[c] + read.first_node;
    if (i < nodes.begin || i >= std::min(end, nodes.end)) continue;
    piece.lines.emplace_back(i, j);
    piece.overlap.push_back(contacts.overlap[c]);
    piece.neck_radius.push_back(contacts.neck_radius[c]);
    piece.conductance.push_back(read.field.graph.conductance[c]);
  }
}

/// Layer by layer, each with the next one, which its contacts reach.
Piece read_piece(const Scene& scene, std::span<const double> state) {
  LayeredNodes& nodes = LayeredNodes::of(scene);
  const LayerSource& source = nodes.source();
  const double origin = scene.fields.front().origin;
  Piece piece;
  std::size_t row = 0;
  nodes.for_stretches([&](std::int64_t first, std::int64_t last) {
    const ReadLayers read = nodes.reader().read(first, std::min(last + 1, source.layers()), true);
    const std::int64_t end = source.nodes_before(last);
    take_nodes(read, nodes, end, origin, state, row, piece);
    take_contacts(read, nodes, end, piece);
  });
  return piece;
}

/// Nodes of others at the ends of lines, in order.
std::vector<std::int64_t> ghosts_of(const Piece& piece, std::int64_t end) {
  std::vector<std::int64_t> ghosts;
  for (const auto& line : piece.lines)
    if (line.second >= end) ghosts.push_back(line.second);
  std::sort(ghosts.begin(), ghosts.end());
  ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
  return ghosts;
}

VtkPolyData particles_of(const Piece& piece, const std::string& field, double t) {
  return {.points = std::span(piece.centre).first(piece.id.size()),
          .lines = {},
          .point_data = {{"id", piece.id}, {"radius", piece.radius}, {field, piece.value}},
          .cell_data = {},
          .time = t};
}

/// Puts the centres of ghosts behind those of the piece, and positions in place of nodes.
///   beyond  values of the nodes that follow the own ones
VtkPolyData contacts_of(const LayeredNodes& nodes, const std::string& field, double t,
                        std::span<const double> beyond, Piece& piece) {
  const auto ghosts = ghosts_of(piece, nodes.end);
  const LayerSource& source = nodes.source();
  const std::size_t own = piece.id.size();
  if (!ghosts.empty()) {
    const std::int64_t first = source.layer_of_node(ghosts.front());
    const Packing packing = source.packing(first, source.layer_of_node(ghosts.back()) + 1);
    for (const auto ghost : ghosts)
      piece.centre.push_back(packing.centre[at(ghost - source.nodes_before(first))]);
  }
  std::vector<double> flux;
  for (std::size_t c = 0; c < piece.lines.size(); ++c) {
    auto& [i, j] = piece.lines[c];
    const bool here = j < nodes.end;
    i -= nodes.begin;
    const double other = here ? piece.value[at(j - nodes.begin)] : beyond[at(j - nodes.end)];
    flux.push_back(piece.conductance[c] * (piece.value[at(i)] - other));
    j = here ? j - nodes.begin
             : static_cast<std::int64_t>(own) +
                   (std::lower_bound(ghosts.begin(), ghosts.end(), j) - ghosts.begin());
  }
  constexpr std::uint8_t duplicate_point = 1;  // vtkDataSetAttributes::DUPLICATEPOINT
  std::vector<std::uint8_t> ghost_type(own, 0);
  ghost_type.resize(piece.centre.size(), duplicate_point);
  return {.points = piece.centre,
          .lines = std::move(piece.lines),
          .point_data = {{"vtkGhostType", std::move(ghost_type)}},
          .cell_data = {{"overlap", std::move(piece.overlap)},
                        {"neck_radius", std::move(piece.neck_radius)},
                        {"flux_" + field, std::move(flux)},
                        {"conductance_" + field, std::move(piece.conductance)}},
          .time = t,
          .vertices = false};
}

/// Does what may fail on some process; then all throw what the lowest one says.
template <class Work>
void everybodys(const Work& work) {
  if (const auto first = world().first_of(failure_of(work))) throw EverybodysError(*first);
}

}  // namespace

void write_layered_frame(const Scene& scene, const std::string& folder, std::size_t frame, double t,
                         std::span<const double> state) {
  const LayeredNodes& nodes = LayeredNodes::of(scene);
  const std::string& field = scene.fields.front().name;
  Piece piece;
  everybodys([&] { piece = read_piece(scene, state); });
  const auto beyond = values_beyond(nodes, piece.value, world());
  VtkPolyData particles, contacts;
  everybodys([&] {
    contacts = contacts_of(nodes, field, t, beyond, piece);
    particles = particles_of(piece, field, t);
    write_vtk_piece(folder, frame, world().rank(), particles, contacts);
  });
  everybodys([&] {
    if (world().is_root()) join_vtk_pieces(folder, frame, world().size(), particles, contacts);
  });
}

}  // namespace superstep

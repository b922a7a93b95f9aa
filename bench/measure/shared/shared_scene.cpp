#include "bench/measure/shared/shared_scene.hpp"

#include <utility>

#include "bench/measure/shared/shared_parts.hpp"
#include "bench/measure/shared/worker.hpp"
#include "case/build_rhs.hpp"
#include "network/part.hpp"
#include "rhs/network_rhs.hpp"
#include "rhs/nonlinear_part.hpp"

namespace superstep {
namespace {

/// One field with constant conductances, which is most scenes.
struct LinearPart {
  NetworkPart network;
  std::int64_t rows = 0;
  double pair_step = 0;
  std::string name, unit;
};

void pack(const LinearPart& part, Packer& out) {
  pack(part.network, out);
  out.put(part.rows);
  out.put(part.pair_step);
  out.put(part.name);
  out.put(part.unit);
}

void unpack(Unpacker& in, LinearPart& part) {
  unpack(in, part.network);
  in.take(part.rows);
  in.take(part.pair_step);
  in.take(part.name);
  in.take(part.unit);
}

ScenePart build(LinearPart part, std::size_t block) {
  const Partition partition(part.rows, world().size(), world().rank(), block);
  Network& network = part.network.network;
  network.halo = std::make_shared<Halo>(world(), partition, std::move(part.network.halo));
  const auto entries = static_cast<double>(network.nonzeros());
  ScenePart own;
  own.rhs = std::make_unique<NetworkRhs>(std::move(network), part.name, part.unit, part.pair_step);
  own.entries = entries;
  return own;
}

ScenePart build(NonlinearPart part, std::size_t block) {
  std::size_t entries = part.temperature.network.network.nonzeros();
  if (part.potential) entries += part.potential->network.network.nonzeros();
  ScenePart own;
  own.rhs = make_rhs(std::move(part), world(), block);
  own.entries = static_cast<double>(entries);
  return own;
}

/// Own rows of every field.
std::vector<double> own_state(const Scene& scene, int rank) {
  std::vector<double> own;
  for (const auto& field : scene.rhs->fields()) {
    const Partition partition(static_cast<std::int64_t>(field.count), world().size(), rank, block_rows());
    const auto rows =
        std::span<const double>(scene.initial)
            .subspan(field.offset + static_cast<std::size_t>(partition.begin()), partition.owned());
    own.insert(own.end(), rows.begin(), rows.end());
  }
  return own;
}

/// Sends everybody what cut(rank) gives, and builds the root's.
template <class Cut>
ScenePart share(const Scene& scene, bool linear, const Cut& cut) {
  for (int to = 1; to < world().size(); ++to) {
    Packer out;
    out.put(Order::scene);
    out.put(block_rows());
    out.put(linear);
    pack(cut(to), out);
    out.put(own_state(scene, to));
    world().send(to, out.bytes());
  }
  ScenePart own = build(cut(0), block_rows());
  own.kept_initial = own_state(scene, 0);
  own.initial = own.kept_initial;
  own.scene = scene.rhs->identity();
  return own;
}

template <class Part>
ScenePart take(Unpacker& in, std::size_t block) {
  Part part;
  unpack(in, part);
  auto initial = in.take<std::vector<double>>();
  ScenePart own = build(std::move(part), block);
  own.kept_initial = std::move(initial);
  own.initial = own.kept_initial;
  return own;
}

}  // namespace

bool can_be_shared(const Scene& scene) {
  if (scene.rhs->reduction().total() == 0) return false;
  if (dynamic_cast<const NetworkRhs*>(scene.rhs.get())) return true;
  const auto* nonlinear = dynamic_cast<const NonlinearRhs*>(scene.rhs.get());
  return nonlinear && !nonlinear->solves_for_potential();
}

ScenePart share_out(const Scene& scene) {
  if (scene.own_nodes) return part_of_own(scene);
  if (const auto* whole = dynamic_cast<const NetworkRhs*>(scene.rhs.get())) {
    const auto& view = whole->fields().front();
    return share(scene, true, [&](int rank) {
      const auto rows = static_cast<std::int64_t>(whole->size());
      return LinearPart{part_of(whole->network(), Partition(rows, world().size(), rank, block_rows())), rows,
                        whole->facts().pair_step, view.name, view.unit};
    });
  }
  const NonlinearInput input = nonlinear_input(scene);
  return share(scene, false, [&](int rank) { return part_of(input, world().size(), rank, block_rows()); });
}

ScenePart take_part(Unpacker& in) {
  const auto block = in.take<std::size_t>();
  return in.take<bool>() ? take<LinearPart>(in, block) : take<NonlinearPart>(in, block);
}

std::ptrdiff_t own_entry(const Rhs& part, std::size_t entry) {
  std::size_t begin = 0;  // of the field in the whole state
  for (const auto& field : part.fields()) {
    if (entry < begin + field.total()) {
      const std::size_t row = entry - begin;
      if (row < field.first_row || row >= field.first_row + field.count) return -1;
      return static_cast<std::ptrdiff_t>(field.offset + row - field.first_row);
    }
    begin += field.total();
  }
  return -1;
}

std::vector<double> whole_state(const Rhs& part, std::span<const double> state) {
  std::vector<double> whole;
  for (const auto& field : part.fields()) {
    const auto rows = world().gather(state.subspan(field.offset, field.count));
    whole.insert(whole.end(), rows.begin(), rows.end());
  }
  return whole;
}

}  // namespace superstep

#include "bench/measure/shared/shared_layers.hpp"

#include <fmt/format.h>

#include <exception>
#include <iterator>
#include <string>

#include "bench/host/terminal.hpp"
#include "bench/measure/shared/worker.hpp"
#include "case/layers/layered_scene.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  // bytes of text that are sent at a time

/// Calls each(text) with lines of the nodes that are here.
template <class Each>
void for_own_lines(const Scene& scene, std::span<const double> state, const Each& each) {
  LayeredNodes& nodes = *scene.layers;
  const double origin = scene.fields.front().origin;
  fmt::memory_buffer text;
  std::size_t row = 0;
  nodes.for_stretches([&](std::int64_t first, std::int64_t last) {
    const ReadLayers read = nodes.reader().read(first, last, false);
    const Packing& packing = read.packed.packing;
    const Graph& graph = read.field.graph;
    for (std::size_t k = 0; k < packing.size(); ++k) {
      if (packing.id[k] < nodes.begin || packing.id[k] >= nodes.end) continue;
      const double value = graph.is_fixed[k] ? graph.fixed_value[k] : state[row++] + origin;
      const auto [x, y, z] = packing.centre[k];
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{}\n", packing.id[k], x, y, z,
                     packing.radius[k], value);
      if (text.size() < piece) continue;
      each(std::string_view(text.data(), text.size()));
      text.clear();
    }
  });
  if (text.size() > 0) each(std::string_view(text.data(), text.size()));
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

}  // namespace

std::optional<Scene> share_layers(const std::string& file) {
  if (world().alone()) return std::nullopt;
  const std::string text = read_text_file(file);
  if (!can_be_layered(TomlTable::parse_text(text, file))) return std::nullopt;
  Packer out;
  out.put(Order::layers);
  out.put(block_rows());
  out.put(file);
  out.put(text);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
  try {
    return build_in_layers(TomlTable::parse_text(text, file), world());
  } catch (const InputError&) {  // everybody's
    throw;
  } catch (const std::exception& error) {  // the others would wait for ever
    note("error: ", fmt::format("process 1 of {}: {}", world().size(), error.what()));
    world().abort(static_cast<int>(ExitCode::internal));
    throw;
  }
}

ScenePart take_layers(Unpacker& in) {
  set_block_rows(in.take<std::size_t>());
  std::string file, text;
  in.take(file);
  in.take(text);
  auto scene = std::make_shared<Scene>(build_in_layers(TomlTable::parse_text(text, file), world()));
  ScenePart part = part_of_layers(*scene);
  part.layered = std::move(scene);
  return part;
}

ScenePart part_of_layers(const Scene& scene) {
  ScenePart part;
  part.rhs = std::shared_ptr<Rhs>(std::shared_ptr<Rhs>(), scene.rhs.get());  // the scene's
  part.initial = scene.initial;
  part.entries = static_cast<double>(dynamic_cast<const NetworkRhs&>(*scene.rhs).entries());
  part.scene = scene.rhs->identity();
  part.in_layers = true;
  return part;
}

void for_layered_lines(const Scene& scene, std::span<const double> state,
                       const std::function<void(std::string_view)>& each) {
  for_own_lines(scene, state, each);
  Packer out;
  out.put(Order::lines);
  for (int from = 1; from < world().size(); ++from) {
    world().send(from, out.bytes());
    std::exception_ptr failed;  // what a process has begun to send must be received all the same
    for (auto text = world().receive(from); !text.empty(); text = world().receive(from)) try {
        if (!failed) each(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()));
      } catch (...) {
        failed = std::current_exception();
      }
    if (failed) std::rethrow_exception(failed);
  }
}

void send_layered_lines(const ScenePart& part) {
  for_own_lines(*part.layered, part.final_state,
                [](std::string_view text) { world().send(0, bytes_of(text)); });
  world().send(0, {});
}

}  // namespace superstep

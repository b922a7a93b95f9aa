#include "bench/harness/digest.hpp"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace superstep {
namespace {

void add_field(Digest& digest, const Scene& scene, std::size_t f) {
  const FieldScene& field = scene.fields[f];
  const Graph& graph = field.graph;
  digest.add(field.name);
  digest.add_all<std::int64_t>(graph.id);
  for (const auto* values :
       {&graph.capacity, &graph.source, &graph.initial, &graph.fixed_value, &graph.conductance})
    digest.add_all<double>(*values);
  digest.add_all<char>(graph.is_fixed);
  digest.add_all<std::int32_t>(graph.fixed_table);
  for (const auto& table : graph.tables) {
    digest.add_all<double>(table.time);
    digest.add_all<double>(table.value);
  }
  for (const auto& source : graph.tabled_sources) digest.add_number(source.node).add_number(source.table);
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges)
      digest.add_number(exchange.node)
          .add_number(exchange.coefficient)
          .add_number(exchange.ambient)
          .add_number(exchange.table);
  digest.add_all<std::int32_t>(graph.i);
  digest.add_all<std::int32_t>(graph.j);
  digest.add_all<NodeRole>(field.roles);
  std::vector<std::int64_t> entries;
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    entries.push_back(scene.entry_of_node(f, static_cast<std::int32_t>(node)));
  digest.add_all<std::int64_t>(entries);
}

// f(t, y) of a state unlike any that has a symmetry: a new physical term changes it whatever the term is.
void add_derivative(Digest& digest, const Scene& scene, double t, double amplitude) {
  std::vector<double> state = scene.initial, derivative(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) state[i] += amplitude * std::sin(static_cast<double>(i) + 1);
  (*scene.rhs)(t, state, derivative);
  digest.add_all<double>(derivative);
}

}  // namespace

Digest& Digest::add_bytes(const void* data, std::size_t size) noexcept {
  constexpr Word prime = (static_cast<Word>(1) << 88U) + 0x13bU;
  const auto* bytes = static_cast<const unsigned char*>(data);
  for (std::size_t k = 0; k < size; ++k) hash_ = (hash_ ^ bytes[k]) * prime;
  return *this;
}

Digest& Digest::add(std::string_view text) noexcept {
  add_number(static_cast<double>(text.size()));
  return add_bytes(text.data(), text.size());
}

std::string Digest::text() const {
  return fmt::format("{:016x}{:016x}", static_cast<std::uint64_t>(hash_ >> 64U),
                     static_cast<std::uint64_t>(hash_));
}

void add_scene(Digest& digest, const Scene& scene) {
  for (std::size_t f = 0; f < scene.fields.size(); ++f) add_field(digest, scene, f);
  digest.add_all<double>(scene.initial);
  digest.add_number(scene.t_end);
  digest.add_all<double>(scene.output_times);
  for (const auto& probe : scene.probes) digest.add_number(probe.node);
  double span = 0;
  for (const auto& field : scene.fields) span = std::max(span, field.high - field.low);
  add_derivative(digest, scene, 0.0, 0.0);
  add_derivative(digest, scene, scene.t_end, span > 0 ? span : 1.0);
}

}  // namespace superstep

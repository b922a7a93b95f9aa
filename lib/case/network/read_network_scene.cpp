#include "case/network/read_network_scene.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "case/inputs/read_amount.hpp"
#include "case/inputs/read_initial.hpp"
#include "case/network/read_network_files.hpp"
#include "case/read_field.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "core/text/suggest.hpp"
#include "network/generators/network_generator.hpp"

namespace superstep {
namespace {

constexpr double largest_ratio = 1e12;  // beyond it sums of conductances are rounding

double between(TomlTable& table, const char* key, double low, double high, double fallback) {
  const auto value = table.find(key);
  if (!value) return fallback;
  if (!(value->number() >= low && value->number() <= high))
    value->reject(fmt::format("it must lie between {:g} and {:g}", low, high));
  return value->number();
}

NetworkRecipe read_recipe(TomlTable& network, const NetworkGenerator& generator) {
  constexpr std::int64_t smallest = 8, largest = largest_generated_network;
  NetworkRecipe recipe;
  const auto size = network.require("size", "it is the number of nodes that the generator makes, or nearly");
  if (size.integer() < smallest || size.integer() > largest)
    size.reject(fmt::format("it must lie between {} and {}", smallest, largest));
  recipe.size = static_cast<std::size_t>(size.integer());
  recipe.contrast = between(network, "contrast", 1, largest_ratio, recipe.contrast);
  recipe.spread = between(network, "spread", 1, largest_ratio, recipe.spread);
  recipe.fraction = between(network, "fraction", 0, 1, recipe.fraction);
  if (recipe.fraction > 0 && generator.fraction.empty())
    network.find("fraction")->reject(fmt::format("the generator \"{}\" takes none", generator.name));
  if (const auto seed = network.find("seed")) {
    if (seed->integer() < 0) seed->reject("it must be >= 0");
    recipe.seed = static_cast<std::uint64_t>(seed->integer());
  }
  return recipe;
}

/// Holds nodes at a value; none where the key is left out.
void fix(TomlTable& network, const char* key, const std::vector<std::int32_t>& nodes, double t_end,
         Graph& graph) {
  const auto value = network.find(key);
  if (!value) return;
  const Amount amount = read_amount(*value, t_end, graph);
  if (amount.table >= 0 && graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
  for (const auto node : nodes) {
    graph.is_fixed[at(node)] = 1;
    graph.fixed_value[at(node)] = amount.value;
    if (!graph.fixed_table.empty()) graph.fixed_table[at(node)] = amount.table;
  }
}

void heat(TomlTable& network, const std::vector<std::int32_t>& nodes, double t_end, Graph& graph) {
  const auto source = network.find("source");
  if (!source) return;
  const Amount amount = read_amount(*source, t_end, graph);
  for (const auto node : nodes) {
    if (amount.table < 0)
      graph.source[at(node)] = amount.value;
    else
      graph.tabled_sources.push_back({node, amount.table});
  }
}

Graph generate(TomlTable& network, const TomlValue& named, double t_end) {
  const std::string name = named.string();
  const NetworkGenerator* generator = find_network_generator(name);
  if (!generator) {
    std::vector<std::string> names;
    for (const auto& known : network_generators()) names.push_back(known.name);
    named.reject("it must name a generator of networks" + suggestion(name, names));
  }
  for (const char* key : {"field", "size", "contrast", "spread", "fraction", "seed", "expect", "initial",
                          "inlet", "outlet", "source", "nodes", "edges"})
    (void)network.find(key);
  network.finish();  // a misspelt key is said first: without it another network would be made
  GeneratedNetwork made = generator->make(read_recipe(network, *generator));
  if (const auto expected = network.find("expect"))
    if (const std::string hash = network_hash(made); hash != expected->string())
      expected->reject(
          fmt::format("the network that was made is {}: the case is of another one; write that "
                      "if the recipe was changed on purpose, or leave this key out",
                      hash));
  Graph graph = std::move(made.graph);
  graph.initial = read_initial(network, graph.id, nullptr);
  fix(network, "inlet", made.inlet, t_end, graph);
  fix(network, "outlet", made.outlet, t_end, graph);
  heat(network, made.heated, t_end, graph);
  return graph;
}

}  // namespace

FieldScene describe_network_field(TomlTable& network) {
  FieldScene field;
  const auto name = network.string("field").value_or("temperature");
  if (name != "temperature" && name != "potential")
    network.require("field", "").reject("it must be \"temperature\" or \"potential\"");
  const FieldKind& kind = name == "potential" ? electric_kind() : thermal_kind();
  field.name = kind.name;
  field.unit = kind.unit;
  const auto order = network.string("order").value_or("bandwidth");
  if (order != "bandwidth" && order != "file")
    network.require("order", "").reject("it must be \"bandwidth\" or \"file\"");
  field.in_order = order == "file";
  return field;
}

void read_network_scene(TomlTable& root, TomlTable& network, Scene& scene, const NetworkArrays* arrays) {
  for (const char* other :
       {"packing", "material", "materials", "interfaces", "contact", "thermal", "electric", "coupling"})
    if (const auto value = root.find(other))
      value->reject("a case with [network] gives nodes and edges directly; remove this, or remove [network]");
  FieldScene field = describe_network_field(network);
  const auto generator = network.find("generator");
  if (generator && arrays) generator->reject("the network is in memory already; leave this key out");
  if (generator) {
    for (const char* file : {"nodes", "edges", "matrix", "openpnm"})
      if (const auto value = network.find(file))
        value->reject("the network comes from a generator; give either files or a generator");
    field.graph = generate(network, *generator, scene.t_end);
  } else {
    NetworkInput input = read_network_files(network, scene.t_end, arrays);
    field.graph = std::move(input.graph);
    scene.warnings.insert(scene.warnings.end(), input.notes.begin(), input.notes.end());
  }
  field.algebraic = eliminate_algebraic_nodes(field.graph, network.where());
  field.bare = field.graph.conductance;
  scene.fields.push_back(std::move(field));
}

}  // namespace superstep

#include "case/network/read_network_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <unordered_map>
#include <utility>

#include "case/inputs/named_file.hpp"
#include "case/inputs/read_amount.hpp"
#include "case/inputs/read_initial.hpp"
#include "case/memory/memory_network.hpp"
#include "case/network/node_vector.hpp"
#include "core/error.hpp"
#include "core/text/ids_in_words.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

MatrixKind matrix_kind(TomlTable& network) {
  const auto kind = network.find("matrix_kind");
  if (!kind || kind->string() == "auto") return MatrixKind::automatic;
  if (kind->string() == "laplacian") return MatrixKind::laplacian;
  if (kind->string() == "conductance") return MatrixKind::conductance;
  kind->reject("it must be \"auto\", \"laplacian\" or \"conductance\"");
}

NodeVector read_vector_of(const TomlValue& file, std::span<const std::int64_t> id) {
  return read_named_file(file, [&](const auto& path) { return read_node_vector(path, id); });
}

/// A matrix and pores say nothing of capacities: 1 is that of du/dt + K u = y, and said where it is taken.
void note_capacity(TomlTable& network, std::vector<std::string>& notes) {
  if (!network.find("capacity"))
    notes.push_back(fmt::format(
        "{}: no capacity is given: every node has 1; give one number for all [J/K or F], or a file",
        network.where()));
}

/// A number for all nodes, or a file with one for each; nothing when the key is not there.
void read_vector(TomlTable& network, const char* key, std::span<const std::int64_t> id,
                 std::vector<double>& out) {
  const auto value = network.find(key);
  if (!value) return;
  if (!value->is_string()) {
    out.assign(id.size(), value->number());
    return;
  }
  NodeVector values = read_vector_of(*value, id);
  for (std::size_t k = 0; k < id.size() && std::string(key) == "capacity"; ++k)
    if (!values.given[k])
      value->reject(
          fmt::format("the file has no value for node {}; every node needs a capacity, or 0", id[k]));
  out = std::move(values.value);
}

void fix(Graph& graph, std::size_t node, const Amount& amount, const TomlValue& at) {
  if (graph.is_fixed[node])
    at.reject(fmt::format("node {} is fixed already; selections must not overlap", graph.id[node]));
  if (amount.table >= 0 && graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
  graph.is_fixed[node] = 1;
  graph.fixed_value[node] = amount.value;
  if (!graph.fixed_table.empty()) graph.fixed_table[node] = amount.table;
}

/// Nodes of an entry `{ ids, value }` or, in a pore network, `{ label, value }`.
std::vector<std::size_t> nodes_of(TomlTable& entry, const Graph& graph, const PoreNetwork* pores) {
  std::vector<std::size_t> out;
  if (pores != nullptr)
    if (const auto label = entry.find("label")) {
      std::vector<std::string> names;
      for (const auto& [name, mask] : pores->labels) {
        names.push_back(name);
        if (name != label->string()) continue;
        for (std::size_t k = 0; k < mask.size(); ++k)
          if (mask[k]) out.push_back(k);
        if (out.empty()) label->reject("it holds no pore");
        return out;
      }
      label->reject(fmt::format("it must be a label of the pores; those are {}", fmt::join(names, ", ")));
    }
  std::unordered_map<std::int64_t, std::size_t> position;
  for (std::size_t k = 0; k < graph.nodes(); ++k) position.emplace(graph.id[k], k);
  const auto ids = entry.require("ids", "it lists nodes");
  if (ids.array().empty()) ids.reject("it must hold at least one id");
  std::vector<char> taken(graph.nodes());
  for (const auto& id : ids.array()) {
    const auto found = position.find(id.integer());
    if (found == position.end()) id.reject("it must be the id of a node; " + ids_in_words(graph.id));
    if (taken[found->second]) id.reject("it stands twice; keep one");
    taken[found->second] = 1;
    out.push_back(found->second);
  }
  return out;
}

/// Calls each(node, amount, entry) for the nodes of a list of { ids, value }.
template <class Each>
void for_entries(const TomlValue& list, double t_end, const PoreNetwork* pores, Graph& graph,
                 const Each& each) {
  if (list.array().empty()) list.reject("it must hold at least one entry { ids, value }");
  for (const auto& one : list.array()) {
    TomlTable entry = one.table();
    const auto nodes = nodes_of(entry, graph, pores);
    const Amount amount = read_amount(entry.require("value", "it is what the nodes have"), t_end, graph);
    entry.finish();
    for (const auto node : nodes) each(node, amount, one);
  }
}

/// `fixed` is a file of ids and values, or a list of { ids, value }.
void read_fixed(TomlTable& network, double t_end, const PoreNetwork* pores, Graph& graph) {
  const auto fixed = network.find("fixed");
  if (!fixed) return;
  if (fixed->is_string()) {
    const NodeVector values = read_vector_of(*fixed, graph.id);
    for (std::size_t k = 0; k < graph.nodes(); ++k)
      if (values.given[k]) fix(graph, k, {values.value[k], -1}, *fixed);
    return;
  }
  for_entries(*fixed, t_end, pores, graph, [&](std::size_t node, const Amount& amount, const TomlValue& at) {
    fix(graph, node, amount, at);
  });
}

void add_source(Graph& graph, std::size_t node, const Amount& amount) {
  if (amount.table < 0)
    graph.source[node] += amount.value;
  else
    graph.tabled_sources.push_back({static_cast<std::int32_t>(node), amount.table});
}

/// A list of { ids, value }: each of its nodes has that source, beside what it may have already.
void read_source_list(const TomlValue& list, double t_end, const PoreNetwork* pores, Graph& graph) {
  for_entries(list, t_end, pores, graph, [&](std::size_t node, const Amount& amount, const TomlValue& at) {
    if (graph.is_fixed[node])
      at.reject(fmt::format("node {} is fixed: a source there does nothing", graph.id[node]));
    add_source(graph, node, amount);
  });
}

/// A file with a source for each node, one amount for all of them, or a list of nodes with theirs. Once it is
/// known which nodes are fixed.
void read_source(TomlTable& network, double t_end, const PoreNetwork* pores, Graph& graph) {
  const auto source = network.find("source");
  if (!source) return;
  if (source->is_string()) return read_vector(network, "source", graph.id, graph.source);
  if (source->is_array()) return read_source_list(*source, t_end, pores, graph);
  const Amount amount = read_amount(*source, t_end, graph);
  for (std::size_t k = 0; k < graph.nodes(); ++k) add_source(graph, k, amount);
}

/// Beside a table of nodes: lists of nodes whose values follow a table of time, or are not in it.
void read_lists(TomlTable& network, double t_end, Graph& graph) {
  for (const char* key : {"fixed", "source"})
    if (const auto value = network.find(key); value && !value->is_array())
      value->reject(fmt::format(
          "nodes has a column of that name; give a list of nodes beside it: {} = [ {{ ids, value }} ]", key));
  read_fixed(network, t_end, nullptr, graph);
  read_source(network, t_end, nullptr, graph);
}

/// A node that the file of initial values leaves out would start from 0; only where nothing depends on its
/// start it may be left out.
void require_initial(const TomlValue& file, const NodeVector& values, const Graph& graph) {
  for (std::size_t k = 0; k < graph.nodes(); ++k)
    if (!values.given[k] && !values.is_sparse && !graph.is_fixed[k] && graph.capacity[k] > 0)
      file.reject(fmt::format("the file has no value for node {}; every node that is not fixed needs one",
                              graph.id[k]));
}

/// What the files of nodes hold, for networks that come without one.
void read_node_keys(TomlTable& network, double t_end, const PoreNetwork* pores, Graph& graph) {
  if (pores == nullptr) read_vector(network, "capacity", graph.id, graph.capacity);
  for (std::size_t k = 0; k < graph.nodes(); ++k)
    if (!(graph.capacity[k] >= 0)) {
      const std::string rule = fmt::format("the capacity of node {} is {}; it must be >= 0 (J/K or F)",
                                           graph.id[k], graph.capacity[k]);
      if (const auto stated = network.find("capacity")) stated->reject(rule);
      throw InputError(fmt::format("{}: {}", network.where(), rule));  // an array
    }
  const auto initial = network.find("initial");
  const bool of_file = initial && initial->is_string();
  const NodeVector start = of_file ? read_vector_of(*initial, graph.id) : NodeVector{};
  if (of_file)
    graph.initial = start.value;
  else if (initial)
    graph.initial = read_initial(network, graph.id, nullptr);
  read_fixed(network, t_end, pores, graph);
  if (of_file) require_initial(*initial, start, graph);
  read_source(network, t_end, pores, graph);
}

NetworkInput read_pores(TomlTable& network, const TomlValue& file, double t_end) {
  const auto conductance = network.require("conductance", "it names the throats' column of conductances");
  const auto capacity = network.find("capacity");
  const bool by_column = capacity && capacity->is_string();
  PoreNetwork pores = read_named_file(file, [&](const auto& path) {
    return read_openpnm(path, conductance.string(), by_column ? capacity->string() : std::string{});
  });
  note_capacity(network, pores.input.notes);
  if (capacity && !by_column)
    pores.input.graph.capacity.assign(pores.input.graph.nodes(), capacity->number());
  read_node_keys(network, t_end, &pores, pores.input.graph);
  return std::move(pores.input);
}

/// Nodes and edges of a caller; the case says what the arrays do not.
NetworkInput take_arrays(TomlTable& network, const NetworkArrays& arrays, double t_end) {
  for (const char* key : {"nodes", "edges", "matrix", "openpnm"})
    if (const auto file = network.find(key))
      file->reject("the network is in memory already; leave this key out");
  const auto once = [&](const char* key, std::span<const double> array) {
    if (const auto value = network.find(key); value && !array.empty())
      value->reject("there is an array of them in memory; leave one of the two out");
  };
  once("capacity", arrays.capacity);
  once("source", arrays.source);
  once("initial", arrays.initial);
  once("fixed", arrays.fixed);
  NetworkInput input =
      network_of(arrays, network.file(), matrix_kind(network), network.number("ambient").value_or(0.0));
  read_node_keys(network, t_end, nullptr, input.graph);
  return input;
}

}  // namespace

NetworkInput read_network_files(TomlTable& network, double t_end, const NetworkArrays* arrays) {
  if (arrays) return take_arrays(network, *arrays, t_end);
  const auto matrix = network.find("matrix"), openpnm = network.find("openpnm"),
             nodes = network.find("nodes"), edges = network.find("edges");
  const int ways = (matrix ? 1 : 0) + (openpnm ? 1 : 0) + (edges ? 1 : 0);
  if (ways > 1) throw InputError(fmt::format("{}: give one of edges, matrix and openpnm", network.where()));
  if (openpnm) return read_pores(network, *openpnm, t_end);
  if (matrix) {
    const MatrixKind kind = matrix_kind(network);
    const double ambient = network.number("ambient").value_or(0.0);
    NetworkInput input =
        read_named_file(*matrix, [&](const auto& path) { return read_matrix_network(path, kind, ambient); });
    note_capacity(network, input.notes);
    read_node_keys(network, t_end, nullptr, input.graph);
    return input;
  }
  if (!edges)
    network.missing(
        "edges",
        "give nodes and edges (CSV with id,capacity,source,initial,fixed and i,j,conductance), a matrix, "
        "or openpnm");
  if (nodes) {
    NetworkInput input = read_named_file(*nodes, [&](const auto& of_nodes) {
      return read_named_file(*edges,
                             [&](const auto& of_edges) { return read_nodes_and_edges(of_nodes, of_edges); });
    });
    read_lists(network, t_end, input.graph);
    return input;
  }
  if (!network.find("capacity"))
    network.missing("capacity",
                    "key 'capacity' is missing, and edges have no capacities: give one number for all nodes "
                    "[J/K or F], a file with one for each, or nodes = a table with "
                    "id,capacity,source,initial,fixed");
  NetworkInput input = read_named_file(*edges, [](const auto& path) { return read_edge_list(path); });
  read_node_keys(network, t_end, nullptr, input.graph);
  return input;
}

}  // namespace superstep

#include "whole_cases.hpp"

#include <fmt/format.h>

#include "network/generators/network_generator.hpp"
#include "whole_case_files.hpp"

namespace superstep::test {
namespace {

Tree head() {
  return Tree::parse(R"({ "title": "whole", "source": "a test", "t_end": 1.0, "output_times": [0.5, 1.0] })");
}

/// One of each way to select, no particle twice.
Tree selections() {
  return Tree::parse(R"([
    { "ids": [13] },
    { "box": { "min": [-0.5, 1.0, 1.0], "max": [0.5, 2.5, 2.5] } },
    { "layer": { "side": "bottom", "thickness": 1.5 } },
    { "sphere": { "centre": [3.8, 1.9, 1.9], "radius": 0.5 } },
    { "cylinder": { "base": [1.9, 3.8, 1.5], "axis": [0, 0, 1], "radius": 0.5, "height": 1.0 } },
    "top" ])");
}

/// Tables of time from `value` on: in the case, which repeats, and in a file.
Tree listed_table(double value) {
  return {{"times", {0.0, 1.0}}, {"values", {value, value + 1}}, {"scale", 1.0}, {"period", 2.0}};
}
Tree table_in_file(double value) {
  return {{"file", "profile.csv"}, {"time", "t"}, {"value", "P"}, {"scale", value}, {"outside", "clamp"}};
}

/// An entry for each selection; the first two have tables of time.
Tree entries(const std::string& amount, double value, const Tree& more = Tree::object()) {
  Tree out = Tree::array();
  for (const auto& where : selections()) {
    Tree entry = {{"where", where}};
    entry[amount] = out.empty() ? listed_table(value) : out.size() == 1 ? table_in_file(value) : Tree(value);
    entry.update(more);
    out.push_back(entry);
  }
  return out;
}

Tree law(const std::string& kind, double value) {
  if (kind == "linear")
    return {
        {"law", kind}, {"value", value}, {"coefficient", 1e-4}, {"reference", 300.0}, {"outside", "error"}};
  if (kind == "sigmoid")
    return {{"law", kind},       {"value", value},     {"amplitude", 0.5},
            {"steepness", 0.05}, {"reference", 300.0}, {"outside", "clamp"}};
  return {{"law", "table"},
          {"temperatures", {0.0, 300.0, 2000.0}},
          {"values", {value, value, 2 * value}},
          {"outside", "clamp"}};
}

Tree thermal(const std::string& kind) {
  return {{"conductivity", law(kind, 10.0)},
          {"specific_heat", 100.0},
          {"initial", 300.0},
          {"fixed", Tree::array({{{"where", "top"}, {"value", 310.0}}})}};
}

Tree electric(const std::string& kind) {
  return {{"conductivity", law(kind, 1e3)},
          {"specific_capacity", 1e3},
          {"mode", "transient"},
          {"initial", 0.0},
          {"fixed", Tree::array({{{"where", "top"}, {"value", 1e-6}}})}};
}

Tree corpus() {
  return Tree::parse(R"({ "set": "quick", "class": "linear", "kind": "lattice", "purpose": "a test",
    "unknowns": 20, "stiffness": 1e3, "contrast": 10.0 })");
}

/// With the figures of a source and a benchmark.
Tree full_head() {
  Tree tree = head();
  tree["corpus"] = corpus();
  tree["published"] =
      Tree::parse(R"({ "particles": 27, "relative_density": 0.7, "effective_conductivity": 1.0,
    "lambda_max": 1.0, "lambda_min": 1.0, "critical_step": 1.0, "pair_step": 1.0, "alpha_star": 0.7 })");
  tree["bench"] = {{"baseline", "forward-euler"}, {"integrators", {"rkc"}}};
  return tree;
}

Tree fields() {
  Tree tree = full_head();
  tree["probe"] = {"mid-height", 13};
  tree["packing"] =
      Tree::parse(R"({ "file": "lattice.csv", "length_unit": "mm", "units": "auto", "format": "auto",
    "periodic": "none", "box": { "min": [-1.0, -1.0, -1.0], "max": [4.8, 4.8, 4.8] },
    "columns": ["id", "x", "y", "z", "radius"], "order": "bandwidth", "container": { "width": 5.8, "depth": 5.8, "height": 5.8 } })");
  tree["material"] = {{"density", 1000.0}};
  tree["contact"] = {{"neck", "plastic"}, {"hardening", 1.0},    {"conductance", "series"},
                     {"gap", 0.01},       {"bond_radius", 0.05}, {"bonds", "bonds.csv"}};
  tree["thermal"] = thermal("table");
  tree["thermal"]["initial"] = {{"column", "temperature"}, {"file", "start.csv"}};
  tree["thermal"]["grain_boundary"] = {{"thickness", 1e-7}, {"reduction", 0.2}};
  tree["thermal"]["fixed"] = entries("value", 310);
  tree["thermal"]["source"] = entries("value", 1e-3);
  tree["thermal"]["convection"] = entries("ambient", 300, {{"coefficient", 10.0}});
  tree["thermal"]["radiation"] = entries("ambient", 300, {{"emissivity", 0.5}, {"kelvin", true}});
  tree["electric"] = electric("table");
  tree["electric"]["grain_boundary"] = {{"thickness", 1e-7}, {"reduction", 0.2}};
  tree["electric"]["fixed"] = entries("value", 1e-6);
  tree["electric"]["source"] = entries("value", 1e-6);
  tree["electric"]["settle_tolerance"] = 1e-9;
  tree["electric"]["resolve_change"] = 1e-6;
  tree["coupling"] = {{"joule_heat", true}};
  return tree;
}

Tree generated(const Tree& packing, const std::string& kind) {
  Tree tree = head();
  tree["packing"] = packing;
  tree["material"] = {{"density", 1000.0}};
  tree["contact"] = {{"neck", "geometric"}};
  tree["thermal"] = thermal(kind);
  tree["electric"] = electric(kind);
  return tree;
}

/// Its one material has a name.
Tree generated_grid(const Tree& packing) {
  Tree tree = generated(packing, "linear");
  tree.erase("material");
  tree["materials"] = Tree::parse(R"([ { "name": "a", "density": 1000.0,
    "thermal": { "conductivity": 10.0, "specific_heat": 100.0 },
    "electric": { "conductivity": 1e3, "specific_capacity": 1e3 } } ])");
  tree["thermal"] = Tree::parse(R"({ "initial": 300.0, "fixed": [ { "where": "top", "value": 310.0 } ] })");
  tree["electric"] = Tree::parse(R"({ "initial": 0.0, "fixed": [ { "where": "top", "value": 1e-6 } ] })");
  return tree;
}

Tree materials() {
  Tree tree = head();
  tree["packing"] = {{"file", "named.csv"}, {"length_unit", "mm"}};
  tree["materials"] = Tree::array();
  for (const char* name : {"a", "b", "c"}) {
    const std::string kind = name[0] == 'a' ? "linear" : name[0] == 'b' ? "sigmoid" : "table";
    tree["materials"].push_back(
        {{"name", name},
         {"density", 1000.0},
         {"thermal", {{"conductivity", law(kind, 10)}, {"specific_heat", 100.0}}},
         {"electric", {{"conductivity", law(kind, 1e3)}, {"specific_capacity", 1e3}}}});
  }
  tree["interfaces"] = Tree::parse(R"([ { "between": ["a", "b"],
    "thermal": { "thickness": 1e-7, "reduction": 0.2 }, "electric": { "thickness": 1e-7, "reduction": 0.2 } } ])");
  tree["contact"] = {{"neck", "given"}, {"file", "necks.csv"}};
  tree["thermal"] = {{"initial", 300.0}};
  tree["electric"] = {{"initial", {{"column", "potential"}, {"file", "start.csv"}}}};
  return tree;
}

/// A material for each way to select, beside those that the packing names.
Tree selected() {
  Tree tree = materials();
  tree["contact"] = {{"neck", "geometric"}};
  for (const auto& where : selections()) {
    Tree one = tree["materials"][0];
    one["name"] = fmt::format("m{}", tree["materials"].size());
    one["where"] = where;
    tree["materials"].push_back(one);
  }
  return tree;
}

Tree lammps() {
  Tree tree = head();
  tree["packing"] = {
      {"file", "grains.data"}, {"length_unit", "mm"}, {"atom_style", "hybrid sphere"}, {"periodic", "xyz"}};
  tree["material"] = {{"density", 1000.0}};
  tree["contact"] = {{"neck", "geometric"}};
  tree["thermal"] = thermal("table");
  return tree;
}

Tree matrix() {
  Tree tree = head();
  tree["network"] =
      Tree::parse(R"({ "matrix": "K.mtx", "matrix_kind": "laplacian", "ambient": 1.0, "capacity": 1.0,
    "initial": { "column": "value", "file": "start4.csv" } })");
  for (const auto& [key, one, other] : {std::tuple("fixed", 1, 4), {"source", 2, 3}})
    tree["network"][key] = {{{"ids", {one}}, {"value", listed_table(1)}},
                            {{"ids", {other}}, {"value", table_in_file(2)}}};
  return tree;
}

Tree pores() {
  Tree tree = head();
  tree["network"] = Tree::parse(
      R"({ "openpnm": "pores.csv", "conductance": "throat.k", "capacity": "pore.volume", "initial": 0.0,
    "fixed": [ { "label": "pore.left", "value": 1.0 } ], "source": [ { "label": "pore.right", "value": 1.0 } ] })");
  return tree;
}

Tree network(const CaseFolder& folder) {
  (void)write_rod(folder, {.nodes = 5, .head = {}, .bench = {}});
  Tree tree = full_head();
  tree["probe"] = 2;
  tree["network"] = {{"nodes", "rod_nodes.csv"}, {"edges", "rod_edges.csv"}, {"field", "temperature"}};
  return tree;
}

Tree generated_network(Tree (*table)(double)) {
  Tree tree = full_head();
  tree["network"] = Tree::parse(R"({ "generator": "lattice", "size": 64, "contrast": 10.0, "spread": 2.0,
    "fraction": 0.1, "seed": 3, "field": "temperature", "initial": 0.5, "order": "file" })");
  const auto made = find_network_generator("lattice")->make(
      {.size = 64, .contrast = 10, .spread = 2, .fraction = 0.1, .seed = 3});
  tree["network"]["expect"] = network_hash(made);
  for (const char* key : {"inlet", "outlet", "source"}) tree["network"][key] = table(1);
  return tree;
}

Tree press() {
  Tree tree = head();
  tree["corpus"] = corpus();
  tree["t_end"] = 0.01;
  tree["output_times"] = {0.005, 0.01};
  tree["bench"] = Tree::parse(
      R"({ "baseline": "forward-euler", "integrators": ["rkc:rtol=1e-5"], "motion_window": [0.002, 0.004],
    "press_table": { "hold": [0.01], "upper_wall": [0.4], "seeds": [1, 2] } })");
  tree["material"] = {{"density", 2000.0}};
  tree["thermal"] = Tree::parse(R"({ "conductivity": 1e5, "specific_heat": 100.0, "initial": 300.0,
    "walls": { "lower": 1000.0, "upper": 900.0, "sides": 300.0 }, "walls_conduct": true })");
  tree["electric"] = Tree::parse(R"({ "model": "averaging", "conductivity": 0.1, "absorption": 0.5,
    "solver": "conjugate", "tolerance": 1e-10, "hold_temperature": true })");
  Tree law = Tree::parse(R"({ "stiffness": 1e7, "exponent": 2.0, "softening_temperature": 1500.0,
    "stiffness_floor": 5e6, "friction": 0.1, "friction_speed": 0.01, "damping": 0.2 })");
  tree["dynamics"] = Tree::parse(R"({ "gravity": 9.81, "drag": 0.1, "medium_velocity": [0.0, 0.0, 0.0],
    "skin": 0.01, "thermal_integrator": "staggered",
    "box": { "min": [0.0, 0.0, 0.0], "max": [0.4, 0.4, 0.5] },
    "particles": { "count": 6, "radius": 0.05, "seed": 3, "max_overlap": 0.0 },
    "bond": { "stiffness": 1e6, "exponent": 2.0, "threshold": 0.05, "rule": "overlap" },
    "phases": [ { "name": "press", "until": 0.01, "upper_wall": 0.45, "current": { "lower": 1e4, "upper": 1e4 } } ],
    "stepping": { "scheme": "staggered", "control": "steady", "phi": 0.5, "iterations": 10, "tolerance_position": 5e-4,
      "tolerance_temperature": 5e-4, "power": 2.0, "first_step": 0.001, "largest_step": 0.005,
      "smallest_step": 1e-9, "growth": 2.0, "shrink": 0.1, "fraction": 0.5 } })");
  tree["dynamics"]["contact"] = tree["dynamics"]["wall"] = law;
  return tree;
}

Tree press_of_a_list() {
  Tree tree = press();
  tree["bench"]["press_table"].erase("seeds");  // only generated particles have them
  tree["electric"]["model"] = "potential";
  tree["electric"]["saturation"] =
      Tree::parse(R"({ "thermal": 1.0, "thermal_slope": 0.01, "temperature": 500.0,
    "field": 0.5, "field_slope": 0.1, "reference_field": 1.0 })");
  tree["dynamics"]["phases"][0].erase("current");
  tree["dynamics"]["phases"][0]["potential"] = {{"lower", 0.0}, {"upper", 1.0}};
  tree["dynamics"]["bond"]["rule"] = "tension";
  tree["dynamics"]["bond"]["rupture"] = 0.05;
  tree["dynamics"]["particles"] = Tree::parse(R"({ "list": [
    { "position": [0.1, 0.1, 0.1], "radius": 0.05, "velocity": [0.0, 0.0, 0.1], "temperature": 400.0 },
    { "position": [0.3, 0.3, 0.3], "radius": 0.05 } ] })");
  return tree;
}

Tree press_with_necks() {
  Tree tree = press_of_a_list();
  tree["dynamics"]["bond"] = Tree::parse(R"({ "stiffness": 1e6, "threshold": 0.05, "rule": "rest-length",
    "rupture": 0.2, "unloading": 0.02, "damping": 0.1, "softening_temperature": 1500.0, "stiffness_floor": 1e5,
    "growth": { "mechanism": "coble", "rate": 1.0, "activation_energy": 1e5, "reference_temperature": 900.0,
      "sintering_stress": 1e6 } })");
  return tree;
}

/// Several materials take their numbers from the tables of all.
Tree press_of_materials(Tree tree) {
  tree.erase("material");
  for (const char* key : {"conductivity", "specific_heat"}) tree["thermal"].erase(key);
  tree["electric"].erase("conductivity");
  for (int k = 0; k < 2; ++k)
    tree["materials"].push_back(Tree::parse(R"({ "density": 2000.0, "hardness": 2.0, "share": 1.0,
      "thermal": { "conductivity": 1e5, "specific_heat": 100.0 }, "electric": { "conductivity": 0.1 } })"));
  tree["materials"][0]["name"] = "hard";
  tree["materials"][1]["name"] = "soft";
  return tree;
}

Tree press_of_sizes(const char* sizes) {
  Tree tree = press_of_materials(press());
  tree["dynamics"]["particles"].erase("radius");
  tree["dynamics"]["particles"]["sizes"] = Tree::parse(sizes);
  return tree;
}

Tree press_of_named() {
  Tree tree = press_of_materials(press_of_a_list());
  for (auto& one : tree["dynamics"]["particles"]["list"]) one["material"] = "soft";
  return tree;
}

Tree press_of_a_file() {
  Tree tree = press_with_necks();
  tree["dynamics"]["particles"] = Tree::parse(R"({ "file": "moved.csv", "length_unit": "mm",
    "velocity_unit": 0.1, "bonds": "moved_bonds.csv", "shift": [0.05, 0.05, 0.05], "max_overlap": 0.2 })");
  return tree;
}

}  // namespace

std::vector<WholeCase> whole_cases(const CaseFolder& folder) {
  write_files_of_cases(folder);
  const Tree cylinder = Tree::parse(R"({ "generator": "cylinder", "length_unit": "mm", "diameter": 4.0,
    "height": 5.0, "relative_density": 0.5, "count": 40, "seed": 2,
    "sizes": { "distribution": "lognormal", "min": 0.3, "max": 2.0, "sigma": 0.4, "median": 1.0 },
    "container": { "diameter": 4.0, "height": 5.0 } })");
  const Tree box = Tree::parse(R"({ "generator": "box", "length_unit": "mm", "width": 3.0, "depth": 3.0,
    "height": 4.0, "relative_density": 0.5, "seed": 2,
    "sizes": { "distribution": "uniform", "min": 0.8, "max": 1.2 } })");
  const Tree grid = Tree::parse(R"({ "generator": "grid", "length_unit": "mm", "count": 27, "spacing": 1.0,
    "jitter": 0.02, "seed": 2, "materials": ["a"], "shares": [1.0],
    "sizes": { "distribution": "uniform", "min": 1.05, "max": 1.1 } })");
  const Tree lattice = Tree::parse(R"({ "generator": "lattice", "length_unit": "mm", "cells": [3, 3, 3],
    "spacing": 1.9, "diameter": 2.0 })");
  Tree listed = box;
  listed["sizes"] = {{"distribution", "list"}, {"diameters", {0.8, 1.2}}, {"weights", {1.0, 2.0}}};
  return {{"fields", CaseKey::packing, fields()},
          {"materials", CaseKey::packing, materials()},
          {"cylinder", CaseKey::packing, generated(cylinder, "linear")},
          {"box", CaseKey::packing, generated(box, "sigmoid")},
          {"listed", CaseKey::packing, generated(listed, "table")},
          {"selected", CaseKey::packing, selected()},
          {"lammps", CaseKey::packing, lammps()},
          {"matrix", CaseKey::network, matrix()},
          {"pores", CaseKey::network, pores()},
          {"grid", CaseKey::packing, generated_grid(grid)},
          {"cubic", CaseKey::packing, generated(lattice, "linear")},
          {"network", CaseKey::network, network(folder)},
          {"generated", CaseKey::network, generated_network(listed_table)},
          {"driven", CaseKey::network, generated_network(table_in_file)},
          {"press", CaseKey::press, press()},
          {"list", CaseKey::press, press_of_a_list()},
          {"necks", CaseKey::press, press_with_necks()},
          {"sized", CaseKey::press, press_of_sizes(R"({ "distribution": "lognormal", "min": 0.06, "max": 0.12,
             "sigma": 0.2, "median": 0.09 })")},
          {"sizes", CaseKey::press,
           press_of_sizes(R"({ "distribution": "list", "diameters": [0.08, 0.1], "weights": [1.0, 2.0] })")},
          {"named", CaseKey::press, press_of_named()},
          {"moved", CaseKey::press, press_of_a_file()}};
}

}  // namespace superstep::test

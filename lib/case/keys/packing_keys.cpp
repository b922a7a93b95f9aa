/// Keys of cases that do not move, and those that every case has.

#include <iterator>

#include "case/corpus/corpus_tags.hpp"
#include "case/keys/key_list.hpp"
#include "contact/neck.hpp"
#include "network/generators/network_generator.hpp"
#include "packing/generate.hpp"
#include "packing/pack_checks.hpp"

namespace superstep {
namespace {

constexpr unsigned still = CaseKey::packing | CaseKey::network, all = still | CaseKey::press;

}  // namespace

void list_common_keys(KeyList& keys) {
  keys.in("", all);
  keys.text("title", "a name for tables and reports").fallback = "name of the file";
  keys.text("source", "where the scene comes from");
  keys.number("t_end", positive_number, "s", "end of the run");
  keys.numbers("output_times", 0, positive_number, "s", "ascending, none after t_end").fallback =
      "[t_end]; bench: 2, 10 and 100 % of it";
  keys.table("bench", "what `superstep bench` does");
  keys.in("bench", all);
  keys.text("baseline", "SPEC that speedups refer to");
  keys.list("integrators", CaseKey::text, "SPECs that are compared; left out = every family").may_be_empty =
      true;
  keys.in("bench", CaseKey::press);
  keys.numbers("motion_window", 2, no_less_than_zero, "s",
               "from when to when schemes of motion are compared");

  keys.in("", still);
  auto& probe =
      keys.text("probe", "nodes whose history is kept: mid-height, an id, or a list", {"mid-height"});
  probe.types |= CaseKey::integer | CaseKey::array;
  probe.elements = CaseKey::integer | CaseKey::text;
  probe.may_be_empty = true;
  keys.table("published", "figures of the source, printed beside ours");
  keys.in("published", still);
  for (const char* figure : {"particles", "relative_density", "effective_conductivity", "lambda_max",
                             "lambda_min", "critical_step", "pair_step", "alpha_star"})
    keys.number(figure, any_number, "", "as published");

  keys.in("", still).table("network", "nodes and edges given directly");
  keys.in("network", CaseKey::network);
  keys.text("nodes", "table with id,capacity,source,initial,fixed");
  keys.text("edges", "table with i,j,conductance");
  keys.text("matrix", "or a Matrix Market file");
  keys.text("matrix_kind", "what its off-diagonal entries are", {"auto", "laplacian", "conductance"})
      .fallback = "auto";
  keys.number("ambient", any_number, "K or V", "of surroundings, to which row sums of a Laplacian lead")
      .fallback = "0";
  keys.text("openpnm", "or a pore network in CSV or VTP");
  keys.text("conductance", "openpnm: the column of throats that conducts");
  keys.number("capacity", no_less_than_zero, "J/K or F",
              "without nodes: of all, or a file, or openpnm's column; left out = 1, but edges need it")
      .types = CaseKey::number | CaseKey::text;
  keys.initial("K or V", "without nodes: of all, the file of a vector, or a table as below; left out = 0",
               CaseKey::text);
  keys.list("fixed", CaseKey::table,
            "a list of nodes that are held; without nodes also a file of ids and values")
      .types = CaseKey::array | CaseKey::text;
  keys.in("network.fixed[]", CaseKey::network);
  keys.list("ids", CaseKey::integer, "nodes that are held");
  keys.text("label", "or pores with this label: openpnm");
  keys.amount("value", "K or V", "the value: a number, or a table of time");
  keys.in("network", CaseKey::network);
  keys.text("field", "what the values are", {"temperature", "potential"}).fallback = "temperature";
  keys.text("order", "of rows; file: under mpirun each process reads its part of nodes and edges",
            {"bandwidth", "file"})
      .fallback = "bandwidth";
  std::vector<std::string> generators;
  for (const auto& generator : network_generators()) generators.push_back(generator.name);
  keys.text("generator", "or a network that is made, the same bits everywhere", generators);
  keys.integer("size", {.min = 8, .max = static_cast<double>(largest_generated_network)},
               "generator: nodes, or what a whole grid has of them");
  keys.number("contrast", {.min = 1, .max = 1e12}, "",
              "generator: largest over smallest conductance, roughly")
      .fallback = "1";
  keys.number("spread", {.min = 1, .max = 1e12}, "", "generator: largest over smallest capacity").fallback =
      "1";
  keys.number("fraction", part, "", "generator: missing contacts, shortcuts, good grains, ...").fallback =
      "0";
  keys.integer("seed", no_less_than_zero, "generator: of the random numbers").fallback = "1";
  keys.text("expect", "generator: hash of the network; another one is an error");
  keys.amount("inlet", "K or V", "generator: value at the inlet; left out = not held");
  keys.amount("outlet", "K or V", "generator: value at the outlet; left out = not held");
  keys.amount("source", "W or A",
              "a list of nodes with sources; without nodes also of each node, or a file; generator: of every "
              "sixteenth node",
              CaseKey::text | CaseKey::array);
  keys.in("network.source[]", CaseKey::network);
  keys.list("ids", CaseKey::integer, "nodes that have the source, each of them");
  keys.text("label", "or pores with this label: openpnm");
  keys.amount("value", "W or A", "the source: a number, or a table of time");
}

void list_corpus_keys(KeyList& keys) {
  keys.in("", all).table("corpus", "what the case stands for in a corpus");
  keys.in("corpus", all);
  keys.text("set", "smallest set that holds it", {std::begin(corpus_sets), std::end(corpus_sets)});
  keys.text("class", "what it is about", {std::begin(corpus_classes), std::end(corpus_classes)});
  keys.text("kind", "of its network");
  keys.text("purpose", "one line: what it is for");
  keys.number("unknowns", positive_number, "", "entries of the state");
  keys.number("stiffness", positive_number, "", "t_end times the spectral radius");
  keys.number("contrast", positive_number, "", "largest over smallest rate of exchange").fallback = "1";
}

void list_sizes(KeyList& keys, const std::string& unit) {
  keys.table("sizes", "diameters");
  keys.text("sizes.distribution", "of the diameters", {"lognormal", "uniform", "list"});
  keys.number("sizes.min", positive_number, unit, "lognormal, uniform: smallest diameter");
  keys.number("sizes.max", positive_number, unit, "lognormal, uniform: largest diameter");
  keys.number("sizes.sigma", {.min = narrowest_sigma, .max = widest_sigma}, "",
              "lognormal: standard deviation of ln(diameter)");
  keys.number("sizes.median", positive_number, unit, "lognormal: median diameter");
  keys.numbers("sizes.diameters", 0, positive_number, unit, "list: the diameters");
  keys.numbers("sizes.weights", 0, positive_number, "", "list: number fractions").fallback = "equal";
}

void list_packing_keys(KeyList& keys) {
  keys.in("", CaseKey::packing).table("packing", "where the particles come from");
  keys.in("packing", CaseKey::packing);
  keys.text("file", "packing file: CSV, LAMMPS, LIGGGHTS, Yade, MercuryDPM, XYZ, VTK");
  keys.text("generator", "or a container that is filled, or a cubic lattice",
            {"cylinder", "box", "grid", "lattice"});
  keys.text("length_unit", "of the packing and of selections", {"m", "cm", "mm", "um", "nm"}).fallback =
      "what the file states, else m";
  keys.text("units", "unit style of the code that wrote the file",
            {"auto", "lj", "real", "metal", "si", "cgs", "electron", "micro", "nano"})
      .fallback = "auto: as the file says";
  keys.text("periodic", "sides of the box that are joined",
            {"auto", "none", "x", "y", "z", "xy", "xz", "yx", "yz", "zx", "zy", "xyz", "xzy", "yxz", "yzx",
             "zxy", "zyx"})
      .fallback = "auto: as the file says";
  keys.table("box", "the box of a file that states none");
  keys.numbers("box.min", 3, any_number, "length_unit", "one corner");
  keys.numbers("box.max", 3, any_number, "length_unit", "the other corner");
  keys.text("format", "of a file that cannot be told by its content", {"auto", "xyzd", "xyzr"}).fallback =
      "auto";
  keys.text("atom_style", "LAMMPS data: the order of the columns of Atoms, as in hybrid sphere bond");
  keys.list("columns", CaseKey::text, "names of the columns, for files that do not name them");
  keys.text("order", "of the rows: of small bandwidth, or in layers, which processes read for themselves",
            {"bandwidth", "layers"})
      .fallback = "bandwidth";
  keys.number("diameter", positive_number, "length_unit", "of a cylinder; lattice: of the spheres");
  keys.number("width", positive_number, "length_unit", "of a box");
  keys.number("depth", positive_number, "length_unit", "of a box");
  keys.number("height", positive_number, "length_unit", "of either");
  keys.number("relative_density", {.min = 0, .max = 0.9, .min_open = true}, "",
              "volume of the spheres over that of the container");
  keys.integer("count", {.min = 0, .max = static_cast<double>(largest_packing)},
               "lognormal: spheres, and the median follows; grid: spheres, or nearly")
      .fallback = "0: as many as the density asks for";
  keys.integer("seed", no_less_than_zero, "of the random numbers").fallback = "1";
  keys.number("spacing", positive_number, "length_unit", "grid, lattice: of the centres");
  keys.list("cells", CaseKey::integer, "lattice: spheres along x, y and z");
  keys.number("jitter", {.min = 0, .max = 0.5}, "", "grid: shift of the centres over the spacing").fallback =
      "0";
  keys.list("materials", CaseKey::text, "grid: names, drawn by chance");
  keys.numbers("shares", 0, positive_number, "", "grid: number fractions of the materials").fallback =
      "equal";
  list_sizes(keys, "length_unit");
  keys.table("container", "of the packing in the file: for its density and effective conductivity");
  keys.number("container.diameter", positive_number, "length_unit", "of a cylinder");
  keys.number("container.width", positive_number, "length_unit", "of a box");
  keys.number("container.depth", positive_number, "length_unit", "of a box");
  keys.number("container.height", positive_number, "length_unit", "of either");

  keys.in("", CaseKey::packing).table("contact", "necks between particles");
  keys.in("contact", CaseKey::packing);
  std::vector<std::string> laws = {"given"};
  for (const auto& law : neck_laws()) laws.push_back(law.name);
  keys.text("neck", "neck law, or given", laws);
  keys.text("file", "given: CSV with i,j,radius");
  keys.number("hardening", {.min = 0.5, .max = 1.45}, "", "plastic").fallback = "1.45";
  keys.number("gap", no_less_than_zero, "length_unit", "particles up to this far apart touch").fallback = "0";
  keys.number("bond_radius", positive_number, "length_unit",
              "least radius of a neck, and that of necks across a gap");
  keys.text("bonds", "table with i,j,radius: necks of its own beside those of the law");
  keys.text("conductance", "halves in series, or a pipe", {"series", "pipe"}).fallback = "series";

  keys.in("", CaseKey::packing | CaseKey::press).table("material", "one material");
  keys.in("material", CaseKey::packing | CaseKey::press);
  keys.number("density", positive_number, "kg/m3", "of the particles");

  keys.in("", CaseKey::packing).list("materials", CaseKey::table, "several materials, one table each");
  keys.in("materials[]", CaseKey::packing);
  keys.text("name", "as the packing says it");
  keys.where("where");
  keys.number("density", positive_number, "kg/m3", "of its particles");
  keys.table("thermal", "its conductivity and specific heat");
  keys.in("materials[].thermal", CaseKey::packing).conductivity("W/(m K)");
  keys.number("specific_heat", positive_number, "J/(kg K)", "of the material");
  keys.in("materials[]", CaseKey::packing).table("electric", "its conductivity and specific capacity");
  keys.in("materials[].electric", CaseKey::packing).conductivity("S/m");
  keys.number("specific_capacity", positive_number, "F/kg", "transient only");

  keys.in("", CaseKey::packing)
      .list("interfaces", CaseKey::table, "layers between two materials, one table each")
      .may_be_empty = true;
  keys.in("interfaces[]", CaseKey::packing);
  keys.list("between", CaseKey::text, "names of two materials").count = 2;
  keys.boundary("thermal", "the field's grain_boundary");
  keys.boundary("electric", "the field's grain_boundary");
}

}  // namespace superstep

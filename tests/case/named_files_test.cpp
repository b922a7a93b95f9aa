/// A file that a case names and that is not there, or none, or empty, is the fault of a key: the message
/// names both.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "case/case.hpp"
#include "core/error.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

/// A case with %s where it names the file, in line 2 of what follows the head.
struct Naming {
  std::string key, text;
};

std::string press(const std::string& particles) {
  return "[dynamics.particles]\n" + particles +
         "[material]\ndensity = 2000.0\n[thermal]\nconductivity = 1.0\nspecific_heat = 100.0\ninitial = "
         "300.0\n"
         "walls = 300.0\n[dynamics]\n[dynamics.box]\nmin = [-1.0, -1.0, -1.0]\nmax = [1.0, 1.0, 1.0]\n"
         "[dynamics.contact]\nstiffness = 1e7\n[dynamics.wall]\nstiffness = 1e7\n[dynamics.bond]\nstiffness "
         "= "
         "1e6\nthreshold = 0.1\n[[dynamics.phases]]\nname = \"rest\"\nuntil = 1.0\n";
}

const std::string material = "[material]\ndensity = 1000.0\n";
const std::string hertz = "[contact]\nneck = \"hertz\"\n";
const std::string thermal = "[thermal]\nconductivity = 1.0\nspecific_heat = 500.0\n";

const std::vector<Naming> namings = {
    {"packing.file", "[packing]\nfile = \"%s\"\n" + hertz + material + thermal},
    {"contact.file",
     "[contact]\nfile = \"%s\"\nneck = \"given\"\n[packing]\nfile = \"two.csv\"\n" + material + thermal},
    {"contact.bonds",
     "[contact]\nbonds = \"%s\"\nneck = \"hertz\"\n[packing]\nfile = \"two.csv\"\n" + material + thermal},
    {"thermal.initial.file",
     "[thermal]\ninitial = { column = \"T\", file = \"%s\" }\nconductivity = 1.0\n"
     "specific_heat = 500.0\n[packing]\nfile = \"two.csv\"\n" +
         hertz + material},
    {"thermal.fixed[0].value.file",
     "[thermal]\nfixed = [ { where = \"top\", value = { file = \"%s\" } } ]\nconductivity = "
     "1.0\nspecific_heat = "
     "500.0\n[packing]\nfile = \"two.csv\"\n" +
         hertz + material},
    {"network.nodes", "[network]\nnodes = \"%s\"\nedges = \"edges.csv\"\n"},
    {"network.edges", "[network]\nedges = \"%s\"\nnodes = \"nodes.csv\"\n"},
    {"network.edges", "[network]\nedges = \"%s\"\ncapacity = 1.0\n"},
    {"network.matrix", "[network]\nmatrix = \"%s\"\ncapacity = 1.0\n"},
    {"network.openpnm", "[network]\nopenpnm = \"%s\"\nconductance = \"throat.g\"\ncapacity = 1.0\n"},
    {"network.capacity", "[network]\ncapacity = \"%s\"\nedges = \"edges.csv\"\n"},
    {"network.source", "[network]\nsource = \"%s\"\nedges = \"edges.csv\"\ncapacity = 1.0\n"},
    {"network.initial", "[network]\ninitial = \"%s\"\nedges = \"edges.csv\"\ncapacity = 1.0\n"},
    {"network.fixed", "[network]\nfixed = \"%s\"\nedges = \"edges.csv\"\ncapacity = 1.0\n"},
    {"dynamics.particles.file", press("file = \"%s\"\n")},
    {"dynamics.particles.bonds", press("bonds = \"%s\"\nfile = \"two.csv\"\n")},
};

TEST(NamedFiles, ThatCannotBeReadAreTheFaultOfTheirKey) {
  const test::CaseFolder folder;
  folder.write("two.csv", "id,x,y,z,radius\n1,0,0,0,0.1\n2,0.5,0,0,0.1\n");
  folder.write("nodes.csv", "id,capacity,source,initial,fixed\n1,1,0,0,\n2,1,0,0,\n");
  folder.write("edges.csv", "i,j,conductance\n1,2,1\n");
  folder.write("empty.csv", " \n");
  folder.write("damaged.csv", "\x1f\x8b\x08 and nothing more");
  const std::array<std::array<const char*, 2>, 4> faults = {{{"missing.csv", "no such file"},
                                                             {".", "is a directory"},
                                                             {"empty.csv", "is empty"},
                                                             {"damaged.csv", "the gzip file is"}}};
  for (const auto& [key, text] : namings)
    for (const auto& [file, what] : faults) {
      std::string one = text;
      one.replace(one.find("%s"), 2, file);
      const auto path = folder.write("case.toml", "t_end = 1.0\n" + one);
      const auto message = test::message_of<InputError>([&] { (void)load_case(path); });
      EXPECT_TRUE(message.starts_with(fmt::format("{}:3: key '{}' names ", path, key))) << message;
      EXPECT_NE(message.find(std::string(file) + ": " + what), std::string::npos) << message;
    }
}

}  // namespace
}  // namespace superstep

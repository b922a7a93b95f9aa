#include "whole_case_files.hpp"

#include <fmt/format.h>

namespace superstep::test {
namespace {

/// 27 equal spheres of radius 1 mm, 1.9 mm apart; the middle layer has the ids 9 to 17.
void write_lattice(const CaseFolder& folder) {
  std::string plain = "id,x,y,z,radius\n", named = "id,x,y,z,radius,material\n", necks = "i,j,radius\n";
  for (int id = 0; id < 27; ++id) {
    const std::string row =
        fmt::format("{},{},{},{},1", id, 1.9 * (id % 3), 1.9 * (id / 3 % 3), 1.9 * (id / 9));
    plain += row + "\n";
    named += fmt::format("{},{}\n", row, "abc"[id / 9]);
    if (id >= 9) necks += fmt::format("{},{},0.3\n", id - 9, id);
  }
  folder.write("lattice.csv", plain);
  folder.write("named.csv", named);
  folder.write("necks.csv", necks);
  std::string start = "id,temperature,potential\n";
  for (int id = 0; id < 27; ++id) start += fmt::format("{},300.5,0.0\n", id);
  folder.write("start.csv", start);
  folder.write("bonds.csv", "i,j,radius\n0,1,0.2\n0,4,0.2\n");
  folder.write("profile.csv", "t,P\n0,1\n0.5,2\n0.5,1\n2,1\n");
}

/// Four spheres in a row, as LAMMPS writes them.
void write_grains(const CaseFolder& folder) {
  std::string text = "title\n\n4 atoms\n1 atom types\n\n0 9 xlo xhi\n0 9 ylo yhi\n0 9 zlo zhi\n\nAtoms\n\n";
  for (int id = 1; id <= 4; ++id) text += fmt::format("{} 1 4.5 4.5 {} 2.0 2500\n", id, 1.9 * id);
  folder.write("grains.data", text);
}

void write_networks(const CaseFolder& folder) {
  folder.write(
      "K.mtx",
      "%%MatrixMarket matrix coordinate real symmetric\n4 4 7\n1 1 1\n2 1 -1\n2 2 2.5\n3 2 -1\n3 3 2\n"
      "4 3 -1\n4 4 1\n");
  folder.write("start4.csv", "id,value\n1,0\n2,1\n3,2\n4,3\n");
  folder.write("pores.csv",
               "pore.coords[0],pore.left,pore.right,pore.volume,throat.conns[0],throat.conns[1],throat.k\n"
               "0,True,False,1,0,1,2\n1,False,False,2,1,2,3\n2,False,True,3,,,\n");
}

/// Two particles of a press that touch, and the bond between them.
void write_press(const CaseFolder& folder) {
  folder.write(
      "moved.csv",
      "id,x,y,z,radius,vx,vy,vz,temperature\n7,100,100,100,50,0,0,1,400\n9,190,100,100,50,0,0,0,500\n");
  folder.write("moved_bonds.csv", "i,j,overlap,growth\n7,9,0.12,0.5\n");
}

}  // namespace

void write_files_of_cases(const CaseFolder& folder) {
  write_lattice(folder);
  write_grains(folder);
  write_networks(folder);
  write_press(folder);
}

}  // namespace superstep::test

/// Necks and bonds of a file that can hardly be those of the packing are taken, and warned of.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "case/scene.hpp"
#include "support/case_texts.hpp"

namespace superstep {
namespace {

class GivenNecks : public test::CaseTexts {
 protected:
  /// Warnings of a row of four spheres, 2 mm wide and up to 3 mm apart, with these necks in mm.
  std::string said(const std::string& necks, const std::string& contact = "neck = \"given\"\nfile",
                   const std::string& packing = "") {
    folder_.write("row.csv", "id,x,y,z,r\n1,0,0,0,1\n2,0,0,1.98,1\n3,0,0,3.96,1\n4,0,0,6.96,1\n");
    folder_.write("necks.csv", "i,j,radius\n" + necks);
    const Scene scene = load("t_end = 100\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n" + packing +
                             "[contact]\n" + contact +
                             " = \"necks.csv\"\n[material]\ndensity = 2500\n"
                             "[thermal]\nconductivity = 1.0\nspecific_heat = 800\n");
    return fmt::format("{}", fmt::join(scene.warnings, "\n"));
  }
};

TEST_F(GivenNecks, WiderThanTheirParticlesAreSaid) {
  EXPECT_EQ(said("1,2,1\n2,3,0.8\n3,4,1\n").find("wider than"), std::string::npos);
  const auto wide = said("1,2,1\n2,3,5\n3,4,1\n");
  EXPECT_NE(wide.find("1 of 3 necks of necks.csv are wider than"), std::string::npos) << wide;
  EXPECT_NE(wide.find("the first in line 3: 5 beside a radius of"), std::string::npos) << wide;
}

TEST_F(GivenNecks, OfParticlesFarFromEachOtherAreSaid) {
  for (const char* contact : {"neck = \"given\"\nfile", "neck = \"hertz\"\nbonds"}) {
    EXPECT_EQ(said("1,2,0.5\n3,4,0.5\n", contact).find("far from"), std::string::npos)
        << "a gap of half a width";
    const auto far = said("1,2,0.5\n4,1,0.5\n", contact);
    EXPECT_NE(
        far.find("1 of 2 necks of necks.csv join particles far from each other, the first in line 3: 6.96 "
                 "from centre to centre beside radii of 2 together"),
        std::string::npos)
        << far;
  }
  const std::string ring =
      "periodic = \"z\"\nbox = { min = [-1, -1, -1], max = [1, 1, 8] }\n";  // 2.04 mm across the joined side
  EXPECT_EQ(said("1,2,0.5\n4,1,0.5\n", "neck = \"given\"\nfile", ring).find("far from"), std::string::npos);
}

}  // namespace
}  // namespace superstep

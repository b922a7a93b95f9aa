/// Boxes of packings: where unwrapped positions belong, and positions against the box.

#include <gtest/gtest.h>

#include "support/packing_text.hpp"

namespace superstep {
namespace {

using test::expect_says;
using test::read_as;
using test::refusal;

std::string dump_of(const std::string& columns, const std::string& rows,
                    const std::string& sides = "pp pp pp") {
  return "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n4\nITEM: BOX BOUNDS " + sides +
         "\n0 4\n0 4\n0 4\nITEM: ATOMS " + columns + "\n" + rows;
}

TEST(Boxes, UnwrappedPositionsArePutBackBeforeSidesAreCut) {
  const std::string wrapped = dump_of("id x y z radius",
                                      "1 2 2 0.5 0.55\n2 2 2 1.5 0.55\n3 2 2 2.5 0.55\n4 2 2 3.5 0.55\n"),
                    unwrapped =
                        dump_of("id xu yu zu radius",
                                "1 2 2 0.5 0.55\n2 2 -2 9.5 0.55\n3 2 2 -5.5 0.55\n4 10 2 3.5 0.55\n"),
                    parts = dump_of("id xsu ysu zsu radius",
                                    "1 0.5 0.5 0.125 0.55\n2 0.5 0.5 1.375 0.55\n3 0.5 1.5 0.625 0.55\n"
                                    "4 0.5 0.5 -0.125 0.55\n");
  for (const char* periodic : {"auto", "none", "x", "xz", "xyz"}) {
    PackingOptions options;
    options.periodic = periodic;
    const auto inside = read_as("a.dump", wrapped, options);
    for (const auto& other : {unwrapped, parts}) {
      const auto packing = read_as("a.dump", other, options);
      for (std::size_t k = 0; k < 4; ++k)
        EXPECT_LT(norm(packing.centre[k] - inside.centre[k]), 1e-12) << periodic << " " << k;
    }
  }
  const auto open = read_as(
      "a.dump", dump_of("id xu yu zu radius",
                        "1 2 2 0.5 0.55\n2 2 2 1.5 0.55\n3 2 2 5.5 0.55\n4 2 2 3.5 0.55\n", "pp pp ff"));
  EXPECT_EQ(open.centre[2].z, 5.5) << "along a side that the file calls open they are where they are";
}

TEST(Boxes, PositionsAreHeldAgainstStatedOnes) {
  expect_says(refusal("# cell = \"100 100 100 4 0 0 0 4 0 0 0 4\"\n# periodic = \"xyz\"\nx,y,z,radius\n"
                      "0,0,0,0.55\n0,0,1,0.55\n"),
              {"p.txt:4:", "far outside the box", "that the file states"});
  PackingOptions options;
  options.box = box_cell({100, 100, 100}, {104, 104, 104});
  expect_says(refusal("id,x,y,z,radius\n7,0,0,0,0.55\n", options),
              {"particle 7", "far outside the box", "[packing] box"});
  options.box = box_cell({0, 0, 0}, {4, 4, 4});
  EXPECT_TRUE(test::warns(read_as("a.csv", "x,y,z,radius\n0,0,5,0.55\n", options), "[packing] box"));
}

TEST(Boxes, AWrongCommentOfACellIsCalledWhatItIs) {
  const auto complaint = [](const std::string& cell) {
    return refusal("x,y,z,radius\n# cell = " + cell + "\n0,0,0,1\n");
  };
  expect_says(complaint("\"0 0 0 1 0 0\""), {"p.txt:2: the comment '# cell' has 6 numbers", "ox oy oz ax"});
  expect_says(complaint("0 0 0 1 0 0 0 b 0 0 0 1"), {"p.txt:2: the comment '# cell' has 'b', which is no"});
}

}  // namespace
}  // namespace superstep

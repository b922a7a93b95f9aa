/// What files state of their columns and units is used, or refused; it is never read as if it did not stand
/// there.

#include <gtest/gtest.h>

#include "case/scene.hpp"
#include "core/error.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

class StatedUnits : public testing::Test {
 protected:
  void expect_refused(const std::string& text, const std::string& part) {
    const auto message =
        test::message_of<InputError>([&] { (void)load_scene(folder_.write("c.toml", text)); });
    EXPECT_NE(message.find(part), std::string::npos) << "wanted: " << part << "\n   got: " << message;
  }
  Packing packing(const std::string& text) { return read_packing(folder_.write("p.txt", text)); }
  void expect_no_packing(const std::string& text, const std::string& part) {
    const auto message = test::message_of<InputError>([&] { (void)packing(text); });
    EXPECT_NE(message.find(part), std::string::npos) << "wanted: " << part << "\n   got: " << message;
  }
  /// Three nodes in a row.
  std::string chain(const std::string& edges, const std::string& keys = {}) {
    folder_.write("e.csv", edges);
    return "t_end = 1\n[network]\nedges = \"e.csv\"\ncapacity = 1\n" + keys + "\n";
  }
  test::TemporaryFolder folder_;
  const std::string rows_ = "0 0 0 0.55\n0 0 1 0.55\n0 0 2 0.55\n";
  const std::string edges_ = "i,j,conductance\n1,2,1\n2,3,1\n";
};

TEST_F(StatedUnits, ACommentThatNamesTheColumnsIsTheirHeader) {
  for (const char* header : {"# x y z diameter\n", "# x y z diameter\n# 3 particles\n", "#x,y,z,diameter\n"})
    EXPECT_EQ(packing(header + rows_).radius[1], 0.275) << header;
  for (const char* header : {"# x [mm] y [mm] z [mm] r [mm]\n", "# x (mm) y (mm) z (mm) r (mm)\n"})
    EXPECT_EQ(packing(header + rows_).radius[1], 0.55e-3) << header;
  for (const char* remark : {"# packing of copper balls\n", "# made by hand\n", "# r\n"})
    EXPECT_EQ(packing(remark + rows_).radius[1], 0.55) << remark;
  EXPECT_EQ(packing("# x y z r\n# packing of copper balls\n" + rows_).radius[1], 0.55);
}

TEST_F(StatedUnits, HalfAHeaderIsRefused) {
  for (const char* header :
       {"# r x y z, all in m\n", "# x y z r in mm\n", "# x, y, z and the diameter in mm\n"})
    expect_no_packing(header + rows_, "p.txt:1: the comment");
  expect_no_packing("# x y z diameter (all in mm)\n" + rows_, "the header 'x y z diameter (all in mm)'");
}

TEST_F(StatedUnits, LengthUnitsMayStandBelowTheHeaderAndBeWrittenInSeveralWays) {
  for (const char* head : {"x y z r\n# length_unit = \"mm\"\n", "# length_unit: mm\nx y z r\n",
                           "#Length_Unit = \"mm\"\nx y z r\n", "% length_unit = mm\nx y z r\n"})
    EXPECT_EQ(packing(head + rows_).radius[1], 0.55e-3) << head;
}

TEST_F(StatedUnits, OfNecksAreThoseOfTheirFile) {
  folder_.write("p.csv", "x,y,z,r\n0,0,0,0.55\n0,0,1,0.55\n");
  const auto neck = [&](const std::string& content) {
    folder_.write("n.csv", content);
    const Scene scene = load_scene(folder_.write(
        "c.toml",
        "t_end = 1\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = "
        "2500\n[contact]\n"
        "neck = \"given\"\nfile = \"n.csv\"\n[thermal]\nconductivity = 1.0\nspecific_heat = 800\n"));
    return scene.packed->contacts.neck_radius[0];
  };
  EXPECT_EQ(neck("i,j,radius\n0,1,0.2\n"), 0.2e-3);
  EXPECT_EQ(neck("# length_unit = \"m\"\ni,j,radius\n0,1,2e-4\n"), 2e-4);
  EXPECT_EQ(neck("i,j,radius [um]\n0,1,200\n"), 200 * 1e-6);
  EXPECT_EQ(neck("# i j radius [um]\n0 1 200\n"), 200 * 1e-6);
  const auto refusal =
      test::message_of<InputError>([&] { (void)neck("# length_unit = \"m\"\ni,j,radius [um]\n0,1,200\n"); });
  EXPECT_NE(refusal.find("keep one"), std::string::npos) << refusal;
}

TEST_F(StatedUnits, OfEdgesAndNodesAreSI) {
  expect_refused(chain("# i j conductance [mS]\n1 2 1\n2 3 1\n"),
                 "e.csv:1: column 'conductance [mS]' is in mS");
  expect_refused(chain("i,j,conductance [mS]\n1,2,1\n2,3,1\n"), "e.csv:1: column");
  const auto scene = load_scene(folder_.write("c.toml", chain("# my edge list\n1 2 5\n2 3 5\n")));
  EXPECT_EQ(scene.fields[0].graph.conductance[0], 5);
}

TEST_F(StatedUnits, VectorsOfNodesObeyTheirHeader) {
  const auto fixed = [&](const std::string& content) {
    folder_.write("f.csv", content);
    return chain(edges_, "fixed = \"f.csv\"");
  };
  for (const char* content : {"id,value\n1,2\n2,1\n", "value,id\n2,1\n1,2\n", "id value\n1 2\n2 1\n"}) {
    const auto scene = load_scene(folder_.write("c.toml", fixed(content)));
    EXPECT_EQ(scene.fields[0].graph.fixed_value[0], 2) << content;
    EXPECT_EQ(scene.fields[0].graph.fixed_value[1], 1) << content;
  }
  expect_refused(fixed("id,value [mV]\n1,1000\n3,0\n"), "f.csv:1: column 'value [mV]' is in mV");
  expect_refused(fixed("node,value\n1,1000\n3,0\n"), "one of its two columns must be called id");
  folder_.write("c.csv", "capacity [kJ/K]\n1\n1\n1\n");
  expect_refused("t_end = 1\n[network]\nedges = \"e.csv\"\ncapacity = \"c.csv\"\n", "is in kJ/K");
}

TEST_F(StatedUnits, OfProfilesAreReadFromTheirNames) {
  const auto profile = [&](const std::string& content, const std::string& keys = "") {
    folder_.write("p.csv", content);
    return chain(edges_, "fixed = [{ ids = [1], value = { file = \"p.csv\"" + keys + " } }]");
  };
  for (const char* time : {"time [ms]", "time_ms", "time/ms", "time (min)"}) {
    const std::string content = std::string(time) + ",value\n0,0\n1,1\n";
    expect_refused(profile(content, std::string(", time = \"") + time + "\""), "times must be in s");
  }
  expect_refused(profile("# time [ms] value [K]\n0 0\n1 1\n"), "times must be in s");
  expect_refused(profile("time,value [mK]\n0,0\n1,1\n"), "is in mK; values must be in");
  const auto scene = load_scene(folder_.write("c.toml", profile("# my profile\n0 0\n1 1\n")));
  EXPECT_EQ(scene.fields[0].graph.tables.size(), 1u);
}

}  // namespace
}  // namespace superstep

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

TEST_F(StatedUnits, SignsAndOtherNamesDoNotHideAHeader) {
  for (const char* header : {"## x y z diameter\n", "#! x y z diameter\n", "# columns: x y z diameter\n",
                             "#1:x 2:y 3:z 4:diameter\n", "# x | y | z | diameter\n", "# x,y,z,diameter,\n",
                             "# x, y, z, diameter\n"})
    EXPECT_EQ(packing(header + rows_).radius[1], 0.275) << header;
  for (const char* header : {"# cx cy cz diameter\n", "# rx ry rz d\n", "# x[0] x[1] x[2] d\n"})
    expect_no_packing(header + rows_, "is missing from the header");
  const Packing more =
      packing("# id x y z r vx vy vz wx wy wz\n1 0 0 0 .55 1 2 3 4 5 6\n2 0 0 1 .55 1 2 3 4 5 6\n");
  EXPECT_EQ(more.attributes.size(), 6u);
  EXPECT_EQ(packing("# id x y z r vx vy vz\n0 0 0 0 .5 1 1 1\n1 0 0 1 .5 1 1 1\n").size(), 2u)
      << "no MercuryDPM";
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
  for (const char* head : {"id,T_C\n", "# id T_degC\n", "id,temperature_C\n"})
    expect_refused(fixed(head + std::string(head[0] == '#' ? "1 20\n3 0\n" : "1,20\n3,0\n")),
                   "f.csv:1: column");
  for (const char* head : {"id,T_kelvin\n", "id,T_max\n"})
    EXPECT_NO_THROW((void)load_scene(folder_.write("c.toml", fixed(head + std::string("1,20\n3,0\n")))));
  expect_refused(fixed("node,value\n1,1000\n3,0\n"), "one of its two columns must be called id");
  folder_.write("c.csv", "capacity [kJ/K]\n1\n1\n1\n");
  expect_refused("t_end = 1\n[network]\nedges = \"e.csv\"\ncapacity = \"c.csv\"\n", "is in kJ/K");
}

TEST_F(StatedUnits, ProseIsNoHeader) {
  const auto value = [&](const std::string& content, const std::string& keys = "") {
    folder_.write("p.csv", content);
    const Scene scene = load_scene(folder_.write(
        "c.toml", chain(edges_, "fixed = [{ ids = [1], value = { file = \"p.csv\"" + keys + " } }]")));
    return scene.fields[0].graph.tables[0].value.back();
  };
  for (const char* prose : {"# Time series\n", "# measured value\n", "# time value\n# Fixed value\n"})
    EXPECT_EQ(value(std::string(prose) + "0 0\n1 5\n"), 5) << prose;
  EXPECT_EQ(value("# time a b c value\n0 7 7 7 0\n1 7 7 7 5\n"), 5);
  EXPECT_EQ(value("# t T1 T2 T3 T4\n0 0 0 0 0\n1 1 2 5 4\n", ", time = \"t\", value = \"T3\""), 5);
  EXPECT_EQ(value("time,T_min\n0,300\n1,305\n", ", value = \"T_min\""), 305) << "no minutes";
  EXPECT_EQ(value("t,T\n0,300\n1,305\n", ", time = \"t\", value = \"T\""), 305);
  folder_.write("f.csv", "# node id\n1 3\n2 1\n");
  const auto scene = load_scene(folder_.write("c.toml", chain(edges_, "fixed = \"f.csv\"")));
  EXPECT_EQ(scene.fields[0].graph.fixed_value[0], 3);
  folder_.write("i.csv", "# id temperature\n# final state\n1 4\n2 5\n3 6\n");
  const auto initial = load_scene(
      folder_.write("c.toml", chain(edges_, "initial = { file = \"i.csv\", column = \"temperature\" }")));
  EXPECT_EQ(initial.fields[0].graph.initial[2], 6);
}

TEST_F(StatedUnits, NamesThatDifferInCaseAreTakenAsWritten) {
  folder_.write("i.csv", "id,t,T\n1,0,300\n2,0,400\n3,0,500\n");
  const std::string from = "initial = { file = \"i.csv\", column = ";
  const auto start = [&](const char* column) {
    return load_scene(folder_.write("c.toml", chain(edges_, from + column + " }")))
        .fields[0]
        .graph.initial[1];
  };
  EXPECT_EQ(start("\"T\""), 400);
  folder_.write("i.csv", "id,t,T [K]\n1,0,300\n2,0,400\n3,0,500\n");
  EXPECT_EQ(start("\"T\""), 400);
  folder_.write("i.csv", "id,TEMP,Temp\n1,0,300\n2,0,400\n3,0,500\n");
  expect_refused(chain(edges_, from + "\"temp\" }"), "may be column 'TEMP' or 'Temp'");
}

TEST_F(StatedUnits, OfProfilesAreReadFromTheirNames) {
  const auto profile = [&](const std::string& content, const std::string& keys = "") {
    folder_.write("p.csv", content);
    return chain(edges_, "fixed = [{ ids = [1], value = { file = \"p.csv\"" + keys + " } }]");
  };
  for (const char* time : {"time [ms]", "time_ms", "time/ms", "time (min)", "ms", "hours", "time-ms", "t.ms",
                           "t:ms", "t|ms", "time_milliseconds"}) {
    const std::string content = std::string(time) + ",value\n0,0\n1,1\n";
    expect_refused(profile(content, std::string(", time = \"") + time + "\""), "times must be in s");
  }
  expect_refused(profile("# time [ms] value [K]\n0 0\n1 1\n"), "times must be in s");
  expect_refused(profile("## time [ms] value\n0 0\n1 1\n"), "times must be in s");
  expect_refused(profile("# t [ms] T [K]\n0 0\n1 1\n"), "there is no column 'time'");
  expect_refused(profile("time,T_C\n0,0\n1,1\n", ", value = \"T_C\""), "'T_C' is in C");
  for (const char* head : {"# time_ms value\n", "# time value_mW\n", "# t_ms T\n", "# t T_C\n"})
    expect_refused(profile(head + std::string("0 0\n1 1\n")), "p.csv:1");
  expect_refused(profile("time,value [mK]\n0,0\n1,1\n"), "is in mK; values must be in");
  for (const char* value : {"degC", "celsius", "kW", "P-kW", "P_GW", "I_uA", "T (F)", "T (m)", "T [-]"}) {
    const std::string content = std::string("time,") + value + "\n0,0\n1,1\n";
    const std::string key = std::string(", value = \"") + value + "\"";
    expect_refused(profile(content, key), "values must be in K, V, W or A");
    EXPECT_NO_THROW((void)load_scene(folder_.write("c.toml", profile(content, key + ", scale = 2.0"))));
  }
  for (const char* value : {"T (K)", "U [V]", "P_W", "I [A]", "min", "x.y", "T_mean"}) {
    const std::string content = std::string("time,") + value + "\n0,0\n1,1\n";
    EXPECT_NO_THROW((void)load_scene(
        folder_.write("c.toml", profile(content, std::string(", value = \"") + value + "\""))))
        << value;
  }
  const auto scene = load_scene(folder_.write("c.toml", profile("# my profile\n0 0\n1 1\n")));
  EXPECT_EQ(scene.fields[0].graph.tables.size(), 1u);
}

}  // namespace
}  // namespace superstep

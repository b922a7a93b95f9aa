/// What `superstep info FILE` and `superstep init` say and write, as a user meets them.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "case/scene.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;

class FileReport : public testing::Test {
 protected:
  int run(const std::string& arguments) {
    const std::string command = fmt::format("cd '{}' && '{}' {} >stdout.txt 2>stderr.txt", folder_.file("."),
                                            SUPERSTEP_PROGRAM, arguments);
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string out() const { return folder_.read("stdout.txt"); }
  std::string err() const { return folder_.read("stderr.txt"); }
  void expect_out(const std::string& part) {
    EXPECT_NE(out().find(part), std::string::npos) << part << " in\n" << out();
  }
  /// 4 x 4 x 5 spheres on a lattice that overlap by 5 %, in a box that is periodic along x and y, or along
  /// all axes.
  void write_dump(const char* flags) {
    std::string text = fmt::format(
        "ITEM: TIMESTEP\n7\nITEM: NUMBER OF ATOMS\n80\nITEM: BOX BOUNDS {}\n0 7.6e-3\n0 7.6e-3\n0 9.5e-3\n"
        "ITEM: ATOMS id type x y z radius f_T\n",
        flags);
    for (int k = 0; k < 80; ++k)
      text += fmt::format("{} 1 {} {} {} 1e-3 {}\n", k + 1, 1e-3 + 1.9e-3 * (k % 4),
                          1e-3 + 1.9e-3 * (k / 4 % 4), 1e-3 + 1.9e-3 * (k / 16), 300 + k);
    folder_.write("p.dump", text);
  }
  CaseFolder folder_;
};

TEST_F(FileReport, KnowsTablesWithAHeaderOfAnyKind) {
  for (const char* header :
       {"id,x,y,z,radius\n", "# id,x,y,z,radius\n", "\"id\",\"x\",\"y\",\"z\",\"radius\"\n", ""}) {
    folder_.write("p.csv", std::string(header) + "1,0.05,0.05,0.01,0.0102\n2,0.05,0.05,0.03,0.0102\n");
    ASSERT_EQ(run("info p.csv"), 0) << header << err();
    expect_out("particles                          2");
  }
  folder_.write("edges.csv", "i,j,conductance\n0,1,2.0\n1,2,3.0\n");
  ASSERT_EQ(run("info edges.csv"), 0) << err();
  expect_out("edge list");
}

TEST_F(FileReport, SaysWhatAPackingIsAndHowItConducts) {
  write_dump("pp pp pp");
  ASSERT_EQ(run("info p.dump"), 0) << err();
  expect_out("LAMMPS/LIGGGHTS dump");
  expect_out("periodic along");
  expect_out("f_T");
  ASSERT_EQ(run("info p.dump --conductivity 85 --density 5910 --axis z --json"), 0) << err();
  const auto json = nlohmann::json::parse(out());
  EXPECT_EQ(json["particles"], 80);
  EXPECT_EQ(json["conduction"]["coordination"], 6.0) << "a cubic lattice, across its sides too";
  EXPECT_EQ(json["conduction"]["components"], 1);
  // A lattice conducts as one contact over its spacing: K / a, the same along every axis.
  const double along_z = json["conduction"]["effective_conductivity_periodic"];
  ASSERT_EQ(run("info p.dump --conductivity 85 --density 5910 --axis x --json"), 0) << err();
  EXPECT_NEAR(
      nlohmann::json::parse(out())["conduction"]["effective_conductivity_periodic"].get<double>() / along_z,
      1, 1e-9);
  // Cut open, between the centres of the layers at both ends: the same conductance, over the same
  // cross-section.
  EXPECT_NEAR(json["conduction"]["effective_conductivity"].get<double>() / along_z, 1, 1e-9);
  const std::string recommended = json["conduction"]["recommended"];
  EXPECT_NE(recommended.find(" for an error of 0.0001 of the span is the work of about"), std::string::npos)
      << recommended;
  ASSERT_EQ(run("info p.dump --conductivity 85 --density 5910 --axis z"), 0) << err();
  expect_out("over the whole periodic cell: 0.0095 m along z, cross-section 5.776e-05 m2\n");
  expect_out(
      "over 0.0076 m along z, from centre to centre of the innermost particles held; cross-section 5.776e-05 "
      "m2 "
      "of the periodic cell\n");
  EXPECT_NEAR(json["conduction"]["cross_section_m2"].get<double>(), 5.776e-5, 1e-15);
  EXPECT_NEAR(json["conduction"]["length_m"].get<double>(), 7.6e-3, 1e-12);
  write_dump("ff ff ff");
  ASSERT_EQ(run("info p.dump --conductivity 85"), 0) << err();
  expect_out(
      "over 0.0076 m along z, from centre to centre of the innermost particles held; cross-section 5.929e-05 "
      "m2 "
      "of the bounding box of all surfaces\n");
  EXPECT_EQ(out().find("container"), std::string::npos) << "there is no case to state one in: " << out();
}

/// Two particles at either end of a gap, one pair of them in touch or none.
TEST_F(FileReport, NothingConductsWhereNoPathOfContactsLeads) {
  for (const char* rows : {"1,0,0,0.01,0.005\n2,0,0,0.03,0.005\n3,0,0,0.05,0.005\n",
                           "1,0,0,0.01,0.005\n2,0,0,0.0195,0.005\n3,0,0,0.05,0.005\n4,0,0,0.0595,0.005\n"}) {
    folder_.write("p.csv", std::string("id,x,y,z,radius\n") + rows);
    ASSERT_EQ(run("info p.csv --conductivity 85 --axis z"), 0) << err();
    expect_out("0 W/(m K); no path of contacts from side to side");
    expect_out("[contact] gap");
    EXPECT_EQ(out().find("out of memory"), std::string::npos) << out();
    EXPECT_EQ(out().find("recommended"), std::string::npos) << out();
    ASSERT_EQ(run("info p.csv --conductivity 85 --axis z --json"), 0) << err();
    const auto conduction = nlohmann::json::parse(out())["conduction"];
    EXPECT_EQ(conduction["effective_conductivity"], 0.0);
    EXPECT_TRUE(conduction["recommended"].is_null() && conduction["transit_time_s"].is_null());
  }
}

TEST_F(FileReport, ACaseWithoutContactsIsDescribedInNumbers) {
  folder_.write("p.csv", "id,x,y,z,radius\n1,0,0,0.01,0.005\n2,0,0,0.03,0.005\n3,0,0,0.05,0.005\n");
  ASSERT_EQ(run("init p.csv -o case.toml"), 0) << err();
  ASSERT_EQ(run("info case.toml"), 0) << err();
  expect_out("0 W/(m K) (no path of contacts");
  expect_out("nothing conducts");
  EXPECT_EQ(out().find("nan"), std::string::npos) << out();
}

TEST_F(FileReport, StarterCasesOfFewParticlesAndOfColumnsWithGapsRun) {
  const char* const packings[] = {
      "x,y,z,radius\n0,0,0,1e-3\n0,0,1.9e-3,1e-3\n",                            // nothing between the ends
      "x,y,z,radius\n0,0,0,1e-3\n0,0,9e-3,1e-3\n",                              // nor any contact
      "x,y,z,radius\n0,0,0,1e-3\n1.9e-3,0,0,1e-3\n0,0,9e-3,1e-3\n",             // two in one layer
      "x,y,z,radius,T\n0,0,0,1e-3,300\n0,0,1.9e-3,1e-3,nan\n0,0,4e-3,1e-3,1\n"  // no temperature of one
  };
  int number = 0;
  for (const char* packing : packings) {
    folder_.write("p.csv", packing);
    const std::string name = fmt::format("case{}.toml", number++);
    ASSERT_EQ(run("init p.csv -o " + name), 0) << packing << err();
    EXPECT_EQ(run("run " + name), 0) << packing << folder_.read(name) << err();
  }
}

TEST_F(FileReport, InitWritesACaseThatRuns) {
  write_dump("pp pp ff");
  ASSERT_EQ(run("init p.dump --conductivity 85 --density 5910 --specific-heat 640 -o sub.toml"), 0) << err();
  const std::string text = folder_.read("sub.toml");
  EXPECT_NE(text.find("conductivity = 85.0"), std::string::npos) << text;
  ASSERT_EQ(run("run sub.toml --out result"), 0) << err();
  EXPECT_TRUE(folder_.has("result/final.csv"));
  ASSERT_EQ(run("info result/final.csv"), 0) << err();
  expect_out("temperature");
  expect_out("xy");
  EXPECT_EQ(run("init p.dump -o sub.toml"), 2) << "what is there is kept";
  // Chained: the end of one run is the start of the next, with the same contacts.
  std::string next = text;
  next.replace(next.find("\"p.dump\""), 8, "\"result/final.csv\"");
  const std::string of_dump = "\"f_T\"";
  ASSERT_NE(next.find("initial = { column = " + of_dump), std::string::npos) << next;
  next.replace(next.find(of_dump), of_dump.size(), "\"temperature\"");
  const Scene first = load_scene(folder_.file("sub.toml")),
              second = load_scene(folder_.write("next.toml", next));
  EXPECT_EQ(first.packed->contacts.size(), second.packed->contacts.size());
  EXPECT_EQ(run("run next.toml --out result2"), 0) << err();
}

TEST_F(FileReport, NetworksAndOtherFiles) {
  folder_.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n3 3 2\n2 1 2\n3 2 3\n");
  ASSERT_EQ(run("info K.mtx"), 0) << err();
  expect_out("Matrix Market");
  folder_.write("e.csv", "i,j,conductance\n1,2,3\n2,3,4\n");
  ASSERT_EQ(run("info e.csv"), 0) << err();
  expect_out("edge list");
  folder_.write("e.txt", "1 2 3.0\n2 3 4.0\n");
  ASSERT_EQ(run("info e.txt"), 0) << err();
  expect_out("edge list without a header");
  expect_out("[network] edges = \"e.txt\", with capacity");
  folder_.write("prose.txt", "these are not spheres\n");
  EXPECT_EQ(run("info prose.txt"), 3);
  EXPECT_EQ(run("info nothing.dump"), 3);
  EXPECT_EQ(run("info K.mtx --conductivity -1"), 2);
}

TEST_F(FileReport, AReaderThatHasSeenEnoughIsNoFault) {
  const std::string command = fmt::format("'{}' list --keys 2>'{}'; echo $? >'{}'", SUPERSTEP_PROGRAM,
                                          folder_.file("stderr.txt"), folder_.file("code.txt"));
  pclose(popen(command.c_str(), "r"));  // NOLINT(cert-env33-c): nobody reads
  EXPECT_EQ(err(), "");
  EXPECT_EQ(folder_.read("code.txt"), "0\n");
}

TEST_F(FileReport, ParticlesThatAllTouchAnEndStillHaveContacts) {
  folder_.write("two.csv", "x,y,z,r\n0,0,0,0.55\n0,0,1,0.55\n");
  ASSERT_EQ(run("info two.csv --conductivity 10"), 0) << err();
  EXPECT_NE(out().find("nothing lies between"), std::string::npos) << out();
  EXPECT_NE(out().find("mean coordination                  1"), std::string::npos) << out();
  folder_.write("inside.csv", "x,y,z,r\n0,0,0,0.55\n0,0,0.1,0.3\n");
  EXPECT_EQ(run("info inside.csv --conductivity 10"), 3);
  EXPECT_NE(err().find("inside.csv: particle 1"), std::string::npos) << err();
}

TEST_F(FileReport, TheSystemOfACaseReadsBack) {
  write_rod(folder_, test::Rod{});
  ASSERT_EQ(run("info rod.toml --matrix system"), 0) << err();
  const Scene rod = load_scene(folder_.file("rod.toml")),
              again = load_scene(folder_.file("system/case.toml"));
  EXPECT_EQ(again.rhs->size(), rod.rhs->size());
  std::vector<double> f(rod.rhs->size()), g(f.size());
  (*rod.rhs)(0, rod.initial, f);
  (*again.rhs)(0, again.initial, g);
  EXPECT_EQ(f, g) << "the same network in the same order";
  EXPECT_EQ(again.t_end, rod.t_end);
  EXPECT_EQ(again.output_times, rod.output_times);
}

}  // namespace
}  // namespace superstep

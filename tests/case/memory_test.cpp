/// Cases whose particles and networks are in memory.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "case/memory/case_data.hpp"
#include "core/error.hpp"

namespace superstep {
namespace {

Scene load(const std::string& text, const CaseData& data) {
  return load_scene(TomlTable::parse_unseen(text, "mine"), data);
}

std::string refusal(const std::string& text, const CaseData& data) {
  try {
    (void)load(text, data);
  } catch (const InputError& error) {
    return error.what();
  }
  return "taken";
}

const std::string of_spheres =
    "t_end = 1\npacking = {length_unit = \"mm\"}\nmaterial = {density = 1000}\ncontact = {neck = "
    "\"geometric\"}\n"
    "thermal = {conductivity = 1, specific_heat = 1, initial = {column = \"warm\"}}\n";

struct ThreeSpheres {
  std::vector<double> centres{0, 0, 0, 1.9, 0, 0, 3.8, 0, 0}, radii{1, 1, 1};  // mm
  std::vector<PackingAttribute> attributes{{"warm", {1, 2, 3}}};
  [[nodiscard]] CaseData data() const {
    SphereArrays spheres;
    spheres.centres = centres;
    spheres.radii = radii;
    spheres.attributes = attributes;
    return {.spheres = spheres, .network = std::nullopt};
  }
};

TEST(Memory, SpheresMakeTheSceneOfAFile) {
  const ThreeSpheres three;
  const Scene scene = load(of_spheres, three.data());
  const auto& graph = scene.fields.front().graph;
  ASSERT_EQ(graph.edges(), 2U);
  EXPECT_EQ(graph.initial, (std::vector<double>{1, 2, 3}));
  EXPECT_NEAR(graph.capacity[0], 1000 * 4.0 / 3 * std::numbers::pi * 1e-9, 1e-20) << "a sphere of 1 mm";
}

TEST(Memory, WrongSpheresAreRefusedByNameAndPosition) {
  ThreeSpheres three;
  three.radii[2] = -1;
  EXPECT_EQ(refusal(of_spheres, three.data()),
            "mine: particle 2: radius is -1; it must be > 0; correct it or remove the particle");
  three.radii = {1, 1};
  EXPECT_EQ(refusal(of_spheres, three.data()),
            "mine: centres has 9 values, and must have 6: three coordinates for each radius");
  three = {};
  three.centres[4] = std::nan("");
  EXPECT_EQ(refusal(of_spheres, three.data()), "mine: value 4 of centres is nan; it must be finite");
  three = {};
  three.centres[3] = 0;
  EXPECT_NE(refusal(of_spheres, three.data()).find("particle 1: centre is"), std::string::npos);
  EXPECT_NE(refusal("t_end = 1\npacking = {file = \"a.csv\"}\nthermal = {}\n", ThreeSpheres{}.data())
                .find("in memory already"),
            std::string::npos);
  EXPECT_NE(refusal("t_end = 1\npacking = {order = \"layers\"}\nthermal = {}\n", ThreeSpheres{}.data())
                .find("keep their order"),
            std::string::npos);
}

struct ThreeNodes {
  // Rows of a Laplacian between three nodes in a row, columns in no order, the last one grounded by 0.5.
  std::vector<double> value{-2, 2, -2, -3, 5, 3.5, -3};
  std::vector<std::int64_t> column{1, 0, 0, 2, 1, 2, 1}, row_begin{0, 2, 5, 7};
  std::vector<double> fixed{};
  [[nodiscard]] CaseData data() const {
    NetworkArrays network;
    network.value = value;
    network.column = column;
    network.row_begin = row_begin;
    network.fixed = fixed;
    return {.spheres = std::nullopt, .network = network};
  }
};

const std::string of_network = "t_end = 1\nnetwork = {initial = 4, ambient = 7}\n";

TEST(Memory, AMatrixIsANetwork) {
  ThreeNodes three;
  three.fixed = {9, std::nan(""), std::nan("")};
  const Scene scene = load(of_network, three.data());
  const auto& graph = scene.fields.front().graph;
  ASSERT_EQ(graph.edges(), 2U);
  EXPECT_EQ(graph.conductance, (std::vector<double>{2, 3}));
  EXPECT_EQ(graph.is_fixed, (std::vector<char>{1, 0, 0}));
  EXPECT_EQ(graph.fixed_value[0], 9);
  EXPECT_EQ(graph.initial, (std::vector<double>{4, 4, 4}));
  ASSERT_EQ(graph.convection.size(), 1U);
  EXPECT_EQ(graph.convection[0].coefficient, 0.5);
  EXPECT_EQ(graph.convection[0].ambient, 7);
}

TEST(Memory, WrongMatricesAreRefusedByNameAndPlace) {
  ThreeNodes three;
  three.value[6] = -3.1;
  EXPECT_NE(refusal(of_network, three.data()).find("mine: entry (1, 2) is -3; the entry across the diagonal"),
            std::string::npos);
  three = {};
  three.row_begin = {0, 5, 2, 7};
  EXPECT_EQ(refusal(of_network, three.data()),
            "mine: the matrix's indptr falls from 5 to 2 in row 1; it must not fall");
  three = {};
  three.row_begin.back() = 6;
  EXPECT_NE(refusal(of_network, three.data()).find("indptr goes from 0 to 6"), std::string::npos);
  three = {};
  three.column[3] = 3;
  EXPECT_EQ(refusal(of_network, three.data()),
            "mine: the matrix's row 1 has an entry in column 3; there are columns 0 to 2");
  three = {};
  three.value[4] = std::nan("");
  EXPECT_EQ(refusal(of_network, three.data()), "mine: entry (1, 1) of the matrix is nan; it must be finite");
  three = {};
  three.fixed = {1, 2};
  EXPECT_EQ(refusal(of_network, three.data()),
            "mine: fixed has 2 values, and must have 3: one for each node, NaN where it is free");
  three = {};
  EXPECT_NE(refusal("t_end = 1\nnetwork = {edges = \"e.csv\"}\n", three.data()).find("in memory already"),
            std::string::npos);
  three.fixed = {1, 2, 3};
  EXPECT_NE(refusal("t_end = 1\nnetwork = {fixed = [{ids = [0], value = 1}]}\n", three.data())
                .find("leave one of the two out"),
            std::string::npos);
}

TEST(Memory, DataThatTheCaseHasNoUseForIsNoSecret) {
  EXPECT_NE(refusal(of_network, ThreeSpheres{}.data()), "taken");
  EXPECT_NE(refusal(of_spheres, ThreeNodes{}.data()), "taken");
}

TEST(Memory, EdgesAreANetwork) {
  const std::vector<std::int64_t> ends{0, 1, 1, 2, 1, 0};
  const std::vector<double> conductance{1, 2, 4};
  NetworkArrays network;
  network.ends = ends;
  network.conductance = conductance;
  network.nodes = 3;
  const Scene scene =
      load("t_end = 1\nnetwork = {initial = 1}\n", {.spheres = std::nullopt, .network = network});
  EXPECT_EQ(scene.fields.front().graph.conductance, (std::vector<double>{5, 2})) << "0-1 stands there twice";
  network.nodes = 2;
  EXPECT_EQ(refusal(of_network, {.spheres = std::nullopt, .network = network}),
            "mine: edge 1 ends at node 2; there are nodes 0 to 1");
}

TEST(Memory, UnseenTextsHaveNoLines) {
  EXPECT_EQ(refusal("t_end = 1\n\nnetwork = {initia = 1}\n", ThreeNodes{}.data()),
            "mine: unknown key 'initia' in [network]; did you mean 'initial'?");
  EXPECT_EQ(refusal("t_end = \"a\"\n", ThreeNodes{}.data()), "mine: key 't_end' is 'a'; it must be a number");
}

}  // namespace
}  // namespace superstep

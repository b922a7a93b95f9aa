#include "case/case.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "press.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using namespace test;

std::string case_path(const std::string& name) {
  return std::string(SUPERSTEP_SOURCE_DIR) + "/cases/" + name;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(SinteringCases, AllLoad) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(case_path(""))) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with("sintering_") || entry.path().extension() != ".toml") continue;
    EXPECT_TRUE(std::holds_alternative<Press>(load_case(entry.path().string()))) << name;
    ++count;
  }
  EXPECT_GE(count, 5);
  EXPECT_TRUE(std::holds_alternative<Scene>(load_case(case_path("chain.toml"))));
}

TEST(SinteringCases, ExampleIsThePrintedOneWhereItSaysSo) {
  const Press one = load_press(case_path("sintering_example.toml"));
  EXPECT_EQ(one.particles.size(), 1000U);
  EXPECT_EQ(one.particles.radius.front(), 0.075);
  EXPECT_EQ(one.stepping.largest_step, 0.005);
  EXPECT_EQ(one.model.contact.softening.temperature, 500);
  EXPECT_EQ(one.model.thermal.wall_temperature[upper], 1000);
  EXPECT_EQ(one.stepping.iterations, 10);
  EXPECT_EQ(one.stepping.tolerance_position, 5e-4);
  EXPECT_NEAR(one.particles.mass.front(), 3.534, 1e-3) << "2000 kg/m3";
}

struct Mistake {
  const char *from, *to, *says;
};

class WrongCase : public testing::TestWithParam<Mistake> {};

TEST_P(WrongCase, IsAnErrorThatNamesPlaceAndRule) {
  const TemporaryFolder folder;
  const std::string text = read_text_file(case_path("sintering_column.toml"));
  const auto path = folder.write("wrong.toml", replaced(text, GetParam().from, GetParam().to));
  const std::string message = message_of<InputError>([&] { (void)load_press(path); });
  EXPECT_NE(message.find(path + ":"), std::string::npos) << message;
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Keys, WrongCase,
    testing::Values(Mistake{"gravity = 9.81", "gravty = 9.81", "did you mean 'gravity'"},
                    Mistake{"damping = 0.3", "dampin = 0.3", "did you mean 'damping'"},
                    Mistake{"stiffness = 1e8", "stiffness = -1", "must be >= 0"},
                    Mistake{"exponent = 2", "exponent = nan", "finite"},
                    Mistake{"upper_wall = 1.14", "upper_wall = -0.1", "walls would cross"},
                    Mistake{"until = 0.1", "until = 0.0", "later than the phase begins"},
                    Mistake{"until = 0.1", "until = 1e-300", "the length of the phase, 1e-300 s is beyond"},
                    Mistake{"t_end = 3.0", "t_end = 1e-300", "between 1e-40 and 1e+40 s"},
                    Mistake{"until = 3.0", "until = 2.0", "before t_end"},
                    Mistake{"name = \"hold\"", "name = \"press\"", "[0].name' is the same, and results tell"},
                    Mistake{"current = { lower = 1.0, upper = 3.0 }", "potential = { lower = 1.0 }",
                            "model = \"potential\""},
                    Mistake{"position = [0.0, 0.0, 0.225]", "position = [0.0, 0.0, 0.2]", "overlap"},
                    Mistake{"position = [0.0, 0.0, 0.225]", "position = [0.0, 0.15, 0.225]", "+y wall"},
                    Mistake{"max = [0.2, 0.2, 1.2]", "max = [0.2, -0.3, 1.2]", "exceed that of min"},
                    Mistake{"phi = 0.5", "phi = 1.5", "between 0 and 1"},
                    Mistake{"phi = 0.5", "scheme = \"plane\"", "valid are: staggered, plain"},
                    Mistake{"motion_window = [0.0, 0.2]", "motion_window = [0.2, 0.1]", "from < to"},
                    Mistake{"t_end = 3.0", "t_end = \"3\"", "number"}));

TEST(SinteringCases, BondsThatPullWithoutBoundAreRefused) {
  const TemporaryFolder folder;
  const std::string text = read_text_file(case_path("sintering_printed_bond.toml"));
  const auto complaint = [&](const std::string& from, const std::string& to) {
    const auto path = folder.write("case.toml", replaced(text, from, to));
    return message_of<InputError>([&] { (void)load_press(path); });
  };
  const std::string bond = "[dynamics.bond]\nstiffness = ";
  EXPECT_EQ(complaint(bond + "9e6", bond + "9.9e6"), "");
  const std::string message = complaint(bond + "9e6", bond + "1e7");
  EXPECT_NE(message.find("'dynamics.bond.stiffness' is 10000000; it must be below"), std::string::npos)
      << message;
  // Hot contacts have nothing but their floor to push with.
  EXPECT_NE(complaint("stiffness_floor = 1e7", "stiffness_floor = 8e6").find("stiffness_floor"),
            std::string::npos);
}

/// Two particles of one material of this hardness, with these laws.
std::string two_bonded(double hardness, const std::string& contact, const std::string& bond) {
  return fmt::format(
      "t_end = 0.5\n"
      "[[materials]]\nname = \"a\"\ndensity = 2000.0\n"
      "thermal = {{ conductivity = 0.0, specific_heat = 100.0 }}\nhardness = {}\n"
      "[thermal]\ninitial = 300.0\nwalls = 300.0\n"
      "[dynamics.box]\nmin = [-1, -1, -1]\nmax = [1, 1, 1]\n"
      "[dynamics.particles]\nlist = [{{ position = [0, 0, 0], radius = 0.1, material = \"a\" "
      "}}]\n"
      "[dynamics.contact]\nstiffness = 1e7\n{}\n[dynamics.wall]\nstiffness = 1e7\n"
      "[dynamics.bond]\n{}\n[[dynamics.phases]]\nname = \"x\"\nuntil = 0.5\n",
      hardness, contact, bond);
}

TEST(SinteringCases, BondsAreHeldAgainstTheWeakestContactThereIs) {
  const TemporaryFolder folder;
  const auto complaint = [&](double hardness, const char* contact, const char* bond) {
    const auto path = folder.write("case.toml", two_bonded(hardness, contact, bond));
    return message_of<InputError>([&] { (void)load_press(path); });
  };
  const auto says = [](const std::string& message, const char* what) {
    EXPECT_NE(message.find(what), std::string::npos) << message;
  };
  // A contact of hardness 0.1 pushes with a tenth.
  says(complaint(0.1, "", "stiffness = 5e6\nthreshold = 0.01"), "must be below 1000000 N/m2");
  EXPECT_EQ(complaint(0.1, "", "stiffness = 9e5\nthreshold = 0.01"), "");
  EXPECT_EQ(complaint(4, "", "stiffness = 3e7\nthreshold = 0.01"), "") << "and one of 4 with four times";
  // Of hot ones no more than the floor is left, exactly.
  const char* floor = "softening_temperature = 900\nstiffness_floor = 1e6";
  says(complaint(1, floor, "stiffness = 1e6\nthreshold = 0.01"), "must be below 1000000 N/m2");
  EXPECT_EQ(complaint(1, floor, "stiffness = 9.9e5\nthreshold = 0.01"), "");
  // Overlap^1 against overlap^2: at the threshold of 0.01 the bond pulls a hundred times as hard.
  says(complaint(1, "", "exponent = 1\nstiffness = 9e6\nthreshold = 0.01"), "must be below 100000 N/m2");
  EXPECT_EQ(complaint(1, "", "exponent = 1\nstiffness = 9e4\nthreshold = 0.01"), "");
  EXPECT_EQ(complaint(1, "", "exponent = 3\nstiffness = 9e6\nthreshold = 0.01"), "") << "most at overlap 1";
}

TEST(SinteringCases, ParticlesThatTouchUpToRoundingDoNotOverlap) {
  const TemporaryFolder folder;
  const auto complaint = [&](const char* second) {
    std::string text = two_bonded(1, "", "stiffness = 1e6\nthreshold = 0.1");
    text = replaced(text, "position = [0, 0, 0]", "position = [0.1, 0, 0]");
    text = replaced(text, "\"a\" }]",
                    std::string("\"a\" }, { position = [") + second +
                        ", 0, 0], radius = 0.1, material = \"a\" }]\nmax_overlap = 0.0");
    const auto path = folder.write("case.toml", text);
    return message_of<InputError>([&] { (void)load_press(path); });
  };
  ASSERT_LT(0.3 - 0.1, 0.2) << "of numbers with 53 bits";
  EXPECT_EQ(complaint("0.3"), "");
  EXPECT_NE(complaint("0.2999").find("overlap by"), std::string::npos);
}

TEST(SinteringCases, ZeroParticlesAndFullBoxesAreErrors) {
  const TemporaryFolder folder;
  const std::string text = read_text_file(case_path("sintering_example.toml"));
  for (const auto& [count, says] : {std::pair{"0", "at least one"}, std::pair{"5000", "found no room"}}) {
    const auto path =
        folder.write("wrong.toml", replaced(text, "count = 1000", std::string("count = ") + count));
    const std::string message = message_of<InputError>([&] { (void)load_press(path); });
    EXPECT_NE(message.find(says), std::string::npos) << message;
  }
}

/// Overlap strains of a column under the force F on top, from the balance of every particle; the stack's
/// height.
struct Stack {
  double height;
  std::vector<double> area;  // of the contacts between particles, from below
};

/// Wall and pair have the same law.
double strain_for(double force, double stiffness) {
  constexpr double r = 0.075;
  double low = 0, high = 0.9;
  for (int k = 0; k < 200; ++k) {
    const double e = 0.5 * (low + high);
    const double area = std::numbers::pi * r * r * (2 * e - e * e);
    (stiffness * e * e * area < force ? low : high) = e;
  }
  return low;
}

Stack stack_under(double force_on_top, double weight) {
  constexpr double r = 0.075, stiffness = 1e8;
  Stack stack{r * (1 - strain_for(force_on_top, stiffness)), {}};
  for (int above = 1; above < 8; ++above) {
    const double e = strain_for(force_on_top + above * weight, stiffness);
    stack.height += 2 * r * (1 - e);
    stack.area.insert(stack.area.begin(), std::numbers::pi * r * r * (2 * e - e * e));
  }
  stack.height += r * (1 - strain_for(force_on_top + 8 * weight, stiffness));
  return stack;
}

TEST(SinteringCases, ColumnComesToItsBalance) {
  const Press one = load_press(case_path("sintering_column.toml"));
  Motion motion(one.model, one.particles, one.stepping);
  motion.start(one.state);
  ASSERT_TRUE(motion.advance(one.t_end).ok());
  const double weight = one.particles.mass[0] * 9.81;
  double low = 0, high = 1e6;
  for (int k = 0; k < 200; ++k) {
    const double middle = 0.5 * (low + high);
    (stack_under(middle, weight).height > 1.14 ? low : high) = middle;
  }
  const Stack stack = stack_under(low, weight);
  EXPECT_NEAR(motion.history().back().wall_force, low, 1e-5 * low) << "the motion has died down to that";
  // Currents: lowest particle 1 A, highest 3 A, drops in proportion to 1/A in between.
  double resistance = 0;
  for (const double area : stack.area) resistance += 1 / area;
  double expected = 1;
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(motion.state().electric[k], expected, 1e-5) << k;
    if (k < stack.area.size()) expected += 2 / (stack.area[k] * resistance);
  }
}

TEST(SinteringCases, TwoParticlesReachTheDepthOfTheEnergyIntegral) {
  const Press one = load_press(case_path("sintering_two_particles.toml"));
  Motion motion(one.model, one.particles, one.stepping);
  motion.start(one.state);
  double deepest = 0;
  motion.after_step = [&] {
    const Vec3 between = motion.state().position[1] - motion.state().position[0];
    deepest = std::max(deepest, 1 - norm(between) / 0.15);
  };
  ASSERT_TRUE(motion.advance(one.t_end).ok());
  // m/2 (2 m/s)^2/2. The deepest step end is short by up to (pi h/2T)^2/2 = 2e-5 with h = 1e-4 s, T = 0.025
  // s, the rule is off by (pi h/T)^2/12 = 1.3e-5; the energy goes with the fourth power.
  EXPECT_NEAR(contact_energy(1e7, 0.075, deepest), one.particles.mass[0], 1.4e-4 * one.particles.mass[0]);
  EXPECT_NEAR(motion.state().velocity[1].x, 1, 1e-5) << "order 2 with 300 steps in the contact";
}

}  // namespace
}  // namespace superstep

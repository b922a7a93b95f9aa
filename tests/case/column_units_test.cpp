/// Columns of values that state units: taken in kelvin and volts, or refused.

#include <gtest/gtest.h>

#include "case/inputs/column_unit.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

TEST(ColumnUnits, StandInBracketsOrClearlyAtTheEnd) {
  for (const auto& [name, unit] : {std::pair{"temperature [C]", "C"},
                                   {"T (mK)", "mK"},
                                   {"T_degC", "degC"},
                                   {"temperature_C", "C"},
                                   {"Temp \xC2\xB0\x43", "\xC2\xB0\x43"},
                                   {"f_Temp[0]", ""},
                                   {"temperature", ""},
                                   {"T_mean", ""},
                                   {"c_C", ""},
                                   {"U [V]", "V"}})
    EXPECT_EQ(split_column_unit(name).unit, unit) << name;
}

/// The case of three spheres whose start is this column, of the packing or of a file beside it.
Scene start_of(const std::string& column, bool beside) {
  const test::TemporaryFolder folder;
  const std::string rows = "1,0,0,0,0.055,25\n2,0,0,0.1,0.055,26\n3,0,0,0.2,0.055,27\n";
  folder.write("p.csv", "id,x,y,z,radius," + column + "\n" + rows);
  return load_scene(folder.write(
      "c.toml",
      "t_end = 1e-3\n[packing]\nfile = \"p.csv\"\n[material]\ndensity = 1000.0\n[contact]\nneck = \"hertz\"\n"
      "[thermal]\nconductivity = 10.0\nspecific_heat = 700.0\ninitial = { column = \"" +
          column + "\"" + (beside ? ", file = \"p.csv\"" : "") +
          " }\nfixed = [ { where = { ids = [1] }, value = 400.0 } ]\n"));
}

TEST(ColumnUnits, OfInitialValuesAreNotTakenForKelvin) {
  for (const bool beside : {false, true}) {
    for (const char* column : {"temperature", "temperature [K]", "T (K)", "f_Temp[0]"})
      EXPECT_EQ(start_of(column, beside).fields[0].graph.initial[2], 27) << column;
    for (const char* column :
         {"temperature [C]", "T [mK]", "T_degC", "temperature_C", "T [V]", "T [\xC2\xB0\x43]"}) {
      const auto message = test::message_of<InputError>([&] { (void)start_of(column, beside); });
      EXPECT_NE(message.find(column), std::string::npos) << column << ": " << message;
      EXPECT_NE(message.find("taken in K"), std::string::npos) << message;
    }
  }
}

}  // namespace
}  // namespace superstep

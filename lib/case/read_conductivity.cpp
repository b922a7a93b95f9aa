#include "case/read_conductivity.hpp"

#include "core/text/suggest.hpp"

namespace superstep {
namespace {

void read_table(TomlTable& table, ConductivityLaw& law) {
  const auto temperatures = table.require("temperatures", "it lists the temperatures, ascending");
  const auto values = table.require("values", "it lists the conductivity at each temperature");
  law.temperatures = temperatures.numbers();
  law.values = values.numbers();
  if (law.temperatures.size() < 2) temperatures.reject("a table needs at least two temperatures");
  if (law.values.size() != law.temperatures.size())
    values.reject("there must be as many values as temperatures");
  for (std::size_t k = 0; k < law.values.size(); ++k) {
    if (k > 0 && !(law.temperatures[k] > law.temperatures[k - 1]))
      temperatures.reject("the temperatures must be ascending");
    if (!(law.values[k] > 0)) values.reject("every conductivity must be > 0");
  }
  law.value = law.values.front();
}

double number(TomlTable& table, const char* key, const char* why) {
  return table.require(key, why).number();
}

ConductivityLaw::Outside read_outside(TomlTable& table) {
  const auto outside = table.find("outside");
  if (!outside || outside->string() == "error") return ConductivityLaw::Outside::error;
  if (outside->string() != "clamp")
    outside->reject(
        "it must be \"error\" or \"clamp\" (hold a table's end values, or a line at 1 % of its value)");
  return ConductivityLaw::Outside::clamp;
}

}  // namespace

ConductivityLaw read_conductivity(const TomlValue& conductivity) {
  ConductivityLaw law;
  if (!conductivity.is_table()) {
    law.value = conductivity.number();
    if (!(law.value > 0)) conductivity.reject("it must be > 0 [W/(m K) or S/m]");
    return law;
  }
  TomlTable table = conductivity.table();
  law.place = conductivity.where();
  law.outside = read_outside(table);
  const auto kind = table.require("law", "it must be linear, table or sigmoid");
  const std::string name = kind.string();
  if (name == "table") {
    law.kind = ConductivityLaw::Kind::table;
    read_table(table, law);
  } else if (name == "linear") {
    law.kind = ConductivityLaw::Kind::linear;
    law.value = table.positive("value", "W/(m K) or S/m");
    law.coefficient = number(table, "coefficient", "it is the relative change per kelvin");
    law.reference = number(table, "reference", "it is the temperature at which the value holds");
  } else if (name == "sigmoid") {
    law.kind = ConductivityLaw::Kind::sigmoid;
    law.value = table.positive("value", "W/(m K) or S/m");
    const auto amplitude = table.require("amplitude", "it is the relative rise from cold to hot");
    law.amplitude = amplitude.number();
    if (!(law.amplitude > -1)) amplitude.reject("it must be > -1, so that the conductivity stays positive");
    law.steepness = number(table, "steepness", "it is the steepness of the rise [1/K]");
    law.reference = number(table, "reference", "it is the temperature of the half rise");
  } else {
    static const std::vector<std::string> laws = {"linear", "table", "sigmoid"};
    kind.reject("it must name a law" + suggestion(name, laws));
  }
  table.finish();
  return law;
}

}  // namespace superstep

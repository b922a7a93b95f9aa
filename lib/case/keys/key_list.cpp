#include "case/keys/key_list.hpp"

#include <utility>

namespace superstep {

KeyList& KeyList::in(std::string table, unsigned scenes) {
  table_ = std::move(table);
  scenes_ = scenes;
  return *this;
}

CaseKey& KeyList::add(const std::string& name, unsigned types, std::string meaning) {
  CaseKey key;
  key.place = table_.empty() ? name : table_ + "." + name;
  key.scenes = scenes_;
  key.types = types;
  key.meaning = std::move(meaning);
  keys_.push_back(std::move(key));
  return keys_.back();
}

namespace {

void set_range(CaseKey& key, KeyRange range) {
  key.min = range.min;
  key.max = range.max;
  key.min_open = range.min_open;
  key.max_open = range.max_open;
}

}  // namespace

CaseKey& KeyList::number(const std::string& name, KeyRange range, std::string unit, std::string meaning) {
  CaseKey& key = add(name, CaseKey::number, std::move(meaning));
  set_range(key, range);
  key.unit = std::move(unit);
  return key;
}

CaseKey& KeyList::integer(const std::string& name, KeyRange range, std::string meaning) {
  CaseKey& key = add(name, CaseKey::integer, std::move(meaning));
  set_range(key, range);
  return key;
}

CaseKey& KeyList::boolean(const std::string& name, std::string fallback, std::string meaning) {
  CaseKey& key = add(name, CaseKey::boolean, std::move(meaning));
  key.fallback = std::move(fallback);
  return key;
}

CaseKey& KeyList::text(const std::string& name, std::string meaning, std::vector<std::string> words) {
  CaseKey& key = add(name, CaseKey::text, std::move(meaning));
  key.words = std::move(words);
  return key;
}

CaseKey& KeyList::numbers(const std::string& name, std::size_t count, KeyRange range, std::string unit,
                          std::string meaning) {
  CaseKey& key = add(name, CaseKey::array, std::move(meaning));
  key.elements = CaseKey::number;
  key.count = count;
  set_range(key, range);
  key.unit = std::move(unit);
  return key;
}

CaseKey& KeyList::list(const std::string& name, unsigned elements, std::string meaning) {
  CaseKey& key = add(name, CaseKey::array, std::move(meaning));
  key.elements = elements;
  return key;
}

CaseKey& KeyList::table(const std::string& name, std::string meaning) {
  return add(name, CaseKey::table, std::move(meaning));
}

void KeyList::amount(const std::string& name, const std::string& unit, const std::string& meaning,
                     unsigned other_types) {
  CaseKey& key = number(name, any_number, unit, meaning);
  key.types = CaseKey::number | CaseKey::table | other_types;
  if ((other_types & CaseKey::array) != 0) key.elements = CaseKey::table;
  numbers(name + ".times", 0, any_number, "s", "instants, ascending; two equal ones are a step");
  numbers(name + ".values", 0, any_number, unit, "the value at each instant, linear between");
  text(name + ".file", "or a table in a file, sampled as it may be");
  text(name + ".time", "file: its column of instants [s]").fallback = "time";
  text(name + ".value", "file: its column of values").fallback = "value";
  number(name + ".scale", any_number, "", "multiplies the values").fallback = "1";
  number(
      name + ".period", positive_number, "s",
      "after which the table repeats; a shorter table is closed by a line from its last value to its first")
      .fallback = "it does not";
  text(name + ".outside", "what holds before and after the table", {"clamp", "zero", "error"}).fallback =
      "clamp";
}

void KeyList::initial(const std::string& unit, const std::string& meaning, unsigned other_types) {
  number("initial", any_number, unit, meaning).types = CaseKey::number | CaseKey::table | other_types;
  text("initial.column", "or a column of the packing file, a value for each");
  text("initial.file", "or of this file, by its column id");
}

void KeyList::where(const std::string& name) {
  static const std::vector<std::string> sides = {"top", "bottom", "+x", "-x", "+y", "-y", "+z", "-z"};
  std::vector<std::string> words = {"all"};
  words.insert(words.end(), sides.begin(), sides.end());
  text(name, "particles: all, a layer one mean diameter thick, or one of the tables below", words).types =
      CaseKey::text | CaseKey::table;
  list(name + ".ids", CaseKey::integer, "ids of the packing");
  table(name + ".box", "centres in a box");
  numbers(name + ".box.min", 3, any_number, "length_unit", "one corner");
  numbers(name + ".box.max", 3, any_number, "length_unit", "the other corner");
  table(name + ".layer", "centres no deeper than this below the outermost surface on a side");
  text(name + ".layer.side", "the side", sides);
  number(name + ".layer.thickness", positive_number, "length_unit", "depth of the layer");
  table(name + ".sphere", "centres in a sphere");
  numbers(name + ".sphere.centre", 3, any_number, "length_unit", "its centre");
  number(name + ".sphere.radius", positive_number, "length_unit", "its radius");
  table(name + ".cylinder", "centres in a cylinder");
  numbers(name + ".cylinder.base", 3, any_number, "length_unit", "centre of its base");
  numbers(name + ".cylinder.axis", 3, any_number, "", "its direction, of any length but 0");
  number(name + ".cylinder.radius", positive_number, "length_unit", "its radius");
  number(name + ".cylinder.height", positive_number, "length_unit", "its height");
}

void KeyList::conductivity(const std::string& unit) {
  number("conductivity", positive_number, unit, "a number, or a law of temperature").types =
      CaseKey::number | CaseKey::table;
  text("conductivity.law", "how it follows temperature", {"linear", "table", "sigmoid"});
  number("conductivity.value", positive_number, unit, "linear, sigmoid: at the reference; cold");
  number("conductivity.coefficient", any_number, "1/K", "linear: relative change per kelvin");
  number("conductivity.reference", any_number, "K", "linear, sigmoid: where the value holds; half the rise");
  number("conductivity.amplitude", {.min = -1, .min_open = true}, "", "sigmoid: relative rise, cold to hot");
  number("conductivity.steepness", any_number, "1/K", "sigmoid: steepness of the rise");
  numbers("conductivity.temperatures", 0, any_number, "K", "table: at least two, ascending");
  numbers("conductivity.values", 0, positive_number, unit, "table: the conductivity at each temperature");
  text("conductivity.outside", "what holds outside the law's range", {"error", "clamp"}).fallback = "error";
}

void KeyList::boundary(const std::string& name, const std::string& otherwise) {
  table(name, "a layer in series with every contact; left out = " + otherwise);
  number(name + ".thickness", positive_number, "m", "of the layer");
  number(name + ".reduction", positive_number, "", "its conductivity over that of the bulk");
}

}  // namespace superstep

#include "case/inputs/read_amount.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "case/inputs/column_unit.hpp"
#include "case/inputs/named_column.hpp"
#include "case/inputs/named_file.hpp"
#include "case/inputs/workable_times.hpp"
#include "core/error.hpp"
#include "core/text/bracketed_unit.hpp"
#include "core/text/delimited.hpp"

namespace superstep {
namespace {

/// Two equal neighbours are a step; a third value at the same instant would have no meaning. Calls
/// reject(index, rule).
template <class Reject>
void require_ascending(const std::vector<double>& time, Reject reject) {
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k] < time[k - 1])
      reject(k, fmt::format("the times must be ascending, and {} follows {}", time[k], time[k - 1]));
    if (k > 1 && time[k] == time[k - 2])
      reject(k,
             fmt::format(
                 "{} stands three times; the times must be ascending, and a step is two equal times with the "
                 "value before it and the value after it",
                 time[k]));
  }
}

/// Two instants that differ by roundings are one: k * period and the sum of what came before it, for example.
bool is_same_instant(double a, double b) {
  constexpr double roundings = 8;
  return std::abs(a - b) <=
         roundings * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}
void join_same_instants(std::vector<double>& time) {
  for (std::size_t k = 1; k < time.size(); ++k)
    if (is_same_instant(time[k], time[k - 1])) time[k] = time[k - 1];
}

TimeTable read_lists(TomlTable& table) {
  const auto times = table.require("times", "it lists instants, ascending [s]; or give a file");
  const auto values = table.require("values", "it lists the value at each instant");
  TimeTable out{times.numbers(), values.numbers()};
  if (out.time.empty()) times.reject("a table needs at least one instant");
  if (out.value.size() != out.time.size()) values.reject("there must be as many values as times");
  join_same_instants(out.time);
  const auto reject = [&](std::size_t, const std::string& rule) { times.reject(rule); };
  require_ascending(out.time, reject);
  require_workable_instants(out.time, reject);
  return out;
}

/// Unit that a name states: in brackets, or as its last word where that is one of `words` ("time_ms").
std::string_view stated_unit(std::string_view name, std::span<const std::string_view> words) {
  if (const auto unit = split_bracketed_unit(name).unit; !unit.empty()) return unit;
  const std::size_t cut = name.find_last_of("_/, ");
  if (cut == std::string_view::npos) return {};
  const std::string_view last = name.substr(cut + 1);
  return std::find(words.begin(), words.end(), last) == words.end() ? std::string_view{} : last;
}

/// Words that can be nothing else behind a time, or behind a value ("T_min" is none of them).
constexpr std::array<std::string_view, 22> of_times = {
    "ms",     "msec",         "us",          "µs",           "μs",          "usec",       "ns", "min",
    "minute", "minutes",      "h",           "hr",           "hour",        "hours",      "d",  "day",
    "days",   "milliseconds", "millisecond", "microseconds", "microsecond", "nanoseconds"};
constexpr std::array<std::string_view, 22> of_values = {
    "mK", "uK", "mV", "kV", "uV", "nV",   "mW", "kW",   "MW",         "GW",      "uW",
    "nW", "mA", "kA", "uA", "nA", "degC", "°C", "degF", "fahrenheit", "celsius", "Celsius"};

/// The unit that a column states which is called by it ("ms"), or has it behind another sign ("time-ms"). Not
/// of the words of a comment, which may be sentences.
template <std::size_t n>
std::string_view lone_unit(std::string_view name, const std::array<std::string_view, n>& words) {
  const std::size_t cut = name.find_last_of("-.:|");
  const std::string_view last = trimmed(cut == std::string_view::npos ? name : name.substr(cut + 1));
  return std::find(words.begin(), words.end(), last) == words.end() ? std::string_view{} : last;
}

/// Tables of time are in SI units: a column that says otherwise is not read as if it did not.
template <std::size_t n>
void require_unit(const DelimitedTable& rows, std::size_t column, std::string_view stated(std::string_view),
                  const std::array<std::string_view, n>& words, bool plain(std::string_view),
                  const char* way_out) {
  if (rows.names().empty()) return;
  const std::string& name = rows.names()[column];
  const std::string_view behind = stated(name), unit = behind.empty() ? lone_unit(name, words) : behind;
  if (unit.empty() || plain(unit)) return;
  throw InputError(fmt::format("{}: column '{}' is in {}; {}", rows.where_header(), name, unit, way_out));
}

bool is_second(std::string_view unit) {
  return unit == "s" || unit == "sec" || unit == "second" || unit == "seconds";
}

std::string_view unit_of_time(std::string_view name) {
  return stated_unit(name, of_times);
}
std::string_view unit_of_value(std::string_view name) {
  const std::string_view unit = stated_unit(name, of_values);
  return unit.empty() ? split_column_unit(name).unit : unit;  // "T_C"
}

bool is_unit_of_value(std::string_view unit) {
  constexpr std::array<std::string_view, 4> plain = {"K", "V", "W", "A"};
  const std::string word = lower_case(unit);
  return std::find(plain.begin(), plain.end(), unit) != plain.end() || word == "kelvin" || word == "volt" ||
         word == "volts" || word == "watt" || word == "watts" || word == "ampere" || word == "amperes";
}

/// Of columns in a comment as well: "# time_ms P_mW".
HeaderRule profile_header(const std::string& time, const std::string& value) {
  return or_states_unit(header_of({time, value}, 2), [](std::string_view name) {
    const std::string_view unit = unit_of_time(name);
    return unit.empty() ? unit_of_value(name) : unit;
  });
}

TimeTable read_profile(TomlTable& table, const TomlValue& file) {
  const std::string path = named_path(file),
                    text = read_named_file(file, [](const auto&name) { return read_text_file(name); });
  const auto name_of = [&](const char* key) {
    const auto stated = table.find(key);
    return bare_name(stated ? stated->string() : key);
  };
  DelimitedTable rows(path, text, profile_header(name_of("time"), name_of("value")));
  const auto column = [&](const char* key, std::size_t fallback) {
    const auto stated = table.find(key);
    return column_named(rows, stated ? stated->string() : key, stated ? stated->where() : path,
                        stated ? std::nullopt : std::optional(fallback));
  };
  const std::size_t time = column("time", 0), value = column("value", 1);
  require_unit(rows, time, unit_of_time, of_times, is_second, "times must be in s");
  if (!table.find("scale"))
    require_unit(rows, value, unit_of_value, of_values, is_unit_of_value,
                 "values must be in K, V, W or A; or give scale, by which they are multiplied");
  TimeTable out;
  std::vector<std::size_t> line;
  while (rows.next()) {
    out.time.push_back(number_in(rows, time));
    out.value.push_back(number_in(rows, value));
    line.push_back(rows.line());
  }
  if (out.time.empty())
    throw InputError(fmt::format("{}: has no rows; a profile needs at least one instant", path));
  join_same_instants(out.time);
  const auto reject = [&](std::size_t k, const std::string& rule) {
    throw InputError(fmt::format("{}:{}: {}", path, line[k], rule));
  };
  require_ascending(out.time, reject);
  require_workable_instants(out.time, reject);
  return out;
}

/// The profile over and over, from t = 0 to t_end. Where it is shorter than its period, the line from its
/// last value to its first closes it.
TimeTable repeated(const TimeTable& once, const TomlValue& period, double t_end) {
  constexpr double most_knots = 5e6;
  const double length = period.number(), own = once.time.back() - once.time.front();
  if (!(length > 0)) period.reject("it must be > 0 [s]");
  if (own > length && !is_same_instant(once.time.front() + length, once.time.back()))
    period.reject(fmt::format("the profile is {} s long, and must not be longer than its period", own));
  const double first = std::floor((0 - once.time.front()) / length),
               last = std::ceil((t_end - once.time.front()) / length);
  constexpr double most_turns = 0x1p53;  // beyond, turns can not be counted
  if (!(std::abs(first) < most_turns && std::abs(last) < most_turns))
    period.reject(fmt::format(
        "it is nothing beside the instants of the profile, which begins at {} s, or beside t_end = {} s",
        once.time.front(), t_end));
  if ((last - first + 1) * static_cast<double>(once.time.size()) > most_knots)
    period.reject(fmt::format(
        "up to t_end = {} s the profile would have more than {} instants; it is too short, or t_end "
        "too late",
        t_end, most_knots));
  TimeTable out;
  for (auto turn = static_cast<std::int64_t>(first); turn <= static_cast<std::int64_t>(last); ++turn)
    for (std::size_t k = 0; k < once.time.size(); ++k) {
      // Where a period ends and the next begins is one instant, however it is rounded.
      double at = once.time[k] + static_cast<double>(turn) * length;
      if (!out.time.empty() && (at < out.time.back() || is_same_instant(at, out.time.back())))
        at = out.time.back();
      const std::size_t n = out.time.size();
      if (n >= 2 && out.time[n - 1] == at && out.time[n - 2] == at) {
        out.value[n - 1] =
            once.value[k];  // a step at the seam of two periods: what lies between has no duration
        continue;
      }
      out.time.push_back(at);
      out.value.push_back(once.value[k]);
    }
  return out;
}

void require_covered(const TomlValue& outside, const TimeTable& table, double t_end) {
  if (table.time.front() > 0 || table.time.back() < t_end)
    outside.reject(fmt::format(
        "the table holds from {} to {} s, and the run goes from 0 to {} s; lengthen the table, or "
        "choose \"clamp\" or \"zero\"",
        table.time.front(), table.time.back(), t_end));
}

/// Nothing before the first and after the last instant. A step there needs two equal times.
void add_zero_ends(const TomlValue& outside, TimeTable& table) {
  const auto is_step = [&](std::size_t k) {
    return table.time.size() > k + 1 && table.time[k] == table.time[k + 1];
  };
  if (is_step(0) || (table.time.size() > 1 && is_step(table.time.size() - 2)))
    outside.reject(
        "the table begins or ends with a step, which \"zero\" makes itself; leave the first or the last row "
        "out");
  table.time.insert(table.time.begin(), table.time.front());
  table.value.insert(table.value.begin(), 0.0);
  if (table.time.size() == 2 && table.time[0] == table.time[1])
    outside.reject("a single instant lasts no time");
  table.time.push_back(table.time.back());
  table.value.push_back(0.0);
}

void apply_outside(const TomlValue& outside, double t_end, TimeTable& table) {
  const std::string word = outside.string();
  if (word == "error")
    require_covered(outside, table, t_end);
  else if (word == "zero")
    add_zero_ends(outside, table);
  else if (word != "clamp")
    outside.reject("it must be \"clamp\", \"zero\" or \"error\"");
}

}  // namespace

Amount read_amount(const TomlValue& amount, double t_end, Graph& graph) {
  if (!amount.is_table()) return {amount.number(), -1};
  TomlTable table = amount.table();
  for (const char* key : {"file", "time", "value", "times", "values", "scale", "period", "outside"})
    (void)table.find(key);
  table.finish();  // a misspelt key is said first: without it another column would be looked for
  const auto file = table.find("file");
  if (file && (table.find("times") || table.find("values")))
    file->reject("give either a file, or times and values");
  TimeTable out = file ? read_profile(table, *file) : read_lists(table);
  const auto scale = table.find("scale"), period = table.find("period"), outside = table.find("outside");
  if (scale)
    for (double& value : out.value) value *= scale->number();
  if (period && outside) outside->reject("a table with a period has no outside; leave one of the two out");
  if (period) {
    out = repeated(out, *period, t_end);
    require_workable_instants(out.time, [&](std::size_t, const std::string& rule) { period->reject(rule); });
  }
  if (outside) apply_outside(*outside, t_end, out);
  graph.tables.push_back(std::move(out));
  return {graph.tables.back().at(0), static_cast<std::int32_t>(graph.tables.size()) - 1};
}

}  // namespace superstep

#include "packing/read.hpp"

#include <fmt/format.h>

#include <fstream>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/formats.hpp"
#include "packing/formats/text_row.hpp"

namespace superstep {
namespace {

using Reader = Packing (*)(const PackingFile&);

bool all_numbers(const TextRow& row) {
  for (std::size_t k = 0; k < row.size(); ++k)
    if (!parse_number(row[k])) return false;
  return true;
}

/// The reader that the beginning of the text asks for; nullptr when it looks like none of the blank-separated
/// formats.
Reader recognise(std::string_view text) {
  constexpr std::size_t mercury_header = 8, header_lines = 100;
  LineReader lines(text);
  TextRow row{std::string{}};
  bool is_first = true;
  while (lines.next() && lines.number() <= header_lines) {
    row.split(lines.line(), lines.number());
    if (row.size() == 0) continue;
    if (row[0] == "#format") return read_yade;
    if (row.size() >= 2 && row[1] == "atoms" && parse_integer(row[0])) return read_lammps_data;
    if (row[0].front() == '#') continue;
    if (is_first && row[0] == "ITEM:") return read_lammps_dump;
    if (is_first && row.size() == mercury_header && all_numbers(row)) return read_mercury;
    is_first = false;
  }
  return nullptr;
}

/// A text without a comma in its first line cannot be CSV.
void require_csv(const std::string& path, std::string_view text) {
  LineReader lines(text);
  while (lines.next() && (trimmed(lines.line()).empty() || trimmed(lines.line()).front() == '#')) {
  }
  if (lines.line().find(',') == std::string_view::npos)
    throw InputError(
        fmt::format("{}:{}: line {} begins none of the known formats: CSV with header id,x,y,z,radius, "
                    "LAMMPS/LIGGGHTS dump or data, Yade text with #format, MercuryDPM .data in 3-D; write "
                    "the packing as one of these",
                    path, lines.number(), quoted(lines.line())));
}

}  // namespace

Packing read_packing(const std::string& path, double unit) {
  {
    const std::string text = read_text_file(path);
    if (const Reader reader = recognise(text)) return reader({path, text, unit});
    require_csv(path, text);
  }
  return read_csv(path, unit);
}

bool reads_as_packing(const std::string& path) {
  try {
    (void)read_packing(path);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::string stated_length_unit(const std::string& path) {
  constexpr std::string_view key = "length_unit";
  require_regular_file(path);
  std::ifstream stream(
      path);  // the comments at the top alone: whoever reads the rest says what is wrong with it
  std::size_t number = 0;
  for (std::string text; std::getline(stream, text);) {
    ++number;
    std::string_view line = trimmed(text);
    if (line.empty()) continue;
    if (line.front() != '#') break;
    line = trimmed(line.substr(1));
    if (!line.starts_with(key)) continue;
    line = trimmed(line.substr(key.size()));
    if (line.empty() || line.front() != '=') continue;
    line = trimmed(line.substr(1));
    if (line.size() >= 2 && line.front() == '"' && line.back() == '"') line = line.substr(1, line.size() - 2);
    const std::string name(line);
    (void)length_unit(name, fmt::format("{}:{}", path, number));
    return name;
  }
  return {};
}

double length_unit(const std::string& name, const std::string& where) {
  if (name == "m") return 1.0;
  if (name == "cm") return 1e-2;
  if (name == "mm") return 1e-3;
  if (name == "um") return 1e-6;
  if (name == "nm") return 1e-9;
  throw InputError(fmt::format("{}: length unit is {}; valid are: m, cm, mm, um, nm", where, quoted(name)));
}

}  // namespace superstep

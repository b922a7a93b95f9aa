/// VTK legacy files, ASCII and binary: points and their data, cells left out.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/error.hpp"
#include "core/text/delimited.hpp"
#include "core/text/number.hpp"
#include "core/text/text_file.hpp"
#include "packing/formats/vtk/vtk_array.hpp"

namespace superstep {
namespace {

constexpr std::string_view magic = "# vtk DataFile Version";

bool recognises(const PackingFile& file) {
  return file.content.starts_with(magic);
}

/// Walks a file in which lines of words and blocks of values follow each other.
class Walker {
 public:
  explicit Walker(const PackingFile& file) : path_(file.path), all_(file.content), rest_(file.content) {}

  [[nodiscard]] std::string_view line() {
    const std::size_t end = rest_.find('\n');
    const std::string_view out = trimmed(rest_.substr(0, end));
    rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
    return out;
  }
  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }

  /// So many values; `keep` tells whether they are wanted.
  std::vector<double> values(std::size_t count, const std::string& type_name, const std::string& what,
                             bool keep) {
    const auto type = vtk_type(type_name);
    if (!type)
      fail(fmt::format("{} has the type {}, which is not read; write numbers", what, in_quotes(type_name)));
    std::vector<double> out;
    if (binary) {
      if (count > rest_.size() / type->size)
        fail(fmt::format("ends inside {}; it is cut off: write it again", what));
      if (keep) append_values(rest_.substr(0, count * type->size), *type, true, out);
      rest_.remove_prefix(count * type->size);
    } else {
      if (count > rest_.size()) fail(fmt::format("ends inside {}; it is cut off: write it again", what));
      if (keep) out.reserve(count);
      for (std::size_t k = 0; k < count; ++k) {
        const auto word = next_word();
        if (word.empty()) fail(fmt::format("ends inside {}; it is cut off: write it again", what));
        if (!keep) continue;
        const auto value = parse_number(word);
        // What is no number is refused where it is needed; among attributes it is a gap.
        out.push_back(value ? *value : std::numeric_limits<double>::quiet_NaN());
        if (!value && !std::isalpha(static_cast<unsigned char>(word.front())) && word.front() != '-')
          fail(fmt::format("{} holds {}; it must hold numbers", what, in_quotes(word)));
      }
    }
    return out;
  }
  [[noreturn]] void fail(const std::string& reason) const {
    const auto used = static_cast<std::ptrdiff_t>(all_.size() - rest_.size());
    throw InputError(
        fmt::format("{}:{}: {}", path_, 1 + std::count(all_.begin(), all_.begin() + used, '\n'), reason));
  }

  bool binary = false;

 private:
  std::string_view next_word() {
    const std::size_t begin = rest_.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return {};
    const std::size_t end = std::min(rest_.find_first_of(" \t\r\n", begin), rest_.size());
    const std::string_view word = rest_.substr(begin, end - begin);
    rest_.remove_prefix(end);
    return word;
  }

  std::string path_;
  std::string_view all_, rest_;
};

using Words = std::vector<std::string_view>;

std::size_t count_of(const Walker& walker, const Words& words, std::size_t k) {
  const auto value = k < words.size() ? parse_integer(words[k]) : std::nullopt;
  constexpr std::int64_t most = std::int64_t{1} << 40;  // more than any file that is read
  if (!value || *value < 0 || *value > most) walker.fail(fmt::format("'{}' needs a count", words[0]));
  return static_cast<std::size_t>(*value);
}

std::string word(const Words& words, std::size_t k) {
  return k < words.size() ? std::string(words[k]) : std::string{};
}

/// A name with its %20 and the like as what they stand for.
std::string array_name(const Words& words, std::size_t k) {
  const std::string written = word(words, k);
  std::string out;
  for (std::size_t at = 0; at < written.size(); ++at) {
    unsigned code = 0;
    const char* const hex = written.data() + at + 1;
    const bool is_code = written[at] == '%' && at + 2 < written.size() &&
                         std::from_chars(hex, hex + 2, code, 16).ptr == hex + 2 && code >= ' ';
    out += is_code ? static_cast<char>(code) : written[at];
    at += is_code ? 2 : 0;
  }
  return out;
}

/// Data that follows POINT_DATA or CELL_DATA.
class LegacyReader {
 public:
  explicit LegacyReader(const PackingFile& file) : file_(file), walker_(file) {}

  Packing read() {
    (void)walker_.line();
    (void)walker_.line();  // a title, whatever it says
    const std::string kind(walker_.line());
    walker_.binary = kind == "BINARY";
    if (!walker_.binary && kind != "ASCII") walker_.fail("the third line must be ASCII or BINARY");
    while (!walker_.at_end()) {
      const std::string_view line = walker_.line();
      if (line.empty()) continue;
      split(line);
      section();
    }
    if (points_.empty())
      throw InputError(fmt::format("{}: has no points; at least one is needed", file_.path));
    return packing_of_points(file_, points_, data_);
  }

 private:
  void split(std::string_view line) {
    if (!split_cells(line, ' ', words_))
      walker_.fail(fmt::format("{} has a quote that is not closed; write the file again", in_quotes(line)));
  }
  void section() {
    const std::string_view key = words_[0];
    if (key == "POINTS") {
      if (in_data_ || !points_.empty())
        walker_.fail("POINTS stands twice, or below data; a file holds one list of points, above their data");
      tuples_ = count_of(walker_, words_, 1);
      components_ = 3;
      points_ = walker_.values(3 * tuples_, word(words_, 2), "POINTS", true);
    } else if (key == "VERTICES" || key == "LINES" || key == "POLYGONS" || key == "TRIANGLE_STRIPS" ||
               key == "CELLS") {
      cells();
    } else if (key == "CELL_TYPES") {
      (void)walker_.values(count_of(walker_, words_, 1), "int", "CELL_TYPES", false);
    } else if (key == "OFFSETS" || key == "CONNECTIVITY") {
      (void)walker_.values(key == "OFFSETS" ? offsets_ : connectivity_, word(words_, 1), std::string(key),
                           false);
    } else if (key == "POINT_DATA" || key == "CELL_DATA") {
      in_data_ = true;
      of_points_ = key == "POINT_DATA";
      tuples_ = count_of(walker_, words_, 1);
      if (of_points_ && 3 * tuples_ != points_.size())
        walker_.fail(
            fmt::format("POINT_DATA announces {} points, and POINTS has {}; the file is damaged: "
                        "write it again",
                        tuples_, points_.size() / 3));
    } else if (key == "METADATA") {
      metadata();
    } else if (key == "SCALARS") {
      scalars();
    } else if (const std::size_t components = components_of(key); components > 0) {
      array(array_name(words_, 1), components, word(words_, 2));
    } else if (key == "TEXTURE_COORDINATES") {
      array(array_name(words_, 1), count_of(walker_, words_, 2), word(words_, 3));
    } else if (key == "COLOR_SCALARS") {
      array(array_name(words_, 1), count_of(walker_, words_, 2), walker_.binary ? "unsigned_char" : "float");
    } else if (key == "LOOKUP_TABLE") {
      (void)walker_.values(4 * count_of(walker_, words_, 2), walker_.binary ? "unsigned_char" : "float",
                           "LOOKUP_TABLE", false);
    } else if (key == "FIELD") {
      field();
    } else if (in_data_) {
      walker_.fail(
          fmt::format("{} begins no data that are read; write the file without them", in_quotes(key)));
    } else if (key != "DATASET") {
      walker_.fail(
          fmt::format("{} begins no section of points that is read; write POLYDATA or UNSTRUCTURED_GRID",
                      in_quotes(key)));
    }
  }

  /// Of data that are a name, a type and the values; 0 for others.
  static std::size_t components_of(std::string_view key) {
    if (key == "GLOBAL_IDS" || key == "PEDIGREE_IDS" || key == "EDGE_FLAGS") return 1;
    if (key == "VECTORS" || key == "NORMALS") return 3;
    return key == "TENSORS" ? 9 : key == "TENSORS6" ? 6 : 0;
  }

  /// An empty line ends it, but for names of the components of the last array, which may be empty.
  void metadata() {
    for (std::string_view line = walker_.line(); !line.empty(); line = walker_.line())
      for (std::size_t k = 0; line == "COMPONENT_NAMES" && k < components_; ++k) (void)walker_.line();
  }

  void cells() {
    const std::size_t count = count_of(walker_, words_, 1), size = count_of(walker_, words_, 2);
    Walker ahead = walker_;
    if (ahead.line().starts_with("OFFSETS")) {  // as of version 5.1
      offsets_ = count;
      connectivity_ = size;
    } else {
      (void)walker_.values(size, "int", std::string(words_[0]), false);
    }
  }

  void scalars() {
    const std::string name = array_name(words_, 1), type = word(words_, 2);
    const std::size_t components = words_.size() > 3 ? count_of(walker_, words_, 3) : 1;
    Walker ahead = walker_;
    if (ahead.line().starts_with("LOOKUP_TABLE")) walker_ = ahead;
    array(name, components, type);
  }

  void field() {
    const std::size_t arrays = count_of(walker_, words_, 2);
    for (std::size_t k = 0; k < arrays; ++k) {
      std::string_view line;
      while (line.empty() && !walker_.at_end()) line = walker_.line();
      if (line.empty()) walker_.fail("ends inside FIELD; it is cut off: write it again");
      split(line);
      if (words_[0] == "METADATA") {
        section();
        --k;
        continue;
      }
      const std::string name = array_name(words_, 0), type = word(words_, 3);
      const std::size_t components = count_of(walker_, words_, 1), tuples = count_of(walker_, words_, 2);
      if (type == "string") walker_.fail(fmt::format("array '{}' holds strings; leave it out", name));
      array(name, components, type, tuples);
    }
  }

  void array(const std::string& name, std::size_t components, const std::string& type,
             std::optional<std::size_t> own_tuples = {}) {
    const std::size_t tuples = own_tuples.value_or(tuples_);
    constexpr std::size_t most = 1000;  // components; more is a slip
    if (components > most) walker_.fail(fmt::format("array '{}' has {} components", name, components));
    components_ = components;
    const bool keep = of_points_ && components > 0 && 3 * tuples == points_.size();
    auto values = walker_.values(components * tuples, type, fmt::format("array '{}'", name), keep);
    if (keep) data_.push_back({name, components, std::move(values)});
  }

  const PackingFile& file_;
  Walker walker_;
  Words words_;
  std::vector<double> points_;
  std::vector<VtkArray> data_;
  std::size_t tuples_ = 0, offsets_ = 0, connectivity_ = 0;
  std::size_t components_ = 0;  ///< of the last array
  bool in_data_ = false, of_points_ = false;
};

Packing read(const PackingFile& file) {
  return LegacyReader(file).read();
}

}  // namespace

PackingFormat vtk_legacy_format() {
  return {"VTK legacy", recognises, read, true, true};
}

}  // namespace superstep

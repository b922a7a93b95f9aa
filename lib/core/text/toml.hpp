#pragma once
/// Case files in TOML, read strictly: every value is typed, every key is known, every error names file and
/// line.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace superstep {

class TomlTable;

/// One value of a case file with its place. Conversions throw InputError when the type is another one.
/// In size, of any number that may be computed with: squares of what solvers form of them still fit.
inline constexpr double largest_number = 1e40;

class TomlValue {
 public:
  [[nodiscard]] bool is_number() const noexcept;
  [[nodiscard]] bool is_integer() const noexcept;
  [[nodiscard]] bool is_string() const noexcept;
  [[nodiscard]] bool is_array() const noexcept;
  [[nodiscard]] bool is_table() const noexcept;

  [[nodiscard]] double number() const;  ///< integer or float, at most 1e40 in size
  [[nodiscard]] std::int64_t integer() const;
  [[nodiscard]] bool boolean() const;
  [[nodiscard]] std::string string() const;
  [[nodiscard]] std::vector<TomlValue> array() const;
  [[nodiscard]] std::vector<double> numbers() const;
  [[nodiscard]] std::vector<std::string> strings() const;
  [[nodiscard]] TomlTable table() const;

  [[nodiscard]] const std::string& file() const noexcept;
  /// "file:line: key 'a.b'", or "file: key 'a.b'" of an unseen text, to begin an error message with.
  [[nodiscard]] std::string where() const;
  /// The value as an error message quotes it.
  [[nodiscard]] std::string shown() const;
  /// Throws InputError "where is shown; rule".
  [[noreturn]] void reject(const std::string& rule) const;

 private:
  friend class TomlTable;
  struct Node;
  explicit TomlValue(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

/// A table of a case file. The file remembers which keys were asked for in which table, those inside arrays
/// included: what nobody asked for is an error once `finish` is called, at the root for all of them.
class TomlTable {
 public:
  /// Parses a file. Throws InputError for anything that is not TOML, too large, or nested too deeply.
  [[nodiscard]] static TomlTable parse_file(const std::string& path);
  [[nodiscard]] static TomlTable parse_text(const std::string& text, const std::string& path);
  /// The same of a text that a program wrote and nobody sees: errors name keys, and no lines.
  [[nodiscard]] static TomlTable parse_unseen(const std::string& text, const std::string& path);

  /// Value under `key`, marked as known.
  [[nodiscard]] std::optional<TomlValue> find(const std::string& key);
  /// Value under `key`; InputError when it is missing, with `why` as the way out.
  [[nodiscard]] TomlValue require(const std::string& key, const std::string& why);

  [[nodiscard]] std::optional<double> number(const std::string& key);
  [[nodiscard]] double positive(const std::string& key, const std::string& unit);
  [[nodiscard]] std::optional<std::string> string(const std::string& key);
  [[nodiscard]] std::optional<TomlTable> table(const std::string& key);

  /// Throws InputError because `key` is not there: "where: what", or, where a key that nobody asked for
  /// looks like it or like one that was asked for, that one is misspelt.
  [[noreturn]] void missing(const std::string& key, const std::string& what) const;

  /// Throws InputError for the first key, here or in a table below that was read, that was never asked for;
  /// names the nearest that was.
  void finish() const;
  /// "file:line: [a.b]"
  [[nodiscard]] std::string where() const;
  [[nodiscard]] const std::string& file() const noexcept;
  /// Every key that has been asked for in any table of the file, whether it is there or not, by its place:
  /// `thermal.fixed[0].value`.
  [[nodiscard]] std::vector<std::string> asked_keys() const;

  /// One value of this table or of one inside it: its place, as in `thermal.fixed[0].value`, and its content
  /// with its type, in which numbers that are equal read the same. `text` is what a string holds, else empty.
  struct Leaf {
    std::string path, content, text;
  };
  /// All values, sorted by place: two files with the same leaves mean the same.
  [[nodiscard]] std::vector<Leaf> leaves() const;

 private:
  friend class TomlValue;
  struct Data;
  static TomlTable parse(const std::string& text, const std::string& path, bool has_lines);
  explicit TomlTable(std::shared_ptr<Data> data) : data_(std::move(data)) {}
  std::shared_ptr<Data> data_;
};

}  // namespace superstep

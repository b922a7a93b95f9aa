#include "toml_text.hpp"

#include <algorithm>

namespace superstep::test {
namespace {

class Writer {
 public:
  explicit Writer(const std::optional<Edit>& edit) : edit_(edit) {}

  void table(const Tree& tree, const std::string& path) {
    for (const auto& [name, value] : tree.items()) {
      const std::string place = path.empty() ? name : path + "." + name;
      if (value.is_object() && !edited(place)) continue;
      begin(place);
      out_.text += pair(name, value, place, "\n") + "\n";
      line_ = 1 + static_cast<int>(std::count(out_.text.begin(), out_.text.end(), '\n'));
    }
    for (const auto& [name, value] : tree.items()) {
      const std::string place = path.empty() ? name : path + "." + name;
      if (!value.is_object() || edited(place)) continue;
      begin(place);
      out_.text += "[" + place + "]\n";
      ++line_;
      table(value, place);
    }
  }
  [[nodiscard]] TomlText take() { return std::move(out_); }

 private:
  [[nodiscard]] bool edited(const std::string& place) const { return edit_ && edit_->place == place; }
  void begin(const std::string& place) { out_.line[place] = line_; }

  std::string pair(const std::string& name, const Tree& value, const std::string& place,
                   const std::string& separator) {
    if (!edited(place)) return name + " = " + text(value, place);
    const std::string wrong = edit_->key + " = " + edit_->value;
    out_.line_of_more = line_ + (separator == "\n" ? 1 : 0);
    return edit_->more.empty() ? wrong : wrong + separator + edit_->more;
  }

  std::string text(const Tree& value, const std::string& place) {
    if (value.is_array()) {
      const bool tables = !value.empty() && value.front().is_object();
      std::string out = "[";
      for (std::size_t k = 0; k < value.size(); ++k) {
        if (tables) {
          out += "\n  ";
          ++line_;
        }
        out += text(value[k], place + "[" + std::to_string(k) + "]");
        if (k + 1 < value.size()) out += ", ";
      }
      return out + "]";
    }
    if (!value.is_object()) return value.dump();
    std::string out = "{ ";
    for (const auto& [name, inner] : value.items()) {
      if (out.size() > 2) out += ", ";
      begin(place + "." + name);
      out += pair(name, inner, place + "." + name, ", ");
    }
    return out + " }";
  }

  const std::optional<Edit>& edit_;
  TomlText out_;
  int line_ = 1;
};

}  // namespace

TomlText toml_text(const Tree& root, const std::optional<Edit>& edit) {
  Writer writer(edit);
  writer.table(root, "");
  return writer.take();
}

std::string toml_value(const Tree& value) {
  std::string text = toml_text({{"a", Tree::array({value})}}).text;  // "a = [...]\n"
  text = text.substr(text.find('[') + 1);
  text = text.substr(0, text.rfind(']'));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace superstep::test

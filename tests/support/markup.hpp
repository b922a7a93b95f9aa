#pragma once
/// A strict little reader of markup: enough to tell whether elements are nested as they should be.

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace superstep::test {

/// What is wrong with the nesting of `markup`; empty when nothing is. Counts elements by name on the way.
class MarkupReader {
 public:
  explicit MarkupReader(std::string_view markup) : rest_(markup) {}

  std::string problem() {
    while (next_tag()) {
      if (name_.starts_with('!') || name_.starts_with('?')) continue;
      if (closing_) {
        if (open_.empty() || open_.back() != name_) return "</" + name_ + "> closes <" + last() + ">";
        open_.pop_back();
        continue;
      }
      seen_.push_back(name_);
      if (empty_ || is_void()) continue;
      if (name_ == "script" || name_ == "style") {  // raw text up to its end tag
        const auto end = rest_.find("</" + name_);
        if (end == std::string_view::npos) return "<" + name_ + "> stays open";
        rest_.remove_prefix(end);
      }
      open_.push_back(name_);
    }
    return open_.empty() ? "" : "<" + last() + "> stays open";
  }
  [[nodiscard]] int count(const std::string& name) const {
    int n = 0;
    for (const auto& seen : seen_) n += seen == name ? 1 : 0;
    return n;
  }

 private:
  bool next_tag() {
    const auto begin = rest_.find('<');
    if (begin == std::string_view::npos) return false;
    rest_.remove_prefix(begin + 1);
    closing_ = rest_.starts_with('/');
    if (closing_) rest_.remove_prefix(1);
    std::size_t end = 0;
    while (end < rest_.size() && rest_[end] != '>' && rest_[end] != '/' &&
           !std::isspace(static_cast<unsigned char>(rest_[end])))
      ++end;
    name_ = std::string(rest_.substr(0, end));
    char quote = 0;
    for (; end < rest_.size() && (quote != 0 || rest_[end] != '>'); ++end) {
      if (quote == 0 && rest_[end] == '"')
        quote = '"';
      else if (rest_[end] == quote)
        quote = 0;
    }
    empty_ = end > 0 && end < rest_.size() && rest_[end - 1] == '/';
    rest_.remove_prefix(end < rest_.size() ? end + 1 : rest_.size());
    return true;
  }
  [[nodiscard]] bool is_void() const {
    return name_ == "meta" || name_ == "link" || name_ == "br" || name_ == "wbr" || name_ == "img" ||
           name_ == "hr";
  }
  [[nodiscard]] std::string last() const { return open_.empty() ? "nothing" : open_.back(); }

  std::string_view rest_;
  std::string name_;
  bool closing_ = false, empty_ = false;
  std::vector<std::string> open_, seen_;
};

}  // namespace superstep::test

#pragma once
/// The little of XML that VTK files consist of: elements with attributes, walked from front to back.

#include <map>
#include <string>
#include <string_view>

namespace superstep {

/// One opening, closing or empty tag.
struct XmlTag {
  std::string name;  ///< without '/'
  std::map<std::string, std::string> attributes;
  bool closes = false;             ///< </name>
  bool is_empty = false;           ///< <name/>
  std::size_t begin = 0, end = 0;  ///< of the text, '<' included, '>' included
};

class XmlScanner {
 public:
  explicit XmlScanner(std::string_view text) : text_(text) {}
  /// The next tag from `position` on; false at the end or where a tag is not closed. Comments and
  /// declarations are skipped.
  bool next(XmlTag& tag);
  void go_to(std::size_t position) noexcept { at_ = position; }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace superstep

#include "packing/formats/vtk/xml_scan.hpp"

#include "core/text/text_file.hpp"

namespace superstep {
namespace {

void read_attributes(std::string_view text, std::map<std::string, std::string>& out) {
  for (;;) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos) return;
    std::string_view name = text.substr(0, equals);
    const std::size_t first = name.find_last_not_of(" \t\r\n");
    name = first == std::string_view::npos ? std::string_view{} : name.substr(0, first + 1);
    if (const auto blank = name.find_last_of(" \t\r\n"); blank != std::string_view::npos)
      name.remove_prefix(blank + 1);
    const std::size_t open = text.find_first_of("\"'", equals);
    if (open == std::string_view::npos) return;
    const std::size_t close = text.find(text[open], open + 1);
    if (close == std::string_view::npos) return;
    out.emplace(std::string(name), std::string(text.substr(open + 1, close - open - 1)));
    text.remove_prefix(close + 1);
  }
}

}  // namespace

bool XmlScanner::next(XmlTag& tag) {
  for (;;) {
    const std::size_t begin = text_.find('<', at_);
    if (begin == std::string_view::npos) return false;
    const bool is_comment = text_.substr(begin).starts_with("<!--");
    const std::size_t end = is_comment ? text_.find("-->", begin) : text_.find('>', begin);
    if (end == std::string_view::npos) return false;
    at_ = end + (is_comment ? 3 : 1);
    if (is_comment || text_[begin + 1] == '?' || text_[begin + 1] == '!') continue;
    std::string_view inside = text_.substr(begin + 1, end - begin - 1);
    tag = {};
    tag.begin = begin;
    tag.end = end + 1;
    tag.closes = !inside.empty() && inside.front() == '/';
    if (tag.closes) inside.remove_prefix(1);
    tag.is_empty = !inside.empty() && inside.back() == '/';
    if (tag.is_empty) inside.remove_suffix(1);
    const std::size_t name_end = inside.find_first_of(" \t\r\n");
    tag.name = std::string(inside.substr(0, name_end));
    if (name_end != std::string_view::npos) read_attributes(inside.substr(name_end), tag.attributes);
    return true;
  }
}

}  // namespace superstep

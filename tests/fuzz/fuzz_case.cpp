/// A case file and the files that it names, moving particles included: read, warned about and assessed as
/// `info` does.

#include <cctype>

#include "case/case.hpp"
#include "case/checks/health.hpp"
#include "case/checks/warnings.hpp"
#include "case/content_hash.hpp"
#include "input_folder.hpp"

namespace {

/// A generator that is asked for a million particles takes as long as it says.
bool asks_for_many(std::string_view text) {
  if (text.find("generator") == text.npos && text.find("count") == text.npos) return false;
  std::size_t digits = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(text[k])) || text[k] == '_';
    if (digits > 0 && (text[k] == 'e' || text[k] == 'E')) return true;
    digits = is_digit ? digits + 1 : 0;
    if (digits > 2) return true;
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const std::string_view text = fuzz::text_of(data, size);
  if (asks_for_many(text)) return -1;
  const fuzz::InputFolder folder(text, "case.toml");
  fuzz::read_or_refuse([&] {
    const TomlTable root = parse_case(folder.path() + "/case.toml");
    const Case one = load_case(root);
    (void)content_hash(root);
    if (const auto* scene = std::get_if<Scene>(&one)) {
      (void)range_warnings(*scene);
      (void)implausible_sizes(*scene);
      (void)assess_network(*scene);
    }
  });
  return 0;
}

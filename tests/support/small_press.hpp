#pragma once
/// A case with moving particles that is over in a moment.

#include <string>

#include "core/text/text_file.hpp"
#include "support/temporary_case.hpp"

namespace superstep::test {

/// Thirty particles in a small press, a few hundredths of a second.
inline std::string small_press(const CaseFolder& folder, const std::string& more = "") {
  const std::string text = read_text_file(SUPERSTEP_SOURCE_DIR "/tests/support/small_press.toml");
  return folder.write("press.toml", text + more);
}

}  // namespace superstep::test

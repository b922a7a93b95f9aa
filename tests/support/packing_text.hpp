#pragma once
/// Texts read as packing files.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/error.hpp"
#include "packing/read.hpp"
#include "support/temporary_folder.hpp"

namespace superstep::test {

inline Packing read_as(const std::string& name, const std::string& content,
                       const PackingOptions& options = {}) {
  const TemporaryFolder folder;
  return read_packing(folder.write(name, content), options);
}

/// What is said against a file p.txt of this content.
inline std::string refusal(const std::string& content, const PackingOptions& options = {},
                           const std::string& name = "p.txt") {
  return message_of<InputError>([&] { (void)read_as(name, content, options); });
}

/// One line that has all these parts.
inline void expect_says(const std::string& message, const std::vector<std::string>& parts) {
  for (const auto& part : parts)
    EXPECT_NE(message.find(part), std::string::npos) << part << " in: " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos);
}

inline bool notes(const Packing& packing, const std::string& part) {
  for (const auto& note : packing.notes)
    if (note.find(part) != std::string::npos) return true;
  return false;
}

inline bool warns(const Packing& packing, const std::string& part) {
  for (const auto& warning : packing.warnings)
    if (warning.find(part) != std::string::npos) return true;
  return false;
}

}  // namespace superstep::test

#pragma once
/// Small cases that hold, together, every key there is.

#include <vector>

#include "case/keys/case_keys.hpp"
#include "support/temporary_case.hpp"
#include "toml_text.hpp"

namespace superstep::test {

struct WholeCase {
  std::string name;
  CaseKey::Scene scene;
  Tree tree;
};

/// Writes the data files that they name into the folder.
[[nodiscard]] std::vector<WholeCase> whole_cases(const CaseFolder& folder);

}  // namespace superstep::test

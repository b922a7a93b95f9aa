#pragma once
/// What can be wrong about a key, made from what the list of keys says of it.

#include <string>
#include <vector>

#include "case/keys/case_keys.hpp"
#include "toml_text.hpp"

namespace superstep::test {

struct BadInput {
  std::string what;
  Edit edit;
};

/// Places of a tree with the values there, tables and arrays included: `thermal.fixed[0].value`.
[[nodiscard]] std::vector<std::pair<std::string, Tree>> places_of(const Tree& root);
/// The place as the list of keys has it: `thermal.fixed[].value`.
[[nodiscard]] std::string general_place(const std::string& place);

/// Everything about `key`, whose right value at `place` is `value`, that a reader has to refuse.
[[nodiscard]] std::vector<BadInput> bad_inputs(const CaseKey& key, const std::string& place,
                                               const Tree& value);

}  // namespace superstep::test

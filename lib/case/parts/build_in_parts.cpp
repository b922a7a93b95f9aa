#include "case/parts/build_in_parts.hpp"

#include <utility>

#include "case/layers/layered_scene.hpp"
#include "case/network/parts/shared_network.hpp"

namespace superstep {
namespace {

bool is_network(const TomlTable& root) {
  return TomlTable(root).find("network").has_value();
}

}  // namespace

bool can_be_in_parts(const TomlTable& root, std::string& why_not) {
  return is_network(root) ? can_be_shared_network(root, why_not) : can_be_layered(root, why_not);
}

Scene build_in_parts(TomlTable root, Communicator& among) {
  return is_network(root) ? build_shared_network(std::move(root), among)
                          : build_in_layers(std::move(root), among);
}

}  // namespace superstep

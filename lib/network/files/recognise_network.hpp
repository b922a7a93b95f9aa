#pragma once
/// What a file of a network is, by its content.

#include <optional>
#include <string>

#include "network/files/read_network.hpp"

namespace superstep {

struct NetworkFile {
  std::string format, key;  ///< in words; of [network]
  NetworkInput input;
};

/// Matrix Market, edges with a header or without one, OpenPNM's columns; nothing for other files. Throws
/// InputError where it is one of these and wrong.
[[nodiscard]] std::optional<NetworkFile> recognise_network(const std::string& path);

}  // namespace superstep

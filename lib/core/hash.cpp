#include "core/hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

#include <cstdint>
#include <new>

namespace superstep {

// The library's own type, under a name that the header can declare.
struct ContentHash::State {};

namespace {
XXH3_state_t* library(void* state) noexcept {
  return static_cast<XXH3_state_t*>(state);
}
}  // namespace

void ContentHash::Free::operator()(State* state) const noexcept {
  XXH3_freeState(library(state));
}

ContentHash::ContentHash() {
  void* state = XXH3_createState();
  if (!state) throw std::bad_alloc();
  state_.reset(static_cast<State*>(state));
  XXH3_128bits_reset(library(state));
}

ContentHash& ContentHash::add(std::string_view text) {
  const std::uint64_t size = text.size();
  XXH3_128bits_update(library(state_.get()), &size, sizeof size);
  if (size > 0) XXH3_128bits_update(library(state_.get()), text.data(), text.size());
  return *this;
}

ContentHash& ContentHash::add_number(double value) {
  return add({reinterpret_cast<const char*>(&value), sizeof value});
}

std::string ContentHash::text() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(library(state_.get()));
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

}  // namespace superstep

/// Layout (machine byte order; the cache does not travel):
///   magic[8] | checksum of the rest [32 hexadecimal digits] | vectors, each a 64-bit length and its doubles:
///   count of states, states..., count of CVODE's states, states..., error bar, spans, scalars, probes, times
///   of the history, orders, coefficients

#include "bench/harness/reference_cache.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <span>
#include <string_view>
#include <system_error>

#include "core/atomic_file.hpp"
#include "core/hash.hpp"

namespace superstep {
namespace {

constexpr std::string_view magic = "SSREF002";
constexpr std::size_t checksum_size = 32;

std::string checksum(std::string_view content) {
  return ContentHash().add(content).text();
}

void put(std::string& out, std::span<const double> values) {
  const std::uint64_t size = values.size();
  out.append(reinterpret_cast<const char*>(&size), sizeof size);
  out.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

void put(std::string& out, double value) {
  put(out, std::span(&value, 1));
}

/// Takes vectors off the front of a content; `good` turns false when there is less than promised.
struct Source {
  std::string_view rest;
  bool good = true;

  std::vector<double> vector() {
    std::uint64_t size = 0;
    if (!take(&size, sizeof size) || size > rest.size() / sizeof(double)) {
      good = false;
      return {};
    }
    std::vector<double> values(size);
    good = take(values.data(), size * sizeof(double)) && good;
    return values;
  }
  std::size_t count() {
    const auto values = vector();
    if (values.size() != 1 || !(values[0] >= 0) || values[0] > 1e9) good = false;
    return good ? static_cast<std::size_t>(values[0]) : 0;
  }
  bool take(void* out, std::size_t size) {
    if (size > rest.size()) return false;
    if (size > 0) std::memcpy(out, rest.data(), size);
    rest.remove_prefix(size);
    return true;
  }
};

std::optional<ProbeHistory> take_history(Source& source) {
  const std::size_t probes = source.count();
  ProbeHistory::Data data;
  data.time = source.vector();
  std::size_t coefficients = 0;
  constexpr double highest = 100;  // of any method
  for (const double order : source.vector()) {
    if (!(order >= 0 && order <= highest)) return std::nullopt;
    data.order.push_back(static_cast<int>(order));
    coefficients += (static_cast<std::size_t>(data.order.back()) + 1) * probes;
  }
  data.coefficient = source.vector();
  if (!source.good || data.order.size() != data.time.size() || data.coefficient.size() != coefficients)
    return std::nullopt;
  return ProbeHistory::from(probes, data);
}

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

std::string cache_folder() {
  if (const auto folder = environment("SUPERSTEP_CACHE"); !folder.empty()) return folder;
  if (const auto folder = environment("XDG_CACHE_HOME"); !folder.empty()) return folder + "/superstep";
  if (const auto folder = environment("HOME"); !folder.empty()) return folder + "/.cache/superstep";
  return {};
}

std::string cache_file(const std::string& key) {
  const std::string folder = cache_folder();
  return folder.empty() ? std::string{} : fmt::format("{}/{}.reference", folder, key);
}

std::optional<CachedReference> read_cached_reference(const std::string& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  const std::string content{std::istreambuf_iterator<char>(stream), {}};
  std::string_view rest = content;
  if (!rest.starts_with(magic) || rest.size() < magic.size() + checksum_size) return std::nullopt;
  rest.remove_prefix(magic.size());
  const auto expected = rest.substr(0, checksum_size);
  rest.remove_prefix(checksum_size);
  if (checksum(rest) != expected) return std::nullopt;

  Source source{rest};
  CachedReference reference;
  const std::size_t states = source.count();
  for (std::size_t k = 0; source.good && k < states; ++k) reference.states.push_back(source.vector());
  const std::size_t by_cvode = source.count();
  for (std::size_t k = 0; source.good && k < by_cvode; ++k) reference.cvode.push_back(source.vector());
  reference.error_bar = source.vector();
  reference.spans = source.vector();
  reference.scalars = source.vector();
  auto history = take_history(source);
  if (!source.good || !history || !source.rest.empty()) return std::nullopt;
  reference.history = std::move(*history);
  return reference;
}

void write_cached_reference(const std::string& file, const CachedReference& reference) {
  std::string content;
  put(content, static_cast<double>(reference.states.size()));
  for (const auto& state : reference.states) put(content, state);
  put(content, static_cast<double>(reference.cvode.size()));
  for (const auto& state : reference.cvode) put(content, state);
  put(content, reference.error_bar);
  put(content, reference.spans);
  put(content, reference.scalars);
  const auto history = reference.history.data();
  put(content, static_cast<double>(reference.history.probes()));
  put(content, history.time);
  put(content, std::vector<double>(history.order.begin(), history.order.end()));
  put(content, history.coefficient);
  write_file_atomically(file, std::string(magic) + checksum(content) + content);
}

}  // namespace superstep

#include "integrators/press/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <type_traits>

#include "core/error.hpp"
#include "core/hash.hpp"

namespace superstep::dynamics {
namespace {

// The last byte is the version: raise it whenever a stored type changes.
constexpr std::string_view magic = "superstep checkpoint 3\n";

class Writer {
 public:
  template <class Value>
  void put(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  template <class Value>
  void put(const std::vector<Value>& values) {
    put(static_cast<std::uint64_t>(values.size()));
    for (const auto& value : values) put(value);
  }
  void put(const std::string& text) { put(std::vector<char>(text.begin(), text.end())); }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

class Reader {
 public:
  Reader(std::string path, std::string_view bytes) : path_(std::move(path)), rest_(bytes) {}
  template <class Value>
  void get(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    need(sizeof value);
    std::memcpy(&value, rest_.data(), sizeof value);
    rest_.remove_prefix(sizeof value);
  }
  template <class Value>
  void get(std::vector<Value>& values) {
    std::uint64_t size = 0;
    get(size);
    if (size > rest_.size() / sizeof(Value)) damaged();
    values.resize(static_cast<std::size_t>(size));
    for (auto& value : values) get(value);
  }
  void get(std::string& text) {
    std::vector<char> letters;
    get(letters);
    text.assign(letters.begin(), letters.end());
  }
  void finish() const {
    if (!rest_.empty()) damaged();
  }

 private:
  void need(std::size_t size) const {
    if (rest_.size() < size) damaged();
  }
  [[noreturn]] void damaged() const {
    throw InputError(fmt::format("{}: is not a whole checkpoint; write it anew", path_));
  }
  std::string path_;
  std::string_view rest_;
};

// Rows have padding, whose content is undefined: store their members one by one.
template <class Stream, class Row, class Visit>
void visit_row(Stream& stream, Row& row, Visit visit) {
  visit(stream, row.time);
  visit(stream, row.phase);
  visit(stream, row.volume_fraction);
  visit(stream, row.mean_temperature);
  visit(stream, row.max_temperature);
  visit(stream, row.wall_force);
  visit(stream, row.kinetic_energy);
  visit(stream, row.bonds);
  visit(stream, row.contacts);
  visit(stream, row.step);
  visit(stream, row.iterations);
  visit(stream, row.rejections);
  for (auto* energy : {&row.wall_work, &row.potential_energy, &row.elastic_energy, &row.dissipated,
                       &row.joule_heat, &row.heat_lost, &row.heat_content})
    visit(stream, *energy);
  visit(stream, row.landed);
}

template <class Stream, class Content, class Visit>
void visit_content(Stream& stream, Content& content, Visit visit) {
  visit(stream, content.particles.id);
  visit(stream, content.particles.radius);
  visit(stream, content.particles.mass);
  visit(stream, content.particles.material);
  visit(stream, content.particles.specific_heat);
  visit(stream, content.particles.conductivity);
  visit(stream, content.particles.electric_conductivity);
  visit(stream, content.particles.hardness);
  visit(stream, content.state.time);
  visit(stream, content.state.position);
  visit(stream, content.state.velocity);
  visit(stream, content.state.temperature);
  visit(stream, content.state.electric);
  visit(stream, content.state.bonds);
  visit(stream, content.next_step);
  visit(stream, content.model);
}

bool is_finite(double value) {
  return std::isfinite(value);
}
bool is_finite(const Vec3& value) {
  return std::isfinite(value.x) && std::isfinite(value.y) && std::isfinite(value.z);
}

/// A checksum that fits says that nothing was damaged, and not that it makes sense: whoever goes on from the
/// state finds a value for each particle, numbers, and bonds between particles.
bool makes_sense(const Checkpoint& one) {
  const auto& [time, position, velocity, temperature, electric, bonds] = one.state;
  const std::size_t n = one.particles.id.size();
  const auto all_finite = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](const auto& value) { return is_finite(value); });
  };
  const auto joins_particles = [&](const Bond& bond) {
    const auto is_one = [n](std::int32_t i) { return i >= 0 && static_cast<std::size_t>(i) < n; };
    return is_one(bond.i) && is_one(bond.j) && bond.i != bond.j && is_finite(bond.overlap) &&
           is_finite(bond.growth);
  };
  return one.particles.radius.size() == n && one.particles.mass.size() == n && position.size() == n &&
         velocity.size() == n && temperature.size() == n && (electric.empty() || electric.size() == n) &&
         is_finite(time) && is_finite(one.next_step) && all_finite(position) && all_finite(velocity) &&
         all_finite(temperature) && all_finite(electric) &&
         std::all_of(bonds.begin(), bonds.end(), joins_particles);
}

}  // namespace

std::string checkpoint_image(const Checkpoint& checkpoint) {
  static_assert(std::has_unique_object_representations_v<std::int64_t>);
  static_assert(sizeof(Bond) == 24 && sizeof(Vec3) == 24, "no padding may be stored");
  Writer out;
  const auto put = [](Writer& stream, const auto& value) { stream.put(value); };
  visit_content(out, checkpoint, put);
  out.put(static_cast<std::uint64_t>(checkpoint.history.size()));
  for (const auto& row : checkpoint.history) visit_row(out, row, put);
  return std::string(magic) + ContentHash().add(out.bytes()).text() + out.bytes();
}

Checkpoint read_checkpoint(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error && status.type() != std::filesystem::file_type::not_found)
    throw InputError(fmt::format("{}: cannot be read: {}", path, error.message()));
  if (!std::filesystem::exists(status))
    throw InputError(fmt::format("{}: no such file; check the path", path));
  if (!std::filesystem::is_regular_file(status))
    throw InputError(fmt::format("{}: is no file; name a checkpoint.bin", path));
  std::ifstream file(path, std::ios::binary);
  if (!file) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  const std::string image{std::istreambuf_iterator<char>(file), {}};
  if (file.bad()) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  constexpr std::string_view any_version = "superstep checkpoint ";
  if (image.starts_with(any_version) && image.size() >= magic.size() && !image.starts_with(magic))
    throw InputError(
        fmt::format("{}: is a checkpoint of version {}, and this program reads version {}; go on with "
                    "the program that wrote it, or start anew",
                    path, image.substr(any_version.size(), 1), magic.substr(any_version.size(), 1)));
  if (!image.starts_with(magic))
    throw InputError(fmt::format("{}: is no checkpoint; name a checkpoint.bin", path));
  constexpr std::size_t checksum_size = 32;
  const std::string_view rest = std::string_view(image).substr(magic.size());
  const std::string_view body = rest.substr(std::min(checksum_size, rest.size()));
  if (rest.substr(0, checksum_size) != ContentHash().add(body).text())
    throw InputError(fmt::format("{}: is damaged (its checksum does not fit); write it anew", path));
  Reader in(path, body);
  Checkpoint checkpoint;
  const auto get = [](Reader& stream, auto& value) { stream.get(value); };
  visit_content(in, checkpoint, get);
  std::uint64_t rows = 0;
  in.get(rows);
  for (std::uint64_t k = 0; k < rows; ++k) {
    HistoryRow row;
    visit_row(in, row, get);
    checkpoint.history.push_back(row);
  }
  in.finish();
  if (!makes_sense(checkpoint))
    throw InputError(fmt::format("{}: holds values that no run has written; write it anew", path));
  return checkpoint;
}

}  // namespace superstep::dynamics

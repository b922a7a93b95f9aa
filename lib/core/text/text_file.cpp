#include "core/text/text_file.hpp"

#include <fmt/format.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/text/decoding/compressed.hpp"
#include "core/text/decoding/encoding.hpp"

namespace superstep {

namespace {

const char* kind_of(std::filesystem::file_type type) noexcept {
  switch (type) {
    case std::filesystem::file_type::fifo:
      return "a pipe";
    case std::filesystem::file_type::socket:
      return "a socket";
    default:
      return "a device";
  }
}

}  // namespace

bool is_regular_file(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored);
}

void require_regular_file(const std::string& path, std::uintmax_t most) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status))
    throw FileError(path, "no such file; check the path (one in a case file starts at that file)");
  if (std::filesystem::is_directory(status)) throw FileError(path, "is a directory; name a file in it");
  if (!std::filesystem::is_regular_file(status))
    throw FileError(
        path, fmt::format("is {}, and no file; save what it holds and name that", kind_of(status.type())));
  const auto size = std::filesystem::file_size(path, error);
  if (!error && size > most)
    throw FileError(path,
                    fmt::format("has {} bytes, and at most {} are read; is it the right file?", size, most));
}

std::string read_bytes(const std::string& path, std::uintmax_t most) {
  require_regular_file(path, most);
  std::error_code ignored;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw FileError(path, fmt::format("cannot be opened: {}", std::strerror(errno)));
  std::string text;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) text.reserve(size);
  constexpr std::size_t block = std::size_t{1} << 20;
  std::string buffer(block, '\0');
  while (stream.read(buffer.data(), static_cast<std::streamsize>(block)) || stream.gcount() > 0)
    text.append(buffer, 0, static_cast<std::size_t>(stream.gcount()));
  if (stream.bad()) throw FileError(path, fmt::format("cannot be read: {}", std::strerror(errno)));
  if (is_gzip(text)) return gunzip(text, path, most);
  return text;
}

std::string read_file(const std::string& path, std::uintmax_t most) {
  return to_utf8(read_bytes(path, most));
}

std::string read_text_file(const std::string& path, std::uintmax_t most) {
  std::string text = read_file(path, most);
  refuse_binary(text, path);
  require_content(text, path);
  return text;
}

void refuse_binary(std::string_view text, const std::string& path) {
  if (text.find('\0') != std::string_view::npos)
    throw FileError(path, "holds NUL bytes, so it is binary; a text file is expected");
}

void require_content(std::string_view text, const std::string& path) {
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw FileError(path, "is empty; a file with content is expected");
}

bool LineReader::next() noexcept {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line_ = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
  if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::string in_quotes(std::string_view value) {
  constexpr std::size_t longest = 60;
  std::string out = "'";
  bool after_c2 = false;  // C1, which steers a terminal as well, is C2 80 to C2 9F in UTF-8
  for (const char c : value.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || (after_c2 && byte < 0xA0))
      out += fmt::format("\\x{:02x}", byte);
    else
      out += c;
    after_c2 = byte == 0xC2;
  }
  out += value.size() > longest ? "...'" : "'";
  return out;
}

}  // namespace superstep

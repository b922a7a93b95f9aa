#include "core/text/decoding/compressed.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <limits>
#include <new>

#include "core/error.hpp"

namespace superstep {
namespace {

/// One stream of zlib, released whatever happens.
class Inflater {
 public:
  explicit Inflater(int window_bits) {
    if (inflateInit2(&stream_, window_bits) != Z_OK) throw std::bad_alloc();
  }
  ~Inflater() { inflateEnd(&stream_); }
  Inflater(const Inflater&) = delete;
  Inflater& operator=(const Inflater&) = delete;

  /// Takes from `in` and appends to `out` until the stream ends, `in` is used up, or `out` has grown by
  /// `room`.
  int run(std::string_view& in, std::string& out, std::size_t room) {
    constexpr std::size_t block = std::size_t{1} << 20;
    int status = Z_OK;
    while (status == Z_OK && room > 0) {
      const std::size_t piece = std::min(block, room), before = out.size();
      const auto given =
          static_cast<uInt>(std::min<std::size_t>(in.size(), std::numeric_limits<uInt>::max()));
      out.resize(before + piece);
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(in.data()));  // zlib does not write there
      stream_.avail_in = given;
      stream_.next_out = reinterpret_cast<Bytef*>(out.data() + before);
      stream_.avail_out = static_cast<uInt>(piece);
      status = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t written = piece - stream_.avail_out;
      in.remove_prefix(given - stream_.avail_in);
      out.resize(before + written);
      room -= written;
      if (written == 0 && status == Z_OK && in.empty()) status = Z_BUF_ERROR;
    }
    return status;
  }
  void reset() { inflateReset(&stream_); }

 private:
  z_stream stream_{};
};

}  // namespace

bool is_gzip(std::string_view bytes) noexcept {
  return bytes.starts_with("\x1F\x8B");
}

std::string gunzip(std::string_view bytes, const std::string& path, std::uintmax_t most) {
  constexpr int gzip_only = 15 + 16;
  Inflater inflater(gzip_only);
  std::string out;
  while (is_gzip(bytes)) {
    const std::size_t room = static_cast<std::size_t>(most) - out.size() + 1;
    const int status = inflater.run(bytes, out, room);
    if (out.size() > most)
      throw FileError(
          path,
          fmt::format("unpacks to more than {} bytes, the most that is read; is it the right file?", most));
    if (status != Z_STREAM_END)
      throw FileError(path, fmt::format("the gzip file {}; copy or compress it again",
                                        status == Z_BUF_ERROR ? "is cut off" : "is damaged"));
    inflater.reset();
  }
  if (bytes.find_first_not_of('\0') != std::string_view::npos)  // noughts are padding
    throw FileError(path, "the gzip file goes on behind its last packed part; copy or compress it again");
  return out;
}

void append_inflated(std::string_view bytes, std::size_t size, const std::string& where, std::string& out) {
  constexpr int zlib_only = 15;
  Inflater inflater(zlib_only);
  const std::size_t before = out.size();
  const int status = inflater.run(bytes, out, size + 1);
  if (status != Z_STREAM_END || out.size() - before != size)
    throw InputError(fmt::format(
        "{}: a compressed block does not hold the {} bytes that its header announces; the file is damaged: "
        "write it again",
        where, size));
}

}  // namespace superstep

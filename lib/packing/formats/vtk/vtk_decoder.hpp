#pragma once
/// Arrays of VTK XML files, however they are written: ASCII, base64 or raw, in place or appended, as they are
/// or in zlib blocks.

#include <string>
#include <string_view>
#include <vector>

#include "packing/formats/vtk/vtk_array.hpp"
#include "packing/formats/vtk/xml_scan.hpp"

namespace superstep {

class VtkDecoder {
 public:
  /// What the tag VTKFile says about all arrays. Throws InputError, as all of it.
  ///   path  for messages
  ///   content  must stay
  VtkDecoder(std::string path, std::string_view content, const XmlTag& tag);

  /// The values of a DataArray whose name is `name`.
  [[nodiscard]] std::vector<double> values(const XmlTag& tag, VtkType type, const std::string& name) const;

 private:
  [[noreturn]] void fail(const std::string& reason) const;
  [[noreturn]] void cut_off(const std::string& name) const;
  void find_appended();
  [[nodiscard]] std::vector<double> ascii(std::string_view text, const std::string& name) const;
  [[nodiscard]] std::string bytes(std::string_view source, bool base64, std::size_t size,
                                  const std::string& name) const;
  [[nodiscard]] std::size_t header_value(std::string_view header, std::size_t k) const;
  [[nodiscard]] std::string block(std::string_view source, bool base64, const std::string& name) const;

  std::string path_;
  std::string_view content_, appended_;
  bool big_endian_ = false, is_compressed_ = false, appended_is_base64_ = false;
  std::size_t header_size_ = 4;
};

/// An attribute of a tag, or `fallback`.
[[nodiscard]] std::string vtk_attribute(const XmlTag& tag, const std::string& name,
                                        const std::string& fallback = {});
/// The same as a count >= 0, `fallback` where there is none. Throws InputError.
[[nodiscard]] std::size_t vtk_count(const std::string& path, const XmlTag& tag, const std::string& name,
                                    std::int64_t fallback);

}  // namespace superstep

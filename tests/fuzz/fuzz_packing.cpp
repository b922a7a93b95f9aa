/// Packings in every format there is: the reader tells them apart by what they begin with. A table that is
/// read in parts is the one that is read as a whole.

#include "contact/search.hpp"
#include "input_file.hpp"
#include "packing/parts/table_part.hpp"
#include "packing/read.hpp"

namespace {

using namespace superstep;

using fuzz::require;

/// What was read as a whole is there in parts, too.
void read_in_parts(const std::string& path, const Packing& whole) {
  std::string why_not;
  const auto table = TableInParts::open(path, {}, why_not);
  if (!table) return;
  require(table->length_unit() == whole.length_unit);
  constexpr std::uint64_t parts = 3;
  std::size_t next = 0;
  for (std::uint64_t part = 0; part < parts; ++part) {
    const Packing one = table->read(table->bytes() * part / parts, table->bytes() * (part + 1) / parts);
    for (std::size_t k = 0; k < one.size(); ++k, ++next) {
      require(next < whole.size() && one.radius[k] == whole.radius[next]);
      require(norm(one.centre[k] - whole.centre[next]) == 0);
      if (table->has_ids()) require(one.id[k] == whole.id[next]);
    }
  }
  require(next == whole.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::InputFile file(fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { (void)recognised_format(file.path()); });
  std::optional<Packing> packing;
  fuzz::read_or_refuse([&] { packing = read_packing(file.path()); });
  if (!packing) return 0;
  read_in_parts(file.path(), *packing);
  fuzz::read_or_refuse([&] {
    (void)find_contacts(*packing, 0.0, true);
    fuzz::InputFile again(packing_csv(*packing));  // what was read can be written
    (void)again;
  });
  return 0;
}

#include "bench/measure/shared/shared_parts.hpp"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "bench/host/terminal.hpp"
#include "bench/measure/shared/worker.hpp"
#include "case/case.hpp"
#include "case/parts/build_in_parts.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

/// A mistake that somebody found in his part of a case: the case as a whole says where, as far as memory
/// goes.
[[noreturn]] void say_as_of_the_whole(const InputError& error, const std::string& text,
                                      const std::string& file) {
  try {
    (void)load_case(TomlTable::parse_text(text, file));
  } catch (const InputError&) {
    throw;
  } catch (const std::exception&) {  // the part's own words will do
  }
  throw InputError(error.what());
}

}  // namespace

std::optional<Scene> share_in_parts(const std::string& file, bool quiet) {
  if (world().alone()) return std::nullopt;
  const std::string text = read_text_file(file);
  std::string why_not;
  bool in_parts = false;
  try {
    in_parts = can_be_in_parts(TomlTable::parse_text(text, file), why_not);
  } catch (const InputError& error) {
    say_as_of_the_whole(error, text, file);
  }
  const auto read_for_all = [&](const std::string& why) -> std::optional<Scene> {
    if (!why.empty() && !quiet)
      note("", fmt::format("{}: process 1 of {} reads the scene for all: {}", file, world().size(), why));
    return std::nullopt;
  };
  if (!in_parts) return read_for_all(why_not);
  Packer out;
  out.put(Order::parts);
  out.put(block_rows());
  out.put(file);
  out.put(text);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
  try {
    return build_in_parts(TomlTable::parse_text(text, file), world());
  } catch (const NeedsOneReader& error) {  // everybody's
    return read_for_all(error.what());
  } catch (const InputError& error) {  // everybody's, too
    say_as_of_the_whole(error, text, file);
  } catch (const std::exception& error) {  // the others would wait for ever
    note("error: ", fmt::format("process 1 of {}: {}", world().size(), error.what()));
    world().abort(static_cast<int>(ExitCode::internal));
    throw;
  }
}

ScenePart take_in_parts(Unpacker& in) {
  set_block_rows(in.take<std::size_t>());
  std::string file, text;
  in.take(file);
  in.take(text);
  auto scene = std::make_shared<Scene>(build_in_parts(TomlTable::parse_text(text, file), world()));
  ScenePart part = part_of_own(*scene);
  part.scene_here = std::move(scene);
  return part;
}

ScenePart part_of_own(const Scene& scene) {
  ScenePart part;
  part.rhs = std::shared_ptr<Rhs>(std::shared_ptr<Rhs>(), scene.rhs.get());  // the scene's
  part.initial = scene.initial;
  part.entries = static_cast<double>(dynamic_cast<const NetworkRhs&>(*scene.rhs).entries());
  part.scene = scene.rhs->identity();
  part.in_parts = true;
  return part;
}

}  // namespace superstep

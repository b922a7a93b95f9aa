#include "bench/measure/shared/shared_layers.hpp"

#include <fmt/format.h>

#include <exception>
#include <string>

#include "bench/host/terminal.hpp"
#include "bench/measure/shared/worker.hpp"
#include "case/case.hpp"
#include "case/layers/layered_scene.hpp"
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

std::optional<Scene> share_layers(const std::string& file, bool quiet) {
  if (world().alone()) return std::nullopt;
  const std::string text = read_text_file(file);
  std::string why_not;
  bool in_layers = false;
  try {
    in_layers = can_be_layered(TomlTable::parse_text(text, file), why_not);
  } catch (const InputError& error) {
    say_as_of_the_whole(error, text, file);
  }
  if (!in_layers) {
    if (!why_not.empty() && !quiet)
      note("",
           fmt::format("{}: process 1 of {} reads the packing for all: {}", file, world().size(), why_not));
    return std::nullopt;
  }
  Packer out;
  out.put(Order::layers);
  out.put(block_rows());
  out.put(file);
  out.put(text);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
  try {
    return build_in_layers(TomlTable::parse_text(text, file), world());
  } catch (const InputError& error) {  // everybody's
    say_as_of_the_whole(error, text, file);
  } catch (const std::exception& error) {  // the others would wait for ever
    note("error: ", fmt::format("process 1 of {}: {}", world().size(), error.what()));
    world().abort(static_cast<int>(ExitCode::internal));
    throw;
  }
}

ScenePart take_layers(Unpacker& in) {
  set_block_rows(in.take<std::size_t>());
  std::string file, text;
  in.take(file);
  in.take(text);
  auto scene = std::make_shared<Scene>(build_in_layers(TomlTable::parse_text(text, file), world()));
  ScenePart part = part_of_layers(*scene);
  part.layered = std::move(scene);
  return part;
}

ScenePart part_of_layers(const Scene& scene) {
  ScenePart part;
  part.rhs = std::shared_ptr<Rhs>(std::shared_ptr<Rhs>(), scene.rhs.get());  // the scene's
  part.initial = scene.initial;
  part.entries = static_cast<double>(dynamic_cast<const NetworkRhs&>(*scene.rhs).entries());
  part.scene = scene.rhs->identity();
  part.in_layers = true;
  return part;
}

}  // namespace superstep

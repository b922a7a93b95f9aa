#include "bench/measure/shared/part_lines.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <exception>
#include <memory>
#include <vector>

#include "bench/measure/shared/failure_of.hpp"
#include "bench/measure/shared/worker.hpp"
#include "case/parts/own_nodes.hpp"
#include "core/text/append.hpp"
#include "parallel/file_part.hpp"

namespace superstep {
namespace {

constexpr std::size_t piece = std::size_t{1} << 20;  // bytes of text that are sent at a time

/// A number as text, made anew where it is another one than the last time: in a lattice most are not.
class Repeated {
 public:
  [[nodiscard]] std::string_view text(double value) {
    const auto bits = std::bit_cast<std::uint64_t>(value);
    if (bits != bits_ || text_.empty()) text_ = fmt::format("{}", value);
    bits_ = bits;
    return text_;
  }

 private:
  std::uint64_t bits_ = 0;
  std::string text_;
};

/// Calls each(text) with lines of the nodes that are here.
template <class Each>
void for_own_lines(const Scene& scene, std::span<const double> state, const Each& each) {
  const double origin = scene.fields.front().origin;
  const bool are_spheres = scene.own_nodes->are_spheres();
  std::string text;
  Repeated second, third, radius;
  std::size_t row = 0;
  scene.own_nodes->show([&](const ShownNode& node) {
    append(text, "{}", node.id);
    if (are_spheres)
      append(text, ",{},{},{},{}", node.centre.x, second.text(node.centre.y), third.text(node.centre.z),
             radius.text(node.radius));
    append(text, ",{}\n", node.is_fixed ? node.fixed_value : state[row++] + origin);
    if (text.size() < piece) return;
    each(text);
    text.clear();
  });
  if (text.size() > 0) each(text);
}

std::span<const std::byte> bytes_of(std::string_view text) {
  return std::as_bytes(std::span(text.data(), text.size()));
}

/// Lines that are kept while they are counted, so that they need not be made twice; as long as they are few.
class FewLines {
 public:
  void take(std::string_view text) {
    constexpr std::size_t most = 16 * piece;
    bytes_ += text.size();
    all_ = all_ && bytes_ <= most;
    if (all_)
      texts_.emplace_back(text);
    else
      texts_.clear();
  }
  [[nodiscard]] std::uint64_t bytes() const noexcept { return bytes_; }
  /// Whether what was taken is all here.
  [[nodiscard]] bool all() const noexcept { return all_; }
  [[nodiscard]] const std::vector<std::string>& texts() const noexcept { return texts_; }

 private:
  std::vector<std::string> texts_;
  std::uint64_t bytes_ = 0;
  bool all_ = true;
};

/// Collective. `head` on the root alone.
WrittenLines write_together(const Scene& scene, std::span<const double> state, std::string_view head,
                            const std::string& file) {
  std::unique_ptr<FilePart> part;
  const auto closed = failure_of([&] { part = world().open_part(file); });
  if (world().any(closed.has_value())) return {.reached = false, .failure = {}};
  FewLines few;
  const auto uncounted =
      failure_of([&] { for_own_lines(scene, state, [&](std::string_view text) { few.take(text); }); });
  if (const auto failure = world().first_of(uncounted)) return {.failure = failure};
  std::uint64_t place = world().sum_before(head.size() + few.bytes());
  const auto put = [&](std::string_view text) {
    part->write(place, text);
    place += text.size();
  };
  const auto unwritten = failure_of([&] {
    put(head);
    if (few.all())
      for (const auto& text : few.texts()) put(text);
    else
      for_own_lines(scene, state, put);
    part->finish();
  });
  return {.failure = world().first_of(unwritten)};
}

}  // namespace

WrittenLines write_part_lines(const Scene& scene, std::span<const double> state, std::string_view head,
                              const std::string& file) {
  Packer out;
  out.put(Order::write_lines);
  out.put(file);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
  return write_together(scene, state, head, file);
}

void join_part_lines(const ScenePart& part, Unpacker& in) {
  std::string file;
  in.take(file);
  (void)write_together(*part.scene_here, part.final_state, {}, file);
}

void for_part_lines(const Scene& scene, std::span<const double> state,
                    const std::function<void(std::string_view)>& each) {
  for_own_lines(scene, state, each);
  Packer out;
  out.put(Order::send_lines);
  for (int from = 1; from < world().size(); ++from) {
    world().send(from, out.bytes());
    std::exception_ptr failed;  // what a process has begun to send must be received all the same
    for (auto text = world().receive(from); !text.empty(); text = world().receive(from)) try {
        if (!failed) each(std::string_view(reinterpret_cast<const char*>(text.data()), text.size()));
      } catch (...) {
        failed = std::current_exception();
      }
    if (failed) std::rethrow_exception(failed);
  }
}

void send_part_lines(const ScenePart& part) {
  for_own_lines(*part.scene_here, part.final_state,
                [](std::string_view text) { world().send(0, bytes_of(text)); });
  world().send(0, {});
}

}  // namespace superstep

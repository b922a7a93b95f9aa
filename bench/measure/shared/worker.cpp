#include "bench/measure/shared/worker.hpp"

#include "bench/host/interrupt.hpp"
#include "bench/measure/shared/part_lines.hpp"
#include "bench/measure/shared/shared_parts.hpp"
#include "bench/measure/shared/shared_run.hpp"
#include "case/parts/build_in_parts.hpp"
#include "core/error.hpp"

namespace superstep {

int serve_the_root(const WriteFrame& write_frame) {
  catch_interrupts();
  ScenePart part;
  while (true) {
    const auto bytes = world().receive(0);
    Unpacker in(bytes);
    switch (in.take<Order>()) {
      case Order::scene:
        part = {};
        part = take_part(in);
        break;
      case Order::parts:
        part = {};
        try {
          part = take_in_parts(in);
        } catch (const NeedsOneReader&) {  // which is the root
        } catch (const InputError&) {      // the root's, too, and it says so
        }
        break;
      case Order::write_lines:
        join_part_lines(part, in);
        break;
      case Order::send_lines:
        send_part_lines(part);
        break;
      case Order::run:
        join_run(part, in, write_frame);
        break;
      case Order::end:
        return in.take<int>();
    }
  }
}

void dismiss_workers(int exit_code) {
  if (world().alone()) return;
  if (in_shared_run()) world().abort(exit_code);
  Packer out;
  out.put(Order::end);
  out.put(exit_code);
  for (int to = 1; to < world().size(); ++to) world().send(to, out.bytes());
}

}  // namespace superstep

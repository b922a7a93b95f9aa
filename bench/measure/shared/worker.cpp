#include "bench/measure/shared/worker.hpp"

#include "bench/host/interrupt.hpp"
#include "bench/measure/shared/layered_lines.hpp"
#include "bench/measure/shared/shared_layers.hpp"
#include "bench/measure/shared/shared_run.hpp"
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
      case Order::layers:
        part = {};
        try {
          part = take_layers(in);
        } catch (const InputError&) {  // the root's, too, and it says so
        }
        break;
      case Order::write_lines:
        join_layered_lines(part, in);
        break;
      case Order::send_lines:
        send_layered_lines(part);
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

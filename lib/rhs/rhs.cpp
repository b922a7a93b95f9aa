#include "rhs/rhs.hpp"

namespace superstep {

void Rhs::do_chain(std::span<ChainedStage> stages, bool with_inflow, ChainObserver* observer) {
  for (std::size_t k = 0; k < stages.size(); ++k) {
    auto& link = stages[k];
    if (with_inflow) link.inflow = inflow(link.t, {link.stage.y1, size()});
    do_stage(link.t, link.stage, {link.out, size()});
    if (observer) observer->entries_done(k, 0, size());
  }
}

}  // namespace superstep

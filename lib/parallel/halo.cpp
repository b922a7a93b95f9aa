#include "parallel/halo.hpp"

#include <utility>

namespace superstep {

Halo::Halo(Communicator& among, const Partition& partition, std::vector<std::int64_t> rows)
    : among_(&among),
      partition_(partition),
      rows_(std::move(rows)),
      exchange_(among.make_exchange(partition_, rows_)) {}

void Halo::begin(const double* owned, double* values) {
  among_->count_halo(exchange_->messages(), exchange_->bytes());
  exchange_->begin(owned, values);
}

}  // namespace superstep

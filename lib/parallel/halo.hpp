#pragma once
/// The ghost tail of a field's rows: values that other processes own and this one's rows need.

#include <memory>
#include <vector>

#include "parallel/communicator.hpp"

namespace superstep {

class Halo {
 public:
  /// Collective.
  ///   rows  the global rows whose values are needed, ascending, none of them owned
  Halo(Communicator& among, const Partition& partition, std::vector<std::int64_t> rows);

  [[nodiscard]] Communicator& among() const noexcept { return *among_; }
  [[nodiscard]] const Partition& partition() const noexcept { return partition_; }
  [[nodiscard]] std::size_t size() const noexcept { return rows_.size(); }
  /// The global row that a value is of.
  [[nodiscard]] std::int64_t row(std::size_t k) const noexcept { return rows_[k]; }

  /// Between the two other work goes on; nothing may read `values` [size()].
  void begin(const double* owned, double* values);
  void end() { exchange_->end(); }
  void progress() { exchange_->progress(); }
  /// Both at once.
  void fetch(const double* owned, double* values) {
    begin(owned, values);
    end();
  }

 private:
  Communicator* among_;
  Partition partition_;
  std::vector<std::int64_t> rows_;
  std::unique_ptr<Exchange> exchange_;
};

}  // namespace superstep

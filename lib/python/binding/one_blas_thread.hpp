#pragma once
/// OpenBLAS, which NumPy uses as well, on one thread for a while.

namespace superstep::python {

/// Factorizations call BLAS on small blocks, for which its threads cost more than they give, and their sums
/// would depend on how many there are. What NumPy had is restored.
class OneBlasThread {
 public:
  OneBlasThread();
  ~OneBlasThread();
  OneBlasThread(const OneBlasThread&) = delete;
  OneBlasThread& operator=(const OneBlasThread&) = delete;

 private:
  int before_ = 0;  // 0 = no OpenBLAS
};

}  // namespace superstep::python

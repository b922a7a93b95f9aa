#include "audit/oracle/linear_truth.hpp"

#include "audit/oracle/linear_solution.hpp"

namespace superstep::audit {

Truth linear_truth(const StatedScene& scene) {
  return linear_solution<long double>(scene);
}

}  // namespace superstep::audit

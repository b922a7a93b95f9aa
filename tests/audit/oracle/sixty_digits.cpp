#include "audit/oracle/linear_truth.hpp"

#ifdef SUPERSTEP_HAS_BOOST
#include <boost/multiprecision/cpp_bin_float.hpp>

#include "audit/oracle/linear_solution.hpp"

namespace superstep::audit {

Truth linear_truth_in_sixty_digits(const StatedScene& scene) {
  namespace many = boost::multiprecision;
  return linear_solution<many::number<many::cpp_bin_float<60>, many::et_off>>(scene);
}

}  // namespace superstep::audit
#else
#include <stdexcept>

namespace superstep::audit {

Truth linear_truth_in_sixty_digits(const StatedScene& /*scene*/) {
  throw std::runtime_error("built without Boost's numbers of many digits (libboost-dev)");
}

}  // namespace superstep::audit
#endif

#include "integrators/detail/implicit/state_n_vector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <new>

#include "core/parallel.hpp"
#include "core/state_vector.hpp"

namespace superstep::sundials {
namespace {

struct Content {
  const Reduction* reduction;
  StateVector values;
};

Content& content(N_Vector v) noexcept {
  return *static_cast<Content*>(v->content);
}

const Reduction& reduction_of(N_Vector v) noexcept {
  return *content(v).reduction;
}

double* data(N_Vector v) {
  return content(v).values.data();
}

/// Calls body(i) for every entry.
template <class Body>
void for_each(N_Vector v, const Body& body) {
  for_each_entry(content(v).values.size(), body);
}

void destroy(N_Vector v) {
  if (!v) return;
  delete static_cast<Content*>(v->content);
  v->content = nullptr;
  N_VFreeEmpty(v);
}

N_Vector clone(N_Vector v) {
  N_Vector out = N_VNewEmpty(v->sunctx);
  if (!out) return nullptr;
  N_VCopyOps(v, out);
  try {
    out->content = new Content{content(v).reduction, StateVector(reduction_of(v).size())};
  } catch (const std::bad_alloc&) {
    N_VFreeEmpty(out);
    return nullptr;
  }
  return out;
}

void space(N_Vector v, sunindextype* reals, sunindextype* integers) {
  *reals = static_cast<sunindextype>(content(v).values.size());
  *integers = 1;
}

sunindextype length(N_Vector v) {
  return static_cast<sunindextype>(reduction_of(v).total());
}

// Of x and y only the entries are read: z may be either of them.
void linear_sum(double a, N_Vector x, double b, N_Vector y, N_Vector z) {
  for_each(z, [=, u = data(x), v = data(y), w = data(z)](std::size_t i) { w[i] = a * u[i] + b * v[i]; });
}
void set_all(double c, N_Vector z) {
  for_each(z, [=, w = data(z)](std::size_t i) { w[i] = c; });
}
void product(N_Vector x, N_Vector y, N_Vector z) {
  for_each(z, [=, u = data(x), v = data(y), w = data(z)](std::size_t i) { w[i] = u[i] * v[i]; });
}
void quotient(N_Vector x, N_Vector y, N_Vector z) {
  for_each(z, [=, u = data(x), v = data(y), w = data(z)](std::size_t i) { w[i] = u[i] / v[i]; });
}
void scale(double c, N_Vector x, N_Vector z) {
  for_each(z, [=, u = data(x), w = data(z)](std::size_t i) { w[i] = c * u[i]; });
}
void magnitudes(N_Vector x, N_Vector z) {
  for_each(z, [=, u = data(x), w = data(z)](std::size_t i) { w[i] = std::abs(u[i]); });
}
void inverse(N_Vector x, N_Vector z) {
  for_each(z, [=, u = data(x), w = data(z)](std::size_t i) { w[i] = 1 / u[i]; });
}
void add_constant(N_Vector x, double b, N_Vector z) {
  for_each(z, [=, u = data(x), w = data(z)](std::size_t i) { w[i] = u[i] + b; });
}

double dot(N_Vector x, N_Vector y) {
  return reduction_of(x).sum([u = data(x), v = data(y)](std::size_t i) { return u[i] * v[i]; });
}
double largest(N_Vector x) {
  return reduction_of(x).max([u = data(x)](std::size_t i) { return std::abs(u[i]); });
}
double weighted_squares(N_Vector x, N_Vector w) {
  return reduction_of(x).sum([u = data(x), v = data(w)](std::size_t i) {
    const double p = u[i] * v[i];
    return p * p;
  });
}
double weighted_rms(N_Vector x, N_Vector w) {
  return std::sqrt(weighted_squares(x, w) / static_cast<double>(std::max<sunindextype>(1, length(x))));
}
double weighted_length(N_Vector x, N_Vector w) {
  return std::sqrt(weighted_squares(x, w));
}
double weighted_rms_of_some(N_Vector x, N_Vector w, N_Vector mask) {
  const double sum = reduction_of(x).sum([u = data(x), v = data(w), m = data(mask)](std::size_t i) {
    const double p = m[i] > 0 ? u[i] * v[i] : 0.0;
    return p * p;
  });
  return std::sqrt(sum / static_cast<double>(std::max<sunindextype>(1, length(x))));
}
double smallest(N_Vector x) {
  double out = std::numeric_limits<double>::max();
  for (const double value : content(x).values) out = std::min(out, value);
  return reduction_of(x).smallest(out);
}
double sum_of_magnitudes(N_Vector x) {
  return reduction_of(x).sum([u = data(x)](std::size_t i) { return std::abs(u[i]); });
}
void compare(double c, N_Vector x, N_Vector z) {
  for_each(z, [=, u = data(x), w = data(z)](std::size_t i) { w[i] = std::abs(u[i]) >= c ? 1.0 : 0.0; });
}
booleantype inverse_where_possible(N_Vector x, N_Vector z) {
  bool zero = false;
  for (std::size_t i = 0; i < content(x).values.size(); ++i) {
    const double value = data(x)[i];
    if (value == 0)
      zero = true;
    else
      data(z)[i] = 1 / value;
  }
  return reduction_of(x).any(zero) ? SUNFALSE : SUNTRUE;
}
double smallest_quotient(N_Vector x, N_Vector y) {
  double out = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < content(x).values.size(); ++i)
    if (data(y)[i] != 0) out = std::min(out, data(x)[i] / data(y)[i]);
  return reduction_of(x).smallest(out);
}

}  // namespace

std::span<double> entries(N_Vector v) noexcept {
  return content(v).values;
}

N_Vector new_state_vector(const Reduction& reduction, SUNContext context) noexcept {
  N_Vector v = N_VNewEmpty(context);
  if (!v) return nullptr;
  auto& ops = *v->ops;
  // KLU's wrapper asks for a vector with all entries side by side, by the name of SUNDIALS' own.
  ops.nvgetvectorid = [](N_Vector) { return SUNDIALS_NVEC_SERIAL; };
  ops.nvclone = clone;
  ops.nvcloneempty = clone;
  ops.nvdestroy = destroy;
  ops.nvspace = space;
  ops.nvgetarraypointer = data;
  ops.nvgetlength = length;
  ops.nvlinearsum = linear_sum;
  ops.nvconst = set_all;
  ops.nvprod = product;
  ops.nvdiv = quotient;
  ops.nvscale = scale;
  ops.nvabs = magnitudes;
  ops.nvinv = inverse;
  ops.nvaddconst = add_constant;
  ops.nvdotprod = dot;
  ops.nvmaxnorm = largest;
  ops.nvwrmsnorm = weighted_rms;
  ops.nvwrmsnormmask = weighted_rms_of_some;
  ops.nvmin = smallest;
  ops.nvwl2norm = weighted_length;
  ops.nvl1norm = sum_of_magnitudes;
  ops.nvcompare = compare;
  ops.nvinvtest = inverse_where_possible;
  ops.nvminquotient = smallest_quotient;
  try {
    v->content = new Content{&reduction, StateVector(reduction.size())};
  } catch (const std::bad_alloc&) {
    N_VFreeEmpty(v);
    return nullptr;
  }
  return v;
}

}  // namespace superstep::sundials

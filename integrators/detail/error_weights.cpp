#include "integrators/detail/error_weights.hpp"

namespace superstep {

std::vector<OptionKey> tolerance_keys(const std::string& default_rtol) {
  return {
      {.name = "rtol",
       .min = 1e-14,
       .max = 0.5,
       .fallback = default_rtol,
       .meaning = "local error allowed, relative to a field's span plus the value itself"},
      {.name = "atol",
       .min = 0,
       .fallback = "0",
       .meaning = "local error allowed on top, in the field's unit"},
  };
}

void ErrorWeights::prepare(Rhs& rhs, const Plan& plan, double rtol, double atol) {
  rhs_ = &rhs;
  rtol_ = rtol;
  atol_ = atol;
  initial_ = plan.ranges;
  const double duration = plan.output_times.empty() ? 0 : plan.output_times.back() - plan.t_begin;
  source_rise_.clear();
  for (std::size_t f = 0; f < rhs.fields().size(); ++f)
    source_rise_.push_back(initial_[f].span() > 0 ? 0 : std::abs(rhs.mean_source_rate(f)) * duration);
  const auto fields = rhs.fields();
  field_span_.resize(fields.size());
  field_of_entry_.assign(fields.size() > 1 ? rhs.size() : 0, 0);
  if (fields.size() > 1)
    for (std::size_t f = 0; f < fields.size(); ++f)
      for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride)
        field_of_entry_[i] = static_cast<std::uint8_t>(f);
  restart();
}

void ErrorWeights::restart() {
  ranges_ = initial_;
  update_spans();
}

void ErrorWeights::widen(std::span<const double> y) {
  const auto fields = rhs_->fields();
  for (std::size_t f = 0; f < fields.size(); ++f)
    for (std::size_t k = 0, i = fields[f].offset; k < fields[f].count; ++k, i += fields[f].stride) {
      ranges_[f].low = std::min(ranges_[f].low, y[i]);
      ranges_[f].high = std::max(ranges_[f].high, y[i]);
    }
  update_spans();
}

void ErrorWeights::update_spans() {
  for (std::size_t f = 0; f < ranges_.size(); ++f) {
    // A field that starts uniform has no span yet: what sources will add, else its own size, stands in.
    const double size = std::max(std::abs(ranges_[f].low), std::abs(ranges_[f].high));
    field_span_[f] = std::max(ranges_[f].span(), source_rise_[f]);
    if (!(field_span_[f] > 0)) field_span_[f] = size > 0 ? size : 1.0;
  }
}

void ErrorWeights::fill(std::span<const double> y, std::span<double> weights) const {
  const auto weight = weight_at();
  for (std::size_t i = 0; i < y.size(); ++i) weights[i] = weight(i, std::abs(y[i]));
}

}  // namespace superstep

#include "integrators/registry.hpp"

#include "core/error.hpp"
#include "core/text/suggest.hpp"

#ifdef SUPERSTEP_HAS_PETSC
#define SUPERSTEP_PETSC(method) method(petsc)
#else
#define SUPERSTEP_PETSC(method)
#endif

// One line per method: its file in this folder defines `IntegratorEntry <name>_entry()`.
#define SUPERSTEP_INTEGRATORS(method)                                                                   \
  method(forward_euler) method(sts) method(rkc) method(rkl) method(rkg) method(tsrkc) method(rock)      \
      method(trapezoidal) method(esdirk) method(exponential) method(exprb) method(cvode) method(arkode) \
          SUPERSTEP_PETSC(method) method(automatic)

namespace superstep {

const char* distributed_name(Distributed distributed) noexcept {
  return distributed == Distributed::exact ? "exact" : "gathered";
}

#define SUPERSTEP_DECLARE(method) IntegratorEntry method##_entry();
SUPERSTEP_INTEGRATORS(SUPERSTEP_DECLARE)
#undef SUPERSTEP_DECLARE

std::span<const IntegratorEntry> integrators() {
#define SUPERSTEP_ENTRY(method) method##_entry(),
  static const std::vector<IntegratorEntry> table = {SUPERSTEP_INTEGRATORS(SUPERSTEP_ENTRY)};
#undef SUPERSTEP_ENTRY
  return table;
}

std::vector<std::string> representatives() {
  constexpr const char* usual_tolerance = ":rtol=1e-3";
  std::vector<std::string> specs;
  for (const auto& entry : integrators()) {
    specs.insert(specs.end(), entry.representatives.begin(), entry.representatives.end());
    if (entry.representatives.empty()) specs.push_back(entry.name + (entry.adaptive ? usual_tolerance : ""));
  }
  return specs;
}

const IntegratorEntry& find_integrator(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& entry : integrators()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  throw UsageError("unknown integrator '" + name + "'" + suggestion(name, names));
}

std::unique_ptr<Method> make_method(const std::string& spec) {
  const Spec parsed = parse_spec(spec);
  const auto& entry = find_integrator(parsed.name);
  return entry.make(Options(parsed, entry.keys));
}

std::unique_ptr<Integrator> make_integrator(const std::string& spec) {
  return std::make_unique<Integrator>(make_method(spec));
}

std::vector<std::string> rtol_ladder(const std::string& spec, int first, int last, int stride) {
  const char* separator = spec.find(':') == std::string::npos ? ":" : ",";
  std::vector<std::string> ladder;
  for (int power = first; power <= last; power += stride)
    ladder.push_back(spec + separator + "rtol=1e-" + std::to_string(power));
  return ladder;
}

std::vector<std::string> joined(std::initializer_list<std::vector<std::string>> ladders) {
  std::vector<std::string> out;
  for (const auto& ladder : ladders) out.insert(out.end(), ladder.begin(), ladder.end());
  return out;
}

const char* status_name(Status status) noexcept {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::inaccurate:
      return "inaccurate";
    case Status::unstable:
      return "unstable";
    case Status::failed:
      return "failed";
    case Status::refused:
      return "refused";
    case Status::timeout:
      return "timeout";
    case Status::interrupted:
      return "interrupted";
  }
  return "unknown";
}

}  // namespace superstep

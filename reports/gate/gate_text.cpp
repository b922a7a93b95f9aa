#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "reports/gate/gate.hpp"
#include "results/text/json_object.hpp"

namespace superstep {

const char* verdict_name(GateVerdict verdict) noexcept {
  switch (verdict) {
    case GateVerdict::passed:
      return "passed";
    case GateVerdict::better:
      return "better";
    case GateVerdict::not_judged:
      return "not judged";
    case GateVerdict::inconclusive:
      return "inconclusive";
    case GateVerdict::regressed:
      return "regressed";
  }
  return "";
}

std::string gate_markdown(const GateReport& report) {
  std::string out = fmt::format("# Performance gate: {}\n\n`{}` against `{}`: {} checks passed.\n",
                                verdict_name(report.verdict), report.results, report.baseline, report.passed);
  if (!report.findings.empty())
    out += "\n| verdict | case | method | what | baseline | now |\n|---|---|---|---|---|---|\n";
  for (const auto& finding : report.findings)
    out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", verdict_name(finding.verdict), finding.case_name,
                       finding.spec.empty() ? "all" : "`" + finding.spec + "`", finding.what, finding.before,
                       finding.now);
  for (const auto& note : report.notes) out += fmt::format("\n{}\n", note);
  return out;
}

std::string gate_json(const GateReport& report) {
  nlohmann::ordered_json out = {{"schema", "superstep.gate"},
                                {"schema_version", 1},
                                {"verdict", verdict_name(report.verdict)},
                                {"results", report.results},
                                {"baseline", report.baseline},
                                {"passed", report.passed},
                                {"findings", nlohmann::ordered_json::array()},
                                {"notes", report.notes}};
  for (const auto& finding : report.findings)
    out["findings"].push_back({{"verdict", verdict_name(finding.verdict)},
                               {"case", finding.case_name},
                               {"method", finding.spec},
                               {"what", finding.what},
                               {"baseline", finding.before},
                               {"now", finding.now}});
  return json_text(out);
}

}  // namespace superstep

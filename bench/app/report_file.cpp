#include "bench/app/report_file.hpp"

#include "core/atomic_file.hpp"
#include "reports/html/report_html.hpp"
#include "reports/html/report_input.hpp"

namespace superstep {

std::string write_report(const std::string& folder) {
  const std::string file = folder + "/report.html";
  write_file_atomically(file, report_html(read_report_input(folder)));
  return file;
}

}  // namespace superstep

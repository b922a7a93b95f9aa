#include "bench/app/report_file.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "bench/host/terminal.hpp"
#include "core/atomic_file.hpp"
#include "reports/html/report_html.hpp"
#include "reports/html/report_input.hpp"

namespace superstep {

std::string write_report(const std::string& folder) {
  std::string file = folder + "/report.html";
  write_file_atomically(file, report_html(read_report_input(folder)));
  return file;
}

void renew_report(const std::string& folder, bool wanted, bool quiet) {
  if (wanted) {
    const std::string file = write_report(folder);
    if (!quiet) note("report in " + file);
  } else if (std::error_code ignored; !quiet && std::filesystem::exists(folder + "/report.html", ignored)) {
    note(fmt::format("{0}/report.html shows earlier results; renew it with superstep report {0}", folder));
  }
}

}  // namespace superstep

#pragma once
/// Reports with what holds for every one of them checked.

#include <gtest/gtest.h>

#include <string>

#include "reports/html/report_html.hpp"
#include "support/markup.hpp"
#include "support/temporary_folder.hpp"

namespace superstep::test {

/// Writes the report of a folder and checks what holds for every report.
inline std::string report_of(const TemporaryFolder& folder) {
  const std::string html = report_html(read_report_input(folder.file(".")));
  MarkupReader reader(html);
  EXPECT_EQ(reader.problem(), "");
  EXPECT_EQ(html.find("window.hacked=1</script>"), std::string::npos) << "names are text";
  const int data = reader.count("figure");  // every figure carries its numbers
  EXPECT_EQ(reader.count("script"), data + 2) << "the library, our script, and the numbers of each figure";
  EXPECT_GE(reader.count("svg"), reader.count("figure")) << "every chart stands in the file";
  for (const char* address : {"src=\"http", "href=\"http", "url(http", "@import", "src=\"//"})
    EXPECT_EQ(html.find(address), std::string::npos) << address;
  EXPECT_EQ(html.find("nan"), html.find("nano")) << "no number that is none";
  return html;
}

}  // namespace superstep::test

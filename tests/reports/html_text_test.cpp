#include "results/text/html_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace superstep {
namespace {

TEST(HtmlText, MarkupBecomesEntities) {
  EXPECT_EQ(html_text("</script><b a=\"1\" b='2'>&"),
            "&lt;/script&gt;&lt;b a=&quot;1&quot; b=&#39;2&#39;&gt;&amp;");
  EXPECT_EQ(html_text(std::string("a\0b\x1b[31m\x7f", 9)), "ab[31m ");
  EXPECT_EQ(html_text("ünïcode ∑"), "ünïcode ∑");
}

TEST(HtmlText, BytesThatAreNotUtf8AreReplaced) {
  EXPECT_EQ(valid_utf8("caf\xe9"), "caf\xEF\xBF\xBD");
  EXPECT_EQ(valid_utf8("\xc0\x80"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "overlong";
  EXPECT_EQ(valid_utf8("\xed\xa0\x80").size(), 9U) << "a surrogate is three bytes of nothing";
  EXPECT_EQ(valid_utf8("\xf0\x9f\x98\x80"), "\xf0\x9f\x98\x80");
  EXPECT_EQ(valid_utf8("\xe2\x82"), "\xEF\xBF\xBD\xEF\xBF\xBD") << "cut off at the end";
}

TEST(HtmlText, SpecsInASentenceBreakAfterColonAndCommaAlone) {
  EXPECT_EQ(sentence_html("Fastest & best"), "Fastest &amp; best");
  EXPECT_EQ(sentence_html("take rkc:rtol=1e-3,step=<2>; done."),
            "take <span class=\"whole\">rkc:</span><wbr><span class=\"whole\">rtol=1e-3,</span><wbr>"
            "<span class=\"whole\">step=&lt;2&gt;;</span> done.");
  EXPECT_EQ(sentence_html("="), "<span class=\"whole\">=</span>");
  EXPECT_EQ(sentence_html(""), "");
}

TEST(HtmlText, ShorteningNeverSplitsACharacter) {
  EXPECT_EQ(shortened("short", 5), "short");
  EXPECT_EQ(shortened("longer", 5), "long…");
  EXPECT_EQ(shortened("üüüüüü", 3), "üü…");
  EXPECT_EQ(characters(shortened(std::string(500, 'x'), 40)), 40U);
}

TEST(NumberText, IsShortAndKeepsItsMeaning) {
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(-0.0123), "-0.0123");
  EXPECT_EQ(number_text(16538), "16538");
  EXPECT_EQ(number_text(100, 1), "100");
  EXPECT_EQ(number_text(1e-4), "10⁻⁴");
  EXPECT_EQ(number_text(2.5e-12), "2.5·10⁻¹²");
  EXPECT_EQ(number_text(3.86533e7, 4), "3.865·10⁷");
  EXPECT_EQ(number_text(-1e-4), "-1·10⁻⁴");
  EXPECT_EQ(number_text(std::numeric_limits<double>::infinity()), "∞");
  EXPECT_EQ(number_text(std::numeric_limits<double>::quiet_NaN()), "not a number");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1234567), "1\u202F234\u202F567");
  EXPECT_EQ(count_text(16538), "16\u202F538");
}

}  // namespace
}  // namespace superstep

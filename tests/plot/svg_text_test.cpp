#include "limber/plot/svg_text.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>

namespace limber {
namespace {

TEST(EscapeXml, ReplacesTheFiveSpecialCharacters) {
  EXPECT_EQ(escape_xml("a<b & \"c\" > 'd'"), "a&lt;b &amp; &quot;c&quot; &gt; &#39;d&#39;");
}

TEST(EscapeXml, KeepsUnicode) {
  EXPECT_EQ(escape_xml("θ = 90° → \xF0\x9F\xA6\xBE"), "θ = 90° → \xF0\x9F\xA6\xBE");
}

TEST(EscapeXml, ReplacesWhatXmlForbids) {
  EXPECT_EQ(escape_xml(std::string_view("a\0b\x1B", 4)), "a\uFFFDb\uFFFD");
  EXPECT_EQ(escape_xml("\xFF"), "\uFFFD");                      // no UTF-8
  EXPECT_EQ(escape_xml("x\xC3"), "x\uFFFD");                    // cut off
  EXPECT_EQ(escape_xml("\xC0\xAF"), "\uFFFD\uFFFD");            // overlong slash
  EXPECT_EQ(escape_xml("\xED\xA0\x80"), "\uFFFD\uFFFD\uFFFD");  // surrogate
  EXPECT_EQ(escape_xml("\xEF\xBF\xBF"), "\uFFFD\uFFFD\uFFFD");  // U+FFFF
}

TEST(SvgNumber, HasAtMostTwoDecimalsAndNoTrailingZeros) {
  EXPECT_EQ(svg_number(12.3400001), "12.34");
  EXPECT_EQ(svg_number(12.5), "12.5");
  EXPECT_EQ(svg_number(100.0), "100");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(-0.0), "0");
  EXPECT_EQ(svg_number(1e15), "1000000000000000");
}

TEST(SvgNumber, NeverWritesWhatIsNotFinite) {
  EXPECT_THROW(svg_number(std::nan("")), std::logic_error);
  EXPECT_THROW(svg_number(std::numeric_limits<double>::infinity()), std::logic_error);
}

}  // namespace
}  // namespace limber

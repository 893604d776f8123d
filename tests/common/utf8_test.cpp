#include "limber/common/utf8.hpp"

#include <string>

#include <gtest/gtest.h>

namespace limber {
namespace {

TEST(Utf8, TakesTheEndsOfEveryLength) {
  for (const char* text :
       {"", "arm", "\x7F", "\xC2\x80", "\xDF\xBF", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xEE\x80\x80",
        "\xEF\xBF\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"}) {
    EXPECT_TRUE(is_utf8(text)) << text;
  }
}

TEST(Utf8, FindsTheFirstByteThatIsNone) {
  // Latin-1, cut short, a lone continuation, overlong forms, a surrogate, beyond the last
  // character.
  for (const char* rest : {"caf\xE9", "\xC3", "\xE2\x82", "\xF0\x9F\x98", "\x80", "\xC0\xAF",
                           "\xC1\xBF", "\xE0\x9F\xBF", "\xF0\x8F\xBF\xBF", "\xED\xA0\x80",
                           "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    const std::string text = std::string("arm ") + rest;
    EXPECT_EQ(find_invalid_utf8(text), rest[0] == 'c' ? 7U : 4U) << text;
  }
}

TEST(Utf8, EscapesEveryByteThatIsNone) {
  EXPECT_EQ(with_other_bytes_escaped("caf\xE9 \xC3\xA9\xFF\xFE"), "caf\\xe9 \xC3\xA9\\xff\\xfe");
  EXPECT_EQ(with_other_bytes_escaped("\xC3"), "\\xc3");
  EXPECT_EQ(with_other_bytes_escaped("arm\r\n"), "arm\r\n");
}

}  // namespace
}  // namespace limber

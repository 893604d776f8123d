#include "limber/common/printable.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"

namespace limber {
namespace {

TEST(Printable, LeavesTextAsItIs) {
  for (const char* text : {"", "arm 'mine'", "two\n\tlines", "θ = 0.3 rad, ± 2 %", "名前 🦑"}) {
    EXPECT_EQ(printable(text), text);
  }
}

TEST(Printable, SpellsOutWhatWouldCommandATerminal) {
  EXPECT_EQ(printable("\x1b[2Jgone"), "\\x1b[2Jgone");
  EXPECT_EQ(printable("a\rb\bc\x7f"
                      "d"),
            "a\\x0db\\x08c\\x7fd");
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "\\x9b31m")
      << "CSI as one character";
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, SpellsOutWhatTurnsTheDirectionOfWriting) {
  EXPECT_EQ(printable("a\u202Egpj.exe"), "a\\u202egpj.exe");
}

TEST(Printable, SpellsOutBytesThatAreNoUtf8) {
  EXPECT_EQ(printable("a\x9b\xff\xc3"), "a\\x9b\\xff\\xc3");
}

TEST(Printable, AZeroByteEndsNoMessageOfAnError) {
  EXPECT_STREQ(InputError(std::string("a\0b\0: no", 8)).what(), "a\\x00b\\x00: no");
}

TEST(Printable, JsonStaysJsonWithTheSameMeaning) {
  const nlohmann::json value = {{"name", "\x1b[2J\xC2\x9B\x7f \u202E θ\n"}};
  const std::string shown = printable_json(value.dump());
  EXPECT_EQ(shown, printable(shown)) << "nothing is left that a terminal would obey";
  EXPECT_EQ(nlohmann::json::parse(shown), value);
}

}  // namespace
}  // namespace limber

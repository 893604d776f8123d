#include "src/driver/child_process.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CommandWords, AreSeparatedByBlanks) {
  EXPECT_THAT(command_words("  python3  my_driver.py\t--port /dev/ttyUSB0 "),
              ElementsAre("python3", "my_driver.py", "--port", "/dev/ttyUSB0"));
}

TEST(CommandWords, QuotesKeepBlanksAndEachOther) {
  EXPECT_THAT(command_words(R"('a b' "c 'd'" e'f g'h "")"),
              ElementsAre("a b", "c 'd'", "ef gh", ""));
}

TEST(CommandWords, BackslashesKeepTheNextCharacter) {
  EXPECT_THAT(command_words(R"(a\ b "c\"d\\" 'e\f' "g\h")"),
              ElementsAre("a b", R"(c"d\)", R"(e\f)", R"(g\h)"));
}

TEST(CommandWords, KnowNothingElseOfAShell) {
  EXPECT_THAT(command_words("a $HOME | b; c > ~/d *"),
              ElementsAre("a", "$HOME", "|", "b;", "c", ">", "~/d", "*"));
}

TEST(CommandWords, RefuseQuotesWithoutEndAndNothingAtAll) {
  EXPECT_THAT([] { (void)command_words("python3 'a"); },
              ThrowsMessage<InputError>(HasSubstr("a quote (') has no end")));
  EXPECT_THAT([] { (void)command_words("  "); },
              ThrowsMessage<InputError>(HasSubstr("no command found")));
}

}  // namespace
}  // namespace limber

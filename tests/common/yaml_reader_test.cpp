#include "limber/common/yaml_reader.hpp"

#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

YamlReader read(const std::string& text) {
  return YamlReader::from_text(text, "f.yaml");
}

TEST(YamlReader, NamesFileLineFieldFoundAndAllowed) {
  const auto reader = read("a: 1\nsegments:\n  - {width_m: -0.03}\n");
  EXPECT_THAT(
      [&] { reader.at("segments").elements()[0].at("width_m").positive("a length in metres"); },
      ThrowsMessage<InputError>(
          "f.yaml:3: segments[0].width_m: -0.03 found; expected a length in metres, > 0"));
}

TEST(YamlReader, RefusesNumbersThatAreNotFiniteOrNotPlain) {
  for (const char* bad : {".nan", ".inf", "-.inf", "nan", "inf", "1e999", "3 cm", "3cm", "0x10",
                          "''", "[1]", "~", "+-3"}) {
    const auto reader = read(std::string("a: ") + bad + "\n");
    EXPECT_THAT([&] { reader.at("a").number("a length in metres"); },
                ThrowsMessage<InputError>(
                    AllOf(HasSubstr("f.yaml:1: a: "), HasSubstr("a length in metres"))))
        << bad;
  }
}

TEST(YamlReader, AcceptsEveryUsualSpellingOfANumber) {
  EXPECT_EQ(read("a: 1e-3").at("a").number("x"), 1e-3);
  EXPECT_EQ(read("a: +2.5").at("a").number("x"), 2.5);
  EXPECT_EQ(read("a: -7").at("a").integer("x", -10, 10), -7);
}

TEST(YamlReader, NamesTheMissingKey) {
  EXPECT_THAT([] { read("a: 1").at("b"); },
              ThrowsMessage<InputError>("f.yaml:1: the key 'b' is missing"));
}

TEST(YamlReader, RefusesUnknownAndRepeatedKeys) {
  EXPECT_THAT(
      [] {
        read("a: 1\nwidht: 2").refuse_unknown_keys({"a", "width"});
      },
      ThrowsMessage<InputError>("f.yaml:2: widht: unknown key; allowed here: a, width"));
  EXPECT_THAT([] { read("a: 1\na: 2"); },
              ThrowsMessage<InputError>(HasSubstr("f.yaml:2: a: the key occurs twice")));
}

TEST(YamlReader, RefusesKeysThatAreRepeatedFurtherDown) {
  EXPECT_THAT([] { read("a:\n  - {b: 1}\n  - {b: 1, c: 2,\n     b: 3}"); },
              ThrowsMessage<InputError>("f.yaml:4: a[1].b: the key occurs twice"));
}

// Each level names the one above twice: walked naively, 2^40 nodes.
TEST(YamlReader, WalksSharedAnchorsOnce) {
  std::string text = "a0: &a0 {x: 1}\n";
  for (int i = 1; i <= 40; ++i) {
    text += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [*a" + std::to_string(i - 1) +
            ", *a" + std::to_string(i - 1) + "]\n";
  }
  EXPECT_EQ(read(text).keys().size(), 41u);
}

TEST(YamlReader, RefusesAListOrANumberWhereAMappingIsExpected) {
  EXPECT_THAT([] { read("a: 3").at("a").keys(); },
              ThrowsMessage<InputError>("f.yaml:1: a: '3' found; expected a mapping"));
}

TEST(YamlReader, RefusesAnotherDocumentBehindTheFirst) {
  EXPECT_THAT([] { read("a: 1\n---\na: 2\n"); },
              ThrowsMessage<InputError>(HasSubstr("f.yaml:3: another document")));
  EXPECT_THROW(read("a: 1\n...\n- garbage: [\n"), InputError);
  EXPECT_THROW(read("a: 1\n--- {a: 2}\n"), InputError);
  for (const char* one : {"---\na: 1\n...\n", "\xEF\xBB\xBF# c\n---\na: 1\n", "a: 1\n---\n# end\n",
                          "%YAML 1.2\n---\na: 1\n", "--- {a: 1}\n"}) {
    EXPECT_NO_THROW(read(one)) << one;
  }
}

TEST(YamlReader, GivesLineAndColumnOfBrokenYaml) {
  EXPECT_THAT([] { read("a: [1, 2\nb: 3\n"); }, ThrowsMessage<InputError>(HasSubstr("f.yaml:2:")));
  EXPECT_THAT([] { read(""); }, ThrowsMessage<InputError>(HasSubstr("an empty file")));
}

// yaml-cpp takes a zero for a backslash, and makes one byte of two escapes.
TEST(YamlReader, RefusesWhatWouldBecomeOtherBytes) {
  EXPECT_THAT([] { read(std::string("a: 1\nb\0_c: 1\n", 13)); },
              ThrowsMessage<InputError>(HasSubstr("f.yaml:2: a byte that is zero")));
  EXPECT_THAT([] { read("a: 1\nb: \"c\\_d\"\n"); },
              ThrowsMessage<InputError>(HasSubstr("f.yaml:2: 'c\\xa0d': an escape")));
  EXPECT_THAT([] { read("\"c\\Nd\": 1\n"); }, ThrowsMessage<InputError>(HasSubstr("'c\\x85d'")));
}

// The library quotes one byte of a character.
TEST(YamlReader, SaysWhatIsBrokenInUtf8) {
  EXPECT_THAT([] { read("a: \"\\\xC3\xA9\"\n"); }, ThrowsMessage<InputError>(HasSubstr("\\xc3")));
}

TEST(YamlReader, RefusesAnotherSchema) {
  EXPECT_THAT(
      [] { read("schema: limber/plan/1").require_schema("limber/arm/1"); },
      ThrowsMessage<InputError>(AllOf(HasSubstr("'limber/plan/1'"), HasSubstr("'limber/arm/1'"))));
}

}  // namespace
}  // namespace limber

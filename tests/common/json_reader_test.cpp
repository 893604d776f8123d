#include "limber/common/json_reader.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

constexpr std::size_t kLongestMessage = 300;

std::string refusal(const std::function<void()>& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

std::string refusal_of(const std::string& text) {
  return refusal([&] { (void)parse_json_object(text, "f.json"); });
}

/// Lists in each other, in an object.
std::string nested(std::size_t lists) {
  return "{\"a\":" + std::string(lists, '[') + std::string(lists, ']') + "}";
}

TEST(JsonReader, RefusesWhatLiesTooDeepWithoutRecursion) {
  EXPECT_NO_THROW((void)parse_json_object(nested(kMaxJsonLevels - 1), "f.json"));
  for (const std::size_t lists : {std::size_t(kMaxJsonLevels), std::size_t(2'000'000)}) {
    EXPECT_THAT(refusal_of(nested(lists)), AllOf(StartsWith("f.json: "), HasSubstr("32 deep")));
  }
  std::string objects;
  for (int i = 0; i < 100'000; ++i) {
    objects += "{\"a\":";
  }
  EXPECT_THAT(refusal_of(objects), HasSubstr("32 deep")) << "before their ends are looked for";
}

// The last one counts to one reader and the first one to another.
TEST(JsonReader, RefusesAKeyThatStandsTwice) {
  EXPECT_NO_THROW(
      (void)parse_json_object(R"({"a": {"b": 1}, "b": [{"b": 2}, {"b": 3}]})", "f.json"));
  EXPECT_THAT(refusal_of(R"({"a": 1, "b": {"c": [], "c": 2}})"),
              AllOf(StartsWith("f.json: the key 'c' stands twice in one object")));
}

TEST(JsonReader, RefusesNumbersThatNoDoubleHolds) {
  EXPECT_THAT(refusal_of(R"({"a": 1e309})"), AllOf(StartsWith("f.json: not valid JSON: "),
                                                   HasSubstr("number overflow parsing '1e309'")));
}

TEST(JsonReader, RefusesARootThatIsNoObject) {
  for (const char* root : {"[1, 2]", "3", "\"text\"", "null", "true"}) {
    EXPECT_THAT(refusal_of(root),
                AllOf(StartsWith("f.json: "), HasSubstr("expected a JSON object")));
  }
}

TEST(JsonReader, SkipsAByteOrderMark) {
  EXPECT_EQ(parse_json_object("\xEF\xBB\xBF{\"a\": 1}", "f.json").at("a"), 1);
}

TEST(JsonReader, NamesTheFileWhereItIsNoJsonAndWhereItIsMissing) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "f.json", "{\"a\": ");
  EXPECT_THAT([&] { (void)read_json_object(folder.path() / "f.json"); },
              ThrowsMessage<InputError>(
                  AllOf(HasSubstr("f.json: not valid JSON: parse error at line 1, column 7"))));
  EXPECT_THAT([&] { (void)read_json_object(folder.path() / "none.json"); },
              ThrowsMessage<InputError>(HasSubstr("none.json")));
}

TEST(JsonReader, MessagesStayShortHoweverLongTheValueIs) {
  const std::string text = "{\"a\": \"" + std::string(100'000, 'x') + "\"}";
  const nlohmann::json root = parse_json_object(text, "f.json");
  const JsonReader reader(root, "f.json");
  EXPECT_LT(refusal([&] { (void)reader.at("a").number(); }).size(), kLongestMessage);
  EXPECT_LT(refusal([&] { reader.at("a").refuse_found("expected less"); }).size(), kLongestMessage);
  EXPECT_LT(refusal_of("{\"a\": \"" + std::string(100'000, 'x')).size(), kLongestMessage);
  nlohmann::json list = nlohmann::json::array();
  for (int i = 0; i < 100'000; ++i) {
    list.push_back({1, 2, 3});
  }
  EXPECT_EQ(in_few_words(list), "a list of 100000");
  EXPECT_EQ(in_few_words({-1, 2}), "[-1,2]");
}

TEST(JsonReader, SaysFieldWhatWasFoundAndWhatIsAllowed) {
  const nlohmann::json root = parse_json_object(
      R"({"a": {"b": [1, "x", 2.5, -3]}, "n": null, "big": 18446744073709551615, "t": true})", "f");
  const JsonReader reader(root, "f");
  const std::vector<JsonReader> items = reader.at("a").at("b").elements("a list");
  EXPECT_EQ(refusal([&] { (void)items[1].number(); }),
            "f: a.b[1]: 'x' found; expected a finite number");
  EXPECT_EQ(refusal([&] { (void)items[2].count(9); }),
            "f: a.b[2]: 2.5 found; expected a whole number from 0 to 9");
  EXPECT_EQ(refusal([&] { (void)items[3].integer(0, 9); }),
            "f: a.b[3]: -3 found; expected a whole number from 0 to 9");
  EXPECT_EQ(refusal([&] { (void)items[0].number(2.0, 3.0); }),
            "f: a.b[0]: 1 found; expected a number from 2 to 3");
  EXPECT_EQ(refusal([&] { (void)reader.at("a").at("c"); }), "f: a.c: missing");
  EXPECT_EQ(refusal([&] { (void)reader.at("n").text(); }), "f: n: null found; expected a text");
  EXPECT_EQ(refusal([&] { (void)reader.at("n").boolean(); }),
            "f: n: null found; expected true or false");
  EXPECT_EQ(refusal([&] { (void)reader.at("n").elements("a list of poses"); }),
            "f: n: null found; expected a list of poses");
  EXPECT_THAT(refusal([&] { (void)reader.at("big").integer(0, 9); }), HasSubstr("from 0 to 9"));
  EXPECT_EQ(reader.at("big").count(std::numeric_limits<std::uint64_t>::max()),
            std::numeric_limits<std::uint64_t>::max());
  EXPECT_TRUE(reader.at("t").boolean());
  EXPECT_EQ(items[3].integer(-3, 0), -3);
}

TEST(JsonReader, ReadsListsOfNumbersOfAGivenLength) {
  const nlohmann::json root = parse_json_object(R"({"a": [1, 2.5], "b": [1, null]})", "f");
  const JsonReader reader(root, "f");
  EXPECT_THAT(reader.at("a").numbers(2, "numbers"), ElementsAre(1.0, 2.5));
  EXPECT_EQ(refusal([&] { (void)reader.at("a").numbers(3, "numbers"); }),
            "f: a: 2 numbers found; expected 3 numbers");
  EXPECT_EQ(refusal([&] { (void)reader.at("b").numbers(2, "numbers"); }),
            "f: b[1]: null found; expected a finite number");
  EXPECT_EQ(refusal([&] { (void)reader.at("a").numbers(2, "numbers", 0.0, 2.0); }),
            "f: a[1]: 2.5 found; expected a number from 0 to 2");
}

TEST(JsonReader, QuotesBytesThatAreNotUtf8InUtf8) {
  EXPECT_THAT(refusal([&] { (void)parse_json_object("\xFF", "f"); }), HasSubstr("'\\xff'"));
}

}  // namespace
}  // namespace limber

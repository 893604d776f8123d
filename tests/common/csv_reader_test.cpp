#include "limber/common/csv_reader.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Texts = std::vector<std::string>;

std::vector<Texts> rows_of(const std::string& text, char separator = ',') {
  CsvReader reader(text, "a.csv", separator);
  std::vector<Texts> rows;
  std::vector<CsvCell> row;
  while (reader.next(row)) {
    rows.emplace_back();
    for (const CsvCell& cell : row) {
      rows.back().emplace_back(cell.text);
    }
  }
  return rows;
}

TEST(CsvReader, SplitsCellsAndRows) {
  EXPECT_THAT(rows_of("a,b\n1,,2\n"), ElementsAre(Texts{"a", "b"}, Texts{"1", "", "2"}));
  EXPECT_THAT(rows_of("a;b;c", ';'), ElementsAre(Texts{"a", "b", "c"}));
  EXPECT_THAT(rows_of("a\tb", '\t'), ElementsAre(Texts{"a", "b"}));
  EXPECT_THAT(rows_of(""), ElementsAre());
}

TEST(CsvReader, KeepsBlankRowsAndTrailingCells) {
  EXPECT_THAT(rows_of("a,\n\n,\n"), ElementsAre(Texts{"a", ""}, Texts{""}, Texts{"", ""}));
}

TEST(CsvReader, TakesEveryLineEndAndAByteOrderMark) {
  EXPECT_THAT(rows_of("\xEF\xBB\xBF"
                      "a,b\r\nc\rd\n"),
              ElementsAre(Texts{"a", "b"}, Texts{"c"}, Texts{"d"}));
}

TEST(CsvReader, TrimsBlanksOutsideAndInsideQuotes) {
  EXPECT_THAT(rows_of(" a ,\tb\t, \" c \" \n"), ElementsAre(Texts{"a", "b", "c"}));
}

TEST(CsvReader, UnderstandsQuotes) {
  EXPECT_THAT(rows_of("\"a,b\",\"say \"\"no\"\"\",\"\"\n"),
              ElementsAre(Texts{"a,b", "say \"no\"", ""}));
  EXPECT_THAT(rows_of("\"two\nlines\",b\nc\n"), ElementsAre(Texts{"two\nlines", "b"}, Texts{"c"}));
}

TEST(CsvReader, KnowsLineAndColumnAfterQuotedLineEnds) {
  CsvReader reader("\"two\nlines\",b\n  x,\"y\"\n", "a.csv");
  std::vector<CsvCell> row;
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(reader.line(), 1U);
  ASSERT_TRUE(reader.next(row));
  EXPECT_EQ(reader.line(), 3U);
  EXPECT_EQ(row[0].column, 3U);
  EXPECT_EQ(row[1].column, 5U);
  EXPECT_THAT([&] { reader.number(row[0], "a length in metres"); },
              ThrowsMessage<InputError>(
                  "a.csv:3:3: 'x' found; expected a length in metres, a plain finite number"));
}

TEST(CsvReader, CountsEveryKindOfLineEndInQuotes) {
  for (const char* end : {"\n", "\r", "\r\n"}) {
    CsvReader reader(fmt::format("\"a{0}b\"{0}1\n", end), "a.csv");
    std::vector<CsvCell> row;
    ASSERT_TRUE(reader.next(row));
    ASSERT_TRUE(reader.next(row));
    EXPECT_EQ(reader.line(), 3U) << testing::PrintToString(end);
  }
}

TEST(CsvReader, RefusesAnOpenQuoteAndUtf16) {
  EXPECT_THAT([] { rows_of("a\n\"b,c\n"); },
              ThrowsMessage<InputError>(HasSubstr("a.csv:2:1: a quote that is never closed")));
  EXPECT_THAT(
      [] {
        rows_of(
            "\xFF\xFE"
            "a");
      },
      ThrowsMessage<InputError>(HasSubstr("save it as 'CSV UTF-8'")));
}

TEST(CsvReader, ReadsNumbersAsProgramsWriteThem) {
  for (const auto& [text, expected] : std::vector<std::pair<const char*, double>>{
           {"1", 1.0}, {"+2.5", 2.5}, {"-1e-3", -1e-3}, {".5", 0.5}, {"1E2", 100.0}}) {
    double value = 0.0;
    EXPECT_TRUE(parse_number(text, value)) << text;
    EXPECT_EQ(value, expected);
  }
  double ignored = 0.0;
  for (const char* text : {"", "nan", "inf", "1e999", "1,5", "0x10", "1 m", "+-1", "--1"}) {
    EXPECT_FALSE(parse_number(text, ignored)) << text;
  }
}

TEST(CsvReader, NamesTheDecimalComma) {
  CsvReader reader("1,5;2", "a.csv", ';');
  std::vector<CsvCell> row;
  reader.next(row);
  EXPECT_THAT([&] { reader.number(row[0], "a time"); },
              ThrowsMessage<InputError>(HasSubstr("with a decimal point")));
}

// Python takes no message, and JSON no text, that is not UTF-8.
TEST(CsvReader, QuotesLatin1InUtf8) {
  CsvReader reader("angle [\xB0]\n\x82.5\n", "a.csv");
  std::vector<CsvCell> row;
  reader.next(row);
  EXPECT_EQ(row[0].text, "angle [\\xb0]");
  reader.next(row);
  EXPECT_THAT([&] { reader.number(row[0], "an angle"); },
              ThrowsMessage<InputError>(HasSubstr("\\x82.5")));
}

}  // namespace
}  // namespace limber

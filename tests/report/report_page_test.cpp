#include "limber/report/report_page.hpp"

#include <regex>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/plot/chart.hpp"
#include "support/described_xml.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::ThrowsMessage;

ReportPage full_page() {
  ReportPage page("limber <demo>", "seed 7 & more");
  page.heading("Evaluation").paragraph("a < b").remark("mind").list({"one", "two"});
  page.key_figures({{"error", "5.1 cm", "paper: 5.8"}, {"speed", "1 M/s", ""}});
  page.table({.caption = "errors",
              .header = {"model", "cm"},
              .rows = {{"no-load", "16"}, {"network", "5"}},
              .highlighted_rows = {1}});
  Chart chart("chart");
  chart.line("l", {0.0, 1.0}, {0.0, 1.0});
  page.figure({chart.svg(), "one figure"});
  page.figures({{chart.svg(), "left"}, {chart.svg(), "right"}});
  page.code("limber demo\n  --quick");
  page.heading("Plans");
  return page;
}

TEST(ReportPage, IsWellFormedAndHoldsEverything) {
  const CommandResult result = described_xml(full_page().html());
  ASSERT_EQ(result.code, 0) << result.output;
  for (const char* text :
       {"text: limber <demo>", "text: seed 7 & more", "text: a < b", "text: 5.1 cm",
        "text: network", "text: errors", "text: one figure", "text: right",
        "text: limber demo --quick", "figure 3", "h2 2", "tr 3"}) {
    EXPECT_THAT(result.output, HasSubstr(text));
  }
}

TEST(ReportPage, LoadsNothingFromElsewhere) {
  std::string html = full_page().html();
  // The name of SVG's namespace is no address that a browser visits.
  html = std::regex_replace(html, std::regex("http://www.w3.org/2000/svg"), "");
  const std::size_t script = html.find("<script>//<![CDATA[");
  ASSERT_NE(script, std::string::npos);
  for (const char* forbidden : {"import", "fetch", "XMLHttpRequest", "http", "Worker"}) {
    EXPECT_EQ(html.find(forbidden, script), std::string::npos) << forbidden;
  }
  html.erase(script, html.find("</script>", script) - script);
  for (const char* forbidden : {"http:", "https:", "//", " src=", "<script", "<link", "@import",
                                "url(", "<iframe", "<img"}) {
    EXPECT_THAT(html, Not(HasSubstr(forbidden)));
  }
}

TEST(ReportPage, ServesPhonesAndDarkMode) {
  const std::string html = full_page().html();
  EXPECT_THAT(html, HasSubstr("name=\"viewport\" content=\"width=device-width"));
  EXPECT_THAT(html, HasSubstr("prefers-color-scheme: dark"));
}

TEST(ReportPage, LinksToEverySection) {
  const std::string html = full_page().html();
  for (const char* id : {"section-1", "section-2"}) {
    EXPECT_THAT(html, HasSubstr(std::string("href=\"#") + id + "\""));
    EXPECT_THAT(html, HasSubstr(std::string("id=\"") + id + "\""));
  }
}

TEST(ReportPage, HighlightsRows) {
  EXPECT_THAT(full_page().html(), HasSubstr("<tr class=\"highlight\"><td>network</td>"));
}

TEST(ReportPage, NamesTheRowThatDoesNotFitItsHeader) {
  ReportPage page("p");
  EXPECT_THAT(
      ([&] {
        page.table({.caption = "t", .header = {"a", "b"}, .rows = {{"1", "2"}, {"3"}}});
      }),
      ThrowsMessage<InputError>(HasSubstr("table 't': row 1 has 1 cells; its header has 2")));
}

TEST(ReportPage, WithNothingInItIsAPage) {
  EXPECT_EQ(described_xml(ReportPage("empty").html()).code, 0);
}

}  // namespace
}  // namespace limber

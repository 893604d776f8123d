#include "limber/report/report_page.hpp"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

#include "limber/common/error.hpp"
#include "limber/plot/svg_text.hpp"
#include "limber/report/page_bytes.hpp"

namespace limber {

namespace {

// Colours as variables, so that dark mode is one block; pictures keep their white ground in both.
constexpr std::string_view kStyleSheet = R"(
:root { --ink: #1d2328; --soft: #58636d; --ground: #ffffff; --card: #f3f5f7; --rule: #d5dade;
  --accent: #005a8f; --mark: #fff3d6; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6eaed; --soft: #a5b0b9; --ground: #14181b; --card: #20262b; --rule: #3a434b;
    --accent: #6fc0f0; --mark: #43391d; }
}
* { box-sizing: border-box; }
html { color-scheme: light dark; }
body { margin: 0 auto; padding: 1rem; max-width: 76rem; color: var(--ink);
  background: var(--ground); font: 17px/1.55 system-ui, Helvetica, Arial, sans-serif;
  overflow-wrap: break-word; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0.5rem 0 0; }
h2 { font-size: 1.35rem; margin: 2.4rem 0 0.6rem; border-bottom: 1px solid var(--rule); }
h3 { font-size: 1.1rem; margin: 1.6rem 0 0.4rem; }
p, ul { max-width: 46rem; }
a { color: var(--accent); }
.subtitle, figcaption, caption, .note { color: var(--soft); }
nav ul { padding: 0; margin: 1rem 0; list-style: none; display: flex; flex-wrap: wrap;
  gap: 0.3rem 1.2rem; }
.remark { border-left: 4px solid var(--accent); padding: 0.2rem 0 0.2rem 0.9rem; }
.cards { display: grid; gap: 0.8rem; grid-template-columns: repeat(auto-fit, minmax(11rem, 1fr)); }
.card { background: var(--card); border-radius: 0.6rem; padding: 0.8rem 1rem; }
.card .value { font-size: clamp(1.25rem, 5.2vw, 1.7rem); font-weight: 700; line-height: 1.25; }
.card .note { font-size: 0.9rem; }
.scroll { overflow-x: auto; margin: 1rem 0; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding-bottom: 0.4rem; }
th, td { text-align: left; padding: 0.35rem 0.9rem 0.35rem 0; border-bottom: 1px solid var(--rule);
  vertical-align: top; }
tr.highlight td { background: var(--mark); font-weight: 600; }
.figures { display: grid; gap: 1rem;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 30rem), 1fr)); }
figure { margin: 1rem 0; }
figure svg { display: block; width: 100%; height: auto; max-height: 90vh; border-radius: 0.4rem; }
.single { max-width: 50rem; }
.wide { grid-column: 1 / -1; max-width: none; overflow-x: auto; }
.wide svg { min-width: 44rem; }
figcaption { margin-top: 0.4rem; font-size: 0.95rem; }
pre { background: var(--card); border-radius: 0.4rem; padding: 0.8rem; overflow-x: auto; }
details { margin: 1rem 0; } summary { cursor: pointer; color: var(--accent); }
#moment { position: fixed; z-index: 1; pointer-events: none; background: var(--card);
  border: 1px solid var(--rule); border-radius: 0.3rem; padding: 0.2rem 0.5rem; font-size: 0.85rem;
  font-variant-numeric: tabular-nums; }
#moment i { display: inline-block; width: 0.8em; height: 0.2em; vertical-align: middle; }
svg[data-x] { cursor: crosshair; touch-action: pan-y; }
@media print { body { max-width: none; } figure, tr { break-inside: avoid; } }
)";

std::string element(std::string_view tag, std::string_view text, std::string_view attributes = "") {
  return fmt::format("<{0}{1}>{2}</{0}>\n", tag, attributes, escape_xml(text));
}

/// Width that the picture asks for, 0 if it does not say.
int picture_width_px(const std::string& svg) {
  const std::string_view key = " width=\"";
  const std::size_t found = svg.substr(0, svg.find('>')).find(key);
  return found == std::string::npos ? 0 : std::atoi(svg.c_str() + found + key.size());
}

/// Grids of charts would be too small to read on a phone: they keep a minimum width and scroll
/// sideways.
std::string figure_element(const ReportFigure& figure, std::string_view look) {
  constexpr int kWidePx = 650;
  const bool wide = picture_width_px(figure.svg) > kWidePx;
  return fmt::format("<figure class=\"{}\">\n{}{}</figure>\n", wide ? "wide" : look, figure.svg,
                     element("figcaption", figure.caption));
}

std::string row_element(const std::vector<std::string>& cells, std::string_view tag,
                        bool highlighted) {
  std::string row = highlighted ? "<tr class=\"highlight\">" : "<tr>";
  for (const std::string& cell : cells) {
    row += element(tag, cell, tag == "th" ? " scope=\"col\"" : "");
  }
  return row + "</tr>\n";
}

void check_rows(const ReportTable& table) {
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    if (table.rows[row].size() != table.header.size()) {
      throw InputError(fmt::format("table '{}': row {} has {} cells; its header has {}",
                                   table.caption, row, table.rows[row].size(),
                                   table.header.size()));
    }
  }
}

}  // namespace

ReportPage::ReportPage(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

ReportPage& ReportPage::heading(std::string_view text) {
  sections_.emplace_back(text);
  body_ += element("h2", text, fmt::format(" id=\"section-{}\"", sections_.size()));
  return *this;
}

ReportPage& ReportPage::paragraph(std::string_view text) {
  body_ += element("p", text);
  return *this;
}

ReportPage& ReportPage::remark(std::string_view text) {
  body_ += element("p", text, " class=\"remark\"");
  return *this;
}

ReportPage& ReportPage::list(const std::vector<std::string>& items) {
  if (items.empty()) {
    return *this;
  }
  body_ += "<ul>\n";
  for (const std::string& item : items) {
    body_ += element("li", item);
  }
  body_ += "</ul>\n";
  return *this;
}

ReportPage& ReportPage::code(std::string_view text) {
  body_ += "<pre>" + element("code", text) + "</pre>\n";
  return *this;
}

ReportPage& ReportPage::key_figures(const std::vector<KeyFigure>& figures) {
  body_ += "<div class=\"cards\">\n";
  for (const KeyFigure& figure : figures) {
    body_ += "<div class=\"card\">\n" + element("div", figure.label) +
             element("div", figure.value, " class=\"value\"");
    body_ += figure.note.empty() ? "" : element("div", figure.note, " class=\"note\"");
    body_ += "</div>\n";
  }
  body_ += "</div>\n";
  return *this;
}

ReportPage& ReportPage::table(const ReportTable& table) {
  check_rows(table);
  body_ += "<div class=\"scroll\">\n<table>\n";
  body_ += table.caption.empty() ? "" : element("caption", table.caption);
  body_ += "<thead>\n" + row_element(table.header, "th", false) + "</thead>\n<tbody>\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const bool highlighted = std::ranges::count(table.highlighted_rows, int(row)) > 0;
    body_ += row_element(table.rows[row], "td", highlighted);
  }
  body_ += "</tbody>\n</table>\n</div>\n";
  return *this;
}

ReportPage& ReportPage::figure(const ReportFigure& figure) {
  body_ += figure_element(figure, "single");
  return *this;
}

ReportPage& ReportPage::figures(const std::vector<ReportFigure>& figures) {
  body_ += "<div class=\"figures\">\n";
  for (const ReportFigure& figure : figures) {
    body_ += figure_element(figure, "cell");
  }
  body_ += "</div>\n";
  return *this;
}

std::string ReportPage::html() const {
  std::string links;
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    links +=
        fmt::format("<li><a href=\"#section-{}\">{}</a></li>\n", i + 1, escape_xml(sections_[i]));
  }
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{0}</title>\n<style>{1}</style>\n</head>\n<body>\n<header>\n<h1>{0}</h1>\n{2}"
      "</header>\n{3}<main>\n{4}</main>\n<script>//<![CDATA[\n{5}//]]></script>\n</body>\n"
      "</html>\n",
      escape_xml(title_), kStyleSheet,
      subtitle_.empty() ? "" : element("p", subtitle_, " class=\"subtitle\""),
      links.empty() ? "" : "<nav><ul>\n" + links + "</ul></nav>\n", body_,
      page_bytes().at("/assets/report.js"));
}

}  // namespace limber

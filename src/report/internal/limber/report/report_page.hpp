#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace limber {

/// One important figure, shown large on a card.
struct KeyFigure {
  std::string label;   ///< "open-loop error"
  std::string value;   ///< "5.1 cm"
  std::string note{};  ///< "paper: 5.8 ± 4.7 cm"; may be empty
};

/// Rows of text under one header row.
struct ReportTable {
  std::string caption{};
  std::vector<std::string> header{};
  std::vector<std::vector<std::string>> rows{};  ///< each as long as the header
  std::vector<int> highlighted_rows{};           ///< indices of rows set off by colour and weight
};

/// A picture and what it shows.
struct ReportFigure {
  std::string svg;  ///< one <svg> element, as Chart and SvgDrawing make it; put in as it is
  std::string caption;
};

/// Builds one self-contained HTML page: style sheet and pictures inside it, nothing loaded
/// from elsewhere; readable on a phone, in light and dark mode, and as XML (every element is
/// closed). Charts can be hovered and zoomed where scripts are on. All text is escaped; only the
/// figures' SVG is trusted.
///
///   ReportPage page("limber demo", "arm three_segment, seed 7");
///   page.heading("Evaluation").paragraph("…").table(errors).figure({chart.svg(), "Error over
///   time"}); write_file_atomically(folder / "report.html", page.html());
class ReportPage {
 public:
  explicit ReportPage(std::string title, std::string subtitle = "");

  /// A section's title; the page starts with a list of links to them.
  ReportPage& heading(std::string_view text);
  ReportPage& paragraph(std::string_view text);
  /// A highlighted paragraph, for what a reader must know before trusting a figure.
  ReportPage& remark(std::string_view text);
  ReportPage& list(const std::vector<std::string>& items);
  /// Fixed-width text with its line breaks, such as commands.
  ReportPage& code(std::string_view text);
  ReportPage& key_figures(const std::vector<KeyFigure>& figures);
  /// Wide tables scroll sideways on their own. @throws InputError if a row does not fit the
  /// header.
  ReportPage& table(const ReportTable& table);
  ReportPage& figure(const ReportFigure& figure);
  /// Side by side where the screen is wide enough, else below one another.
  ReportPage& figures(const std::vector<ReportFigure>& figures);

  std::string html() const;

 private:
  std::string title_;
  std::string subtitle_;
  std::string body_;
  std::vector<std::string> sections_;  // titles; numbered from 1
};

}  // namespace limber

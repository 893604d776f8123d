#include "limber/common/csv_reader.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/printable.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

/// Without surrounding spaces and tabs.
std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(" \t"), text.size()));
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

}  // namespace

CsvReader CsvReader::from_file(const fs::path& path, char separator) {
  return CsvReader(read_file(path), path.string(), separator);
}

CsvReader::CsvReader(std::string text, std::string name, char separator)
    : text_(std::move(text)), name_(std::move(name)), separator_(separator) {
  const std::string_view start = text_;
  if (start.starts_with("\xFF\xFE") || start.starts_with("\xFE\xFF")) {
    refuse(1, "the file is UTF-16 text; expected UTF-8: save it as 'CSV UTF-8'");
  }
  if (start.starts_with("\xEF\xBB\xBF")) {
    position_ = 3;
    line_begin_ = 3;
  }
  text_ = with_other_bytes_escaped(std::move(text_));  // names and cells are quoted
}

void CsvReader::refuse(std::size_t column, const std::string& message) const {
  throw InputError(fmt::format("{}:{}:{}: {}", name_, line(), column, message));
}

bool CsvReader::next(std::vector<CsvCell>& row) {
  row.clear();
  unquoted_.clear();
  if (position_ >= text_.size()) {
    return false;
  }
  line_ = next_line_;
  while (true) {
    row.push_back(read_cell());
    if (at_line_end()) {
      end_line();
      return true;
    }
    ++position_;  // the separator
  }
}

void CsvReader::skip_line() {
  while (!at_line_end()) {
    ++position_;
  }
  end_line();
}

void CsvReader::skip_lines_with(char first) {
  while (position_ < text_.size()) {
    const std::size_t begin = text_.find_first_not_of(" \t", position_);
    if (begin == std::string::npos || text_[begin] != first) {
      return;
    }
    position_ = begin;
    skip_line();
  }
}

bool CsvReader::at_line_end() const {
  return position_ >= text_.size() || text_[position_] == '\n' || text_[position_] == '\r';
}

void CsvReader::end_line() {
  if (position_ + 1 < text_.size() && text_[position_] == '\r' && text_[position_ + 1] == '\n') {
    ++position_;
  }
  ++position_;
  ++next_line_;
  line_begin_ = position_;
}

CsvCell CsvReader::read_cell() {
  const std::size_t begin = position_;
  while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t') &&
         text_[position_] != separator_) {
    ++position_;
  }
  if (position_ < text_.size() && text_[position_] == '"') {
    return read_quoted_cell();
  }
  position_ = begin;
  while (!at_line_end() && text_[position_] != separator_) {
    ++position_;
  }
  const std::string_view raw = std::string_view(text_).substr(begin, position_ - begin);
  const std::string_view text = trimmed(raw);
  const std::size_t lead = text.empty() ? 0 : std::size_t(text.data() - raw.data());
  return {text, begin - line_begin_ + lead + 1};
}

CsvCell CsvReader::read_quoted_cell() {
  const std::size_t column = position_ - line_begin_ + 1;
  std::string content;
  for (++position_;; ++position_) {
    if (position_ >= text_.size()) {
      refuse(column, "a quote that is never closed; expected \" at the end of the cell");
    }
    const char c = text_[position_];
    if (c == '"') {
      if (position_ + 1 >= text_.size() || text_[position_ + 1] != '"') {
        break;
      }
      ++position_;
    } else if (c == '\n' || (c == '\r' && text_.compare(position_, 2, "\r\n") != 0)) {
      ++next_line_;
      line_begin_ = position_ + 1;
    }
    content += c;
  }
  ++position_;
  // Text between the quote and the separator belongs to the cell, as spreadsheets read it.
  while (!at_line_end() && text_[position_] != separator_) {
    content += text_[position_++];
  }
  unquoted_.push_back(std::move(content));
  return {trimmed(unquoted_.back()), column};
}

double CsvReader::number(const CsvCell& cell, const std::string& expected) const {
  double value = 0.0;
  if (!parse_number(cell.text, value)) {
    const bool comma = separator_ != ',' && cell.text.find(',') != std::string_view::npos;
    refuse(cell.column,
           fmt::format("'{}' found; expected {}, a plain finite number{}", in_one_line(cell.text),
                       expected, comma ? " with a decimal point" : ""));
  }
  return value;
}

bool is_blank(const std::vector<CsvCell>& row) {
  return std::all_of(row.begin(), row.end(), [](const CsvCell& cell) { return cell.empty(); });
}

}  // namespace limber

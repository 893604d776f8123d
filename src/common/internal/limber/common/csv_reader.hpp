#pragma once

#include <cstddef>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "limber/common/filesystem.hpp"
#include "limber/common/number_text.hpp"

namespace limber {

/// One cell of a CSV row.
struct CsvCell {
  std::string_view text;   ///< without quotes and surrounding blanks; valid until the next row
  std::size_t column = 1;  ///< of its first character in the line, from 1
  bool empty() const { return text.empty(); }
};

/// Reads delimited text row by row: RFC 4180's quotes (a doubled quote is one, a quoted cell may
/// hold separators and line ends), a byte order mark, \n, \r\n and \r line ends. Bytes that are not
/// UTF-8, as of an old program's '°', become \xb0. What a row means is up to the caller; every
/// refusal names file, line and column.
/// Threads: one.
class CsvReader {
 public:
  /// @throws InputError if the file can't be read, or is UTF-16 (as some spreadsheets save).
  static CsvReader from_file(const fs::path& path, char separator = ',');
  /// @param name  stands for the file in messages.
  CsvReader(std::string text, std::string name, char separator = ',');

  /// The next row, blank ones included (a single empty cell); false at the end of the file.
  /// @throws InputError if a quote is never closed.
  bool next(std::vector<CsvCell>& row);

  /// Passes over one line, whatever quotes it holds.
  void skip_line();

  /// Passes over lines that begin with `first`, whatever quotes they hold.
  void skip_lines_with(char first);

  /// Line on which the last row began, from 1; 1 before the first.
  std::size_t line() const { return line_ == 0 ? 1 : line_; }
  const std::string& name() const { return name_; }

  /// @throws InputError "file:line:column: message".
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const;

  /// The cell as a finite number with a decimal point. @throws InputError that says what was
  /// `expected`, and names the decimal comma if there is one.
  double number(const CsvCell& cell, const std::string& expected) const;

 private:
  CsvCell read_cell();
  CsvCell read_quoted_cell();
  void end_line();
  bool at_line_end() const;

  std::string text_;
  std::string name_;
  char separator_;
  std::size_t position_ = 0;
  std::size_t line_ = 0;              // of the last row
  std::size_t next_line_ = 1;         // of the character at position_
  std::size_t line_begin_ = 0;        // of the line of that character
  std::deque<std::string> unquoted_;  // cells of the last row that had doubled quotes
};

/// Whether a row holds nothing.
bool is_blank(const std::vector<CsvCell>& row);

}  // namespace limber

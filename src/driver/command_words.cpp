#include "command_words.hpp"

#include <optional>

#include <fmt/format.h>

#include "limber/common/error.hpp"

namespace limber {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

}  // namespace

std::vector<std::string> command_words(const std::string& command) {
  std::vector<std::string> words;
  std::optional<std::string> word;
  char quote = 0;
  for (std::size_t i = 0; i < command.size(); ++i) {
    const char c = command[i];
    if (quote == 0 && is_blank(c)) {
      if (word) {
        words.push_back(std::move(*word));
        word.reset();
      }
      continue;
    }
    if (!word) {
      word.emplace();
    }
    const char next = i + 1 < command.size() ? command[i + 1] : '\0';
    if (c == '\\' && next != '\0' &&
        (quote == 0 || (quote == '"' && (next == '"' || next == '\\')))) {
      *word += next;
      ++i;
    } else if (quote == 0 && (c == '\'' || c == '"')) {
      quote = c;
    } else if (c == quote) {
      quote = 0;
    } else {
      *word += c;
    }
  }
  if (quote != 0) {
    throw InputError(fmt::format("--driver exec:{}: a quote ({}) has no end", command, quote));
  }
  if (word) {
    words.push_back(std::move(*word));
  }
  if (words.empty()) {
    throw InputError(
        "--driver exec: no command found; expected exec:COMMAND, as in \"exec:python3 driver.py\"");
  }
  return words;
}

}  // namespace limber

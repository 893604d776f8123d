#include "mutation.hpp"

#include <algorithm>
#include <charconv>

namespace limber::fuzz {

namespace {

constexpr const char* kNumbers[] = {"0",
                                    "-0.0",
                                    "1",
                                    "-1",
                                    "2",
                                    "1e-7",
                                    "0.5",
                                    "101",
                                    "1e6",
                                    "1e39",
                                    "-1e308",
                                    "1e309",
                                    "5e-324",
                                    "nan",
                                    "inf",
                                    "2147483647",
                                    "2147483648",
                                    "-2147483649",
                                    "18446744073709551616",
                                    "0x10",
                                    "1_000",
                                    "1,5",
                                    "null",
                                    "true",
                                    "[]",
                                    "{}",
                                    "\"1\"",
                                    ""};
constexpr std::size_t kMaxPiece = 64;  // bytes
constexpr std::uint32_t kMaxChanges = 4;

std::size_t place(const std::string& text, RandomStream& random) {
  return random.index(static_cast<std::uint32_t>(text.size() + 1));
}

/// A piece of `text`: mostly short, else any.
std::string piece(const std::string& text, RandomStream& random) {
  const std::size_t from = place(text, random);
  const std::size_t longest = random.index(4) == 0 ? text.size() : kMaxPiece;
  return text.substr(from, random.index(static_cast<std::uint32_t>(longest + 1)));
}

bool is_of_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e';
}

/// The number that stands at `at` or after it, replaced by another.
void change_number(std::string& text, std::size_t at, RandomStream& random) {
  const auto begin = std::find_if(text.begin() + static_cast<std::ptrdiff_t>(at), text.end(),
                                  [](char c) { return c >= '0' && c <= '9'; });
  const auto end = std::find_if_not(begin, text.end(), is_of_number);
  text.replace(begin, end, kNumbers[random.index(std::size(kNumbers))]);
}

void change(std::string& text, const std::vector<std::string>& inputs,
            const std::vector<std::string>& words, RandomStream& random) {
  const std::size_t at = place(text, random);
  const auto pick = [&](const std::vector<std::string>& from) -> const std::string& {
    return from[random.index(static_cast<std::uint32_t>(from.size()))];
  };
  switch (random.index(8)) {
    case 0:
      if (at < text.size()) {
        text[at] = static_cast<char>(text[at] ^ (1 << random.index(8)));
      }
      return;
    case 1:
      text.insert(at, 1, static_cast<char>(random.index(256)));
      return;
    case 2:
      text.erase(at, random.index(kMaxPiece));
      return;
    case 3:
      text.erase(at);
      return;
    case 4:
      text.insert(at, piece(text, random));
      return;
    case 5:
      text.insert(at, piece(pick(inputs), random));
      return;
    case 6:
      text.insert(at, words.empty() ? "" : pick(words));
      return;
    default:
      change_number(text, at, random);
  }
}

}  // namespace

std::vector<std::string> dictionary_words(std::string_view text) {
  std::vector<std::string> words;
  std::string word;
  bool within = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!within && text[i] == '#') {
      i = std::min(text.find('\n', i), text.size());
    } else if (text[i] == '"') {
      if (within) {
        words.push_back(word);
      }
      word.clear();
      within = !within;
    } else if (within && text[i] == '\\' && text.substr(i).starts_with("\\x")) {
      unsigned byte = 0;
      const std::string_view digits = text.substr(std::min(i + 2, text.size()), 2);
      (void)std::from_chars(digits.data(), digits.data() + digits.size(), byte, 16);
      word += static_cast<char>(byte);
      i += 3;
    } else if (within) {
      i += text[i] == '\\' ? 1 : 0;
      word += i < text.size() ? text[i] : '\\';
    }
  }
  return words;
}

std::string mutant(const std::vector<std::string>& inputs, const std::vector<std::string>& words,
                   RandomStream& random) {
  std::string text = inputs[random.index(static_cast<std::uint32_t>(inputs.size()))];
  for (std::uint32_t left = 1 + random.index(kMaxChanges); left > 0; --left) {
    change(text, inputs, words, random);
  }
  return text;
}

}  // namespace limber::fuzz

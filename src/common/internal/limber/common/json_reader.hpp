#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json_fwd.hpp>

#include "limber/common/filesystem.hpp"

namespace limber {

/// Levels of nested lists and objects that are read: limber's own files need 6, and a deeper
/// recursion could overflow the stack.
inline constexpr int kMaxJsonLevels = 32;

/// limber reads all JSON through this: an object, in UTF-8, with or without a byte order mark,
/// at most kMaxJsonLevels deep, with numbers that a double can hold, and no key twice in an object.
/// @param where  begins every message: the file, or the part of it.
/// @throws InputError
nlohmann::json parse_json_object(std::string_view text, const std::string& where);

/// The same for a whole file. @throws InputError naming it, also if it can't be read.
nlohmann::json read_json_object(const fs::path& path);

/// A value in a few words, for messages: "'text'", "3", "a list of 200"; long texts shortened.
std::string in_few_words(const nlohmann::json& value);

/// One value of a JSON file with its place: every refusal names file and field, what was found and
/// what is allowed. Borrows the value.
class JsonReader {
 public:
  static constexpr double kMaxNumber = std::numeric_limits<double>::max();

  /// @param file   begins every message
  /// @param field  path of the value in the file; empty for the root
  JsonReader(const nlohmann::json& value, std::string file, std::string field = "");

  /// The value at `key`. @throws InputError if it is missing or this is no object.
  JsonReader at(const char* key) const;
  bool has(const char* key) const;
  /// @throws InputError at the first key that is none of these; not where this is no object.
  void refuse_unknown_keys(const std::vector<std::string>& allowed) const;
  /// @param expected  words the message: "a list of frames"
  std::vector<JsonReader> elements(const std::string& expected) const;

  bool is_null() const;
  std::string text() const;
  bool boolean() const;
  /// A finite number in [low, high].
  double number(double low = -kMaxNumber, double high = kMaxNumber) const;
  /// A whole number from 0 to `most`.
  std::uint64_t count(std::uint64_t most) const;
  /// The same, as an int in [low, high].
  int integer(int low, int high) const;
  /// Numbers in [low, high]. @param size  how many there have to be; npos: any number of them.
  std::vector<double> numbers(std::size_t size, const char* what, double low = -kMaxNumber,
                              double high = kMaxNumber) const;

  /// @throws InputError if the text `schema` is another than `expected`.
  void require_schema(const std::string& expected) const;

  const nlohmann::json& value() const { return value_; }
  /// @throws InputError "file: field: message".
  [[noreturn]] void refuse(const std::string& message) const;
  /// The same if it `is_bad`; as the free function of this name.
  template <typename... Arguments>
  void refuse_if(bool is_bad, fmt::format_string<Arguments...> message,
                 Arguments&&... arguments) const {
    if (is_bad) {
      refuse(fmt::format(message, std::forward<Arguments>(arguments)...));
    }
  }
  /// `message` with "… found; " before it.
  [[noreturn]] void refuse_found(const std::string& message) const;

 private:
  const nlohmann::json& value_;
  std::string file_;
  std::string field_;
};

}  // namespace limber

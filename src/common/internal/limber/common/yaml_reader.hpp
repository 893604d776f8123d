#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "limber/common/filesystem.hpp"

namespace limber {

/// One value of a YAML file with its place, "file:line: field.path": every refusal names both, with
/// what was found and what is allowed. Numbers that are not finite are refused everywhere.
class YamlReader {
 public:
  /// @throws InputError if the file is missing, empty or no YAML (with line and column).
  static YamlReader from_file(const fs::path& path);
  /// @param name  stands for the file in messages.
  static YamlReader from_text(const std::string& text, const std::string& name);

  bool has(const std::string& key) const;
  bool is_mapping() const { return node_.IsMap(); }
  bool is_sequence() const { return node_.IsSequence(); }
  /// The value at `key`. @throws InputError if it is missing or this is no mapping.
  YamlReader at(const std::string& key) const;
  /// The elements of a sequence. @throws InputError if this is no sequence.
  std::vector<YamlReader> elements() const;
  /// Keys of a mapping in the file's order. @throws InputError if this is no mapping.
  std::vector<std::string> keys() const;
  /// Refuses keys that are not in `allowed` (a misspelt key would otherwise be a silent default).
  void refuse_unknown_keys(const std::vector<std::string>& allowed) const;
  /// Makes `value` what `read` makes of the value at `key`; without one it stays.
  template <class Value, class Read>
  void read_if_there(const std::string& key, Value& value, const Read& read) const {
    if (has(key)) {
      value = std::invoke(read, at(key));
    }
  }

  std::string text() const;
  bool boolean() const;
  /// A finite number in [low, high]; `unit` only words the message ("a length in metres").
  double number(const std::string& unit, double low = -std::numeric_limits<double>::max(),
                double high = std::numeric_limits<double>::max()) const;
  /// A finite number > 0.
  double positive(const std::string& unit) const;
  int integer(const std::string& what, int low, int high) const;
  std::vector<double> numbers(const std::string& unit) const;
  std::vector<std::string> texts() const;

  /// The schema line of the file: @throws InputError if it is another than `expected`.
  void require_schema(const std::string& expected) const;

  /// @throws InputError "file:line: field: message".
  [[noreturn]] void refuse(const std::string& message) const;
  /// The same if it `is_bad`; as the free function of this name.
  template <typename... Arguments>
  void refuse_if(bool is_bad, fmt::format_string<Arguments...> message,
                 Arguments&&... arguments) const {
    if (is_bad) {
      refuse(fmt::format(message, std::forward<Arguments>(arguments)...));
    }
  }
  /// The value as written in the file, for messages.
  std::string found() const;
  const std::string& file() const { return file_; }
  /// The mapping at `key` as a YAML text of its own, for a reader that comes later: each entry is
  /// on the line that it has in the file, so that messages about it name the same line.
  std::string mapping_as_text(const std::string& key) const;

 private:
  YamlReader(std::string file, std::string field, YAML::Node node, int line);

  std::string file_;
  std::string field_;
  YAML::Node node_;
  int line_;  // from 1
};

/// A text as one line of YAML that reads back the same, whatever it holds.
std::string yaml_text(const std::string& text);

}  // namespace limber

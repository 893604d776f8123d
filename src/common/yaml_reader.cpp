#include "limber/common/yaml_reader.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_format.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

int line_of(const YAML::Node& node, int fallback) {
  return node.Mark().is_null() ? fallback : node.Mark().line + 1;
}

/// From 1. yaml-cpp loads the first document, passes over the others, and counts some without end.
std::optional<int> line_of_second_document(const std::string& text) {
  std::istringstream lines(
      text.substr(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0));
  bool has_content = false;
  bool has_ended = false;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    const bool is_mark = line.size() == 3 || line.find_first_of(" \t\r", 3) == 3;
    const bool is_begin = is_mark && line.starts_with("---");
    const bool is_end = is_mark && line.starts_with("...");
    has_ended = has_ended || is_end || (is_begin && has_content);
    const std::size_t first = line.find_first_not_of(" \t\r", is_begin || is_end ? 3 : 0);
    if (first != std::string::npos && line[first] != '#' && line[0] != '%') {
      if (has_ended) {
        return number;
      }
      has_content = true;
    }
  }
  return std::nullopt;
}

/// yaml-cpp makes a byte that is not UTF-8 of the escapes \_ and \N.
void refuse_other_bytes(const YAML::Node& scalar, const std::string& name) {
  if (!is_utf8(scalar.Scalar())) {
    throw InputError(fmt::format("{}:{}: '{}': an escape that gives no UTF-8; write the character",
                                 name, line_of(scalar, 1),
                                 with_other_bytes_escaped(shortened(scalar.Scalar()))));
  }
}

/// What yaml-cpp accepts. A repeated key would silently win or lose. `seen` holds the positions of
/// visited collections, so that aliases are walked once however often they are named.
void refuse_oddities(const YAML::Node& node, const std::string& name, const std::string& field,
                     std::set<int>& seen) {
  if (node.IsScalar()) {
    refuse_other_bytes(node, name);
  }
  if ((!node.IsMap() && !node.IsSequence()) || !seen.insert(node.Mark().pos).second) {
    return;
  }
  if (node.IsSequence()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      refuse_oddities(node[i], name, fmt::format("{}[{}]", field, i), seen);
    }
    return;
  }
  std::set<std::string> keys;
  for (const auto& entry : node) {
    if (entry.first.IsScalar()) {
      refuse_other_bytes(entry.first, name);
    }
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "?";
    const std::string path = field.empty() ? key : field + "." + key;
    if (!keys.insert(key).second) {
      throw InputError(
          fmt::format("{}:{}: {}: the key occurs twice", name, line_of(entry.first, 1), path));
    }
    refuse_oddities(entry.second, name, path, seen);
  }
}

}  // namespace

YamlReader::YamlReader(std::string file, std::string field, YAML::Node node, int line)
    : file_(std::move(file)), field_(std::move(field)), node_(std::move(node)), line_(line) {}

YamlReader YamlReader::from_file(const fs::path& path) {
  return from_text(read_file(path), path.string());
}

YamlReader YamlReader::from_text(const std::string& text, const std::string& name) {
  refuse_other_format(text, "YAML", name);
  if (const std::size_t at = find_invalid_utf8(text); at != std::string::npos) {
    throw InputError(fmt::format("{}:{}: a byte that is not UTF-8; save the file as UTF-8", name,
                                 1 + std::count(text.begin(), text.begin() + long(at), '\n')));
  }
  if (const std::size_t at = text.find('\0'); at != std::string::npos) {
    throw InputError(fmt::format("{}:{}: a byte that is zero; expected text", name,
                                 1 + std::count(text.begin(), text.begin() + long(at), '\n')));
  }
  if (const std::optional<int> line = line_of_second_document(text)) {
    throw InputError(fmt::format("{}:{}: another document; expected one in the file", name, *line));
  }
  try {
    const YAML::Node root = YAML::Load(text);
    if (!root.IsMap()) {
      throw InputError(fmt::format("{}:1: expected a mapping (key: value …), found {}", name,
                                   root.IsNull() ? "an empty file" : "something else"));
    }
    std::set<int> seen_nodes;
    refuse_oddities(root, name, "", seen_nodes);
    return YamlReader(name, "", root, 1);
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format("{}:{}:{}: not valid YAML: {}", name, error.mark.line + 1,
                                 error.mark.column + 1, with_other_bytes_escaped(error.msg)));
  }
}

void YamlReader::refuse(const std::string& message) const {
  const std::string where = field_.empty() ? "" : field_ + ": ";
  throw InputError(fmt::format("{}:{}: {}{}", file_, line_, where, message));
}

std::string YamlReader::found() const {
  switch (node_.Type()) {
    case YAML::NodeType::Scalar:
      return fmt::format("'{}'", shortened(node_.Scalar()));
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node_.size());
    case YAML::NodeType::Map:
      return "a mapping";
    default:
      return "nothing";
  }
}

bool YamlReader::has(const std::string& key) const {
  return node_.IsMap() && static_cast<bool>(node_[key]);
}

YamlReader YamlReader::at(const std::string& key) const {
  if (!node_.IsMap()) {
    refuse(fmt::format("{} found; expected a mapping with the key '{}'", found(), key));
  }
  const YAML::Node child = node_[key];
  refuse_if(!child, "the key '{}' is missing", key);
  int line = line_of(child, line_);
  if (child.IsNull()) {  // yaml-cpp puts an absent value where the next token is
    for (const auto& entry : node_) {
      line = entry.second.is(child) ? line_of(entry.first, line) : line;
    }
  }
  return YamlReader(file_, field_.empty() ? key : field_ + "." + key, child, line);
}

std::vector<YamlReader> YamlReader::elements() const {
  if (!node_.IsSequence()) {
    refuse(fmt::format("{} found; expected a list", found()));
  }
  return mapped<YamlReader>(node_.size(), [&](std::size_t i) {
    return YamlReader(file_, fmt::format("{}[{}]", field_, i), node_[i], line_of(node_[i], line_));
  });
}

std::vector<std::string> YamlReader::keys() const {
  if (!node_.IsMap()) {
    refuse(fmt::format("{} found; expected a mapping", found()));
  }
  return mapped<std::string>(node_, [&](const auto& entry) {
    return entry.first.IsScalar() ? entry.first.Scalar() : "?";
  });
}

std::string YamlReader::mapping_as_text(const std::string& key) const {
  const YamlReader mapping = at(key);
  std::string text;
  int line = 1;
  const auto add = [&](int wanted, const std::string& added) {
    for (; line < wanted; ++line) {
      text += '\n';
    }
    text += added + "\n";
    ++line;
  };
  const std::vector<std::string> keys = mapping.keys();
  add(keys.empty() ? mapping.line_ : line_of(mapping.node_.begin()->first, mapping.line_) - 1,
      key + (keys.empty() ? ": {}" : ":"));
  for (const auto& entry : mapping.node_) {
    YAML::Emitter emitter;
    emitter << YAML::Flow << entry.second;
    add(line_of(entry.first, line), fmt::format("  {}: {}", entry.first.Scalar(), emitter.c_str()));
  }
  return text;
}

void YamlReader::refuse_unknown_keys(const std::vector<std::string>& allowed) const {
  for (const std::string& key : keys()) {
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end()) {
      at(key).refuse(fmt::format("unknown key; allowed here: {}", fmt::join(allowed, ", ")));
    }
  }
}

std::string YamlReader::text() const {
  if (!node_.IsScalar()) {
    refuse(fmt::format("{} found; expected a text", found()));
  }
  return node_.Scalar();
}

bool YamlReader::boolean() const {
  if (node_.IsScalar() && (node_.Scalar() == "true" || node_.Scalar() == "false")) {
    return node_.Scalar() == "true";
  }
  refuse(fmt::format("{} found; expected true or false", found()));
}

double YamlReader::number(const std::string& unit, double low, double high) const {
  double value = 0.0;
  if (!node_.IsScalar() || !parse_number(node_.Scalar(), value)) {
    refuse(fmt::format("{} found; expected {}, a plain finite number", found(), unit));
  }
  if (value < low || value > high) {
    constexpr double kUnbounded = std::numeric_limits<double>::max();
    const std::string range = low == -kUnbounded   ? fmt::format("at most {}", high)
                              : high == kUnbounded ? fmt::format("at least {}", low)
                                                   : fmt::format("from {} to {}", low, high);
    refuse(fmt::format("{} found; expected {}, {}", value, unit, range));
  }
  return value;
}

double YamlReader::positive(const std::string& unit) const {
  const double value = number(unit);
  refuse_if(value <= 0.0, "{} found; expected {}, > 0", value, unit);
  return value;
}

int YamlReader::integer(const std::string& what, int low, int high) const {
  const double value = number(what, low, high);
  refuse_if(value != std::floor(value), "{} found; expected {}, a whole number", value, what);
  return int(value);
}

std::vector<double> YamlReader::numbers(const std::string& unit) const {
  return mapped<double>(elements(),
                        [&](const YamlReader& element) { return element.number(unit); });
}

std::vector<std::string> YamlReader::texts() const {
  return mapped<std::string>(elements(), [&](const YamlReader& element) { return element.text(); });
}

void YamlReader::require_schema(const std::string& expected) const {
  const YamlReader schema = at("schema");
  if (schema.text() != expected) {
    schema.refuse(fmt::format("{} found; this program reads '{}'", schema.found(), expected));
  }
}

std::string yaml_text(const std::string& text) {
  YAML::Emitter emitter;
  emitter.SetStringFormat(YAML::DoubleQuoted);
  emitter << text;
  return emitter.c_str();
}

}  // namespace limber

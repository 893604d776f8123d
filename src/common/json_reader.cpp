#include "limber/common/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/file_format.hpp"
#include "limber/common/filesystem.hpp"
#include "limber/common/mapped.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

using PlainJson = nlohmann::json;

/// A few numbers, which say more than how many there are.
bool is_short(const PlainJson& list) {
  constexpr std::size_t kMaxShown = 4;
  return list.size() <= kMaxShown &&
         std::ranges::all_of(list, [](const PlainJson& item) { return item.is_number(); });
}

/// What the library says, without its own numbering: "[json.exception.parse_error.101] ".
std::string reason_of(const PlainJson::exception& error) {
  constexpr std::size_t kMaxReason = 160;
  const std::string text = with_other_bytes_escaped(error.what());  // it quotes what it read
  const std::size_t end = text.find("] ");
  return shortened(end == std::string::npos ? text : text.substr(end + 2), kMaxReason);
}

}  // namespace

PlainJson parse_json_object(std::string_view text, const std::string& where) {
  std::vector<std::set<std::string>> keys;  // of the objects that are open
  const auto sound = [&](int depth, PlainJson::parse_event_t event, const PlainJson& value) {
    using Event = PlainJson::parse_event_t;
    if (event == Event::object_start) {
      keys.emplace_back();
    } else if (event == Event::object_end) {
      keys.pop_back();
    } else if (event == Event::key && !keys.back().insert(value.get<std::string>()).second) {
      throw InputError(
          fmt::format("{}: the key {} stands twice in one object; which of the two "
                      "counts can't be known",
                      where, in_few_words(value)));
    }
    refuse_if(
        (event == Event::object_start || event == Event::array_start) && depth >= kMaxJsonLevels,
        "{}: lists and objects nested more than {} deep; no limber file has so many", where,
        kMaxJsonLevels);
    return true;
  };
  try {
    PlainJson root = PlainJson::parse(text, sound);
    if (!root.is_object()) {
      throw InputError(
          fmt::format("{}: {} found; expected a JSON object, {{…}}", where, in_few_words(root)));
    }
    return root;
  } catch (const PlainJson::exception& error) {
    throw InputError(fmt::format("{}: not valid JSON: {}", where, reason_of(error)));
  }
}

PlainJson read_json_object(const fs::path& path) {
  const std::string text = read_file(path);
  refuse_other_format(text, "JSON", path.string());
  return parse_json_object(text, path.string());
}

std::string in_few_words(const PlainJson& value) {
  switch (value.type()) {
    case PlainJson::value_t::null:
      return "null";
    case PlainJson::value_t::object:
      return fmt::format("an object of {}", value.size());
    case PlainJson::value_t::array:
      return is_short(value) ? value.dump() : fmt::format("a list of {}", value.size());
    case PlainJson::value_t::string:
      return fmt::format("'{}'", shortened(value.get_ref<const std::string&>()));
    default:
      return value.dump();
  }
}

JsonReader::JsonReader(const PlainJson& value, std::string file, std::string field)
    : value_(value), file_(std::move(file)), field_(std::move(field)) {}

void JsonReader::refuse(const std::string& message) const {
  throw InputError(fmt::format("{}: {}{}", file_, field_.empty() ? "" : field_ + ": ", message));
}

void JsonReader::refuse_found(const std::string& message) const {
  refuse(fmt::format("{} found; {}", in_few_words(value_), message));
}

JsonReader JsonReader::at(const char* key) const {
  std::string field = field_.empty() ? key : fmt::format("{}.{}", field_, key);
  limber::refuse_if(!has(key), "{}: {}: missing", file_, field);  // of the part, not of this
  return {value_.at(key), file_, std::move(field)};
}

bool JsonReader::has(const char* key) const {
  return value_.is_object() && value_.contains(key);
}

void JsonReader::refuse_unknown_keys(const std::vector<std::string>& allowed) const {
  for (auto entry = value_.begin(); value_.is_object() && entry != value_.end(); ++entry) {
    if (std::ranges::find(allowed, entry.key()) == allowed.end()) {
      at(entry.key().c_str())
          .refuse(fmt::format("unknown key; allowed here: {}", fmt::join(allowed, ", ")));
    }
  }
}

std::vector<JsonReader> JsonReader::elements(const std::string& expected) const {
  if (!value_.is_array()) {
    refuse_found("expected " + expected);
  }
  return mapped<JsonReader>(value_.size(), [&](std::size_t i) {
    return JsonReader(value_[i], file_, fmt::format("{}[{}]", field_, i));
  });
}

bool JsonReader::is_null() const {
  return value_.is_null();
}

std::string JsonReader::text() const {
  if (!value_.is_string()) {
    refuse_found("expected a text");
  }
  return value_.get<std::string>();
}

bool JsonReader::boolean() const {
  if (!value_.is_boolean()) {
    refuse_found("expected true or false");
  }
  return value_.get<bool>();
}

double JsonReader::number(double low, double high) const {
  if (!value_.is_number()) {
    refuse_found("expected a finite number");
  }
  const double value = value_.get<double>();
  if (!(value >= low && value <= high)) {
    refuse_found(low == -kMaxNumber   ? fmt::format("expected a number of at most {}", high)
                 : high == kMaxNumber ? fmt::format("expected a number of at least {}", low)
                                      : fmt::format("expected a number from {} to {}", low, high));
  }
  return value;
}

std::uint64_t JsonReader::count(std::uint64_t most) const {
  if (!value_.is_number_unsigned() || value_.get<std::uint64_t>() > most) {
    refuse_found(fmt::format("expected a whole number from 0 to {}", most));
  }
  return value_.get<std::uint64_t>();
}

int JsonReader::integer(int low, int high) const {
  // A number beyond 64 bits is read as a double, and is none of these.
  const bool fits = value_.is_number_unsigned() ? value_.get<std::uint64_t>() <= INT64_MAX
                                                : value_.is_number_integer();
  const std::int64_t value = fits ? value_.get<std::int64_t>() : 0;
  if (!fits || value < low || value > high) {
    refuse_found(fmt::format("expected a whole number from {} to {}", low, high));
  }
  return int(value);
}

std::vector<double> JsonReader::numbers(std::size_t size, const char* what, double low,
                                        double high) const {
  if (!value_.is_array()) {
    refuse_found(fmt::format("expected a list of {}", what));
  }
  refuse_if(size != std::string::npos && value_.size() != size, "{} numbers found; expected {} {}",
            value_.size(), size, what);
  std::vector<double> result;
  result.reserve(value_.size());
  for (std::size_t i = 0; i < value_.size(); ++i) {
    const PlainJson& item = value_[i];
    const double value = item.is_number() ? item.get<double>() : std::nan("");
    if (!(value >= low && value <= high)) {
      // Says what and where.
      (void)JsonReader(item, file_, fmt::format("{}[{}]", field_, i)).number(low, high);
    }
    result.push_back(value);
  }
  return result;
}

void JsonReader::require_schema(const std::string& expected) const {
  const JsonReader schema = at("schema");
  if (schema.text() != expected) {
    schema.refuse_found(fmt::format("this program reads '{}'", expected));
  }
}

}  // namespace limber

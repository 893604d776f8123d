#include "limber/common/safetensors.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "limber/common/error.hpp"
#include "limber/common/file_format.hpp"
#include "limber/common/json_reader.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/common/utf8.hpp"

namespace limber {

namespace {

using PlainJson = nlohmann::json;

constexpr std::size_t kLengthBytes = 8;
constexpr std::size_t kAlignment = 8;
constexpr std::uint64_t kMaxHeader = 100'000'000;  // the format's own limit
// Of a dimension: beside one of 0, no data bound it, and whoever goes through its columns takes as
// long as through real ones.
constexpr std::size_t kMaxSize = std::size_t{1} << 28U;
constexpr const char* kMetadataKey = "__metadata__";
constexpr const char* kFloats = "F32";
constexpr const char* kShorts = "I16";
static_assert(std::endian::native == std::endian::little,
              "safetensors is little endian; swap bytes here for other machines");

[[noreturn]] void refuse(const std::string& where, const std::string& what) {
  throw InputError(where + ": " + what);
}

struct Range {
  std::size_t begin = 0;
  std::size_t end = 0;
  std::string tensor;
};

std::string_view header_of(std::string_view bytes, const std::string& where) {
  refuse_if(bytes.size() < kLengthBytes,
            "{}: {} bytes; a safetensors file begins with 8 bytes of header length", where,
            bytes.size());
  std::uint64_t length = 0;
  std::memcpy(&length, bytes.data(), kLengthBytes);
  refuse_if(length > kMaxHeader || length > bytes.size() - kLengthBytes,
            "{}: header length is {} bytes, but {} follow it: truncated, or not a safetensors file",
            where, length, bytes.size() - kLengthBytes);
  return bytes.substr(kLengthBytes, std::size_t(length));
}

// A list of whole numbers ≥ 0 at header[name][key].
std::vector<std::size_t> sizes_at(const PlainJson& entry, const char* key, const std::string& name,
                                  const std::string& where) {
  const auto found = entry.find(key);
  refuse_if(found == entry.end() || !found->is_array(), "{}: tensor {}: no list {}", where, name,
            key);
  std::vector<std::size_t> sizes;
  for (const PlainJson& size : *found) {
    if (!size.is_number_unsigned()) {
      refuse(where, fmt::format("tensor {}: {} is {}; expected whole numbers ≥ 0", name, key,
                                in_few_words(*found)));
    }
    sizes.push_back(size.get<std::size_t>());
  }
  return sizes;
}

std::size_t element_count(const std::vector<std::size_t>& shape, const std::string& name,
                          const std::string& where) {
  std::size_t count = 1;
  for (const std::size_t size : shape) {
    if (size > kMaxSize ||
        (size != 0 && count > std::numeric_limits<std::size_t>::max() / sizeof(float) / size)) {
      refuse(where,
             fmt::format("tensor {}: shape [{}] is too large", name, fmt::join(shape, ", ")));
    }
    count *= size;
  }
  return count;
}

std::string dtype_of(const PlainJson& entry, const std::string& name, const std::string& where) {
  if (!entry.is_object()) {
    refuse(where, fmt::format("tensor {}: header entry is {}; expected an object", name,
                              in_few_words(entry)));
  }
  return entry.contains("dtype") && entry["dtype"].is_string() ? entry["dtype"].get<std::string>()
                                                               : "missing";
}

template <class Number>
TensorOf<Number> read_tensor(const PlainJson& entry, const std::string& name, std::string_view data,
                             const std::string& where, Range& range) {
  TensorOf<Number> tensor;
  tensor.shape = sizes_at(entry, "shape", name, where);
  const std::vector<std::size_t> offsets = sizes_at(entry, "data_offsets", name, where);
  if (offsets.size() != 2 || offsets[0] > offsets[1] || offsets[1] > data.size()) {
    refuse(where, fmt::format("tensor {}: data_offsets are [{}]; expected [begin, end] within the "
                              "{} bytes behind the header (is the file truncated?)",
                              name, fmt::join(offsets, ", "), data.size()));
  }
  const std::size_t count = element_count(tensor.shape, name, where);
  if (offsets[1] - offsets[0] != count * sizeof(Number)) {
    refuse(where, fmt::format("tensor {}: data_offsets span {} bytes; shape [{}] needs {}", name,
                              offsets[1] - offsets[0], fmt::join(tensor.shape, ", "),
                              count * sizeof(Number)));
  }
  tensor.values.resize(count);
  if (count > 0) {
    std::memcpy(tensor.values.data(), data.data() + offsets[0], count * sizeof(Number));
  }
  range = {offsets[0], offsets[1], name};
  return tensor;
}

template <class Number>
void append_tensors(const std::map<std::string, TensorOf<Number>>& tensors, const char* dtype,
                    PlainJson& header, std::string& data) {
  for (const auto& [name, tensor] : tensors) {
    const std::size_t begin = data.size();
    data.append(reinterpret_cast<const char*>(tensor.values.data()),
                tensor.values.size() * sizeof(Number));
    header[name] = {
        {"dtype", dtype}, {"shape", tensor.shape}, {"data_offsets", {begin, data.size()}}};
  }
}

// The format wants the tensors to cover the data without overlaps or holes.
void require_contiguous(std::vector<Range> ranges, std::size_t size, const std::string& where) {
  std::sort(ranges.begin(), ranges.end(), [](const Range& a, const Range& b) {
    return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
  });
  std::size_t end = 0;
  for (const Range& range : ranges) {
    if (range.begin != end) {
      refuse(where,
             fmt::format("tensor {}: data begins at byte {}; expected "
                         "{}, the end of the tensor before it ({})",
                         range.tensor, range.begin, end, range.begin < end ? "overlap" : "hole"));
    }
    end = range.end;
  }
  refuse_if(end != size, "{}: {} bytes of data behind the last tensor", where, size - end);
}

std::map<std::string, std::string> read_metadata(const PlainJson& metadata,
                                                 const std::string& where) {
  refuse_if(!metadata.is_object(), "{}: __metadata__ is not a JSON object", where);
  std::map<std::string, std::string> strings;
  for (const auto& [key, value] : metadata.items()) {
    if (!value.is_string()) {
      refuse(where,
             fmt::format("__metadata__ {} is {}; expected a string", key, in_few_words(value)));
    }
    strings[key] = value.get<std::string>();
  }
  return strings;
}

}  // namespace

std::string safetensors_bytes(const Safetensors& content) {
  PlainJson header = PlainJson::object();
  if (!content.metadata.empty()) {
    header[kMetadataKey] = content.metadata;
  }
  std::string data;
  append_tensors(content.tensors, kFloats, header, data);
  append_tensors(content.shorts, kShorts, header, data);  // behind, so that floats stay aligned
  std::string text = header.dump(-1, ' ', false, PlainJson::error_handler_t::replace);
  text.append((kAlignment - text.size() % kAlignment) % kAlignment, ' ');
  const std::uint64_t length = text.size();
  std::string bytes(kLengthBytes, '\0');
  std::memcpy(bytes.data(), &length, kLengthBytes);
  return bytes + text + data;
}

Safetensors parse_safetensors(std::string_view bytes, const std::string& where) {
  refuse_other_format(bytes, kSafetensorsFormat, where);
  const std::string_view text = header_of(bytes, where);
  const std::string_view data = bytes.substr(kLengthBytes + text.size());
  const PlainJson header = parse_json_object(text, where + ": header");
  Safetensors content;
  std::vector<Range> ranges;
  for (const auto& [name, entry] : header.items()) {
    if (name == kMetadataKey) {
      content.metadata = read_metadata(entry, where);
      continue;
    }
    const std::string dtype = dtype_of(entry, name, where);
    if (dtype == kFloats) {
      content.tensors[name] = read_tensor<float>(entry, name, data, where, ranges.emplace_back());
    } else if (dtype == kShorts) {
      content.shorts[name] =
          read_tensor<std::int16_t>(entry, name, data, where, ranges.emplace_back());
    } else {
      refuse(where, fmt::format("tensor {}: dtype is {}; expected {} or {}", name, shortened(dtype),
                                kFloats, kShorts));
    }
  }
  require_contiguous(std::move(ranges), data.size(), where);
  return content;
}

}  // namespace limber

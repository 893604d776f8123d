#include "limber/common/safetensors.hpp"

#include <cstdint>
#include <cstring>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

// Bytes of a file with this header and `data_bytes` zero bytes of data.
std::string file_of(const std::string& header, std::size_t data_bytes) {
  const std::uint64_t length = header.size();
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &length, 8);
  return bytes + header + std::string(data_bytes, '\0');
}

std::string tensor_entry(const std::string& shape, const std::string& offsets,
                         const std::string& dtype = "F32") {
  return R"({"dtype":")" + dtype + R"(","shape":)" + shape + R"(,"data_offsets":)" + offsets + "}";
}

TEST(Safetensors, ComeBackAfterARoundTrip) {
  Safetensors content;
  content.tensors["b"] = {{2, 3}, {1, 2, 3, 4, 5, 6.5F}};
  content.tensors["a"] = {{0}, {}};
  content.shorts["0"] = {{3, 1}, {-32768, 7, 32767}};  // of an odd size, and named first
  content.metadata["what"] = "ein \"Test\" ü";
  const Safetensors back = parse_safetensors(safetensors_bytes(content), "f");
  EXPECT_EQ(back.metadata, content.metadata);
  ASSERT_EQ(back.tensors.size(), 2U);
  EXPECT_EQ(back.tensors.at("b").shape, content.tensors["b"].shape);
  EXPECT_EQ(back.tensors.at("b").values, content.tensors["b"].values);
  EXPECT_TRUE(back.tensors.at("a").values.empty());
  EXPECT_EQ(back.shorts.at("0").shape, content.shorts["0"].shape);
  EXPECT_EQ(back.shorts.at("0").values, content.shorts["0"].values);
}

TEST(Safetensors, DataBeginAtAMultipleOfEight) {
  for (const char* name : {"a", "ab", "abc", "abcd", "abcde"}) {
    Safetensors content;
    content.tensors[name] = {{1}, {1.0F}};
    EXPECT_EQ((safetensors_bytes(content).size() - sizeof(float)) % 8, 0U);
  }
}

TEST(Safetensors, EveryTruncationIsRefused) {
  Safetensors content;
  content.tensors["weight"] = {{2, 2}, {1, 2, 3, 4}};
  content.metadata["schema"] = "s";
  const std::string bytes = safetensors_bytes(content);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW((void)parse_safetensors(std::string_view(bytes).substr(0, size), "f"), InputError)
        << size << " bytes";
  }
}

struct BrokenFile {
  const char* name;
  std::string bytes;
  const char* message;
};

class BrokenSafetensors : public ::testing::TestWithParam<BrokenFile> {};

TEST_P(BrokenSafetensors, AreRefusedByName) {
  EXPECT_THAT([&] { (void)parse_safetensors(GetParam().bytes, "m.safetensors"); },
              ThrowsMessage<InputError>(
                  AllOf(StartsWith("m.safetensors: "), HasSubstr(GetParam().message))));
}

INSTANTIATE_TEST_SUITE_P(
    Files, BrokenSafetensors,
    ::testing::Values(
        BrokenFile{"empty", "", "0 bytes; a safetensors file begins with 8 bytes"},
        BrokenFile{"length_past_end", file_of("{}", 0).replace(0, 1, "\x40"),
                   "header length is 64 bytes, but 2 follow it"},
        BrokenFile{"huge_length", std::string(16, '\xff'), "header length is 18446744073709551615"},
        BrokenFile{"no_json", file_of("{\"a\": ", 0),
                   "header: not valid JSON: parse error at line 1, column 7"},
        BrokenFile{"no_object", file_of("[1]", 0), "header: [1] found; expected a JSON object"},
        BrokenFile{"other_dtype", file_of("{\"w\":" + tensor_entry("[1]", "[0,2]", "F16") + "}", 2),
                   "tensor w: dtype is F16; expected F32 or I16"},
        BrokenFile{"no_dtype", file_of(R"({"w":{"shape":[1]}})", 4),
                   "tensor w: dtype is missing; expected F32 or I16"},
        BrokenFile{"no_shape", file_of(R"({"w":{"dtype":"F32","data_offsets":[0,4]}})", 4),
                   "tensor w: no list shape"},
        BrokenFile{"negative_shape", file_of("{\"w\":" + tensor_entry("[-1]", "[0,4]") + "}", 4),
                   "tensor w: shape is [-1]; expected whole numbers"},
        BrokenFile{"vast_shape",
                   file_of("{\"w\":" + tensor_entry("[4294967296,4294967296]", "[0,4]") + "}", 4),
                   "tensor w: shape [4294967296, 4294967296] is too large"},
        BrokenFile{"vast_beside_nothing",
                   file_of("{\"w\":" + tensor_entry("[0,8589934592]", "[0,0]") + "}", 0),
                   "tensor w: shape [0, 8589934592] is too large"},
        BrokenFile{"offsets_past_end", file_of("{\"w\":" + tensor_entry("[2]", "[0,8]") + "}", 4),
                   "tensor w: data_offsets are [0, 8]; expected [begin, end] within the 4 bytes"},
        BrokenFile{"offsets_reversed", file_of("{\"w\":" + tensor_entry("[1]", "[4,0]") + "}", 4),
                   "tensor w: data_offsets are [4, 0]"},
        BrokenFile{"shape_and_offsets_differ",
                   file_of("{\"w\":" + tensor_entry("[3]", "[0,8]") + "}", 8),
                   "tensor w: data_offsets span 8 bytes; shape [3] needs 12"},
        BrokenFile{"overlap",
                   file_of("{\"a\":" + tensor_entry("[2]", "[0,8]") +
                               ",\"b\":" + tensor_entry("[2]", "[4,12]") + "}",
                           12),
                   "tensor b: data begins at byte 4; expected "
                   "8, the end of the tensor before it (overlap)"},
        BrokenFile{"hole", file_of("{\"a\":" + tensor_entry("[1]", "[4,8]") + "}", 8),
                   "tensor a: data begins at byte 4; expected 0"},
        BrokenFile{"tail", file_of("{\"a\":" + tensor_entry("[1]", "[0,4]") + "}", 9),
                   "5 bytes of data behind the last tensor"},
        BrokenFile{"metadata_number", file_of(R"({"__metadata__":{"epochs":3}})", 0),
                   "__metadata__ epochs is 3; expected a string"},
        BrokenFile{"metadata_list", file_of(R"({"__metadata__":[]})", 0),
                   "__metadata__ is not a JSON object"}),
    [](const auto& file) { return std::string(file.param.name); });

}  // namespace
}  // namespace limber

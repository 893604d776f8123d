#include "limber/common/file_format.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/common/yaml_reader.hpp"

namespace limber {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kRecording = "\x89HDF\r\n\x1a\n";

TEST(FileFormat, IsKnownByTheFirstBytes) {
  EXPECT_EQ(binary_format(kRecording), kHdf5Format);
  EXPECT_EQ(binary_format(safetensors_bytes({})), kSafetensorsFormat);
  for (const char* text : {"", "schema: limber/arm/1\n", "{\"schema\": \"limber/plan/1\"}"}) {
    EXPECT_EQ(binary_format(text), "") << text;
  }
}

TEST(FileFormat, ReadersSayWhatAWrongFileHolds) {
  EXPECT_THAT(
      [] { (void)YamlReader::from_text(kRecording, "r.h5"); },
      ThrowsMessage<InputError>(HasSubstr("r.h5: holds a recording (HDF5); expected YAML")));
  EXPECT_THAT([] { (void)YamlReader::from_text(safetensors_bytes({}), "m"); },
              ThrowsMessage<InputError>(HasSubstr("holds a model or a forest (safetensors)")));
  EXPECT_THAT([] { (void)parse_safetensors(kRecording, "r.h5"); },
              ThrowsMessage<InputError>(HasSubstr("expected safetensors")));
}

}  // namespace
}  // namespace limber

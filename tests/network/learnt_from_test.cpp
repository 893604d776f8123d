// What a model file says of what its network learnt from: measured pressures, or set points.
#include <gmock/gmock.h>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"
#include "support/temporary_folder.hpp"

namespace limber {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

TEST(ModelFile, KeepsWhatItLearntFrom) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  for (const bool setpoints : {false, true}) {
    model.learnt_from_setpoints = setpoints;
    write_model(path, model);
    EXPECT_EQ(parse_safetensors(read_file(path), path).metadata.at("learnt_from"),
              setpoints ? "setpoints" : "measured");
    EXPECT_EQ(read_model(path).learnt_from_setpoints, setpoints);
    EXPECT_EQ(read_model(path).member(0).learnt_from_setpoints, setpoints);
  }
}

// Files of before there were two kinds.
TEST(ModelFile, LearntFromMeasurementsWhereItDoesNotSay) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  write_model(path, untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1));
  Safetensors content = parse_safetensors(read_file(path), path);
  content.metadata.erase("learnt_from");
  write_file_atomically(path, safetensors_bytes(content));
  EXPECT_FALSE(read_model(path).learnt_from_setpoints);
  content.metadata["learnt_from"] = "hearsay";
  write_file_atomically(path, safetensors_bytes(content));
  EXPECT_THAT([&] { (void)read_model(path); },
              ThrowsMessage<InputError>(
                  HasSubstr("metadata learnt_from = 'hearsay'; expected measured or setpoints")));
}

TEST(ModelFile, HasNoValvesBeforeWhatLearntFromSetPoints) {
  const TemporaryFolder folder;
  const std::string path = folder.path() / "model.safetensors";
  CompensationModel model = untrained_model(sample_arm(2), BackboneLayout::gap_poses, {5}, 1);
  model.learnt_from_setpoints = true;
  const ValveParameters valves{true, {{{0.1, 99.5}, {0.12, 80.0}}, {{0.1, 99.5}, {0.12, 80.0}}}};
  EXPECT_THAT(
      [&] {
        model.set_valves({valves, {}});
      },
      ThrowsMessage<InputError>(HasSubstr("their lag would count twice")));
  EXPECT_FALSE(model.valves);
  model.valves = valves;
  EXPECT_THAT([&] { write_model(path, model); },
              ThrowsMessage<InputError>(AllOf(StartsWith(path), HasSubstr("count twice"))));
  model.learnt_from_setpoints = false;
  EXPECT_NO_THROW(write_model(path, model));
}

}  // namespace
}  // namespace limber

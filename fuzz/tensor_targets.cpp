#include <fcntl.h>
#include <unistd.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/arm_family.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/planning/forest.hpp"
#include "limber/world/environment.hpp"
#include "src/data/confined_child.hpp"
#include "src/data/recording_pipe.hpp"
#include "src/training/checkpoint.hpp"
#include "support/test_recording.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

void read_tensors(const Input& input) {
  const Safetensors content = parse_safetensors(input.bytes, input.file);
  const Safetensors again = parse_safetensors(safetensors_bytes(content), "again");
  require(again.tensors.size() == content.tensors.size() && again.metadata == content.metadata,
          "tensors that are others once written");
}

std::vector<std::string> tensor_seeds() {
  Safetensors content;
  content.tensors["a"] = {{2, 3}, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}};
  content.tensors["b"] = {{}, {0.5F}};
  content.shorts["c"] = {{2}, {-1, 7}};
  content.metadata["schema"] = "x";
  return {safetensors_bytes(content)};
}

void read_model_file(const Input& input) {
  const CompensationModel model = read_model(input.file);
  const auto again = scratch_folder() / "again.safetensors";
  write_model(again, model);
  require(read_model(again).shape() == model.shape(), "a model that is another one once written");
  if (model.member_of_family) {
    (void)family_of(model);
  }
  const ArmDescription& arm = model.dimension == Dimension::space ? small_space_arm() : small_arm();
  require_model_of(model, arm, input.file);
  const ForwardModel forward(arm, model);
}

std::vector<std::string> model_seeds() {
  std::vector<std::string> seeds;
  const auto add = [&](const CompensationModel& model) {
    const auto file = scratch_folder() / "seed.safetensors";
    write_model(file, model);
    seeds.push_back(read_file(file));
  };
  for (const BackboneLayout layout : {BackboneLayout::gap_poses, BackboneLayout::base_poses}) {
    CompensationModel model = untrained_model(small_arm(), layout, {2}, 1);
    model.set_arm(small_arm());
    add(model);
  }
  CompensationModel family = untrained_model(small_space_arm(), BackboneLayout::gap_poses, {2}, 1);
  family.set_arm(small_space_arm());
  add(family);
  const Eigen::VectorXf e = Eigen::VectorXf::Ones(1);
  family.family = ArmFamily{Eigen::MatrixXf::Zero(2, 1), Eigen::MatrixXf::Zero(2, 2), e, {}};
  add(family);
  add(model_of_arm(family, {"", e, Eigen::MatrixXf::Ones(1, 1)}));
  return seeds;
}

ForestKey small_key() {
  return forest_key(small_arm(), "", {}, start_state({}, small_arm()));
}

void read_forest_file(const Input& input) {
  const Forest forest = read_forest(input.file);
  const auto again = scratch_folder() / "again.forest";
  write_forest(again, forest);
  require(read_forest(again).size() == forest.size(), "a forest that is another one once written");
  (void)is_grown_for(forest, small_arm(), small_key());
  naming(input.file,
         [&] { require_forest_of(forest, small_arm(), {}, start_state({}, small_arm())); });
}

std::vector<std::string> forest_seeds() {
  ForestSettings settings;
  settings.nodes = 20;
  settings.jobs = 1;
  const ForwardModel model(small_arm());
  const auto file = scratch_folder() / "seed.forest";
  write_forest(
      file, *grow_forest(small_arm(), model, small_key(), start_state({}, small_arm()), settings));
  return {read_file(file)};
}

RunShape small_run() {
  return {4, 2, true, 0, true};
}

void read_checkpoint_file(const Input& input) {
  const Checkpoint checkpoint = read_checkpoint(input.file, "run", small_run());
  const auto again = scratch_folder() / "again.checkpoint";
  write_checkpoint(again, checkpoint);
  require(
      read_checkpoint(again, "run", small_run()).state.epochs_done == checkpoint.state.epochs_done,
      "a checkpoint that is another one once written");
}

std::vector<std::string> checkpoint_seeds() {
  Checkpoint checkpoint;
  checkpoint.identity = "run";
  checkpoint.stages = {{2, 64, 2}, {8, 32, 4}};
  TrainingState& state = checkpoint.state;
  const Eigen::VectorXf numbers = Eigen::VectorXf::LinSpaced(4, 0.1F, 0.4F);
  state.parameters = numbers;
  state.optimiser = {numbers, numbers, {}, 0};
  const auto file = scratch_folder() / "seed.checkpoint";
  write_checkpoint(file, checkpoint);
  return {read_file(file)};
}

void read_recording_file(const Input& input) {
  const Recording recording = read_recording(input.file);
  const auto again = scratch_folder() / "again.h5";
  write_recording(again, recording);
  require(read_recording(again).episodes.size() == recording.episodes.size(),
          "a recording that is another one once written");
  const RecordingInspection inspection = inspect(recording, nullptr, input.file);
  (void)to_text(recording, inspection);
  (void)to_json(recording, inspection).dump();
  (void)base_warning(recording);
}

/// In space, with everything that a recording may say of itself.
Recording space_recording() {
  Recording recording = test_recording(1, 2, 3, 3);
  recording.dimension = Dimension::space;
  recording.segment_count = 1;
  recording.chamber_count = 3;
  recording.arm_description = arm_keys_to_yaml(small_space_arm());
  Episode& episode = recording.episodes[0];
  episode.dimension = Dimension::space;
  episode.lifted = true;
  episode.physics = "{\"chamber_area_m2\": 0.0005}";
  episode.log = "a.csv";
  FrameMatrix poses = FrameMatrix::Zero(2, 21);
  for (const Eigen::Index column : {6, 13, 20}) {  // of the quaternions' real parts
    poses.col(column).setOnes();
  }
  episode.backbone = poses;
  return recording;
}

std::vector<std::string> recording_seeds() {
  std::vector<std::string> seeds;
  for (const Recording& recording : {test_recording(1, 4, 1, 3), space_recording()}) {
    const auto file = scratch_folder() / "seed.h5";
    write_recording(file, recording);
    seeds.push_back(read_file(file));
  }
  return seeds;
}

/// What the process that reads a recording passes on: it may have been taken over by the file.
void read_passed_recording(const Input& input) {
  constexpr std::size_t kRoom = 60'000;  // of a pipe that nobody reads yet
  int ends[2];
  require(pipe(ends) == 0, "no pipe");
  const std::size_t size = std::min(input.bytes.size(), kRoom);
  const bool is_written = write(ends[1], input.bytes.data(), size) == ssize_t(size);
  close(ends[1]);
  Recording recording;
  const auto read_all = [&] {
    PipeReader in("recording.h5", ends[0], std::uintmax_t{1} << 20U, 1000);
    pass_header(in, recording);
    while (true) {
      Episode episode;
      pass(in, episode);
      recording.episodes.push_back(std::move(episode));
    }
  };
  std::string refusal;
  try {
    read_all();
  } catch (const EndOfPipe&) {
  } catch (const InputError& error) {
    refusal = error.what();
  }
  close(ends[0]);
  require(is_written, "a pipe that takes nothing");
  if (!refusal.empty()) {
    throw InputError(refusal);
  }
  validate(recording, "recording.h5");
}

std::vector<std::string> passed_seeds() {
  std::vector<std::string> seeds;
  for (Recording& recording : std::vector{test_recording(1, 4, 1, 3), space_recording()}) {
    const auto file = scratch_folder() / "seed.pipe";
    const int to = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    PipeWriter out(to);
    pass_header(out, recording);
    pass(out, recording.episodes[0]);
    out.flush();
    close(to);
    seeds.push_back(read_file(file));
  }
  return seeds;
}

}  // namespace

std::vector<Target> tensor_targets() {
  return {{"safetensors", "a.safetensors", read_tensors, tensor_seeds},
          {"model", "model.safetensors", read_model_file, model_seeds},
          {"forest", "a.forest", read_forest_file, forest_seeds},
          {"checkpoint", "run.checkpoint", read_checkpoint_file, checkpoint_seeds},
          {"recording", "recording.h5", read_recording_file, recording_seeds},
          {"recording_pipe", "", read_passed_recording, passed_seeds}};
}

}  // namespace limber::fuzz

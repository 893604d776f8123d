#include "limber/common/atomic_file.hpp"
#include "limber/common/error.hpp"
#include "limber/common/random_stream.hpp"
#include "limber/common/safetensors.hpp"
#include "limber/data/recording_inspection.hpp"
#include "limber/forward/forward_model.hpp"
#include "limber/network/compensation_model.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/untrained_model.hpp"
#include "limber/planning/forest.hpp"
#include "limber/world/environment.hpp"
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
  require_model_of(model, small_arm(), input.file);
  const ForwardModel forward(small_arm(), model);
}

std::vector<std::string> model_seeds() {
  std::vector<std::string> seeds;
  for (const BackboneLayout layout : {BackboneLayout::gap_poses, BackboneLayout::base_poses}) {
    CompensationModel model = untrained_model(small_arm(), layout, {2}, 1);
    model.set_arm(small_arm());
    const auto file = scratch_folder() / "seed.safetensors";
    write_model(file, model);
    seeds.push_back(read_file(file));
  }
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

std::vector<std::string> recording_seeds() {
  const auto file = scratch_folder() / "seed.h5";
  write_recording(file, test_recording(1, 4, 1, 3));
  return {read_file(file)};
}

}  // namespace

std::vector<Target> tensor_targets() {
  return {{"safetensors", "a.safetensors", read_tensors, tensor_seeds},
          {"model", "model.safetensors", read_model_file, model_seeds},
          {"forest", "a.forest", read_forest_file, forest_seeds},
          {"checkpoint", "run.checkpoint", read_checkpoint_file, checkpoint_seeds},
          {"recording", "recording.h5", read_recording_file, recording_seeds}};
}

}  // namespace limber::fuzz

// write_sample_model FOLDER: for each layout a model file and, as rows of numbers, random network
// inputs with what limber's packed network answers; read_model.py checks them independently.
#include <filesystem>
#include <fstream>
#include <limits>
#include <vector>

#include "limber/common/random_stream.hpp"
#include "limber/network/packed_network.hpp"
#include "limber/network/untrained_model.hpp"
#include "support/sample_arm.hpp"

namespace limber {
namespace {

constexpr int kQueries = 20;

void write_row(std::ofstream& file, const float* numbers, int count) {
  for (int i = 0; i < count; ++i) {
    file << (i == 0 ? "" : " ") << numbers[i];
  }
  file << "\n";
}

void write_sample(const std::filesystem::path& folder, BackboneLayout layout, OutputForm form) {
  CompensationModel model = untrained_model(sample_arm(3), layout, {100, 100, 100}, 5, form);
  model.training["note"] = "sample";
  const std::string name = std::string(to_string(layout)) + "_" + to_string(form);
  write_model(folder / (name + ".safetensors"), model);

  const PackedNetwork network(model, cpu_level());
  std::vector<float> scratch(2 * static_cast<std::size_t>(network.padded_width()));
  std::ofstream inputs(folder / (name + ".inputs"));
  std::ofstream outputs(folder / (name + ".outputs"));
  inputs.precision(std::numeric_limits<float>::max_digits10);
  outputs.precision(std::numeric_limits<float>::max_digits10);
  RandomStream random(9, 0);
  for (int q = 0; q < kQueries; ++q) {
    std::vector<float> input;
    for (int i = 0; i < network.input_size(); ++i) {
      const double range = 1.0 / static_cast<double>(model.input.scale[i]);
      input.push_back(static_cast<float>(random.uniform(-0.5, 0.5) * range));
    }
    write_row(inputs, input.data(), network.input_size());
    write_row(outputs, network.evaluate(input.data(), scratch.data()), network.output_size());
  }
}

}  // namespace
}  // namespace limber

int main(int argc, char** argv) {
  if (argc != 2) {
    return 2;
  }
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  using enum limber::BackboneLayout;
  using enum limber::OutputForm;
  limber::write_sample(folder, base_poses, compensation);
  limber::write_sample(folder, gap_poses, compensation);
  limber::write_sample(folder, gap_poses, gated_change);
  return 0;
}

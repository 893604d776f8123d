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

void write_sample(const std::filesystem::path& folder, BackboneLayout layout) {
  CompensationModel model = untrained_model(sample_arm(3), layout, {100, 100, 100}, 5);
  model.training["note"] = "sample";
  write_model(folder / (std::string(to_string(layout)) + ".safetensors"), model);

  const PackedNetwork network(model, cpu_level());
  std::vector<float> scratch(2 * static_cast<std::size_t>(network.padded_width()));
  std::ofstream inputs(folder / (std::string(to_string(layout)) + ".inputs"));
  std::ofstream outputs(folder / (std::string(to_string(layout)) + ".outputs"));
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
  limber::write_sample(folder, limber::BackboneLayout::base_poses);
  limber::write_sample(folder, limber::BackboneLayout::gap_poses);
  return 0;
}

// A plan with a network of one's own, and a second opinion on it.
//
//   03_plan_and_verify MODEL.safetensors ENVIRONMENT.yaml PLAN.json

#include <iostream>

#include "limber/common/data_folder.hpp"
#include "limber/planning/planner_factory.hpp"

int main(int argc, char** argv) try {
  if (argc < 4) {
    std::cerr << "03_plan_and_verify MODEL.safetensors ENVIRONMENT.yaml PLAN.json\n";
    return 2;
  }
  const auto arm = limber::load_arm(limber::data_folder() / "arms" / "three_segment.yaml");
  const auto environment = limber::load_environment(argv[2], arm);
  const auto result = limber::plan(arm, argv[1], environment);  // with room for the model's error
  if (!result.plan) {
    std::cout << "no plan: " << result.reason << "\n";
    return 1;
  }
  limber::write_plan(argv[3], *result.plan);

  // The planner has asked for it already; this is how you ask yourself, of a file from anywhere.
  const limber::CompensationModel network = limber::read_model(argv[1]);
  const limber::ValveParameters valves = network.valves.value_or(limber::ValveParameters{});
  const limber::Certificate certificate =
      limber::certify(limber::read_plan_unchecked(argv[3]), arm, &network, valves, environment);
  for (const limber::CertificateFailure& failure : certificate.failures) {
    std::cout << failure.check << ": " << failure.message << "\n";
  }
  std::cout << (certificate.certified() ? "certified" : "refused") << ": " << certificate.frames
            << " frames, " << certificate.cost_kpa << " kPa, clearance "
            << certificate.clearance_m * 100.0 << " cm\n";
  return certificate.certified() ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 2;
}

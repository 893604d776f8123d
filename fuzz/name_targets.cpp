#include "limber/common/error.hpp"
#include "limber/common/utf8.hpp"
#include "limber/planning/planner_factory.hpp"
#include "limber/run/jacobian_controller.hpp"
#include "limber/sim/disturbance.hpp"
#include "limber/sim/driver_server.hpp"
#include "limber/sim/related_arms.hpp"
#include "src/driver/child_process.hpp"
#include "target.hpp"

namespace limber::fuzz {

namespace {

// The command line and Python pass texts in UTF-8 alone.

void read_planner(const Input& input) {
  if (!is_utf8(input.bytes)) {
    return;
  }
  const std::string name(input.bytes);
  (void)make_planner(name, 1);
  (void)is_default_planner(name);
}

std::vector<std::string> planner_seeds() {
  std::vector<std::string> seeds = planner_names();
  seeds.emplace_back("default,improved_plans=0");
  return seeds;
}

template <class Read>
void refusing(Read&& read) {
  try {
    read();
  } catch (const InputError&) {
  }
}

/// The values of flags that have a grammar of their own.
void read_flag_values(const Input& input) {
  if (!is_utf8(input.bytes)) {
    return;
  }
  const std::string text(input.bytes);
  refusing([&] { (void)parse_jacobian(text); });
  refusing([&] { (void)parse_disturbances(text); });
  refusing([&] { (void)parse_physics_variation(text); });
  refusing([&] { (void)parse_server_fault(text); });
  (void)command_words(text);
}

}  // namespace

std::vector<Target> name_targets() {
  return {{"planner", "", read_planner, planner_seeds}, {"flag_values", "", read_flag_values}};
}

}  // namespace limber::fuzz

#include "run_flags.hpp"

#include <algorithm>

#include "limber/lab/trial_run.hpp"
#include "limber/sim/disturbance.hpp"

namespace limber {

namespace {

/// Without what is there twice: it would be the same row.
std::vector<std::string> once_each(const std::vector<std::string>& names) {
  std::vector<std::string> result;
  for (const std::string& name : names) {
    if (std::find(result.begin(), result.end(), name) == result.end()) {
      result.push_back(name);
    }
  }
  return result;
}

}  // namespace

void RunFlags::add_to(CLI::App& app) {
  app.add_flag("--replan", replan_,
               "Execute closed loop: plan again from where the arm is measured, while it moves and "
               "after; as --controller replan");
  app.add_option(
         "--controller", controllers_,
         "What executes the plans: " + controller_names() + "; may be repeated to compare them")
      ->expected(1)
      ->take_all();
  app.add_option("--disturbance", disturbances_,
                 "The virtual arm is not as the model knows it: none, " + disturbance_kinds() +
                     "; several at once with commas between; may be repeated to compare them")
      ->expected(1)
      ->take_all();
}

std::vector<std::string> RunFlags::controllers() const {
  std::vector<std::string> names = controllers_;
  if (replan_) {
    names.emplace_back("replan");
  }
  if (names.empty()) {
    names.emplace_back("open");
  }
  return once_each(names);
}

bool RunFlags::replans() const {
  const std::vector<std::string> names = controllers();
  return std::find(names.begin(), names.end(), "replan") != names.end();
}

std::vector<std::string> RunFlags::disturbances() const {
  std::vector<std::string> names;
  for (const std::string& name : disturbances_) {
    names.push_back(name == "none" ? "" : to_string(parse_disturbances(name)));
  }
  if (names.empty()) {
    names.emplace_back();
  }
  return once_each(names);
}

}  // namespace limber

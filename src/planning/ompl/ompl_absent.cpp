// In place of this folder's other sources if OMPL was not found.
#include "limber/common/error.hpp"
#include "limber/planning/ompl_planner.hpp"

namespace limber {

std::vector<std::string> ompl_planner_names() {
  return {};
}

std::unique_ptr<Planner> make_ompl_planner(const std::string& name) {
  throw InputError("planner '" + name +
                   "': this limber was built without OMPL: install libompl-dev and build again");
}

}  // namespace limber

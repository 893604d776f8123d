#include "bindings.hpp"
#include "limber/common/version.hpp"

// Classes before the functions that take them, so that docstrings name them as Python does.
PYBIND11_MODULE(_limber, module) {
  using namespace limber::python;
  module.doc() = "limber's C++ library; import limber instead.";
  module.attr("__version__") = limber::version();
  bind_errors(module);
  bind_random(module);
  bind_goals(module);
  bind_arm(module);
  bind_no_load_model(module);
  bind_characterisation(module);
  bind_inverse_kinematics(module);
  bind_valves(module);
  bind_recordings(module);
  bind_logs(module);
  bind_networks(module);
  bind_environments(module);
  bind_collision(module);
  bind_forward_model(module);
  bind_motion_model(module);
  bind_plans(module);
  bind_certificate(module);
  bind_planning(module);
  bind_virtual_arm(module);
  bind_process_driver(module);
  bind_collection(module);
  bind_execution(module);
  bind_training(module);
  bind_evaluation(module);
  bind_pictures(module);
  bind_json(module);
}

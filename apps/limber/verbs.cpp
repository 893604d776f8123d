#include "verbs.hpp"

namespace limber {

std::vector<std::unique_ptr<Verb>> all_verbs() {
  std::vector<std::unique_ptr<Verb>> verbs;
  verbs.push_back(make_demo_verb());
  verbs.push_back(make_characterize_verb());
  verbs.push_back(make_collect_verb());
  verbs.push_back(make_import_verb());
  verbs.push_back(make_inspect_verb());
  verbs.push_back(make_train_verb());
  verbs.push_back(make_family_verb());
  verbs.push_back(make_adapt_verb());
  verbs.push_back(make_evaluate_verb());
  verbs.push_back(make_calibrate_verb());
  verbs.push_back(make_bench_verb());
  verbs.push_back(make_environment_verb());
  verbs.push_back(make_plan_verb());
  verbs.push_back(make_verify_verb());
  verbs.push_back(make_execute_verb());
  verbs.push_back(make_experiment_verb());
  verbs.push_back(make_campaign_verb());
  verbs.push_back(make_improve_verb());
  verbs.push_back(make_export_verb());
  verbs.push_back(make_driver_verb());
  verbs.push_back(make_virtual_arm_verb());
  verbs.push_back(make_studio_verb());
  verbs.push_back(make_doctor_verb());
  return verbs;
}

}  // namespace limber

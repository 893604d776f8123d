#include "verbs.hpp"

namespace limber {

std::vector<std::unique_ptr<Verb>> all_verbs() {
  std::vector<std::unique_ptr<Verb>> verbs;
  for (const auto& make :
       {make_demo_verb,        make_characterize_verb, make_collect_verb, make_import_verb,
        make_inspect_verb,     make_train_verb,        make_family_verb,  make_adapt_verb,
        make_evaluate_verb,    make_calibrate_verb,    make_bench_verb,   make_environment_verb,
        make_plan_verb,        make_verify_verb,       make_execute_verb, make_experiment_verb,
        make_campaign_verb,    make_improve_verb,      make_export_verb,  make_driver_verb,
        make_virtual_arm_verb, make_studio_verb,       make_doctor_verb}) {
    verbs.push_back(make());
  }
  return verbs;
}

}  // namespace limber

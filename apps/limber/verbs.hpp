#pragma once

#include <memory>
#include <vector>

#include "verb.hpp"

namespace limber {

/// Every verb, in the order of `limber --help`; each is made in its own file, verb_<name>.cpp.
std::vector<std::unique_ptr<Verb>> all_verbs();

std::unique_ptr<Verb> make_adapt_verb();
std::unique_ptr<Verb> make_bench_verb();
std::unique_ptr<Verb> make_calibrate_verb();
std::unique_ptr<Verb> make_campaign_verb();
std::unique_ptr<Verb> make_collect_verb();
std::unique_ptr<Verb> make_demo_verb();
std::unique_ptr<Verb> make_studio_verb();
std::unique_ptr<Verb> make_doctor_verb();
std::unique_ptr<Verb> make_evaluate_verb();
std::unique_ptr<Verb> make_family_verb();
std::unique_ptr<Verb> make_train_verb();
std::unique_ptr<Verb> make_environment_verb();
std::unique_ptr<Verb> make_plan_verb();
std::unique_ptr<Verb> make_execute_verb();
std::unique_ptr<Verb> make_experiment_verb();
std::unique_ptr<Verb> make_verify_verb();
std::unique_ptr<Verb> make_improve_verb();
std::unique_ptr<Verb> make_export_verb();
std::unique_ptr<Verb> make_import_verb();
std::unique_ptr<Verb> make_inspect_verb();
std::unique_ptr<Verb> make_characterize_verb();
std::unique_ptr<Verb> make_driver_verb();
std::unique_ptr<Verb> make_virtual_arm_verb();

}  // namespace limber

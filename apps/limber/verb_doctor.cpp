#include <thread>

#include <Eigen/Core>

#include "limber/common/version.hpp"
#include "verbs.hpp"

namespace limber {

namespace {

class DoctorVerb final : public Verb {
 public:
  const char* name() const override { return "doctor"; }
  const char* summary() const override {
    return "Versions, CPU features, and which optional parts are present";
  }
  const char* example() const override { return "limber doctor --json"; }
  void add_flags(CLI::App&) override {}

  int run(const CommonFlags& flags) override {
    nlohmann::ordered_json result;
    result["limber"] = version();
    result["compiler"] = __VERSION__;
    result["threads"] = std::thread::hardware_concurrency();
    result["eigen"] =
        fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
    std::string text;
    for (const auto& [key, value] : result.items()) {
      text += fmt::format("{:<10} {}\n", key,
                          value.is_string() ? value.get<std::string>() : value.dump());
    }
    print_result(flags, result, text);
    return kExitDone;
  }
};

}  // namespace

std::unique_ptr<Verb> make_doctor_verb() {
  return std::make_unique<DoctorVerb>();
}

}  // namespace limber

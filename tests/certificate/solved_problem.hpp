#pragma once

#include <string>
#include <vector>

#include "limber/certificate/certificate.hpp"
#include "limber/planning/planner.hpp"
#include "limber/planning/planner_factory.hpp"
#include "planning/play_model.hpp"

namespace limber {

/// A solved problem with a heading asked for, so that every check has work.
struct Solved {
  ArmDescription arm = three_segment_arm();
  bool has_network;
  ForwardModel model;
  Environment environment;
  Plan plan;

  explicit Solved(bool with_network)
      : has_network(with_network),
        model(with_network ? ForwardModel(arm, play_network(arm, 0.01F)) : ForwardModel(arm)) {
    environment.name = "pillars";
    environment.obstacles = {Circle{0.45, 0.22, 0.025}, Rectangle{0.6, -0.1, 0.04, 0.1, 0.3},
                             Polygon{{{0.1, 0.3}, {0.2, 0.3}, {0.15, 0.4}}}};
    environment.goal = {0.30, 0.40, 2.4, 0.02, 0.8};
    PlannerLimits limits;
    limits.iterations = 1500;
    PlanResult result = make_planner("default")->plan({arm, model, environment}, limits, 3);
    if (result.plan) {
      plan = *result.plan;
    }
  }

  Certificate certificate(const Plan& p) const {
    return certify(p, arm, has_network ? &model.compensation() : nullptr, {}, environment);
  }
};

inline const Solved& solved(bool with_network = true) {
  static const Solved network(true);
  static const Solved no_load(false);
  return with_network ? network : no_load;
}

inline std::vector<std::string> failed_checks(const Certificate& certificate) {
  std::vector<std::string> checks;
  for (const CertificateFailure& failure : certificate.failures) {
    checks.push_back(failure.check);
  }
  return checks;
}

}  // namespace limber

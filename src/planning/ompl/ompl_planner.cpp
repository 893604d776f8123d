#include "limber/planning/ompl_planner.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/planners/est/EST.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/control/planners/pdst/PDST.h>
#include <ompl/control/planners/rrt/RRT.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/control/spaces/RealVectorControlSpace.h>
#include <ompl/util/Console.h>

#include "arm_space.hpp"
#include "limber/common/error.hpp"
#include "limber/common/number_text.hpp"
#include "limber/common/refuse_if.hpp"
#include "limber/planning/problem_check.hpp"
#include "limber/world/inverse_kinematics.hpp"
#include "plan_ladder.hpp"
#include "planner_name.hpp"

namespace limber {

namespace {

/// OMPL's SST with its nodes counted, and with its best motion for whoever looks while it searches.
class CountedSst : public ompl::control::SST {
 public:
  using SST::SST;
  /// Nodes may still be extended or are inactive: dominated, kept because they have children. In a
  /// sparse tree there are at least as many witnesses as active nodes.
  void note_counts(PlanResult& result) const {
    std::vector<Motion*> motions;
    if (nn_) {
      nn_->list(motions);
    }
    const auto inactive = std::ranges::count_if(motions, &Motion::inactive_);
    result.statistics.nodes = motions.size();
    result.warnings.push_back(fmt::format("SST: {} active nodes, {} inactive, {} witnesses",
                                          std::ssize(motions) - inactive, inactive,
                                          witnesses_ ? witnesses_->size() : 0));
  }

  /// Cost of the best motion to the goal so far, if there is one.
  std::optional<double> solution_cost() const {
    const double cost = prevSolutionCost_.value();
    return prevSolution_.empty() || std::isinf(cost) ? std::nullopt : std::optional(cost);
  }

  /// That motion; before there is one, the motion that ended nearest. @pre a motion was kept
  ompl::control::PathControl kept_path() const {
    ompl::control::PathControl path(si_);
    for (std::size_t i = prevSolution_.size(); i-- > 1;) {
      path.append(prevSolution_[i], prevSolutionControls_[i - 1],
                  prevSolutionSteps_[i - 1] * siC_->getPropagationStepSize());
    }
    path.append(prevSolution_.front());
    return path;
  }
};

namespace ob = ompl::base;
namespace oc = ompl::control;

constexpr std::uint64_t kStream = 0x6f6d706c;  // apart from other planners' draws
constexpr int kGoalConfigurations = 50;
constexpr double kSecondsToFreeAState = 1e-6;  // including what belongs to it

using Parameters = std::map<std::string, std::string>;

/// OMPL seeds every generator from one sequence per process, in the order in which they are made.
/// That of a planner is seeded here, and limber's samplers draw from ArmWorld::random. What is left
/// is that of the nearest neighbours, which are exact whatever it draws.
template <class OmplPlanner>
class Seeded final : public OmplPlanner {
 public:
  Seeded(const oc::SpaceInformationPtr& si, std::uint64_t seed) : OmplPlanner(si) {
    this->rng_.setLocalSeed(seed);
  }
};

template <class OmplPlanner>
ob::PlannerPtr make(const oc::SpaceInformationPtr& si, std::uint64_t seed) {
  return std::make_shared<Seeded<OmplPlanner>>(si, seed);
}

const std::map<std::string, ob::PlannerPtr (*)(const oc::SpaceInformationPtr&, std::uint64_t)>
    kPlanners{{"ompl:RRT", make<oc::RRT>},
              {"ompl:SST", make<CountedSst>},
              {"ompl:KPIECE1", make<oc::KPIECE1>},
              {"ompl:EST", make<oc::EST>},
              {"ompl:PDST", make<oc::PDST>}};

OmplSettings take_settings(PlannerName& name) {
  OmplSettings settings;
  settings.frames = name.take_whole("frames", 1, 100, settings.frames);
  settings.tip_weight = name.take("tip_weight", 0, 100, settings.tip_weight);
  settings.directed = name.take_whole("directed", 0, 1, 1) != 0;
  return settings;
}

/// OMPL only suggests its ranges, "low:high", "low:step:high" or "0,1", and takes any number.
void require_suggested(const ob::GenericParam& parameter, const std::string& value) {
  const std::string& range = parameter.getRangeSuggestion();
  const std::optional<double> low = number_in(range.substr(0, range.find_first_of(":,")));
  const std::optional<double> high = number_in(range.substr(range.find_last_of(":,") + 1));
  (void)setting_number(parameter.getName(), value, low.value_or(0.0),
                       high.value_or(std::numeric_limits<double>::max()));
}

void require_limits(const PlannerLimits& limits) {
  refuse_if(limits.iterations || limits.memory_mb,
            "OMPL's planners count neither iterations nor memory: limit time or queries");
  refuse_if(!limits.time_s && !limits.queries,
            "no limit is set: give a time or a number of queries");
}

/// One plan: OMPL's planner on limber's space, and what it found as limber's result.
class OmplRun {
 public:
  OmplRun(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
          const PlannerCallback& callback, const OmplSettings& settings)
      : problem_(problem),
        limits_(limits),
        seed_(seed),
        budget_(limits, callback),
        checker_(checker_of(problem)),
        simulator_(problem.arm, problem.model, checker_),
        world_{problem, checker_, simulator_, settings, RandomStream(seed, kStream)} {}

  /// @param text  the planner's name in plans, settings included
  PlanResult run(const std::string& name, const Parameters& parameters, const std::string& text) {
    if (is_refused(problem_, checker_, result_)) {
      return std::move(result_);
    }
    find_goal_configurations();
    const oc::SpaceInformationPtr si = make_space_information(world_);
    ob::PlannerPtr planner = kPlanners.at(name)(si, seed_);
    for (const auto& [key, value] : parameters) {
      if (planner->params().hasParam(key)) {
        require_suggested(planner->params()[key], value);
      }
    }
    if (!planner->params().setParams(parameters, false)) {
      refuse_parameters(*planner, parameters);
    }
    const auto definition = define_problem(si);
    planner->setProblemDefinition(definition);
    planner->setup();
    ladder_.emplace(problem_, simulator_, budget_, text, seed_);
    sst_ = dynamic_cast<const CountedSst*>(planner.get());
    planner->solve(ob::PlannerTerminationCondition([this] { return spent(); }));
    offer_improvement();
    // About: a few are no nodes. OMPL's own data of a large tree take longer than may be spent.
    result_.statistics.nodes = world_.states;
    if (sst_ != nullptr) {
      sst_->note_counts(result_);
      sst_ = nullptr;
    }
    planner.reset();  // takes its time, which is the plan's
    finish(*definition);
    return std::move(result_);
  }

 private:
  void find_goal_configurations() {
    InverseKinematicsSettings settings;
    settings.starts = 4 * kGoalConfigurations;
    settings.max_solutions = kGoalConfigurations;
    settings.limits = problem_.limits;
    const InverseKinematicsResult found = solve_inverse_kinematics(
        problem_.model.no_load(), problem_.environment.goal, settings, world_.random);
    for (const Eigen::VectorXd& kpa : found.pressures_kpa) {
      world_.goal_configurations.push_back(kpa.cast<float>());
    }
    if (world_.goal_configurations.empty()) {
      world_.goal_configurations.push_back(found.best_pressures_kpa.cast<float>());
    }
  }

  [[noreturn]] static void refuse_parameters(ob::Planner& planner, const Parameters& parameters) {
    std::vector<std::string> known;
    planner.params().getParamNames(known);
    std::vector<std::string> given;
    for (const auto& [key, value] : parameters) {
      given.push_back(key + "=" + value);
    }
    throw InputError(fmt::format(
        "planner settings {} are not all known to OMPL's {}; expected frames, tip_weight, "
        "directed, {}",
        fmt::join(given, ", "), planner.getName(), fmt::join(known, ", ")));
  }

  ob::ProblemDefinitionPtr define_problem(const oc::SpaceInformationPtr& si) {
    auto definition = std::make_shared<ob::ProblemDefinition>(si);
    ob::ScopedState<> state(si);
    world_.write(start_of(problem_), 0.0, true, state.get());
    definition->addStartState(state);
    definition->setGoal(make_arm_goal(world_, si));
    // RRT and the others stop at the first solution whatever it costs; SST at one this cheap.
    definition->setOptimizationObjective(
        make_pressure_objective(world_, si, limits_.cost_threshold_kpa.value_or(0.0)));
    return definition;
  }

  bool spent() {
    offer_improvement();
    budget_.keep_for_the_end(kSecondsToFreeAState * double(world_.states) + judging_s_);
    const std::optional<double> best_kpa = ladder_->best_cost_kpa();
    return budget_.spent({budget_.elapsed_s(), 0, world_.states, simulator_.queries(), best_kpa,
                          [] { return std::vector<TreeEdge>(); }},
                         0.0);
  }

  /// SST goes on after a first plan: each better one is offered while it searches. The others end
  /// with their first plan.
  void offer_improvement() {
    const std::optional<double> cost = sst_ != nullptr ? sst_->solution_cost() : std::nullopt;
    if (!cost || *cost >= offered_cost_) {
      return;
    }
    offered_cost_ = *cost;
    oc::PathControl path = sst_->kept_path();
    offer(waypoints(path));
  }

  void offer(const std::vector<Pressures>& kpa) {
    const double begin_s = budget_.elapsed_s();
    (void)ladder_->offer(kpa, path_cost_kpa(kpa), simulator_.queries());
    judging_s_ = std::max(judging_s_, budget_.elapsed_s() - begin_s);
  }

  /// Set points of every frame of OMPL's path, by the rule that it was propagated by.
  std::vector<Pressures> waypoints(oc::PathControl& path) const {
    std::vector<Pressures> kpa{world_.setpoint_kpa(path.getState(0))};
    for (std::size_t i = 0; i < path.getControlCount(); ++i) {
      const auto index = static_cast<unsigned>(i);
      const auto frames = std::lround(path.getControlDuration(index) * problem_.arm.frame_rate_hz);
      const double* change =
          path.getControl(index)->as<oc::RealVectorControlSpace::ControlType>()->values;
      for (long k = 0; k < frames; ++k) {
        kpa.push_back(world_.next_setpoint(kpa.back(), change));
      }
    }
    return kpa;
  }

  void finish(const ob::ProblemDefinition& definition) {
    const std::vector<std::string> counts = std::move(result_.warnings);
    const ob::PathPtr path = definition.getSolutionPath();
    const std::vector<Pressures> kpa =
        path ? waypoints(static_cast<oc::PathControl&>(*path))
             : std::vector<Pressures>{start_of(problem_).setpoint_kpa()};
    const bool was_offered = std::isfinite(offered_cost_);
    if (path && !definition.hasApproximateSolution() && !was_offered) {
      offer(kpa);
    }
    ladder_->finish(simulator_.queries(), kpa, result_);
    result_.warnings.insert(result_.warnings.end(), counts.begin(), counts.end());
    result_.statistics.queries = simulator_.queries();
    result_.statistics.time_s = budget_.elapsed_s();
    if (result_.plan) {
      note_first_solution();
    }
  }

  void note_first_solution() {
    const FirstSolution& first = *result_.first_solution;
    result_.events = {{first.time_s, 0, 0, first.queries, first.cost_kpa},
                      {result_.statistics.time_s, 0, result_.statistics.nodes,
                       result_.statistics.queries, result_.plan->cost_kpa}};
  }

  const PlanningProblem& problem_;
  PlannerLimits limits_;
  std::uint64_t seed_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator simulator_;
  ArmWorld world_;
  std::optional<PlanLadder> ladder_;
  const CountedSst* sst_ = nullptr;  // while it searches, where it is one
  double offered_cost_ = std::numeric_limits<double>::infinity();
  double judging_s_ = 0.0;  // that a plan took at most
  PlanResult result_;
};

class OmplPlanner final : public Planner {
 public:
  explicit OmplPlanner(const std::string& text) : text_(text) {
    PlannerName parsed = PlannerName::parse(text);
    name_ = parsed.name;
    if (kPlanners.count(name_) == 0) {
      throw InputError(fmt::format("planner '{}'; the planners of OMPL are {}", name_,
                                   fmt::join(ompl_planner_names(), ", ")));
    }
    settings_ = take_settings(parsed);
    parameters_ = std::move(parsed.settings);
  }

  const char* name() const override { return text_.c_str(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    require_limits(limits);
    static std::once_flag quiet;
    std::call_once(quiet, [] { ompl::msg::noOutputHandler(); });
    return OmplRun(problem, limits, seed, callback, settings_).run(name_, parameters_, text_);
  }

 private:
  std::string text_;
  std::string name_;
  Parameters parameters_;
  OmplSettings settings_;
};

}  // namespace

std::vector<std::string> ompl_planner_names() {
  std::vector<std::string> names;
  for (const auto& [name, make] : kPlanners) {
    names.push_back(name);
  }
  return names;
}

std::unique_ptr<Planner> make_ompl_planner(const std::string& name) {
  return std::make_unique<OmplPlanner>(name);
}

}  // namespace limber

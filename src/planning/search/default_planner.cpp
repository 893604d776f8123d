#include "default_planner.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "batch_search.hpp"
#include "forest/forest_search.hpp"
#include "path_simulator.hpp"
#include "plan_improver.hpp"
#include "plan_ladder.hpp"
#include "planner_budget.hpp"
#include "second_opinions.hpp"

namespace limber {

namespace {

using Solutions = std::vector<BatchSearch::Solution>;

/// One search: its parts, and what they pass to each other. Who has which turn says TurnTaking.
class DefaultRun {
 public:
  DefaultRun(const PlanningProblem& problem, const CollisionChecker& checker,
             const DefaultPlannerSettings& settings, const char* planner, std::uint64_t seed,
             PlannerBudget& budget)
      : problem_(problem),
        settings_(settings),
        budget_(budget),
        single_(problem.arm, problem.model, checker),
        opinions_(problem, checker),
        paths_(problem, checker, {settings.hold_position_m, settings.hold_orientation_rad},
               settings.jobs),
        restarts_(settings.restart_queries),
        team_(problem, opinions_, settings.improved_plans, seed),
        ladder_(problem, single_, budget, planner, seed),
        seed_(seed) {
    search_.emplace(problem, paths_, settings, seed);
    if (settings.forest != nullptr) {
      forest_.emplace(*settings.forest, problem, checker, paths_, *search_);
    }
  }

  /// Until a limit is spent, the plan is good enough, or there is nothing left to try.
  PlanResult run() {
    start_in_goal();
    while (!nothing_left() && !budget_.good_enough(ladder_.best_cost_kpa()) &&
           !budget_.spent(progress(), search_->bytes())) {
      if (!has_plan() && !forest_ && restarts_.is_due(paths_.queries())) {
        search_again();
      }
      take_turn();
    }
    return result();
  }

 private:
  std::function<bool()> give_up() const {
    return [this] { return budget_.out_of_time(); };
  }

  bool has_plan() const { return ladder_.best_cost_kpa().has_value(); }

  PlannerProgress progress() const {
    return {budget_.elapsed_s(),
            search_->proposals(),
            std::uint64_t(search_->tree().size()),
            paths_.queries(),
            ladder_.best_cost_kpa(),
            [this] { return tree_edges(search_->tree()); }};
  }

  /// Whether no plan can be better, nobody has anything to try, or improving has had its queries.
  bool nothing_left() const {
    return (has_plan() && *ladder_.best_merit_kpa() <= 0.0) || turns_.is_idle() ||
           turns_.since_plan(has_plan(), paths_.queries()) >=
               (problem_.goal_has_room ? settings_.improvement_queries
                                       : settings_.improvement_queries_without_room);
  }

  /// An arm that need not move, by all opinions, has the cheapest plan of all.
  void start_in_goal() {
    const MotionState start = start_of(problem_);
    const Pressures setpoint_kpa = start.setpoint_kpa();
    const PathOutcome stays = paths_.run({{start, {setpoint_kpa}}}, give_up()).front();
    if (stays.in_goal && opinions_.agree({setpoint_kpa})) {
      (void)note_plan({setpoint_kpa}, GoalAim(problem_).merit_kpa(0.0, *stays.held_tip));
    }
  }

  /// That edges are measured by; none while standing still, beyond the aim, is the best plan: every
  /// motion costs more.
  std::optional<double> cost_to_beat_kpa() const {
    const std::optional<double> cost_kpa = ladder_.best_cost_kpa();
    return cost_kpa && *cost_kpa > 0.0 ? cost_kpa : std::nullopt;
  }

  /// Whether it may be built upon.
  bool note_plan(const Waypoints& waypoints_kpa, double merit_kpa) {
    const bool stands = ladder_.offer(waypoints_kpa, merit_kpa, paths_.queries());
    budget_.note(progress());
    return stands;
  }

  /// From the start, with the random numbers that follow.
  void search_again() {
    keep_nearest();
    const std::uint64_t proposals = search_->proposals();
    search_.emplace(problem_, paths_, settings_, seed_, proposals);
    team_.forget_waiting();
    restarts_.begin(paths_.queries());
  }

  /// The motion that comes nearest to the goal, of all searches so far.
  void keep_nearest() {
    if (nearest_kpa_.empty() || search_->nearest_error() < nearest_error_) {
      nearest_error_ = search_->nearest_error();
      nearest_kpa_ = search_->waypoints_to(search_->nearest_node());
    }
  }

  /// The forest and the search in turns, as long as there is something in it; then whoever is
  /// behind with its share of the queries.
  void take_turn() {
    const std::uint64_t before = paths_.queries();
    if (forest_) {
      const ForestSearch::Round round = forest_->round(give_up(), has_plan());
      if (!round.more) {
        forest_.reset();
      }
      take_in(round.found, before);
      if (has_plan() || budget_.out_of_time()) {
        return;
      }
    }
    if (turns_.next(has_plan(), paths_.queries()) == TurnTaking::Turn::search || !improve()) {
      const std::uint64_t before_search = paths_.queries();
      take_in(search_->round(cost_to_beat_kpa(), give_up()), before_search);
    }
    turns_.note_turn(before, paths_.queries());
  }

  bool improve() {
    return team_.round(*search_, paths_, ladder_, std::bind_front(&DefaultRun::note_plan, this),
                       give_up());
  }

  /// What a turn has found that began at `before` queries of the model.
  void take_in(Solutions found, std::uint64_t before) {
    const GoalAim aim(problem_);
    const auto merit_kpa = [&](const BatchSearch::Solution& one) {
      return aim.merit_kpa(one.cost_kpa, one.held_tip);
    };
    std::ranges::stable_sort(found, {}, merit_kpa);
    for (const BatchSearch::Solution& one : found) {
      if (may_be_built_upon(one, merit_kpa(one))) {
        team_.add(one);
      }
    }
    turns_.note_search(has_plan(), before, paths_.queries());
  }

  /// Notes it as a plan where it is the best so far.
  bool may_be_built_upon(const BatchSearch::Solution& one, double merit_kpa) {
    const bool is_best = !has_plan() || merit_kpa < *ladder_.best_merit_kpa();
    if (!is_best && opinions_.empty()) {
      return true;
    }
    const Waypoints waypoints_kpa = search_->waypoints_to(one.node);
    return opinions_.agree(waypoints_kpa) && (!is_best || note_plan(waypoints_kpa, merit_kpa));
  }

  PlanResult result() {
    PlanResult result;
    const PlannerProgress end = progress();
    keep_nearest();
    result.statistics.iterations = end.iterations;
    result.statistics.nodes = end.nodes;
    ladder_.finish(paths_.queries(), nearest_kpa_, result);
    result.statistics.queries = paths_.queries() + single_.queries() + opinions_.queries();
    close_search(budget_, search_->tree(), end, result);
    return result;
  }

  const PlanningProblem& problem_;
  const DefaultPlannerSettings& settings_;
  PlannerBudget& budget_;
  MotionSimulator single_;
  SecondOpinions opinions_;
  PathSimulator paths_;
  Restarts restarts_;
  std::optional<BatchSearch> search_;   // the present one
  std::optional<ForestSearch> forest_;  // until there is nothing more in it
  ImproverTeam team_;
  PlanLadder ladder_;
  TurnTaking turns_;
  std::uint64_t seed_;
  double nearest_error_ = 0.0;  // of nearest_kpa_, in the goal's tolerances
  Waypoints nearest_kpa_;       // empty: no search has ended yet
};

class DefaultPlanner final : public Planner {
 public:
  DefaultPlanner(const DefaultPlannerSettings& settings, std::string name)
      : settings_(settings), name_(std::move(name)) {
    require_valid(settings);
  }

  const char* name() const override { return name_.c_str(); }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    PlannerBudget budget(limits, callback);
    const CollisionChecker checker = checker_of(problem);
    PlanResult refused;
    if (is_refused(problem, checker, refused)) {
      return refused;
    }
    if (settings_.forest != nullptr) {
      require_forest_of(*settings_.forest, problem.arm, problem.model.valves().parameters(),
                        start_state(problem.environment, problem.arm));
    }
    return DefaultRun(problem, checker, settings_, name(), seed, budget).run();
  }

 private:
  DefaultPlannerSettings settings_;
  std::string name_;
};

}  // namespace

std::unique_ptr<Planner> make_default_planner(const DefaultPlannerSettings& settings,
                                              std::string name) {
  return std::make_unique<DefaultPlanner>(settings, std::move(name));
}

}  // namespace limber

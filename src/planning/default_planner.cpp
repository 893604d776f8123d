#include "limber/planning/default_planner.hpp"

#include <algorithm>

#include "batch_search.hpp"
#include "limber/planning/problem_check.hpp"
#include "path_simulator.hpp"
#include "plan_improver.hpp"
#include "plan_result.hpp"
#include "planner_budget.hpp"
#include "setting_check.hpp"

namespace limber {

namespace {

// Shares of the model's queries, once there is a plan.
constexpr double kSearchShare = 0.2;
constexpr double kChampionShare = 0.4;
constexpr double kChallengerShare = 0.4;
constexpr int kChallengerPatience = 12;  // rounds without success until a challenger has lost

/// One run: the tree; the champion, the best plan so far; and a challenger, another plan from the
/// tree that is improved until it is cheaper or gets no cheaper.
class Run {
 public:
  Run(const PlanningProblem& problem, const PlannerLimits& limits, const PlannerCallback& callback,
      const DefaultPlannerSettings& settings, std::uint64_t seed)
      : problem_(problem),
        budget_(limits, callback),
        checker_(problem.arm, problem.environment.obstacles, problem.margin_m),
        single_(problem.arm, problem.model, checker_),
        paths_(problem, checker_, {settings.hold_position_m, settings.hold_orientation_rad},
               settings.jobs),
        search_(problem, paths_, settings, seed),
        champion_(problem, paths_, seed, 0),
        challenger_(problem, paths_, seed, 1),
        seed_(seed) {}

  PlanResult run(const char* planner) {
    ProblemCheck check = check_problem(problem_, checker_, seed_);
    result_.warnings = std::move(check.warnings);
    if (check.refusal) {
      result_.status = *check.refusal;
      result_.reason = std::move(check.reason);
      return std::move(result_);
    }
    start_in_goal();
    while (!budget_.good_enough(best_cost_kpa()) && !budget_.spent(progress(), search_.bytes())) {
      take_turn();
    }
    finish(planner);
    return std::move(result_);
  }

 private:
  std::function<bool()> give_up() {
    return [this] { return budget_.out_of_time(); };
  }

  std::optional<double> best_cost_kpa() const {
    return champion_.has_plan() ? std::optional(champion_.cost_kpa()) : std::nullopt;
  }

  PlannerProgress progress() const {
    return {budget_.elapsed_s(), search_.edges(), static_cast<std::uint64_t>(search_.tree().size()),
            paths_.queries(), best_cost_kpa()};
  }

  /// An arm that need not move has the cheapest plan of all.
  void start_in_goal() {
    const Pressures start = start_state(problem_.environment, problem_.arm).pressures_kpa;
    std::vector<Path> standing{
        {start, start_state(problem_.environment, problem_.arm).backbone, {start}}};
    std::vector<PathOutcome> outcome;
    paths_.run(standing, outcome, give_up());
    if (outcome.front().in_goal && champion_.adopt({start}, give_up())) {
      note_first_solution();
    }
  }

  void note_first_solution() {
    if (!result_.first_solution && champion_.has_plan()) {
      result_.first_solution =
          FirstSolution{budget_.elapsed_s(), champion_.cost_kpa(), paths_.queries()};
    }
  }

  /// Runs whoever is farthest behind with its share of the queries.
  void take_turn() {
    const std::uint64_t before = paths_.queries();
    if (!champion_.has_plan()) {
      search();
      return;
    }
    double* const spent[] = {&search_spent_, &champion_spent_, &challenger_spent_};
    const int turn = static_cast<int>(
        std::min_element(std::begin(spent), std::end(spent),
                         [](const double* a, const double* b) { return *a < *b; }) -
        std::begin(spent));
    if (turn == 0) {
      search();
    } else if (turn == 1) {
      champion_.round(give_up());
    } else {
      challenge();
    }
    constexpr double kShares[] = {kSearchShare, kChampionShare, kChallengerShare};
    // At least one query a turn: whoever has nothing to do must not be asked for ever.
    *spent[turn] += double(std::max<std::uint64_t>(paths_.queries() - before, 1)) / kShares[turn];
  }

  void search() {
    search_.round(best_cost_kpa(), give_up());
    const auto& solutions = search_.solutions();
    for (; seen_ < solutions.size(); ++seen_) {
      const BatchSearch::Solution& found = solutions[seen_];
      if (!champion_.has_plan() || found.cost_kpa < champion_.cost_kpa()) {
        if (champion_.adopt(search_.waypoints_to(found.node), give_up())) {
          note_first_solution();
        }
      } else {
        waiting_.push_back(found);
      }
    }
  }

  void challenge() {
    if (!challenger_.has_plan()) {
      call_challenger();
      return;
    }
    challenger_.round(give_up());
    if (challenger_.cost_kpa() < champion_.cost_kpa()) {
      champion_.swap_plans(challenger_);
      challenger_.drop_plan();
    } else if (challenger_.fruitless_rounds() > kChallengerPatience) {
      challenger_.drop_plan();
    }
  }

  /// The cheapest of the tree's plans that have not had their turn.
  void call_challenger() {
    if (waiting_.empty()) {
      return;
    }
    const auto cheapest =
        std::min_element(waiting_.begin(), waiting_.end(),
                         [](const BatchSearch::Solution& a, const BatchSearch::Solution& b) {
                           return a.cost_kpa < b.cost_kpa;
                         });
    const int node = cheapest->node;
    waiting_.erase(cheapest);
    if (!challenger_.adopt(search_.waypoints_to(node), give_up())) {
      challenger_.drop_plan();
    }
  }

  void finish(const char* planner) {
    result_.statistics.iterations = search_.edges();
    result_.statistics.nodes = static_cast<std::uint64_t>(search_.tree().size());
    result_.statistics.goal_nodes = search_.solutions().size();
    finish_search(problem_, single_, budget_,
                  champion_.has_plan() ? champion_.waypoints_kpa()
                                       : search_.waypoints_to(search_.nearest_node()),
                  champion_.has_plan(), planner, seed_, result_);
    result_.statistics.queries = paths_.queries() + single_.queries();
    result_.tree = tree_edges(search_.tree());
    result_.statistics.time_s = budget_.elapsed_s();
  }

  const PlanningProblem& problem_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator single_;
  PathSimulator paths_;
  BatchSearch search_;
  PlanImprover champion_;
  PlanImprover challenger_;
  std::uint64_t seed_;
  std::size_t seen_ = 0;  // of the search's solutions
  std::vector<BatchSearch::Solution> waiting_;
  double search_spent_ = 0.0;
  double champion_spent_ = 0.0;
  double challenger_spent_ = 0.0;
  PlanResult result_;
};

void require_valid(const DefaultPlannerSettings& s) {
  require_between("step_size", s.step_size, 1e-3, 10.0);
  require_between("goal_shots", s.goal_shots, 0.0, 1.0);
  require_between("shot_spread", s.shot_spread, 0.0, 10.0);
  require_between("goal_bias", s.goal_bias, 0.0, 1.0);
  require_between("goal_bias + goal_shots", s.goal_bias + s.goal_shots, 0.0, 1.0);
  require_between("goal_spread", s.goal_spread, 0.0, 10.0);
  require_between("goal_configurations", s.goal_configurations, 1, 1e6);
  require_between("random_parent", s.random_parent, 0.0, 1.0);
  require_between("cell_pressure", s.cell_pressure, 1e-4, 2.0);
  require_between("cell_position_m", s.cell_position_m, 1e-5, 10.0);
  require_between("cell_orientation_rad", s.cell_orientation_rad, 1e-4, 10.0);
  require_between("dearest", s.dearest, 1.0, 1e6);
  require_between("hold_position_m", s.hold_position_m, 0.0, 10.0);
  require_between("hold_orientation_rad", s.hold_orientation_rad, 0.0, 10.0);
  require_between("jobs", s.jobs, 0, 1024);
}

class DefaultPlanner final : public Planner {
 public:
  explicit DefaultPlanner(const DefaultPlannerSettings& settings) : settings_(settings) {
    require_valid(settings);
  }

  const char* name() const override { return "default"; }

  PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits, std::uint64_t seed,
                  const PlannerCallback& callback) override {
    return Run(problem, limits, callback, settings_, seed).run(name());
  }

 private:
  DefaultPlannerSettings settings_;
};

}  // namespace

std::unique_ptr<Planner> make_default_planner(const DefaultPlannerSettings& settings) {
  return std::make_unique<DefaultPlanner>(settings);
}

}  // namespace limber

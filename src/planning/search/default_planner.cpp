#include "default_planner.hpp"

#include <algorithm>

#include "batch_search.hpp"
#include "default_settings.hpp"
#include "forest/forest_search.hpp"
#include "path_simulator.hpp"
#include "plan_improver.hpp"
#include "plan_ladder.hpp"
#include "plan_result.hpp"
#include "planner_budget.hpp"
#include "second_opinions.hpp"

namespace limber {

namespace {

constexpr double kSearchShare = 0.2;  // of the model's queries, once there is a plan
constexpr int kPatience = 15;  // rounds without success until a plan that is not the best goes
constexpr int kMaxIdleTurns = 10'000;
constexpr std::uint64_t kChoiceStream = std::uint64_t{1} << 60;

/// One run: the tree, and some of the plans it has found, which are improved side by side. One that
/// gets no cheaper, and is not the best, is replaced by another from the tree.
class Run {
 public:
  Run(const PlanningProblem& problem, const PlannerLimits& limits, const PlannerCallback& callback,
      const DefaultPlannerSettings& settings, const char* planner, std::uint64_t seed)
      : problem_(problem),
        settings_(settings),
        budget_(limits, callback),
        checker_(problem.arm, problem.environment.obstacles, problem.margin_m),
        single_(problem.arm, problem.model, checker_),
        aim_(problem),
        opinions_(problem, checker_),
        paths_(problem, checker_, {settings.hold_position_m, settings.hold_orientation_rad},
               settings.jobs),
        search_(problem, paths_, settings, seed),
        ladder_(problem, single_, budget_, planner, seed),
        choice_(seed, kChoiceStream),
        planner_(planner),
        seed_(seed) {
    for (int i = 0; i < settings.improved_plans; ++i) {
      improvers_.emplace_back(problem, opinions_, seed, static_cast<std::uint64_t>(i));
    }
  }

  PlanResult run(const Forest* forest) {
    if (is_refused(problem_, checker_, result_)) {
      return std::move(result_);
    }
    if (forest != nullptr) {
      require_forest_of(*forest, problem_.arm, problem_.model.valves().parameters(),
                        start_state(problem_.environment, problem_.arm));
      forest_.emplace(*forest, problem_, checker_, paths_, search_);
    }
    start_in_goal();
    while (!nothing_left() && !budget_.good_enough(best_cost_kpa()) &&
           !budget_.spent(progress(), search_.bytes())) {
      take_turn();
    }
    finish();
    return std::move(result_);
  }

 private:
  std::function<bool()> give_up() {
    return [this] { return budget_.out_of_time(); };
  }

  std::optional<double> best_cost_kpa() const { return ladder_.best_cost_kpa(); }
  bool has_plan() const { return best_cost_kpa().has_value(); }

  PlannerProgress progress() const {
    return {budget_.elapsed_s(), search_.proposals(),
            static_cast<std::uint64_t>(search_.tree().size()), paths_.queries(), best_cost_kpa()};
  }

  /// Whether no plan can be cheaper, or nothing is left to try: a limit of queries alone would
  /// never be reached.
  bool nothing_left() const {
    return (has_plan() && *best_cost_kpa() <= 0.0) || idle_turns_ > kMaxIdleTurns ||
           improvement_queries() >= (problem_.goal_has_room
                                         ? settings_.improvement_queries
                                         : settings_.improvement_queries_without_room);
  }

  /// Since there is a plan.
  double improvement_queries() const {
    return has_plan() ? double(paths_.queries() - before_plan_) : 0.0;
  }

  /// An arm that need not move has the cheapest plan of all.
  void start_in_goal() {
    const MotionState start = start_of(problem_);
    batch_.assign(1, {start, {start.setpoint_kpa()}});
    paths_.run(batch_, outcomes_, give_up());
    if (outcomes_.front().in_goal) {
      (void)note_plan({start.setpoint_kpa()}, 0.0);
    }
  }

  /// Whether it may be built upon.
  bool note_plan(const std::vector<Pressures>& waypoints_kpa, double merit_kpa) {
    const bool stands = ladder_.offer(waypoints_kpa, merit_kpa, paths_.queries());
    budget_.note(progress());
    return stands;
  }

  /// The forest and the search in turns, as long as there is something in it; then whoever is
  /// behind with its share of the queries.
  void take_turn() {
    const std::uint64_t before = paths_.queries();
    if (forest_) {
      if (!forest_->round(give_up())) {
        forest_.reset();
      }
      note_solutions(before);
      if (has_plan() || budget_.out_of_time()) {
        return;
      }
    }
    const bool search_is_behind =
        double(search_queries_) <= kSearchShare * double(paths_.queries() - before_plan_);
    if (!has_plan() || search_is_behind || !improve()) {
      search();
    }
    idle_turns_ = paths_.queries() == before ? idle_turns_ + 1 : 0;
  }

  void search() {
    const std::uint64_t before = paths_.queries();
    search_.round(best_cost_kpa(), give_up());
    note_solutions(before);
  }

  double merit_kpa(const BatchSearch::Solution& one) const {
    return aim_.merit_kpa(one.cost_kpa, one.held_tip);
  }

  /// What the search has found since the model had been asked `before` queries.
  void note_solutions(std::uint64_t before) {
    const auto& solutions = search_.solutions();
    std::vector<BatchSearch::Solution> found(solutions.begin() + std::ptrdiff_t(seen_),
                                             solutions.end());
    seen_ = solutions.size();
    std::ranges::stable_sort(found, {}, [this](const auto& one) { return merit_kpa(one); });
    for (const BatchSearch::Solution& one : found) {
      if (may_be_built_upon(one)) {
        waiting_.push_back(one);
      }
    }
    if (!has_plan()) {
      before_plan_ = paths_.queries();
    } else {
      search_queries_ += paths_.queries() - before;
    }
  }

  /// Notes it as a plan if it is the best so far.
  bool may_be_built_upon(const BatchSearch::Solution& one) {
    const bool is_best = !has_plan() || merit_kpa(one) < *ladder_.best_merit_kpa();
    if (!is_best && opinions_.empty()) {
      return true;
    }
    const std::vector<Pressures> waypoints_kpa = search_.waypoints_to(one.node);
    return opinions_.agree(waypoints_kpa) && (!is_best || note_plan(waypoints_kpa, merit_kpa(one)));
  }

  /// A batch of changes of all plans in work. False if there is none.
  bool improve() {
    batch_.clear();
    std::vector<std::size_t> first;
    for (PlanImprover& improver : improvers_) {
      first.push_back(batch_.size());
      const bool is_best = improver.has_plan() && improver.merit_kpa() <= *ladder_.best_merit_kpa();
      if (!improver.has_plan() || (improver.fruitless_rounds() > kPatience && !is_best)) {
        call_plan(improver);
      }
      if (improver.has_plan()) {
        improver.propose(batch_);
      }
    }
    if (batch_.empty()) {
      return false;
    }
    paths_.run(batch_, outcomes_, give_up());
    for (std::size_t i = 0; i < improvers_.size(); ++i) {
      if (improvers_[i].has_plan()) {
        improvers_[i].settle(outcomes_.data() + first[i]);
        if (improvers_[i].merit_kpa() < *ladder_.best_merit_kpa() &&
            !note_plan(improvers_[i].waypoints_kpa(), improvers_[i].merit_kpa())) {
          improvers_[i].drop();
        }
      }
    }
    return true;
  }

  /// Any of the tree's plans that have not had their turn: the cheapest are mostly similar.
  void call_plan(PlanImprover& improver) {
    if (waiting_.empty()) {
      return;
    }
    const std::size_t index = choice_.index(static_cast<std::uint32_t>(waiting_.size()));
    std::vector<MotionState> states;
    const BatchSearch::Solution solution = waiting_[index];
    const std::vector<int> nodes = search_.tree().nodes_to(solution.node);
    for (const int node : nodes) {
      states.push_back(search_.tree().state(node));
    }
    improver.adopt(search_.waypoints_to(solution.node), std::move(states), solution.held_tip);
    waiting_[index] = waiting_.back();
    waiting_.pop_back();
  }

  void finish() {
    result_.statistics.iterations = search_.proposals();
    result_.statistics.nodes = static_cast<std::uint64_t>(search_.tree().size());
    result_.statistics.goal_nodes = search_.solutions().size();
    PlannerProgress end = progress();
    finish_search(problem_, single_, budget_,
                  {ladder_, paths_.queries(), search_.waypoints_to(search_.nearest_node())},
                  planner_, seed_, result_);
    result_.statistics.queries = paths_.queries() + single_.queries() + opinions_.queries();
    close_search(budget_, search_.tree(), end, result_);
  }

  const PlanningProblem& problem_;
  const DefaultPlannerSettings& settings_;
  PlannerBudget budget_;
  CollisionChecker checker_;
  MotionSimulator single_;
  GoalAim aim_;
  SecondOpinions opinions_;
  PathSimulator paths_;
  BatchSearch search_;
  std::optional<ForestSearch> forest_;  // until there is nothing more in it
  std::vector<PlanImprover> improvers_;
  PlanLadder ladder_;
  RandomStream choice_;
  const char* planner_;
  std::uint64_t seed_;
  std::size_t seen_ = 0;                        // of the search's solutions
  std::vector<BatchSearch::Solution> waiting_;  // that no improver has had
  int idle_turns_ = 0;
  std::uint64_t before_plan_ = 0;     // queries
  std::uint64_t search_queries_ = 0;  // since then
  std::vector<Path> batch_;
  std::vector<PathOutcome> outcomes_;
  PlanResult result_;
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
    return Run(problem, limits, callback, settings_, name(), seed).run(settings_.forest);
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

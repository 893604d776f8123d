#pragma once
// For those who plan.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "limber/arm/arm_description.hpp"
#include "limber/certificate/certificate.hpp"
#include "limber/forward/error_room.hpp"
#include "limber/forward/motion_model.hpp"
#include "limber/forward/recorded_region.hpp"
#include "limber/world/collision.hpp"
#include "limber/world/environment.hpp"
#include "limber/world/plan.hpp"

namespace limber {

class PlanJudge;

/// Called on the planner's own thread with each plan that was certified while it searches: the
/// first, and those notably better than the one before (docs/planning.md).
using PlanCallback = std::function<void(const Plan&)>;

/// The problem to solve. Borrowed: everything outlives the call that gets it.
struct PlanningProblem {
  const ArmDescription& arm;
  MotionModel model;  ///< of a forward model alone: ideal valves
  const Environment& environment;
  double margin_m = 0.0;  ///< clearance kept from every obstacle, ≥ 0
  /// How far inside the goal's tolerances plans end, ≥ 0: room for the model's error.
  PoseError goal_margin = {};
  /// Distance from the goal's pose: plans that end nearer than that are preferred to cheaper plans
  /// that end farther away. None: the end matters only as far as it is in the goal.
  std::optional<PoseError> aim = std::nullopt;
  /// Plans stay in this region; borrowed. None: anywhere within the arm's limits.
  const RecordedRegion* stay_within = nullptr;
  /// Set points stay within these, one of each segment, within the arm's limits. Empty: the arm's.
  std::vector<PressureLimits> limits = {};
  /// Asked about every plan before it counts; borrowed. None: all plans count.
  PlanJudge* judge = nullptr;
  /// Whether an arm that starts nearer to an obstacle than the margin keeps only the clearance that
  /// it starts with. Its position at the start is known.
  bool margin_yields_to_start = false;
  /// Whether the goal leaves room for the model's error. If not, improving plans for long gains
  /// little.
  bool goal_has_room = true;
  /// Kept free beside the margin. `goal_inside` is left to the planner.
  std::optional<PlanTube> tube = std::nullopt;
  PlanCallback on_plan = {};
};

/// The problem, its plans keeping `room`. @throws InputError for a model of another arm.
PlanningProblem problem_with_room(const ArmDescription& arm, const MotionModel& model,
                                  const Environment& environment, const ErrorRoom& room);
/// Checker of the arm with everything that its plans keep free.
CollisionChecker checker_of(const PlanningProblem& problem);

/// The state that the environment starts with, at rest or in motion.
MotionState start_of(const PlanningProblem& problem);
/// What set points keep: the problem's limits, or else the arm's.
std::vector<PressureLimits> limits_of(const PlanningProblem& problem);
/// Set points that a plan may use.
PressureBox setpoints_of(const PlanningProblem& problem);

/// When to stop; whichever comes first. At least one of time, iterations and queries is set.
/// The limit of queries is for the search itself, which looks at it after each of its rounds. The
/// result's statistics count all queries: also those of an ensemble's other networks, which judge
/// every plan, and of the plan's last simulation. So they may exceed the limit.
struct PlannerLimits {
  std::optional<double> time_s = std::nullopt;
  std::optional<std::uint64_t> iterations = std::nullopt;
  std::optional<std::uint64_t> queries = std::nullopt;      ///< of the forward model, by the search
  std::optional<double> memory_mb = std::nullopt;           ///< of the tree
  std::optional<double> cost_threshold_kpa = std::nullopt;  ///< stop at a plan this cheap
  /// Share of time, iterations and queries after which a search without a plan ends; in (0, 1].
  double patience = 1.0;

  /// The same; with a time of kDefaultTimeLimitS if neither time, iterations nor queries is set.
  PlannerLimits or_default() const;
};

inline constexpr double kDefaultTimeLimitS = 10.0;

enum class PlanStatus {
  solved,             ///< a certified plan exists (certificate/certificate.hpp)
  limit,              ///< a limit came first
  invalid_start,      ///< the arm starts in an obstacle, or beyond the problem's limits
  goal_unreachable,   ///< beyond the arm's length
  goal_in_collision,  ///< no tip in the goal's region is free
  not_certified,      ///< plans were found, and their certificates refuse every one of them
};

/// In the enumeration's order.
inline constexpr std::array kPlanStatuses{PlanStatus::solved,
                                          PlanStatus::limit,
                                          PlanStatus::invalid_start,
                                          PlanStatus::goal_unreachable,
                                          PlanStatus::goal_in_collision,
                                          PlanStatus::not_certified};

enum class PlanLimit { time, iterations, queries, memory };

/// Names as in files and JSON: "goal_unreachable", "iterations".
const char* to_string(PlanStatus status);
const char* to_string(PlanLimit limit);

/// Tip of a node and of its parent, for pictures.
struct TreeEdge {
  Eigen::Vector2f from_m;
  Eigen::Vector2f to_m;
};

struct PlannerProgress {
  double time_s = 0.0;
  std::uint64_t iterations = 0;
  std::uint64_t nodes = 0;
  std::uint64_t queries = 0;
  std::optional<double> best_cost_kpa;  ///< none before the first solution
  /// The search tree so far, as in PlanResult::tree. Only a callback has it, while it runs.
  std::function<std::vector<TreeEdge>()> tree = {};
};

/// Called about ten times per second, on the planner's own thread. False asks the planner to stop.
using PlannerCallback = std::function<bool(const PlannerProgress&)>;

/// The first plan that its judge accepted.
struct FirstSolution {
  double time_s = 0.0;  ///< when the judge had accepted it
  double cost_kpa = 0.0;
  std::uint64_t queries = 0;   ///< of the forward model, until it was found
  double candidate_s = 0.0;    ///< when it was found
  double certificate_s = 0.0;  ///< time that it then took to build and to judge it
};

struct PlannerStatistics {
  double time_s = 0.0;
  std::uint64_t iterations = 0;
  std::uint64_t queries = 0;  ///< of the forward model, all of them: may exceed the limit
  std::uint64_t nodes = 0;
  std::uint64_t rewires_tried = 0;     ///< cheaper parents whose edge was simulated
  std::uint64_t rewires_accepted = 0;  ///< of these, same backbone and everything downstream free
};

struct PlanResult {
  PlanStatus status = PlanStatus::limit;
  std::string reason;  ///< a sentence: what ended the search, or what is wrong with the problem
  std::vector<std::string> warnings;
  std::optional<PlanLimit> limit;  ///< the limit that ended the search; none at the cost threshold
  std::optional<Plan> plan;        ///< set if and only if solved
  /// If there is no plan, the motion that came nearest to the goal. It is free of collision until
  /// its hold, in which valves and the arm still move, and does not end in the goal: never execute
  /// it as a solution. Its clearance is not measured.
  std::optional<Plan> best_partial;
  std::optional<Certificate> certificate;  ///< of the plan that was found
  /// If no plan keeps the clearance asked for: the clearance of a plan that was found with less.
  std::optional<double> max_clearance_m;
  std::optional<FirstSolution> first_solution;
  /// How the search went: the first plan, each plan that costs over half a per cent less than the
  /// one noted before, and the end. Empty without a plan, or where its motion was given.
  std::vector<PlannerProgress> events;
  PlannerStatistics statistics;
  std::vector<TreeEdge> tree;  ///< at most kMaxTreeEdges, the oldest

  static constexpr std::size_t kMaxTreeEdges = 20000;
};

/// A planner in pressure space.
///
/// Laws: before a plan is returned it is simulated again from the start, frame by frame. Every
/// frame and the motion between frames is free, and the last frame, after the hold, is in the goal.
/// Without an aim, the cost never rises with the budget. Runs limited by iterations or queries
/// alone depend on the seed and nothing else, not even the number of threads. The time limit is
/// kept to 50 ms. Threads: one planner, one caller at a time.
class Planner {
 public:
  virtual ~Planner() = default;
  virtual const char* name() const = 0;
  /// @throws InputError if no limit is set or one is not positive, or of an arm in space.
  [[nodiscard]] virtual PlanResult plan(const PlanningProblem& problem, const PlannerLimits& limits,
                                        std::uint64_t seed,
                                        const PlannerCallback& callback = {}) = 0;
};

}  // namespace limber

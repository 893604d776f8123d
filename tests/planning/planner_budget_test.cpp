#include "src/planning/planner_budget.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "limber/common/error.hpp"
#include "limber/common/interrupt.hpp"

namespace limber {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr double kReserveS = 0.005;
constexpr double kGraceS = 0.02;
constexpr double kAFewBytes = 1000.0;

/// A clock that moves when it is told to.
class Budget : public ::testing::Test {
 protected:
  PlannerBudget budget() {
    return {limits_, callback_, [this] { return now_; }};
  }
  void set_time(double seconds) {
    now_ =
        PlannerBudget::Clock::time_point(std::chrono::duration_cast<PlannerBudget::Clock::duration>(
            std::chrono::duration<double>(kBeginS + seconds)));
  }
  void SetUp() override { set_time(0.0); }

  static PlannerProgress progress(std::uint64_t iterations, std::uint64_t queries,
                                  std::optional<double> cost_kpa = std::nullopt) {
    return {0.0, iterations, 0, queries, cost_kpa};
  }

  PlannerLimits limits_;
  PlannerCallback callback_;

 private:
  static constexpr double kBeginS = 1000.0;
  PlannerBudget::Clock::time_point now_;
};

TEST_F(Budget, TimeIsUpALittleBeforeTheLimitAndOverdueALittleAfter) {
  limits_.time_s = 2.0;
  const PlannerBudget one = budget();
  for (const double time_s : {0.0, 0.5, 1.99, 1.996, 2.0, 2.019, 2.021, 30.0}) {
    set_time(time_s);
    EXPECT_NEAR(one.elapsed_s(), time_s, 1e-9);
    EXPECT_EQ(one.out_of_time(), time_s >= 2.0 - kReserveS) << time_s;
    EXPECT_EQ(one.is_overdue(), time_s >= 2.0 + kGraceS) << time_s;
  }
}

TEST_F(Budget, EndsAtOnceWhereItsThreadIsAskedToStop) {
  limits_.time_s = 2.0;
  std::atomic<bool> stop = false;
  const StopScope scope(&stop);
  PlannerBudget one = budget();
  EXPECT_FALSE(one.out_of_time());
  EXPECT_FALSE(one.spent(progress(1, 1), kAFewBytes));
  stop = true;
  EXPECT_TRUE(one.out_of_time());
  EXPECT_TRUE(one.is_overdue());
  EXPECT_TRUE(one.spent(progress(2, 2), kAFewBytes));
  EXPECT_EQ(one.reason(), "stopped by the user");
  EXPECT_FALSE(one.limit());
}

TEST_F(Budget, WithoutATimeLimitTimeIsNeverUp) {
  limits_.queries = 10;
  PlannerBudget one = budget();
  one.keep_for_the_end(1e6);
  set_time(1e9);
  EXPECT_FALSE(one.out_of_time());
  EXPECT_FALSE(one.is_overdue());
}

TEST_F(Budget, WhatTheEndTakesIsKeptUpToHalfOfTheLimit) {
  limits_.time_s = 2.0;
  PlannerBudget one = budget();
  const auto is_up_at = [&](double time_s) {
    set_time(time_s);
    return one.out_of_time();
  };
  one.keep_for_the_end(0.4);
  EXPECT_FALSE(is_up_at(1.59));
  EXPECT_TRUE(is_up_at(1.6));
  one.keep_for_the_end(0.1);
  EXPECT_TRUE(is_up_at(1.6)) << "the longest certificate so far counts";
  one.keep_for_the_end(50.0);
  EXPECT_FALSE(is_up_at(0.999));
  EXPECT_TRUE(is_up_at(1.001));
}

TEST_F(Budget, PatienceEndsASearchWithoutAPlanEarlier) {
  limits_ = {10.0, 100, 1000, std::nullopt, std::nullopt, 0.8};
  {
    PlannerBudget without = budget();
    EXPECT_FALSE(without.spent(progress(79, 799), kAFewBytes));
    EXPECT_TRUE(without.spent(progress(80, 799), kAFewBytes));
    EXPECT_EQ(without.limit(), PlanLimit::iterations);
  }
  {
    PlannerBudget without = budget();
    EXPECT_TRUE(without.spent(progress(79, 800), kAFewBytes));
    EXPECT_EQ(without.limit(), PlanLimit::queries);
  }
  PlannerBudget with = budget();
  EXPECT_FALSE(with.spent(progress(99, 999, 50.0), kAFewBytes));
  set_time(8.5);
  EXPECT_FALSE(with.out_of_time());
  EXPECT_TRUE(with.spent(progress(100, 999, 50.0), kAFewBytes));
  EXPECT_TRUE(budget().elapsed_s() == 0.0) << "a budget begins when it is made";
}

TEST_F(Budget, ASpentLimitStaysSpentAndIsTheFirst) {
  limits_ = {1.0, 100, 1000, 1.0, std::nullopt, 1.0};
  PlannerBudget one = budget();
  EXPECT_FALSE(one.spent(progress(0, 0), 0.999e6));
  EXPECT_FALSE(one.limit());
  EXPECT_EQ(one.reason(), "");
  EXPECT_TRUE(one.spent(progress(0, 0), 1e6));
  set_time(5.0);
  EXPECT_TRUE(one.spent(progress(500, 5000), kAFewBytes));
  EXPECT_TRUE(one.spent(progress(0, 0), kAFewBytes));
  EXPECT_EQ(one.limit(), PlanLimit::memory);
  EXPECT_EQ(one.reason(), "1 MB spent");
}

TEST_F(Budget, SaysWhatWasSpent) {
  const auto reason = [&](const PlannerLimits& limits) {
    limits_ = limits;
    set_time(0.0);
    PlannerBudget one = budget();
    set_time(3.0);
    EXPECT_TRUE(one.spent(progress(500, 5000), kAFewBytes));
    return one.reason();
  };
  PlannerLimits limits;
  limits.time_s = 2.5;
  EXPECT_EQ(reason(limits), "2.5 s spent");
  limits = {};
  limits.iterations = 500;
  EXPECT_EQ(reason(limits), "500 iterations spent");
  limits = {};
  limits.queries = 4000;
  EXPECT_EQ(reason(limits), "4000 model queries spent");
}

TEST_F(Budget, AsksItsCallbackTenTimesASecondAndStopsWhenToldTo) {
  limits_.iterations = 1'000'000;
  std::vector<double> calls_s;
  callback_ = [&](const PlannerProgress& now) {
    calls_s.push_back(now.time_s);
    return calls_s.size() < 4;
  };
  PlannerBudget one = budget();
  int turns = 0;
  for (double time_s = 0.0; time_s < 10.0; time_s += 0.01) {
    ++turns;
    set_time(time_s);
    if (one.spent({time_s, 1, 1, 1, std::nullopt}, kAFewBytes)) {
      break;
    }
  }
  ASSERT_EQ(calls_s.size(), 4U);
  for (std::size_t k = 1; k < calls_s.size(); ++k) {
    EXPECT_NEAR(calls_s[k] - calls_s[k - 1], 0.1, 0.011);
  }
  EXPECT_NEAR(turns, 31, 3);
  EXPECT_TRUE(one.was_stopped());
  EXPECT_TRUE(one.out_of_time()) << "long steps look there";
  EXPECT_FALSE(one.limit());
  EXPECT_EQ(one.reason(), "stopped by the user");
}

TEST_F(Budget, KeepsAnEventForEachHalfPerCent) {
  limits_.iterations = 1000;
  PlannerBudget one = budget();
  one.note(progress(1, 10));
  EXPECT_TRUE(one.events().empty()) << "no plan yet";
  for (const double cost_kpa : {100.0, 99.6, 99.51, 99.4, 99.0, 80.0, 79.9}) {
    one.note(progress(2, 20, cost_kpa));
  }
  std::vector<double> kept;
  for (const PlannerProgress& event : one.events()) {
    kept.push_back(*event.best_cost_kpa);
  }
  EXPECT_EQ(kept, (std::vector{100.0, 99.4, 80.0}));
}

TEST_F(Budget, IsSatisfiedAtTheCostAskedFor) {
  limits_.iterations = 10;
  EXPECT_FALSE(budget().good_enough(0.0)) << "nothing was asked for";
  limits_.cost_threshold_kpa = 70.0;
  EXPECT_FALSE(budget().good_enough(std::nullopt));
  EXPECT_FALSE(budget().good_enough(70.1));
  EXPECT_TRUE(budget().good_enough(70.0));
}

TEST_F(Budget, RefusesLimitsThatAreNone) {
  const auto refusal = [&](const PlannerLimits& limits, const char* message) {
    limits_ = limits;
    EXPECT_THAT([&] { (void)budget(); }, ThrowsMessage<InputError>(HasSubstr(message)));
  };
  PlannerLimits limits;
  refusal(limits, "needs a limit of time, iterations or queries; none is set");
  limits.memory_mb = 10.0;
  refusal(limits, "none is set");
  limits.iterations = 0;
  refusal(limits, "limit of iterations of 0; expected a number > 0");
  limits.iterations = 5;
  limits.time_s = std::numeric_limits<double>::quiet_NaN();
  refusal(limits, "time limit [s] of nan");
  limits.time_s = std::numeric_limits<double>::infinity();
  refusal(limits, "time limit [s] of inf");
  limits.time_s = 1.0;
  limits.cost_threshold_kpa = -3.0;
  refusal(limits, "cost threshold of -3; expected a number > 0");
}

}  // namespace
}  // namespace limber

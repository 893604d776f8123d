#include "src/planning/planner_budget.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "limber/common/random_stream.hpp"

namespace limber {
namespace {

using Turn = TurnTaking::Turn;

TEST(TurnTaking, BeforeThereIsAPlanTheSearchHasEveryTurn) {
  TurnTaking turns;
  for (std::uint64_t queries = 0; queries < 10'000; queries += 100) {
    EXPECT_EQ(turns.next(false, queries), Turn::search);
    turns.note_search(false, queries, queries + 100);
  }
  EXPECT_EQ(turns.since_plan(false, 10'000), 0.0);
  EXPECT_EQ(turns.since_plan(true, 10'500), 500.0) << "what came before the plan counts for nobody";
}

// Whatever a turn takes, the search has a fifth of the queries, but for one turn of either.
TEST(TurnTaking, EachHasItsShareOfTheQueriesUpToATurn) {
  RandomStream random(1, 1);
  TurnTaking turns;
  constexpr std::uint32_t kMaxTurn = 900;
  turns.note_search(false, 0, 5000);
  std::uint64_t queries = 5000;
  double search = 0.0, all = 0.0;
  for (int k = 0; k < 5000; ++k) {
    const std::uint64_t turn = 1 + random.index(kMaxTurn);
    const bool is_search = turns.next(true, queries) == Turn::search;
    if (is_search) {
      turns.note_search(true, queries, queries + turn);
      search += double(turn);
    }
    queries += turn;
    all += double(turn);
    EXPECT_NEAR(search, TurnTaking::kSearchShare * all, kMaxTurn) << "after turn " << k;
    EXPECT_EQ(turns.since_plan(true, queries), all);
  }
}

TEST(TurnTaking, DependsOnTheCountsAlone) {
  const auto turns_of = [](std::uint64_t seed) {
    RandomStream random(seed, 2);
    TurnTaking turns;
    std::vector<Turn> taken;
    std::uint64_t queries = 0;
    for (int k = 0; k < 500; ++k) {
      taken.push_back(turns.next(k > 20, queries));
      const std::uint64_t turn = random.index(300);
      if (taken.back() == Turn::search) {
        turns.note_search(k > 20, queries, queries + turn);
      }
      turns.note_turn(queries, queries + turn);
      queries += turn;
    }
    return taken;
  };
  EXPECT_EQ(turns_of(3), turns_of(3));
  EXPECT_NE(turns_of(3), turns_of(4));
}

TEST(TurnTaking, TurnsWithoutAQueryInARowMakeItIdle) {
  TurnTaking turns;
  for (int k = 0; k < TurnTaking::kMaxIdleTurns; ++k) {
    turns.note_turn(70, 70);
  }
  EXPECT_FALSE(turns.is_idle());
  turns.note_turn(70, 71);
  for (int k = 0; k < TurnTaking::kMaxIdleTurns; ++k) {
    turns.note_turn(71, 71);
  }
  EXPECT_FALSE(turns.is_idle()) << "one query starts the count again";
  turns.note_turn(71, 71);
  EXPECT_TRUE(turns.is_idle());
}

}  // namespace
}  // namespace limber

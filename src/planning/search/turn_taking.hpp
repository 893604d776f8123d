#pragma once

#include <cstdint>

namespace limber {

/// Whose turn it is in a search whose plans are improved while it goes on, by the queries of the
/// model that each has had: the search's alone until there is a plan, then a fifth of them, the
/// rest its improvers'. Queries are counted by whoever simulates, over all turns.
class TurnTaking {
 public:
  enum class Turn { search, improvers };

  static constexpr double kSearchShare = 0.2;
  static constexpr int kMaxIdleTurns = 10'000;

  /// @param queries  so far
  Turn next(bool has_plan, std::uint64_t queries) const {
    const bool search_is_behind =
        double(search_queries_) <= kSearchShare * double(queries - before_plan_);
    return !has_plan || search_is_behind ? Turn::search : Turn::improvers;
  }

  /// The search, or the forest, has had a turn. @param has_plan  after it
  void note_search(bool has_plan, std::uint64_t before, std::uint64_t after) {
    if (has_plan) {
      search_queries_ += after - before;
    } else {
      before_plan_ = after;
    }
  }
  /// Anybody has had one.
  void note_turn(std::uint64_t before, std::uint64_t after) {
    idle_turns_ = after == before ? idle_turns_ + 1 : 0;
  }

  /// Queries since there is a plan; 0 where there is none.
  double since_plan(bool has_plan, std::uint64_t queries) const {
    return has_plan ? double(queries - before_plan_) : 0.0;
  }
  /// Whether nobody has anything to try, for long: a limit of queries alone would never be reached.
  bool is_idle() const { return idle_turns_ > kMaxIdleTurns; }

 private:
  std::uint64_t before_plan_ = 0;     // queries
  std::uint64_t search_queries_ = 0;  // since then
  int idle_turns_ = 0;                // in a row
};

}  // namespace limber
